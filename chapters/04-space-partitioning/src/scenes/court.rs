//! The court: two storeys of arcades around a paved court with a fountain, banners and plants in pots.
//!
//! It has the character and size of CRYTEK SPONZA: columns, arches and moldings, cloths and leaves.

mod arcade;
mod fittings;
mod garden;
mod tower;
mod trim;

use common::{Rgb, Vec3, color::srgb};
use ray_casting::{
    frame::Frame,
    light::{DirectionalLight, Light, PointLight},
    mesh::Shading,
};

use super::{
    Generator,
    budget::{ratio, share},
    builder::Builder,
    fountain::fountain,
};
use crate::model::{Model, View};

/// The family of courts.
pub const GENERATOR: Generator = Generator { name: "court", full_size: 262_000, make };

/// Half the width of the open court.
const HALF_WIDTH: f32 = 4.5;
/// z of the arcade at the far end; the court begins at 0.
const FAR: f32 = -18.0;
/// From an arcade's face to the wall behind it.
const GALLERY: f32 = 3.2;
/// Thickness of the walls above the arches.
const THICK: f32 = 0.5;
/// Height of the eaves.
const EAVES: f32 = 9.0;

/// One of the two storeys.
#[derive(Clone, Copy)]
struct Storey {
    /// Height of its floor.
    floor: f32,
    /// Height of the capitals' upper sides.
    spring: f32,
    /// Height of the wall's upper edge.
    top: f32,
    /// Radius of the columns.
    column: f32,
}

/// From below.
const STOREYS: [Storey; 2] = [
    Storey { floor: 0.0, spring: 3.0, top: 4.9, column: 0.25 },
    Storey { floor: 5.15, spring: 7.1, top: 8.75, column: 0.19 },
];

/// How the three sides are divided into bays, one arch each.
#[derive(Clone, Copy)]
struct Bays {
    /// Along each long side.
    side: u32,
    /// At the far end.
    end: u32,
}

impl Bays {
    /// Few where there are few triangles.
    fn of(triangles: u32) -> Self {
        if triangles < 700 { Bays { side: 2, end: 1 } } else { Bays { side: 6, end: 3 } }
    }

    /// Whether columns carry the arches, or mere walls.
    fn has_columns(self) -> bool {
        self.side > 2
    }

    /// The middle of each bay at the height 0, on the arcade's face, which looks along the frame's z.
    fn frames(self) -> Vec<Frame> {
        let mut frames = vec![];
        for turn in [90.0, -90.0] {
            let x = if turn > 0.0 { -HALF_WIDTH } else { HALF_WIDTH };
            for i in 0..self.side {
                let z = FAR * (ratio(i, self.side) + 0.5 / ratio(self.side, 1));
                frames.push(Frame::at(Vec3::new(x, 0.0, z)).turned(Vec3::Y, turn));
            }
        }
        for i in 0..self.end {
            let x = HALF_WIDTH * (2.0 * (ratio(i, self.end) + 0.5 / ratio(self.end, 1)) - 1.0);
            frames.push(Frame::at(Vec3::new(x, 0.0, FAR)));
        }
        frames
    }

    /// Where columns stand: between two bays, under the middle of the wall.
    fn columns(self) -> Vec<Vec3> {
        let middle = HALF_WIDTH + THICK / 2.0;
        let side = (0..self.side).map(|i| FAR * ratio(i, self.side));
        let long = side.flat_map(|z| [-middle, middle].map(|x| Vec3::new(x, 0.0, z)));
        let end = (1..self.end).map(|i| HALF_WIDTH * (2.0 * ratio(i, self.end) - 1.0));
        long.chain(end.map(|x| Vec3::new(x, 0.0, FAR - THICK / 2.0))).collect()
    }

    /// Width of one bay.
    fn width(self) -> f32 {
        -FAR / ratio(self.side, 1)
    }
}

fn make(triangles: u32) -> Model {
    let part = |of: f32| share(triangles, of);
    let bays = Bays::of(triangles);
    let mut builder = Builder::default();
    // The building.
    arcade::arches(&mut builder, bays, part(0.13));
    arcade::galleries(&mut builder);
    arcade::moldings(&mut builder, bays, part(0.07));
    arcade::columns(&mut builder, bays, part(0.25));
    trim::cornices(&mut builder, part(0.05));
    trim::balustrades(&mut builder, bays, part(0.1));
    trim::paving(&mut builder, part(0.06));
    // What is in it.
    fittings::doors(&mut builder, bays, part(0.02));
    fittings::banners(&mut builder, bays, part(0.05));
    fittings::lanterns(&mut builder, bays, part(0.03));
    fountain(&mut builder, Vec3::new(0.0, 0.0, FAR / 2.0), part(0.04));
    tower::bell_tower(&mut builder, part(0.03));
    // Leaves have what is left.
    garden::plants(&mut builder, triangles);
    builder.without_empty_parts();
    Model {
        mesh: builder.mesh,
        shading: Shading::Smooth,
        parts: builder.parts,
        view: View { eye: Vec3::new(1.5, 1.9, 1.6), lookat: Vec3::new(-0.5, 4.0, -12.0), field_of_view: 54.0 },
        lights: lights(),
        ambient: Rgb::new(0.22, 0.235, 0.29),
        background: srgb(112, 168, 224),
    }
}

/// The sun, the sky, what the sunlit floor sends back, and lanterns in the galleries.
fn lights() -> Vec<Box<dyn Light>> {
    let mut lights: Vec<Box<dyn Light>> = vec![
        Box::new(DirectionalLight::new(Vec3::new(0.62, 1.0, 0.5), Rgb::new(5.2, 4.2, 2.8))),
        Box::new(DirectionalLight::new(Vec3::new(-0.1, 1.0, 0.12), Rgb::new(0.42, 0.5, 0.64))),
        Box::new(DirectionalLight::new(Vec3::new(-0.35, 0.8, 1.0), Rgb::new(0.26, 0.28, 0.34))),
        Box::new(PointLight { position: Vec3::new(-2.4, 0.9, -7.0), intensity: Rgb::new(5.0, 4.1, 2.9) }),
    ];
    for z in [-4.5, -13.5] {
        for side in [-1.0, 1.0] {
            let position = Vec3::new(side * (HALF_WIDTH + 1.7), fittings::LANTERN - 0.05, z);
            lights.push(Box::new(PointLight { position, intensity: Rgb::new(9.0, 5.7, 2.8) }));
        }
    }
    lights
}
