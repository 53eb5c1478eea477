//! The numbers of chapter 1.

use common::{Interval, Stream, Vec3};
use ray_casting::{
    implicit::{Heart, ImplicitSurface},
    mesh::{Mesh, Shading},
    quadratic::{self, Roots},
    ray::Ray,
    shape::Shape,
    sphere::Sphere,
    triangle::Triangle,
    triangle_barycentric::Shear,
};

use super::{Numbers, grouped, percent};
use crate::{
    exact::{Line, V},
    meshes::{asset, leaks_of_a_sphere},
    normals::{error_of_icosphere_normals, error_of_sphere_normals},
    rays::{aimed, direction, in_cube},
};

const RAYS: u32 = 100_000;

/// How many of [`RAYS`] rays at the unit sphere, from `distance` radii away in any direction and aimed at a disc around it of twice its
/// area, hit instead of missing or miss instead of hitting.
fn misjudged(distance: f32, roots: fn(&Sphere, &Ray) -> Roots) -> u32 {
    let sphere = Sphere::new(Vec3::ZERO, 1.0);
    let mut random = Stream::new(701, 0, 0);
    let is_misjudged = |_| {
        let eye = direction(&mut random) * distance;
        let aim = loop {
            let aim = in_cube(&mut random) * std::f32::consts::SQRT_2;
            let aim = aim - eye * (aim.dot(eye) / eye.length_squared());
            if aim.length_squared() < 2.0 {
                break aim;
            }
        };
        let ray = aimed(eye, aim);
        // In f64: does the ray pass the center at less than the radius?
        let line = Line::of(&ray);
        let hits = line.at(-line.origin.dot(line.direction)).length() < 1.0;
        roots(&sphere, &ray).first_in(Interval::POSITIVE).is_some() != hits
    };
    (0..RAYS).map(is_misjudged).map(u32::from).sum()
}

/// Rays aimed at triangles a thousand times longer than high: how many are misjudged by edges, by barycentric
/// coordinates.
fn misjudged_thin_triangles() -> [u32; 2] {
    let mut random = Stream::new(702, 0, 0);
    let mut misjudged = [0; 2];
    for _ in 0..RAYS {
        let [r1, r2] = [(); 2].map(|()| in_cube(&mut random));
        let aside = (r2 - r1).cross(direction(&mut random)).normalize() * (r2 - r1).length() / 1000.0;
        let r3 = r1 + (r2 - r1) * random.uniform() + aside;
        let triangle = Triangle::new(r1, r2, r3);
        // Aim at the triangle or beside it, up to its height away.
        let aim = r1 + (r2 - r1) * random.uniform() + aside * (3.0 * random.uniform() - 1.0);
        let ray = aimed(aim + direction(&mut random) * 4.0, aim);
        // In f64: does the ray pass each edge on the same side?
        let line = Line::of(&ray);
        let [a, b, c] = triangle.corners.map(|r| V::from(r) - line.origin);
        let turns = [a.cross(b), b.cross(c), c.cross(a)].map(|n| n.dot(line.direction) > 0.0);
        let hits = turns[0] == turns[1] && turns[1] == turns[2];
        let by_edges = triangle.hit_by_edges(&ray, Interval::POSITIVE).is_some();
        let by_barycentric = triangle.hit_by_barycentric(&Shear::along(&ray), Interval::POSITIVE).is_some();
        misjudged[0] += u32::from(by_edges != hits);
        misjudged[1] += u32::from(by_barycentric != hits);
    }
    misjudged
}

/// Rays at the pawn: how many hit it, and for how many both ways do not find the same triangle.
fn disagreements() -> [u32; 2] {
    let mesh = Mesh::new(&asset("pawn.obj"), Shading::Flat).unwrap();
    let triangles: Vec<_> = mesh.triangles().collect();
    let mut random = Stream::new(703, 0, 0);
    let [mut hits, mut differ] = [0; 2];
    for _ in 0..20_000 {
        let ray = aimed(direction(&mut random) * 5.0, Vec3::Y + in_cube(&mut random));
        let along = Shear::along(&ray);
        let nearest = |hit: &dyn Fn(&Triangle) -> Option<f32>| {
            let hits = triangles.iter().enumerate().filter_map(|(i, triangle)| Some((hit(triangle)?, i)));
            hits.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, i)| i)
        };
        let by_edges = nearest(&|triangle| triangle.hit_by_edges(&ray, Interval::POSITIVE));
        let by_barycentric = nearest(&|t| t.hit_by_barycentric(&along, Interval::POSITIVE).map(|hit| hit.t));
        hits += u32::from(by_barycentric.is_some());
        differ += u32::from(by_edges != by_barycentric);
    }
    [hits, differ]
}

