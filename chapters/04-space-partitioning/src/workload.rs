//! The workload: rays of the three kinds that a renderer asks for, the same for every structure that is compared.

use common::{Basis, Interval, Stream, Vec2, Vec3, float, parallel, picture::FilmPoint};
use ray_casting::{hit::Hit, light::Light, ray::Ray, shape::Shape};
use shadows::offset::Offset;

use crate::viewed_mesh::ViewedMesh;

// ANCHOR: kinds
/// What a ray is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayKind {
    /// From the eye through a pixel: neighbors go the same way. What is hit first?
    Primary,
    /// From a surface in any direction, as a matte surface scatters light: neighbors go different ways.
    Bounce,
    /// From a surface to a light: is anything hit at all?
    Shadow,
}

impl RayKind {
    /// All of them.
    pub const ALL: [RayKind; 3] = [RayKind::Primary, RayKind::Bounce, RayKind::Shadow];

    /// What to call it.
    #[must_use]
    pub fn name(self) -> &'static str {
        ["primary", "diffuse bounce", "shadow"][self as usize]
    }
}
// ANCHOR_END: kinds

/// A ray, and where its hits count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cast {
    /// The ray.
    pub ray: Ray,
    /// Where hits count.
    pub range: Interval,
}

/// Rays of all kinds, in the order of the pixels that they belong to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Workload([Vec<Cast>; 3]);

impl Workload {
    // ANCHOR: workload
    /// About `count` primary rays, a film in the shape of 4:3; and for each of their hits a bounce ray, and a shadow
    /// ray if a light shines on it. `shape` finds the hits. Whatever structure that is, the rays are the same.
    #[must_use]
    pub fn new(viewed: &ViewedMesh, shape: &(impl Shape + ?Sized), count: u32, seed: u64) -> Self {
        let [columns, rows] = film(count);
        #[expect(clippy::cast_precision_loss, reason = "a film has far fewer than 2²⁴ columns")]
        let row = |row: usize| {
            let mut casts = Self::default();
            for column in 0..columns {
                let position = Vec2::new(column as f32, row as f32) + 0.5;
                let point = FilmPoint { position, size: Vec2::new(columns as f32, rows as f32) };
                let mut random = Stream::new(seed, (row * columns + column) as u64, 0);
                casts.follow(viewed.camera.ray(point), shape, &viewed.lights, &mut random);
            }
            casts
        };
        let mut all = Self::default();
        for mut row in parallel::map(rows, row) {
            all.0.iter_mut().zip(&mut row.0).for_each(|(all, row)| all.append(row));
        }
        all
    }

    /// Add a primary ray, and the rays from where it hits.
    fn follow(&mut self, ray: Ray, shape: &(impl Shape + ?Sized), lights: &[Box<dyn Light>], random: &mut Stream) {
        let [primary, bounce, shadow] = &mut self.0;
        primary.push(Cast { ray, range: Interval::POSITIVE });
        let Some(hit) = shape.intersect(&ray, Interval::POSITIVE) else { return };
        let origin = Offset::Following.origin(&hit, hit.geometric_normal);
        let scattered = cosine_distributed(hit.geometric_normal, random);
        bounce.push(Cast { ray: Ray::new(origin, scattered), range: Interval::POSITIVE });
        shadow.extend(toward_a_light(&hit, origin, lights, random));
    }
    // ANCHOR_END: workload

    /// The rays of a kind.
    #[must_use]
    pub fn casts(&self, kind: RayKind) -> &[Cast] {
        &self.0[kind as usize]
    }

    /// Number of rays of all kinds.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.iter().map(Vec::len).sum()
    }

    /// Whether there is no ray; never so for a workload that was made.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// Columns and rows of a film of shape 4:3 with at most `count` pixels, but at least one.
fn film(count: u32) -> [usize; 2] {
    let count = count.max(1);
    let rows = (count * 3 / 4).isqrt().max(1);
    [(count / rows) as usize, rows as usize]
}

// ANCHOR: cosine
/// A direction over a matte surface: its probability is in proportion to the cosine of the angle to the normal.
///
/// Source: Malley's method: a point in a disc, lifted up to the hemisphere (PBRT, section A.5.3).
fn cosine_distributed(normal: Vec3, random: &mut Stream) -> Vec3 {
    let radius_squared = random.uniform();
    let angle = std::f32::consts::TAU * random.uniform();
    let (x, y) = (float::cos(angle), float::sin(angle));
    let local = (Vec3::new(x, y, 0.0) * radius_squared.sqrt()).with_z((1.0 - radius_squared).sqrt());
    Basis::around(normal).to_world(local)
}
// ANCHOR_END: cosine

