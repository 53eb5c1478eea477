//! The camera against its formula in f64, and the rendering loop against the renderer.

#![expect(clippy::disallowed_methods, reason = "f64 has digits to spare: its last bits do not matter here")]

use common::{
    Stream, Vec2, Vec3,
    film::{Film, Size},
    knob::Values,
    picture::{FilmPoint, Integrator, ORBIT, PITCH, Settings, YAW, ZOOM},
    renderer::{self, Plan},
    story::Story,
};
use ray_casting::{
    camera::{Camera, CameraError},
    rendering_loop,
};

use crate::{
    exact::{EPSILON, V},
    rays::{between, direction, in_cube, magnitude, one_of},
};

/// Wide, tall, square, and a single pixel.
const SIZES: [(f32, f32); 5] = [(640.0, 360.0), (90.0, 160.0), (256.0, 256.0), (1920.0, 1.0), (1.0, 1.0)];

fn film_point(x: f32, y: f32, (width, height): (f32, f32)) -> FilmPoint {
    FilmPoint { position: Vec2::new(x, y), size: Vec2::new(width, height) }
}

/// The direction through the center of pixel (X, Y) of XM × YM, by p = lookat + α·right + β·up.
fn formula([eye, lookat, up]: [V; 3], degrees: f64, [x, y]: [f64; 2], [width, height]: [f64; 2]) -> V {
    let alpha = 2.0 * (x + 0.5) / width - 1.0;
    // Rows run down, β runs up.
    let beta = 1.0 - 2.0 * (y + 0.5) / height;
    let forward = (lookat - eye).unit();
    let right = forward.cross(up).unit();
    let up = right.cross(forward);
    // The shorter side of the window has the field of view.
    let shorter = (lookat - eye).length() * (degrees / 2.0).to_radians().tan();
    let (right, up) = (right * (shorter * (width / height).max(1.0)), up * (shorter * (height / width).max(1.0)));
    (lookat + right * alpha + up * beta - eye).unit()
}

#[test]
fn rays_go_where_the_formula_says() {
    let mut random = Stream::new(501, 0, 0);
    for i in 0..20_000 {
        let lookat = in_cube(&mut random) * 10.0;
        let distance = magnitude(&mut random, 0.1, 100.0);
        let toward = direction(&mut random);
        let eye = lookat - toward * distance;
        let up = direction(&mut random) * magnitude(&mut random, 0.1, 10.0);
        let degrees = between(&mut random, 1.0, 170.0);
        let size = SIZES[i % SIZES.len()];
        let (x, y) = (one_of(&mut random, size.0 as usize) as f32, one_of(&mut random, size.1 as usize) as f32);

        let camera = Camera::new(eye, lookat, up, degrees).unwrap();
        let ray = camera.ray(film_point(x + 0.5, y + 0.5, size));
        let pixel = [x, y].map(f64::from);
        let expected = formula([eye, lookat, up].map(V::from), degrees.into(), pixel, [size.0, size.1].map(f64::from));
        // Rounded are: the points, whose difference may be short; the right vector, if up is nearly along the view; and
        // α and β, which are stretched over a window that may be wide.
        let short = (lookat.length() + eye.length()) / distance;
        let along = up.normalize().cross(toward).length().recip();
        let half = (degrees / 2.0).to_radians();
        let wide = common::float::tan(half) * (size.0 / size.1).max(size.1 / size.0);
        let tolerance = 2.0 * EPSILON * f64::from(short + along + wide + 2.0);
        let error = (V::from(ray.direction) - expected).length();
        assert!(error < tolerance, "{camera:?} {x} {y} {size:?}: {ray:?}, not {expected:?}: {error}");
        assert_eq!(ray.origin, eye);
        assert!((ray.direction.length() - 1.0).abs() < 2e-7);
    }
}

#[test]
fn pixels_are_square() {
    for (width, height) in [(640.0, 360.0), (90.0, 160.0), (256.0, 256.0), (2000.0, 100.0), (31.0, 57.0)] {
        for degrees in [2.0, 45.0, 120.0] {
            let camera = Camera::new(Vec3::new(1.0, 2.0, 3.0), Vec3::ZERO, Vec3::Y, degrees).unwrap();
            // From the middle of the film half a pixel to all sides.
            let middle = Vec2::new(width, height) / 2.0;
            let look =
                |x: f32, y: f32| V::from(camera.ray(film_point(middle.x + x, middle.y + y, (width, height))).direction);
            let across = (look(0.5, 0.0) - look(-0.5, 0.0)).length();
            let down = (look(0.0, 0.5) - look(0.0, -0.5)).length();
            assert!(
                (across / down - 1.0).abs() < 10.0 * EPSILON / across,
                "{width}x{height} {degrees}°: {across} {down}"
            );
        }
    }
}

