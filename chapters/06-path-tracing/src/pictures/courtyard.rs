//! The cover: the court of chapter 4 in the light of sun and sky, with a golden ball on its fountain.

use std::sync::Arc;

use common::{
    Error, Rgb, Vec3,
    film::Size,
    knob::{Knob, Step},
    picture::{ORBIT, Picture, Render, Settings},
};
use ray_casting::{
    background::Background, camera::Camera, light::DirectionalLight, pictures::stage::camera_error, scene::Scene,
    sphere::Sphere,
};
use space_partitioning::{choice::Choice, scenes::court};

use super::knobs::{self, DIRECT, SAMPLING, method};
use crate::{material::Material, path_tracer::PathTracer, world::World};

/// In the open most light comes after few bounces. Paths cut off here lack three thousandths of it, and without roulette they
/// have less grain.
const ROULETTE: Knob = knobs::roulette(false);
const BOUNCES: Knob = knobs::bounces(6.0);
/// How many triangles the court has.
const TRIANGLES: Knob = Knob::number(
    "triangles",
    "about how many triangles",
    [100.0, 20_000_000.0],
    50_000.0,
    "triangles",
    Step::Times(2.0),
);
/// What finds them.
const STRUCTURE: Knob = Knob::choice("structure", "what finds the triangles", &Choice::NAMES, Choice::KdTree as usize);

pub(super) const PICTURE: Picture = Picture {
    name: "courtyard",
    alt: "A court with two storeys of arches on white columns, in the sun on the left and in the shade on the right. A \
          great golden ball rests on the fountain in its middle and mirrors the court, the sky, and the banners. The \
          vaults of the galleries, which no sun reaches, are lit from below.",
    knobs: &[TRIANGLES, STRUCTURE, SAMPLING, DIRECT, ROULETTE, BOUNCES, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 540>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    Ok(Box::new(tracer(settings)?))
}

/// The court, with these knobs.
///
/// # Errors
/// [`Error::Picture`] if the knobs leave no direction to look in.
pub fn tracer(settings: &Settings) -> Result<PathTracer, Error> {
    let values = &settings.values;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the knob's range is smaller")]
    let model = (court::GENERATOR.make)(values.number(&TRIANGLES) as u32);
    let choice = Choice::ALL[values.index(&STRUCTURE).min(Choice::ALL.len() - 1)];
    let world =
        World::new(scene()).with_parts((&model.mesh, model.shading), &model.parts, choice, |_, phong| phong.into())?;
    let camera = Camera::orbited(EYE, LOOKAT, FIELD_OF_VIEW, values).map_err(camera_error)?;
    Ok(PathTracer { world: Arc::new(world), camera, method: method(settings, [&ROULETTE, &BOUNCES]) })
}

/// Who looks.
const EYE: Vec3 = Vec3::new(1.5, 1.9, 1.6);
const LOOKAT: Vec3 = Vec3::new(-0.4, 3.7, -12.0);
const FIELD_OF_VIEW: f32 = 54.0;

// ANCHOR: scene
/// Sun and sky, and the ball. The triangles come with the mesh.
fn scene() -> Scene<Material> {
    let mut scene = Scene::new();
    scene.surround(Sky).light(DirectionalLight::new(Vec3::new(0.62, 1.0, 0.5), Rgb::new(6.6, 5.3, 3.6)));
    scene.add("golden ball", Sphere::new(Vec3::new(0.0, 3.75, -9.0), 1.4), Material::GOLD);
    scene
}

/// A clear sky: pale at the horizon, blue above.
struct Sky;

impl Background for Sky {
    fn radiance(&self, direction: Vec3) -> Rgb {
        let height = direction.normalize().y.max(0.0);
        Rgb::new(0.95, 1.1, 1.3).lerp(Rgb::new(0.3, 0.62, 1.4), height)
    }
}
// ANCHOR_END: scene
