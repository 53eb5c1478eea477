//! Balls, cut evenly: their triangles are all about as large, everywhere.

use common::Vec3;

use super::builder::Builder;

/// Number of triangles of a [`Builder::ball`]: eight faces of an octahedron, each cut into `fineness` squared.
#[must_use]
pub const fn cost(fineness: u32) -> u32 {
    8 * fineness * fineness
}

/// The greatest fineness of so many balls that together have at most so many triangles, but at least 1.
#[must_use]
pub fn fineness(triangles: u32, balls: u32) -> u32 {
    (f64::from(triangles) / f64::from(cost(1)) / f64::from(balls.max(1))).sqrt().max(1.0) as u32
}

impl Builder {
    /// A ball: an octahedron whose faces are cut into `fineness` squared triangles each and blown up.
    pub fn ball(&mut self, center: Vec3, radius: f32, fineness: u32) {
        let fineness = fineness.max(1);
        let first = self.mesh.positions.len() as u32;
        // Rings from the upper pole down to the lower one; the ring of index r has 4 · (distance to the nearer pole).
        let steps = |ring: u32| ring.min(2 * fineness - ring);
        for ring in 0..=2 * fineness {
            let steps = steps(ring);
            let height = 1.0 - ring as f32 / fineness as f32;
            if steps == 0 {
                self.vertex(center + Vec3::Y * (height * radius));
                continue;
            }
            for (from, to) in [(Vec3::X, -Vec3::Z), (-Vec3::Z, -Vec3::X), (-Vec3::X, Vec3::Z), (Vec3::Z, Vec3::X)] {
                for step in 0..steps {
                    let across = from.lerp(to, step as f32 / steps as f32) * (1.0 - height.abs());
                    self.vertex(center + (across + Vec3::Y * height).normalize_or(Vec3::Y) * radius);
                }
            }
        }
        // Between two rings each quarter has one triangle more that stands on the longer ring.
        let mut start = first;
        for ring in 0..2 * fineness {
            let (upper, lower) = (steps(ring), steps(ring + 1));
            let next = start + (4 * upper).max(1);
            let above = |quarter: u32, step: u32| start + (quarter * upper + step) % (4 * upper).max(1);
            let below = |quarter: u32, step: u32| next + (quarter * lower + step) % (4 * lower).max(1);
            for quarter in 0..4 {
                for step in 0..lower {
                    let tip = above(quarter, step.min(upper));
                    let tip = if lower > upper { tip } else { above(quarter, step + 1) };
                    self.triangle([tip, below(quarter, step), below(quarter, step + 1)]);
                }
                for step in 0..upper {
                    let tip = if lower > upper { below(quarter, step + 1) } else { below(quarter, step) };
                    self.triangle([tip, above(quarter, step + 1), above(quarter, step)]);
                }
            }
            start = next;
        }
    }
}
