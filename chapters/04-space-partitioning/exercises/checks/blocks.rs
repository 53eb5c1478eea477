//! Blocks of space, and what exercise 4.5 needs around them.

use common::{Interval, Vec3};
use ray_casting::{aabb::Aabb, hit::Hit, ray::Ray};
use space_partitioning::{
    grid::Grid,
    primitives::{Primitives, overlap},
    probe::Probe,
    query::{Query, Question},
    slabs::Slabs,
    structure::{Cell, Partition, Structure},
};

use super::hierarchy::around;

/// A box in equal blocks, as many along each axis.
#[derive(Clone, Debug)]
pub(crate) struct Blocks {
    aabb: Aabb,
    count: u16,
}

impl Blocks {
    /// How many there are.
    pub(crate) fn len(&self) -> usize {
        usize::from(self.count).pow(3)
    }

    /// Where the face of an index lies on an axis.
    fn plane(&self, axis: usize, index: u16) -> f32 {
        if index >= self.count {
            return self.aabb.max[axis];
        }
        let (min, size) = (self.aabb.min[axis], self.aabb.max[axis] - self.aabb.min[axis]);
        min + f32::from(index) * (size / f32::from(self.count))
    }

    /// The indices of a block along x, y and z.
    fn indices(&self, number: usize) -> [u16; 3] {
        let count = usize::from(self.count);
        [number % count, number / count % count, number / count / count].map(|i| u16::try_from(i).unwrap_or(0))
    }

    /// The space of a block.
    pub(crate) fn block(&self, number: usize) -> Aabb {
        let indices = self.indices(number);
        let corner = |step: u16| Vec3::from_array([0, 1, 2].map(|axis| self.plane(axis, indices[axis] + step)));
        Aabb { min: corner(0), max: corner(1) }
    }

    /// The blocks that a ray meets, from front to back, by number, each with the part of `range` in which the ray is inside.
    pub(crate) fn along(&self, ray: &Ray, range: Interval) -> Vec<(u32, Interval)> {
        let slabs = Slabs::of(ray);
        let Some(inside) = slabs.cross(&self.aabb, range) else { return Vec::new() };
        let mut met = Vec::new();
        // Slices across z, in them rows along x, in them blocks.
        let slice = |aabb: Aabb, axis: usize, index: u16| {
            let mut part = aabb;
            part.min[axis] = self.plane(axis, index);
            part.max[axis] = self.plane(axis, index + 1);
            part
        };
        for z in 0..self.count {
            let layer = slice(self.aabb, 2, z);
            let Some(inside) = slabs.cross(&layer, inside) else { continue };
            for y in 0..self.count {
                let row = slice(layer, 1, y);
                let Some(inside) = slabs.cross(&row, inside) else { continue };
                for x in 0..self.count {
                    let Some(inside) = slabs.cross(&slice(row, 0, x), inside) else { continue };
                    let [x, y, z, count] = [x, y, z, self.count].map(u32::from);
                    met.push(((z * count + y) * count + x, inside));
                }
            }
        }
        met.sort_by(|(_, a), (_, b)| a.min.total_cmp(&b.min));
        met
    }
}

/// What a block holds.
#[derive(Clone, Debug)]
pub(crate) enum Content<E> {
    /// The entries of few primitives.
    List(Vec<E>),
    /// A grid of its own.
    Grid(Grid<E>),
}

/// A part of some primitives, and of them only what lies inside of a block.
pub(crate) struct Part<'p, P> {
    primitives: &'p P,
    numbers: Vec<u32>,
    block: Aabb,
}

impl<'p, P: Primitives> Part<'p, P> {
    /// The primitives of these numbers.
    pub(crate) fn new(primitives: &'p P, numbers: &[u32], block: &Aabb) -> Self {
        Self { primitives, numbers: numbers.to_vec(), block: *block }
    }

    fn whole(&self, number: u32) -> u32 {
        self.numbers[number as usize]
    }
}

