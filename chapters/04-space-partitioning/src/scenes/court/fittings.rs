//! What belongs to the building: doors, banners and lanterns.

use common::{Vec2, Vec3, color::srgb};
use ray_casting::{frame::Frame, material::Phong};

use super::{Bays, FAR, GALLERY, HALF_WIDTH};
use crate::scenes::{
    arches::Arch,
    budget::{grid, number, ratio, share},
    builder::Builder,
    chance::Chance,
};

/// Height of the lanterns' middles.
pub(super) const LANTERN: f32 = 3.35;
/// The doors of the galleries.
const DOOR: Arch = Arch { width: 1.5, bottom: 0.0, spring: 1.9, top: 3.0, radius: 0.68, depth: 0.0 };

/// A round-arched door behind each arch, framed by a molding.
pub(super) fn doors(builder: &mut Builder, bays: Bays, triangles: u32) {
    const FEWEST: u32 = 40;
    let frames = bays.frames();
    let each = triangles / u32::try_from(frames.len()).unwrap_or(1);
    if each < FEWEST {
        return;
    }
    let walls: Vec<Frame> = frames
        .iter()
        .map(|frame| {
            let at = Frame::at(frame.point_to_world(Vec3::new(0.0, 0.0, -GALLERY + 0.02)));
            match frame.vector_to_world(Vec3::Z).x {
                x if x > 0.5 => at.turned(Vec3::Y, 90.0),
                x if x < -0.5 => at.turned(Vec3::Y, -90.0),
                _ => at,
            }
        })
        .collect();
    builder.part("doors", Phong::of(srgb(74, 88, 82), 0.2, 20.0));
    let segments = number(each / 2, 4, [4, 64]);
    let mut outline: Vec<Vec2> = (0..=segments).map(|i| DOOR.over(ratio(i, segments), DOOR.radius)).collect();
    outline.extend([Vec2::new(-DOOR.radius, 0.0), Vec2::new(DOOR.radius, 0.0)]);
    for frame in &walls {
        builder.prism(frame, &outline, 0.0, 0.05);
    }
    builder.part("frames of the doors", Phong::of(srgb(222, 204, 172), 0.0, 1.0));
    let steps = grid(each / 3, 4.0, [5, 2]);
    for frame in &walls {
        builder.molding(frame, &DOOR, 0.07, steps);
        for x in [-0.75, 0.75] {
            builder.cuboid(frame, Vec3::new(x - 0.07, 0.0, 0.0), Vec3::new(x + 0.07, DOOR.spring, 0.08));
        }
    }
}

/// Banners that hang over the balustrades, in three colors.
pub(super) fn banners(builder: &mut Builder, bays: Bays, triangles: u32) {
    const FEWEST: u32 = 4;
    let colors = [
        ("crimson banners", srgb(158, 48, 48)),
        ("blue banners", srgb(52, 92, 140)),
        ("golden banners", srgb(214, 162, 74)),
    ];
    let number = number(triangles, FEWEST, [0, 2 * (bays.side - 1)]);
    let each = triangles / number.max(1);
    for (color, (name, albedo)) in colors.into_iter().enumerate() {
        builder.part(name, Phong::of(albedo, 0.05, 8.0));
        for i in 0..number {
            // Pairs of one color face each other.
            let (pair, side) = (i / 2, if i % 2 == 0 { -1.0 } else { 1.0 });
            if pair % 3 != u32::try_from(color).unwrap_or(0) {
                continue;
            }
            let place = Vec3::new(side * (HALF_WIDTH - 0.46), 0.0, FAR * ratio(pair + 1, bays.side));
            let frame = Frame::at(place).turned(Vec3::Y, -side * 90.0);
            let [low, high] = [Vec2::new(-0.46, 3.25), Vec2::new(0.46, 5.98)];
            builder.drapery(&frame, low, high, 2.6, each, &mut Chance::of("banners", i));
        }
    }
}

/// Lanterns of iron and pale glass in the galleries of the ground.
pub(super) fn lanterns(builder: &mut Builder, bays: Bays, triangles: u32) {
    const FEWEST: u32 = 40;
    let lanterns = number(triangles, FEWEST, [0, 2 * bays.side]);
    let each = triangles / lanterns.max(1);
    // Those with a light in them come first.
    let order = [1, 4, 0, 2, 3, 5];
    let places: Vec<Vec3> = (0..lanterns)
        .map(|i| {
            let bay = order.get(i as usize / 2).copied().unwrap_or(0);
            let side = if i % 2 == 0 { -1.0 } else { 1.0 };
            Vec3::new(side * (HALF_WIDTH + 1.7), LANTERN, FAR * (ratio(bay, bays.side) + 0.5 / ratio(bays.side, 1)))
        })
        .collect();
    let [sides, steps] = grid(share(each, 0.5), 1.0, [4, 2]);
    builder.part("shades of the lanterns", Phong::of(srgb(255, 226, 170), 0.3, 30.0));
    for &place in &places {
        // A cup of glass, open below, whose light is inside.
        let profile: Vec<Vec2> =
            (0..=steps).map(|i| ratio(i, steps)).map(|t| Vec2::new(0.15 - 0.13 * t * t, -0.16 + 0.3 * t)).collect();
        let inside: Vec<Vec2> = profile.iter().rev().map(|p| Vec2::new(p.x - 0.006, p.y - 0.004)).collect();
        builder.turned(&Frame::at(place), &inside, sides);
    }
    builder.part("iron of the lanterns", Phong::of(srgb(52, 48, 46), 0.3, 30.0));
    for &place in &places {
        let profile: Vec<Vec2> =
            (0..=steps).map(|i| ratio(i, steps)).map(|t| Vec2::new(0.155 - 0.13 * t * t, -0.16 + 0.3 * t)).collect();
        builder.turned(&Frame::at(place), &profile, sides);
        builder.bar(place + Vec3::Y * 0.13, place.with_y(4.9), 0.012, 4);
    }
}
