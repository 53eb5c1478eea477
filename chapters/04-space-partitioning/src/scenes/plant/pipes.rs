//! The pipes: bundles that run along the axes, with bends and flanges, through the house and on a rack before it.

use common::{Vec3, color::srgb, float};
use ray_casting::material::Phong;

use super::{
    super::{
        budget::{number, share},
        builder::Builder,
        chance::Chance,
        cuboid,
    },
    flange::flange,
    house::{HIGH, LOW},
    steel::{column, girder},
};

/// The rack: its z, its ends in x, and its height.
const RACK: (f32, f32, f32, f32) = (8.0, -88.0, 60.0, 7.0);
/// Width of the rack.
const WIDTH: f32 = 7.0;
/// Name and color of the pipes, and their share of the budget.
const KINDS: [(&str, [u8; 3], f32); 5] = [
    ("silver pipes", [188, 192, 196], 0.3),
    ("ochre pipes", [208, 150, 58], 0.2),
    ("green pipes", [72, 134, 118], 0.2),
    ("red pipes", [176, 70, 52], 0.14),
    ("blue pipes", [72, 112, 160], 0.16),
];
/// Most pipes side by side in a bundle.
const BUNDLE: usize = 4;

/// How finely pipes are cut.
#[derive(Clone, Copy)]
struct Cut {
    sides: u32,
    /// Pieces of a bend.
    bend: u32,
    bolts: bool,
}

/// The frames that the rack is made of, with at most about so many triangles.
pub(super) fn rack(builder: &mut Builder, triangles: u32) {
    let (z, left, right, height) = RACK;
    builder.part("pipe rack", Phong::of(srgb(92, 112, 118), 0.25, 20.0));
    let frames = number(triangles, 6 * cuboid::COST, [1, 24]);
    let budget = triangles / frames / 5;
    for frame in 0..frames {
        let x = left + (right - left) * (frame as f32 + 0.5) / frames as f32;
        let at = |y: f32, side: f32| Vec3::new(x, y, z + side * WIDTH / 2.0);
        column(builder, at(0.0, -1.0), at(height + 2.8, -1.0), 0.4, budget);
        column(builder, at(0.0, 1.0), at(height + 2.8, 1.0), 0.4, budget);
        girder(builder, at(height - 0.6, -1.0), at(height - 0.6, 1.0), 0.3, budget);
        girder(builder, at(height + 2.2, -1.0), at(height + 2.2, 1.0), 0.3, budget);
    }
}

/// Pipes of so many triangles.
pub(super) fn pipes(builder: &mut Builder, triangles: u32, chance: &mut Chance) {
    // More triangles make both more and finer pipes.
    let count = (0.13 * float::pow(triangles as f32, 0.7)).max(1.0);
    let each = triangles as f32 / count;
    let sides = ((0.4 * each.sqrt()) as u32).clamp(3, 40);
    let bend = (each as u32 / (8 * sides)).saturating_sub(3).clamp(1, 24);
    let cut = Cut { sides, bend, bolts: each > 450.0 };
    let start = builder.count();
    let mut until = 0.0;
    let mut bundle = 0;
    // The fewest have one color.
    let kinds = if triangles < 200 { &KINDS[..1] } else { &KINDS };
    for (i, &(name, [red, green, blue], part)) in kinds.iter().enumerate() {
        builder.part(name, Phong::of(srgb(red, green, blue), 0.5, 40.0));
        until += part;
        // The last take the rest.
        let wanted = start + if i + 1 == kinds.len() { triangles } else { share(triangles, until) };
        let first = builder.count();
        while builder.count() < wanted || builder.count() == first {
            // Every third bundle lies on the rack.
            let line = if bundle % 3 == 1 { rack_route(chance) } else { house_route(chance) };
            // The first are thick.
            let radius = 0.5 * float::pow(1.0 + bundle as f32 / 5.0, -0.33) * chance.between(0.7, 1.2);
            bundle += 1;
            let in_bundle = if cut.sides < 4 { 1 } else { 1 + chance.index(BUNDLE) };
            for i in 0..in_bundle {
                if builder.count() < wanted || i == 0 {
                    let aside = Vec3::new(1.0, 1.0, -1.0) * (3.4 * radius * i as f32);
                    let line: Vec<Vec3> = line.iter().map(|&corner| corner + aside).collect();
                    pipe(builder, &line, radius, cut);
                }
            }
        }
    }
}

