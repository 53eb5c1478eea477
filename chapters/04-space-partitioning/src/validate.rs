//! Checks of a structure against everything that a walk relies on.

use common::Vec3;
use ray_casting::aabb::Aabb;

use crate::{
    primitives::{Primitives, overlap},
    structure::{Cell, Partition, Structure},
};

impl<P: Primitives, T: Partition<P>> Structure<P, T> {
    // ANCHOR: validate
    /// Check that the cells fill the box around everything, that no list names a primitive twice or one that is not
    /// near, and that every primitive stands in the list of every cell that it reaches into. It looks at every primitive
    /// for every cell, so it takes its time: it is meant for tests of up to some thousand primitives.
    ///
    /// # Errors
    /// In words, what is wrong and where.
    pub fn validate(&self) -> Result<(), String> {
        let cells = self.partition.cells();
        let Some(whole) = self.partition.aabb() else {
            return match cells.iter().find(|cell| !cell.list.is_empty()) {
                Some(cell) => Err(format!("cell {} lists something where there is nothing", cell.number)),
                None => Ok(()),
            };
        };
        is_filled(&whole, &cells.iter().map(|cell| cell.aabb).collect::<Vec<_>>())?;
        cells.iter().try_for_each(|cell| self.is_listed_rightly(cell))
    }
    // ANCHOR_END: validate

    /// Check the list of a cell.
    fn is_listed_rightly(&self, cell: &Cell<'_, P::Entry>) -> Result<(), String> {
        let mut listed: Vec<_> = cell.list.iter().map(|entry| self.primitives.number(entry)).collect();
        listed.sort_unstable();
        if let Some(twice) = listed.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(format!("cell {} lists primitive {} twice", cell.number, twice[0]));
        }
        // What barely touches a cell may be listed or not: look at the cell a little larger, and a little smaller.
        let size = cell.aabb.max - cell.aabb.min;
        let rounding = cell.aabb.min.abs().max(cell.aabb.max.abs()) * 1e-6;
        let resized = |by: Vec3| Aabb { min: cell.aabb.min - by, max: cell.aabb.max + by };
        let (larger, smaller) = (resized(rounding), resized(-(size * 1e-3 + rounding)));
        for number in 0..self.primitives.count() {
            let is_listed = listed.binary_search(&number).is_ok();
            let aabb = self.primitives.aabb(number);
            if is_listed && overlap(&aabb, &larger).is_none() {
                return Err(format!("cell {} lists primitive {number}, which is not near", cell.number));
            }
            let reaches = overlap(&aabb, &smaller).and_then(|_| self.primitives.clipped(number, &smaller));
            if !is_listed && reaches.is_some() {
                return Err(format!("cell {} does not list primitive {number}, which reaches into it", cell.number));
            }
        }
        if let Some(unknown) = listed.iter().find(|&&number| number >= self.primitives.count()) {
            return Err(format!("cell {} lists primitive {unknown}, which does not exist", cell.number));
        }
        Ok(())
    }
}

/// Check that boxes fill a larger box: all lie inside, and their volumes sum up to its volume.
fn is_filled(whole: &Aabb, parts: &[Aabb]) -> Result<(), String> {
    if let Some(outside) = parts.iter().find(|part| !(whole.contains(part.min) && whole.contains(part.max))) {
        return Err(format!("a cell, {outside:?}, lies outside of {whole:?}"));
    }
    // A box that is flat along an axis has no volume: leave that axis out.
    let size = (whole.max - whole.min).as_dvec3().to_array();
    let volume = |aabb: &Aabb| -> f64 {
        let sides = (aabb.max - aabb.min).as_dvec3().to_array();
        sides.iter().zip(size).filter(|(_, size)| *size > 0.0).map(|(side, size)| side / size).product()
    };
    let sum: f64 = parts.iter().map(volume).sum();
    if (sum - 1.0).abs() > 1e-3 {
        return Err(format!("the cells fill {sum} times the whole"));
    }
    Ok(())
}
