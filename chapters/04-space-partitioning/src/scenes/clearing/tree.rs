//! The trees: trunk, roots, branches and twigs as tubes, and leaves around the ends of the twigs.

use common::{Rgb, Vec2, Vec3, color::srgb, float};
use ray_casting::material::Phong;

use super::{
    super::{
        budget::{number, share},
        builder::Builder,
        chance::Chance,
        spline::on_spline,
    },
    ground,
};

/// Triangles of a leaf.
const LEAF: u32 = 2;
/// Where the trees stand, and how high they are, in meters; the first are in any scene.
const PLACES: [(f32, f32, f32); 13] = [
    (-4.9, -2.6, 7.0),
    (4.7, -3.4, 7.6),
    (-1.2, -6.8, 7.2),
    (-4.6, 3.4, 6.4),
    (5.6, 1.6, 6.6),
    (2.2, -8.2, 8.4),
    (-7.6, -6.2, 8.2),
    (8.0, -6.6, 8.0),
    (-8.4, -0.4, 7.4),
    (9.2, -1.6, 7.8),
    (-4.6, -9.8, 8.6),
    (5.8, -10.2, 9.0),
    (0.4, -11.4, 8.8),
];
/// Area of all leaves together, at any number of them, in square meters.
const FOLIAGE: f32 = 460.0;

/// Where leaves grow: around the end of a twig.
struct Tuft {
    center: Vec3,
    radius: f32,
}

/// All trees, with about so many triangles.
pub(super) fn trees(builder: &mut Builder, triangles: u32, chance: &mut Chance) {
    let wanted = builder.count() + triangles;
    let wood = share(triangles, 0.3);
    let trees = number(wood, 12, [2, PLACES.len() as u32]);
    let mut tufts = Vec::new();
    builder.part("bark", Phong::of(srgb(104, 82, 64), 0.0, 1.0));
    for &(x, z, height) in &PLACES[..trees as usize] {
        tree(builder, &mut tufts, ground(x, z), height, wood / trees, chance);
    }
    // Leaves take what is left.
    let count = (builder.missing_to(wanted) / LEAF).max(3);
    let size = (FOLIAGE * trees as f32 / PLACES.len() as f32 / count as f32).sqrt().min(1.4);
    let greens = [
        ("dark leaves", srgb(46, 76, 44), 0.4),
        ("leaves", srgb(76, 106, 50), 0.8),
        ("pale leaves", srgb(128, 140, 66), 1.0),
    ];
    let mut grown = 0;
    for (name, color, until) in greens {
        builder.part(name, Phong::of(color, 0.1, 12.0));
        let last = ((count as f32 * until) as u32).max(grown + 1);
        leaves(builder, &tufts, last - grown, size, chance);
        grown = last;
    }
}

/// A tree of about so many triangles, without leaves.
fn tree(builder: &mut Builder, tufts: &mut Vec<Tuft>, foot: Vec3, height: f32, triangles: u32, chance: &mut Chance) {
    // The trunk: a curved line, wide at the foot.
    let thick = height * chance.between(0.034, 0.042);
    let bow = |chance: &mut Chance| Vec3::new(chance.around(0.4), 0.0, chance.around(0.4));
    let line: Vec<Vec3> = (0..5)
        .map(|i| foot + Vec3::Y * (height * 0.85 * i as f32 / 4.0 - 0.1) + bow(chance) * (i as f32 / 4.0))
        .collect();
    let trunk_radius = |t: f32| thick * (1.0 - 0.82 * t + 0.9 * float::pow(1.0 - t, 14.0));
    tube(builder, &line, share(triangles, 0.22), 3.0, trunk_radius);

    // Roots that run out from the foot and sink into the ground.
    let roots = number(triangles, 120, [0, 7]);
    for root in 0..roots {
        let angle = std::f32::consts::TAU * (root as f32 + chance.around(0.25)) / roots as f32;
        let out = Vec3::new(float::cos(angle), 0.0, float::sin(angle));
        let aside = Vec3::new(-out.z, 0.0, out.x) * chance.around(0.3);
        let length = chance.between(0.7, 1.3);
        let on_ground = |d: f32, above: f32| {
            let place = foot + out * d + aside * (d * d);
            ground(place.x, place.z) + Vec3::Y * above
        };
        let line =
            [foot + Vec3::Y * 0.75, on_ground(0.36, 0.22), on_ground(0.6 * length, 0.06), on_ground(length, -0.14)];
        tube(builder, &line, share(triangles, 0.16) / roots, 1.6, |t| thick * (0.62 - 0.5 * t));
    }

    // Branches, the lower the longer, each with twigs.
    let branches = number(triangles, 26, [2, 16]);
    for branch in 0..branches {
        let t = 0.42 + 0.55 * (branch as f32 + chance.between(0.0, 0.8)) / branches as f32;
        let angle = branch as f32 * 2.4 + chance.around(0.4);
        let out = Vec3::new(float::cos(angle), chance.between(0.25, 0.7), float::sin(angle)).normalize_or(Vec3::Y);
        let reach = height * (0.36 - 0.24 * t) * chance.between(0.8, 1.2);
        let from = on_spline(&line, t);
        let line = [from, from + out * (0.5 * reach), from + (out * 0.9 + Vec3::Y * 0.35) * reach];
        let start = trunk_radius(t) * 0.6;
        let budget = share(triangles, 0.6) / branches;
        tube(builder, &line, if budget < 30 { 6 } else { budget / 2 }, 1.5, |t| start * (1.0 - 0.8 * t));
        tufts.push(Tuft { center: line[2], radius: 0.16 * height * chance.between(0.6, 0.9) });
        let twigs = (budget / 2 / 10).min(5);
        for _ in 0..twigs {
            let from = on_spline(&line, chance.between(0.45, 0.95));
            let angle = chance.angle();
            let aside = Vec3::new(float::cos(angle), chance.between(-0.2, 0.8), float::sin(angle));
            let to = from + (aside + out * 0.6) * (0.35 * reach);
            let bent = from.lerp(to, 0.5) + Vec3::Y * (0.05 * reach);
            tube(builder, &[from, bent, to], budget / 2 / twigs, 1.2, |t| start * 0.4 * (1.0 - 0.75 * t));
            tufts.push(Tuft { center: to, radius: 0.1 * height * chance.between(0.6, 1.0) });
        }
    }
}

