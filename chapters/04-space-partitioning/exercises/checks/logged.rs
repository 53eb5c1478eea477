//! Triangles that write down which of them are tested.

use std::cell::RefCell;

use common::{Interval, Vec3};
use ray_casting::{aabb::Aabb, hit::Hit, ray::Ray};
use space_partitioning::{primitives::Primitives, triangles::Triangles};

thread_local! {
    /// The numbers of all triangles that this thread has tested.
    static LOG: RefCell<Vec<u32>> = const { RefCell::new(Vec::new()) };
}

/// Triangles that write down which of them are tested. Each thread has a log of its own.
#[derive(Clone)]
pub(crate) struct Logged(pub(crate) Triangles);

/// The result of `act`, and the numbers of all triangles that were tested meanwhile.
pub(crate) fn logging<T>(act: impl FnOnce() -> T) -> (T, Vec<u32>) {
    LOG.take();
    let result = act();
    (result, LOG.take())
}

impl Primitives for Logged {
    type View = <Triangles as Primitives>::View;
    type Entry = <Triangles as Primitives>::Entry;

    fn count(&self) -> u32 {
        self.0.count()
    }

    fn aabb(&self, number: u32) -> Aabb {
        self.0.aabb(number)
    }

    fn clipped(&self, number: u32, cell: &Aabb) -> Option<Aabb> {
        self.0.clipped(number, cell)
    }

    fn octants(&self, number: u32, cell: &Aabb, middle: Vec3) -> [Option<Aabb>; 8] {
        self.0.octants(number, cell, middle)
    }

    fn entry(&self, number: u32) -> Self::Entry {
        self.0.entry(number)
    }

    fn number(&self, entry: &Self::Entry) -> u32 {
        self.0.number(entry)
    }

    fn view(&self, ray: &Ray) -> Self::View {
        self.0.view(ray)
    }

    fn intersect(&self, entry: &Self::Entry, view: &Self::View, range: Interval) -> Option<f32> {
        LOG.with_borrow_mut(|log| log.push(self.number(entry)));
        self.0.intersect(entry, view, range)
    }

    fn hit(&self, number: u32, ray: &Ray, t: f32) -> Option<Hit> {
        self.0.hit(number, ray, t)
    }
}
