//! Wrong panels, all of one recipe with one ingredient changed.

use common::{Interval, Rgb, Vec2, Vec3, exercise::Verdict};
use glam::Vec2Swizzles as _;
use ray_casting::{hit::Hit, ray::Ray, scene::Scene};
use shadows::offset::Offset;

use crate::{checks::soft_shadows::check, name};

/// One place on the panel, seen from the lit point.
#[derive(Clone, Copy)]
struct Place {
    direction: Vec3,
    distance: f32,
    /// `edges[0] × edges[1]`.
    area: Vec3,
    /// Cosine at the surface.
    cosine: f32,
}

impl Place {
    /// The square of the distance.
    fn square(self) -> f32 {
        self.distance * self.distance
    }
}

/// How a panel gives light. The default is right.
#[derive(Clone, Copy)]
struct Recipe {
    /// Shares of both edges, by column, row, n and jitter.
    share: fn(usize, usize, usize, &[Vec2]) -> Vec2,
    /// What one place gives, for a radiance of 1.
    strength: fn(Place) -> f32,
    /// Whether it counts at all.
    counts: fn(Place) -> bool,
    /// The shadow ray and its range.
    ray: fn(&Hit, Place) -> (Ray, Interval),
    normal: fn(&Hit) -> Vec3,
    /// The answer, by the sum, the number of places that are seen, and the number of all.
    mean: fn(Rgb, f32, f32) -> (f32, Rgb),
}

fn cell(column: usize, row: usize) -> Vec2 {
    Vec2::new(column as f32, row as f32)
}

const RIGHT: Recipe = Recipe {
    share: |column, row, n, jitter| (cell(column, row) + jitter[row * n + column]) / n as f32,
    strength: |p| p.cosine * -p.direction.dot(p.area) / (p.distance * p.distance),
    counts: |p| p.cosine > 0.0 && -p.direction.dot(p.area) > 0.0,
    ray: |hit, p| {
        let origin = Offset::Following.origin(hit, hit.geometric_normal);
        (Ray::new(origin, p.direction), Interval::POSITIVE.up_to(p.distance))
    },
    normal: |hit| hit.shading_normal,
    mean: |sum, seen, all| (seen / all, sum / all),
};

impl Recipe {
    fn light(
        &self,
        [corner, first, second]: [Vec3; 3],
        radiance: Rgb,
        scene: &Scene<()>,
        hit: &Hit,
        n: u16,
        jitter: &[Vec2],
    ) -> (f32, Rgb) {
        let n = usize::from(n);
        let (mut sum, mut seen) = (Rgb::ZERO, 0.0);
        for (row, column) in (0..n).flat_map(|row| (0..n).map(move |column| (row, column))) {
            let share = (self.share)(column, row, n, jitter);
            let to_light = corner + first * share.x + second * share.y - hit.position;
            let (direction, distance) = (to_light.normalize(), to_light.length());
            let cosine = direction.dot((self.normal)(hit));
            let place = Place { direction, distance, area: first.cross(second), cosine };
            let (ray, range) = (self.ray)(hit, place);
            if (self.counts)(place) && !scene.occluded(&ray, range) {
                seen += 1.0;
                sum += radiance * (self.strength)(place);
            }
        }
        (self.mean)(sum, seen, (n * n) as f32)
    }

    fn check(self) -> Verdict {
        check(move |panel, radiance, scene, hit, n, jitter| self.light(panel, radiance, scene, hit, n, jitter))
    }

    fn diagnosis(self) -> &'static str {
        name(self.check())
    }
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(RIGHT.check(), Ok(()));
    // The range in lengths of the whole way.
    let whole: fn(&Hit, Place) -> (Ray, Interval) = |hit, p| {
        let origin = Offset::Following.origin(hit, hit.geometric_normal);
        (Ray::new(origin, p.direction * p.distance), Interval::new(0.0, 1.0))
    };
    assert_eq!(Recipe { ray: whole, ..RIGHT }.check(), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(Recipe { counts: |_| false, ..RIGHT }.diagnosis(), "not-started");
}

