//! The lathe: bodies that are turned around an axis.
//!
//! The profile of such a body has radius and height of each ring, upward where the outside is outside. A point twice in
//! a row makes an edge. Each step costs two triangles for each side, or one at a tip of radius 0.

use common::{Basis, Vec2, Vec3, float};
use ray_casting::frame::Frame;

use super::{budget::ratio, builder::Builder};

impl Builder {
    /// A body turned around a frame's y axis. Its tips are one vertex: with smooth shading they are round.
    pub fn turned(&mut self, frame: &Frame, profile: &[Vec2], sides: u32) {
        let sides = sides.max(3);
        let directions: Vec<Vec2> = (0..sides)
            .map(|side| std::f32::consts::TAU * ratio(side, sides))
            .map(|angle| Vec2::new(float::cos(angle), -float::sin(angle)))
            .collect();
        self.rings(profile, |point| {
            let at = |direction: Vec2| {
                frame.point_to_world(Vec3::new(direction.x * point.x, point.y, direction.y * point.x))
            };
            match point.x == 0.0 {
                true => vec![at(Vec2::ZERO)],
                false => directions.iter().map(|&direction| at(direction)).collect(),
            }
        });
    }

    /// A body turned around any axis, a unit vector; heights are those above `foot`. Its tips have a vertex for each
    /// side: with smooth shading they are pointed.
    pub fn turned_around(&mut self, foot: Vec3, axis: Vec3, profile: &[Vec2], sides: u32) {
        let sides = sides.max(3);
        let basis = Basis::around(axis);
        let directions: Vec<Vec3> = (0..sides)
            .map(|side| std::f32::consts::TAU * side as f32 / sides as f32)
            .map(|angle| basis.tangent * float::cos(angle) + basis.bitangent * float::sin(angle))
            .collect();
        self.rings(profile, |point| {
            directions.iter().map(|&direction| foot + direction * point.x + axis * point.y).collect()
        });
    }

    /// The ring of each point of a profile, and belts between them.
    fn rings(&mut self, profile: &[Vec2], places: impl Fn(Vec2) -> Vec<Vec3>) {
        let mut below: Option<(Vec2, Vec<u32>)> = None;
        for &point in profile {
            let ring: Vec<u32> = places(point).into_iter().map(|place| self.vertex(place)).collect();
            if let Some((_, below)) = below.filter(|(last, _)| *last != point) {
                self.belt(&below, &ring);
            }
            below = Some((point, ring));
        }
    }
}
