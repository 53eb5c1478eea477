//! Checks exercise 1.3, an orthographic camera.

use common::{
    Vec2, Vec3,
    exercise::{Diagnosis, Finding, Verdict},
    picture::FilmPoint,
};
use glam::DVec3;
use ray_casting::ray::Ray;

use super::{dice::Dice, words};

/// The camera as it should be.
#[derive(Clone, Copy)]
struct Ideal {
    eye: Vec3,
    lookat: Vec3,
    up: Vec3,
    side: f32,
}

impl Ideal {
    /// Forward, right and up, all of unit length.
    fn axes(&self) -> [DVec3; 3] {
        let forward = (self.lookat.as_dvec3() - self.eye.as_dvec3()).normalize();
        let right = forward.cross(self.up.as_dvec3()).normalize();
        [forward, right, right.cross(forward)]
    }

    /// The ray of a film point: where it starts and where it goes.
    fn ray(&self, point: FilmPoint) -> (DVec3, DVec3) {
        let [forward, right, up] = self.axes();
        let (position, size) = (point.position.as_dvec2(), point.size.as_dvec2());
        // Pixels from the middle, times the side of a pixel.
        let pixel = f64::from(self.side) / size.min_element();
        let from_middle = (position - size / 2.0) * pixel;
        (self.eye.as_dvec3() + right * from_middle.x - up * from_middle.y, forward)
    }

    fn words(&self) -> String {
        let Self { eye, lookat, up, side } = self;
        let [eye, lookat, up] = [eye, lookat, up].map(|v| words::triple(*v));
        format!("the camera at {eye} that looks at {lookat}, up {up}, side {side}")
    }
}

/// A camera under test.
struct Trial<F> {
    ray: F,
    ideal: Ideal,
}

impl<F: Fn(FilmPoint) -> Ray> Trial<F> {
    /// How far positions may be off, in scene units, and directions.
    const SLACK: f64 = 1e-4;

    /// The ray through a film point, if it is right: otherwise the mistake of that name, or a more particular one.
    fn probe(&self, point: FilmPoint, name: &'static str, advice: &str) -> Verdict {
        let got = (self.ray)(point);
        let (origin, direction) = self.ideal.ray(point);
        let (o, d) = (got.origin.as_dvec3(), got.direction.as_dvec3());
        let (name, advice) = if !got.origin.is_finite() || !got.direction.is_finite() {
            ("not-a-number", "Something was divided by zero, or a vector of length zero was normalised.")
        } else if d.distance(direction) <= Self::SLACK {
            if o.distance(origin) <= Self::SLACK * (1.0 + origin.length()) {
                return Ok(());
            }
            (name, advice)
        } else if d.distance(-direction) <= Self::SLACK {
            ("looks-backwards", "The ray goes the wrong way: from the eye toward `lookat`.")
        } else if (d.length() - 1.0).abs() > Self::SLACK {
            ("direction-not-unit", "Camera rays have unit length, so that `t` is a distance.")
        } else {
            ("not-parallel", "All rays of this camera go in one direction: from the eye toward `lookat`.")
        };
        let ray = |o: DVec3, d: DVec3| format!("a ray from {} in direction {}", words::rounded(o), words::rounded(d));
        Err(Finding {
            tried: format!(
                "{}, film of {}×{} pixels, position ({}, {})",
                self.ideal.words(),
                point.size.x,
                point.size.y,
                point.position.x,
                point.position.y
            ),
            got: ray(o, d),
            expected: ray(origin, direction),
            advice: advice.into(),
        }
        .named(name))
    }
}

/// A point of a film by its share of the width and of the height, from the upper left corner.
fn film([width, height]: [f32; 2], [across, down]: [f32; 2]) -> FilmPoint {
    let size = Vec2::new(width, height);
    FilmPoint { position: size * Vec2::new(across, down), size }
}

/// Accept a camera, or name what is wrong with it. `make` takes eye, lookat, up and side, and gives the function that
/// turns a film point into a ray.
pub(crate) fn check<F: Fn(FilmPoint) -> Ray>(make: impl Fn(Vec3, Vec3, Vec3, f32) -> F) -> Verdict {
    let trial =
        |eye, lookat, up, side| Trial { ray: make(eye, lookat, up, side), ideal: Ideal { eye, lookat, up, side } };
    let plain = trial(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, Vec3::Y, 4.0);
    let square = |place| film([200.0, 200.0], place);
    if [[0.5, 0.5], [0.2, 0.7]].iter().all(|place| (plain.ray)(square(*place)).direction == Vec3::ZERO) {
        return Err(Diagnosis::not_started("Your camera has no direction yet: `ray` returns a ray of length zero."));
    }
    square_film(&plain)?;
    other_films(&plain)?;

    let advice = "Here `up` leans toward the view. The film must stand at right angles to the view all the same: \
                  right = forward × up, and then the film's own up = right × forward, both of unit length.";
    for up in [Vec3::Y, Vec3::Y * 3.0, Vec3::new(1.0, 1.0, 0.2)] {
        let leaning = trial(Vec3::new(3.0, 4.0, 2.0), Vec3::new(1.0, 0.0, -1.0), up, 6.0);
        for place in [[0.5, 0.5], [1.0, 0.5], [0.5, 0.0], [0.1, 0.9]] {
            leaning.probe(square(place), "film-leans", advice)?;
        }
    }
    along_up(&make)?;

    // Many cameras.
    let mut dice = Dice::new(13);
    for _ in 0..500 {
        let (eye, forward, up) = (dice.point(5.0), dice.direction(), dice.direction());
        if forward.normalize().cross(up.normalize()).length() > 0.1 {
            let camera = trial(eye, eye + forward * dice.choice([0.5, 1.0, 20.0]), up, dice.number(0.5, 9.0));
            let size = [dice.choice([64.0, 100.0, 640.0]), dice.choice([64.0, 100.0, 360.0])];
            let place = [dice.number(0.0, 1.0), dice.number(0.0, 1.0)];
            camera.probe(film(size, place), "wrong-origin", "The direction is right, but the ray starts elsewhere.")?;
        }
    }
    Ok(())
}