#[test]
fn wrong_means() {
    let mean = |mean| Recipe { mean, ..RIGHT }.diagnosis();
    assert_eq!(mean(|sum, seen, all| (seen / all, sum)), "sum-not-mean");
    assert_eq!(mean(|sum, seen, all| (seen / all, sum / seen)), "mean-of-the-seen");
    assert_eq!(
        mean(|sum, seen, all| (seen / all, if seen > 0.0 { sum / seen } else { Rgb::ZERO })),
        "mean-of-the-seen"
    );
    assert_eq!(mean(|sum, seen, all| (seen / all, sum / all * (seen / all))), "shadow-twice");
    assert_eq!(mean(|sum, seen, all| (seen, sum / all)), "visible-is-a-count");
    assert_eq!(mean(|sum, seen, _| (seen, sum)), "sum-not-mean");
    assert_eq!(mean(|sum, seen, all| (seen / all.sqrt(), sum / all.sqrt())), "divided-by-n");
    assert_eq!(mean(|sum, seen, all| (seen / all, sum / all.sqrt())), "divided-by-n");
    assert_eq!(mean(|sum, seen, all| (1.5 * seen / all, sum / all)), "not-a-share");
    assert_eq!(mean(|sum, seen, all| (seen / all, Rgb::splat(sum.x / all))), "one-channel");
    assert_eq!(mean(|sum, seen, all| (seen / all, sum / (all - 1.0))), "not-a-number");
}

#[test]
fn wrong_places() {
    let share = |share| Recipe { share, ..RIGHT }.diagnosis();
    assert_eq!(share(|_, _, _, _| Vec2::splat(0.5)), "center-only");
    assert_eq!(share(|c, r, n, _| (cell(c, r) + 0.5) / n as f32), "jitter-ignored");
    assert_eq!(share(|c, r, n, jitter| (cell(c, r) + jitter[0]) / n as f32), "jitter-shared");
    assert_eq!(share(|c, r, n, jitter| (cell(c, r) + jitter[c * n + r]) / n as f32), "jitter-transposed");
    assert_eq!(share(|c, r, n, jitter| cell(c, r) / n as f32 + jitter[r * n + c]), "jitter-not-divided");
    assert_eq!(share(|c, r, n, jitter| jitter[r * n + c]), "no-grid");
    assert_eq!(share(|c, r, n, _| cell(c, r) / n as f32), "jitter-ignored");
    assert_eq!(share(|c, r, n, _| cell(c, r) / (n as f32 - 1.0).max(1.0)), "wrong-part");
    let too_far: fn(usize, usize, usize, &[Vec2]) -> Vec2 =
        |c, r, n, jitter| (cell(c, r) + jitter[r * n + c]) / (n as f32 - 1.0).max(1.0);
    assert_eq!(share(too_far), "wrong-part");
    assert_eq!(share(|c, r, n, jitter| (cell(c, r) + 1.0 + jitter[r * n + c]) / n as f32), "wrong-part");
    assert_eq!(share(|c, r, n, jitter| (cell(c, r) + jitter[r * n + c] - 0.5) / n as f32), "jitter-centered");
    assert_eq!(share(|c, r, n, jitter| (cell(r, c) + jitter[r * n + c]) / n as f32), "jitter-transposed");
    assert_eq!(share(|c, r, n, jitter| (cell(c, r) + jitter[r * n + c]).yx() / n as f32), "edges-mixed");
    assert_eq!(share(|c, r, n, jitter| (cell(c, r) + jitter[r * n + c].yx()) / n as f32), "jitter-mixed");
}