/// They are numbered from 0, but their entries are those of the whole.
impl<P: Primitives> Primitives for Part<'_, P> {
    type View = P::View;
    type Entry = P::Entry;

    fn count(&self) -> u32 {
        u32::try_from(self.numbers.len()).unwrap_or(u32::MAX)
    }

    fn aabb(&self, number: u32) -> Aabb {
        // What only touches the block has no box in it.
        let part = self.primitives.clipped(self.whole(number), &self.block);
        part.unwrap_or(Aabb { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY })
    }

    fn clipped(&self, number: u32, cell: &Aabb) -> Option<Aabb> {
        self.primitives.clipped(self.whole(number), &overlap(cell, &self.block)?)
    }

    fn entry(&self, number: u32) -> P::Entry {
        self.primitives.entry(self.whole(number))
    }

    fn number(&self, entry: &P::Entry) -> u32 {
        self.primitives.number(entry)
    }

    fn view(&self, ray: &Ray) -> P::View {
        self.primitives.view(ray)
    }

    fn intersect(&self, entry: &P::Entry, view: &P::View, range: Interval) -> Option<f32> {
        self.primitives.intersect(entry, view, range)
    }

    fn hit(&self, number: u32, ray: &Ray, t: f32) -> Option<Hit> {
        self.primitives.hit(self.whole(number), ray, t)
    }
}

/// What a student writes: how blocks are filled, and how a ray goes through them.
pub(crate) trait TwoLevel: Send + Sync {
    /// What a block holds.
    fn content<P: Primitives>(primitives: &P, numbers: &[u32], block: &Aabb) -> Content<P::Entry>;

    /// Walk through the blocks along a ray.
    fn walk<P: Primitives, Q: Question, N: Probe>(
        blocks: &Blocks,
        contents: &[Content<P::Entry>],
        ray: &Ray,
        query: &mut Query<'_, P, Q, N>,
    );
}

/// Blocks with their contents.
pub(crate) struct Filled<E, T> {
    pub(crate) blocks: Blocks,
    pub(crate) contents: Vec<Content<E>>,
    _how: std::marker::PhantomData<T>,
}

/// Primitives in blocks that are filled by `T`, so many of them along each axis.
pub(crate) fn filled<P: Primitives, T: TwoLevel>(primitives: P, count: u16) -> Structure<P, Filled<P::Entry, T>> {
    let numbers: Vec<u32> = (0..primitives.count()).collect();
    let boxes: Vec<_> = numbers.iter().map(|&number| primitives.aabb(number)).collect();
    let aabb = around(&boxes).unwrap_or(Aabb { min: Vec3::ZERO, max: Vec3::ZERO });
    let blocks = Blocks { aabb, count };
    let contents = (0..blocks.len()).map(|i| T::content(&primitives, &numbers, &blocks.block(i))).collect();
    Structure { primitives, partition: Filled { blocks, contents, _how: std::marker::PhantomData } }
}

impl<P: Primitives, T: TwoLevel> Partition<P> for Filled<P::Entry, T> {
    fn walk<Q: Question, N: Probe>(&self, ray: &Ray, query: &mut Query<'_, P, Q, N>) {
        T::walk(&self.blocks, &self.contents, ray, query);
    }

    fn aabb(&self) -> Option<Aabb> {
        Some(self.blocks.aabb)
    }

    fn cells(&self) -> Vec<Cell<'_, P::Entry>> {
        let contents = (0_u32..).zip(&self.contents);
        let cells = contents.flat_map(|(number, content)| match content {
            Content::List(list) => vec![Cell { number, aabb: self.blocks.block(number as usize), list }],
            Content::Grid(grid) => Partition::<P>::cells(grid),
        });
        cells.collect()
    }

    fn bytes(&self) -> usize {
        let bytes_of = |content: &Content<P::Entry>| match content {
            Content::List(list) => size_of_val(list.as_slice()),
            Content::Grid(grid) => Partition::<P>::bytes(grid),
        };
        self.contents.iter().map(bytes_of).sum()
    }
}
