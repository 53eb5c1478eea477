//! Further shapes for the builder: boxes, beams, surfaces of revolution, balls and a photographer's backdrop.

use common::{Basis, Vec2, Vec3, float};

use super::builder::Builder;

/// Triangles of a box: two for each of its six sides.
pub(super) const BOX: u32 = 12;

/// Triangles of a [`Builder::ball`]: eight faces of an octahedron, each cut into `fineness` squared.
pub(super) const fn in_ball(fineness: u32) -> u32 {
    8 * fineness * fineness
}

/// The greatest fineness of `count` balls that together have at most so many triangles, but at least 1.
pub(super) fn fineness(triangles: u32, count: u32) -> u32 {
    (f64::from(triangles) / f64::from(in_ball(1)) / f64::from(count.max(1))).sqrt().max(1.0) as u32
}

/// A part of a number of triangles.
pub(super) fn share(triangles: u32, share: f32) -> u32 {
    (f64::from(triangles) * f64::from(share)) as u32
}

/// A point of the smooth curve that runs through all the given points, for `t` from 0 at the first to 1 at the last.
///
/// Source: Catmull, Rom, *A Class of Local Interpolating Splines*, 1974.
pub(super) fn spline(points: &[Vec3], t: f32) -> Vec3 {
    let last = points.len() - 1;
    let along = t.clamp(0.0, 1.0) * last as f32;
    let i = (along as usize).min(last.saturating_sub(1));
    let u = along - i as f32;
    let [before, from, to, after] = [i.saturating_sub(1), i, i + 1, i + 2].map(|i| points[i.min(last)]);
    let (slope, next_slope) = ((to - before) / 2.0, (after - from) / 2.0);
    let bend = 3.0 * (to - from) - 2.0 * slope - next_slope;
    let twist = 2.0 * (from - to) + slope + next_slope;
    from + u * (slope + u * (bend + u * twist))
}

impl Builder {
    /// Make room for so many triangles, of which about every vertex belongs to two.
    pub(super) fn reserve(&mut self, triangles: u32) {
        self.mesh.triangles.reserve(triangles as usize);
        self.mesh.positions.reserve(triangles as usize / 2);
    }

    /// Number of triangles that are missing to so many.
    pub(super) fn missing_to(&self, triangles: u32) -> u32 {
        triangles.saturating_sub(self.count())
    }

    /// A box around `center`, from `-half` to `half` of three directions at right angles, right-handed.
    pub(super) fn solid(&mut self, center: Vec3, half: [Vec3; 3]) {
        // Each pair of opposite sides, spanned by the other two directions.
        for i in 0..3 {
            let [out, u, v] = [half[i], half[(i + 1) % 3], half[(i + 2) % 3]];
            let (near, far) = (center + out, center - out);
            self.quad([near - u - v, near + u - v, near + u + v, near - u + v]);
            self.quad([far - u - v, far - u + v, far + u + v, far + u - v]);
        }
    }

    /// A box along the axes, from its least to its greatest coordinates.
    pub(super) fn upright(&mut self, low: Vec3, high: Vec3) {
        let half = (high - low) / 2.0;
        self.solid(low + half, [Vec3::X * half.x, Vec3::Y * half.y, Vec3::Z * half.z]);
    }

    /// A straight beam of square section.
    pub(super) fn beam(&mut self, from: Vec3, to: Vec3, thickness: f32) {
        let along = (to - from) / 2.0;
        let basis = Basis::around(along.normalize_or(Vec3::Y));
        let half = thickness / 2.0;
        self.solid(from + along, [basis.tangent * half, basis.bitangent * half, along]);
    }

    /// A surface of revolution around the unit vector `axis`. The profile has the distance from the axis in `x` and the
    /// height above `foot` in `y`, from below to above for an outer side. Two equal points in sequence make an edge that
    /// is not smoothed. Has two triangles for each segment and step of the profile, one where a step starts or ends on
    /// the axis, none between equal points.
    pub(super) fn revolve(&mut self, foot: Vec3, axis: Vec3, profile: &[Vec2], segments: u32) {
        let segments = segments.max(3);
        let basis = Basis::around(axis);
        let first = self.mesh.positions.len() as u32;
        // All rings have all vertices, so that normals on the axis may differ around it.
        let turns: Vec<Vec3> = (0..segments)
            .map(|segment| {
                let angle = std::f32::consts::TAU * segment as f32 / segments as f32;
                basis.tangent * float::cos(angle) + basis.bitangent * float::sin(angle)
            })
            .collect();
        for point in profile {
            for turn in &turns {
                self.vertex(foot + *turn * point.x + axis * point.y);
            }
        }
        for (ring, pair) in (0..).zip(profile.windows(2)) {
            let [below, above] = [pair[0], pair[1]];
            if below == above {
                continue;
            }
            let at = |ring: u32, segment: u32| first + ring * segments + segment % segments;
            for segment in 0..segments {
                let [a, b] = [at(ring, segment), at(ring, segment + 1)];
                let [c, d] = [at(ring + 1, segment + 1), at(ring + 1, segment)];
                if below.x > 0.0 {
                    self.triangle([a, b, c]);
                }
                if above.x > 0.0 {
                    self.triangle([a, c, d]);
                }
            }
        }
    }

    /// A ball: an octahedron whose faces are cut into `fineness` squared triangles each and blown up.
    pub(super) fn globe(&mut self, center: Vec3, radius: f32, fineness: u32) {
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

    /// A photographer's backdrop: a floor at height 0 that runs to `depth` behind the origin and bends upward there into
    /// a wall. It has four triangles for each of `rows` rows, which are at least 5.
    pub(super) fn backdrop(&mut self, width: f32, depth: f32, height: f32, rows: u32) {
        let rows = rows.max(5);
        let bend = height / 2.0;
        self.surface(2, rows, |u, v| {
            let x = width * (u - 0.5);
            // The floor is the first row, the wall the last, all the others make the bend: a quarter of a circle.
            let row = (v * rows as f32).round();
            if row < 1.0 {
                return Vec3::new(x, 0.0, 2.0 * depth);
            }
            if row >= rows as f32 {
                return Vec3::new(x, height, -depth);
            }
            let angle = std::f32::consts::FRAC_PI_2 * (row - 1.0) / (rows - 2) as f32;
            Vec3::new(x, bend * (1.0 - float::cos(angle)), bend - depth - bend * float::sin(angle))
        });
    }
}
