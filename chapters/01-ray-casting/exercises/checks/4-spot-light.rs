//! Checks exercise 1.4, a spot light.

use common::{
    Rgb, Vec3,
    exercise::{Diagnosis, Finding, Verdict},
};
use ray_casting::light::{Illumination, Light};

use super::{dice::Dice, words};

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
        let [inner, outer] = self.angles.map(cosine);
        smooth(((self.cosine(point) - outer) / (inner - outer)).clamp(0.0, 1.0))
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
    /// How much of the light without cone arrives at `point`, by the answer.
    fn share(&self, point: Vec3) -> f64 {
        let unshaded = self.ideal.intensity.as_dvec3() / self.ideal.distance_squared(point);
        self.light.illuminate(point).strength.as_dvec3().dot(unshaded) / unshaded.length_squared()
    }

    /// The mistake of that name, if what arrives at `point` is not right.
    fn probe(&self, point: Vec3, name: &'static str, advice: &str) -> Verdict {
        let Ideal { position, intensity, .. } = self.ideal;
        let got = self.light.illuminate(point);
        let distance = self.ideal.distance_squared(point).sqrt();
        let direction = (position.as_dvec3() - point.as_dvec3()) / distance;
        let strength = intensity.as_dvec3() * self.ideal.falloff(point) / (distance * distance);
        let (name, advice) = if !got.strength.is_finite() || !got.direction.is_finite() {
            ("not-a-number", "Something was divided by zero: what if both angles are the same?")
        } else if got.direction.as_dvec3().distance(-direction) < 1e-4 {
            (
                "direction-reversed",
                "`direction` goes from the point toward the light, and not the way the light travels.",
            )
        } else if got.direction.as_dvec3().distance(direction) > 1e-4 {
            (
                "wrong-direction",
                "`direction` is the unit vector from the point toward the light, as for a `PointLight`.",
            )
        } else if (f64::from(got.distance) - distance).abs() > 1e-4 * distance {
            ("wrong-distance", "`distance` is the way from the point to the light.")
        } else if got.strength.as_dvec3().distance(strength)
            > 2e-4 * (intensity.as_dvec3() / (distance * distance)).length()
        {
            (name, advice)
        } else {
            return Ok(());
        };
        let Illumination { direction: d, distance: l, strength: s } = got;
        Err(Finding {
            tried: format!(
                "{}, at the point {}, {} units away, {}° off the axis",
                self.ideal.words(),
                words::triple(point),
                words::number(distance),
                words::number(angle(self.ideal.cosine(point)))
            ),
            got: format!("direction {}, distance {l}, strength {}", words::triple(d), words::triple(s)),
            expected: format!(
                "direction {}, distance {}, strength {}",
                words::rounded(direction),
                words::number(distance),
                words::rounded(strength)
            ),
            advice: advice.into(),
        }
        .named(name))
    }
}

/// Accept a spot light, or name what is wrong with it. `make` takes position, axis, intensity, inner and outer angle.
pub(crate) fn check<L: Light>(make: impl Fn(Vec3, Vec3, Rgb, f32, f32) -> L) -> Verdict {
    let trial = |position, axis, intensity, angles: [f32; 2]| Trial {
        light: make(position, axis, intensity, angles[0], angles[1]),
        ideal: Ideal { position, axis, intensity, angles },
    };
    let lamp = trial(Vec3::new(0.0, 2.0, 0.0), -Vec3::Y, Rgb::new(4.0, 8.0, 16.0), [30.0, 60.0]);
    let is_dark = |y: f32| lamp.light.illuminate(Vec3::Y * y).strength == Rgb::ZERO;
    if is_dark(0.0) && is_dark(4.0) {
        return Err(Diagnosis::not_started("Your light is dark: `illuminate` returns no strength anywhere."));
    }
    distance(&lamp)?;
    cone(&lamp)?;
    edge(&lamp)?;
    let long = trial(lamp.ideal.position, lamp.ideal.axis * 5.0, lamp.ideal.intensity, lamp.ideal.angles);
    long.probe(at(45.0), "axis-length", "This axis is five times as long. Make it a unit vector before you use it.")?;
    sharp(&trial(lamp.ideal.position, lamp.ideal.axis, lamp.ideal.intensity, [30.0, 30.0]))?;

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
    } else if on_axis == 0.0 {
        (
            "shines-backwards",
            "This point lies on the axis, and it is dark. The angle lies between the axis and the way from \
                              the light to the point: `-direction`, not `direction`.",
        )
    } else {
        ("wrong-strength", "On the axis the whole light arrives: intensity divided by the square of the distance.")
    };
    lamp.probe(Vec3::ZERO, name, advice)
}

/// Inside the inner and outside the outer angle.
fn cone<L: Light>(lamp: &Trial<L>) -> Verdict {
    let point = Vec3::Y * 4.0;
    lamp.probe(
        point,
        "shines-backwards",
        "This point lies behind the lamp. Its cosine is negative: the cosine must not lose its sign.",
    )?;
    lamp.probe(at(85.0), "no-cone", "This point lies outside the outer angle, where no light arrives.")?;
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

/// With both angles the same.
fn sharp<L: Light>(lamp: &Trial<L>) -> Verdict {
    for (degrees, expected) in [(20.0, 1.0), (29.0, 1.0), (31.0, 0.0), (50.0, 0.0)] {
        let point = at(degrees);
        let share = lamp.share(point);
        // Written so that a share that is no number is wrong.
        let is_right = (share - expected).abs() < 1e-3;
        if !is_right {
            return Err(Finding {
                tried: format!("{}, at a point {degrees}° off the axis", lamp.ideal.words()),
                got: format!("strength {}", words::triple(lamp.light.illuminate(point).strength)),
                expected: format!("{expected} times the light of a `PointLight`"),
                advice:
                    "Both angles are the same: the cone has a sharp edge. Then 0/0 or a number divided by 0 comes up: \
                         clamp the share between 0 and 1, and look at what becomes of a NaN."
                        .into(),
            }
            .named("sharp-edge"));
        }
    }
    Ok(())
}
