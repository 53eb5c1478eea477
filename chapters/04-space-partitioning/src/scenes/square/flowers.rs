//! Flowers in pots and window boxes, and creepers on the walls.

use common::{Rgb, Vec3, color::srgb};
use ray_casting::{frame::Frame, material::Phong};

use super::{FAR, FOUNTAIN, SIDES, houses::House};
use crate::scenes::{
    budget::{number, ratio, share},
    builder::Builder,
    chance::Chance,
    foliage::{Cloud, leaf_length},
};

/// Fewest triangles of a thing with flowers.
const FEWEST: u32 = 130;

/// Pots beside the doors and around the fountain, boxes under the windows above.
pub(super) fn pots(builder: &mut Builder, houses: &[House], triangles: u32) {
    let mut pots: Vec<Vec3> = vec![];
    for i in 0..6 {
        let frame = Frame::at(FOUNTAIN).turned(Vec3::Y, 60.0 * ratio(i, 1) + 20.0);
        pots.push(frame.point_to_world(Vec3::new(0.0, 0.0, 2.25)));
    }
    for house in houses {
        for side in [-1.05, 1.05] {
            pots.push(house.frame.point_to_world(Vec3::new(house.column(house.door) + side, 0.0, 0.4)));
        }
    }
    let mut boxes: Vec<(Frame, Vec3)> = vec![];
    for house in houses {
        for floor in 1..house.floors {
            for column in 0..house.columns {
                boxes.push((house.frame, Vec3::new(house.column(column), house.floor(floor) + 0.78, 0.2)));
            }
        }
    }
    let number = number(triangles, FEWEST, [0, u32::try_from(pots.len() + boxes.len()).unwrap_or(0)]);
    // Half of them on the ground, while there are few.
    let on_ground = (number.div_ceil(2) as usize).min(pots.len());
    pots.truncate(on_ground);
    boxes.truncate(number as usize - on_ground);
    let each = triangles / number.max(1);
    builder.part("pots", Phong::of(srgb(186, 100, 64), 0.0, 1.0));
    let sides = crate::scenes::budget::number(share(each, 0.25).min(900), 14, [4, 64]);
    for &place in &pots {
        builder.pot(&Frame::at(place), 0.24, 0.36, sides);
    }
    builder.part("window boxes", Phong::of(srgb(150, 104, 72), 0.0, 1.0));
    for (frame, middle) in &boxes {
        let half = Vec3::new(0.45, 0.09, 0.1);
        builder.cuboid(frame, *middle - half, *middle + half);
    }
    // Their plants.
    let mut clouds: Vec<Cloud> = vec![];
    for &place in &pots {
        clouds.push(Cloud { center: place + Vec3::Y * 0.52, half: Vec3::splat(0.3) });
    }
    for (frame, middle) in &boxes {
        let half = frame.vector_to_world(Vec3::new(0.46, 0.17, 0.16)).abs();
        clouds.push(Cloud { center: frame.point_to_world(*middle + Vec3::new(0.0, 0.18, 0.02)), half });
    }
    let left = share(each, 0.72) * number;
    bed(
        builder,
        &clouds,
        left,
        &[
            ("geranium leaves", srgb(78, 130, 62), 0.6),
            ("red flowers", srgb(206, 42, 44), 0.25),
            ("pink flowers", srgb(232, 120, 150), 0.15),
        ],
    );
}

/// Creepers: ivy up two houses, and one that blooms beside the alley.
pub(super) fn creepers(builder: &mut Builder, triangles: u32) {
    if triangles < FEWEST / 2 {
        return;
    }
    let mut chance = Chance::of("shoots", 0);
    // Each climbs from its foot in several shoots that stray.
    const SHOOTS: u32 = 7;
    const STEPS: u32 = 14;
    let mut climb = |foot: Vec3, along: Vec3, height: f32, wide: f32| {
        let mut clouds = vec![];
        for shoot in 0..SHOOTS {
            let lean = wide * (2.0 * ratio(shoot, SHOOTS - 1) - 1.0) + chance.around(0.3);
            let reach = height * chance.between(0.5, 1.0);
            let mut stray = 0.0;
            for step in 0..STEPS {
                let t = ratio(step, STEPS);
                stray += chance.around(0.16);
                let center = foot + along * (lean * (t + 0.15) + stray) + Vec3::Y * (reach * t + 0.2);
                let size = 0.34 - 0.18 * t;
                let half = (along.abs() + Vec3::Y) * size + along.cross(Vec3::Y).abs() * 0.11;
                clouds.push(Cloud { center, half });
            }
        }
        clouds
    };
    let mut ivy = climb(Vec3::new(2.0, 0.0, FAR + 0.08), Vec3::X, 6.2, 1.5);
    ivy.extend(climb(Vec3::new(SIDES[0] + 0.08, 0.0, -9.7), Vec3::Z, 7.4, 1.7));
    let bougainvillea = climb(Vec3::new(-5.0, 0.0, FAR + 0.1), Vec3::X, 8.2, 1.3);
    bed(builder, &ivy, share(triangles, 0.6), &[("ivy", srgb(70, 116, 54), 0.6), ("dark ivy", srgb(46, 88, 46), 0.4)]);
    bed(
        builder,
        &bougainvillea,
        share(triangles, 0.4),
        &[("leaves of the bougainvillea", srgb(82, 126, 60), 0.45), ("bougainvillea", srgb(204, 52, 122), 0.55)],
    );
}

/// Leaves and flowers that share clouds, each kind with its share.
fn bed(builder: &mut Builder, clouds: &[Cloud], triangles: u32, kinds: &[(&'static str, Rgb, f32)]) {
    let fine = triangles > 200_000;
    let cost = if fine { 4 } else { 2 };
    let area: f32 = clouds.iter().map(|cloud| cloud.half.length_squared() * 2.8).sum();
    let length = leaf_length(area, triangles / cost).clamp(0.012, 0.22);
    for &(name, color, part) in kinds {
        builder.part(name, Phong::of(color, 0.08, 18.0));
        if !clouds.is_empty() {
            builder.leaves(clouds, share(triangles, part) / cost, length, fine, &mut Chance::of(name, 0));
        }
    }
}
