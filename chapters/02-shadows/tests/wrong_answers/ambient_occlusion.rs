//! Wrong ways to look around, all of one recipe with one ingredient changed.

use common::{Interval, Vec3, exercise::Verdict};
use ray_casting::{hit::Hit, ray::Ray, scene::Scene};
use shadows::offset::Offset;

use crate::{checks::ambient_occlusion::check, name};

/// How openness is found. The default is right.
#[derive(Clone, Copy)]
struct Recipe {
    /// The normal that counts.
    normal: fn(&Hit) -> Vec3,
    /// Where rays start.
    origin: fn(&Hit, Vec3) -> Vec3,
    /// The direction that is looked in; `None` to leave it out.
    turned: fn(Vec3, Vec3) -> Option<Vec3>,
    /// The weight, by the cosine.
    weight: fn(f32) -> f32,
    /// The range, by the reach.
    range: fn(f32) -> Interval,
    /// The answer, by the weights that get away, all weights, and the number of directions.
    value: fn(f32, f32, f32) -> f32,
}

const RIGHT: Recipe = Recipe {
    normal: |hit| hit.geometric_normal,
    origin: |hit, normal| Offset::Following.origin(hit, normal),
    turned: |direction, normal| Some(if direction.dot(normal) < 0.0 { -direction } else { direction }),
    weight: |cosine| cosine,
    range: |reach| Interval::POSITIVE.up_to(reach),
    value: |open, all, _| if all > 0.0 { open / all } else { 1.0 },
};

impl Recipe {
    fn openness(&self, scene: &Scene<()>, hit: &Hit, directions: &[Vec3], reach: f32) -> f32 {
        let normal = (self.normal)(hit);
        let (mut open, mut all) = (0.0, 0.0);
        for direction in directions.iter().filter_map(|d| (self.turned)(*d, normal)) {
            let weight = (self.weight)(direction.dot(normal));
            all += weight;
            let ray = Ray::new((self.origin)(hit, normal), direction);
            if !scene.occluded(&ray, (self.range)(reach)) {
                open += weight;
            }
        }
        (self.value)(open, all, directions.len() as f32)
    }

    fn check(self) -> Verdict {
        check(move |scene, hit, directions, reach| self.openness(scene, hit, directions, reach))
    }

    fn diagnosis(self) -> &'static str {
        name(self.check())
    }
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(RIGHT.check(), Ok(()));
    // Both other ways to turn a direction and to end a range.
    let turned: fn(Vec3, Vec3) -> Option<Vec3> = |d, n| Some(d * d.dot(n).signum());
    assert_eq!(Recipe { turned, range: |reach| Interval::new(0.0, reach), ..RIGHT }.check(), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(Recipe { value: |_, _, _| 1.0, ..RIGHT }.diagnosis(), "not-started");
}

#[test]
fn nothing_in_the_way_is_no_stub() {
    assert_eq!(Recipe { range: |reach| Interval::new(reach, 0.0), ..RIGHT }.diagnosis(), "all-open");
}

#[test]
fn wrong_means() {
    let value = |value| Recipe { value, ..RIGHT }.diagnosis();
    assert_eq!(value(|open, all, _| 1.0 - open / all), "occlusion-not-openness");
    assert_eq!(value(|open, _, count| open / count), "divided-by-count");
    assert_eq!(value(|open, _, count| 2.0 * open / count), "divided-by-count");
    assert_eq!(value(|open, all, _| 1.3 * open / all), "above-one");
    assert_eq!(value(|open, _, _| open), "sum-not-mean");
    assert_eq!(value(|open, all, _| open / all), "not-a-number");
    assert_eq!(value(|open, all, _| if all > 0.0 { open / all } else { 0.0 }), "nobody-knows");
    assert_eq!(value(|open, _, _| open / open), "only-the-open-ones");
    assert_eq!(Recipe { weight: |_| 1.0, ..RIGHT }.diagnosis(), "cosine-forgotten");
    assert_eq!(Recipe { weight: |c| c * c, ..RIGHT }.diagnosis(), "cosine-squared");
    assert_eq!(Recipe { weight: |_| 1.0, value: |open, _, _| open, ..RIGHT }.diagnosis(), "sum-not-mean");
}

#[test]
fn directions_into_the_surface() {
    assert_eq!(Recipe { turned: |d, n| (d.dot(n) > 0.0).then_some(d), ..RIGHT }.diagnosis(), "left-out");
    let as_given = Recipe { turned: |d, _| Some(d), ..RIGHT };
    assert_eq!(as_given.diagnosis(), "not-turned-round");
    assert_eq!(Recipe { weight: f32::abs, ..as_given }.diagnosis(), "not-turned-round");
    assert_eq!(Recipe { weight: |c| c.max(0.0), ..as_given }.diagnosis(), "left-out");
    // Mirrored at the surface.
    let mirrored: fn(Vec3, Vec3) -> Option<Vec3> = |d, n| Some(if d.dot(n) < 0.0 { d.reflect(n) } else { d });
    assert_eq!(Recipe { turned: mirrored, ..RIGHT }.diagnosis(), "mirrored");
    // Turned the wrong way.
    let inward = Recipe { turned: |d, n| Some(-d * d.dot(n).signum()), weight: f32::abs, ..RIGHT };
    assert_eq!(inward.diagnosis(), "all-blocked");
}