/// The plainest camera with a square film.
fn square_film<F: Fn(FilmPoint) -> Ray>(camera: &Trial<F>) -> Verdict {
    let square = |place| film([200.0, 200.0], place);
    let origin = |place| (camera.ray)(square(place)).origin;
    let name = if origin([0.5, 0.5]) == camera.ideal.lookat { "starts-at-lookat" } else { "middle-off" };
    let advice = "The ray through the middle of the film starts in the eye. Rays that start elsewhere miss what stands \
                  in front of that place.";
    camera.probe(square([0.5, 0.5]), name, advice)?;

    let (right, top) = (origin([1.0, 0.5]), origin([0.5, 0.0]));
    let advice_scale = "`side` is the whole length of the film's shorter side in scene units; from the middle to an \
                        edge it is half as much.";
    let (name, advice) = if right == origin([0.0, 0.5]) {
        ("one-origin", "All rays start at the same point. With parallel rays it is the origin that differs by pixel.")
    } else if right.x < 0.0 {
        ("mirrored", "Left and right are swapped: a × b = −(b × a).")
    } else if (right.x - 2.0).abs() > 1e-3 {
        ("wrong-scale", advice_scale)
    } else {
        ("wrong-origin", "The ray through the middle of the right edge starts at the wrong place.")
    };
    camera.probe(square([1.0, 0.5]), name, advice)?;
    let (name, advice) = if top.y < 0.0 {
        ("upside-down", "Rows run downward, and `point.ndc()` has already turned them: its y grows upward.")
    } else if (top.y - 2.0).abs() > 1e-3 {
        ("wrong-scale", advice_scale)
    } else {
        ("wrong-origin", "The ray through the middle of the upper edge starts at the wrong place.")
    };
    camera.probe(square([0.5, 0.0]), name, advice)
}

/// The same camera with films that are wider or higher.
fn other_films<F: Fn(FilmPoint) -> Ray>(camera: &Trial<F>) -> Verdict {
    for size in [[400.0, 200.0], [200.0, 400.0]] {
        let origin = |place| (camera.ray)(film(size, place)).origin;
        let half = Vec2::new(origin([1.0, 0.5]).x, origin([0.5, 0.0]).y);
        let is_square = (half.x / half.y - size[0] / size[1]).abs() < 1e-3;
        let (name, advice) = if is_square {
            (
                "longer-side",
                "The pixels are square, but `side` belongs to the shorter side of the film, whichever that is.",
            )
        } else {
            (
                "pixels-not-square",
                "One pixel to the right must be as far as one pixel up, at any aspect ratio: see `wide` and \
                                   `high` on the page about the camera.",
            )
        };
        for place in [[1.0, 0.5], [0.5, 0.0]] {
            camera.probe(film(size, place), name, advice)?;
        }
    }
    Ok(())
}

/// Cameras that look along `up`: any right will do, but there must be one.
fn along_up<F: Fn(FilmPoint) -> Ray>(make: &impl Fn(Vec3, Vec3, Vec3, f32) -> F) -> Verdict {
    for up in [Vec3::Y, -Vec3::Y] {
        let ideal = Ideal { eye: Vec3::new(0.0, 5.0, 0.0), lookat: Vec3::ZERO, up, side: 4.0 };
        let ray = make(ideal.eye, ideal.lookat, ideal.up, ideal.side);
        let from_middle = |place| ray(film([200.0, 200.0], place)).origin - ideal.eye;
        let (right, top) = (from_middle([1.0, 0.5]), from_middle([0.5, 0.0]));
        let is_at_right_angles = right.dot(top).abs() < 1e-3 && right.y.abs() < 1e-3 && top.y.abs() < 1e-3;
        let is_long_enough = [right, top].iter().all(|v| (v.length() - 2.0).abs() < 1e-3);
        if !(is_at_right_angles && is_long_enough) {
            return Err(Finding {
                tried: format!("{}, which looks along its own `up`", ideal.words()),
                got: format!(
                    "from the middle of the film to its right edge {}, to its upper edge {}",
                    words::triple(right),
                    words::triple(top)
                ),
                expected: "two vectors of length 2, at right angles to each other and to the view".into(),
                advice:
                    "forward × up is zero here, so it has no direction. Choose any vector at right angles to forward \
                         then: `forward.any_orthonormal_vector()`."
                        .into(),
            }
            .named("looking-along-up"));
        }
    }
    Ok(())
}
