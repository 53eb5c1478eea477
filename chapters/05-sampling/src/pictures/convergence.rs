//! How the error falls as samples are added: regular ones in several dimensions, and random ones.

use common::{
    Error, Rgb, Vec2,
    drawing::{
        Drawing, SLATE,
        lettering::Lettering,
        mark::Pen,
        plot::{Axis, Curve, Plot, Scale},
    },
    film::Size,
    knob::{Knob, Step},
    picture::{Picture, Render, Settings},
};

use super::palette::GOLD;
use crate::{
    experiments::dimension::{Convergence, Effort},
    integrals::{INTEGRALS, NAMES},
};

/// What is integrated.
const INTEGRAL: Knob = Knob::choice("integral", "what is integrated", &NAMES, 1);
/// At most how many samples.
const SAMPLES: Knob =
    Knob::number("samples", "at most how many samples", [256.0, 1_048_576.0], 65_536.0, "", Step::Times(2.0));
/// Over how many runs the random error is averaged.
const RUNS: Knob =
    Knob::number("runs", "over how many runs the random error is averaged", [1.0, 256.0], 32.0, "", Step::Times(2.0));

pub(super) const PICTURE: Picture = Picture {
    name: "convergence",
    alt: "A plot on logarithmic axes: the error of an integral over the number of samples, up to 65,536. Four lines \
          of regular samples, from light blue to violet: in one dimension the error falls steeply, with the slope \
          −1; in two with −½; in four with about −¼; in eight it hardly falls at all. Four golden lines of random \
          samples in the same dimensions lie over each other, all with a slope of about −½.",
    knobs: &[INTEGRAL, SAMPLES, RUNS],
    size: Size::of::<960, 560>(),
    samples: 1,
    takes_mesh: false,
    make,
};

/// The page.
const PAGE: Vec2 = Vec2::new(960.0, 560.0);
/// The dimensions, and the colors of their regular samples.
const DIMENSIONS: [(usize, Rgb); 4] = [
    (1, Rgb::new(0.52, 0.90, 1.0)),
    (2, Rgb::new(0.15, 0.56, 1.0)),
    (4, Rgb::new(0.26, 0.30, 1.0)),
    (8, Rgb::new(0.62, 0.26, 0.95)),
];

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let values = &settings.values;
    let integral = &INTEGRALS[values.index(&INTEGRAL).min(INTEGRALS.len() - 1)];
    let effort = Effort { samples: values.index(&SAMPLES) as u64, runs: values.index(&RUNS), seed: 0 };
    let measured = DIMENSIONS.map(|(dimension, color)| (Convergence::measure(integral, dimension, effort), color));
    let mut curves = Vec::new();
    for (convergence, color) in &measured {
        curves.push(Curve { points: points(&convergence.regular), pen: Pen::new(*color, 2.6) });
        curves.push(Curve { points: points(&convergence.random), pen: Pen { opacity: 0.8, ..Pen::new(GOLD, 2.2) } });
    }
    #[expect(clippy::cast_precision_loss, reason = "a plot")]
    let most = effort.samples as f32;
    let plot = Plot {
        // Room at the right for what stands beside the ends of the lines.
        page: PAGE - Vec2::X * 232.0,
        x: Axis { name: "samples M", unit: "", range: [2.0, most * 1.2], scale: Scale::Logarithmic },
        y: Axis { name: "error", unit: "", range: [range_end(&curves), 1.0], scale: Scale::Logarithmic },
        curves,
        legends: Vec::new(),
    };
    let mut drawing = Drawing::new(PAGE, SLATE);
    drawing.paste(plot.drawing(), Vec2::ZERO);
    for (convergence, color) in &measured {
        for point in points(&convergence.regular) {
            drawing.disc(plot.place(point), 3.4, *color);
        }
    }
    // What the lines mean, beside their ends.
    let lettering = |color| Lettering::new(Plot::LETTER, color);
    let mut labels: Vec<(f32, Rgb, String)> = Vec::new();
    for (convergence, color) in &measured {
        let name = format!("regular, D = {}: slope {}", convergence.dimension, slope(convergence.slopes()[0]));
        labels.extend(end(&plot, &convergence.regular).map(|y| (y, *color, name)));
    }
    let ends: Vec<f32> = measured.iter().filter_map(|(convergence, _)| end(&plot, &convergence.random)).collect();
    let slopes: Vec<f64> = measured.iter().filter_map(|(convergence, _)| convergence.slopes()[1]).collect();
    if let [first, .., last] = ends[..] {
        let mean = slopes.iter().sum::<f64>() / slopes.len() as f64;
        labels.push(((first + last) / 2.0, GOLD, format!("random, all D: slope {}", slope(Some(mean)))));
    }
    // From top to bottom, none over another.
    labels.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut free = 0.0_f32;
    for (y, color, text) in labels {
        let y = y.max(free);
        free = y + 1.25 * Plot::LETTER;
        let letters = lettering(color.lerp(Rgb::ONE, 0.2));
        let x = plot.place(Vec2::new(most, 1.0)).x + 10.0;
        drawing.text(&text, Vec2::new(x, y + letters.drop()), letters);
    }
    Ok(Box::new(drawing))
}

/// Points of a curve; an error of 0 has no place on a logarithmic axis.
fn points(measured: &[[f64; 2]]) -> Vec<Vec2> {
    #[expect(clippy::cast_possible_truncation, reason = "a plot")]
    let point = |[count, error]: &[f64; 2]| Vec2::new(*count as f32, *error as f32);
    measured.iter().map(point).filter(|point| point.y > 1e-30).collect()
}

/// A power of ten below all points.
fn range_end(curves: &[Curve]) -> f32 {
    let least = curves.iter().flat_map(|curve| &curve.points).map(|point| point.y).fold(1.0, f32::min);
    std::iter::successors(Some(0.1), |end| Some(end / 10.0)).find(|end| *end <= least).unwrap_or(1e-30)
}

/// The height on the page at which a line ends.
fn end(plot: &Plot, measured: &[[f64; 2]]) -> Option<f32> {
    points(measured).last().map(|point| plot.place(*point).y)
}

/// A slope in figures.
fn slope(slope: Option<f64>) -> String {
    slope.map_or("unknown".into(), |slope| format!("{slope:.2}").replace('-', "−"))
}
