//! The edges of cells as lines, where no triangle hides them.

use std::collections::HashSet;

use common::{
    Interval, Rgb, Vec2, Vec3,
    drawing::{Drawing, SLATE, mark::Pen},
};
use ray_casting::{aabb::Aabb, camera::Camera, ray::Ray};

use crate::{choice::Countable, primitives::octant};

/// Draws edges as a camera sees them among the triangles of a scene.
pub(super) struct Wires<'w> {
    pub(super) camera: &'w Camera,
    pub(super) scene: &'w dyn Countable,
    /// Size of the view, in units of the page.
    pub(super) size: Vec2,
}

/// An edge from one corner of a cell to another.
type Edge = [Vec3; 2];

impl Wires<'_> {
    /// How many pieces an edge is looked at in: each is either hidden or not.
    const PIECES: u8 = 8;

    /// The edges of all cells.
    pub(super) fn draw(&self, cells: &[Aabb], color: Rgb) -> Drawing {
        let mut drawing = Drawing::new(self.size, SLATE);
        // Neighbors share edges: each is drawn once.
        let mut drawn = HashSet::new();
        let edges =
            cells.iter().flat_map(edges).filter(|edge| drawn.insert(edge.map(|end| end.to_array().map(f32::to_bits))));
        let seen: Vec<Edge> = edges.flat_map(|edge| self.seen(edge)).collect();
        let middle = |edge: &Edge| ((edge[0] + edge[1]) / 2.0 - self.camera.eye()).length();
        let [near, far] = seen
            .iter()
            .map(middle)
            .fold([f32::INFINITY, 0.0], |[near, far], distance| [near.min(distance), far.max(distance)]);
        for edge in &seen {
            let [Some(from), Some(to)] = edge.map(|end| self.place(end)) else { continue };
            // Thinner and paler with distance.
            let share = (middle(edge) - near) / (far - near).max(f32::MIN_POSITIVE);
            let pen = Pen { opacity: 1.0 - 0.6 * share, ..Pen::new(color, 1.5 - 0.7 * share) };
            drawing.line(&[from, to], pen);
        }
        drawing
    }

    /// Where a point is seen in the view.
    fn place(&self, point: Vec3) -> Option<Vec2> {
        let seen = self.camera.project(point)?;
        Some(self.size / 2.0 + Vec2::new(seen.x, -seen.y) * (self.size.min_element() / 2.0))
    }

    /// The parts of an edge that no triangle hides.
    fn seen(&self, [from, to]: Edge) -> Vec<Edge> {
        let at = |i: u8| from.lerp(to, f32::from(i) / f32::from(Self::PIECES));
        let mut parts: Vec<Edge> = Vec::new();
        let mut goes_on = false;
        for i in 0..Self::PIECES {
            let is_seen = self.is_seen((at(i) + at(i + 1)) / 2.0);
            match parts.last_mut().filter(|_| goes_on) {
                Some(part) if is_seen => part[1] = at(i + 1),
                _ if is_seen => parts.push([at(i), at(i + 1)]),
                _ => {}
            }
            goes_on = is_seen;
        }
        parts
    }

    /// Whether nothing stands between the eye and a point.
    fn is_seen(&self, point: Vec3) -> bool {
        let eye = self.camera.eye();
        !self.scene.occluded(&Ray::new(eye, point - eye), Interval::new(0.0, 1.0))
    }
}

/// The twelve edges of a cell.
fn edges(cell: &Aabb) -> impl Iterator<Item = Edge> + use<> {
    // The least corner of each of the eight parts of a cell cut at its greatest corner.
    let corners: [Vec3; 8] = std::array::from_fn(|i| octant(cell, cell.max, i).min);
    let along = move |axis: usize| {
        let lower = (0..8).filter(move |corner| corner >> axis & 1 == 0);
        lower.map(move |corner| [corners[corner], corners[corner | 1 << axis]])
    };
    (0..3).flat_map(along)
}