#[test]
fn wrong_strengths() {
    let strength = |strength| Recipe { strength, ..RIGHT }.diagnosis();
    assert_eq!(strength(|p| p.cosine * -p.direction.dot(p.area)), "no-inverse-square");
    assert_eq!(strength(|p| p.cosine * -p.direction.dot(p.area) / p.distance), "inverse-not-squared");
    assert_eq!(strength(|p| -p.direction.dot(p.area) / p.square()), "surface-cosine-forgotten");
    assert_eq!(strength(|p| p.cosine * p.area.length() / p.square()), "panel-cosine-forgotten");
    let unit: fn(Place) -> f32 = |p| p.cosine * -p.direction.dot(p.area.normalize()) / p.square();
    assert_eq!(strength(unit), "area-forgotten");
    assert_eq!(strength(|p| p.cosine * -p.direction.dot(p.area) * p.area.length() / p.square()), "area-twice");
    assert_eq!(strength(|_| 1.0), "only-radiance");
    let by_pi: fn(Place) -> f32 = |p| p.cosine * -p.direction.dot(p.area) / p.square() / std::f32::consts::PI;
    assert_eq!(strength(by_pi), "divided-by-pi");
}

#[test]
fn wrong_sides() {
    let counts = |counts| Recipe { counts, ..RIGHT };
    assert_eq!(counts(|p| p.cosine > 0.0).diagnosis(), "shines-backwards");
    assert_eq!(counts(|p| p.cosine * -p.direction.dot(p.area) > 0.0).diagnosis(), "both-behind");
    let both = Recipe { strength: |p| (p.cosine * p.direction.dot(p.area) / p.square()).abs(), ..RIGHT };
    assert_eq!(Recipe { counts: |p| p.cosine > 0.0, ..both }.diagnosis(), "shines-backwards");
    assert_eq!(counts(|p| -p.direction.dot(p.area) > 0.0).diagnosis(), "below-horizon");
    let clamped = Recipe { strength: |p| p.cosine.max(0.0) * -p.direction.dot(p.area) / p.square(), ..RIGHT };
    assert_eq!(Recipe { counts: |p| -p.direction.dot(p.area) > 0.0, ..clamped }.diagnosis(), "below-horizon");
    // A panel without area has no normal.
    let normalized: fn(Place) -> f32 =
        |p| p.cosine * -p.direction.dot(p.area.normalize()) * p.area.length() / p.square();
    let counts_nan: fn(Place) -> bool = |p| {
        let front = p.area.normalize();
        p.cosine > 0.0 && (front.is_nan() || -p.direction.dot(front) > 0.0)
    };
    assert_eq!(Recipe { strength: normalized, counts: counts_nan, ..RIGHT }.diagnosis(), "not-a-number");
    assert_eq!(counts(|p| p.cosine > 0.0 && -p.direction.dot(p.area) >= 0.0).diagnosis(), "no-area");
    assert_eq!(Recipe { normal: |hit| hit.geometric_normal, ..RIGHT }.diagnosis(), "geometric-normal");
}

#[test]
fn wrong_shadows() {
    let ray = |ray| Recipe { ray, ..RIGHT }.diagnosis();
    fn start(hit: &Hit) -> Vec3 {
        Offset::Following.origin(hit, hit.geometric_normal)
    }
    assert_eq!(ray(|hit, p| (Ray::new(start(hit), p.direction), Interval::POSITIVE)), "beyond-the-light");
    assert_eq!(
        ray(|hit, p| (Ray::new(start(hit), p.direction * p.distance), Interval::POSITIVE.up_to(p.distance))),
        "reach-squared"
    );
    assert_eq!(ray(|hit, p| (Ray::new(start(hit), p.direction), Interval::new(0.0, 1.0))), "range-too-short");
    assert_eq!(ray(|hit, p| (Ray::new(start(hit), p.direction), Interval::new(1.0, 0.0))), "no-shadow");
    assert_eq!(
        ray(|hit, p| (Ray::new(hit.position, p.direction), Interval::POSITIVE.up_to(p.distance))),
        "self-shadow"
    );
    assert_eq!(
        ray(|hit, p| (Ray::new(start(hit), p.direction), Interval::POSITIVE.up_to(p.square()))),
        "reach-squared"
    );
    fn lifted(hit: &Hit, p: Place, offset: Offset) -> (Ray, Interval) {
        (Ray::new(offset.origin(hit, hit.geometric_normal), p.direction), Interval::POSITIVE.up_to(p.distance))
    }
    for fixed in [
        |hit: &Hit, p: Place| lifted(hit, p, Offset::Fixed(1e-4)),
        |hit: &Hit, p: Place| lifted(hit, p, Offset::Fixed(1e-3)),
        |hit: &Hit, p: Place| lifted(hit, p, Offset::Fixed(0.05)),
    ] {
        assert_eq!(ray(fixed), "fixed-offset");
    }
    assert_eq!(Recipe { ray: |hit, p| lifted(hit, p, Offset::Bits), ..RIGHT }.check(), Ok(()));
}

