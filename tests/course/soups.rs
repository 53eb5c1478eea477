//! Soups of triangles, and rays at all their weak places.

use std::sync::Arc;

use common::{Stream, Vec3, obj::ObjMesh};
use ray_casting::{
    aabb::Aabb,
    mesh::{Mesh, Shading},
    ray::Ray,
};
use space_partitioning::scenes::GENERATORS;

use crate::rays::{aimed, between, direction, in_cube, magnitude, one_of};

/// A named mesh.
pub(crate) struct Soup {
    pub(crate) name: String,
    pub(crate) mesh: Arc<Mesh>,
}

impl Soup {
    pub(crate) fn new(name: impl Into<String>, positions: Vec<Vec3>) -> Self {
        let triangles = (0..positions.len() as u32 / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        let obj = ObjMesh { positions, triangles, ..ObjMesh::default() };
        Self { name: name.into(), mesh: Arc::new(Mesh::new(&obj, Shading::Flat).unwrap()) }
    }
}

/// A soup of `count` triangles, each made by `triangle` from its place in a cube.
fn soup(name: &str, count: u32, random: &mut Stream, mut triangle: impl FnMut(&mut Stream, Vec3) -> [Vec3; 3]) -> Soup {
    let corners = (0..count).flat_map(|_| {
        let place = in_cube(random);
        triangle(random, place)
    });
    Soup::new(name, corners.collect())
}

/// The nearest corner of a raster of a sixteenth.
fn snapped(v: Vec3) -> Vec3 {
    (v * 16.0).round() / 16.0
}

/// Soups of all kinds, each of some hundred triangles.
pub(crate) fn soups(random: &mut Stream) -> Vec<Soup> {
    let small = |random: &mut Stream, p: Vec3| [(); 3].map(|()| p + in_cube(random) * 0.1);
    let mut soups = vec![
        soup("small triangles", 400, random, small),
        soup("large triangles", 100, random, |random, _| [(); 3].map(|()| in_cube(random))),
        soup("slivers", 300, random, |random, p| {
            let along = direction(random);
            [p, p + along, p + along * 0.5 + in_cube(random) * 1e-3]
        }),
        soup("corners in a raster", 300, random, |random, p| [(); 3].map(|()| snapped(p + in_cube(random) * 0.2))),
        // Floors, walls and steps, whose planes are the planes of cells too.
        soup("upright in a raster", 300, random, |random, p| {
            let axis = one_of(random, 3);
            let (u, v) = (Vec3::AXES[(axis + 1) % 3], Vec3::AXES[(axis + 2) % 3]);
            [p, p + u * 0.25, p + v * 0.25].map(snapped)
        }),
        // A wall and small things on it: the wall's corners are far from where it is hit.
        soup("great and small in a raster", 200, random, |random, p| {
            let axis = one_of(random, 3);
            let (u, v) = (Vec3::AXES[(axis + 1) % 3], Vec3::AXES[(axis + 2) % 3]);
            let side = if random.uniform() < 0.2 { 2.0 } else { 0.0625 };
            let p = snapped(p);
            [p - (u + v) * (side / 2.0), p + u * side, p + v * side]
        }),
        soup("each one twice", 150, random, small),
        soup("all in one place", 60, random, |_, _| [Vec3::ZERO, Vec3::X, Vec3::Y]),
        soup("one corner in common", 150, random, |random, _| [Vec3::ZERO, in_cube(random), in_cube(random)]),
        soup("many sizes", 250, random, |random, p| {
            let size = magnitude(random, 1e-4, 1.0);
            [(); 3].map(|()| p + in_cube(random) * size)
        }),
        soup("one far away", 200, random, |random, p| {
            let far = if random.uniform() < 0.005 { 1e4 } else { 1.0 };
            [(); 3].map(|()| (p + in_cube(random) * 0.1) * far)
        }),
        soup("far from the origin", 300, random, |random, p| {
            [(); 3].map(|()| Vec3::splat(1000.0) + p + in_cube(random) * 0.1)
        }),
        soup("without area", 200, random, |random, p| {
            let step = in_cube(random) * 0.1;
            [p, p + step, p + step * f32::from(one_of(random, 3) as u8)]
        }),
        soup("flat", 300, random, |random, p| [(); 3].map(|()| (p + in_cube(random) * 0.1).with_y(0.5))),
        soup("tiny", 300, random, |random, p| [(); 3].map(|()| (p + in_cube(random) * 0.1) * 1e-6)),
        soup("huge", 300, random, |random, p| [(); 3].map(|()| (p + in_cube(random) * 0.1) * 1e6)),
        soup("one", 1, random, |random, _| [(); 3].map(|()| in_cube(random))),
    ];
    // Ties: the same triangles once more, in another order.
    if let Some(twice) = soups.iter_mut().find(|soup| soup.name == "each one twice") {
        let corners = twice.mesh.triangles().chain(twice.mesh.triangles()).flat_map(|t| t.corners);
        *twice = Soup::new("each one twice", corners.collect());
    }
    for generator in GENERATORS {
        let mesh = (generator.make)(400).mesh;
        let mesh = Arc::new(Mesh::new(&mesh, Shading::Flat).unwrap());
        soups.push(Soup { name: format!("the {}", generator.name), mesh });
    }
    soups
}

/// What rays are aimed at.
pub(crate) struct Aim<'a> {
    pub(crate) mesh: &'a Mesh,
    /// Cells of the structures.
    pub(crate) cells: &'a [Aabb],
}

