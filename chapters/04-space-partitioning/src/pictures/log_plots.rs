//! What was measured with growing scenes, as curves over the number of triangles: two plots side by side.

use common::{
    Vec2,
    drawing::{
        CHALK, Drawing, SLATE,
        lettering::{Align, Lettering},
        mark::Pen,
        plot::{Axis, Curve, Legend, Plot, Scale},
    },
};

use super::palette::color;
use crate::{
    choice::Choice,
    measured::{Measured, growth},
};

/// The page of both, and of each.
pub(super) const PAGE: Vec2 = Vec2::new(960.0, 460.0);
const PANEL: Vec2 = Vec2::new(480.0, 460.0);

/// What one of the plots shows.
pub(super) struct Shown {
    /// Its headline.
    pub(super) title: &'static str,
    /// The axis upward.
    pub(super) y: Axis,
    /// The value of a measurement.
    pub(super) value: fn(&Measured) -> f32,
    /// Where the legend starts, in values of the axes.
    pub(super) legend: [f32; 2],
    /// Ends of a dashed line: what brute force would need, where that is known without a measurement.
    pub(super) known: Option<[[f32; 2]; 2]>,
}

/// Both plots on a page, with a curve for each of the structures.
pub(super) fn draw(choices: &[Choice], shown: [Shown; 2]) -> Drawing {
    let measured = growth();
    let mut page = Drawing::new(PAGE, SLATE);
    for (i, shown) in (0_u8..).zip(shown) {
        page.paste(panel(choices, &measured, &shown), Vec2::X * (f32::from(i) * PANEL.x));
    }
    page
}

/// One of the two.
fn panel(choices: &[Choice], measured: &[Measured], shown: &Shown) -> Drawing {
    let points = |choice| points(measured, choice, shown.value);
    let curve = |&choice: &Choice| Curve { points: points(choice), pen: pen(choice) };
    let keys = choices.iter().map(|&choice| (pen(choice), name_of(choice))).collect();
    let mut curves: Vec<Curve> = choices.iter().map(curve).collect();
    curves.extend(shown.known.map(|ends| Curve {
        points: ends.map(Vec2::from_array).to_vec(),
        pen: Pen { dashes: Some([7.0, 6.0]), ..pen(Choice::BruteForce) },
    }));
    let plot = Plot {
        page: PANEL,
        x: Axis { name: "triangles", unit: "", range: [80.0, 1.3e7], scale: Scale::Logarithmic },
        y: shown.y,
        curves,
        legends: vec![Legend { at: Vec2::from_array(shown.legend), keys }],
    };
    let mut drawing = plot.drawing();
    // A dot for each measurement.
    for &choice in choices {
        for point in points(choice) {
            drawing.disc(plot.place(point), 3.6, color(choice));
        }
    }
    let middle = Vec2::new(plot.place(Vec2::new(plot.x.range[1], plot.y.range[1])).x, 30.0);
    drawing.text(shown.title, middle, Lettering::new(22.0, CHALK).aligned(Align::Right));
    drawing
}

/// The values of a structure over the number of triangles.
fn points(measured: &[Measured], choice: Choice, value: fn(&Measured) -> f32) -> Vec<Vec2> {
    let of_choice = measured.iter().filter(|measured| measured.row.choice == choice);
    of_choice.map(|measured| Vec2::new(measured.row.triangles as f32, value(measured))).collect()
}

/// Its name in the legend.
fn name_of(choice: Choice) -> &'static str {
    if choice == Choice::BruteForce { "brute force" } else { choice.name() }
}

/// What the curve of a structure is drawn with.
fn pen(choice: Choice) -> Pen {
    Pen::new(color(choice), 2.6)
}
