//! # Exercise 1.3: an orthographic camera
//!
//! Architects draw plans and elevations in which a length is the same wherever it stands: equal columns stay equal, and
//! parallel edges stay parallel. A pinhole camera cannot make such a picture, because its rays fan out. An orthographic
//! camera can: all its rays go in one direction, and only their origins differ.
//!
//! The film stands in the eye, at right angles to the view:
//!
//! ```text
//! forward = (lookat − eye) / |lookat − eye|
//! right   = (forward × up) / |forward × up|      film axes of unit length
//! top     = right × forward
//!
//! origin    = eye + α·(width/2)·right + β·(height/2)·top
//! direction = forward
//! ```
//!
//! `point.ndc()` is a `Vec2`: its x is α and its y is β, both from −1 to 1. The width and the height of the film in scene
//! units follow from `side`, see below, and from `point.aspect()`, which is width / height.
//!
//! ## Your task
//!
//! Fill in `OrthographicCamera::new` and `OrthographicCamera::ray` below, and give the camera the fields it needs. The
//! book's page *The camera* and `chapters/01-ray-casting/src/camera.rs` show the pinhole camera.
//!
//! - The ray through the middle of the film starts in the eye. All rays have the direction `forward`, of unit length.
//! - `side` is the length of the **shorter** side of the film in scene units. The longer side is as much longer as the film
//!   has more pixels that way, so that pixels are square at any `point.aspect()`, upright or not.
//! - Upward in the picture is `up`, as far as it can be: `up` may lean toward the view and may have any length.
//! - A camera that looks along `up` works too. Which way is right does not matter then, but it must have a direction:
//!   `forward.any_orthonormal_vector()` is a unit vector at right angles to `forward`.
//! - Beware of rounding: looking along `up`, forward × up is often not zero but tiny, and its direction is then wrong.
//!   `try_normalize()` does not notice that. Take a very short vector for zero.
//!
//! ## When you are done
//!
//! `cargo exercise 1.3` checks your camera and renders a colonnade by both cameras side by side.

use std::process::ExitCode;

use common::{
    Vec3,
    exercise::{self, Verdict},
    picture::{FilmPoint, Picture},
};
use ray_casting::ray::Ray;

/// A camera whose rays are all parallel.
// STUB: struct OrthographicCamera {
// STUB:     /// Where the ray through the middle of the film starts. (Your camera needs more than this.)
// STUB:     eye: Vec3,
// STUB: }
struct OrthographicCamera {
    /// Where the ray through the middle of the film starts.
    eye: Vec3,
    /// Where all rays go: a unit vector.
    forward: Vec3,
    /// From the middle of a square film to the middle of its right edge.
    right: Vec3,
    /// From the middle of a square film to the middle of its upper edge.
    up: Vec3,
}
// END STUB

impl OrthographicCamera {
    /// A camera at `eye` that looks at `lookat`, with `up` upward in the picture. The shorter side of its film is `side`
    /// scene units long.
    fn new(eye: Vec3, lookat: Vec3, up: Vec3, side: f32) -> Self {
        // STUB: let _ = (lookat, up, side); // take this line away when you start
        // STUB: Self { eye }
        let forward = (lookat - eye).normalize_or(-Vec3::Z);
        let across = forward.cross(up.normalize_or_zero());
        // Along `up` there is no right, only what rounding leaves of it: any direction across the view will do.
        let is_along_up = across.length_squared() < 1e-6;
        let right = if is_along_up { forward.any_orthonormal_vector() } else { across.normalize() };
        let half = side / 2.0;
        Self { eye, forward, right: right * half, up: right.cross(forward) * half }
        // END STUB
    }

    /// The ray that arrives at a point of the film, its direction of unit length.
    fn ray(&self, point: FilmPoint) -> Ray {
        // STUB: let _ = point; // take this line away when you start
        // STUB: Ray::new(self.eye, Vec3::ZERO)
        let (alpha, beta) = point.ndc().into();
        // The shorter side of the film is `side` long; the longer side sees more. So pixels are square.
        let aspect = point.aspect();
        let (wide, high) = (aspect.max(1.0), aspect.recip().max(1.0));
        // Parallel rays: the origin moves over the film, the direction stays.
        Ray::new(self.eye + self.right * (alpha * wide) + self.up * (beta * high), self.forward)
        // END STUB
    }
}

// From here on your camera is checked and shown. There is nothing to do below.

#[path = "../exercises/checks/mod.rs"]
mod checks;
#[path = "../exercises/pictures/mod.rs"]
mod pictures;

/// What your camera sees.
const PICTURE: Picture =
    pictures::orthographic_camera::picture(|settings| pictures::orthographic_camera::make(settings, camera));

/// Your camera as a function from film points to rays.
fn camera(eye: Vec3, lookat: Vec3, up: Vec3, side: f32) -> impl Fn(FilmPoint) -> Ray {
    let camera = OrthographicCamera::new(eye, lookat, up, side);
    move |point| camera.ray(point)
}

fn main() -> ExitCode {
    exercise::main(accepted, &pictures::chapter(&[PICTURE]))
}

/// Whether your camera is right.
fn accepted() -> Verdict {
    checks::orthographic_camera::check(camera)
}
