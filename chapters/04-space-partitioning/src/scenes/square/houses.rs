//! The houses: where they stand, and their walls.

use common::{Rgb, Vec3, color::srgb};
use ray_casting::{frame::Frame, material::Phong};

use super::{FAR, SIDES};
use crate::scenes::{
    budget::{number, ratio},
    builder::Builder,
};

/// A house with its long side to the square. Its frame stands in the middle of the front, which looks along z.
pub(super) struct House {
    pub(super) frame: Frame,
    pub(super) width: f32,
    pub(super) floors: u32,
    /// Number of windows side by side.
    pub(super) columns: u32,
    /// In which of the columns the door is.
    pub(super) door: u32,
    /// Color of the plaster.
    plaster: Rgb,
    /// Which of the colors its shutters have.
    pub(super) shutters: usize,
}

/// From the front to the back of all houses.
pub(super) const DEPTH: f32 = 7.0;
/// Height of the ground floor.
const GROUND_FLOOR: f32 = 3.2;
/// Height of each floor above.
const FLOOR: f32 = 2.75;

impl House {
    /// Height of a floor's lower side; that of the eaves for the number of floors.
    pub(super) fn floor(&self, index: u32) -> f32 {
        if index == 0 { 0.0 } else { GROUND_FLOOR + FLOOR * ratio(index - 1, 1) }
    }

    /// Height of the eaves.
    pub(super) fn eaves(&self) -> f32 {
        self.floor(self.floors)
    }

    /// The middle of a column of windows.
    pub(super) fn column(&self, index: u32) -> f32 {
        self.width * (ratio(index, self.columns) + 0.5 / ratio(self.columns, 1) - 0.5)
    }

    /// Height of the ridge above the eaves.
    pub(super) fn rise(&self) -> f32 {
        0.23 * DEPTH
    }
}

/// As many of the houses as there are triangles for.
pub(super) fn all(triangles: u32) -> Vec<House> {
    const FEWEST: u32 = 40;
    let ochre = srgb(226, 180, 112);
    let rose = srgb(214, 154, 126);
    let cream = srgb(238, 222, 190);
    let clay = srgb(202, 126, 90);
    let mist = srgb(188, 198, 190);
    // Along the far side, from left to right, with an alley in the middle.
    let mut houses = vec![];
    for (x, width, floors, columns, door, plaster, shutters) in [
        (-2.5, 5.0, 3, 3, 1, rose, 0),
        (4.6, 6.6, 2, 4, 1, cream, 1),
        (-8.3, 6.6, 2, 4, 3, ochre, 2),
        (10.6, 5.4, 3, 3, 0, clay, 0),
    ] {
        let frame = Frame::at(Vec3::new(x, 0.0, FAR));
        houses.push(House { frame, width, floors, columns, door, plaster, shutters });
    }
    // Along the left and the right side, the far ones first.
    for (side, z, width, floors, columns, door, plaster, shutters) in [
        (0, -13.2, 6.4, 3, 3, 1, cream, 1),
        (1, -13.0, 6.6, 2, 4, 2, ochre, 1),
        (0, -7.0, 6.0, 2, 3, 0, clay, 2),
        (1, -6.6, 6.2, 3, 3, 1, rose, 2),
        (0, -0.7, 6.6, 2, 4, 2, mist, 0),
        (1, -0.3, 6.4, 2, 3, 1, mist, 0),
    ] {
        let turn = if side == 0 { 90.0 } else { -90.0 };
        let frame = Frame::at(Vec3::new(SIDES[side], 0.0, z)).turned(Vec3::Y, turn);
        houses.push(House { frame, width, floors, columns, door, plaster, shutters });
    }
    houses.truncate(number(triangles, FEWEST, [2, 10]) as usize);
    houses
}

/// Sides, backs and gables in the color of each house, its ledges, a chimney, a door step. The fronts belong to the
/// windows.
pub(super) fn walls(builder: &mut Builder, houses: &[House], triangles: u32) {
    const FEWEST: u32 = 24;
    let each = triangles / u32::try_from(houses.len()).unwrap_or(1);
    for house in houses {
        builder.part("plaster", house.plaster());
        let (half, high, top) = (house.width / 2.0, house.eaves(), house.eaves() + house.rise());
        let at = |x: f32, y: f32, z: f32| house.frame.point_to_world(Vec3::new(x, y, z));
        let back = -DEPTH;
        builder.quad([at(half, 0.0, back), at(-half, 0.0, back), at(-half, high, back), at(half, high, back)]);
        for side in [-half, half] {
            // A wall and its gable; seen from outside, the front is on the right of the left wall.
            let [left, right] = if side < 0.0 { [back, 0.0] } else { [0.0, back] };
            let corners = [at(side, 0.0, left), at(side, 0.0, right), at(side, high, right), at(side, high, left)];
            let [a, b, c, d] = corners.map(|corner| builder.vertex(corner));
            let ridge = builder.vertex(at(side, top, back / 2.0));
            builder.triangle([a, b, c]);
            builder.triangle([a, c, d]);
            builder.triangle([d, c, ridge]);
        }
    }
    builder.part("ledges", Phong::of(srgb(232, 218, 192), 0.0, 1.0));
    if each < FEWEST {
        return;
    }
    for house in houses {
        let half = house.width / 2.0;
        for (y, height, out) in
            [(0.0, 0.45, 0.05), (house.floor(1) - 0.12, 0.14, 0.08), (house.eaves() - 0.22, 0.2, 0.16)]
        {
            builder.cuboid(&house.frame, Vec3::new(-half, y, -0.1), Vec3::new(half, y + height, out));
        }
        let door = house.column(house.door);
        builder.cuboid(&house.frame, Vec3::new(door - 0.8, 0.0, 0.0), Vec3::new(door + 0.8, 0.14, 0.5));
    }
    builder.part("chimneys", Phong::of(srgb(196, 150, 122), 0.0, 1.0));
    for house in houses {
        let x = house.width * 0.27;
        let y = house.eaves() + house.rise() * 0.5;
        builder.cuboid(&house.frame, Vec3::new(x - 0.3, y, -2.9), Vec3::new(x + 0.3, y + 1.7, -2.3));
        builder.cuboid(&house.frame, Vec3::new(x - 0.37, y + 1.7, -2.97), Vec3::new(x + 0.37, y + 1.82, -2.23));
    }
}

impl House {
    /// What its walls are made of.
    pub(super) fn plaster(&self) -> Phong {
        Phong::of(self.plaster, 0.0, 1.0)
    }
}
