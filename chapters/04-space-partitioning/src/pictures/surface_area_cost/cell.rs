//! A concrete cell, and what halving it costs.

use common::{Vec2, Vec3};
use ray_casting::aabb::Aabb;

use crate::{
    kd_tree::split::{CellCost, Costs},
    scenes::chance::Chance,
};

/// A cell with primitives in boxes.
pub(super) struct Cell {
    pub(super) aabb: Aabb,
    pub(super) boxes: Vec<(u32, Aabb)>,
    pub(super) costs: Costs,
}

impl Cell {
    /// A crowd of small boxes at the left, some larger ones in the middle, two at the right, air at both ends.
    pub(super) fn crowded(costs: Costs) -> Self {
        let aabb = Aabb { min: Vec3::ZERO, max: Vec3::new(10.0, 4.0, 4.0) };
        let mut boxes = Vec::new();
        for i in 0..16 {
            let mut chance = Chance::of("crowd", i);
            let corner = Vec3::new(chance.between(0.7, 2.5), chance.between(0.2, 1.9), chance.between(0.2, 2.9));
            let size = Vec3::new(chance.between(0.15, 0.6), chance.between(0.15, 0.6), chance.between(0.2, 0.9));
            boxes.push((i, Aabb { min: corner, max: corner + size }));
        }
        for i in 16..22 {
            let mut chance = Chance::of("larger", i);
            let corner = Vec3::new(chance.between(3.4, 5.2), chance.between(0.1, 2.0), chance.between(0.2, 1.6));
            let size = Vec3::new(chance.between(0.6, 1.5), chance.between(0.5, 1.7), chance.between(0.8, 2.2));
            boxes.push((i, Aabb { min: corner, max: corner + size }));
        }
        let right = |x, y| Aabb { min: Vec3::new(x, y, 0.6), max: Vec3::new(x + 0.8, y + 1.1, 2.4) };
        boxes.extend([(22, right(7.2, 0.4)), (23, right(7.6, 2.3))]);
        Self { aabb, boxes, costs }
    }

    /// The cost of testing everything.
    pub(super) fn whole(&self) -> f32 {
        self.costs.intersection * self.boxes.len() as f32
    }

    /// How many boxes reach below and above a plane.
    pub(super) fn counts(&self, axis: usize, position: f32) -> [usize; 2] {
        let count = |reaches: &dyn Fn(&Aabb) -> bool| self.boxes.iter().filter(|(_, aabb)| reaches(aabb)).count();
        [count(&|aabb| aabb.min[axis] < position), count(&|aabb| aabb.max[axis] > position)]
    }

    /// The cost of halving it by a plane.
    pub(super) fn cost(&self, axis: usize, position: f32) -> f32 {
        let [lower, upper] = self.counts(axis, position);
        CellCost::new(self.costs, &self.aabb).of(axis, position, lower, upper)
    }

    /// The cost over the position: straight between two ends of boxes, with steps there.
    pub(super) fn curve(&self, axis: usize) -> Vec<Vec2> {
        let mut ends = vec![self.aabb.min[axis], self.aabb.max[axis]];
        ends.extend(self.boxes.iter().flat_map(|(_, aabb)| [aabb.min[axis], aabb.max[axis]]));
        ends.sort_by(f32::total_cmp);
        ends.dedup();
        let cost = CellCost::new(self.costs, &self.aabb);
        let piece = |ends: &[f32]| {
            let [lower, upper] = self.counts(axis, f32::midpoint(ends[0], ends[1]));
            [ends[0], ends[1]].map(|end| Vec2::new(end, cost.of(axis, end, lower, upper)))
        };
        ends.windows(2).flat_map(piece).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kd_tree::split::{Rule, choose};

    #[test]
    fn the_chosen_plane_is_the_lowest_point_of_all_curves() {
        for intersection in [0.3, 0.5, 2.0] {
            for empty_bonus in [0.0, 0.2, 0.6] {
                let costs = Costs { intersection, empty_bonus, ..Costs::default() };
                let cell = Cell::crowded(costs);
                let split = choose(Rule::SurfaceArea(costs), &cell.boxes, &cell.aabb).unwrap();
                let curves = (0..3).flat_map(|axis| cell.curve(axis));
                let lowest = curves.map(|point| point.y).fold(f32::INFINITY, f32::min);
                assert_eq!(split.cost, lowest, "{costs:?}");
                assert!(split.cost < cell.whole());
            }
        }
    }
}
