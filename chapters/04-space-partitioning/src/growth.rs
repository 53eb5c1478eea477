//! Growth: what a ray and a structure cost as a scene grows, counted in steps and bytes. Nothing here is measured in
//! seconds, so every machine counts the same.

use std::sync::Arc;

use common::{Error, Interval, Stream, Vec2, Vec3, float, picture::FilmPoint};
use ray_casting::{camera::Camera, hit::Hit, mesh::Mesh, pictures::stage::camera_error, ray::Ray};
use shadows::offset::Offset;

use crate::{
    choice::{Choice, Countable},
    model::View,
    probe::Counts,
    scenes::{Generator, square},
};

/// The family of scenes.
pub const SCENE: Generator = square::GENERATOR;
/// About how many triangles the scenes have: two in every factor of ten.
pub const SIZES: [u32; 11] =
    [100, 316, 1_000, 3_160, 10_000, 31_600, 100_000, 316_000, 1_000_000, 3_160_000, 10_000_000];
/// Scenes with more triangles are not traced by brute force.
pub const MOST_BY_FORCE: u32 = 100_000;
/// The rays come from a film of so many pixels along each side.
const SIDE: u16 = 128;

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
    let subject = Subject::new(&SCENE, triangles)?;
    let structure = choice.over(Arc::clone(&subject.mesh))?;
    Ok(subject.row(choice, structure.as_ref()))
}

// ANCHOR: subject
/// What structures are compared on: triangles, and rays among them as a path tracer asks for them, one diffuse bounce
/// off what the camera sees.
pub struct Subject {
    /// The triangles.
    pub mesh: Arc<Mesh>,
    /// The rays.
    pub rays: Vec<Ray>,
}

impl Subject {
    /// A scene of a family.
    ///
    /// # Errors
    /// None with the generators there are: [`Error::Picture`] if a mesh cannot be made.
    pub fn new(generator: &Generator, triangles: u32) -> Result<Self, Error> {
        let model = (generator.make)(triangles);
        let View { eye, lookat, field_of_view } = model.view;
        let camera = Camera::new(eye, lookat, Vec3::Y, field_of_view).map_err(camera_error)?;
        Self::seen_by(&camera, Mesh::new(&model.mesh, model.shading)?, SIDE)
    }

    /// A mesh that a camera sees, on a film of `side` × `side` pixels.
    ///
    /// # Errors
    /// [`Error::Picture`] if a triangle is not finite, or there are too many.
    pub fn seen_by(camera: &Camera, mesh: Mesh, side: u16) -> Result<Self, Error> {
        let mesh = Arc::new(mesh);
        let structure = Choice::KdTree.over(Arc::clone(&mesh))?;
        Ok(Self { rays: bounces(structure.as_ref(), camera, side), mesh })
    }

    /// The steps of all rays.
    #[must_use]
    pub fn count(&self, structure: &dyn Countable) -> Counts {
        let mut sum = Counts::default();
        for ray in &self.rays {
            sum += structure.count_nearest(ray, Interval::POSITIVE).1;
        }
        sum
    }

    /// All that is counted.
    #[must_use]
    pub fn row(&self, choice: Choice, structure: &dyn Countable) -> Row {
        let (triangles, rays) = (self.mesh.len(), self.rays.len());
        Row { choice, triangles, rays, counts: self.count(structure), bytes: structure.bytes() }
    }
}

/// One ray from each point that is seen through the middle of a pixel, in a direction as chance will have it: likely
/// in proportion to its cosine.
fn bounces(structure: &dyn Countable, camera: &Camera, side: u16) -> Vec<Ray> {
    let size = Vec2::splat(side.into());
    let pixels = (0..side).flat_map(|y| (0..side).map(move |x| Vec2::new(x.into(), y.into()) + 0.5));
    let bounce = |(number, position)| {
        let ray = camera.ray(FilmPoint { position, size });
        let hit = structure.intersect(&ray, Interval::POSITIVE)?;
        Some(bounce(&hit, &mut Stream::new(0, number, 0)))
    };
    (0..).zip(pixels).filter_map(bounce).collect()
}
// ANCHOR_END: subject

/// A ray off a surface. The normal plus a point of the unit sphere has the density of the cosine.
fn bounce(hit: &Hit, random: &mut Stream) -> Ray {
    let normal = hit.geometric_normal;
    let (z, angle) = (1.0 - 2.0 * random.uniform(), std::f32::consts::TAU * random.uniform());
    let across = (1.0 - z * z).max(0.0).sqrt();
    let on_sphere = Vec3::new(across * float::cos(angle), across * float::sin(angle), z);
    let direction = (normal + on_sphere).try_normalize().unwrap_or(normal);
    Ray::new(Offset::Following.origin(hit, normal), direction)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounces_leave_the_surface_with_the_density_of_the_cosine() {
        let down = Ray::new(Vec3::Y, -Vec3::Y);
        let hit = Hit::new(&down, 1.0, Vec3::Y);
        let cosines: Vec<f32> = (0..10_000).map(|i| bounce(&hit, &mut Stream::new(1, i, 0)).direction.y).collect();
        let mean = cosines.iter().sum::<f32>() / 1e4;
        assert!(cosines.iter().all(|&cosine| cosine >= 0.0) && (mean - 2.0 / 3.0).abs() < 0.01, "{mean}");
    }

    #[test]
    fn brute_force_tests_every_triangle_for_every_ray() {
        let Row { triangles, rays, counts, .. } = counts(Choice::BruteForce, 100).unwrap();
        assert_eq!(counts.tests, (triangles * rays) as u64);
        assert!(rays > 5_000, "{rays}");
    }
}
