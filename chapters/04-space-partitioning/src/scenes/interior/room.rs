//! The room itself: walls with arched windows, a ceiling of beams, a floor of planks.

use common::{Vec2, Vec3, color::srgb};
use ray_casting::{frame::Frame, material::Phong};

use super::{FAR, HALF_WIDTH, HEIGHT, NEAR, wood};
use crate::scenes::{
    arches::{Arch, Faces},
    budget::{grid, number, ratio},
    builder::Builder,
    chance::Chance,
};

/// Height of the window sills.
const SILL: f32 = 0.62;
/// Where walls begin: under the floor, so that no light comes in between.
const UNDER: f32 = -0.05;
/// Thickness of the outer walls.
const THICK: f32 = 0.4;
/// The wall around a window to the sun.
const SUNNY: Arch = Arch { width: 0.0, bottom: UNDER, spring: 2.35, top: HEIGHT, radius: 0.78, depth: THICK };
/// The far wall with its large window.
const FAR_WALL: Arch =
    Arch { width: 2.0 * HALF_WIDTH, bottom: UNDER, spring: 2.05, top: HEIGHT, radius: 1.25, depth: THICK };

/// Where the windows to the sun are: the middles of their pieces of wall, on the inner face.
fn sunny(windows: u32) -> (Vec<Frame>, Arch) {
    let width = (NEAR - FAR) / ratio(windows, 1);
    let frames = (0..windows)
        .map(|i| Frame::at(Vec3::new(-HALF_WIDTH, 0.0, NEAR - width * (ratio(i, 1) + 0.5))).turned(Vec3::Y, 90.0))
        .collect();
    (frames, Arch { width, ..SUNNY })
}

/// The far wall's frame: its face looks into the room.
fn far() -> Frame {
    Frame::at(Vec3::new(0.0, 0.0, FAR))
}

/// How many windows a budget for the walls pays for.
fn windows(triangles: u32) -> u32 {
    number(triangles, 25, [1, 4])
}

/// Four walls, the ceiling's plaster and the windows' openings.
pub(super) fn walls(builder: &mut Builder, triangles: u32) {
    builder.part("walls", Phong::of(srgb(216, 200, 172), 0.0, 1.0));
    let (frames, sunny) = sunny(windows(triangles));
    let segments = number(triangles, 30, [2, 64]);
    for frame in &frames {
        builder.arch(frame, &sunny, segments, Faces::Both);
    }
    builder.arch(&far(), &FAR_WALL, segments, Faces::Both);
    let [w, h] = [HALF_WIDTH, HEIGHT];
    builder.quad([[w, UNDER, NEAR], [w, UNDER, FAR], [w, h, FAR], [w, h, NEAR]].map(Vec3::from));
    builder.quad([[w, UNDER, NEAR], [w, h, NEAR], [-w, h, NEAR], [-w, UNDER, NEAR]].map(Vec3::from));
    // The parapets below the windows.
    for frame in &frames {
        builder.cuboid(frame, Vec3::new(-sunny.radius, UNDER, -THICK), Vec3::new(sunny.radius, SILL, -0.02));
    }
    builder.cuboid(&far(), Vec3::new(-FAR_WALL.radius, UNDER, -THICK), Vec3::new(FAR_WALL.radius, SILL, -0.02));
}

/// The plaster above, and beams under it that cross each other.
pub(super) fn ceiling(builder: &mut Builder, triangles: u32) {
    builder.part("ceiling", Phong::of(srgb(232, 222, 202), 0.0, 1.0));
    let [left, right] = [-HALF_WIDTH - THICK, HALF_WIDTH];
    builder.quad(
        [[left, FAR - THICK], [right, FAR - THICK], [right, NEAR], [left, NEAR]].map(|[x, z]| [x, HEIGHT, z].into()),
    );
    builder.part("beams", wood(srgb(106, 68, 42)));
    let across = number(triangles, 24, [0, 9]);
    for i in 0..across {
        let z = NEAR + (FAR - NEAR) * (ratio(i, across) + 0.5 / ratio(across, 1));
        builder.block([-HALF_WIDTH, HEIGHT - 0.24, z - 0.11], [HALF_WIDTH, HEIGHT, z + 0.11]);
    }
    let along = number(triangles, 60, [0, 3]);
    for i in 0..along {
        let x = HALF_WIDTH * (2.0 * (ratio(i, along) + 0.5 / ratio(along, 1)) - 1.0);
        builder.block([x - 0.09, HEIGHT - 0.18, FAR], [x + 0.09, HEIGHT, NEAR]);
    }
    // Cornices at both sides.
    if triangles >= 100 {
        for side in [-1.0, 1.0] {
            let x = side * (HALF_WIDTH - 0.07);
            builder.block([x - 0.07, HEIGHT - 0.16, FAR], [x + 0.07, HEIGHT, NEAR]);
        }
    }
}

