//! Checks exercise 1.4, a spot light.

use common::{
    Rgb, Vec3,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice, trying},
};
use ray_casting::light::{Illumination, Light};

use super::words;

/// The light as it should be.
#[derive(Clone, Copy)]
struct Ideal {
    position: Vec3,
    axis: Vec3,
    intensity: Rgb,
    /// Inner and outer angle, in degrees.
    angles: [f32; 2],
}

impl Ideal {
    /// Cosine of the angle between the axis and the way from the light to `point`.
    fn cosine(&self, point: Vec3) -> f64 {
        let from_light = (point.as_dvec3() - self.position.as_dvec3()).normalize();
        from_light.dot(self.axis.as_dvec3().normalize())
    }

    /// The share of the light that the cone lets through.
    fn falloff(&self, point: Vec3) -> f64 {
        smooth(self.unlimited(point).clamp(0.0, 1.0))
    }

    /// `x` of the falloff as long as nothing limits it.
    fn unlimited(&self, point: Vec3) -> f64 {
        let [inner, outer] = self.angles.map(cosine);
        (self.cosine(point) - outer) / (inner - outer)
    }

    /// How much less light arrives because of the distance.
    fn distance_squared(&self, point: Vec3) -> f64 {
        self.position.as_dvec3().distance_squared(point.as_dvec3())
    }

    fn words(&self) -> String {
        let Self { position, axis, intensity, angles: [inner, outer] } = self;
        let [position, axis, intensity] = [position, axis, intensity].map(|v| words::triple(*v));
        format!("the light at {position}, axis {axis}, intensity {intensity}, angles {inner}° and {outer}°")
    }
}

#[allow(clippy::disallowed_methods, reason = "the platform's functions are the second opinion here")]
fn cosine(degrees: f32) -> f64 {
    f64::from(degrees).to_radians().cos()
}

#[allow(clippy::disallowed_methods, reason = "the platform's functions are the second opinion here")]
fn angle(cosine: f64) -> f64 {
    cosine.acos().to_degrees()
}

/// `3x² − 2x³`.
fn smooth(x: f64) -> f64 {
    x * x * (3.0 - 2.0 * x)
}

/// A light under test.
struct Trial<L> {
    light: L,
    ideal: Ideal,
}

impl<L: Light> Trial<L> {
    /// The light that `make` makes.
    fn new(make: impl Fn(Vec3, Vec3, Rgb, f32, f32) -> L, ideal: Ideal) -> Self {
        let Ideal { position, axis, intensity, angles: [inner, outer] } = ideal;
        Self { light: trying(|| ideal.words(), || make(position, axis, intensity, inner, outer)), ideal }
    }

    /// What arrives at `point`, by the answer.
    fn illuminate(&self, point: Vec3) -> Illumination {
        trying(|| self.tried(point), || self.light.illuminate(point))
    }

    fn tried(&self, point: Vec3) -> String {
        format!(
            "{}, at the point {}, {} units away, {}° off the axis",
            self.ideal.words(),
            words::triple(point),
            words::number(self.ideal.distance_squared(point).sqrt()),
            words::number(angle(self.ideal.cosine(point)))
        )
    }

    /// How much of the light without cone arrives at `point`, by the answer.
    fn share(&self, point: Vec3) -> f64 {
        let unshaded = self.ideal.intensity.as_dvec3() / self.ideal.distance_squared(point);
        self.illuminate(point).strength.as_dvec3().dot(unshaded) / unshaded.length_squared()
    }

    /// Whether no light at all should arrive at `point`.
    fn is_dark(&self, point: Vec3) -> bool {
        self.ideal.falloff(point) == 0.0
    }

    /// Whether the share at `point` is what `x` without limits gives, smoothed or not.
    fn is_unlimited(&self, point: Vec3) -> bool {
        let (share, x) = (self.share(point), self.ideal.unlimited(point));
        [x, smooth(x)].iter().any(|value| (share - value).abs() < 1e-3 * value.abs())
    }

