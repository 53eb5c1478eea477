//! Checks exercise 6.3, depth of field.

use common::{
    Vec2, Vec3,
    exercise::{
        Diagnosis, Finding, Verdict, trying,
        words::{number, rounded, triple},
    },
};
use glam::DVec3;
use ray_casting::ray::Ray;

use super::{lens::Lens, lens_rays};

/// What the student writes.
#[derive(Clone, Copy)]
pub(crate) struct Answer {
    /// The point in focus, by the pinhole's ray, the view, and the distance of the plane of focus.
    pub(crate) in_focus: fn(Ray, Vec3, f32) -> Vec3,
    /// The ray from the lens, by the pinhole's ray, the axes, the aperture, the focus, and a point of the unit square.
    pub(crate) lens_ray: fn(Ray, [Vec3; 3], f32, f32, Vec2) -> Ray,
    /// The diameter of the circle of confusion, by aperture, focus, and depth.
    pub(crate) circle_of_confusion: fn(f32, f32, f32) -> f32,
}

/// Places in the window that are tried: how far to the right and upward, for a window at distance 1.
pub(super) const PLACES: [[f32; 2]; 5] = [[0.5, 0.0], [0.0, 0.0], [-0.25, 0.5], [0.0, -0.75], [1.0, 0.5]];

/// Cameras that are tried.
pub(super) fn lenses() -> [Lens; 4] {
    [
        Lens::looking([0.0, 0.0, 5.0], [0.0, 0.0, 0.0], 1.0, 4.0),
        Lens::looking([3.0, 2.0, -1.0], [0.0, 0.5, 2.0], 0.25, 2.5),
        Lens::looking([-2.0, 4.0, 0.5], [1.0, 1.0, -3.0], 2.0, 30.0),
        Lens::looking([0.5, -1.0, 0.25], [4.0, 2.0, 0.5], 0.01, 0.5),
    ]
}

/// Accept a lens, or name what is wrong with it.
pub(crate) fn check(answer: Answer) -> Verdict {
    let is_origin = |lens: &Lens| {
        let pinhole = lens.pinhole(PLACES[0]);
        point(&answer, lens, pinhole) == pinhole.origin
    };
    if lenses().iter().all(is_origin) {
        return Err(Diagnosis::not_started("Nothing is in focus yet: `in_focus` returns the origin of the ray."));
    }
    points(&answer)?;
    lens_rays::check(&answer)?;
    circles(answer.circle_of_confusion)
}

/// The student's point in focus.
fn point(answer: &Answer, lens: &Lens, pinhole: Ray) -> Vec3 {
    trying(|| tried(lens, pinhole), || (answer.in_focus)(pinhole, lens.axes[2], lens.focus))
}

fn tried(lens: &Lens, pinhole: Ray) -> String {
    let [origin, direction, forward] = [pinhole.origin, pinhole.direction, lens.axes[2]].map(triple);
    format!(
        "`in_focus` of the ray from {origin} in direction {direction}, with forward {forward} and focus {}",
        lens.focus
    )
}

/// A mistake with the point in focus: its name, what it makes, and what to say.
type WrongPoint = (&'static str, fn(&Lens, Ray) -> DVec3, &'static str);

