//! Rays that leave a surface must not hit it again at once: a million of them, from all shapes, small and large, near and far.

use common::{Interval, Stream, Vec3};
use ray_casting::{
    hit::{Hit, Side},
    ray::Ray,
};
use shadows::offset::Offset;
use whitted::{
    branches::branches,
    material::{Fresnel, Material},
};

use crate::{
    exact::Line,
    rays::{aimed, direction, in_cube, magnitude, one_of},
    subjects::{Subject, subjects},
};

/// How rays that leave a shape have fared.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    /// How many rays are to be judged.
    goal: u32,
    /// Rays that left the shape.
    rays: u32,
    /// Of those, rays that nearly grazed it.
    grazing: u32,
    /// Rays that left from the inner side.
    inside: u32,
    /// Rays that hit it again, as they should.
    met: u32,
    /// Rays that started on the wrong side of it.
    beneath: u32,
    /// Rays that hit it where there is nothing.
    false_hits: u32,
}

impl Subject {
    /// A ray at the shape from so many sizes away: at any place of it, or so that it nearly grazes it.
    fn camera_ray(&self, sizes: f32, random: &mut Stream) -> Option<Ray> {
        let eye = self.center + direction(random) * sizes * self.size;
        let ray = aimed(eye, self.center + in_cube(random) * self.size);
        if one_of(random, 3) > 0 {
            return Some(ray);
        }
        let hit = self.shape.intersect(&ray, Interval::POSITIVE)?;
        let leaving = grazing(hit.geometric_normal, random);
        Some(aimed(hit.position + leaving * sizes * self.size, hit.position))
    }

    /// Hit the shape with a ray, leave it in all ways, and follow one of them to the next hit, and so on.
    fn follow(&self, mut ray: Ray, offset: Offset, random: &mut Stream, tally: &mut Tally) {
        const GENERATIONS: u32 = 4;
        for _ in 0..GENERATIONS {
            let Some(hit) = self.shape.intersect(&ray, Interval::POSITIVE) else { return };
            let leaving = departures(&ray, &hit, offset, random);
            for departure in leaving.iter().flatten() {
                self.judge(&hit, departure, tally);
            }
            let Some(next) = leaving[one_of(random, leaving.len())] else { return };
            ray = next.ray;
        }
    }

    /// Count how one ray fares.
    fn judge(&self, hit: &Hit, departure: &Departure, tally: &mut Tally) {
        let Departure { ray, side } = departure;
        let line = Line::of(ray);
        if tally.rays == tally.goal {
            return;
        }
        tally.rays += 1;
        tally.inside += u32::from(*side == Side::Inside);
        tally.grazing += u32::from(ray.direction.dot(hit.geometric_normal).abs() < 0.05);
        let height = self.truth.height(hit, line.origin);
        let is_beneath = if *side == Side::Outside { height <= 0.0 } else { height >= 0.0 };
        tally.beneath += u32::from(is_beneath);
        let Some(again) = self.shape.intersect(ray, Interval::POSITIVE) else { return };
        // From a convex shape nothing comes back. Elsewhere, a hit nearby must be where f64 finds one, or before that.
        let nearby = f64::from(0.02 * self.size);
        let distance = f64::from(again.t);
        let is_false = if self.convex && *side == Side::Outside {
            true
        } else {
            distance < nearby && !self.truth.is_met(&line, 2.0 * distance)
        };
        tally.met += u32::from(!is_false);
        tally.false_hits += u32::from(is_false);
    }
}

/// A ray that leaves a surface, and the side on which it starts.
#[derive(Clone, Copy)]
struct Departure {
    ray: Ray,
    side: Side,
}

/// A shadow ray, the reflected ray, and the refracted one if there is one.
fn departures(ray: &Ray, hit: &Hit, offset: Offset, random: &mut Stream) -> [Option<Departure>; 3] {
    let normal = hit.geometric_normal;
    let light = if one_of(random, 3) == 0 { grazing(normal, random) } else { direction(random) };
    let light = if light.dot(normal) < 0.0 { -light } else { light };
    let shadow = Ray::new(offset.origin(hit, normal), light);
    let [reflected, refracted] =
        branches(ray, hit, &Material::glass(1.5), Fresnel::Exact, offset).map(|b| b.map(|b| b.ray));
    let other = if hit.side == Side::Outside { Side::Inside } else { Side::Outside };
    // A shading normal may send a ray to the wrong side: there it meets the surface with good reason.
    let leaves = |ray: &Ray, sign: f32| ray.direction.dot(normal) * sign > 0.0;
    [
        Some(Departure { ray: shadow, side: hit.side }).filter(|_| light.dot(normal) > 0.0),
        reflected.filter(|ray| leaves(ray, 1.0)).map(|ray| Departure { ray, side: hit.side }),
        refracted.filter(|ray| leaves(ray, -1.0)).map(|ray| Departure { ray, side: other }),
    ]
}

