//! Checks exercise 5.2, points of a triangle.

use common::{
    Stream, Vec2, Vec3,
    exercise::{Diagnosis, Finding, Verdict, trying},
};
use sampling::{estimate::Estimate, unit_square::sample_unit_square};

use super::{
    tally::Tally,
    triangle::{PARTS, Triangle, part},
    words::{about, number, pair, triple},
};

/// What the student writes.
#[derive(Clone, Copy)]
pub(crate) struct Answer {
    /// A point of the triangle, by a point of the unit square.
    pub(crate) sample_triangle: fn([Vec3; 3], Vec2) -> Vec3,
    /// Its density.
    pub(crate) triangle_pdf: fn([Vec3; 3]) -> f32,
}

/// Triangles that are tried.
const TRIANGLES: [[[f32; 3]; 3]; 4] = [
    [[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [0.0, 3.0, 1.0]],
    [[1.0, 2.0, 3.0], [-2.0, 1.0, 0.5], [0.0, -3.0, 2.0]],
    [[-4.0, 0.0, 2.0], [6.0, 0.5, 2.0], [5.0, 0.25, 1.0]],
    [[0.0, 0.01, 0.0], [0.01, 0.0, 0.0], [0.0, 0.0, 0.02]],
];
/// Points drawn in each of them.
const COUNT: u32 = 40_000;
/// Accept points of a triangle, or name what is wrong with them.
pub(crate) fn check(answer: Answer) -> Verdict {
    let triangles = TRIANGLES.map(|corners| Triangle { corners: corners.map(Vec3::from_array) });
    let sample = |triangle: &Triangle, u: Vec2| {
        let tried = || format!("`sample_triangle` of {} with u = {}", triangle.words(), pair(u));
        trying(tried, || (answer.sample_triangle)(triangle.corners, u))
    };
    let us = [[0.3, 0.6], [0.9, 0.2], [0.5, 0.5]].map(Vec2::from_array);
    if us.iter().all(|u| sample(&triangles[0], *u) == triangles[0].corners[0]) {
        return Err(Diagnosis::not_started("All points are the same: `sample_triangle` returns the first corner."));
    }
    for (seed, triangle) in (0..).zip(&triangles) {
        points(triangle, seed, &|u| sample(triangle, u))?;
    }
    densities(&triangles, answer.triangle_pdf)
}

/// Points of one triangle.
fn points(triangle: &Triangle, seed: u64, sample: &dyn Fn(Vec2) -> Vec3) -> Verdict {
    let mut random = Stream::new(55, seed, 0);
    let tried = format!("`sample_triangle` of {} with {COUNT} uniform points u", triangle.words());
    let wrong = |name, got: String, expected: &str, advice: &str| {
        let expected = expected.into();
        Err(Finding { tried: tried.clone(), got, expected, advice: advice.into() }.named(name))
    };
    let size = triangle.cross().length().sqrt();
    let reach = triangle.exact().iter().map(|corner| corner.length()).fold(0.0, f64::max);
    let (mut small, mut on_edge, mut tally) = ([0_u32; 3], 0_u32, Tally::even(usize::from(PARTS) * usize::from(PARTS)));
    let (mut means, mut products) = ([Estimate::default(); 3], [Estimate::default(); 3]);
    let last = 1.0 - f32::EPSILON / 2.0;
    let ends = [[0.0, 0.0], [last, 0.0], [0.0, last], [last, last]].map(Vec2::from_array);
    let drawn = (0..COUNT).map(|_| sample_unit_square(&mut random));
    for (i, u) in ends.into_iter().chain(drawn).enumerate() {
        let point = sample(u);
        let weights = triangle.weights(point.as_dvec3());
        let [r1, r2, r3] = triangle.exact();
        let off = (r1 * weights[0] + r2 * weights[1] + r3 * weights[2] - point.as_dvec3()).length();
        let told = || format!("{} of u = {}", triple(point), pair(u));
        if off.is_nan() || off > 1e-3 * size + 1e-5 * reach {
            let advice = "The point does not even lie in the plane of the triangle. Is the sum of the three weights 1?";
            return wrong("not-in-the-plane", told(), "a point of the triangle", advice);
        }
        if weights.iter().any(|weight| *weight < -1e-3) {
            let advice = "Two numbers from 0 to 1 are a point of a parallelogram, and half of that lies beyond the triangle. Fold \
                          that half back, or take a smaller weight for the third corner.";
            return wrong("outside", told(), "a point of the triangle", advice);
        }
        if i >= ends.len() {
            (0..3).for_each(|k| small[k] += u32::from(weights[k] > 0.75));
            on_edge += u32::from(weights.iter().any(|weight| *weight < 1e-4));
            tally.add(part(weights));
            (0..3).for_each(|k| means[k].add(weights[k]));
            (0..3).for_each(|k| products[k].add(weights[k] * weights[(k + 1) % 3]));
        }
    }
    // The weights of uniform points have the variance 1/18; on a line two of them are the same, up to a factor.
    let covariance = |k: usize| products[k].mean() - means[k].mean() * means[(k + 1) % 3].mean();
    let area = means[0].variance() * means[1].variance() - covariance(0) * covariance(0);
    if area < 1e-4 {
        let advice = "All points lie on one line. Use both numbers of u, each once.";
        return wrong("on-a-line", "points on a line".into(), "points all over the triangle", advice);
    }
    if on_edge > COUNT / 20 {
        let got = format!("{on_edge} points on the edges");
        let advice = "A point that would lie beyond the triangle is pulled to its edge, where a whole part of the square ends up. \
                      Fold it over the edge instead.";
        return wrong("edge-crowded", got, "hardly any there", advice);
    }
    for (k, name) in ["r1", "r2", "r3"].into_iter().enumerate() {
        let excess = f64::from(small[k]) / f64::from(COUNT) * 16.0;
        if excess > 1.15 {
            let got = format!("{} times as many points near the corner {name} as there should be", about(excess));
            // Without the root it is 4 times as many, with the root in the wrong place 7 times.
            let advice = if excess > 5.5 {
                "A corner gets even more points than without a square root: α = √u.x grows where it should shrink. The share of \
                 points with an α of at least a is (1 − a)², so that α = 1 − √u.x."
            } else {
                "A corner gets too many points: did you forget the square root? With α = u.x, as many points have an α between \
                 0.9 and 1 as between 0 and 0.1, and there is far less room for them."
            };
            return wrong("corner-crowded", got, "1 of 16 points in each corner's quarter of the sides", advice);
        }
    }
    if !tally.fits() {
        let advice = "Small triangles of equal area got different numbers of points, although no corner is crowded and no \
                      edge. Is each part of the square stretched as much as any other?";
        return wrong("not-uniform", tally.got(), &tally.wanted(), advice);
    }
    moments(&means, &products).map_or(Ok(()), |(got, expected)| {
        let advice =
            "The means of the weights are off, by little. Is a random number used twice, or a constant rounded?";
        wrong("moments", got, &expected, advice)
    })
}

/// The first mean that is off: those of the weights are 1/3, those of their products 1/12.
fn moments(means: &[Estimate; 3], products: &[Estimate; 3]) -> Option<(String, String)> {
    let all =
        means.iter().map(|mean| (mean, 1.0 / 3.0, "weight")).chain(products.iter().map(|p| (p, 1.0 / 12.0, "product")));
    let (mean, expected, what) =
        all.into_iter().find(|(mean, expected, _)| (mean.mean() - expected).abs() > 2.0 * mean.three_sigma() + 1e-5)?;
    Some((format!("a {what} of {} on average", number(mean.mean())), number(expected)))
}

/// The densities of all triangles.
fn densities(triangles: &[Triangle], triangle_pdf: fn([Vec3; 3]) -> f32) -> Verdict {
    let ask = |triangle: &Triangle| {
        let tried = || format!("`triangle_pdf` of {}", triangle.words());
        f64::from(trying(tried, || triangle_pdf(triangle.corners)))
    };
    if triangles.iter().all(|triangle| ask(triangle) == 0.0) {
        let message = "`sample_triangle` is right. Now for `triangle_pdf`, which returns 0 for every triangle.";
        return Err(Diagnosis::new("pdf-not-started", message));
    }
    let areas: Vec<f64> = triangles.iter().map(|triangle| triangle.cross().length() / 2.0).collect();
    let is = |right: &dyn Fn(f64) -> f64| {
        triangles.iter().zip(&areas).all(|(triangle, area)| (ask(triangle) / right(*area) - 1.0).abs() < 1e-3)
    };
    if !is(&|area| 1.0 / area) {
        let (name, advice) = if is(&|area| 0.5 / area) {
            (
                "half-forgotten",
                "The cross product is as long as the area of the parallelogram: the triangle is half of it.",
            )
        } else if is(&|area| area) || is(&|area| 2.0 * area) {
            ("area-not-inverse", "This is an area. A density is the smaller, the larger the triangle is: 1 / area.")
        } else {
            ("wrong-pdf", "The density is 1 / area, in whatever plane the triangle lies.")
        };
        let off = |(triangle, area): &(&Triangle, &f64)| {
            ((ask(triangle) * **area - 1.0).abs() >= 1e-3) || ask(triangle).is_nan()
        };
        let Some((triangle, area)) = triangles.iter().zip(&areas).find(off) else { return Ok(()) };
        return Err(Finding {
            tried: format!("`triangle_pdf` of {}", triangle.words()),
            got: format!("{}, which integrates to {}", about(ask(triangle)), about(ask(triangle) * area)),
            expected: format!("{}, which integrates to 1", about(1.0 / area)),
            advice: advice.into(),
        }
        .named(name));
    }
    let flat = [[[1.0, 2.0, 3.0]; 3], [[0.0; 3], [1.0, 0.0, 0.0], [3.0, 0.0, 0.0]]];
    for triangle in flat.map(|corners| Triangle { corners: corners.map(Vec3::from_array) }) {
        let pdf = ask(&triangle);
        if pdf != 0.0 {
            let advice =
                "A triangle without an area has no density, and 1 / 0 is infinite. Ask whether the area is above 0.";
            let tried = format!("`triangle_pdf` of {}, which has no area", triangle.words());
            let (got, expected) = (pdf.to_string(), "0".into());
            return Err(Finding { tried, got, expected, advice: advice.into() }.named("no-area"));
        }
    }
    Ok(())
}