/// Points in focus.
fn points(answer: &Answer) -> Verdict {
    const RIVALS: [WrongPoint; 5] = [
        (
            "focus-on-sphere",
            |lens, pinhole| pinhole.origin.as_dvec3() + pinhole.direction.as_dvec3() * f64::from(lens.focus),
            "This point has the distance `focus` from the eye. All such points lie on a sphere. The plane of focus is flat: \
             at its rim the rays are longer than in its middle.",
        ),
        (
            "cosine-multiplied",
            |lens, pinhole| {
                let cosine = f64::from(pinhole.direction.dot(lens.axes[2]));
                pinhole.origin.as_dvec3() + pinhole.direction.as_dvec3() * f64::from(lens.focus) * cosine
            },
            "A slanting ray needs to be longer than `focus` to reach the plane, and yours is shorter. Divide by the cosine.",
        ),
        (
            "one-point-for-all",
            |lens, _| lens.eye.as_dvec3() + lens.axes[2].as_dvec3() * f64::from(lens.focus),
            "This is the middle of the plane, for every ray. Each pixel has a point of its own: where its pinhole's ray meets \
             the plane.",
        ),
        (
            "eye-forgotten",
            |lens, pinhole| lens.in_focus(pinhole) - lens.eye.as_dvec3(),
            "This point is right as seen from the eye, but the eye is not in the origin. `pinhole.at(t)` adds it.",
        ),
        (
            "behind-the-camera",
            |lens, pinhole| 2.0 * lens.eye.as_dvec3() - lens.in_focus(pinhole),
            "This point lies behind the camera. `forward` points to where the camera looks, and `t` is positive there.",
        ),
    ];
    for lens in lenses() {
        let is = |rival: fn(&Lens, Ray) -> DVec3| {
            move |place: &[f32; 2]| {
                let pinhole = lens.pinhole(*place);
                point(answer, &lens, pinhole).as_dvec3().distance(rival(&lens, pinhole)) <= 4.0 * lens.slack()
            }
        };
        let Some(place) = PLACES.iter().find(|place| !is(Lens::in_focus)(place)) else { continue };
        let pinhole = lens.pinhole(*place);
        let (got, expected) = (point(answer, &lens, pinhole), lens.in_focus(pinhole));
        let general = "Look for the `t` at which the ray has come as far as `focus` in the direction `forward`.";
        let (name, advice) = if got.is_finite() {
            let rival = RIVALS.iter().find(|(_, rival, _)| PLACES.iter().all(is(*rival)));
            rival.map_or(("beside-the-plane", general), |(name, _, advice)| (*name, *advice))
        } else {
            ("not-a-number", "Something was divided by zero. Which cosine can be 0, and which cannot?")
        };
        let depth = |point: DVec3| number(lens.depth(point));
        return Err(Finding {
            tried: tried(&lens, pinhole),
            got: format!("{}, at depth {}", rounded(got.as_dvec3()), depth(got.as_dvec3())),
            expected: format!("{}, at depth {}", rounded(expected), depth(expected)),
            advice: advice.into(),
        }
        .named(name));
    }
    Ok(())
}

/// A mistake with the circle of confusion: its name, what it makes, and what to say.
type WrongCircle = (&'static str, fn(f64, f64, f64) -> f64, &'static str);

/// Circles of confusion.
fn circles(circle: fn(f32, f32, f32) -> f32) -> Verdict {
    const RIVALS: [WrongCircle; 5] = [
        (
            "radius",
            |a, f, z| a * (z - f).abs() / f / 2.0,
            "This is the radius. The diameter is asked for, as of the lens.",
        ),
        (
            "negative",
            |a, f, z| a * (z - f) / f,
            "Before the plane of focus your diameter is negative. Rays that have yet to meet are apart, too.",
        ),
        (
            "negative",
            |a, f, z| a * (f - z) / f,
            "Beyond the plane of focus your diameter is negative. Rays that have met already are apart, too.",
        ),
        (
            "divided-by-depth",
            |a, f, z| a * (z - f).abs() / z,
            "The one triangle has the lens as its base and reaches to where the rays meet. Its height is `focus`, not `depth`.",
        ),
        (
            "lens-forgotten",
            |_, f, z| (z - f).abs() / f,
            "This is how large the circle is compared to the lens. A lens twice as large makes a circle twice as large.",
        ),
    ];
    let questions =
        [[1.0, 4.0, 6.0], [1.0, 4.0, 1.0], [0.5, 2.0, 0.0], [0.25, 3.0, 300.0], [2.0, 8.0, 8.0], [0.0, 1.0, 5.0]];
    let of =
        |[a, f, z]: [f32; 3]| trying(|| format!("`circle_of_confusion({a}, {f}, {z})`"), || f64::from(circle(a, f, z)));
    if questions.iter().all(|question| of(*question) == 0.0) {
        let message = "Your rays are right. Now for `circle_of_confusion`, which returns 0 for every depth.";
        return Err(Diagnosis::new("circle-not-started", message));
    }
    let right = |a: f64, f: f64, z: f64| a * (z - f).abs() / f;
    let is = |question: &[f32; 3], rival: &dyn Fn(f64, f64, f64) -> f64| {
        let [a, f, z] = question.map(f64::from);
        let expected = rival(a, f, z);
        // Without a number there is nothing to compare.
        (of(*question) - expected).abs() <= 1e-5 * (1.0 + expected.abs()) || !expected.is_finite()
    };
    let Some(question) = questions.iter().find(|question| !is(question, &right)) else { return Ok(()) };
    let rival = RIVALS.iter().find(|(_, rival, _)| questions.iter().all(|question| is(question, rival)));
    let general =
        "At depth 0 it is the whole aperture, at `focus` it is 0, and at twice `focus` it is the aperture again.";
    let (name, advice) = rival.map_or(("wrong-circle", general), |(name, _, advice)| (*name, *advice));
    let [a, f, z] = *question;
    Err(Finding {
        tried: format!("`circle_of_confusion({a}, {f}, {z})`: aperture {a}, focus {f}, depth {z}"),
        got: number(of(*question)),
        expected: format!("{}, as wide as your own rays are apart there", number(right(a.into(), f.into(), z.into()))),
        advice: advice.into(),
    }
    .named(name))
}
