//! Scenes with a lamp, for exercise 6.2.

use common::{Rgb, Vec3};
use path_tracing::material::Material;
use ray_casting::{ray::Ray, sphere::Sphere};
use whitted::material::Fresnel;

use super::{
    lamp::Lamp,
    lamp_exact::{Seen, irradiance, mean},
    lamp_paths::look,
    lamp_world::LampWorld,
    quad::Quad,
};

/// A scene, a ray into it, and the red radiance along it, if it is known on paper.
pub(super) struct Made {
    pub(super) world: LampWorld,
    pub(super) ray: Ray,
    pub(super) expected: Option<f64>,
}

/// The lamp of all scenes but one: above the origin.
fn lamp() -> Lamp {
    Lamp::around(Vec3::Y * 2.0, [Vec3::X * 0.5, Vec3::Z * 0.5], Rgb::splat(6.0))
}

const ALBEDO: f32 = 0.5;

fn gray() -> Material {
    Material::matte(Rgb::splat(ALBEDO))
}

/// The rays look at the origin from here.
const EYE: Vec3 = Vec3::new(3.0, 2.0, 0.0);

/// A horizontal square at height 0.
fn ground(half: f32) -> Quad {
    Quad::around(Vec3::ZERO, [Vec3::X * half, Vec3::Z * half])
}

/// A lamp above a floor, and nothing else.
pub(super) fn floor() -> Made {
    let world = LampWorld::new(lamp()).with("floor", ground(10.0), gray());
    let received = irradiance(&lamp(), Vec3::ZERO, Vec3::Y) * f64::from(lamp().radiance.x);
    let expected = Some(received * f64::from(gray().diffuse.x));
    Made { world, ray: look(EYE, Vec3::ZERO), expected }
}

/// The lamp itself.
pub(super) fn straight() -> Made {
    let world = LampWorld::new(lamp());
    Made { world, ray: look(Vec3::new(1.0, 0.0, 1.0), Vec3::Y * 2.0), expected: Some(lamp().radiance.x.into()) }
}

/// The lamp in a mirror of gold.
pub(super) fn mirror() -> Made {
    let world = LampWorld::new(lamp()).with("gold", ground(10.0), Material::GOLD);
    // The mirror direction leads to the lamp.
    let ray = look(Vec3::new(-0.2, 1.0, 0.1), Vec3::ZERO);
    let reflectance = Material::GOLD.reflectance(-ray.direction.y, Fresnel::Exact).x;
    Made { world, ray, expected: Some((reflectance * lamp().radiance.x).into()) }
}

/// A floor between the lamp and a panel that nobody asks.
pub(super) fn panel() -> Made {
    let panel = Lamp::around(Vec3::new(0.0, 1.0, -1.5), [Vec3::X, Vec3::Y], Rgb::splat(3.0));
    let received = |lamp: &Lamp| irradiance(lamp, Vec3::ZERO, Vec3::Y) * f64::from(lamp.radiance.x);
    let expected = Some((received(&lamp()) + received(&panel)) * f64::from(gray().diffuse.x));
    let world = LampWorld::new(lamp()).with("floor", ground(10.0), gray()).with(
        "panel",
        panel.quad(),
        Material::glowing(panel.radiance),
    );
    Made { world, ray: look(EYE, Vec3::ZERO), expected }
}

/// A lamp above a floor of porcelain, in which it is mirrored.
pub(super) fn porcelain() -> Made {
    let porcelain = Material::coated(Rgb::splat(0.6), 1.5);
    let ray = look(Vec3::new(-0.2, 1.0, 0.1), Vec3::ZERO);
    let reflectance = f64::from(porcelain.reflectance(-ray.direction.y, Fresnel::Exact).x);
    let received = irradiance(&lamp(), Vec3::ZERO, Vec3::Y);
    let share = reflectance + received * f64::from(porcelain.diffuse.x);
    let expected = Some(share * f64::from(lamp().radiance.x));
    let world = LampWorld::new(lamp()).with("floor", ground(10.0), porcelain);
    Made { world, ray, expected }
}

/// The lamp of the next two scenes, from below.
fn beside() -> Lamp {
    Lamp::around(Vec3::new(1.0, 2.0, 0.0), [Vec3::X * 0.8, Vec3::Z * 0.8], Rgb::splat(6.0))
}

/// A small board keeps this lamp from the origin. A wall on the other side may send its light there.
fn with_wall(wall: Material) -> LampWorld {
    // Of a colored floor the throughput is not 1 in each channel.
    let brown = Material::matte(Rgb::new(0.8, 0.5, 0.2));
    LampWorld::new(beside())
        .with("floor", ground(0.05), brown)
        .with("board", Quad::around(Vec3::new(0.12, 0.2, 0.0), [Vec3::X * 0.12, Vec3::Z * 0.12]), Material::BLACK)
        .with("wall", Quad::around(Vec3::new(-0.4, 1.5, 0.0), [Vec3::Y * 1.5, Vec3::Z * 3.0]), wall)
}

/// The rays that look past the board.
fn past_the_board() -> Ray {
    look(Vec3::new(0.0, 1.0, 3.0), Vec3::ZERO)
}

/// A mirror for the wall: behind it lies the image of the lamp, as bright as the mirror reflects.
pub(super) fn caustic() -> Made {
    let world = with_wall(Material::GOLD);
    let [x, z] = beside().edges;
    let corner = beside().corner * Vec3::new(-1.0, 1.0, 1.0) - Vec3::X * 0.8;
    let image = Lamp { corner, edges: [-x, z], ..beside() };
    #[expect(clippy::cast_possible_truncation, reason = "a cosine")]
    let reflectance = |seen: &Seen| f64::from(Material::GOLD.reflectance(seen.toward.x.abs() as f32, Fresnel::Exact).x);
    let received = mean(&image, Vec3::ZERO, Vec3::Y, |seen| reflectance(seen) * seen.cosine / seen.density());
    let expected = received * 6.0 * 0.8 / std::f64::consts::PI;
    Made { world, ray: past_the_board(), expected: Some(expected) }
}

/// A matte wall.
pub(super) fn indirect() -> Made {
    Made { world: with_wall(gray()), ray: past_the_board(), expected: None }
}

/// A room with a bit of everything.
pub(super) fn furnished() -> Made {
    let wide = Lamp::around(Vec3::new(0.0, 2.2, 0.0), [Vec3::new(1.0, 0.2, 0.0), Vec3::Z], Rgb::splat(4.0));
    let world = LampWorld::new(wide)
        .under(Rgb::splat(0.2))
        .with("floor", ground(2.5), gray())
        .with("wall", Quad::around(Vec3::new(0.0, 1.5, -1.5), [Vec3::X * 2.5, Vec3::Y * 1.5]), gray())
        .with("porcelain", Sphere::new(Vec3::new(0.3, 0.6, -0.4), 0.6), Material::coated(Rgb::splat(0.6), 1.5))
        .with("silver", Sphere::new(Vec3::new(-1.0, 0.5, 0.6), 0.5), Material::SILVER)
        .with("lantern", Sphere::new(Vec3::new(1.6, 0.3, 1.0), 0.3), Material::glowing(Rgb::splat(1.5)));
    Made { world, ray: look(Vec3::new(2.0, 1.2, 2.0), Vec3::new(0.3, 0.9, -0.2)), expected: None }
}
