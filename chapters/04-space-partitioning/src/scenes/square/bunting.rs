//! Bunting: strings of pennants from house to house, since it is a holiday.

use common::{Vec3, color::srgb};
use ray_casting::material::Phong;

use super::SIDES;
use crate::scenes::{
    budget::{number, ratio},
    builder::Builder,
    chance::Chance,
};

/// Where the strings are fastened on the left and on the right: height and z.
const STRINGS: [[[f32; 2]; 2]; 2] = [[[7.3, -9.6], [7.0, -7.6]], [[6.3, -15.6], [7.4, -12.2]]];
/// How far a string hangs through.
const SAG: f32 = 1.5;

/// The point of a string at a share of its length.
fn along([[left_y, left_z], [right_y, right_z]]: [[f32; 2]; 2], t: f32) -> Vec3 {
    let left = Vec3::new(SIDES[0], left_y, left_z);
    let right = Vec3::new(SIDES[1], right_y, right_z);
    // A rope hangs nearly like a parabola.
    left.lerp(right, t) - Vec3::Y * (4.0 * SAG * t * (1.0 - t))
}

/// Strings, and pennants in three colors.
pub(super) fn bunting(builder: &mut Builder, triangles: u32) {
    const FEWEST: u32 = 100;
    const SIDES_OF_A_STRING: u32 = 3;
    if triangles < FEWEST {
        return;
    }
    let steps = number(triangles / 10, 4, [8, 200]);
    builder.part("strings of pennants", Phong::of(srgb(226, 216, 196), 0.0, 1.0));
    for string in STRINGS {
        let line: Vec<Vec3> = (0..=steps).map(|i| along(string, ratio(i, steps))).collect();
        builder.tube(&line, SIDES_OF_A_STRING, |_| 0.008);
    }
    let pennants = number(triangles / 8, 1, [12, 58]);
    let colors = [
        ("red pennants", srgb(198, 62, 52)),
        ("white pennants", srgb(244, 236, 220)),
        ("golden pennants", srgb(226, 168, 66)),
    ];
    for ((name, color), first) in colors.into_iter().zip(0..) {
        builder.part(name, Phong::of(color, 0.0, 1.0));
        for string in STRINGS {
            for i in (first..pennants).step_by(colors.len()) {
                let mut chance = Chance::of("pennants", i);
                // Each hangs from a little of the string, and the wind moves its tip.
                let [from, to] = [0.2, 0.8].map(|share| (ratio(i, 1) + share) / ratio(pennants, 1));
                let [left, right] = [from, to].map(|t| along(string, t));
                let wind = Vec3::new(chance.around(0.06), 0.0, chance.between(-0.05, 0.2));
                let tip = left.midpoint(right) - Vec3::Y * 0.4 + wind;
                let corners = [left, tip, right].map(|corner| builder.vertex(corner));
                builder.triangle(corners);
            }
        }
    }
}
