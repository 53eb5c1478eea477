//! Names for what may be wrong with glass, for exercise 6.1.

use common::Vec3;
use ray_casting::hit::Side;

use super::{
    glass::{Way, is_share},
    glass_case::Case,
    words::is_near,
};

/// Name and advice.
pub(super) type Mistake = (&'static str, &'static str);

/// Why a path goes neither of the two ways.
pub(super) fn direction_mistake(case: &Case, direction: Vec3) -> Mistake {
    let is = |other: Vec3| (direction - other).length() < 1e-3;
    if case.refracted().is_none() {
        return (
            "total-reflection-lost",
            "Here `refract` gives `None`: no light goes through, all of it is reflected. So the path goes on in the mirror direction, \
             with weight 1. If it ended here, the edges of your glass would be black.",
        );
    }
    if !direction.is_finite() {
        return ("not-a-number", "This is no number. Was it divided by zero?");
    }
    if !is_near(direction.length().into(), 1.0, 1e-3) {
        return ("not-a-unit-vector", "`reflect` and `refract` keep the length of a unit vector. Do not stretch it.");
    }
    if is(case.ray.direction) {
        return ("not-bent", "The ray goes straight on. Glass bends it: `refract`.");
    }
    if case.refracted_by(case.ratio().recip()).is_some_and(is) {
        return match case.hit.side {
            Side::Outside => (
                "ratio-upside-down",
                "The ratio is upside down. It is the index behind the surface divided by the index before it: from outside that is \
                 `index`.",
            ),
            Side::Inside => (
                "side-ignored",
                "From inside the ray leaves the glass. What is behind the surface is outside then: the ratio is 1 / index.",
            ),
        };
    }
    if is(-case.reflected()) {
        return (
            "reflected-into-the-surface",
            "This is the mirror direction turned around: `reflect` wants the direction in which the ray travels, `ray.direction`.",
        );
    }
    if is(-case.ray.direction) {
        return ("turned-back", "The path goes back where it came from. Neither of the two rays does that.");
    }
    (
        "wrong-direction",
        "Take `reflect(ray.direction, normal)` or `refract(ray.direction, normal, ratio)`, nothing between them.",
    )
}

/// Why a share is wrong.
pub(super) fn share_mistake(case: &Case, share: f64) -> Mistake {
    let is = |probability: f64| is_share(share, probability);
    let (right, ratio, cosine) = (case.reflectance(), case.ratio(), case.cosine());
    if is(1.0 - right) {
        return ("chances-swapped", "Reflection has probability F, refraction 1 − F. Here it is the other way round.");
    }
    if share == 0.0 {
        return ("never-reflected", "The path always goes through. It must be reflected with probability F.");
    }
    if share == 1.0 {
        return (
            "never-refracted",
            "The path never goes through. Look at the cosine: `exact` gives 1 where it is not above 0. It is that of the angle between \
             the normal and −ray.direction.",
        );
    }
    if is(0.5) {
        return (
            "half-and-half",
            "Both ways are equally likely. With other weights that would be right on average, but most of these paths would bring \
             little: choose the reflection with probability F.",
        );
    }
    // From outside the approximation was told from it before.
    if is(case.reflectance_by(ratio.recip())) {
        return (
            "fresnel-of-the-other-side",
            "This is F for a ray that comes from the other side. `exact` wants the same ratio as `refract`.",
        );
    }
    let behind = (1.0 - (1.0 - cosine * cosine) / (ratio * ratio)).max(0.0).sqrt();
    if is(case.approximate(cosine)) || is(case.approximate(behind)) {
        return ("approximation", "This is Schlick's approximation. The task wants Fresnel's equations: `exact`.");
    }
    ("wrong-share", "Draw one number with `random.uniform()`: where it is below F, the path is reflected.")
}

/// Why a weight is wrong.
pub(super) fn weight_mistake(case: &Case, way: Way, weight: f64) -> Mistake {
    let is = |other: f64| is_near(weight, other, 2e-3 * other.abs().max(1.0));
    let (reflectance, ratio) = (case.reflectance(), case.ratio());
    let share = if way == Way::Reflected { reflectance } else { 1.0 - reflectance };
    if weight == 0.0 {
        return ("weight-of-zero", "The weight 0 ends the path. Glass lets every path go on.");
    }
    if is(share) {
        return (
            "counted-twice",
            "This is F for the reflected ray, 1 − F for the other. But they are chosen that often already. Divide by the probability \
             of the choice, and 1 is left.",
        );
    }
    if is(share.recip()) {
        return (
            "share-forgotten",
            "This is 1 / probability. The light counts its share, F or 1 − F, divided by the probability of the choice, which is the same.",
        );
    }
    if is(ratio * ratio) || is((ratio * ratio).recip()) {
        return (
            "index-squared",
            "This is the ratio of the indices squared. Camera and lights are outside, so it cancels when the path leaves: leave it out.",
        );
    }
    if is(case.cosine()) {
        return (
            "cosine",
            "A cosine belongs to light from all directions. Here the light comes from one: F and 1 − F are all there is.",
        );
    }
    (
        "wrong-weight",
        "Share divided by probability: F / F for the reflected ray, (1 − F) / (1 − F) for the refracted one.",
    )
}