    /// The mistake of that name, if what arrives at `point` is not right.
    fn probe(&self, point: Vec3, name: &'static str, advice: &str) -> Verdict {
        let Ideal { position, intensity, .. } = self.ideal;
        let got = self.illuminate(point);
        let distance = self.ideal.distance_squared(point).sqrt();
        let direction = (position.as_dvec3() - point.as_dvec3()) / distance;
        let strength = intensity.as_dvec3() * self.ideal.falloff(point) / (distance * distance);
        let is_direction_right = got.direction.as_dvec3().distance(direction) <= 1e-4;
        let is_distance_right = (f64::from(got.distance) - distance).abs() <= 1e-4 * distance;
        let is_gray = |color: Rgb| color.max_element() - color.min_element() <= 1e-4 * color.max_element();
        let (name, advice) = if got.strength == Rgb::ZERO
            && !(is_direction_right && is_distance_right)
            && self.is_dark(point)
        {
            (
                "direction-in-the-dark",
                "No light arrives here, and your strength is zero as it should be. But `direction` and `distance` must be right \
                 in the dark too.",
            )
        } else if !got.strength.is_finite() || !got.direction.is_finite() {
            ("not-a-number", "Something was divided by zero: what if both angles are the same?")
        } else if got.direction.as_dvec3().distance(-direction) < 1e-4 {
            (
                "direction-reversed",
                "`direction` goes from the point toward the light, and not the way the light travels.",
            )
        } else if !is_direction_right {
            (
                "wrong-direction",
                "`direction` is the unit vector from the point toward the light, as for a `PointLight`.",
            )
        } else if !is_distance_right {
            ("wrong-distance", "`distance` is the way from the point to the light.")
        } else if got.strength.as_dvec3().distance(strength)
            > 2e-4 * (intensity.as_dvec3() / (distance * distance)).length()
        {
            if is_gray(got.strength) && !is_gray(intensity) && got.strength != Rgb::ZERO && strength.length() > 0.0 {
                (
                    "one-channel",
                    "All three channels of your strength are the same, but those of the intensity differ. Compute with the \
                     whole `Rgb`, not with one of its channels.",
                )
            } else {
                (name, advice)
            }
        } else {
            return Ok(());
        };
        let Illumination { direction: d, distance: l, strength: s } = got;
        let told = |direction, distance, strength| {
            let [direction, strength] = [direction, strength].map(words::rounded);
            format!("direction {direction}, distance {}, strength {strength}", words::number(distance))
        };
        Err(Finding {
            tried: self.tried(point),
            got: told(d.as_dvec3(), f64::from(l), s.as_dvec3()),
            expected: told(direction, distance, strength),
            advice: advice.into(),
        }
        .named(name))
    }
}

/// Accept a spot light, or name what is wrong with it. `make` takes position, axis, intensity, inner and outer angle.
pub(crate) fn check<L: Light>(make: impl Fn(Vec3, Vec3, Rgb, f32, f32) -> L) -> Verdict {
    let trial = |position, axis, intensity, angles| Trial::new(&make, Ideal { position, axis, intensity, angles });
    let lamp = trial(Vec3::new(0.0, 2.0, 0.0), -Vec3::Y, Rgb::new(4.0, 8.0, 16.0), [30.0, 60.0]);
    let is_dark = |y: f32| lamp.illuminate(Vec3::Y * y).strength == Rgb::ZERO;
    if is_dark(0.0) && is_dark(4.0) {
        return Err(Diagnosis::not_started("Your light is dark: `illuminate` returns no strength anywhere."));
    }
    distance(&lamp)?;
    cone(&lamp)?;
    edge(&lamp)?;
    let long = trial(lamp.ideal.position, lamp.ideal.axis * 5.0, lamp.ideal.intensity, lamp.ideal.angles);
    long.probe(at(45.0), "axis-length", "This axis is five times as long. Make it a unit vector before you use it.")?;
    let sharp_at = |degrees| trial(Vec3::Y * 2.0, -Vec3::Y, Rgb::new(4.0, 8.0, 16.0), [degrees; 2]);
    for degrees in [20.0, 29.0, 31.0, 50.0] {
        sharp(&sharp_at(30.0), at(degrees), "sharp-edge")?;
    }
    // On the edge itself.
    sharp(&sharp_at(0.0), Vec3::ZERO, "on-sharp-edge")?;
    for around in [Vec3::X, -Vec3::X, Vec3::Z, -Vec3::Z] {
        sharp(&sharp_at(45.0), Vec3::Y + around, "on-sharp-edge")?;
    }

    // Many lights.
    let mut dice = Dice::new(14);
    for _ in 0..2000 {
        let angles = dice.choice([[0.0, 30.0], [10.0, 20.0], [20.0, 45.0], [45.0, 60.0], [60.0, 89.0]]);
        let intensity = dice.point(10.0).abs() + 0.1;
        let light = trial(dice.point(4.0), dice.direction(), intensity, angles);
        let point = light.ideal.position + light.ideal.axis + dice.direction();
        if point.distance(light.ideal.position) > 0.1 {
            light.probe(
                point,
                "wrong-strength",
                "Work this point out on paper: distance, cosine, x, and then the falloff.",
            )?;
        }
    }
    Ok(())
}

