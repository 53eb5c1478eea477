//! Checks exercise 1.3, an orthographic camera.

use common::{
    Vec2, Vec3,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice, trying},
    picture::FilmPoint,
};
use glam::DVec3;
use ray_casting::ray::Ray;

use super::words;

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

    /// The camera that `make` makes.
    fn new(make: &impl Fn(Vec3, Vec3, Vec3, f32) -> F, ideal: Ideal) -> Self {
        let ray = trying(|| ideal.words(), || make(ideal.eye, ideal.lookat, ideal.up, ideal.side));
        Self { ray, ideal }
    }

    /// The ray of the camera under test.
    fn ray(&self, point: FilmPoint) -> Ray {
        trying(|| self.tried(point), || (self.ray)(point))
    }

    /// Where the ray of a place on a square film starts, seen from the eye.
    fn offset(&self, place: [f32; 2]) -> DVec3 {
        self.ray(film([200.0, 200.0], place)).origin.as_dvec3() - self.ideal.eye.as_dvec3()
    }

    fn tried(&self, point: FilmPoint) -> String {
        let FilmPoint { position, size } = point;
        let camera = self.ideal.words();
        format!("{camera}, film of {}×{} pixels, position ({}, {})", size.x, size.y, position.x, position.y)
    }

    /// The ray through a film point, if it is right: otherwise the mistake of that name, or a more particular one.
    fn probe(&self, point: FilmPoint, name: &'static str, advice: &str) -> Verdict {
        let got = self.ray(point);
        let (origin, direction) = self.ideal.ray(point);
        let (o, d) = (got.origin.as_dvec3(), got.direction.as_dvec3());
        let (name, advice) = if !got.origin.is_finite() || !got.direction.is_finite() {
            ("not-a-number", "Something was divided by zero, or a vector of length zero was normalized.")
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
            tried: self.tried(point),
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
    let trial = |eye, lookat, up, side| Trial::new(&make, Ideal { eye, lookat, up, side });
    let plain = trial(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, Vec3::Y, 4.0);
    let square = |place| film([200.0, 200.0], place);
    if [[0.5, 0.5], [0.2, 0.7]].iter().all(|place| plain.ray(square(*place)).direction == Vec3::ZERO) {
        return Err(Diagnosis::not_started("Your camera has no direction yet: `ray` returns a ray of length zero."));
    }
    square_film(&plain)?;
    other_films(&plain)?;

    for up in [Vec3::Y, Vec3::Y * 3.0, Vec3::new(1.0, 1.0, 0.2)] {
        leaning(&trial(Vec3::new(3.0, 4.0, 2.0), Vec3::new(1.0, 0.0, -1.0), up, 6.0))?;
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
    let is_lookat = camera.ray(square([0.5, 0.5])).origin == camera.ideal.lookat;
    let name = if is_lookat { "starts-at-lookat" } else { "middle-off" };
    let advice = "The ray through the middle of the film starts in the eye, and `point.ndc()` is (0, 0) there. Rays that \
                  start elsewhere miss what stands in front of that place.";
    camera.probe(square([0.5, 0.5]), name, advice)?;

    let (right, top) = (camera.offset([1.0, 0.5]), camera.offset([0.5, 0.0]));
    let is_swapped = right.x.abs() < 1e-3 && top.y.abs() < 1e-3 && right.y.abs().min(top.x.abs()) > 1e-3;
    let (name, advice) = if right == camera.offset([0.0, 0.5]) {
        (
            "one-origin",
            "All rays start at the same point. With parallel rays it is the origin that differs by pixel.".into(),
        )
    } else if is_swapped {
        (
            "axes-swapped",
            "Right and up are swapped: α, the x of `point.ndc()`, belongs to right, and β, its y, to up.".into(),
        )
    } else if right.x < 0.0 {
        ("mirrored", "Left and right are swapped: a × b = −(b × a).".into())
    } else if (right.x - 2.0).abs() > 1e-3 {
        ("wrong-scale", scale("right", right.x / 2.0, camera.ideal))
    } else {
        ("wrong-origin", "The ray through the middle of the right edge starts at the wrong place.".into())
    };
    camera.probe(square([1.0, 0.5]), name, &advice)?;
    let (name, advice) = if top.y < 0.0 {
        ("upside-down", "Rows run downward, and `point.ndc()` has already turned them: its y grows upward.".into())
    } else if (top.y - 2.0).abs() > 1e-3 {
        ("wrong-scale", scale("upper", top.y / 2.0, camera.ideal))
    } else {
        ("wrong-origin", "The ray through the middle of the upper edge starts at the wrong place.".into())
    };
    camera.probe(square([0.5, 0.0]), name, &advice)
}

/// What to say when an edge of the film is `factor` times as far from the middle as it should be.
fn scale(edge: &str, factor: f64, ideal: Ideal) -> String {
    let distance = f64::from(ideal.eye.distance(ideal.lookat));
    let is = |value: f64| (factor / value - 1.0).abs() < 1e-3;
    let why = if is(2.0) {
        "`side` is the whole length of the film; from the middle to an edge it is half as much."
    } else if is(0.5) {
        "From the middle to an edge it is half of `side`, and α and β go up to 1 there: halve only once."
    } else if [1.0, 2.0, 0.5].iter().any(|by| is(by * distance)) {
        "The distance from the eye to `lookat` must not matter: other than the pinhole camera's window, this film has a \
         length in scene units, `side`."
    } else if (factor - 1.0).abs() < 0.03 {
        "That is nearly 1. Do you compute α and β yourself? At the edges of the film they are exactly −1 and 1, as \
         `point.ndc()` gives them."
    } else {
        "From the middle to an edge it must be `side` / 2."
    };
    format!("The {edge} edge is {} times as far from the middle as it should be. {why}", words::number(factor))
}

/// A camera whose `up` leans toward the view.
fn leaning<F: Fn(FilmPoint) -> Ray>(camera: &Trial<F>) -> Verdict {
    let [_, right, up] = camera.ideal.axes();
    let is_stretched = |got: DVec3, axis: DVec3| {
        let along = got.dot(axis);
        got.distance(axis * along) < 1e-3 * along && (along / f64::from(camera.ideal.side / 2.0) - 1.0).abs() > 1e-3
    };
    let (name, advice) =
        if is_stretched(camera.offset([1.0, 0.5]), right) || is_stretched(camera.offset([0.5, 0.0]), up) {
            (
                "axes-not-unit",
                "Of unit length is what both axes of the film must be, and one of them is not. forward × up is shorter \
                 when `up` leans toward the view, and longer when `up` is long: normalize it.",
            )
        } else {
            (
                "film-leans",
                "Here `up` leans toward the view. The film must stand at right angles to the view all the same: \
                 right = forward × up, of unit length, and then the film's own up = right × forward.",
            )
        };
    for place in [[1.0, 0.5], [0.5, 0.0], [0.5, 0.5], [0.1, 0.9]] {
        camera.probe(film([200.0, 200.0], place), name, advice)?;
    }
    Ok(())
}

/// The same camera with films that are wider or higher.
fn other_films<F: Fn(FilmPoint) -> Ray>(camera: &Trial<F>) -> Verdict {
    for size in [[400.0, 200.0], [200.0, 400.0]] {
        let origin = |place| camera.ray(film(size, place)).origin;
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
    let straight = [Vec3::Y, -Vec3::Y, Vec3::X, -Vec3::X, Vec3::Z, -Vec3::Z];
    // Here rounding makes a tiny vector of forward × up.
    let oblique = [[0.3, -0.7, 0.2], [-0.2, 0.9, 0.5], [0.6, 0.1, -0.3]].map(Vec3::from_array);
    for up in straight.into_iter().chain(oblique) {
        for times in [10.0, -10.0] {
            let eye = Vec3::new(1.0, 2.0, 3.0);
            let ideal = Ideal { eye, lookat: eye + up * times, up, side: 4.0 };
            along_one_up(&Trial::new(make, ideal))?;
        }
    }
    Ok(())
}

/// A camera that looks along its `up`.
fn along_one_up<F: Fn(FilmPoint) -> Ray>(camera: &Trial<F>) -> Verdict {
    let ideal = camera.ideal;
    let forward = (ideal.lookat.as_dvec3() - ideal.eye.as_dvec3()).normalize();
    let (right, top) = (camera.offset([1.0, 0.5]), camera.offset([0.5, 0.0]));
    let is_frame = right.cross(forward).distance(top) < 1e-3 && right.dot(forward).abs() < 1e-3;
    let is_long_enough = [right, top].iter().all(|v| (v.length() - 2.0).abs() < 1e-3);
    let direction = camera.ray(film([200.0, 200.0], [0.5, 0.5])).direction.as_dvec3();
    if is_frame && is_long_enough && direction.distance(forward) < 1e-3 {
        return Ok(());
    }
    let is_oblique = ideal.up.abs().min_element() > 0.0;
    let (name, advice) = if is_oblique {
        (
            "nearly-along-up",
            "forward × up should be zero here. Rounding leaves a tiny vector instead, and to normalize it gives a direction \
             that is wrong. Take forward × up for zero when it is very short, as `chapters/01-ray-casting/src/camera.rs` \
             does, and `forward.any_orthonormal_vector()` for right then.",
        )
    } else {
        (
            "looking-along-up",
            "forward × up is zero here, so it has no direction. Choose any unit vector at right angles to forward then: \
             `forward.any_orthonormal_vector()`. No vector is at right angles to every forward.",
        )
    };
    let [forward, right, top, direction] = [forward, right, top, direction].map(words::rounded);
    Err(Finding {
        tried: format!("{}, which looks along its own `up`", ideal.words()),
        got: format!(
            "rays in direction {direction}; from the middle of the film to its right edge {right}, to its upper edge {top}"
        ),
        expected: format!(
            "rays in direction {forward}; to the right any vector of length 2 at right angles to it, and to the upper edge \
             right × forward"
        ),
        advice: advice.into(),
    }
    .named(name))
}
