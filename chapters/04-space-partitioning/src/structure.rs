//! The structure: primitives, and a partition of space that says which of them a ray must test.

use common::Interval;
use ray_casting::{aabb::Aabb, hit::Hit, ray::Ray, shape::Shape};

use crate::{
    primitives::{Bounded, Primitives},
    probe::Probe,
    query::{Any, Found, Nearest, Query, Question},
};

// ANCHOR: partition
/// Space in cells, each with a list of the primitives that reach into it: a grid, an octree, a kd-tree.
pub trait Partition<P: Primitives>: Send + Sync {
    /// Walk along a ray from cell to cell and test what the cells list, until nothing nearer can come.
    fn walk<Q: Question, N: Probe>(&self, ray: &Ray, query: &mut Query<'_, P, Q, N>);

    /// The box around everything; `None` if there is nothing.
    fn aabb(&self) -> Option<Aabb>;

    /// All cells that are not divided any further, for drawings and checks.
    fn cells(&self) -> Vec<Cell<'_, P::Entry>>;

    /// Memory, in bytes, without that of the primitives.
    fn bytes(&self) -> usize;
}
// ANCHOR_END: partition

/// A cell of a partition that is not divided any further.
#[derive(Clone, Copy, Debug)]
pub struct Cell<'p, E> {
    /// Its number, as a [`Probe`] is told it.
    pub number: u32,
    /// The space that it takes.
    pub aabb: Aabb,
    /// The primitives that reach into it.
    pub list: &'p [E],
}

// ANCHOR: structure
/// Primitives behind a partition. To a ray it is one shape.
#[derive(Clone, Debug)]
pub struct Structure<P, T> {
    /// What there is to hit.
    pub primitives: P,
    /// What says where it is.
    pub partition: T,
}

impl<P: Primitives, T: Partition<P>> Structure<P, T> {
    /// All cells that are not divided any further.
    #[must_use]
    pub fn cells(&self) -> Vec<Cell<'_, P::Entry>> {
        self.partition.cells()
    }

    /// The nearest hit, told to a probe. Of several at the same `t` it is that of the lowest number.
    #[inline]
    pub fn nearest(&self, ray: &Ray, range: Interval, probe: &mut impl Probe) -> Option<Found> {
        let mut query = Query::<_, Nearest, _>::new(&self.primitives, ray, range, probe);
        self.partition.walk(ray, &mut query);
        query.found()
    }

    /// Any hit, told to a probe.
    #[inline]
    pub fn any(&self, ray: &Ray, range: Interval, probe: &mut impl Probe) -> Option<Found> {
        let mut query = Query::<_, Any, _>::new(&self.primitives, ray, range, probe);
        self.partition.walk(ray, &mut query);
        query.found()
    }
}

impl<P: Primitives, T: Partition<P>> Shape for Structure<P, T> {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        let Found { number, t } = self.nearest(ray, range, &mut ())?;
        self.primitives.hit(number, ray, t)
    }

    fn occluded(&self, ray: &Ray, range: Interval) -> bool {
        self.any(ray, range, &mut ()).is_some()
    }
}
// ANCHOR_END: structure

/// Structures can hold structures.
impl<P: Primitives, T: Partition<P>> Bounded for Structure<P, T> {
    fn aabb(&self) -> Aabb {
        self.partition.aabb().unwrap_or(NOWHERE)
    }
}

/// A box that no ray hits and that makes no other box larger.
const NOWHERE: Aabb = Aabb { min: common::Vec3::INFINITY, max: common::Vec3::NEG_INFINITY };

// ANCHOR: contents
/// The boxes of all primitives and the box around them, checked.
pub(crate) struct Contents {
    pub(crate) boxes: Vec<(u32, Aabb)>,
    pub(crate) around: Option<Aabb>,
}

/// Why there is no structure of these primitives.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum StructureError {
    /// A primitive without a place in space.
    #[error("primitive {index} has a box from {min} to {max}: structures take finite boxes only")]
    NotFinite {
        /// Its number.
        index: u32,
        /// Least corner of its box.
        min: common::Vec3,
        /// Greatest corner of its box.
        max: common::Vec3,
    },
    /// More than the numbers of primitives can count.
    #[error("{0} primitives are too many: at most {MOST_PRIMITIVES} fit into a structure")]
    TooMany(u32),
}

/// Some bits of a node's numbers are taken for other things.
pub const MOST_PRIMITIVES: u32 = 1 << 28;
// ANCHOR_END: contents

impl From<StructureError> for common::Error {
    fn from(error: StructureError) -> Self {
        Self::Picture(error.to_string())
    }
}

impl Contents {
    /// Look at all primitives. Those that take no space at all, like empty structures, are left out.
    pub(crate) fn of<P: Primitives>(primitives: &P) -> Result<Self, StructureError> {
        let count = primitives.count();
        if count > MOST_PRIMITIVES {
            return Err(StructureError::TooMany(count));
        }
        let mut boxes = Vec::with_capacity(count as usize);
        let mut around = NOWHERE;
        for index in 0..count {
            let Aabb { min, max } = primitives.aabb(index);
            if (min, max) == (NOWHERE.min, NOWHERE.max) {
                continue;
            }
            // Twice the size must be a number too, or cells in the middle could not be computed.
            if !(min * 2.0).is_finite() || !(max * 2.0).is_finite() {
                return Err(StructureError::NotFinite { index, min, max });
            }
            around = Aabb { min: around.min.min(min), max: around.max.max(max) };
            boxes.push((index, Aabb { min, max }));
        }
        Ok(Self { around: (!boxes.is_empty()).then_some(around), boxes })
    }
}