/// A ray to one of the lights that shine on a hit, or none if it lies in the dark.
fn toward_a_light(hit: &Hit, origin: Vec3, lights: &[Box<dyn Light>], random: &mut Stream) -> Option<Cast> {
    let lights = lights.iter().map(|light| light.illuminate(hit.position));
    let shining: Vec<_> = lights.filter(|light| light.direction.dot(hit.geometric_normal) > 0.0).collect();
    #[expect(clippy::cast_precision_loss, reason = "few lights")]
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "rounded down, from 0 up")]
    let light = shining.get((random.uniform() * shining.len() as f32) as usize)?;
    Some(Cast { ray: Ray::new(origin, light.direction), range: Interval::POSITIVE.up_to(light.distance) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{choice::Choice, scenes::GENERATORS};

    fn workload(choice: Choice, seed: u64) -> Workload {
        let viewed = ViewedMesh::of_model((GENERATORS[0].make)(1_000)).unwrap();
        let structure = choice.over(viewed.mesh.clone()).unwrap();
        Workload::new(&viewed, structure.as_ref(), 1_200, seed)
    }

    #[test]
    fn every_structure_makes_the_same_rays() {
        let rays = workload(Choice::KdTree, 0);
        for choice in Choice::ALL {
            assert!(workload(choice, 0) == rays, "{}", choice.name());
        }
        assert!(workload(Choice::KdTree, 1) != rays);
    }

    #[test]
    fn rays_are_what_they_are_called() {
        let rays = workload(Choice::Grid, 0);
        let [primary, bounce, shadow] = RayKind::ALL.map(|kind| rays.casts(kind));
        assert_eq!((primary.len(), rays.len()), (1_200, primary.len() + bounce.len() + shadow.len()));
        assert!(!bounce.is_empty() && bounce.len() <= 1_200 && !shadow.is_empty() && shadow.len() <= bounce.len());
        for cast in primary.iter().chain(bounce).chain(shadow) {
            assert!((cast.ray.direction.length() - 1.0).abs() < 1e-5 && cast.ray.origin.is_finite());
        }
        assert!(primary.iter().all(|cast| cast.ray.origin == primary[0].ray.origin));
        // Lamps are near, the sun is not.
        assert!(shadow.iter().any(|cast| cast.range.max.is_finite()));
        assert!(shadow.iter().any(|cast| cast.range.max.is_infinite()));
    }

    #[test]
    fn films_have_about_the_wanted_number_of_pixels() {
        assert_eq!([film(0), film(1), film(1_200), film(3)], [[1, 1], [1, 1], [40, 30], [3, 1]]);
        for count in [10, 777, 100_000, 2_000_000] {
            let [columns, rows] = film(count);
            let made = columns * rows;
            assert!(made <= count as usize && made * 10 > count as usize * 8, "{made} of {count}");
        }
    }

    /// The mean of the cosine is ∫cos²/π = 2/3, that of any direction across is 0.
    #[test]
    fn scattered_directions_follow_the_cosine() {
        const COUNT: usize = 20_000;
        let normal = Vec3::new(0.6, 0.0, -0.8);
        let mut random = Stream::new(4, 0, 0);
        let mut sum = Vec3::ZERO;
        for _ in 0..COUNT {
            let direction = Basis::around(normal).to_local(cosine_distributed(normal, &mut random));
            assert!(direction.z > 0.0);
            sum += direction;
        }
        // Standard deviations: √(1/2 − 4/9) of the cosine, 1/2 across; five sigma.
        let mean = sum / COUNT as f32;
        let sigma = 1.0 / (COUNT as f32).sqrt();
        assert!((mean.z - 2.0 / 3.0).abs() < 5.0 * 0.24 * sigma, "{mean}");
        assert!(mean.x.abs() < 2.5 * sigma && mean.y.abs() < 2.5 * sigma, "{mean}");
    }

    #[test]
    fn who_sees_nothing_has_primary_rays_only() {
        // A triangle without area.
        let mesh = common::obj::parse(b"v 1 2 3\nf 1 1 1\n").unwrap();
        let viewed = ViewedMesh::of_file(&mesh).unwrap();
        let structure = Choice::KdTree.over(viewed.mesh.clone()).unwrap();
        let rays = Workload::new(&viewed, structure.as_ref(), 100, 0);
        assert_eq!(RayKind::ALL.map(|kind| rays.casts(kind).len()), [96, 0, 0]);
    }
}