/// The right answer to a question in which something is exchanged.
fn instead(change: fn(&mut [Vec3; 3], &mut Hit)) -> &'static str {
    name(check(move |mut panel, radiance, scene, hit, n, jitter| {
        let mut hit = *hit;
        change(&mut panel, &mut hit);
        RIGHT.light(panel, radiance, scene, &hit, n, jitter)
    }))
}

#[test]
fn wrong_geometry() {
    assert_eq!(instead(|panel, _| panel[0] = Vec3::ZERO), "corner-forgotten");
    assert_eq!(instead(|_, hit| hit.position = Vec3::ZERO), "point-forgotten");
    let lifted: fn(&mut [Vec3; 3], &mut Hit) =
        |_, hit| hit.position = Offset::Following.origin(hit, hit.geometric_normal);
    assert_eq!(instead(lifted), "lifted-start");
}

#[test]
fn turned_signs_are_no_stub() {
    // edges[1] × edges[0], or ω for −ω.
    assert_eq!(
        Recipe { counts: |p| p.cosine > 0.0 && p.direction.dot(p.area) > 0.0, ..RIGHT }.diagnosis(),
        "sign-of-the-front"
    );
    assert_eq!(
        Recipe { counts: |p| p.cosine < 0.0 && -p.direction.dot(p.area) > 0.0, ..RIGHT }.diagnosis(),
        "sign-of-the-horizon"
    );
    // hit − place.
    let turned = Recipe {
        counts: |p| p.cosine < 0.0 && p.direction.dot(p.area) > 0.0,
        ray: |hit, p| {
            let origin = Offset::Following.origin(hit, hit.geometric_normal);
            (Ray::new(origin, -p.direction), Interval::POSITIVE.up_to(p.distance))
        },
        ..RIGHT
    };
    assert_eq!(turned.diagnosis(), "sign-of-the-way");
    let message = turned.check().unwrap_err().to_string();
    assert!(message.starts_with("Tried:"), "{message}");
    // A `!` too few.
    let in_shadow = |panel: [Vec3; 3], radiance: Rgb, scene: &Scene<()>, hit: &Hit, n: u16, jitter: &[Vec2]| {
        let all = RIGHT.light(panel, radiance, &Scene::<()>::new(), hit, n, jitter);
        let seen = RIGHT.light(panel, radiance, scene, hit, n, jitter);
        (all.0 - seen.0, all.1 - seen.1)
    };
    assert_eq!(name(check(in_shadow)), "shadow-turned");
}

#[test]
fn one_shadow_ray_for_all() {
    let one = |panel: [Vec3; 3], radiance: Rgb, scene: &Scene<()>, hit: &Hit, n: u16, jitter: &[Vec2]| {
        let to_middle = panel[0] + (panel[1] + panel[2]) / 2.0 - hit.position;
        let origin = Offset::Following.origin(hit, hit.geometric_normal);
        if scene.occluded(&Ray::new(origin, to_middle), Interval::new(0.0, 1.0)) {
            return (0.0, Rgb::ZERO);
        }
        RIGHT.light(panel, radiance, &Scene::<()>::new(), hit, n, jitter)
    };
    assert_eq!(name(check(one)), "one-shadow-ray");
}
