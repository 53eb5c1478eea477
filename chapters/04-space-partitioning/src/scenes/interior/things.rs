//! What else is in the room: curtains, lamps, a globe, plants.

use common::{Vec2, Vec3, color::srgb, float};
use ray_casting::{frame::Frame, material::Phong};

use super::{FAR, HALF_WIDTH, HEIGHT, LAMPS, NEAR, brass, wood};
use crate::scenes::{
    budget::{grid, number, ratio, share},
    builder::Builder,
    chance::Chance,
    foliage::{Cloud, leaf_length},
};

/// Curtains on both sides of each window to the sun.
pub(super) fn curtains(builder: &mut Builder, triangles: u32) {
    const FEWEST: u32 = 40;
    builder.part("curtains", Phong::of(srgb(158, 62, 44), 0.0, 1.0));
    let windows = number(triangles, 2 * FEWEST, [0, 4]);
    let length = (NEAR - FAR) / 4.0;
    for i in (0..windows).map(|i| 3 - i) {
        let z = NEAR - length * (ratio(i, 1) + 0.5);
        for side in [-1.0, 1.0] {
            let frame = Frame::at(Vec3::new(-HALF_WIDTH + 0.12, 0.0, z + side * 1.05)).turned(Vec3::Y, 90.0);
            let [low, high] = [Vec2::new(-0.26, 0.05), Vec2::new(0.26, 3.3)];
            let mut chance = Chance::of("curtains", 2 * i + u32::from(side > 0.0));
            builder.drapery(&frame, low, high, 4.5, triangles / (2 * windows), &mut chance);
        }
    }
}

/// Lamps over the table: white inside, brass outside.
pub(super) fn lamps(builder: &mut Builder, triangles: u32) {
    const WIDE: f32 = 0.34;
    const HIGH: f32 = 0.24;
    const THIN: f32 = 0.008;
    let hung = number(triangles, 18, [0, 3]);
    let [sides, steps] = grid(triangles / (2 * hung.max(1)), 3.0, [4, 1]);
    let steps = steps.max(2);
    let dome = |t: f32, wide: f32| {
        let angle = std::f32::consts::FRAC_PI_2 * t;
        Vec2::new((wide * float::cos(angle)).max(0.025), HIGH * float::sin(angle))
    };
    let lamps = || LAMPS.into_iter().zip(0..hung).map(|(lamp, _)| lamp);
    builder.part("lamps inside", Phong::of(srgb(250, 244, 230), 0.0, 1.0));
    for lamp in lamps() {
        let profile: Vec<Vec2> = (0..=steps).rev().map(|i| dome(ratio(i, steps), WIDE - THIN)).collect();
        builder.turned(&Frame::at(lamp), &profile, sides);
    }
    builder.part("lamps", brass());
    for lamp in lamps() {
        let profile: Vec<Vec2> = (0..=steps).map(|i| dome(ratio(i, steps), WIDE)).collect();
        builder.turned(&Frame::at(lamp), &profile, sides);
        builder.bar(lamp + Vec3::Y * HIGH, lamp.with_y(HEIGHT), 0.012, 6.min(sides));
    }
}

/// A globe on a stand beside the shelves.
pub(super) fn globe(builder: &mut Builder, triangles: u32) {
    let place = Vec3::new(2.55, 0.0, -3.4);
    builder.part("globe", Phong::of(srgb(70, 122, 150), 0.5, 50.0));
    let steps = grid(share(triangles, 0.35), 2.0, [4, 3]);
    if triangles < 200 {
        return;
    }
    builder.closed_surface(steps, |p| place + Vec3::Y * 1.05 + p * 0.26);
    // Land stands a little higher than the sea, and like it.
    builder.part("land of the globe", Phong::of(srgb(168, 150, 96), 0.3, 40.0));
    builder.closed_surface(steps, |p| {
        let wave = |p: Vec3| {
            float::sin(3.1 * p.x + 1.0) * float::cos(2.7 * p.z + 2.0 * p.y) + float::sin(4.3 * p.y + 2.9 * p.z)
        };
        let height = 0.55 * wave(p) + 0.25 * wave(2.3 * p) - 0.12;
        place + Vec3::Y * 1.05 + p * (0.26 + 0.008 * height.clamp(-1.0, 0.4))
    });
    builder.part("stand of the globe", brass());
    let [around, sides] = grid(share(triangles, 0.25), 3.0, [8, 3]);
    let ring: Vec<Vec3> = (0..=around)
        .map(|i| std::f32::consts::TAU * ratio(i, around))
        .map(|a| place + Vec3::Y * 1.05 + Vec3::new(float::cos(a), float::sin(a), 0.25 * float::cos(a)) * 0.3)
        .collect();
    builder.tube(&ring, sides, |_| 0.014);
    let profile = [[0.24, 0.0], [0.24, 0.03], [0.05, 0.07], [0.03, 0.3], [0.05, 0.45], [0.02, 0.5], [0.02, 0.78]];
    builder.turned(&Frame::at(place), &profile.map(Vec2::from), number(share(triangles, 0.15), 12, [4, 500]));
}

/// Plants in pots whose leaves bring the room to its size.
pub(super) fn plants(builder: &mut Builder, triangles: u32) {
    let places = [Vec3::new(-1.75, 0.0, FAR + 0.75), Vec3::new(-3.35, 0.0, -2.2), Vec3::new(1.8, 0.0, FAR + 0.8)];
    let left = builder.missing_to(triangles);
    let plants = number(left, 100, [0, 3]);
    let places = || places.into_iter().zip(0..plants).map(|(place, _)| place);
    let sides = number(left / 10, 14 * plants.max(1), [5, 96]);
    builder.part("pots", Phong::of(srgb(178, 96, 62), 0.0, 1.0));
    for place in places() {
        builder.pot(&Frame::at(place), 0.27, 0.42, sides);
    }
    builder.part("stems", wood(srgb(104, 82, 58)));
    let mut clouds = vec![];
    for (place, i) in places().zip(0..) {
        let mut chance = Chance::of("stems", i);
        for stem in 0..5 {
            let reach = Vec3::new(chance.around(0.42), chance.between(1.05, 1.75), chance.around(0.36));
            let bend = Vec3::new(chance.around(0.1), 0.0, chance.around(0.1));
            let line =
                [0.0_f32, 0.35, 0.7, 1.0].map(|t| place + Vec3::Y * 0.36 + (reach * t + bend * (t * (1.0 - t) * 4.0)));
            if left >= 400 || stem == 0 {
                builder.tube(&line, sides.min(12), |_| 0.016);
            }
            clouds.push(Cloud { center: line[3], half: Vec3::new(0.3, 0.34, 0.3) });
            clouds.push(Cloud { center: line[2], half: Vec3::new(0.22, 0.24, 0.22) });
        }
    }
    let left = builder.missing_to(triangles);
    let fine = left > 20_000;
    let leaves = left / if fine { 4 } else { 2 };
    let length = leaf_length(5.2, leaves / plants.max(1)).clamp(0.01, 0.22);
    let shares = [leaves / 2, leaves - leaves / 2];
    for (shade, (name, color)) in
        [("leaves", srgb(72, 122, 52)), ("dark leaves", srgb(44, 92, 44))].into_iter().enumerate()
    {
        builder.part(name, Phong::of(color, 0.12, 18.0));
        if !clouds.is_empty() {
            builder.leaves(&clouds, shares[shade], length, fine, &mut Chance::of(name, 0));
        }
    }
}
