//! Charts as SVG files.

use common::Error;
use plotters::{
    coord::{
        Shift,
        combinators::LogCoord,
        ranged1d::{Ranged, ValueFormatter},
        types::RangedCoordf64,
    },
    element::DashedPathElement,
    prelude::*,
};

use crate::chart::{Axis, Chart};

/// Width and height in pixels.
const SIZE: (u32, u32) = (900, 520);
/// Room at the right, for the keys.
const KEYS: u32 = 190;
/// For readers of every kind of color vision, on white. Source: Okabe, Ito, *Color Universal Design*, 2008.
const COLORS: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
];

/// The chart as the text of an SVG file.
///
/// # Errors
/// [`Error::Report`] if it cannot be drawn.
pub fn svg(chart: &Chart) -> Result<String, Error> {
    let (x, y) = (chart.range(0), chart.range(1));
    match (chart.x.is_logarithmic, chart.y.is_logarithmic) {
        (false, false) => draw(chart, linear(x), linear(y)),
        (false, true) => draw(chart, linear(x), logarithmic(y)),
        (true, false) => draw(chart, logarithmic(x), linear(y)),
        (true, true) => draw(chart, logarithmic(x), logarithmic(y)),
    }
}

fn linear([min, max]: [f64; 2]) -> RangedCoordf64 {
    (min..max).into()
}

fn logarithmic([min, max]: [f64; 2]) -> LogCoord<f64> {
    (min..max).log_scale().into()
}

fn draw<X, Y>(chart: &Chart, x: X, y: Y) -> Result<String, Error>
where
    X: Ranged<ValueType = f64> + ValueFormatter<f64>,
    Y: Ranged<ValueType = f64> + ValueFormatter<f64>,
{
    let mut text = String::new();
    {
        let page = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        page.fill(&WHITE).map_err(failed)?;
        let mut builder = ChartBuilder::on(&page);
        builder.caption(&chart.title, ("sans-serif", 20)).margin(12).margin_right(KEYS);
        let mut plot = builder.x_label_area_size(44).y_label_area_size(70).build_cartesian_2d(x, y).map_err(failed)?;
        plot.configure_mesh()
            .x_desc(chart.x.name)
            .y_desc(chart.y.name)
            .x_label_formatter(&|value| label(chart.x, *value))
            .y_label_formatter(&|value| label(chart.y, *value))
            .light_line_style(WHITE)
            .draw()
            .map_err(failed)?;
        for (i, line) in chart.lines.iter().enumerate() {
            let style = COLORS[line.color % COLORS.len()].stroke_width(2);
            let points: Vec<(f64, f64)> = shown(chart, &line.points).collect();
            if line.is_dashed {
                plot.draw_series(DashedLineSeries::new(points, 6, 4, style)).map_err(failed)?;
            } else {
                plot.draw_series(LineSeries::new(points, style)).map_err(failed)?;
            }
            draw_key(&page, i, &line.name, style, line.is_dashed)?;
        }
        page.present().map_err(failed)?;
    }
    Ok(text)
}

/// The points that have a place on the axes.
fn shown<'c>(chart: &'c Chart, points: &'c [[f64; 2]]) -> impl Iterator<Item = (f64, f64)> + 'c {
    let fits = |axis: Axis, value: f64| value.is_finite() && (!axis.is_logarithmic || value > 0.0);
    points.iter().filter(move |[x, y]| fits(chart.x, *x) && fits(chart.y, *y)).map(|[x, y]| (*x, *y))
}

/// A piece of the line and its name, to the right of the plot.
fn draw_key(
    page: &DrawingArea<SVGBackend, Shift>,
    i: usize,
    name: &str,
    style: ShapeStyle,
    is_dashed: bool,
) -> Result<(), Error> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "few lines")]
    let y = 60 + 24 * i as i32;
    #[expect(clippy::cast_possible_wrap, reason = "a small page")]
    let x = (SIZE.0 - KEYS) as i32 + 12;
    let ends = [(x, y), (x + 28, y)];
    if is_dashed {
        page.draw(&DashedPathElement::new(ends, 6, 4, style)).map_err(failed)?;
    } else {
        page.draw(&PathElement::new(ends, style)).map_err(failed)?;
    }
    page.draw(&Text::new(name, (x + 36, y - 7), ("sans-serif", 14))).map_err(failed)
}

/// A number beside an axis.
fn label(axis: Axis, value: f64) -> String {
    if axis.is_logarithmic && !(0.01..1e4).contains(&value) {
        format!("{value:.0e}")
    } else {
        format!("{}", (value * 1e6).round() / 1e6)
    }
}

fn failed(error: impl std::fmt::Display) -> Error {
    Error::Report(error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::Line;

    fn chart(points: &[[f64; 2]], [x, y]: [bool; 2]) -> Chart {
        let line = |name: &str, is_dashed| Line { name: name.into(), points: points.into(), color: 7, is_dashed };
        Chart {
            title: "t < u".into(),
            x: Axis { name: "count", is_logarithmic: x },
            y: Axis { name: "error", is_logarithmic: y },
            lines: vec![line("plain", false), line("dashed", true)],
        }
    }

    #[test]
    fn every_chart_can_be_drawn() {
        for axes in [[false, false], [false, true], [true, false], [true, true]] {
            let many: Vec<_> = (0..100).map(|i| [f64::from(i), 1.0 / f64::from(i)]).collect();
            for points in [&many[..], &[], &[[1.0, 1.0]], &[[0.0, -1.0], [f64::NAN, f64::INFINITY]]] {
                let svg = svg(&chart(points, axes)).unwrap();
                assert!(svg.starts_with("<svg ") && svg.trim_end().ends_with("</svg>"), "{svg}");
                assert!(svg.contains("t &lt; u") && svg.contains("plain") && svg.contains("error"), "{svg}");
                assert!(!svg.contains("NaN"), "{svg}");
            }
        }
    }

    #[test]
    fn labels_are_short() {
        let labels = [(true, 1e-5), (true, 100.0), (false, 0.30000000000000004)];
        let labels = labels.map(|(is_logarithmic, value)| label(Axis { name: "", is_logarithmic }, value));
        assert_eq!(labels, ["1e-5", "100", "0.3"]);
    }
}