impl Aim<'_> {
    /// A corner of a random triangle.
    fn vertex(&self, random: &mut Stream) -> Vec3 {
        self.mesh.triangle(one_of(random, self.mesh.len())).corners[one_of(random, 3)]
    }

    /// A random point of a random triangle.
    fn surface(&self, random: &mut Stream) -> Vec3 {
        let [a, b, c] = self.mesh.triangle(one_of(random, self.mesh.len())).corners;
        let (u, v) = (random.uniform(), random.uniform());
        let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
        a + (b - a) * u + (c - a) * v
    }

    /// A random ray, of any of the kinds in turn.
    pub(crate) fn ray(&self, i: u64, random: &mut Stream) -> Ray {
        let bounds = self.mesh.bounds();
        let (center, size) = (bounds.center(), bounds.diagonal().max(f32::MIN_POSITIVE));
        let near = center + in_cube(random) * 0.7 * size;
        let outside = center + direction(random) * 2.0 * size;
        let axis = Vec3::AXES[one_of(random, 3)] * if random.uniform() < 0.5 { -1.0 } else { 1.0 };
        match i % 13 {
            0 => aimed(outside, near),
            1 => aimed(near, center + in_cube(random) * 0.5 * size),
            2 => aimed(outside, self.surface(random)),
            // Along an axis, from anywhere, and through a corner exactly.
            3 => Ray::new(near, axis),
            4 => Ray::new(self.vertex(random) - axis * 2.0 * size, axis),
            5 => aimed(near, self.vertex(random)),
            // Along the edge of a triangle.
            6 => {
                let corners = self.mesh.triangle(one_of(random, self.mesh.len())).corners;
                let way = (corners[1] - corners[0]).try_normalize().unwrap_or(axis);
                Ray::new(corners[0] - way * size * random.uniform(), way)
            }
            // Inside the face of a cell, and along its edge.
            7 | 8 => {
                let cell = self.cells[one_of(random, self.cells.len())];
                let face = one_of(random, 3);
                let mut ray = aimed(near, self.surface(random));
                ray.origin[face] = cell.min[face];
                ray.direction[face] = if random.uniform() < 0.5 { 0.0 } else { -0.0 };
                if i % 13 == 8 {
                    let next = (face + 1) % 3;
                    ray.origin[next] = cell.max[next];
                    ray.direction[next] = 0.0;
                }
                let direction = ray.direction.try_normalize().unwrap_or(Vec3::AXES[(face + 2) % 3]);
                Ray::new(ray.origin, direction)
            }
            // From a point of a surface, as bounces are.
            9 => Ray::new(self.surface(random), direction(random)),
            // From far away.
            10 => aimed(center + direction(random) * size * magnitude(random, 10.0, 1e4), self.surface(random)),
            // From a hair above or below a surface, as it is left by an offset, along the surface or away from it.
            11 => {
                let corners = self.mesh.triangle(one_of(random, self.mesh.len())).corners;
                let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).try_normalize().unwrap_or(axis);
                let flat = [0.0, 1e-3, 1.0][one_of(random, 3)];
                let way =
                    direction(random).reject_from_normalized(normal) + normal * (flat * between(random, -1.0, 1.0));
                let aside = normal * (size * magnitude(random, 1e-8, 1e-5));
                Ray::new(self.surface(random) + aside, way.try_normalize().unwrap_or(normal))
            }
            // Nearly along an axis, not of unit length.
            _ => {
                let tilt = in_cube(random) * magnitude(random, 1e-12, 1e-2);
                Ray::new(near, (axis + tilt) * between(random, 0.1, 10.0))
            }
        }
    }
}
