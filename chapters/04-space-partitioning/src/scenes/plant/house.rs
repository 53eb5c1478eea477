//! The boiler house: an open frame of many storeys with floors of gratings, railings and stairs.

use common::{Vec3, color::srgb, float};
use ray_casting::material::Phong;

use super::{
    super::{budget::share, builder::Builder, chance::Chance, cuboid},
    steel::{column, flight, girder, grating, plate, railing},
};

/// The two corners of the house, in meters.
pub(super) const LOW: Vec3 = Vec3::new(-30.0, 0.0, -38.0);
pub(super) const HIGH: Vec3 = Vec3::new(16.0, 48.0, -6.0);
/// Number of bays along x, y and z in a scene of middle size.
const BAYS: Vec3 = Vec3::new(5.0, 7.0, 4.0);
/// There are at most so many times more bays along each axis, so that one can see through.
const FINEST: f32 = 1.25;

/// The frame's grid.
struct Grid {
    bays: [u32; 3],
}

impl Grid {
    /// As fine as so many triangles allow, when each bay has about four beams.
    fn of(triangles: u32) -> Self {
        let scale = (triangles as f32 / (BAYS.element_product() * 4.0 * cuboid::COST as f32)).max(0.0);
        let scale = float::cbrt(scale).min(FINEST);
        Self { bays: (BAYS * scale).to_array().map(|bays| (bays as u32).max(1)) }
    }

    /// A crossing of the grid.
    fn at(&self, x: u32, y: u32, z: u32) -> Vec3 {
        let [nx, ny, nz] = self.bays.map(|bays| bays as f32);
        LOW + (HIGH - LOW) * Vec3::new(x as f32 / nx, y as f32 / ny, z as f32 / nz)
    }

    /// Number of floors' bays.
    fn floors(&self) -> u32 {
        self.bays.iter().product()
    }
}

/// The house, with about so many triangles at most.
pub(super) fn house(builder: &mut Builder, triangles: u32, chance: &mut Chance) {
    builder.part("steel frame", Phong::of(srgb(92, 112, 118), 0.25, 20.0));
    if triangles < 200 {
        return plate(builder, LOW, HIGH);
    }
    let for_frame = share(triangles, 0.32);
    let grid = Grid::of(for_frame);
    frame(builder, &grid, for_frame);

    // Floors: about two bays of three have one, and the ground has none.
    builder.part("gratings", Phong::of(srgb(142, 144, 142), 0.2, 20.0));
    let [nx, ny, nz] = grid.bays;
    let for_floor = share(triangles, 0.4) / grid.floors();
    for y in 1..=ny {
        for (x, z) in (0..nx).flat_map(|x| (0..nz).map(move |z| (x, z))) {
            let is_first = (x, y, z) == (0, 1, 0);
            if is_first || chance.happens(0.68) {
                let (low, high) = (grid.at(x, y, z), grid.at(x + 1, y, z + 1));
                grating(builder, low + Vec3::Y * 0.14, high + Vec3::Y * 0.22, share(for_floor, 1.4));
            }
        }
    }

    // Railings on all four sides of each storey.
    builder.part("railings and stairs", Phong::of(srgb(226, 176, 56), 0.3, 30.0));
    let edges = 2 * (nx + nz) * ny;
    let for_edge = share(triangles, 0.2) / edges;
    let up = Vec3::Y * 0.2;
    for y in 1..=ny {
        for x in 0..nx {
            railing(builder, grid.at(x, y, 0) + up, grid.at(x + 1, y, 0) + up, for_edge);
            railing(builder, grid.at(x, y, nz) + up, grid.at(x + 1, y, nz) + up, for_edge);
        }
        for z in 0..nz {
            railing(builder, grid.at(0, y, z) + up, grid.at(0, y, z + 1) + up, for_edge);
            railing(builder, grid.at(nx, y, z) + up, grid.at(nx, y, z + 1) + up, for_edge);
        }
    }

    // Stairs before the front, to and fro.
    let storeys = BAYS.y as u32;
    let for_flight = share(triangles, 0.08) / storeys;
    let rise = (HIGH.y - LOW.y) / storeys as f32;
    for storey in 0..storeys {
        let (left, right) = (HIGH.x - 9.5, HIGH.x - 1.0);
        let (from, to) = if storey % 2 == 0 { (left, right) } else { (right, left) };
        let place = |x: f32, storey: u32| Vec3::new(x, LOW.y + rise * storey as f32, HIGH.z + 0.6);
        flight(builder, place(from, storey), place(to, storey + 1), Vec3::Z * 1.4, for_flight);
    }
}

/// Columns in all crossings and girders between them.
fn frame(builder: &mut Builder, grid: &Grid, triangles: u32) {
    let [nx, ny, nz] = grid.bays;
    let columns = (nx + 1) * (nz + 1);
    let girders = ny * ((nx + 1) * nz + nx * (nz + 1));
    let for_column = share(triangles, 0.2) / columns;
    let for_girder = share(triangles, 0.8) / girders;
    for (x, z) in (0..=nx).flat_map(|x| (0..=nz).map(move |z| (x, z))) {
        column(builder, grid.at(x, 0, z), grid.at(x, ny, z), 0.6, for_column);
        for y in 1..=ny {
            if x < nx {
                girder(builder, grid.at(x, y, z), grid.at(x + 1, y, z), 0.42, for_girder);
            }
            if z < nz {
                girder(builder, grid.at(x, y, z), grid.at(x, y, z + 1), 0.42, for_girder);
            }
        }
    }
}