/// A point two units below the lamp of the first tests, at an angle in degrees off its axis.
#[allow(clippy::disallowed_methods, clippy::cast_possible_truncation, reason = "nearly the angle is near enough")]
fn at(degrees: f32) -> Vec3 {
    let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
    Vec3::new(2.0 * sin as f32, 2.0 - 2.0 * cos as f32, 0.0)
}

/// On the axis: strength by distance alone.
fn distance<L: Light>(lamp: &Trial<L>) -> Verdict {
    let on_axis = lamp.share(Vec3::ZERO);
    let (name, advice) = if (on_axis - 4.0).abs() < 1e-3 {
        ("no-inverse-square", "The strength must fall with the square of the distance, as for a `PointLight`.")
    } else if (on_axis - 2.0).abs() < 1e-3 {
        ("inverse-not-squared", "The strength must fall with the square of the distance, not with the distance.")
    } else if lamp.is_unlimited(Vec3::ZERO) {
        ("x-not-limited", "x is above 1 here: limit it to 0…1 before you smooth it. `clamp` does that.")
    } else if on_axis == 0.0 {
        (
            "shines-backwards",
            "This point lies on the axis, and it is dark. Perhaps the cosine has the wrong sign: the angle lies between the \
             axis and the way from the light to the point, which is `-direction`. Or perhaps a comparison is the wrong way \
             round: the cosine falls while the angle grows, so inside the cone it is greater than at the edge.",
        )
    } else {
        ("wrong-strength", "On the axis the whole light arrives: intensity divided by the square of the distance.")
    };
    lamp.probe(Vec3::ZERO, name, advice)
}

/// Inside the inner and outside the outer angle.
fn cone<L: Light>(lamp: &Trial<L>) -> Verdict {
    let behind = Vec3::Y * 4.0;
    let is = |point: Vec3, value: f64| (lamp.share(point) - value).abs() < 1e-3;
    let (name, advice) = if lamp.is_unlimited(behind) {
        ("x-not-limited", "x is below 0 here: limit it to 0…1 before you smooth it. `clamp` does that.")
    } else if [behind, at(85.0), at(65.0), at(20.0)].into_iter().all(|point| is(point, 1.0)) {
        (
            "no-cone-yet",
            "There is no cone yet: behind the lamp, beside it and in front of it all the light arrives, as from a \
             `PointLight`. Multiply the strength by the share. If you do that already: is a comparison the wrong way round, \
             or an angle in degrees compared with one in radians?",
        )
    } else {
        (
            "shines-backwards",
            "This point lies behind the lamp, where the cosine is negative. Does the cosine lose its sign, or is a comparison \
             the wrong way round? The cosine falls while the angle grows.",
        )
    };
    lamp.probe(behind, name, advice)?;
    // What comes out when degrees are taken for radians.
    let [inner, outer] = lamp.ideal.angles.map(|degrees| cosine(degrees.to_degrees()));
    let mistaken = ((lamp.ideal.cosine(at(85.0)) - outer) / (inner - outer)).clamp(0.0, 1.0);
    let (name, advice) = if is(at(85.0), mistaken) || is(at(85.0), smooth(mistaken)) {
        (
            "degrees-not-radians",
            "This is what comes out when degrees are taken for radians. The angles come in degrees, and `cos` takes radians: \
             `angle.to_radians()`.",
        )
    } else {
        (
            "no-cone",
            "This point lies outside the outer angle, where no light arrives. Is the angle turned from degrees into radians \
             before the cosine is taken?",
        )
    };
    lamp.probe(at(85.0), name, advice)?;
    // Angles of the whole cone would make it half as wide: at 20° the edge would have begun.
    let advice = "At 20° off the axis, the point lies within the inner angle of 30°. Both angles are measured from the \
                  axis; neither is the width of the whole cone.";
    if lamp.share(at(35.0)) < 1e-3 {
        lamp.probe(at(20.0), "full-angle", advice)?;
    }
    let (name, advice) = if (lamp.share(at(20.0)) - cosine(20.0)).abs() < 1e-3 {
        (
            "cosine-too-much",
            "The strength is multiplied by a cosine. What the surface's slope does belongs to the material; the light says \
             how strong it is at right angles to its direction.",
        )
    } else {
        (
            "dark-inside",
            "Within the inner angle the whole light arrives. Are the angles turned from degrees into radians before the \
             cosine is taken, and is the share between 0 and 1 clamped?",
        )
    };
    lamp.probe(at(20.0), name, advice)?;
    lamp.probe(at(65.0), "bright-outside", "Outside the outer angle no light arrives. Is the share clamped to 0?")
}

