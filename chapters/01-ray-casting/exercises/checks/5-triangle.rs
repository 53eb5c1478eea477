//! Checks exercise 1.5, a triangle by Möller and Trumbore.

use common::{
    Interval, Vec3,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice},
};
use glam::DVec3;
use ray_casting::{
    ray::Ray,
    triangle::{Triangle, TriangleHit},
};

use super::{crossing::line, dice, words};

/// Where the line of a ray meets the plane of a triangle.
struct Meeting {
    t: f64,
    /// Barycentric coordinates, none negative if it meets the triangle itself.
    weights: [f64; 3],
}

/// By the plane and the areas of the three parts, in f64. `None` for a ray along the plane, or no area.
fn meeting(triangle: &Triangle, ray: &Ray) -> Option<Meeting> {
    let (o, d) = line(ray);
    let [a, b, c] = triangle.corners.map(Vec3::as_dvec3);
    let normal = (b - a).cross(c - a);
    let t = (a - o).dot(normal) / d.dot(normal);
    let p = o + d * t;
    let part = |from: DVec3, to: DVec3| (to - from).cross(p - from).dot(normal) / normal.length_squared();
    t.is_finite().then(|| Meeting { t, weights: [part(b, c), part(c, a), part(a, b)] })
}

/// The function under test.
struct Trial<F>(F);

impl<F: Fn(&Triangle, &Ray, Interval) -> Option<TriangleHit>> Trial<F> {
    /// The mistake of that name, or a more particular one, if the answer is not right.
    fn probe(&self, triangle: &Triangle, ray: &Ray, range: Interval, name: &'static str, advice: &str) -> Verdict {
        let got = (self.0)(triangle, ray, range);
        let met = meeting(triangle, ray);
        let is_expected = |m: &Meeting| {
            m.weights.iter().all(|w| *w >= 0.0) && f64::from(range.min) < m.t && m.t < f64::from(range.max)
        };
        let expected = met.as_ref().filter(|m| is_expected(m));
        let mistake = |name, advice: &str| {
            let corners = triangle.corners.map(words::triple).join(", ");
            let weights = |w: [f64; 3]| format!("(α, β, γ) = {}", words::rounded(DVec3::from_array(w)));
            let hit = |t: f64, w: [f64; 3]| format!("a hit at t = {}, {}", words::number(t), weights(w));
            Err(Finding {
                tried: format!("{}, {}, at the triangle {corners}", words::ray(ray), words::range(range)),
                got: got.map_or("no hit".into(), |h| hit(h.t.into(), h.weights.map(f64::from))),
                expected: expected.map_or("no hit".into(), |m| hit(m.t, m.weights)),
                advice: advice.into(),
            }
            .named(name))
        };
        let (hit, expected) = match (got, expected) {
            (None, None) => return Ok(()),
            (None, Some(_)) => return mistake(name, advice),
            (Some(hit), None) => {
                return if !range.contains(hit.t) {
                    mistake(
                        "ignores-range",
                        "This `t` lies outside the range. `range.contains(t)` tells which hits count.",
                    )
                } else {
                    mistake(name, advice)
                };
            }
            (Some(hit), Some(expected)) => (hit, expected),
        };
        let (t, length) = (f64::from(hit.t), ray.direction.as_dvec3().length());
        let is_t = |t: f64| (t - expected.t).abs() * length <= 2e-3;
        let weights = hit.weights.map(f64::from);
        let is_near = |a: [f64; 3]| a.iter().zip(expected.weights).all(|(a, b)| (a - b).abs() <= 2e-3);
        let [alpha, beta, gamma] = weights;
        if !is_t(t) && (is_t(t * length) || is_t(t / length)) {
            mistake("unit-direction", "`t` counts lengths of the ray's direction: leave the direction as it is.")
        } else if !is_t(t) {
            mistake(
                "wrong-t",
                "The triangle is hit, but at another `t`. Is it the right dot product, divided by the determinant?",
            )
        } else if is_near(weights) {
            Ok(())
        } else if [
            [beta, gamma, alpha],
            [gamma, alpha, beta],
            [beta, alpha, gamma],
            [gamma, beta, alpha],
            [alpha, gamma, beta],
        ]
        .into_iter()
        .any(is_near)
        {
            mistake(
                "weights-order",
                "The weights are right, but not in order: u belongs to the second corner, v to the third.",
            )
        } else if (alpha + beta + gamma - 1.0).abs() > 1e-3 {
            mistake("weights-sum", "The three weights must sum to 1: α is what u and v leave over.")
        } else {
            mistake(
                "wrong-weights",
                "`t` is right, but the weights are not. Look at q = s × e1, and which vector is multiplied with which.",
            )
        }
    }
}

