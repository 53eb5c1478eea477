//! Picture of exercise 1.3: a colonnade, by both cameras.

use common::{
    Error, Rgb, Stream, Vec3,
    color::srgb,
    picture::{FilmPoint, Integrator, Panels, Picture, Render, Settings},
    story::Story,
};
use ray_casting::{
    camera::Camera,
    frame::Frame,
    local_illumination::{LocalIllumination, Terms, tell_ray},
    material::Phong,
    quadric::Quadric,
    ray::Ray,
    scene::Scene,
    sphere::Sphere,
};

use super::stage::{self, Make, camera, stage};

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "Two rows of columns with a ball on each, twice. Left, by a pinhole camera: the columns shrink with the distance and \
               the rows run together. Right, by an orthographic camera: all columns are equally large and the rows stay parallel.";
    stage::picture("1.3-orthographic-camera", alt, make)
}

/// A scene seen through the student's camera.
struct Orthographic<F> {
    local: LocalIllumination,
    ray: F,
}

impl<F: Fn(FilmPoint) -> Ray + Send + Sync> Integrator for Orthographic<F> {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        let ray = (self.ray)(point);
        tell_ray(story, &ray);
        self.local.trace(&ray, story)
    }
}

/// Both views, the right one through the camera that `orthographic` makes of eye, lookat, up and side.
pub(crate) fn make<F: Fn(FilmPoint) -> Ray + Send + Sync + 'static>(
    settings: &Settings,
    orthographic: impl Fn(Vec3, Vec3, Vec3, f32) -> F,
) -> Result<Box<dyn Render>, Error> {
    const LOOKAT: [f32; 3] = [0.0, 0.35, -0.4];
    let pinhole = || camera([4.1, 3.9, 6.4], LOOKAT, 34.0, &settings.values);
    let view = |camera: Camera| Ok::<_, Error>(LocalIllumination { scene: scene()?, camera, terms: Terms::ALL });
    let eye = pinhole()?.eye();
    let lookat = Vec3::from_array(LOOKAT);
    // A little more than what the pinhole camera sees at the point where both look.
    let side = 2.3 * (eye - lookat).length() * common::float::tan(17.0_f32.to_radians());
    // Far enough back that nothing stands behind the film.
    let ray = orthographic(lookat + (eye - lookat) * 4.0, lookat, Vec3::Y, side);
    let parallel = Orthographic { local: view(pinhole()?)?, ray };
    Ok(Box::new(Panels::new(2, vec![Box::new(view(pinhole()?)?), Box::new(parallel)])))
}

/// Two rows of columns.
fn scene() -> Result<Scene<Phong>, Error> {
    let mut scene = stage()?;
    let cream = Phong::of(srgb(226, 212, 184), 0.3, 40.0);
    for (x, ball) in [(-0.95, srgb(190, 40, 48)), (0.95, srgb(52, 140, 140))] {
        for z in [-3.4, -2.2, -1.0, 0.2, 1.4] {
            let place = Vec3::new(x, 0.0, z);
            scene.add("column", Quadric::cylinder(0.2, 1.1).placed(Frame::at(place)), cream);
            scene.add("ball", Sphere::new(place + Vec3::Y * 1.28, 0.29), Phong::of(ball, 0.7, 90.0));
        }
    }
    Ok(scene)
}
