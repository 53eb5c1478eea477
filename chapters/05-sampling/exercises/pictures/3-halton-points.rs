//! Picture of exercise 5.3: random points and Halton points, and how their errors fall.

use common::{
    Error, Rgb, Stream, Vec2,
    color::srgb,
    drawing::{
        CHALK, Drawing, GRID, SLATE,
        lettering::{Align, Lettering},
        mark::Pen,
        plot::{Axis, Curve, Legend, Plot, Scale},
    },
    knob::{Knob, Step},
    picture::{Picture, Render, Settings},
};

use super::Make;
use crate::checks::discrepancy::error;

const POINTS: Knob = Knob::number("points", "points that are drawn", [4.0, 4096.0], 256.0, "", Step::Times(2.0));

/// Random points: gold. Halton points: green.
const GOLD: Rgb = Rgb::new(1.0, 0.56, 0.08);
const GREEN: Rgb = Rgb::new(0.25, 0.75, 0.35);
/// The page, the side of a square of points, and where the two stand.
const PAGE: Vec2 = Vec2::new(960.0, 540.0);
const SIDE: f32 = 216.0;
const CORNERS: [Vec2; 2] = [Vec2::new(24.0, 44.0), Vec2::new(24.0, 306.0)];

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "Left, two squares of 256 points, above random golden ones in heaps and gaps, below green Halton points, evenly spread. \
               Right, a plot on logarithmic axes of the error of a mean over the number of points: a golden line that falls with \
               the slope −½, and a green one that starts lower and falls about twice as steeply.";
    Picture { knobs: &[POINTS], ..super::picture("5.3-halton-points", alt, make) }
}

/// Both sorts of points, the second by the student.
pub(crate) fn make(settings: &Settings, halton: fn(u64) -> [f64; 2]) -> Result<Box<dyn Render>, Error> {
    let count = settings.values.index(&POINTS) as u64;
    let random = |index: u64| {
        let mut random = Stream::new(5, index, 0);
        [(); 2].map(|()| f64::from(random.uniform()))
    };
    let mut drawing = Drawing::new(PAGE, SLATE);
    square(&mut drawing, CORNERS[0], "random", GOLD, (0..count).map(random));
    square(&mut drawing, CORNERS[1], "Halton", GREEN, (0..count).map(halton));
    let curve = |point: &dyn Fn(u64) -> [f64; 2], color| {
        let counts = (2..=13).map(|power| 1_u64 << power);
        #[expect(clippy::cast_possible_truncation, clippy::cast_precision_loss, reason = "a plot")]
        let points = counts.map(|count| Vec2::new(count as f32, error(point, count) as f32));
        Curve { points: points.filter(|p| p.y > 0.0).collect(), pen: Pen::new(color, 2.6) }
    };
    let plot = Plot {
        page: PAGE - Vec2::X * 300.0,
        x: Axis { name: "points M", unit: "", range: [4.0, 8192.0], scale: Scale::Logarithmic },
        y: Axis { name: "error", unit: "", range: [1e-4, 1.0], scale: Scale::Logarithmic },
        curves: vec![curve(&random, GOLD), curve(&halton, GREEN)],
        legends: vec![Legend {
            at: Vec2::new(400.0, 0.55),
            keys: vec![(Pen::new(GOLD, 2.6), "random"), (Pen::new(GREEN, 2.6), "Halton")],
        }],
    };
    drawing.paste(plot.drawing(), Vec2::X * 284.0);
    Ok(Box::new(drawing))
}

/// Points in a square.
fn square(drawing: &mut Drawing, corner: Vec2, name: &str, color: Rgb, points: impl Iterator<Item = [f64; 2]>) {
    let at = |x: f32, y: f32| corner + Vec2::new(x, 1.0 - y) * SIDE;
    drawing.polygon(&[at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)], srgb(20, 23, 29), 1.0);
    drawing.line(&[at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0), at(0.0, 0.0)], Pen::new(GRID, 1.4));
    #[expect(clippy::cast_possible_truncation, reason = "a drawing")]
    points.for_each(|[x, y]| {
        drawing.disc(at(x as f32, y as f32), 2.2, color);
    });
    drawing.text(name, at(0.5, 1.0) - Vec2::Y * 12.0, Lettering::new(20.0, CHALK).aligned(Align::Center));
}