/// The corners of a way through the house.
fn house_route(chance: &mut Chance) -> Vec<Vec3> {
    let size = HIGH - LOW - Vec3::new(4.0, 3.0, 4.0);
    let mut corner =
        LOW + Vec3::new(1.0, 1.0, 2.0) + size * Vec3::from_array([(); 3].map(|()| chance.between(0.0, 1.0)));
    // Many start at the front or the right, where they are seen.
    if chance.happens(0.5) {
        corner.z = HIGH.z - chance.between(0.2, 3.0);
    } else if chance.happens(0.5) {
        corner.x = HIGH.x - chance.between(0.2, 3.0);
    }
    let legs = 3 + chance.index(4);
    let mut line = vec![corner];
    let mut axis = chance.index(3);
    for _ in 0..legs {
        // To another place along the axis, and at least a little away.
        let low = LOW[axis] + 1.0;
        let reach = size[axis];
        let from = (corner[axis] - low) / reach;
        let to = (from + chance.between(0.22, 0.78)).rem_euclid(1.0);
        corner[axis] = low + reach * to;
        line.push(corner);
        axis = (axis + if chance.happens(0.5) { 1 } else { 2 }) % 3;
    }
    line
}

/// The corners of a way along the rack, with a loop that takes up the heat's expansion, and down or off at both ends.
fn rack_route(chance: &mut Chance) -> Vec<Vec3> {
    let (z, left, right, height) = RACK;
    let y = height + 0.4 + if chance.happens(0.5) { 0.0 } else { 2.8 };
    let z = z + chance.between(-0.42, 0.36) * WIDTH;
    let (from, to) = (chance.between(left, left + 40.0), chance.between(right - 60.0, right));
    let bow = chance.between(from + 12.0, to - 12.0);
    let (wide, high) = (chance.between(1.5, 4.0), chance.between(1.2, 2.6));
    let start = if chance.happens(0.5) { Vec3::new(from, 0.0, z) } else { Vec3::new(from, y, 30.0) };
    let end = if chance.happens(0.4) { Vec3::new(to, 0.0, z) } else { Vec3::new(to, y, chance.between(-12.0, -4.0)) };
    vec![
        start,
        Vec3::new(from, y, z),
        Vec3::new(bow, y, z),
        Vec3::new(bow, y + high, z),
        Vec3::new(bow + wide, y + high, z),
        Vec3::new(bow + wide, y, z),
        Vec3::new(to, y, z),
        end,
    ]
}

/// A pipe along a line of corners, with round bends, and flanges on its straight pieces.
fn pipe(builder: &mut Builder, corners: &[Vec3], radius: f32, cut: Cut) {
    let mut line = vec![corners[0]];
    for triple in corners.windows(3) {
        let [before, corner, after] = [triple[0], triple[1], triple[2]];
        let (back, forth) = ((before - corner).normalize_or(Vec3::X), (after - corner).normalize_or(Vec3::Y));
        // A quarter of a circle, of three radii where there is room.
        let room = (before - corner).length().min((after - corner).length()) * 0.45;
        let around = (3.0 * radius).min(room);
        for i in 0..=cut.bend {
            let angle = std::f32::consts::FRAC_PI_2 * i as f32 / cut.bend as f32;
            let (sin, cos) = (float::sin(angle), float::cos(angle));
            line.push(corner + back * (around * (1.0 - sin)) + forth * (around * (1.0 - cos)));
        }
    }
    line.extend(corners.last());
    builder.tube(&line, cut.sides, |_| radius);
    if cut.sides < 5 {
        return;
    }
    for pair in corners.windows(2) {
        let along = pair[1] - pair[0];
        if along.length() > 16.0 * radius {
            let axis = along.normalize_or(Vec3::Y);
            flange(builder, pair[0] + axis * (5.0 * radius), axis, radius, cut.sides, cut.bolts);
            flange(builder, pair[1] - axis * (5.0 * radius), axis, radius, cut.sides, cut.bolts);
        }
    }
}
