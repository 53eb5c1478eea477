//! The garden of the court: plants and small orange trees in pots.

use common::{Vec3, color::srgb};
use ray_casting::{frame::Frame, material::Phong};

use super::{FAR, HALF_WIDTH};
use crate::scenes::{
    budget::{number, ratio, share},
    builder::Builder,
    chance::Chance,
    foliage::{Cloud, leaf_length},
};

/// A plant in its pot.
struct Plant {
    place: Vec3,
    /// Radius of the pot.
    pot: f32,
    /// Height of the stem; bushes have none.
    stem: f32,
    /// Half the width of its foliage.
    wide: f32,
}

/// Where plants stand: orange trees around the fountain and before the far arcade, bushes along the sides.
fn places() -> Vec<Plant> {
    let mut plants: Vec<Plant> = [[-2.5, -7.0], [2.5, -11.0], [-2.5, -11.0], [2.5, -7.0], [-2.9, -16.6], [2.9, -16.6]]
        .into_iter()
        .map(|[x, z]| Plant { place: Vec3::new(x, 0.0, z), pot: 0.36, stem: 1.35, wide: 0.66 })
        .collect();
    for i in 0..5 {
        for side in [1.0, -1.0] {
            let place = Vec3::new(side * (HALF_WIDTH - 0.45), 0.0, FAR * (ratio(i, 6) + 1.0 / 6.0));
            plants.push(Plant { place, pot: 0.25, stem: 0.0, wide: 0.36 });
        }
    }
    plants
}

/// Plants in pots, with as many leaves as bring the court to its size.
pub(super) fn plants(builder: &mut Builder, triangles: u32) {
    const FEWEST: u32 = 90;
    let left = builder.missing_to(triangles);
    let mut plants = places();
    plants.truncate(number(left, FEWEST, [1, 16]) as usize);
    let each = left / u32::try_from(plants.len()).unwrap_or(1);
    let sides = number(share(each, 0.15), 14, [4, 64]);
    builder.part("pots", Phong::of(srgb(184, 98, 62), 0.0, 1.0));
    if left >= FEWEST {
        for plant in &plants {
            builder.pot(&Frame::at(plant.place), plant.pot, plant.pot * 1.5, sides);
        }
    }
    builder.part("stems", Phong::of(srgb(112, 88, 62), 0.0, 1.0));
    let mut clouds = vec![];
    let mut chance = Chance::of("crowns", 0);
    for plant in &plants {
        let top = plant.place + Vec3::Y * (plant.pot * 1.5 + plant.stem);
        if plant.stem > 0.0 && left >= FEWEST {
            builder.bar(plant.place + Vec3::Y * plant.pot, top, 0.035, sides.min(24));
        }
        let middle = top + Vec3::Y * plant.wide * if plant.stem > 0.0 { 0.5 } else { 0.85 };
        clouds.push(Cloud { center: middle, half: Vec3::splat(plant.wide) });
        // Trees have twice the leaves, in lumps around the first cloud.
        let lumps = if plant.stem > 0.0 { 5 } else { 1 };
        for _ in 0..lumps {
            let out = chance.direction() * Vec3::new(0.6, 0.45, 0.6);
            clouds.push(Cloud { center: middle + out * plant.wide, half: Vec3::splat(plant.wide * 0.52) });
        }
    }
    oranges(builder, &plants, share(each, 0.1));
    leaves(builder, &clouds, builder.missing_to(triangles));
}

/// Oranges in the crowns of the trees.
fn oranges(builder: &mut Builder, plants: &[Plant], each: u32) {
    const ON_A_TREE: u32 = 14;
    builder.part("oranges", Phong::of(srgb(240, 136, 30), 0.25, 30.0));
    let steps = match each / ON_A_TREE {
        0..16 => return,
        16..60 => [4, 3],
        60..200 => [6, 4],
        _ => [10, 8],
    };
    let mut chance = Chance::of("oranges", 0);
    for plant in plants.iter().filter(|plant| plant.stem > 0.0) {
        let middle = plant.place + Vec3::Y * (plant.pot * 1.5 + plant.stem + plant.wide * 0.5);
        for _ in 0..ON_A_TREE {
            let place = middle + chance.direction() * (plant.wide * chance.between(0.86, 1.04));
            builder.closed_surface(steps, |p| place + p * 0.062);
        }
    }
}

/// All leaves, in two greens.
fn leaves(builder: &mut Builder, clouds: &[Cloud], triangles: u32) {
    let fine = triangles > 24_000;
    let leaves = triangles / if fine { 4 } else { 2 };
    let area: f32 = clouds.iter().map(|cloud| cloud.half.length_squared() * 4.2).sum();
    let length = leaf_length(area, leaves).clamp(0.01, 0.2);
    let colors = [("leaves", srgb(82, 134, 58)), ("dark leaves", srgb(46, 98, 50))];
    for (name, color) in colors {
        builder.part(name, Phong::of(color, 0.15, 20.0));
        builder.leaves(clouds, leaves / 2, length, fine, &mut Chance::of(name, 0));
    }
}
