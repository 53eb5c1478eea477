//! The sphere flake: each ball carries nine smaller ones.
//!
//! Source: Haines, *A Proposal for Standard Graphics Environments*, IEEE CG&A 7(11), 1987: the database 'balls'.

use common::{Basis, Rgb, Vec3, color::srgb};
use ray_casting::{
    light::{DirectionalLight, PointLight},
    material::Phong,
    mesh::Shading,
};

use super::{
    Generator, ball,
    budget::{number, share},
    builder::Builder,
};
use crate::model::{Model, View};

/// Balls that carry balls that carry balls.
pub const GENERATOR: Generator = Generator { name: "sphere-flake", full_size: 1_000_000, make };

/// Number of smaller balls on each ball.
const CHILDREN: u32 = 9;
/// Their radius, for a parent of radius 1.
const SHRINK: f32 = 1.0 / 3.0;
/// Name and color of the balls of each generation; later ones begin again from the second.
const GENERATIONS: [(&str, [u8; 3]); 6] = [
    ("first ball", [38, 66, 122]),
    ("balls of the 2nd generation", [30, 122, 138]),
    ("balls of the 3rd generation", [226, 158, 62]),
    ("balls of the 4th generation", [196, 68, 60]),
    ("balls of the 5th generation", [244, 222, 186]),
    ("balls of the 6th generation", [72, 148, 150]),
];

/// A ball and the direction from its parent.
#[derive(Clone, Copy)]
struct Ball {
    center: Vec3,
    radius: f32,
    axis: Vec3,
}

/// The scene with about so many triangles.
fn make(triangles: u32) -> Model {
    let mut builder = Builder::default();
    builder.reserve(triangles);

    // The room.
    builder.part("backdrop", Phong::of(srgb(206, 198, 190), 0.0, 1.0));
    builder.backdrop(44.0, 9.0, 16.0, number(triangles, 120, [5, 14]));

    // The balls, generation after generation.
    let finenesses = finenesses(builder.missing_to(triangles));
    let mut balls = vec![Ball { center: Vec3::Y, radius: 1.0, axis: Vec3::Y }];
    for (i, (&fineness, (name, [red, green, blue]))) in finenesses.iter().zip(GENERATIONS).enumerate() {
        if i > 0 {
            balls = balls.into_iter().flat_map(children).collect();
        }
        builder.part(name, Phong::of(srgb(red, green, blue), 0.45, 60.0));
        for ball in &balls {
            builder.ball(ball.center, ball.radius, fineness);
        }
    }

    Model {
        mesh: builder.mesh,
        shading: Shading::Smooth,
        parts: builder.parts,
        view: View { eye: Vec3::new(1.3, 3.1, 5.6), lookat: Vec3::new(0.12, 1.12, 0.0), field_of_view: 31.0 },
        lights: vec![
            Box::new(DirectionalLight::new(Vec3::new(-0.75, 1.0, 0.55), Rgb::new(2.5, 2.25, 1.9))),
            Box::new(PointLight { position: Vec3::new(5.0, 3.5, 4.0), intensity: Rgb::new(14.0, 20.0, 27.0) }),
        ],
        ambient: Rgb::new(0.16, 0.18, 0.22),
        background: srgb(150, 146, 146),
    }
}

/// How finely the balls of each generation are cut, so that all together have about so many triangles.
fn finenesses(triangles: u32) -> Vec<u32> {
    // As many generations as can be round: balls of the last one take a little more than half.
    let last = share(triangles, 0.66);
    let round = |generation: u32| ball::cost(if generation > 2 { 2 } else { 1 });
    let mut deepest = 1;
    while deepest + 1 < GENERATIONS.len() as u32 && CHILDREN.pow(deepest + 1) * round(deepest + 1) <= last {
        deepest += 1;
    }
    // From the last to the first, since what the many leave over the few can use.
    let mut missing = triangles;
    let mut all = Vec::new();
    for generation in (0..=deepest).rev() {
        let count = CHILDREN.pow(generation);
        let budget = match generation {
            _ if generation == deepest && generation > 0 => last,
            0 => missing,
            _ => missing / 2,
        };
        let fineness = ball::fineness(budget, count);
        missing = missing.saturating_sub(count * ball::cost(fineness));
        all.push(fineness);
    }
    all.reverse();
    all
}

/// The nine balls on a ball: six around it and three above, as in the densest packing.
fn children(parent: Ball) -> impl Iterator<Item = Ball> {
    let basis = Basis::around(parent.axis);
    let (around, above) = (3_f32.sqrt() / 2.0, (2.0_f32 / 3.0).sqrt());
    // A hexagon, and a triangle over every other of its sides.
    let hexagon = [(1.0, 0.0), (0.5, around), (-0.5, around), (-1.0, 0.0), (-0.5, -around), (0.5, -around)];
    let low = hexagon.map(|(x, y)| Vec3::new(x, y, 0.0));
    let high = [0, 2, 4].map(|i| (low[i] + low[i + 1]) / 3.0 + Vec3::Z * above);
    low.into_iter().chain(high).map(move |direction| {
        let axis = basis.to_world(direction).normalize_or(Vec3::Y);
        let radius = parent.radius * SHRINK;
        Ball { center: parent.center + axis * (parent.radius + radius), radius, axis }
    })
}
