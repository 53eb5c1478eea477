//! The building around the court: arches on columns, and galleries behind them.

use common::{Vec2, Vec3, color::srgb, float};
use ray_casting::{frame::Frame, material::Phong};

use super::{Bays, EAVES, FAR, GALLERY, HALF_WIDTH, STOREYS, Storey, THICK};
use crate::scenes::{
    arches::{Arch, Faces},
    budget::{grid, number, ratio, share},
    builder::Builder,
};

/// Half the width of an arch.
const RADIUS: f32 = 1.14;

/// The arch of a bay.
fn arch(bays: Bays, storey: Storey) -> Arch {
    let bottom = if bays.has_columns() { storey.spring } else { storey.floor };
    Arch { width: bays.width(), bottom, spring: storey.spring, top: storey.top, radius: RADIUS, depth: THICK }
}

/// The walls above the columns.
pub(super) fn arches(builder: &mut Builder, bays: Bays, triangles: u32) {
    builder.part("walls", Phong::of(srgb(222, 198, 160), 0.0, 1.0));
    let frames = bays.frames();
    let pieces = number(2 * u32::try_from(frames.len()).unwrap_or(1), 1, [1, u32::MAX]);
    let each = triangles / pieces;
    let faces = if each < Arch::cost(4, Faces::Both) { Faces::Front } else { Faces::Both };
    let segments = Arch::segments(each, faces);
    for storey in STOREYS {
        for frame in &frames {
            builder.arch(frame, &arch(bays, storey), segments, faces);
        }
        // The pillars in the corners.
        if bays.has_columns() {
            let pier = bays.width() / 2.0 - RADIUS;
            for [left, right] in [[-HALF_WIDTH - THICK, -HALF_WIDTH + pier], [HALF_WIDTH - pier, HALF_WIDTH + THICK]] {
                builder.block([left, storey.floor, FAR - THICK], [right, storey.spring, FAR + pier]);
            }
        }
    }
}

/// The floors, walls and ceilings of the galleries behind the arches.
pub(super) fn galleries(builder: &mut Builder) {
    let [outer, end] = [HALF_WIDTH + GALLERY, FAR - GALLERY];
    /// The galleries begin a little before the court does.
    const BEGIN: f32 = 4.0;
    builder.part("walls of the galleries", Phong::of(srgb(206, 152, 108), 0.0, 1.0));
    builder
        .quad([[-outer, 0.0, BEGIN], [-outer, 0.0, end], [-outer, EAVES, end], [-outer, EAVES, BEGIN]].map(Vec3::from));
    builder.quad([[outer, 0.0, end], [outer, 0.0, BEGIN], [outer, EAVES, BEGIN], [outer, EAVES, end]].map(Vec3::from));
    builder.quad([[-outer, 0.0, end], [outer, 0.0, end], [outer, EAVES, end], [-outer, EAVES, end]].map(Vec3::from));
    builder.part("ceilings", Phong::of(srgb(196, 170, 136), 0.0, 1.0));
    let inner = HALF_WIDTH + 0.01;
    for (y, above) in [(4.9, Some(5.15)), (EAVES - 0.05, None)] {
        for [left, right, near, far] in
            [[-outer, -inner, BEGIN, end], [inner, outer, BEGIN, end], [-inner, inner, FAR - 0.01, end]]
        {
            builder.quad([[left, y, far], [right, y, far], [right, y, near], [left, y, near]].map(Vec3::from));
            if let Some(y) = above {
                builder.quad([[left, y, near], [right, y, near], [right, y, far], [left, y, far]].map(Vec3::from));
            }
        }
    }
    builder.part("roofs", Phong::of(srgb(178, 92, 62), 0.0, 1.0));
    let [low, high] = [EAVES + 0.02, EAVES + 1.3];
    let eaves = HALF_WIDTH - 0.35;
    builder
        .quad([[-eaves, low, BEGIN], [-eaves, low, end], [-outer, high, end], [-outer, high, BEGIN]].map(Vec3::from));
    builder.quad([[eaves, low, end], [eaves, low, BEGIN], [outer, high, BEGIN], [outer, high, end]].map(Vec3::from));
    let far = FAR + 0.35;
    builder.quad([[-outer, low, far], [outer, low, far], [outer, high, end], [-outer, high, end]].map(Vec3::from));
}