/// Accept the function, or name what is wrong with it.
pub(crate) fn check(answer: impl Fn(&Triangle, &Ray, Interval) -> Option<TriangleHit>) -> Verdict {
    let trial = Trial(answer);
    let triangle = Triangle::new(Vec3::ZERO, Vec3::new(4.0, 0.0, 0.0), Vec3::new(0.0, 4.0, 0.0));
    let toward = |x: f32, y: f32| Ray::new(Vec3::new(x, y, 5.0), -Vec3::Z);
    let away = |x: f32, y: f32| Ray::new(Vec3::new(x, y, 5.0), Vec3::Z);
    let is_hit = |ray: &Ray| (trial.0)(&triangle, ray, Interval::new(-100.0, 100.0)).is_some();
    if ![(1.0, 1.0), (2.0, 0.5)].iter().any(|(x, y)| is_hit(&toward(*x, *y)) || is_hit(&away(*x, *y))) {
        return Err(Diagnosis::not_started("Your triangle is never hit: the function returns `None` for every ray."));
    }
    inside_and_outside(&trial, &triangle, &toward)?;
    any_size(&trial, &toward)?;

    // Many rays at many triangles.
    let mut dice = Dice::new(15);
    for _ in 0..4000 {
        let triangle = Triangle::new(dice.point(3.0), dice.point(3.0), dice.point(3.0));
        let [a, b, c] = triangle.corners;
        let ray = dice::ray(&mut dice, 8.0, (a + b + c) / 3.0, 2.0);
        let speed = ray.direction.normalize().dot(triangle.normal().normalize_or_zero()).abs();
        let edges = [b - a, c - b, a - c].map(Vec3::length);
        let is_sound = triangle.normal().length() > 0.1 * edges.into_iter().fold(0.0, f32::max) && speed > 0.05;
        let Some(met) = meeting(&triangle, &ray).filter(|_| is_sound) else { continue };
        if met.weights.iter().any(|w| w.abs() < 5e-3) || met.t.abs() < 1e-2 {
            continue;
        }
        #[expect(clippy::cast_possible_truncation, reason = "the exact number does not matter")]
        let t = met.t as f32;
        for range in [
            Interval::POSITIVE,
            Interval::new(t - 1.0, t + 1.0),
            Interval::new(t + 0.1, t + 9.0),
            Interval::new(-99.0, t - 0.1),
        ] {
            if (range.min - t).abs() > 0.05 {
                trial.probe(
                    &triangle,
                    &ray,
                    range,
                    "wrong-hit",
                    "Work out by hand what your formulas give for this ray.",
                )?;
            }
        }
    }
    Ok(())
}

/// One ray for each likely mistake, at a triangle of common size.
fn inside_and_outside<F>(trial: &Trial<F>, triangle: &Triangle, toward: &impl Fn(f32, f32) -> Ray) -> Verdict
where
    F: Fn(&Triangle, &Ray, Interval) -> Option<TriangleHit>,
{
    let ray = toward(1.0, 0.5);
    let back = Ray::new(Vec3::new(1.0, 0.5, -5.0), Vec3::Z);
    let is_hit = |ray: &Ray| (trial.0)(triangle, ray, Interval::POSITIVE).is_some();
    if is_hit(&ray) != is_hit(&back) {
        let unseen = if is_hit(&ray) { &back } else { &ray };
        let advice = "From the other side the triangle is hit, from here it is not. The determinant is negative on one side: \
                      that is no reason to reject the hit.";
        trial.probe(triangle, unseen, Interval::POSITIVE, "one-sided", advice)?;
    }
    let advice = "The ray goes straight through the triangle. Work this one out on paper.";
    trial.probe(triangle, &ray, Interval::POSITIVE, "missed", advice)?;
    trial.probe(triangle, &back, Interval::POSITIVE, "missed", advice)?;
    let doubled = Ray::new(ray.origin, ray.direction * 2.0);
    trial.probe(triangle, &doubled, Interval::POSITIVE, "missed", advice)?;
    for (x, y, edge) in [(-0.5, 1.0, "u < 0"), (1.0, -0.5, "v < 0"), (2.5, 2.5, "u + v > 1"), (5.0, 1.0, "u + v > 1")] {
        let advice = format!(
            "The ray passes beside the triangle, where {edge}. No weight may be negative, α = 1 − u − v neither."
        );
        trial.probe(triangle, &toward(x, y), Interval::POSITIVE, "edge-forgotten", &advice)?;
    }
    let away = Ray::new(ray.origin, Vec3::Z);
    trial.probe(triangle, &away, Interval::POSITIVE, "hits-behind", "The triangle lies behind this ray.")?;
    for range in [Interval::new(0.0, 5.0), Interval::new(5.0, 9.0)] {
        trial.probe(triangle, &ray, range, "ignores-range", "The range is open: its ends do not count.")?;
    }
    let along = Ray::new(Vec3::new(-1.0, 1.0, 0.0), Vec3::X);
    let advice = "The ray lies in the triangle's plane, and the determinant is exactly 0: such a ray hits nothing.";
    for ray in [along, Ray::new(along.origin + Vec3::Z, along.direction)] {
        trial.probe(triangle, &ray, Interval::new(-99.0, 99.0), "parallel", advice)?;
    }
    Ok(())
}

/// Triangles that are tiny, large, or have no area.
fn any_size<F>(trial: &Trial<F>, toward: &impl Fn(f32, f32) -> Ray) -> Verdict
where
    F: Fn(&Triangle, &Ray, Interval) -> Option<TriangleHit>,
{
    for size in [1e-4, 1e-2, 1e3] {
        let triangle = Triangle::new(Vec3::ZERO, Vec3::X * size, Vec3::Y * size);
        let advice = "The triangle is small, but it is there. The determinant is as small as the triangle's area, so no \
                      fixed number such as 1e-6 can tell whether it is too small: only exactly 0 is.";
        trial.probe(&triangle, &toward(0.25 * size, 0.5 * size), Interval::POSITIVE, "fixed-epsilon", advice)?;
    }
    let point = Vec3::new(1.0, 1.0, 0.0);
    for flat in [Triangle::new(point, point, point), Triangle::new(Vec3::ZERO, point, point * 2.0)] {
        let advice = "All three corners lie on one line: the determinant is 0, and there is nothing to hit.";
        trial.probe(&flat, &toward(1.0, 1.0), Interval::POSITIVE, "no-area", advice)?;
    }
    Ok(())
}
