//! What several pictures share: a dark stage, a warm lamp, a cool sun, and things that stand anywhere.

use common::{
    Error, Interval, Rgb, Vec3,
    color::srgb,
    picture::{ORBIT, Picture, Render, Settings},
};
use ray_casting::{
    camera::Camera,
    frame::Frame,
    hit::Hit,
    light::{DirectionalLight, Light as _, PointLight},
    local_illumination::{LocalIllumination, Terms},
    material::Phong,
    ray::Ray,
    scene::Scene,
    shape::Shape,
};

pub(super) use ray_casting::pictures::stage::{camera, square};

/// Makes a picture of what a user has chosen.
pub(super) type Make = fn(&Settings) -> Result<Box<dyn Render>, Error>;

/// A picture with a camera that can be moved.
pub(super) const fn picture(name: &'static str, alt: &'static str, make: Make) -> Picture {
    let size = common::film::Size::of::<960, 540>();
    Picture { name, alt, knobs: &ORBIT, size, samples: 16, takes_mesh: false, make }
}

/// A dark scene under a cool sun from the left and a warm lamp from the right.
pub(super) fn lit() -> Scene<Phong> {
    let mut scene = Scene::new();
    scene.ambient = Rgb::new(0.07, 0.085, 0.12);
    scene.light(sun());
    scene.light(PointLight { position: Vec3::new(2.2, 3.9, 3.0), intensity: Rgb::new(75.4, 61.3, 45.6) });
    scene
}

fn sun() -> DirectionalLight {
    DirectionalLight::new(Vec3::new(-0.9, 0.3, -0.35), Rgb::new(1.73, 2.14, 3.1))
}

/// The same with a floor that fades into the background.
pub(super) fn stage() -> Result<Scene<Phong>, Error> {
    let mut scene = lit();
    let floor = Phong::of(srgb(92, 96, 108), 0.0, 1.0);
    // Far from the lamp the floor shows the ambient light and the sun. The background is the same.
    let sun = sun().illuminate(Vec3::ZERO);
    scene.surround(floor.ambient * scene.ambient + sun.strength * floor.diffuse_term(sun.direction, Vec3::Y));
    scene.add("floor", square(0.0, 400.0)?, floor);
    Ok(scene)
}

/// A scene as that camera sees it.
pub(super) fn view(scene: Scene<Phong>, camera: Camera) -> Box<dyn Render> {
    Box::new(LocalIllumination { scene, camera, terms: Terms::ALL })
}

/// A shape moved and turned. Nothing is stretched, so ray parameters keep their meaning.
pub(super) struct Placed<S> {
    /// The shape around the origin.
    pub(super) shape: S,
    /// Where it stands.
    pub(super) frame: Frame,
}

impl<S: Shape> Shape for Placed<S> {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        let frame = &self.frame;
        let local = Ray::new(frame.point_to_local(ray.origin), frame.vector_to_local(ray.direction));
        let hit = self.shape.intersect(&local, range)?;
        let [geometric_normal, shading_normal] =
            [hit.geometric_normal, hit.shading_normal].map(|n| frame.vector_to_world(n));
        Some(Hit { position: ray.at(hit.t), geometric_normal, shading_normal, ..hit })
    }
}
