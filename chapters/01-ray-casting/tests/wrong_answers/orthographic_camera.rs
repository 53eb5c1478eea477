//! Wrong orthographic cameras, all of one recipe with one ingredient changed.

use common::{Vec2, Vec3, exercise::Verdict, picture::FilmPoint};
use glam::Vec2Swizzles as _;
use ray_casting::{camera::Camera, ray::Ray};

use crate::{checks::orthographic_camera::check, name};

/// How a camera is built. The default is right.
#[derive(Clone, Copy)]
struct Recipe {
    /// Where the ray through the middle starts, by eye and lookat.
    middle: fn(Vec3, Vec3) -> Vec3,
    /// Where the rays go, by the way from the eye to lookat.
    direction: fn(Vec3) -> Vec3,
    /// Right and upward, by forward and `up`.
    axes: fn(Vec3, Vec3) -> [Vec3; 2],
    /// How far right and up a film point is, in sides of the film.
    film: fn(FilmPoint) -> Vec2,
}

const RIGHT: Recipe = Recipe {
    middle: |eye, _| eye,
    direction: |forward| forward.normalize(),
    axes: |forward, up| {
        let forward = forward.normalize();
        let across = forward.cross(up.normalize());
        let is_along_up = across.length_squared() < 1e-6;
        let right = if is_along_up { forward.any_orthonormal_vector() } else { across.normalize() };
        [right, right.cross(forward)]
    },
    film: |point| point.ndc() * point.size / point.size.min_element() / 2.0,
};

impl Recipe {
    fn check(self) -> Verdict {
        check(|eye, lookat, up, side| {
            let forward = lookat - eye;
            let [right, top] = (self.axes)(forward, up);
            move |point| {
                let at = (self.film)(point) * side;
                Ray::new((self.middle)(eye, lookat) + right * at.x + top * at.y, (self.direction)(forward))
            }
        })
    }

    fn diagnosis(self) -> &'static str {
        name(self.check())
    }
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(RIGHT.check(), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(Recipe { direction: |_| Vec3::ZERO, ..RIGHT }.diagnosis(), "not-started");
}

#[test]
fn rays_that_fan_out() {
    let verdict = check(|eye, lookat, up, _| {
        let camera = Camera::new(eye, lookat, up, 40.0);
        move |point| camera.map_or(Ray::new(eye, Vec3::ZERO), |camera| camera.ray(point))
    });
    assert_eq!(name(verdict), "not-parallel");
    // The film moves the origin, and the ray still goes to `lookat`.
    let verdict = check(|eye, lookat, up, side| {
        let [right, top] = (RIGHT.axes)(lookat - eye, up);
        move |point| {
            let at = (RIGHT.film)(point) * side;
            let origin = eye + right * at.x + top * at.y;
            Ray::new(origin, (lookat - origin).normalize())
        }
    });
    assert_eq!(name(verdict), "not-parallel");
}

#[test]
fn wrong_directions() {
    assert_eq!(Recipe { direction: |forward| -forward.normalize(), ..RIGHT }.diagnosis(), "looks-backwards");
    assert_eq!(Recipe { direction: |forward| forward, ..RIGHT }.diagnosis(), "direction-not-unit");
}

#[test]
fn wrong_origins() {
    assert_eq!(Recipe { middle: |_, lookat| lookat, ..RIGHT }.diagnosis(), "starts-at-lookat");
    assert_eq!(Recipe { film: |point| (RIGHT.film)(point) + 0.5, ..RIGHT }.diagnosis(), "middle-off");
    assert_eq!(Recipe { film: |_| Vec2::ZERO, ..RIGHT }.diagnosis(), "one-origin");
}

#[test]
fn wrong_scales() {
    let scaled = |film| Recipe { film, ..RIGHT }.check().unwrap_err();
    for (film, factor, says_half) in [
        ((|point| (RIGHT.film)(point) * 2.0) as fn(FilmPoint) -> Vec2, "is 2 times", true),
        (|point| (RIGHT.film)(point) / 2.0, "is 0.5 times", true),
        // By the distance, as the pinhole camera's window.
        (|point| (RIGHT.film)(point) * 5.0, "is 5 times", false),
        (|point| (RIGHT.film)(point) * 10.0, "is 10 times", false),
        (|point| (RIGHT.film)(point) * 1.005, "is 1.005 times", false),
        (|point| (RIGHT.film)(point) * 0.3, "is 0.3 times", false),
    ] {
        let wrong = scaled(film);
        assert_eq!(wrong.name, "wrong-scale");
        let words = wrong.message.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(words.contains(factor) && words.contains("half") == says_half, "{wrong}");
    }
    assert_eq!(Recipe { film: |point| point.ndc() / 2.0, ..RIGHT }.diagnosis(), "pixels-not-square");
    let by_height: fn(FilmPoint) -> Vec2 = |point| point.ndc() * Vec2::new(point.aspect(), 1.0) / 2.0;
    assert_eq!(Recipe { film: by_height, ..RIGHT }.diagnosis(), "longer-side");
}

#[test]
fn wrong_way_round() {
    let mirrored: fn(Vec3, Vec3) -> [Vec3; 2] = |forward, up| {
        let [right, top] = (RIGHT.axes)(forward, up);
        [-right, top]
    };
    assert_eq!(Recipe { axes: mirrored, ..RIGHT }.diagnosis(), "mirrored");
    let film: fn(FilmPoint) -> Vec2 = |point| (RIGHT.film)(point) * Vec2::new(1.0, -1.0);
    assert_eq!(Recipe { film, ..RIGHT }.diagnosis(), "upside-down");
    assert_eq!(Recipe { film: |point| (RIGHT.film)(point).yx(), ..RIGHT }.diagnosis(), "axes-swapped");
}

#[test]
fn a_film_that_leans() {
    let leaning: fn(Vec3, Vec3) -> [Vec3; 2] = |forward, up| [forward.cross(up).normalize_or_zero(), up];
    assert_eq!(Recipe { axes: leaning, ..RIGHT }.diagnosis(), "film-leans");
    let unnormalized: fn(Vec3, Vec3) -> [Vec3; 2] = |forward, up| {
        let right = forward.normalize().cross(up);
        [right, right.cross(forward.normalize())]
    };
    assert_eq!(Recipe { axes: unnormalized, ..RIGHT }.diagnosis(), "axes-not-unit");
}

#[test]
fn looking_along_up() {
    let along = |axes| Recipe { axes, ..RIGHT }.diagnosis();
    assert_eq!(
        along(|forward, up| {
            let right = forward.cross(up).normalize();
            [right, right.cross(forward.normalize())]
        }),
        "looking-along-up"
    );
    // Always the same right: it lies in the view when that goes along X.
    assert_eq!(
        along(|forward, up| {
            let forward = forward.normalize();
            let across = forward.cross(up.normalize());
            let right = if across.length_squared() < 1e-6 { Vec3::X } else { across.normalize() };
            [right, right.cross(forward)]
        }),
        "looking-along-up"
    );
    // The direction of what rounding has left.
    assert_eq!(
        along(|forward, up| {
            let forward = forward.normalize();
            let right = forward.cross(up).try_normalize().unwrap_or_else(|| forward.any_orthonormal_vector());
            [right, right.cross(forward)]
        }),
        "nearly-along-up"
    );
}