/// How many of 10,000 rays that hit the heart are lost by a march of this step.
fn lost_by_march(step: f32) -> [u32; 2] {
    let heart = |step| ImplicitSurface { function: Heart, bound: Sphere::new(Vec3::ZERO, 1.6), step };
    let (fine, coarse) = (heart(0.005), heart(step));
    let mut random = Stream::new(704, 0, 0);
    let [mut hits, mut lost] = [0; 2];
    while hits < 10_000 {
        let ray = aimed(direction(&mut random) * 5.0, in_cube(&mut random) * 1.2);
        if fine.intersect(&ray, Interval::POSITIVE).is_some() {
            hits += 1;
            lost += u32::from(coarse.intersect(&ray, Interval::POSITIVE).is_none());
        }
    }
    [lost, hits]
}

pub(super) fn measured() -> String {
    let mut numbers = Numbers::titled("Numbers in the text of chapter 1, made by tests/course/numbers.rs.");

    numbers
        .about("Rays at the unit sphere from 10³, 3·10³, 10⁴ radii away, aimed at a disc of twice its area: share of");
    numbers.0.push_str("# those that hit instead of missing or miss instead of hitting, by either formula.\n");
    for (name, distance) in [("1e3", 1e3), ("3e3", 3e3), ("1e4", 1e4)] {
        let textbook = misjudged(distance, Sphere::roots_textbook);
        numbers.pin(&format!("far-sphere-textbook-{name}"), percent(textbook, RAYS));
        numbers.pin(&format!("far-sphere-stable-{name}"), percent(misjudged(distance, Sphere::roots), RAYS));
    }

    numbers.about("The smaller root of t² − 2·10⁴ t + 1.");
    numbers.pin("small-root-exact", format!("{:.15}", 1.0 / (1e4 + (1e8_f64 - 1.0).sqrt())));
    numbers.pin("small-root-textbook", quadratic::solve_textbook(1.0, -2e4, 1.0).0[0]);
    numbers.pin("small-root-stable", quadratic::solve(1.0, -1e4, 1.0, 1e8 - 1.0).0[0]);

    numbers.about("Triangles in the meshes.");
    for name in ["pawn", "gem"] {
        let mesh = Mesh::new(&asset(&format!("{name}.obj")), Shading::Flat).unwrap();
        numbers.pin(&format!("{name}-triangles"), mesh.len());
    }

    numbers
        .about("Rays from inside a closed sphere of 20,480 triangles, aimed at edges and corners; how many leave it.");
    let leaks = leaks_of_a_sphere();
    numbers.pin("edge-rays", grouped(leaks.rays));
    numbers.pin("edge-leaks-by-edges", grouped(leaks.by_edges));
    numbers.pin("edge-leaks-by-barycentric", leaks.by_barycentric);

    numbers.about("Rays at triangles a thousand times longer than high: share misjudged.");
    let [by_edges, by_barycentric] = misjudged_thin_triangles();
    numbers.pin("thin-triangle-by-edges", percent(by_edges, RAYS));
    numbers.pin("thin-triangle-by-barycentric", percent(by_barycentric, RAYS));

    numbers.about(
        "Of 20,000 random rays at the pawn: how many hit it, and how many find another triangle by the other way.",
    );
    let [hits, differ] = disagreements();
    numbers.pin("pawn-hits", grouped(hits));
    numbers.pin("pawn-disagreements", differ);

    numbers.about("Rays that hit the heart: share lost by a march of this step.");
    for step in [0.02, 0.1, 0.5] {
        let [lost, hits] = lost_by_march(step);
        numbers.pin(&format!("heart-lost-at-{step}"), percent(lost, hits));
    }

    numbers.about("Greatest angle between a computed normal and the true one, at hits of a unit sphere.");
    numbers.pin("sphere-normal-error", format!("{:.6}°", error_of_sphere_normals()));

    numbers
        .about("Greatest angle between the normals of a sphere of triangles and the radius, shaded flat and smooth.");
    for (levels, triangles) in [(2, 320), (3, 1280)] {
        let [flat, smooth] = error_of_icosphere_normals(levels);
        numbers.pin(&format!("flat-normal-error-{triangles}"), format!("{flat:.1}°"));
        numbers.pin(&format!("smooth-normal-error-{triangles}"), format!("{smooth:.1}°"));
    }
    numbers.0
}