#[test]
fn the_shorter_side_has_the_field_of_view() {
    for degrees in [1.0_f32, 30.0, 90.0, 150.0, 179.0] {
        let camera = Camera::new(Vec3::Z * 5.0, Vec3::ZERO, Vec3::Y, degrees).unwrap();
        for (size, [from, to]) in
            [((300.0, 200.0), [(150.0, 0.0), (150.0, 200.0)]), ((200.0, 300.0), [(0.0, 150.0), (200.0, 150.0)])]
        {
            let [from, to] = [from, to].map(|(x, y)| camera.ray(film_point(x, y, size)).direction);
            let angle = common::float::atan2(from.cross(to).length(), from.dot(to)).to_degrees();
            assert!((angle - degrees).abs() < 1e-4 * degrees.max(10.0), "{degrees}° became {angle}°");
        }
    }
}

#[test]
fn the_first_pixel_is_upper_left() {
    let camera = Camera::new(Vec3::Z * 5.0, Vec3::ZERO, Vec3::Y, 40.0).unwrap();
    let at = |x, y| camera.ray(film_point(x, y, (4.0, 3.0))).direction;
    assert!(at(0.5, 0.5).x < 0.0 && at(0.5, 0.5).y > 0.0);
    assert!(at(3.5, 0.5).x > 0.0 && at(3.5, 0.5).y > 0.0);
    assert!(at(0.5, 2.5).x < 0.0 && at(0.5, 2.5).y < 0.0);
}

/// Shows where on the film each sample lies.
struct Where;

impl Integrator for Where {
    fn radiance(&self, point: FilmPoint, _: &mut Stream, _: &mut impl Story) -> Vec3 {
        point.position.extend(0.0)
    }
}

#[test]
fn the_rendering_loop_goes_row_by_row_from_the_top() {
    let pixels = rendering_loop::render(&Where, Size::of::<3, 2>()).into_iter().map(|p| (p.x, p.y));
    let expected = [(0.5, 0.5), (1.5, 0.5), (2.5, 0.5), (0.5, 1.5), (1.5, 1.5), (2.5, 1.5)];
    assert!(pixels.eq(expected));
}

#[test]
fn the_rendering_loop_makes_the_same_picture_as_the_renderer() {
    for picture in ray_casting::CHAPTER.pictures {
        let render = (picture.make)(&Settings::default()).unwrap();
        let mut film = Film::new(picture.size.scaled_to(40));
        renderer::render(&*render, &mut film, &Plan { samples: 1, seed: 0, threads: 1 }, &());
        let bits = |pixels: Vec<Vec3>| -> Vec<[u32; 3]> {
            pixels.into_iter().map(|pixel| pixel.to_array().map(f32::to_bits)).collect()
        };
        let plain = rendering_loop::render(&*render, film.size());
        assert!(bits(plain) == bits(film.linear()), "{}", picture.name);
    }
}

/// The vectors 'right' and 'up' of a camera, from what it sees.
fn window(camera: &Camera) -> [V; 2] {
    let look = |x, y| V::from(camera.ray(film_point(x, y, (2.0, 2.0))).direction);
    [(look(2.0, 1.0) - look(0.0, 1.0)).unit(), (look(1.0, 0.0) - look(1.0, 2.0)).unit()]
}

#[test]
fn looking_along_up_is_no_special_case() {
    let mut random = Stream::new(502, 0, 0);
    for i in 0..2_000 {
        let axis = [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::Y, direction(&mut random)][i % 5];
        // Exactly along up, opposite to it, or off by very little down to nothing.
        let off = [0.0, magnitude(&mut random, 1e-12, 1e-2)][one_of(&mut random, 2)];
        let view = (axis * [1.0, -1.0][i % 2] + in_cube(&mut random) * off) * magnitude(&mut random, 0.1, 100.0);
        let up = axis * magnitude(&mut random, 0.01, 100.0);
        let camera = Camera::new(-view, Vec3::ZERO, up, 40.0).unwrap();
        let ([right, up], forward) = (window(&camera), V::from(view).unit());
        let crooked =
            [right.dot(up), right.dot(forward), up.dot(forward)].map(f64::abs).into_iter().fold(0.0, f64::max);
        // The nearer the view is to up, the fewer digits has their cross product; at last any axis is taken.
        let sine = V::from(axis).cross(forward).length();
        let tolerance = 1e-6 + if sine > 0.9e-5 { 2.0 * EPSILON / sine } else { 0.0 };
        assert!(crooked < tolerance, "{camera:?}: {crooked}");
        assert!((right.cross(up) + forward).length() < 2.0 * tolerance, "{camera:?} is a mirror image");
    }
    let no_up = Camera::new(Vec3::Z, Vec3::ZERO, Vec3::ZERO, 40.0).unwrap();
    assert!(no_up.ray(film_point(0.5, 0.5, (1.0, 1.0))).direction.is_finite());
}

