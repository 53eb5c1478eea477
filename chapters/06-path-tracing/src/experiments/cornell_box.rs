//! A box in which every renderer is measured: after the one at Cornell University, but lit by a point.

use std::sync::Arc;

use common::{Error, Interval, Rgb, Stream, Vec3};
use ray_casting::{
    camera::Camera,
    light::PointLight,
    material::Phong,
    mesh::{Mesh, Shading},
    pictures::stage::camera_error,
    ray::Ray,
    scene::Scene,
    sphere::Sphere,
};
use space_partitioning::{choice::Choice, scenes::builder::Builder};

use crate::{material::Material, method::Method, path_tracer::PathTracer, world::World};

/// Where the eye is.
pub const EYE: Vec3 = Vec3::new(0.0, 1.0, 4.0);
/// Where it looks.
pub const AIM: Vec3 = Vec3::new(0.0, 1.0, 0.0);
/// The angle that the height of a square picture spans, in degrees.
pub const FIELD_OF_VIEW: f32 = 38.0;
/// The lamp below the ceiling.
pub const LAMP: PointLight = PointLight { position: Vec3::new(0.0, 1.75, 0.0), intensity: Rgb::splat(2.0) };

/// Scene B3 is a box of 2×2×2, open in front, with a red wall on the left, a green one on the right, two boxes in it, and a
/// point light of intensity 2 below the ceiling. Scene C3 has a gold ball in place of the boxes.
///
/// # Errors
/// None, since it has triangles.
pub fn tracer(with_boxes: bool, method: Method) -> Result<PathTracer, Error> {
    let builder = mesh(with_boxes);
    let mut scene = Scene::new();
    scene.light(LAMP);
    if !with_boxes {
        scene.add("gold", Sphere::new(Vec3::new(0.0, 0.5, 0.0), 0.5), Material::GOLD);
    }
    let mesh = (&builder.mesh, Shading::Flat);
    let world = World::new(scene).with_parts(mesh, &builder.parts, Choice::EightAtOnce, |_, phong| phong.into())?;
    let camera = Camera::new(EYE, AIM, Vec3::Y, FIELD_OF_VIEW).map_err(camera_error)?;
    Ok(PathTracer { world: Arc::new(world), camera, method })
}

/// So many rays from anywhere in the box to anywhere else.
#[must_use]
pub fn rays(count: usize) -> Vec<Ray> {
    let mut random = Stream::new(75, 0, 0);
    let mut inside = || Vec3::from_array([(); 3].map(|()| random.uniform() * 2.0 - 1.0)) + Vec3::Y;
    (0..count).map(|_| [inside(), inside()]).map(|[from, to]| Ray::new(from, to - from)).collect()
}

/// How many triangles one of such [`rays`] tests on average, if the box with boxes is in this structure.
///
/// # Errors
/// None, since it has triangles.
pub fn tests_per_ray(choice: Choice) -> Result<f64, Error> {
    const RAYS: usize = 10_000;
    let structure = choice.over(Arc::new(Mesh::new(&mesh(true).mesh, Shading::Flat)?))?;
    let tests: u64 = rays(RAYS).iter().map(|ray| structure.count_nearest(ray, Interval::POSITIVE).1.tests).sum();
    #[expect(clippy::cast_precision_loss, reason = "less than a million")]
    Ok(tests as f64 / RAYS as f64)
}

/// Its triangles, in parts of one color each.
#[must_use]
pub fn mesh(with_boxes: bool) -> Builder {
    let corner = |x: f32, y: f32, z: f32| Vec3::new(x, y, z);
    let mut builder = Builder::default();
    builder.part("white", Phong::of(Rgb::splat(0.75), 0.0, 1.0));
    builder.quad([corner(-1.0, 0.0, -1.0), corner(-1.0, 0.0, 1.0), corner(1.0, 0.0, 1.0), corner(1.0, 0.0, -1.0)]);
    builder.quad([corner(-1.0, 0.0, -1.0), corner(1.0, 0.0, -1.0), corner(1.0, 2.0, -1.0), corner(-1.0, 2.0, -1.0)]);
    builder.quad([corner(-1.0, 2.0, -1.0), corner(1.0, 2.0, -1.0), corner(1.0, 2.0, 1.0), corner(-1.0, 2.0, 1.0)]);
    if with_boxes {
        boxes(&mut builder);
    }
    builder.part("red", Phong::of(Rgb::new(0.63, 0.065, 0.05), 0.0, 1.0));
    builder.quad([corner(-1.0, 0.0, -1.0), corner(-1.0, 2.0, -1.0), corner(-1.0, 2.0, 1.0), corner(-1.0, 0.0, 1.0)]);
    builder.part("green", Phong::of(Rgb::new(0.14, 0.45, 0.091), 0.0, 1.0));
    builder.quad([corner(1.0, 0.0, -1.0), corner(1.0, 0.0, 1.0), corner(1.0, 2.0, 1.0), corner(1.0, 2.0, -1.0)]);
    builder
}

/// Two boxes by the four corners of their upper sides.
fn boxes(builder: &mut Builder) {
    let tall = [[-0.702, -0.484], [-0.534, 0.092], [0.042, -0.076], [-0.126, -0.652]];
    let short = [[0.126, -0.012], [-0.042, 0.564], [0.534, 0.732], [0.702, 0.156]];
    for (corners, height) in [(tall, 1.2), (short, 0.6)] {
        let [top, bottom] = [height, 0.0].map(|y| corners.map(|[x, z]: [f32; 2]| Vec3::new(x, y, z)));
        builder.quad(top);
        for i in 0..4 {
            let j = (i + 1) % 4;
            builder.quad([bottom[i], top[i], top[j], bottom[j]]);
        }
    }
}
