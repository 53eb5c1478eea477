//! The regular grid: space in equal cells, and a walk from cell to cell like a line drawn on squared paper.
//!
//! Source: Amanatides, Woo, *A Fast Voxel Traversal Algorithm for Ray Tracing*, Eurographics 1987.

mod build;
mod march;

use common::Vec3;
use ray_casting::{aabb::Aabb, ray::Ray};

use self::march::March;
use crate::{
    primitives::Primitives,
    probe::Probe,
    query::{Query, Question},
    rounding::SLACK,
    slabs::Slabs,
    structure::{Cell, Contents, Partition, Structure, StructureError},
};

// ANCHOR: grid
/// A regular grid over primitives.
#[derive(Clone, Debug)]
pub struct Grid<E> {
    cells: Option<Cells>,
    /// Where the list of each cell begins; after the last one, where that ends.
    begins: Vec<u32>,
    /// The lists of all cells, one after the other.
    lists: Vec<E>,
}

/// A box in equal cells.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cells {
    /// The whole.
    pub(crate) aabb: Aabb,
    /// Number of cells along each axis.
    pub(crate) resolution: [u32; 3],
    /// Size of a cell.
    pub(crate) size: Vec3,
}
// ANCHOR_END: grid

/// Cells for each primitive, when nothing is said.
pub const DENSITY: f32 = 4.0;

/// A shape of many primitives behind a grid.
///
/// # Errors
/// [`StructureError`] if a primitive has no finite box, or there are too many.
pub fn grid<P: Primitives>(primitives: P) -> Result<Structure<P, Grid<P::Entry>>, StructureError> {
    let partition = Grid::over(&primitives, DENSITY)?;
    Ok(Structure { primitives, partition })
}

impl<E: Copy + Send + Sync> Grid<E> {
    /// A grid over primitives with about `density` cells for each of them.
    ///
    /// # Errors
    /// [`StructureError`] if a primitive has no finite box, or there are too many.
    pub fn over<P: Primitives<Entry = E>>(primitives: &P, density: f32) -> Result<Self, StructureError> {
        let Contents { boxes, around } = Contents::of(primitives)?;
        let Some(aabb) = around else { return Ok(Self { cells: None, begins: vec![0], lists: Vec::new() }) };
        let mut wanted = density * boxes.len() as f32;
        loop {
            let cells = Cells::of(aabb, wanted);
            if let Some((begins, lists)) = build::fill(primitives, &cells, &boxes) {
                return Ok(Self { cells: Some(cells), begins, lists });
            }
            // Large primitives reach into so many cells that their lists would fill the memory: take larger cells.
            wanted /= 4.0;
        }
    }

    /// Number of cells along each axis.
    #[must_use]
    pub fn resolution(&self) -> [u32; 3] {
        self.cells.map_or([0; 3], |cells| cells.resolution)
    }

    /// The list of a cell.
    #[inline(always)]
    fn list(&self, number: u32) -> &[E] {
        let number = number as usize;
        &self.lists[self.begins[number] as usize..self.begins[number + 1] as usize]
    }
}

impl Cells {
    /// More cells than that along one axis are never made.
    const MOST: u32 = 1024;

    // ANCHOR: resolution
    /// Cells for a box: about so many, and as near to cubes as that allows.
    fn of(aabb: Aabb, wanted: f32) -> Self {
        let size = aabb.max - aabb.min;
        // A box without thickness has one layer of cells, and none of its sides may count as zero.
        let longest = size.max_element();
        let sides = size.max(Vec3::splat(longest / Self::MOST as f32));
        // Cubes of this side fill the box with the wanted number.
        let sides = sides / longest.max(f32::MIN_POSITIVE);
        let side = common::float::cbrt(sides.x * sides.y * sides.z / wanted.max(1.0));
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "saturates, also what is no number"
        )]
        let resolution = (sides / side).to_array().map(|n| (n.round() as u32).clamp(1, Self::MOST));
        let counts = Vec3::from_array(resolution.map(|n| n as f32));
        Self { aabb, resolution, size: size / counts }
    }
    // ANCHOR_END: resolution

    // ANCHOR: plane
    /// Where the lower face of the cells of an index lies on an axis.
    #[inline]
    pub(crate) fn plane(&self, axis: usize, index: u32) -> f32 {
        if index >= self.resolution[axis] {
            self.aabb.max[axis]
        } else {
            self.aabb.min[axis] + index as f32 * self.size[axis]
        }
    }

    /// The index along an axis of the cell that a coordinate lies in, or of the nearest one.
    #[inline]
    pub(crate) fn index(&self, axis: usize, coordinate: f32) -> u32 {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "saturates, also what is no number"
        )]
        let index = ((coordinate - self.aabb.min[axis]) / self.size[axis]) as u32;
        let mut index = index.min(self.resolution[axis] - 1);
        // The division is rounded: the faces decide.
        while index > 0 && self.plane(axis, index) > coordinate {
            index -= 1;
        }
        while index + 1 < self.resolution[axis] && self.plane(axis, index + 1) < coordinate {
            index += 1;
        }
        index
    }
    // ANCHOR_END: plane

    /// A ray sees the corners of a triangle a little beside their places: by less than this, unless it is far away.
    pub(crate) fn hair(&self) -> f32 {
        self.aabb.min.abs().max(self.aabb.max.abs()).max_element() * SLACK
    }

    /// The number of a cell.
    #[inline]
    pub(crate) fn number(&self, [x, y, z]: [u32; 3]) -> u32 {
        (z * self.resolution[1] + y) * self.resolution[0] + x
    }

    /// The space of a cell.
    pub(crate) fn cell(&self, index: [u32; 3]) -> Aabb {
        let corner = |step: u32| Vec3::from_array([0, 1, 2].map(|axis| self.plane(axis, index[axis] + step)));
        Aabb { min: corner(0), max: corner(1) }
    }
}

impl<P: Primitives> Partition<P> for Grid<P::Entry> {
    // ANCHOR: walk
    fn walk<Q: Question, N: Probe>(&self, ray: &Ray, query: &mut Query<'_, P, Q, N>) {
        let slabs = Slabs::of(ray);
        let Some(cells) = &self.cells else { return };
        let Some(inside) = slabs.cross(&cells.aabb, query.range()) else { return };
        let mut march = March::new(cells, ray, &slabs, inside);
        let mut cell = Some(march.number());
        // Go on until the grid ends, or a hit lies before the next cell.
        while let Some(number) = cell
            && march.enters() <= query.range().max
        {
            query.visit(number);
            if query.test(self.list(number)) {
                return;
            }
            cell = march.next();
        }
    }
    // ANCHOR_END: walk

    fn aabb(&self) -> Option<Aabb> {
        self.cells.map(|cells| cells.aabb)
    }

    fn cells(&self) -> Vec<Cell<'_, P::Entry>> {
        let Some(cells) = &self.cells else { return Vec::new() };
        let [columns, rows, layers] = cells.resolution;
        let indices = (0..layers).flat_map(|z| (0..rows).flat_map(move |y| (0..columns).map(move |x| [x, y, z])));
        let cell = |index| {
            let number = cells.number(index);
            Cell { number, aabb: cells.cell(index), list: self.list(number) }
        };
        indices.map(cell).collect()
    }

    fn bytes(&self) -> usize {
        size_of_val(self.begins.as_slice()) + size_of_val(self.lists.as_slice())
    }
}