#[test]
fn wrong_ranges() {
    assert_eq!(Recipe { range: |_| Interval::POSITIVE, ..RIGHT }.diagnosis(), "reach-ignored");
    assert_eq!(Recipe { range: |reach| Interval::new(0.0, reach / 2.0), ..RIGHT }.diagnosis(), "wrong-reach");
    assert_eq!(Recipe { range: |reach| Interval::new(0.01, reach), ..RIGHT }.diagnosis(), "fixed-offset");
}

#[test]
fn wrong_normals() {
    assert_eq!(Recipe { normal: |_| Vec3::Y, ..RIGHT }.diagnosis(), "leaks");
    let upward = Recipe { turned: |d, _| Some(if d.y < 0.0 { -d } else { d }), weight: f32::abs, ..RIGHT };
    assert_eq!(upward.diagnosis(), "normal-ignored");
    assert_eq!(Recipe { normal: |hit| hit.shading_normal, ..RIGHT }.diagnosis(), "shading-normal");
}

#[test]
fn wrong_offsets() {
    let origin = |origin| Recipe { origin, ..RIGHT }.diagnosis();
    assert_eq!(origin(|hit, _| hit.position), "self-shadow");
    for fixed in [
        |hit: &Hit, n: Vec3| Offset::Fixed(1e-2).origin(hit, n),
        |hit: &Hit, n: Vec3| Offset::Fixed(1e-3).origin(hit, n),
        |hit: &Hit, n: Vec3| Offset::Fixed(1e-4).origin(hit, n),
    ] {
        assert_eq!(origin(fixed), "fixed-offset");
    }
    assert_eq!(origin(|hit, n| hit.position - n * 1e-3), "all-blocked");
    // One that follows, but is too small.
    let small: fn(&Hit, Vec3) -> Vec3 = |hit, n| hit.position + n * 1e-6 * hit.position.abs().max_element().max(1.0);
    let message = Recipe { origin: small, ..RIGHT }.check().unwrap_err();
    assert_eq!(message.name, "self-shadow", "{message}");
    // Any other that follows.
    assert_eq!(Recipe { origin: |hit, n| Offset::Bits.origin(hit, n), ..RIGHT }.check(), Ok(()));
    // Along each direction.
    let along = |scene: &Scene<()>, hit: &Hit, directions: &[Vec3], reach: f32| {
        let along = |d: &Vec3| {
            let d = if d.dot(hit.geometric_normal) < 0.0 { -*d } else { *d };
            let lifted = Hit { position: Offset::Following.origin(hit, d), ..*hit };
            let cosine = d.dot(hit.geometric_normal);
            let is_open = !scene.occluded(&Ray::new(lifted.position, d), Interval::POSITIVE.up_to(reach));
            (if is_open { cosine } else { 0.0 }, cosine)
        };
        let (open, all) = directions.iter().map(along).fold((0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1));
        if all > 0.0 { open / all } else { 1.0 }
    };
    assert_eq!(name(check(along)), "self-shadow");
}

#[test]
fn other_counts() {
    // The cosine of a direction before it is turned.
    let too_early = |scene: &Scene<()>, hit: &Hit, directions: &[Vec3], reach: f32| {
        let (mut open, mut all) = (0.0, 0.0);
        for d in directions {
            let cosine = d.dot(hit.geometric_normal);
            let one = RIGHT.openness(scene, hit, &[*d], reach);
            (open, all) = (open + one * cosine, all + cosine);
        }
        open / all
    };
    assert_eq!(name(check(too_early)), "cosine-too-early");
    let counted = |scene: &Scene<()>, hit: &Hit, directions: &[Vec3], reach: f32| {
        let all = Recipe { value: |_, all, _| all, ..RIGHT }.openness(scene, hit, directions, reach);
        let away = Recipe { weight: |_| 1.0, value: |open, _, _| open, ..RIGHT };
        if all > 0.0 { away.openness(scene, hit, directions, reach) / all } else { 1.0 }
    };
    assert_eq!(name(check(counted)), "count-by-cosines");
    // Only the first few.
    let few = |scene: &Scene<()>, hit: &Hit, directions: &[Vec3], reach: f32| {
        RIGHT.openness(scene, hit, &directions[..directions.len().min(16)], reach)
    };
    let message = check(few).unwrap_err().to_string();
    assert!(message.contains("[few-directions]") && message.contains("and so on to"), "{message}");
}
