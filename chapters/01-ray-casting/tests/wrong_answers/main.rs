//! Typical wrong answers to the exercises, put through the same checks as the students' answers: each must be caught, and
//! the mistake must be called by its name.

#[path = "../../exercises/checks/mod.rs"]
mod checks;

mod cylinder;
mod messages;
mod orthographic_camera;
mod plane;
mod spot_light;
mod torus;
mod triangle;

use common::{Interval, Vec3, exercise::Verdict};
use ray_casting::{hit::Hit, ray::Ray, shape::Shape};

/// A shape made of a function, which answers what the ray hits.
struct Answer<F>(F);

impl<F: Fn(&Ray, Interval) -> Option<Hit> + Send + Sync> Shape for Answer<F> {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        (self.0)(ray, range)
    }
}

/// The name of the mistake that a check has found.
fn name(verdict: Verdict) -> &'static str {
    verdict.expect_err("a wrong answer was accepted").name
}

/// The nearest of several hits in the range, given as ray parameter and outward normal.
fn nearest(ray: &Ray, range: Interval, hits: impl IntoIterator<Item = (f32, Vec3)>) -> Option<Hit> {
    let hits = hits.into_iter().filter(|(t, _)| range.contains(*t));
    hits.min_by(|(t1, _), (t2, _)| t1.total_cmp(t2)).map(|(t, outward)| Hit::new(ray, t, outward))
}