/// A tube of about so many triangles along the smooth curve through the given points; `slender` says how many times
/// more sides than pieces it has, at least.
fn tube(builder: &mut Builder, line: &[Vec3], triangles: u32, slender: f32, radius: impl Fn(f32) -> f32) {
    let sides = ((triangles as f32 / 2.0 / slender).sqrt() as u32).clamp(3, 4000);
    let pieces = (triangles / (2 * sides)).max(1);
    let points: Vec<Vec3> = (0..=pieces).map(|i| on_spline(line, i as f32 / pieces as f32)).collect();
    builder.tube(&points, sides, |i| radius(i as f32 / pieces as f32));
}

/// So many leaves around the ends of twigs.
fn leaves(builder: &mut Builder, tufts: &[Tuft], count: u32, size: f32, chance: &mut Chance) {
    for _ in 0..count {
        let Some(tuft) = tufts.get(chance.index(tufts.len())) else { return };
        let out = in_crown(chance);
        let center = tuft.center + out * Vec3::new(1.0, 0.75, 1.0) * tuft.radius;
        // Most look up and outward.
        let facing = (out * 0.9 + Vec3::Y * 0.5 + in_crown(chance)).normalize_or(Vec3::Y);
        leaf(builder, center, facing, size * chance.between(0.7, 1.25), chance);
    }
}

/// A leaf: two halves, folded along the middle.
fn leaf(builder: &mut Builder, center: Vec3, facing: Vec3, size: f32, chance: &mut Chance) {
    let along = in_crown(chance).reject_from_normalized(facing).normalize_or(facing.any_orthonormal_vector());
    let side = facing.cross(along) * (0.4 * size);
    let (along, fold) = (along * (0.7 * size), facing * (0.12 * size));
    builder.quad([center - along, center + fold - side, center + along, center + fold + side]);
}

/// A point in the unit ball, more often near its surface than in a solid one.
fn in_crown(chance: &mut Chance) -> Vec3 {
    chance.on_sphere() * float::pow(chance.between(0.0, 1.0), 0.25)
}

/// The forest behind, which stands in the mist: two rows of firs, with about so many triangles.
pub(super) fn far_trees(builder: &mut Builder, triangles: u32, chance: &mut Chance) {
    let trees = number(triangles, 40, [3, 90]);
    // Boughs of two triangles, around a trunk of six.
    let boughs = (triangles / trees / 2).saturating_sub(3).max(2);
    let rows = [("far firs", Rgb::new(1.0, 1.0, 1.0), 21.0), ("near firs", Rgb::new(0.5, 0.56, 0.52), 16.0)];
    for (row, (name, mist, distance)) in (0..).zip(rows) {
        builder.part(name, Phong { ambient: mist, ..Phong::of(srgb(40, 62, 66), 0.0, 1.0) });
        let count = (trees + row) / 2;
        for i in 0..count {
            let angle = 2.5 * ((i as f32 + chance.between(0.2, 0.8)) / count as f32 - 0.5);
            let place = Vec2::new(float::sin(angle), -float::cos(angle)) * (distance + chance.around(1.5));
            let foot = Vec3::new(place.x, -0.2, place.y);
            fir(builder, foot, chance.between(6.0, 11.0), boughs, chance);
        }
    }
}

/// A fir with so many boughs.
fn fir(builder: &mut Builder, foot: Vec3, height: f32, boughs: u32, chance: &mut Chance) {
    let line = [foot - Vec3::Y, foot + Vec3::Y * height];
    builder.tube(&line, 3, |i| if i == 0 { 0.2 } else { 0.03 });
    // Fewer boughs are broader.
    let broad = (30.0 / boughs as f32).sqrt().clamp(0.12, 2.2);
    for bough in 0..boughs {
        let t = 0.06 + 0.92 * (bough as f32 + chance.between(0.0, 1.0)) / boughs as f32;
        let angle = bough as f32 * 2.4 + chance.around(0.5);
        let out = Vec3::new(float::cos(angle), -0.45, float::sin(angle));
        let reach = height * 0.24 * (1.05 - t) * chance.between(0.75, 1.2);
        let side = Vec3::Y.cross(out) * (0.34 * broad * reach.max(0.3));
        let from = foot + Vec3::Y * (t * height + 0.2);
        let middle = from + out * (0.55 * reach);
        builder.quad([from, middle + side, from + out * reach, middle - side]);
    }
}
