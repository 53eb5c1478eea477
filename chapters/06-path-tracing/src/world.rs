//! The world that paths walk through: the scene of chapter 1, and a mesh of many materials behind a structure of
//! chapter 4.

use std::sync::Arc;

use common::{Error, Interval, Rgb, obj::ObjMesh};
use ray_casting::{
    hit::Hit,
    material::Phong,
    mesh::{Mesh, Shading},
    ray::Ray,
    scene::{Object, Scene},
};
use space_partitioning::{
    choice::{Choice, Countable},
    model,
};

use crate::material::Material;

// ANCHOR: world
/// Everything there is: things, lights and sky.
pub struct World {
    /// The lights, the sky, and all that throws shadows. What has no material of its own here is the mesh below.
    scene: Scene<Option<Material>>,
    mesh: Option<PartedMesh>,
}

/// A mesh whose triangles are made of several materials.
struct PartedMesh {
    structure: Arc<dyn Countable>,
    parts: Vec<Part>,
}

/// Triangles of one material that follow each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// What to call it in a pixel's story.
    pub name: &'static str,
    /// Index of its first triangle. It reaches up to the first of the next part.
    pub first: u32,
    /// What it is made of.
    pub material: Material,
}

/// What a ray has hit.
#[derive(Clone, Copy, Debug)]
pub struct Surface<'w> {
    /// What to call it in a pixel's story.
    pub name: &'static str,
    /// What it is made of.
    pub material: &'w Material,
}
// ANCHOR_END: world

impl World {
    /// A scene in which each thing has one material. Any shape will do, and so any structure of chapter 4.
    #[must_use]
    pub fn new(scene: Scene<Material>) -> Self {
        let Scene { objects, lights, ambient: _, background } = scene;
        let own = |Object { name, shape, material }| Object { name, shape, material: Some(material) };
        let objects = objects.into_iter().map(own).collect();
        // All light is followed, so nothing has to stand in for it.
        Self { scene: Scene { objects, lights, ambient: Rgb::ZERO, background }, mesh: None }
    }

    /// The same with a mesh of many materials behind a structure. The first part starts at triangle 0.
    ///
    /// # Errors
    /// [`Error::Picture`] if the mesh is empty, or not finite.
    pub fn with_mesh(mut self, mesh: Mesh, parts: Vec<Part>, choice: Choice) -> Result<Self, Error> {
        let structure = choice.over(Arc::new(mesh))?;
        self.scene.add("mesh", Arc::clone(&structure), None);
        self.mesh = Some(PartedMesh { structure, parts });
        Ok(self)
    }

    /// The same with the triangles of a builder or a model of chapter 4. `material` says what its parts are made of
    /// here, by their names and Phong's materials.
    ///
    /// # Errors
    /// [`Error::Picture`] if the mesh is empty, or not finite.
    pub fn with_parts(
        self,
        (mesh, shading): (&ObjMesh, Shading),
        parts: &[model::Part],
        choice: Choice,
        material: impl Fn(&'static str, Phong) -> Material,
    ) -> Result<Self, Error> {
        let part = |part: &model::Part| Part {
            name: part.name,
            first: part.first,
            material: material(part.name, part.material),
        };
        self.with_mesh(Mesh::new(mesh, shading)?, parts.iter().map(part).collect(), choice)
    }

    /// The lights, the sky and all that throws shadows.
    #[must_use]
    pub fn scene(&self) -> &Scene<Option<Material>> {
        &self.scene
    }

    // ANCHOR: intersect
    /// The nearest hit in front of a ray, and what was hit.
    #[inline(always)]
    #[must_use]
    pub fn intersect(&self, ray: &Ray) -> Option<(Hit, Surface<'_>)> {
        let mut range = Interval::POSITIVE;
        // The mesh says at first only which triangle it is.
        let found = self.mesh.as_ref().and_then(|mesh| Some((mesh, mesh.structure.find(ray, range)?)));
        if let Some((_, found)) = found {
            range = range.up_to(found.t);
        }
        let mut nearest = None;
        for Object { name, shape, material } in &self.scene.objects {
            let Some(material) = material else { continue };
            if let Some(hit) = shape.intersect(ray, range) {
                range = range.up_to(hit.t);
                nearest = Some((hit, Surface { name, material }));
            }
        }
        nearest.or_else(|| {
            let (mesh, found) = found?;
            Some((mesh.structure.hit(ray, found)?, mesh.part(found.number)?))
        })
    }
    // ANCHOR_END: intersect
}

impl PartedMesh {
    /// What a triangle is made of.
    #[inline]
    fn part(&self, triangle: u32) -> Option<Surface<'_>> {
        let after = self.parts.partition_point(|part| part.first <= triangle);
        let part = self.parts.get(after.checked_sub(1)?)?;
        Some(Surface { name: part.name, material: &part.material })
    }
}

#[cfg(test)]
mod tests {
    use common::Vec3;
    use ray_casting::sphere::Sphere;

    use super::*;

    /// Two squares one behind the other, of two materials, and a ball between them.
    fn world() -> World {
        let corner = |x: f32, y: f32, z: f32| Vec3::new(x, y, z);
        let square = |z| [corner(-1.0, -1.0, z), corner(1.0, -1.0, z), corner(0.0, 1.0, z)];
        let obj = ObjMesh {
            positions: [square(0.0), square(-4.0)].concat(),
            triangles: vec![[0, 1, 2], [3, 4, 5]],
            ..ObjMesh::default()
        };
        let part = |name, first, albedo| Part { name, first, material: Material::matte(Rgb::splat(albedo)) };
        let mut scene = Scene::new();
        scene.add("ball", Sphere::new(Vec3::Z * -2.0, 0.5), Material::GOLD);
        let mesh = Mesh::new(&obj, Shading::Flat).unwrap();
        World::new(scene).with_mesh(mesh, vec![part("front", 0, 0.1), part("back", 1, 0.2)], Choice::KdTree).unwrap()
    }

    #[test]
    fn the_nearest_of_mesh_and_things_wins() {
        let world = world();
        let name =
            |z: f32, toward: Vec3| world.intersect(&Ray::new(Vec3::Z * z, toward)).map(|(hit, s)| (s.name, hit.t));
        assert_eq!(name(1.0, -Vec3::Z), Some(("front", 1.0)));
        assert_eq!(name(-1.0, -Vec3::Z), Some(("ball", 0.5)));
        assert_eq!(name(-3.0, -Vec3::Z), Some(("back", 1.0)));
        assert_eq!(name(-5.0, -Vec3::Z), None);
        // Both throw shadows.
        let ray = Ray::new(Vec3::Z * -3.0, -Vec3::Z);
        assert!(
            world.scene().occluded(&ray, Interval::POSITIVE) && !world.scene().occluded(&ray, Interval::new(0.0, 0.9))
        );
    }
}
