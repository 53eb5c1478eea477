//! Which share of light is reflected, over the angle at which it comes in.

use common::{
    Error, Rgb, Vec2,
    drawing::{
        CHALK, Drawing, FAINT, SLATE,
        lettering::{Align, Lettering},
        mark::Pen,
        plot::{Axis, Curve, Legend, Plot, Scale},
    },
    film::Size,
    float,
    picture::{Picture, Render, Settings},
};
use ray_casting::hit::Side;

use crate::material::{Fresnel, Material};

pub(super) const PICTURE: Picture = Picture {
    name: "reflectance",
    alt: "Four plots of reflectance over the angle of incidence, from 0° to 90°. Gold reflects most of the red, a \
          little less green and far less blue; silver nearly all of the three colors; copper most of the red and \
          somewhat more than half of the green and blue; each of them rises to 100 % at 90°. Glass reflects 4 % up to \
          about 50° and then rises steeply; from inside it rises at 30° and is 100 % from 42° on. Dashed lines, the \
          approximation, lie close to the solid ones.",
    knobs: &[],
    size: Size::of::<960, 720>(),
    samples: 1,
    takes_mesh: false,
    make,
};

/// One plot of the four, in units of the page.
const PANEL: Vec2 = Vec2::new(480.0, 360.0);
/// The index of the glass.
const GLASS: f32 = 1.5;
/// Red, green and blue light, as they are drawn.
const LIGHTS: [(&str, Rgb); 3] =
    [("red", Rgb::new(0.90, 0.12, 0.09)), ("green", Rgb::new(0.13, 0.56, 0.14)), ("blue", Rgb::new(0.12, 0.31, 0.95))];
/// The line for light that comes from inside of glass.
const FROM_INSIDE: Rgb = Rgb::new(0.92, 0.60, 0.16);
/// Glass, from outside and from inside.
const SIDES: [(Side, &str, Rgb); 2] =
    [(Side::Outside, "from the air", Rgb::new(0.34, 0.68, 0.90)), (Side::Inside, "from inside", FROM_INSIDE)];

fn make(_settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let mut page = Drawing::new(2.0 * PANEL, SLATE);
    let metals = [("Gold", Material::GOLD), ("Silver", Material::SILVER), ("Copper", Material::COPPER)];
    let mut plots: Vec<_> = metals.map(|(name, material)| (name, metal(&material))).into();
    let glass = glass();
    let note = PANEL + glass.place(Vec2::new(46.0, 92.0));
    plots.push(("Glass", glass));
    for ((name, plot), cell) in plots.into_iter().zip([Vec2::ZERO, Vec2::X, Vec2::Y, Vec2::ONE]) {
        let mut drawing = plot.drawing();
        let middle = plot.place(Vec2::new(45.0, 100.0)) - Vec2::Y * 12.0;
        let name_lettering = Lettering::new(24.0, CHALK).aligned(Align::Center);
        drawing.text(name, middle, name_lettering);
        page.paste(drawing, cell * PANEL);
    }
    page.text("total reflection", note, Lettering::new(Plot::LETTER, FROM_INSIDE));
    Ok(Box::new(page))
}

/// A metal: each color of light by itself.
fn metal(material: &Material) -> Plot {
    let mut curves = Vec::new();
    for (channel, (_, color)) in LIGHTS.into_iter().enumerate() {
        curves.extend(curve_pair(material, Side::Outside, channel, color));
    }
    let lights = LIGHTS.map(|(name, color)| (exact(color), name)).to_vec();
    plot(curves, [legend([8.0, 26.0], lights), legend([42.0, 26.0], formulas())])
}

/// Glass: all colors of light alike, but the two sides are not.
fn glass() -> Plot {
    let glass = Material::glass(GLASS);
    let curves = SIDES.into_iter().flat_map(|(side, _, color)| curve_pair(&glass, side, 0, color)).collect();
    let sides = SIDES.map(|(_, name, color)| (exact(color), name)).to_vec();
    plot(curves, [legend([4.0, 88.0], sides), legend([4.0, 66.0], formulas())])
}

/// A material's reflectance for one channel of the color: exact, and over it approximate.
fn curve_pair(material: &Material, side: Side, channel: usize, color: Rgb) -> [Curve; 2] {
    /// Four to a degree.
    const PIECES: u16 = 360;
    [(Fresnel::Exact, exact(color)), (Fresnel::Approximate, approximate(color))].map(|(fresnel, pen)| {
        Curve::of([0.0, 90.0], PIECES, pen, |degrees| {
            let cosine = float::cos(degrees.to_radians());
            100.0 * material.reflectance(cosine, side, fresnel)[channel]
        })
    })
}

fn exact(color: Rgb) -> Pen {
    Pen::new(color, 2.4)
}

/// Paler, so that it is seen where it lies over the exact one.
fn approximate(color: Rgb) -> Pen {
    Pen { dashes: Some([6.0, 6.0]), ..Pen::new(color.lerp(Rgb::ONE, 0.5), 2.0) }
}

fn formulas() -> Vec<(Pen, &'static str)> {
    vec![(exact(FAINT), "exact"), (approximate(FAINT), "approximate")]
}

fn legend(at: [f32; 2], keys: Vec<(Pen, &'static str)>) -> Legend {
    Legend { at: Vec2::from_array(at), keys }
}

fn plot(curves: Vec<Curve>, legends: [Legend; 2]) -> Plot {
    let x = Axis { name: "angle of incidence", unit: "°", range: [0.0, 90.0], scale: Scale::Linear { step: 15.0 } };
    let y = Axis { name: "reflectance", unit: " %", range: [0.0, 100.0], scale: Scale::Linear { step: 20.0 } };
    Plot { page: PANEL, x, y, curves, legends: legends.into() }
}
