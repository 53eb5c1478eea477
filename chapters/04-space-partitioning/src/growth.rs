//! Growth: what a ray and a structure cost as a scene grows, counted in steps and bytes. Nothing here is measured in
//! seconds, so every machine counts the same.

use std::sync::Arc;

use common::Error;
use ray_casting::mesh::Mesh;

use crate::{
    choice::{Choice, Countable},
    probe::Counts,
    scenes::{Generator, square},
    viewed_mesh::ViewedMesh,
    workload::{Cast, RayKind, Workload},
};

/// The family of scenes.
pub const SCENE: Generator = square::GENERATOR;
/// About how many triangles the scenes have: two in every factor of ten.
pub const SIZES: [u32; 11] =
    [100, 316, 1_000, 3_160, 10_000, 31_600, 100_000, 316_000, 1_000_000, 3_160_000, 10_000_000];
/// Scenes with more triangles are not traced by brute force.
pub const MOST_BY_FORCE: u32 = 100_000;
/// About so many camera rays look for places from which rays can bounce.
const LOOKS: u32 = 16_000;

/// What was counted in one scene with one structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// Which structure.
    pub choice: Choice,
    /// How many triangles the scene has.
    pub triangles: usize,
    /// How many rays were traced.
    pub rays: usize,
    /// Their steps, all together.
    pub counts: Counts,
    /// Memory of the structure.
    pub bytes: usize,
}

/// Count the steps of all rays in the scene with about `triangles` triangles.
///
/// # Errors
/// None with the generators there are: [`Error::Picture`] if a mesh cannot be made.
pub fn counts(choice: Choice, triangles: u32) -> Result<Row, Error> {
    let subject = Subject::new(triangles)?;
    let structure = choice.over(Arc::clone(&subject.mesh))?;
    Ok(subject.row(choice, structure.as_ref()))
}

// ANCHOR: subject
/// What structures of growing size are compared on: triangles, and rays among them as a path tracer asks for them, one
/// diffuse bounce off what the camera sees.
pub struct Subject {
    /// The triangles.
    pub mesh: Arc<Mesh>,
    /// The rays, all of one kind.
    workload: Workload,
}

impl Subject {
    /// The scene with about `triangles` triangles.
    ///
    /// # Errors
    /// None with the generators there are: [`Error::Picture`] if a mesh cannot be made.
    pub fn new(triangles: u32) -> Result<Self, Error> {
        let viewed = ViewedMesh::of_model((SCENE.make)(triangles))?;
        let structure = Choice::KdTree.over(Arc::clone(&viewed.mesh))?;
        let workload = Workload::new(&viewed, structure.as_ref(), LOOKS, 0);
        Ok(Self { mesh: viewed.mesh, workload })
    }

    /// The rays.
    #[must_use]
    pub fn casts(&self) -> &[Cast] {
        self.workload.casts(RayKind::Bounce)
    }

    /// All that is counted.
    #[must_use]
    pub fn row(&self, choice: Choice, structure: &dyn Countable) -> Row {
        let mut counts = Counts::default();
        for Cast { ray, range } in self.casts() {
            counts += structure.count_nearest(ray, *range).1;
        }
        Row { choice, triangles: self.mesh.len(), rays: self.casts().len(), counts, bytes: structure.bytes() }
    }
}
// ANCHOR_END: subject

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn brute_force_tests_every_triangle_for_every_ray() {
        let Row { triangles, rays, counts, .. } = counts(Choice::BruteForce, 100).unwrap();
        assert_eq!(counts.tests, (triangles * rays) as u64);
        assert!(rays > 5_000, "{rays}");
    }
}