/// Planks of two woods with narrow joints, and the rug.
pub(super) fn floor(builder: &mut Builder, triangles: u32) {
    const PLANK: u32 = 12;
    /// Narrowest plank: more than so many would not lie side by side.
    const MOST: [u32; 2] = [58, 12];
    if triangles / PLANK < 16 {
        builder.part("floor", Phong::of(srgb(160, 108, 64), 0.16, 60.0));
        builder.quad([[-4.0, NEAR], [4.0, NEAR], [4.0, FAR], [-4.0, FAR]].map(|[x, z]| [x, 0.0, z].into()));
        rug(builder, triangles);
        return;
    }
    let [across, along] = grid(2 * (triangles / PLANK), 6.0, [4, 2]);
    let [across, along] = [across.min(MOST[0]), along.min(MOST[1])];
    const JOINT: f32 = 0.0025;
    let colors =
        [("light planks", srgb(178, 126, 78)), ("planks", srgb(160, 108, 64)), ("dark planks", srgb(142, 94, 56))];
    for (shade, (name, color)) in colors.into_iter().enumerate() {
        builder.part(name, Phong::of(color, 0.16, 60.0));
        for i in 0..across {
            // The same numbers for each shade: each plank is laid once.
            let mut chance = Chance::of("planks", i);
            let [left, right] = [i, i + 1].map(|i| HALF_WIDTH * (2.0 * ratio(i, across) - 1.0));
            let length = (NEAR - FAR) / ratio(along, 1);
            let shift = chance.between(0.1, 0.9) * length;
            for k in 0..=along {
                let wanted = chance.index(colors.len());
                let [near, far] = [k, k + 1].map(|k| (NEAR + shift - length * ratio(k, 1)).clamp(FAR, NEAR));
                if wanted == shade && near - far > 0.01 {
                    builder.block([left + JOINT, -0.04, far + JOINT], [right - JOINT, 0.0, near - JOINT]);
                }
            }
        }
    }
    builder.part("ground under the planks", Phong::of(srgb(60, 42, 28), 0.0, 1.0));
    builder.quad([[-4.0, -0.02, NEAR], [4.0, -0.02, NEAR], [4.0, -0.02, FAR], [-4.0, -0.02, FAR]].map(Vec3::from));
    rug(builder, triangles);
}

/// A rug of three bands under the table.
fn rug(builder: &mut Builder, triangles: u32) {
    let bands = [
        ("rug", srgb(150, 62, 48), 0.0),
        ("rug's border", srgb(70, 96, 96), 0.14),
        ("rug's middle", srgb(176, 156, 124), 0.24),
    ];
    let seen = match triangles {
        0..24 => 0,
        24..60 => 1,
        _ => bands.len(),
    };
    for ((name, color, inset), height) in bands.into_iter().zip([0.008_f32, 0.01, 0.012]).take(seen) {
        builder.part(name, Phong::of(color, 0.0, 1.0));
        builder.block([-1.9 + inset, 0.001, -10.4 + inset], [1.9 - inset, height, -2.4 - inset]);
    }
}

/// White bars in the windows.
pub(super) fn window_bars(builder: &mut Builder, triangles: u32) {
    builder.part("window bars", Phong::of(srgb(238, 234, 224), 0.1, 20.0));
    // Each bar is a box.
    let bars = triangles / 12;
    let mut openings: Vec<(Frame, Arch)> = vec![(far(), FAR_WALL)];
    let (frames, arch) = sunny(4);
    openings.extend(frames.into_iter().map(|frame| (frame, arch)));
    let each = bars / 5;
    if each < 5 {
        return;
    }
    let [across, up] = if each < 13 { [2, 1] } else { [4, 5] };
    for (frame, arch) in openings {
        let r = arch.radius;
        let inside = Frame::at(frame.point_to_world(Vec3::new(0.0, 0.0, -THICK / 2.0)));
        let inside = if arch.width < 4.0 { inside.turned(Vec3::Y, 90.0) } else { inside };
        builder.muntins(&inside, [-r, r], [SILL, arch.spring], [across, up]);
        // A fan in the round part.
        let rays = if each < 13 { 1 } else { 5 };
        let center = Vec2::Y * arch.spring;
        for i in 1..=rays {
            let tip = arch.over(ratio(i, rays + 1), r);
            let [from, to] = [center, tip].map(|p| inside.point_to_world(p.extend(0.0)));
            builder.bar(from, to, 0.02, 4);
        }
        // The sill.
        builder.cuboid(&frame, Vec3::new(-r - 0.08, SILL, -THICK), Vec3::new(r + 0.08, SILL + 0.05, 0.06));
    }
}
