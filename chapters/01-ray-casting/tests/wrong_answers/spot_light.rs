//! Wrong spot lights, all of one recipe with one ingredient changed.

use common::{Rgb, Vec3, exercise::Verdict, float};
use ray_casting::light::{Illumination, Light, PointLight};

use crate::{checks::spot_light::check, name};

/// How a spot light shines. The default is right.
#[derive(Clone, Copy)]
struct Recipe {
    /// Axis as it is used.
    axis: fn(Vec3) -> Vec3,
    /// Angles from degrees to what the cosine is taken of.
    angle: fn(f32) -> f32,
    /// The share by the cosine, that of the inner and that of the outer angle.
    share: fn(f32, f32, f32) -> f32,
    /// What becomes of the light that would arrive without the cone.
    change: fn(Illumination, f32) -> Illumination,
}

/// From 0 at the outer to 1 at the inner angle.
fn ramp(cosine: f32, inner: f32, outer: f32) -> f32 {
    if cosine >= inner { 1.0 } else { ((cosine - outer) / (inner - outer)).max(0.0) }
}

fn smooth(x: f32) -> f32 {
    x * x * (3.0 - 2.0 * x)
}

const RIGHT: Recipe = Recipe {
    axis: |axis| axis.normalize(),
    angle: |degrees| degrees.to_radians(),
    share: |cosine, inner, outer| smooth(ramp(cosine, inner, outer)),
    change: |light, _| light,
};

/// A light made of a recipe.
struct Spot {
    recipe: Recipe,
    lamp: PointLight,
    axis: Vec3,
    angles: [f32; 2],
}

impl Light for Spot {
    fn illuminate(&self, point: Vec3) -> Illumination {
        let light = self.lamp.illuminate(point);
        let cosine = -light.direction.dot((self.recipe.axis)(self.axis));
        let [inner, outer] = self.angles.map(|angle| float::cos((self.recipe.angle)(angle)));
        let share = (self.recipe.share)(cosine, inner, outer);
        (self.recipe.change)(Illumination { strength: light.strength * share, ..light }, cosine)
    }
}

impl Recipe {
    fn check(self) -> Verdict {
        check(|position, axis, intensity, inner, outer| Spot {
            recipe: self,
            lamp: PointLight { position, intensity },
            axis,
            angles: [inner, outer],
        })
    }

    fn diagnosis(self) -> &'static str {
        name(self.check())
    }
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(RIGHT.check(), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(Recipe { share: |_, _, _| 0.0, ..RIGHT }.diagnosis(), "not-started");
}

#[test]
fn wrong_distances() {
    let scaled = |change| Recipe { change, ..RIGHT }.diagnosis();
    assert_eq!(
        scaled(|l, _| Illumination { strength: l.strength * l.distance * l.distance, ..l }),
        "no-inverse-square"
    );
    assert_eq!(scaled(|l, _| Illumination { strength: l.strength * l.distance, ..l }), "inverse-not-squared");
    assert_eq!(scaled(|l, _| Illumination { distance: l.distance * l.distance, ..l }), "wrong-distance");
}

#[test]
fn wrong_directions() {
    assert_eq!(
        Recipe { change: |l, _| Illumination { direction: -l.direction, ..l }, ..RIGHT }.diagnosis(),
        "direction-reversed"
    );
    assert_eq!(Recipe { axis: |axis| -axis.normalize(), ..RIGHT }.diagnosis(), "shines-backwards");
    let both_ways: fn(f32, f32, f32) -> f32 = |cosine, inner, outer| smooth(ramp(cosine.abs(), inner, outer));
    assert_eq!(Recipe { share: both_ways, ..RIGHT }.diagnosis(), "shines-backwards");
    assert_eq!(Recipe { axis: |axis| axis, ..RIGHT }.diagnosis(), "axis-length");
}

