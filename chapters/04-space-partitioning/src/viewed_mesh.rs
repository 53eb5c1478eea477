//! A mesh with somebody who looks at it and lights around it: where the rays of a comparison come from.

use std::sync::Arc;

use common::{Error, Rgb, Vec3, knob::Values, obj::ObjMesh};
use ray_casting::{
    camera::Camera,
    light::{DirectionalLight, Light},
    mesh::{Mesh, Shading},
    pictures::stage::{camera_error, whole},
};

use crate::model::Model;

/// Triangles, a camera and lights.
pub struct ViewedMesh {
    /// The triangles.
    pub mesh: Arc<Mesh>,
    /// Who looks.
    pub camera: Camera,
    /// What lights them.
    pub lights: Vec<Box<dyn Light>>,
}

impl ViewedMesh {
    /// A model as it wants to be seen.
    ///
    /// # Errors
    /// [`Error::Picture`] if it has no triangle, or nowhere to look.
    pub fn of_model(model: Model) -> Result<Self, Error> {
        let view = model.view;
        let camera = Camera::new(view.eye, view.lookat, Vec3::Y, view.field_of_view).map_err(camera_error)?;
        Ok(Self { mesh: Arc::new(Mesh::new(&model.mesh, Shading::Flat)?), camera, lights: model.lights })
    }

    /// Any mesh, seen as a whole, in the light of a sun.
    ///
    /// # Errors
    /// [`Error::Picture`] if it has no triangle, or is too small or too large to be seen.
    pub fn of_file(mesh: &ObjMesh) -> Result<Self, Error> {
        let mesh = Mesh::new(mesh, Shading::Flat)?;
        let camera = whole(mesh.bounds(), &Values::default())?;
        let sun = DirectionalLight::new(Vec3::new(0.9, 0.9, 1.0), Rgb::ONE);
        Ok(Self { mesh: Arc::new(mesh), camera, lights: vec![Box::new(sun)] })
    }
}
