//! No partition: every primitive is tested. What all structures are compared with.

use ray_casting::{aabb::Aabb, ray::Ray};

use crate::{
    primitives::Primitives,
    probe::Probe,
    query::{Query, Question},
    structure::{Cell, Contents, Partition, Structure, StructureError},
};

// ANCHOR: every_one
/// One cell that lists everything: brute force.
#[derive(Clone, Debug)]
pub struct EveryOne<E> {
    aabb: Option<Aabb>,
    list: Vec<E>,
}

/// A shape of many primitives that are all tested.
///
/// # Errors
/// [`StructureError`] if a primitive has no finite box, or there are too many.
pub fn every_one<P: Primitives>(primitives: P) -> Result<Structure<P, EveryOne<P::Entry>>, StructureError> {
    let Contents { boxes, around } = Contents::of(&primitives)?;
    let list = boxes.into_iter().map(|(number, _)| primitives.entry(number)).collect();
    Ok(Structure { primitives, partition: EveryOne { aabb: around, list } })
}

impl<P: Primitives> Partition<P> for EveryOne<P::Entry> {
    fn walk<Q: Question, N: Probe>(&self, _ray: &Ray, query: &mut Query<'_, P, Q, N>) {
        query.visit(0);
        query.test(&self.list);
    }

    fn aabb(&self) -> Option<Aabb> {
        self.aabb
    }

    fn cells(&self) -> Vec<Cell<'_, P::Entry>> {
        self.aabb.into_iter().map(|aabb| Cell { number: 0, aabb, list: &self.list }).collect()
    }

    fn bytes(&self) -> usize {
        size_of_val(self.list.as_slice())
    }
}
// ANCHOR_END: every_one