/// A unit vector that nearly lies in the plane with this normal, a little above it.
fn grazing(normal: Vec3, random: &mut Stream) -> Vec3 {
    let along = normal.cross(direction(random)).try_normalize().unwrap_or(Vec3::X);
    (along + normal * magnitude(random, 1e-4, 0.1)).normalize()
}

const SCALES: [f32; 5] = [1e-3, 1.0, 1e2, 1e4, 1e5];

/// How many rays leave each shape at each scale.
const RAYS_EACH: u32 = 5_000;

/// Let rays leave all shapes at all scales; for each shape and scale, how they fared.
fn leave_all(offset: Offset, goal: u32) -> Vec<(&'static str, f32, Tally)> {
    let mut tallies = Vec::new();
    for (i, scale) in SCALES.into_iter().enumerate() {
        let mut random = Stream::new(821, i as u64, 0);
        for subject in subjects(scale, &mut random) {
            let mut tally = Tally { goal, ..Tally::default() };
            while tally.rays < goal {
                let sizes = [5.0, 100.0][one_of(&mut random, 2)];
                if let Some(ray) = subject.camera_ray(sizes, &mut random) {
                    subject.follow(ray, offset, &mut random, &mut tally);
                }
            }
            tallies.push((subject.name, scale, tally));
        }
    }
    tallies
}

impl Tally {
    fn failed(&self) -> u32 {
        self.beneath + self.false_hits
    }
}

/// How many rays left, and how many of them hit at once what they left.
pub(crate) fn self_hits(offset: Offset) -> [u32; 2] {
    let tallies = leave_all(offset, RAYS_EACH);
    [tallies.iter().map(|t| t.2.rays).sum(), tallies.iter().map(|t| t.2.failed()).sum()]
}

#[test]
fn no_ray_hits_at_once_what_it_has_left() {
    let tallies = leave_all(Offset::Following, RAYS_EACH);
    for (name, scale, tally) in &tallies {
        assert_eq!(tally.failed(), 0, "{name} at {scale}: {tally:?}");
        // The test was a test: rays left both sides, some of them nearly along the surface.
        assert!(tally.inside > RAYS_EACH / 10 && tally.inside < RAYS_EACH * 9 / 10, "{name} at {scale}: {tally:?}");
        assert!(tally.grazing > RAYS_EACH / 20, "{name} at {scale}: {tally:?}");
    }
    assert_eq!(tallies.iter().map(|t| t.2.rays).sum::<u32>(), 1_000_000);
    // Rays that left for the inside of something met the other side of it.
    assert!(tallies.iter().map(|t| t.2.met).sum::<u32>() > 200_000);
}

/// Other offsets do fail, so the judge can see it.
#[test]
fn other_offsets_do_not_do() {
    let failed = |offset, at: fn(f32) -> bool| -> u32 {
        leave_all(offset, RAYS_EACH / 10)
            .iter()
            .filter(|(_, scale, _)| at(*scale))
            .map(|(_, _, tally)| tally.failed())
            .sum()
    };
    // No offset: at all scales.
    assert!(failed(Offset::Fixed(0.0), |_| true) > 10_000);
    // A thousandth of a unit: not for what is large, and not for what is itself only a thousandth large.
    assert_eq!(failed(Offset::Fixed(1e-3), |scale| scale == 1.0), 0);
    assert!(failed(Offset::Fixed(1e-3), |scale| scale > 1e3) > 1_000);
    assert!(failed(Offset::Fixed(1e-3), |scale| scale < 1.0) > 1_000);
    // The bits of the coordinates: not where one of them is near zero and the others are large.
    assert!(failed(Offset::Bits, |_| true) > 100);
}
