//! The shadow terminator: a mesh that is shaded as if it were round, but casts shadows as it is.

use common::{
    Error, Rgb, Vec3,
    color::srgb,
    film::Size,
    knob::{Knob, Step},
    obj::ObjMesh,
    picture::{ORBIT, Panels, Picture, Render, Settings},
};
use ray_casting::{
    light::{DirectionalLight, Light},
    material::Phong,
    mesh::{Mesh, Shading},
    pictures::stage::{camera, square},
    scene::Scene,
    shape::Shape,
    sphere::Sphere,
};

use crate::{direct_light::DirectLight, offset::Offset};

const SUBDIVISIONS: Knob = Knob::number(
    "subdivisions",
    "how often each triangle of the left ball is divided into four",
    [0.0, 4.0],
    2.0,
    "times",
    Step::Whole,
);

pub(super) const PICTURE: Picture = Picture {
    name: "terminator",
    alt: "Two pale balls lit from the left. Left, a mesh of 128 triangles, shaded smooth: it looks round, but the line \
          between light and shadow is a staircase of triangles. Right, a true sphere: light fades into shadow \
          without an edge.",
    knobs: &[SUBDIVISIONS, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 480>(),
    samples: 8,
    takes_mesh: false,
    make,
};

/// Where both balls are. Each has radius 1.
const CENTER: Vec3 = Vec3::Y;

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let mesh = Mesh::new(&ball_of_triangles(settings.values.index(&SUBDIVISIONS)), Shading::Smooth)?;
    let (mesh, sphere) = (view(mesh, settings)?, view(Sphere::new(CENTER, 1.0), settings)?);
    Ok(Box::new(Panels::new(2, vec![Box::new(mesh), Box::new(sphere)])))
}

fn view(ball: impl Shape + 'static, settings: &Settings) -> Result<DirectLight, Error> {
    let mut scene = Scene::new();
    scene.ambient = Rgb::new(0.07, 0.085, 0.13);
    let sun = DirectionalLight::new(Vec3::new(-0.8, 0.5, 0.4), Rgb::new(3.3, 2.9, 2.3));
    let ground = Phong::of(srgb(120, 116, 116), 0.0, 1.0);
    // Far away the floor has one color; the background is the same.
    let sunlight = sun.illuminate(Vec3::ZERO);
    scene.surround(
        ground.ambient * scene.ambient + sunlight.strength * ground.diffuse_term(sunlight.direction, Vec3::Y),
    );
    scene.light(sun);
    scene.add("floor", square(0.0, 60.0)?, ground);
    scene.add("ball", ball, Phong::of(srgb(222, 206, 178), 0.0, 1.0));
    let camera = camera([0.7, 2.2, 6.4], [0.12, 0.92, 0.0], 24.5, &settings.values)?;
    Ok(DirectLight { scene, camera, offset: Offset::Following })
}

/// An octahedron whose triangles are divided into four again and again, with all corners on the sphere.
fn ball_of_triangles(subdivisions: usize) -> ObjMesh {
    let mut triangles = Vec::new();
    for (x, y, z) in [(1.0, 1.0, 1.0), (1.0, -1.0, -1.0), (-1.0, 1.0, -1.0), (-1.0, -1.0, 1.0)] {
        // With an even number of minus signs the corners run counter-clockwise; the opposite triangle turns them round.
        let [a, b, c] = [Vec3::X * x, Vec3::Y * y, Vec3::Z * z];
        triangles.extend([[a, b, c], [-a, -c, -b]]);
    }
    for _ in 0..subdivisions {
        let four = |[a, b, c]: [Vec3; 3]| {
            let [ab, bc, ca] = [a + b, b + c, c + a].map(Vec3::normalize);
            [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        };
        triangles = triangles.into_iter().flat_map(four).collect();
    }
    // The normal in each corner is that of the sphere.
    let normals: Vec<Vec3> = triangles.into_iter().flatten().collect();
    let mut indices = 0_u32..;
    let triangles: Vec<[u32; 3]> =
        normals.chunks_exact(3).map(|_| std::array::from_fn(|_| indices.next().unwrap_or_default())).collect();
    let positions = normals.iter().map(|normal| CENTER + *normal).collect();
    ObjMesh { positions, normals, triangle_normals: triangles.clone(), triangles }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_triangles_face_outward_and_there_are_four_times_as_many_each_time() {
        for (subdivisions, count) in [(0, 8), (1, 32), (3, 512)] {
            let mesh = Mesh::new(&ball_of_triangles(subdivisions), Shading::Smooth).unwrap();
            assert_eq!(mesh.len(), count);
            for triangle in mesh.triangles() {
                assert!(triangle.normal().dot(triangle.corners[0] - CENTER) > 0.0);
            }
        }
    }
}
