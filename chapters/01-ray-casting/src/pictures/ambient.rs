//! What the ambient term stands in for: the same scene without it, with it, and with light followed one step further.

use std::f32::consts::{PI, TAU};

use common::{
    Basis, Error, Interval, Rgb, Stream, Vec3,
    color::srgb,
    film::Size,
    float,
    knob::Knob,
    picture::{FilmPoint, Integrator, ORBIT, Panels, Picture, Render, Settings},
    story::{Story, Untold, triple},
};

use super::stage::{camera, crystals, square};
use crate::{
    light::DirectionalLight,
    local_illumination::{LocalIllumination, Terms, tell_ray},
    material::Phong,
    quadric::Quadric,
    ray::Ray,
    scene::Scene,
    sphere::Sphere,
};

const LIGHT: Knob = Knob::choice(
    "light",
    "which light is shown",
    &["all three", "without ambient", "with ambient", "one step further"],
    0,
);

pub(super) const PICTURE: Picture = Picture {
    name: "ambient",
    alt: "A white ball, a red bowl and blue crystals on a pale floor under a gray sky, three times. Left, only light \
          that comes straight from the sun: what faces away is black. Middle, with the ambient term: the black parts \
          are lifted to one even gray. Right, with the light followed one step further: the ball glows reddish \
          beside the bowl, and corners and the floor under the ball are darker.",
    knobs: &[LIGHT, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 340>(),
    samples: 32,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let local = |ambient: bool| -> Result<Box<dyn Render>, Error> {
        let (scene, camera) = (scene()?, view(settings)?);
        Ok(Box::new(LocalIllumination { scene, camera, terms: Terms { ambient, ..Terms::ALL } }))
    };
    let gathered = || -> Result<Box<dyn Render>, Error> {
        let direct = LocalIllumination {
            scene: scene()?,
            camera: view(settings)?,
            terms: Terms { ambient: false, ..Terms::ALL },
        };
        Ok(Box::new(OneStepFurther { direct }))
    };
    Ok(match settings.values.index(&LIGHT) {
        1 => local(false)?,
        2 => local(true)?,
        3 => gathered()?,
        _ => Box::new(Panels::new(3, vec![local(false)?, local(true)?, gathered()?])),
    })
}

fn view(settings: &Settings) -> Result<crate::camera::Camera, Error> {
    camera([0.3, 1.9, 5.4], [0.0, 0.55, 0.0], 29.0, &settings.values)
}

fn scene() -> Result<Scene<Phong>, Error> {
    let mut scene = Scene::new();
    scene.ambient = Rgb::new(0.30, 0.33, 0.38);
    scene.surround(scene.ambient);
    scene.light(DirectionalLight::new(Vec3::new(0.75, 0.55, 0.35), Rgb::new(1.95, 1.82, 1.57)));
    scene.add("floor", square(0.0, 60.0)?, Phong::of(srgb(196, 190, 180), 0.0, 1.0));
    scene.add("ball", Sphere::new(Vec3::new(0.62, 0.6, 0.0), 0.6), Phong::of(srgb(236, 232, 224), 0.0, 1.0));
    let bowl = Quadric::paraboloid(0.62, 0.85).placed(crate::frame::Frame::at(Vec3::new(-0.62, 0.0, -0.1)));
    scene.add("bowl", bowl, Phong::of(srgb(206, 50, 40), 0.0, 1.0));
    scene.add("crystals", crystals(Vec3::new(0.02, 0.0, 0.95), 0.42)?, Phong::of(srgb(60, 104, 200), 0.0, 1.0));
    Ok(scene)
}

/// A first taste of chapter 6: the light that a point receives from its surroundings, by one random direction a sample.
struct OneStepFurther {
    direct: LocalIllumination,
}

// ANCHOR: gather
impl Integrator for OneStepFurther {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let ray = self.direct.camera.ray(point);
        tell_ray(story, &ray);
        let radiance = self.direct.trace(&ray, story);
        let Some((hit, object)) = self.direct.scene.intersect(&ray, Interval::POSITIVE) else { return radiance };
        // Look from the hit in one random direction; those near the normal are more likely, by the cosine.
        let (u, v) = (random.uniform(), TAU * random.uniform());
        let across = u.sqrt();
        let local = Vec3::new(across * float::cos(v), across * float::sin(v), (1.0 - u).sqrt());
        let direction = Basis::around(hit.shading_normal).to_world(local);
        let start = hit.position + hit.geometric_normal * 1e-3;
        // What is seen there sends its own direct light, or is the sky.
        let incoming = self.direct.trace(&Ray::new(start, direction), &mut Untold);
        story.tell(|| format!("from direction {} comes {}", triple(direction), triple(incoming)));
        radiance + object.material.diffuse * PI * incoming
    }
}
// ANCHOR_END: gather