/// Moldings around the arches, and a roundel above each column.
pub(super) fn moldings(builder: &mut Builder, bays: Bays, triangles: u32) {
    const FEWEST: u32 = 24;
    builder.part("moldings", Phong::of(srgb(188, 112, 78), 0.0, 1.0));
    let frames = bays.frames();
    let each = share(triangles, 0.75) / (2 * u32::try_from(frames.len()).unwrap_or(1));
    if each < FEWEST {
        return;
    }
    let steps = grid(each, 5.0, [6, 2]);
    for storey in STOREYS {
        for frame in &frames {
            builder.molding(frame, &arch(bays, storey), 0.075, steps);
        }
    }
    builder.part("roundels", Phong::of(srgb(60, 108, 124), 0.4, 30.0));
    let steps = grid(share(triangles, 0.25) / 24, 1.5, [6, 2]);
    for (frame, i) in frames.iter().zip(1..) {
        // Not where two sides meet.
        if i % bays.side == 0 || i > 2 * bays.side && i == 2 * bays.side + bays.end {
            continue;
        }
        let middle = Vec3::new(bays.width() / 2.0, 8.15, 0.0);
        builder.closed_surface(steps, |p| frame.point_to_world(middle + p * Vec3::new(0.2, 0.2, 0.06)));
    }
}

/// A column's outline from its foot upward, for the part `t` of its height from 0 to 1: its radius in radii of the
/// shaft.
fn outline(t: f32) -> f32 {
    // Two rings of the base with a hollow between, a shaft that becomes thinner, a neck, a bell.
    let ring = |at: f32, half: f32, out: f32| {
        let x = (t - at) / half;
        out * (1.0 - x * x).max(0.0).sqrt()
    };
    let shaft = 1.0 - 0.14 * t * t;
    let bell = if t > 0.88 { 0.62 * ((t - 0.88) / 0.12) * ((t - 0.88) / 0.12) } else { 0.0 };
    shaft + ring(0.025, 0.026, 0.34) + ring(0.075, 0.02, 0.2) + ring(0.868, 0.014, 0.16) + bell
}

/// Round columns with bases and capitals.
pub(super) fn columns(builder: &mut Builder, bays: Bays, triangles: u32) {
    const FEWEST: u32 = 8;
    builder.part("columns", Phong::of(srgb(230, 216, 194), 0.1, 30.0));
    if !bays.has_columns() {
        return;
    }
    let places = bays.columns();
    let each = (triangles / (2 * u32::try_from(places.len()).unwrap_or(1))).max(FEWEST);
    let has_blocks = each >= 64;
    let round = if has_blocks { each - 24 } else { each };
    let [sides, steps] = if round < 100 { [round / 2, 1] } else { grid(round, 0.85, [4, 1]) };
    // Heights of the rings: closely where the outline bends.
    let heights: Vec<f32> = (0..=steps).map(|i| bend(ratio(i, steps))).collect();
    for storey in STOREYS {
        let radius = storey.column;
        let plinth = if has_blocks { 0.12 } else { 0.0 };
        let (foot, head) = (storey.floor + plinth, storey.spring - plinth);
        let profile: Vec<Vec2> = if steps < 8 {
            vec![Vec2::new(radius, 0.0), Vec2::new(radius * 0.88, head - foot)]
        } else {
            heights.iter().map(|&t| Vec2::new(radius * outline(t), (head - foot) * t)).collect()
        };
        for &place in &places {
            let frame = Frame::at(place.with_y(foot));
            builder.turned(&frame, &profile, sides);
            if has_blocks {
                let (half, slab) = (radius * 1.42, radius * 1.55);
                builder.cuboid(&frame, Vec3::new(-half, -plinth, -half), Vec3::new(half, 0.0, half));
                let top = head - foot;
                builder.cuboid(&frame, Vec3::new(-slab, top, -slab), Vec3::new(slab, top + plinth, slab));
            }
        }
    }
}

/// Equal steps made closer near the base and the capital.
fn bend(t: f32) -> f32 {
    t - 0.115 * float::sin(std::f32::consts::TAU * t)
}
