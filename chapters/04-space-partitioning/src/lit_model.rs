//! A model in the light: the direct light of chapter 2 on the triangles of a structure.

use std::sync::Arc;

use common::{
    Error, Interval, Rgb, Stream,
    picture::{FilmPoint, Integrator},
    story::{Story, number, triple},
};
use ray_casting::{camera::Camera, local_illumination::tell_ray, mesh::Mesh, ray::Ray, scene::Scene};
use shadows::{direct_light::direct_light, offset::Offset};

use crate::{
    choice::{Choice, Countable},
    model::{Model, Part},
};

// ANCHOR: lit_model
/// A model behind a structure, seen by a camera.
pub struct LitModel {
    /// What finds the triangles.
    pub structure: Arc<dyn Countable>,
    mesh: Arc<Mesh>,
    parts: Vec<Part>,
    /// The lights, and the structure once more: as what throws the shadows.
    scene: Scene<()>,
    camera: Camera,
}

impl LitModel {
    /// The model behind a structure of the given kind.
    ///
    /// # Errors
    /// [`Error::Picture`] if the mesh is empty or not finite.
    pub fn new(model: Model, choice: Choice, camera: Camera) -> Result<Self, Error> {
        let Model { mesh, shading, parts, view: _, lights, ambient, background } = model;
        let mesh = Arc::new(Mesh::new(&mesh, shading)?);
        let structure = choice.over(Arc::clone(&mesh))?;
        let mut scene = Scene { lights, ambient, ..Scene::new() };
        scene.surround(background).add("all triangles", Arc::clone(&structure), ());
        Ok(Self { structure, mesh, parts, scene, camera })
    }

    /// The radiance that comes back along a ray.
    fn trace(&self, ray: &Ray, story: &mut impl Story) -> Rgb {
        let Some(found) = self.structure.find(ray, Interval::POSITIVE) else {
            let background = self.scene.background.radiance(ray.direction);
            story.tell(|| format!("hits nothing: background {}", triple(background)));
            return background;
        };
        // Only now is it worth to know more about the hit.
        let Some((part, hit)) = self.part(found.number).zip(self.structure.hit(ray, found)) else { return Rgb::ZERO };
        story.tell(|| {
            let at = triple(hit.position);
            format!("hits triangle {} of '{}' at t = {}, at {at}", found.number, part.name, number(hit.t))
        });
        direct_light(&self.scene, &part.material, &hit, -ray.direction, Offset::Following, story)
    }
}
// ANCHOR_END: lit_model

impl LitModel {
    /// The part that a triangle belongs to.
    fn part(&self, triangle: u32) -> Option<&Part> {
        let after = self.parts.partition_point(|part| part.first <= triangle);
        self.parts.get(after.checked_sub(1)?)
    }

    /// Number of triangles.
    #[must_use]
    pub fn triangles(&self) -> usize {
        self.mesh.len()
    }
}

impl Integrator for LitModel {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        let ray = self.camera.ray(point);
        tell_ray(story, &ray);
        self.trace(&ray, story)
    }
}