#[test]
fn wrong_cones() {
    assert_eq!(Recipe { share: |_, _, _| 1.0, ..RIGHT }.diagnosis(), "no-cone-yet");
    // The comparisons the wrong way round.
    let reversed = Recipe { share: |c, i, o| if c < i { 1.0 } else { f32::from(c <= o) }, ..RIGHT };
    assert_eq!(reversed.diagnosis(), "shines-backwards");
    let message = reversed.check().unwrap_err().message;
    assert!(message.contains("Perhaps") && message.contains("comparison"), "{message}");
    assert_eq!(Recipe { share: |cosine, _, _| f32::from(cosine > 0.0), ..RIGHT }.diagnosis(), "no-cone");
    assert_eq!(Recipe { angle: |degrees| degrees.to_radians() / 2.0, ..RIGHT }.diagnosis(), "full-angle");
    // cos 30 and cos 60, as if these were radians, are 0.15 and −0.95.
    assert_eq!(Recipe { angle: |degrees| degrees, ..RIGHT }.diagnosis(), "degrees-not-radians");
    let unlimited = |share| Recipe { share, ..RIGHT }.diagnosis();
    assert_eq!(unlimited(|c, i, o| smooth((c - o) / (i - o))), "x-not-limited");
    assert_eq!(unlimited(|c, i, o| (c - o) / (i - o)), "x-not-limited");
    assert_eq!(unlimited(|c, i, o| smooth(((c - o) / (i - o)).max(0.0))), "x-not-limited");
    assert_eq!(unlimited(|c, i, o| smooth(((c - o) / (i - o)).min(1.0))), "x-not-limited");
}

#[test]
fn nothing_about_the_dark() {
    let changed = |change| Recipe { change, ..RIGHT }.diagnosis();
    const NONE: Illumination = Illumination { direction: Vec3::Y, distance: f32::INFINITY, strength: Rgb::ZERO };
    assert_eq!(changed(|l, _| if l.strength == Rgb::ZERO { NONE } else { l }), "direction-in-the-dark");
    let no_distance: fn(Illumination, f32) -> Illumination =
        |l, _| if l.strength == Rgb::ZERO { Illumination { distance: f32::INFINITY, ..l } } else { l };
    assert_eq!(changed(no_distance), "direction-in-the-dark");
}

#[test]
fn wrong_falloffs() {
    let falloff = |share| Recipe { share, ..RIGHT }.diagnosis();
    assert_eq!(falloff(ramp), "not-smooth");
    assert_eq!(falloff(|c, i, o| f32::from(c >= (i + o) / 2.0)), "hard-edge");
    assert_eq!(
        falloff(|c, i, o| if c >= i || c <= o { smooth(ramp(c, i, o)) } else { 1.0 - smooth(ramp(c, i, o)) }),
        "falloff-reversed"
    );
    assert_eq!(falloff(|c, i, o| c * smooth(ramp(c, i, o))), "cosine-too-much");
    assert_eq!(
        falloff(|c, i, o| {
            let [c, i, o] = [c, i, o].map(|x| float::acos(x.clamp(-1.0, 1.0)));
            if c <= i { 1.0 } else { smooth(((o - c) / (o - i)).max(0.0)) }
        }),
        "angle-not-cosine"
    );
}

#[test]
fn equal_angles() {
    // Between 0/0, which no clamp mends, and a number divided by zero.
    let share: fn(f32, f32, f32) -> f32 =
        |c, i, o| smooth(((c - o) / (i - o + f32::MIN_POSITIVE)).clamp(0.0, 1.0)) * ((i - o) / (i - o));
    assert_eq!(Recipe { share, ..RIGHT }.diagnosis(), "sharp-edge");
    // A NaN on the edge itself: `clamp` keeps it, `max` makes zero of it.
    let on_edge = |share| Recipe { share, ..RIGHT }.diagnosis();
    assert_eq!(on_edge(|c, i, o| smooth(((c - o) / (i - o)).clamp(0.0, 1.0))), "on-sharp-edge");
    assert_eq!(
        on_edge(|c, i, o| {
            let x = (c - o) / (i - o);
            smooth(if x.is_nan() { 0.0 } else { x.clamp(0.0, 1.0) })
        }),
        "on-sharp-edge"
    );
    // A NaN at 45° only.
    let only_on_axis: fn(f32, f32, f32) -> f32 =
        |c, i, o| if c >= 1.0 { 1.0 } else { smooth(((c - o) / (i - o)).clamp(0.0, 1.0)) };
    assert_eq!(on_edge(only_on_axis), "on-sharp-edge");
}

#[test]
fn intensity_of_one_channel() {
    let gray = |l: Illumination, _| Illumination { strength: Rgb::splat(l.strength.x), ..l };
    assert_eq!(Recipe { change: gray, ..RIGHT }.diagnosis(), "one-channel");
}