#[test]
fn impossible_cameras_are_refused() {
    let point = Vec3::new(1.0, 2.0, 3.0);
    for (eye, lookat) in [(point, point), (point, Vec3::NAN), (Vec3::INFINITY, point)] {
        assert_eq!(Camera::new(eye, lookat, Vec3::Y, 40.0), Err(CameraError::NoDirection));
    }
    for degrees in [0.0, -10.0, 180.0, 360.0, f32::INFINITY, f32::NAN] {
        let refused = Camera::new(point, Vec3::ZERO, Vec3::Y, degrees).unwrap_err();
        assert!(matches!(refused, CameraError::FieldOfView(_)));
        assert!(refused.to_string().contains(&format!("{degrees}°")), "{refused}");
    }
}

fn orbited(eye: Vec3, lookat: Vec3, [yaw, pitch, zoom]: [f32; 3]) -> Camera {
    let mut values = Values::default();
    values.set(&YAW, yaw);
    values.set(&PITCH, pitch);
    values.set(&ZOOM, zoom);
    Camera::orbited(eye, lookat, 40.0, &values).unwrap()
}

#[test]
fn an_orbit_can_be_taken_back() {
    let mut random = Stream::new(503, 0, 0);
    for _ in 0..5_000 {
        let lookat = in_cube(&mut random) * 3.0;
        // Start at most 45° over or under the horizon, and go at most 25° further.
        let across = direction(&mut random).with_y(0.0).normalize();
        let from = across.with_y(between(&mut random, -1.0, 1.0)).normalize();
        let eye = lookat + from * magnitude(&mut random, 0.5, 50.0);
        let (yaw, pitch) = (between(&mut random, -180.0, 180.0), between(&mut random, -25.0, 25.0));
        let zoom = magnitude(&mut random, 0.1, 10.0);
        let (before, there) = (eye - lookat, orbited(eye, lookat, [yaw, pitch, zoom]).eye() - lookat);
        let back = orbited(there + lookat, lookat, [-yaw, -pitch, 1.0 / zoom]).eye() - lookat;
        let tolerance = 1e-6 * (lookat.length() + before.length() + there.length()) * zoom.max(1.0);
        assert!((back - before).length() < 2.0 * tolerance, "{before} {yaw}° {pitch}° {zoom}: {there} {back}");
        // On the way the distance is divided by the zoom, and the angles are what they should be.
        assert!(
            (there.length() * zoom / before.length() - 1.0).abs() < 1e-5 * (1.0 + lookat.length() / there.length())
        );
        let heights = [before, there].map(|v| common::float::atan2(v.y, v.with_y(0.0).length()).to_degrees());
        assert!((heights[1] - heights[0] - pitch).abs() < 0.01, "{heights:?} {pitch}");
    }
    // Nothing turned is nothing changed.
    let (eye, lookat) = (Vec3::new(1.0, 2.0, 3.0), Vec3::new(0.5, 0.0, -0.5));
    assert!((orbited(eye, lookat, ORBIT.map(|knob| knob.default())).eye() - eye).length() < 1e-6);
}

#[test]
fn an_orbit_stops_at_the_poles_upright() {
    let (eye, lookat) = (Vec3::new(0.0, 1.0, 5.0), Vec3::new(0.5, 1.0, 0.0));
    for pitch in [90.0, -90.0] {
        for yaw in [-180.0, -90.0, 0.0, 45.0, 180.0] {
            let camera = orbited(eye, lookat, [yaw, pitch, 1.0]);
            let straight = (camera.eye() - lookat).normalize();
            assert!((straight.y - pitch.signum()).abs() < 1e-6, "{straight}");
            // The picture at the pole is the one just before it.
            let near = orbited(eye, lookat, [yaw, pitch * 0.999, 1.0]);
            for (at_pole, near) in window(&camera).into_iter().zip(window(&near)) {
                assert!((at_pole - near).length() < 0.003, "{yaw}° {pitch}°: {at_pole:?} {near:?}");
            }
        }
    }
    // Everywhere the horizon is level.
    let mut random = Stream::new(504, 0, 0);
    for _ in 0..1_000 {
        let turned = [between(&mut random, -180.0, 180.0), between(&mut random, -90.0, 90.0), 1.0];
        let [right, up] = window(&orbited(eye, lookat, turned));
        assert!(right.0[1].abs() < 1e-5 && up.0[1] > -1e-5, "{turned:?}: {right:?} {up:?}");
    }
}
