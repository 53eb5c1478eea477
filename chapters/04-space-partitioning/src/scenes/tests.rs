//! Tests of all generators, and of the bodies that they are made of.

use common::{Vec2, Vec3};
use ray_casting::frame::Frame;

use super::{GENERATORS, ball, builder::Builder, cuboid};
use crate::model::Model;

/// Numbers of triangles that are asked for, and by what factor the result may differ.
const SIZES: [(u32, f32); 7] =
    [(100, 2.0), (300, 2.0), (1000, 1.15), (3000, 1.15), (10_000, 1.15), (30_000, 1.15), (100_000, 1.15)];

/// The bits of all positions.
fn bits(model: &Model) -> Vec<[u32; 3]> {
    model.mesh.positions.iter().map(|position| position.to_array().map(f32::to_bits)).collect()
}

#[test]
fn scenes_have_about_the_wanted_size() {
    for generator in GENERATORS {
        for (wanted, factor) in SIZES {
            let count = (generator.make)(wanted).mesh.triangles.len() as f32;
            let ratio = count / wanted as f32;
            assert!((factor.recip()..=factor).contains(&ratio), "{}: {count} of {wanted}", generator.name);
        }
    }
}

#[test]
fn scenes_are_whole() {
    for generator in GENERATORS {
        for (wanted, _) in SIZES {
            let Model { mesh, parts, view, .. } = (generator.make)(wanted);
            let name = format!("{} of {wanted}", generator.name);
            // All vertices are somewhere, and all corners are vertices.
            assert!(mesh.positions.iter().all(|position| position.is_finite()), "{name}");
            assert!(mesh.triangles.iter().flatten().all(|&i| (i as usize) < mesh.positions.len()), "{name}");
            assert!(mesh.triangles.iter().all(|[a, b, c]| a != b && b != c && c != a), "{name}");
            // Nearly all triangles have an area.
            let flat = |&[a, b, c]: &[u32; 3]| {
                let [a, b, c] = [a, b, c].map(|i| mesh.positions[i as usize].as_dvec3());
                (b - a).cross(c - a).length() <= 0.0
            };
            let degenerate = mesh.triangles.iter().filter(|corners| flat(corners)).count();
            assert!(degenerate * 1000 <= mesh.triangles.len(), "{name}: {degenerate} without area");
            // Parts follow each other from the first triangle to the last, and none is empty.
            assert_eq!(parts[0].first, 0, "{name}");
            let ends = parts.iter().skip(1).map(|part| part.first).chain([mesh.triangles.len() as u32]);
            for (part, end) in parts.iter().zip(ends) {
                assert!(part.first < end, "{name}: {}", part.name);
            }
            // The eye sees something.
            assert!(view.eye.is_finite() && view.lookat.is_finite() && view.eye != view.lookat, "{name}");
        }
    }
}

#[test]
fn scenes_are_the_same_each_time() {
    for generator in GENERATORS {
        let (one, other) = ((generator.make)(10_000), (generator.make)(10_000));
        assert_eq!(bits(&one), bits(&other), "{}", generator.name);
        assert_eq!(one.mesh.triangles, other.mesh.triangles, "{}", generator.name);
        assert_eq!(one.parts, other.parts, "{}", generator.name);
    }
}

/// Six times the volume inside a closed mesh: positive if its triangles face outward.
fn volume(builder: &Builder) -> f32 {
    let at = |i: u32| builder.mesh.positions[i as usize];
    builder.mesh.triangles.iter().map(|&[a, b, c]| at(a).cross(at(b)).dot(at(c))).sum()
}

#[test]
fn closed_bodies_face_outward() {
    let frame = Frame::at(Vec3::new(0.1, 0.2, 0.3)).turned(Vec3::Y, 30.0);
    let profile = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Vec2::from);
    let bodies: [&dyn Fn(&mut Builder); 7] = [
        &|b| b.cuboid(&frame, Vec3::ZERO, Vec3::ONE),
        &|b| b.beam(Vec3::ZERO, Vec3::new(1.0, 2.0, 3.0), 1.0),
        &|b| b.ball(Vec3::ONE, 1.0, 4),
        &|b| b.cushion(&frame, Vec3::ZERO, Vec3::splat(0.5), [12, 8], 4.0),
        &|b| b.turned(&frame, &profile, 8),
        &|b| b.turned_around(Vec3::ONE, Vec3::new(0.6, 0.0, 0.8), &profile, 8),
        &|b| b.prism(&frame, &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(Vec2::from), 0.0, 1.0),
    ];
    for body in bodies {
        let mut builder = Builder::default();
        body(&mut builder);
        assert!(volume(&builder) > 1.0);
    }
}

#[test]
fn the_costs_are_as_said() {
    let frame = Frame::at(Vec3::ZERO);
    // Two tips, and a ring between.
    let profile = [Vec2::ZERO, Vec2::ONE, 2.0 * Vec2::Y];
    let cost = |make: &dyn Fn(&mut Builder)| {
        let mut builder = Builder::default();
        make(&mut builder);
        builder.count()
    };
    assert_eq!(cost(&|b| b.cuboid(&frame, Vec3::ZERO, Vec3::ONE)), cuboid::COST);
    assert_eq!(cost(&|b| b.beam(Vec3::ZERO, Vec3::ONE, 0.1)), cuboid::COST);
    assert_eq!(cost(&|b| b.ball(Vec3::ZERO, 1.0, 3)), ball::cost(3));
    assert_eq!(cost(&|b| b.closed_surface([5, 4], |p| p)), 2 * 5 * 3);
    assert_eq!(cost(&|b| b.turned(&frame, &profile, 7)), 2 * 7);
    assert_eq!(cost(&|b| b.turned_around(Vec3::ONE, Vec3::X, &profile, 7)), 2 * 7);
    assert_eq!(cost(&|b| b.bar(Vec3::ZERO, Vec3::Y, 0.1, 6)), 12);
    assert_eq!(cost(&|b| b.leaf(Vec3::ZERO, Vec3::X, Vec3::Y, true)), 4);
    assert_eq!(cost(&|b| b.prism(&frame, &[Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y], 0.0, 1.0)), 12);
}
