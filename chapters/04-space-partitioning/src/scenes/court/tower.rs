//! The bell tower that looks over the roof.

use common::{Vec2, Vec3, color::srgb};
use ray_casting::{frame::Frame, material::Phong};

use super::FAR;
use crate::scenes::{
    arches::{Arch, Faces},
    budget::{grid, number, share},
    builder::Builder,
};

/// Half the tower's width.
const HALF: f32 = 1.75;
/// Height where the bells hang, and of the eaves above.
const BELLS: f32 = 15.2;
/// Height of the eaves above the bells.
const TOP: f32 = 18.6;

/// A square tower with two arches on each side, a bell and a roof like a pyramid.
pub(super) fn bell_tower(builder: &mut Builder, triangles: u32) {
    const FEWEST: u32 = 120;
    if triangles < FEWEST {
        return;
    }
    let place = Vec3::new(-2.3, 0.0, FAR - 13.0);
    let here = Frame::at(place);
    builder.part("tower", Phong::of(srgb(214, 184, 146), 0.0, 1.0));
    builder.cuboid(&here, Vec3::new(-HALF, 5.0, -HALF), Vec3::new(HALF, BELLS, HALF));
    let arch = Arch { width: 2.0 * HALF, bottom: BELLS, spring: 17.0, top: TOP, radius: 0.95, depth: 0.4 };
    let segments = number(Arch::segments(triangles / 12, Faces::Both), 1, [2, 200]);
    for turn in [0.0, 90.0, 180.0, 270.0] {
        let side = Frame::at(place).turned(Vec3::Y, turn);
        let face = side.vector_to_world(Vec3::Z) * HALF;
        builder.arch(&Frame::at(place + face).turned(Vec3::Y, turn), &arch, segments, Faces::Both);
    }
    builder.part("ledges of the tower", Phong::of(srgb(234, 216, 186), 0.0, 1.0));
    for (y, out) in [(12.4, 0.14), (BELLS - 0.25, 0.22), (TOP, 0.3)] {
        let reach = HALF + out;
        builder.cuboid(&here, Vec3::new(-reach, y, -reach), Vec3::new(reach, y + 0.26, reach));
    }
    builder.part("roof of the tower", Phong::of(srgb(178, 92, 62), 0.0, 1.0));
    let roof = Frame::at(place + Vec3::Y * (TOP + 0.26)).turned(Vec3::Y, 45.0);
    builder.turned(&roof, &[[2.9, 0.0], [0.0, 2.4]].map(Vec2::from), 4);
    builder.part("bell", Phong::of(srgb(160, 124, 70), 0.9, 50.0));
    let outline = [[0.62, 0.0], [0.5, 0.16], [0.42, 0.5], [0.34, 0.78], [0.16, 0.92], [0.0, 0.94]].map(Vec2::from);
    let [sides, _] = grid(share(triangles, 0.2), 1.0, [8, 5]);
    builder.turned(&Frame::at(place + Vec3::Y * (BELLS + 1.1)), &outline, sides);
    builder.bar(place + Vec3::Y * (BELLS + 2.0), place + Vec3::Y * TOP, 0.06, 6);
}