/// Between both angles.
fn edge<L: Light>(lamp: &Trial<L>) -> Verdict {
    let point = at(45.0);
    let [inner, outer] = lamp.ideal.angles.map(cosine);
    let x = (cosine(45.0) - outer) / (inner - outer);
    let by_angle = (60.0 - 45.0) / (60.0 - 30.0);
    let share = lamp.share(point);
    let is = |value: f64| (share - value).abs() < 2e-3;
    let (name, advice) = if is(1.0 - smooth(x)) || is(1.0 - x) {
        (
            "falloff-reversed",
            "The light must fade from the inner to the outer angle. Note that the inner angle has the greater \
                              cosine.",
        )
    } else if is(smooth(by_angle)) || is(by_angle) {
        (
            "angle-not-cosine",
            "Here the share grows evenly with the angle. It should grow with the cosine of the angle, \
                              which also saves the arc cosine.",
        )
    } else if is(x) {
        (
            "not-smooth",
            "The share grows evenly from 0 to 1, so the cone has visible edges where it begins and ends. \
                        Smooth it: x²(3 − 2x).",
        )
    } else if is(1.0) || is(0.0) {
        ("hard-edge", "Between the two angles the light must fade.")
    } else {
        (
            "wrong-falloff",
            "Between both angles: x = (cos θ − cos outer) / (cos inner − cos outer), and then x²(3 − 2x).",
        )
    };
    lamp.probe(point, name, advice)
}

/// With both angles the same: all the light or none. On the edge itself all of it, unless rounding has moved the point.
fn sharp<L: Light>(lamp: &Trial<L>, point: Vec3, name: &'static str) -> Verdict {
    let [edge, _] = lamp.ideal.angles.map(cosine);
    let beyond = edge - lamp.ideal.cosine(point);
    let is_on_edge = beyond.abs() < 1e-6;
    // On the axis nothing is rounded.
    let is_exact = lamp.ideal.angles == [0.0; 2];
    let may_be_lit = beyond < 0.0 || is_on_edge;
    let may_be_dark = if is_on_edge { !is_exact } else { beyond > 0.0 };
    let share = lamp.share(point);
    // A share that is no number is neither.
    let is = |value: f64| (share - value).abs() < 1e-3;
    if may_be_lit && is(1.0) || may_be_dark && is(0.0) {
        return Ok(());
    }
    let expected = if may_be_lit { "all the light of a `PointLight`" } else { "no light" };
    let advice = if is_on_edge {
        "Both angles are the same, so the cone has a sharp edge, and this point lies on the edge itself, where all the light \
         arrives. x is 0/0 here, which is a NaN, and `clamp` leaves a NaN as it is: ask first whether the cosine is at least \
         that of the inner angle."
    } else {
        "Both angles are the same: the cone has a sharp edge. Then 0/0 or a number divided by 0 comes up: limit the share to \
         0…1, and look at what becomes of a NaN."
    };
    Err(Finding {
        tried: lamp.tried(point),
        got: format!("strength {}", words::rounded(lamp.illuminate(point).strength.as_dvec3())),
        expected: expected.into(),
        advice: advice.into(),
    }
    .named(name))
}
