//! The hair ball: thousands of thin curved hairs around a ball.

use common::{Rgb, Vec3, color::srgb, float};
use ray_casting::{
    light::{DirectionalLight, PointLight},
    material::Phong,
    mesh::Shading,
};

use super::{
    Generator, ball,
    budget::{number, share},
    builder::Builder,
    chance::Chance,
};
use crate::model::{Model, View};

/// A ball of hair.
pub const GENERATOR: Generator = Generator { name: "hair-ball", full_size: 2_900_000, make };

/// Radius of the ball that the hairs grow from, in decimeters.
const CORE: f32 = 0.72;
/// Where its center is.
const CENTER: Vec3 = Vec3::new(0.0, 1.36, 0.0);
/// Sides of a hair.
const SIDES: u32 = 3;
/// Length of a hair.
const LENGTH: f32 = 1.9;
/// Thickness of one of a thousand hairs; more hairs are thinner.
const THICKNESS: f32 = 0.03;
/// Number of hairs that lie side by side in a lock.
const LOCK: u32 = 18;
/// Seed of the random numbers.
const SEED: u64 = 4;
/// Name, color and share of the hairs, the outer ones last.
const STRANDS: [(&str, [u8; 3], f32); 4] = [
    ("dark hair", [84, 34, 24], 0.3),
    ("copper hair", [168, 74, 32], 0.3),
    ("amber hair", [214, 128, 54], 0.25),
    ("gold hair", [240, 190, 112], 0.15),
];

/// The scene with about so many triangles.
fn make(triangles: u32) -> Model {
    let mut builder = Builder::default();
    builder.reserve(triangles);

    // The room, and the ball inside.
    builder.part("backdrop", Phong::of(srgb(96, 116, 124), 0.0, 1.0));
    builder.backdrop(48.0, 9.0, 18.0, number(triangles, 120, [5, 14]));
    builder.part("core", Phong::of(srgb(58, 26, 22), 0.0, 1.0));
    builder.ball(CENTER, CORE, ball::fineness(share(triangles, 0.03), 1).clamp(1, 40));

    // The hairs: at four times as many triangles about 2.5 times as many hairs, each of 1.6 times as many pieces.
    let for_hairs = builder.missing_to(triangles);
    let pieces = (1.1 * float::pow(for_hairs as f32 / 100.0, 0.34)).clamp(3.0, 48.0) as u32;
    let hairs = (for_hairs / (2 * SIDES * pieces)).max(4);
    let thickness = (THICKNESS * float::pow(1000.0 / hairs as f32, 0.55)).min(0.15);
    let mut chance = Chance::numbered(SEED, 0);
    let mut line = Vec::with_capacity(pieces as usize + 1);
    let mut grown = 0;
    let mut until = 0.0;
    for (strand, (name, [red, green, blue], part)) in STRANDS.into_iter().enumerate() {
        builder.part(name, Phong::of(srgb(red, green, blue), 0.4, 30.0));
        until += part;
        let last = if strand + 1 == STRANDS.len() { hairs } else { ((hairs as f32 * until) as u32).max(grown + 1) };
        let mut lock = Lock::new(0.0, &mut chance);
        for hair in grown..last {
            // With few hairs, each is a lock of its own.
            if hair % (hairs / 400).clamp(1, LOCK) == 0 {
                lock = Lock::new(strand as f32 / STRANDS.len() as f32, &mut chance);
            }
            lock.hair(&mut line, pieces, &mut chance);
            let width = thickness * chance.between(0.7, 1.3) / 2.0;
            builder.tube(&line, SIDES, |i| width * (1.0 - 0.85 * i as f32 / pieces as f32));
        }
        grown = last;
    }

    Model {
        mesh: builder.mesh,
        shading: Shading::Smooth,
        parts: builder.parts,
        view: View { eye: Vec3::new(0.0, 2.3, 6.4), lookat: Vec3::new(0.0, 1.28, 0.0), field_of_view: 26.0 },
        lights: vec![
            Box::new(DirectionalLight::new(Vec3::new(-0.8, 1.1, 0.7), Rgb::new(2.9, 2.6, 2.2))),
            Box::new(PointLight { position: Vec3::new(1.1, 2.9, -3.4), intensity: Rgb::new(26.0, 30.0, 36.0) }),
            Box::new(PointLight { position: Vec3::new(3.4, 1.2, 4.6), intensity: Rgb::new(5.0, 7.0, 9.0) }),
        ],
        ambient: Rgb::new(0.1, 0.12, 0.15),
        background: srgb(60, 72, 78),
    }
}

/// Hairs that lie side by side.
struct Lock {
    /// Direction from the center to its root.
    root: Vec3,
    /// How far its tips stand off the core.
    lift: f32,
    /// How far it goes its own way, to the side of the others.
    aside: f32,
    /// Frequency and phase of its curls.
    curl: (f32, f32),
}

impl Lock {
    /// A lock anywhere; `outside` from 0 to 1 says how far it stands off.
    fn new(outside: f32, chance: &mut Chance) -> Self {
        Self {
            root: chance.on_sphere(),
            lift: chance.between(0.1, 0.3) + 0.26 * outside,
            aside: chance.around(0.35),
            curl: (chance.between(5.0, 9.0), chance.angle()),
        }
    }

    /// The points along one of its hairs. It leaves the core, and the flow that all hairs share combs it around the
    /// ball. The lock is wide at its root and narrow at its tip.
    fn hair(&self, line: &mut Vec<Vec3>, pieces: u32, chance: &mut Chance) {
        let beside = chance.on_sphere() * chance.between(0.02, 0.13);
        let lift = self.lift * chance.between(0.85, 1.15);
        let length = LENGTH * chance.between(0.8, 1.1);
        let mut out = self.root;
        line.clear();
        for i in 0..=pieces {
            let t = i as f32 / pieces as f32;
            // The hair rises steeply and then lies down.
            let radius = CORE + lift * (1.0 - (1.0 - t) * (1.0 - t));
            let place = (out + beside * (1.0 - 0.8 * t)).normalize_or(out);
            let wave = t * float::sin(self.curl.0 * t + self.curl.1);
            line.push(CENTER + place * (radius + 0.03 * wave));
            // Step along the flow, at right angles to the way out.
            let flow = flow(out);
            let step = flow + out.cross(flow) * (self.aside + 0.6 * wave);
            out = (out + step * (length / pieces as f32)).normalize_or(out);
        }
    }
}

/// The direction in which hair lies at a place of the unit sphere: along the contour lines of a hilly function, so that it
/// runs in whirls and no place becomes bald.
fn flow(out: Vec3) -> Vec3 {
    const WAVES: [(Vec3, f32); 4] = [
        (Vec3::new(2.1, 1.2, -0.6), 0.4),
        (Vec3::new(-0.9, 2.6, 1.3), 2.2),
        (Vec3::new(1.4, -0.8, 2.9), 4.9),
        (Vec3::new(-2.2, -1.7, 1.9), 1.1),
    ];
    let slope: Vec3 = WAVES.into_iter().map(|(wave, phase)| wave * float::cos(wave.dot(out) + phase)).sum();
    out.cross(slope).normalize_or(Vec3::ZERO)
}
