//! Directions by four ways to choose them, seen from the side and from above, and how often each height comes.

use common::{
    Error, Rgb, Stream, Vec2, Vec3,
    drawing::{
        CHALK, Drawing, FAINT, GRID, SLATE,
        lettering::{Align, Lettering},
        mark::Pen,
    },
    film::Size,
    float,
    knob::{Knob, Step},
    picture::{Picture, Render, Settings},
};

use super::palette::{BLUE, GOLD, GREEN, RED};
use crate::{
    cosine_hemisphere::{cosine_hemisphere_pdf, sample_cosine_hemisphere},
    uniform_hemisphere::{sample_uniform_hemisphere, uniform_hemisphere_pdf},
    uniform_sphere::{point_in_cube, sample_uniform_sphere, uniform_sphere_pdf},
    unit_square::sample_unit_square,
};

/// How many directions are drawn as points.
const POINTS: Knob =
    Knob::number("points", "how many directions are drawn", [10.0, 10_000.0], 1000.0, "", Step::Times(2.0));

pub(super) const PICTURE: Picture = Picture {
    name: "hemisphere-samples",
    alt: "Four columns of 1,000 directions each, as points of the unit sphere seen from the side and from above, \
          with a histogram of the cosine of the angle to the vertical and the density that is claimed. Red, points \
          of a cube that were not rejected: from above four clusters lie toward the corners, and the bars have two \
          peaks where the claimed line is level. Gold, the uniform sphere: even all over, bars all of one height. \
          Blue, the uniform hemisphere: the upper half only, bars of one height from 0 to 1. Green, the cosine \
          hemisphere: sparse near the horizon, evenly spread over the disc seen from above, and bars that rise in a \
          straight line.",
    knobs: &[POINTS],
    size: Size::of::<960, 660>(),
    samples: 1,
    takes_mesh: false,
    make,
};

/// The page, and the width of a column.
const PAGE: Vec2 = Vec2::new(960.0, 660.0);
const COLUMN: f32 = 240.0;
/// Radius of the sphere; heights of its middle seen from the side and from above.
const RADIUS: f32 = 90.0;
const MIDDLES: [f32; 2] = [172.0, 378.0];
/// The histogram: half its width, and heights of its lower and upper edge.
const HALF: f32 = 90.0;
const EDGES: [f32; 2] = [606.0, 506.0];
/// Bars from −1 to 1, and the directions that they count.
const BARS: u8 = 40;
const COUNTED: u32 = 200_000;

/// A way to choose directions.
struct Way {
    name: &'static str,
    /// What is claimed of its density.
    claim: &'static str,
    color: Rgb,
    draw: fn(&mut Stream) -> Vec3,
    /// The claimed density per steradian, by cosθ.
    pdf: fn(f32) -> f32,
    /// The density of cosθ at the top of the histogram, and where it has a tick.
    most: f32,
    tick: (f32, &'static str),
}

const WAYS: [Way; 4] = [
    Way {
        name: "cube, not rejected",
        claim: "not p = 1/(4π)",
        color: RED,
        draw: |random| point_in_cube(random).normalize_or(Vec3::Z),
        pdf: |_| uniform_sphere_pdf(),
        most: 0.8,
        tick: (0.5, "½"),
    },
    Way {
        name: "uniform sphere",
        claim: "p = 1/(4π)",
        color: GOLD,
        draw: |random| sample_uniform_sphere(sample_unit_square(random)),
        pdf: |_| uniform_sphere_pdf(),
        most: 0.8,
        tick: (0.5, "½"),
    },
    Way {
        name: "uniform hemisphere",
        claim: "p = 1/(2π)",
        color: BLUE,
        draw: |random| sample_uniform_hemisphere(sample_unit_square(random)),
        pdf: uniform_hemisphere_pdf,
        most: 2.2,
        tick: (1.0, "1"),
    },
    Way {
        name: "cosine hemisphere",
        claim: "p = cosθ/π",
        color: GREEN,
        draw: |random| sample_cosine_hemisphere(sample_unit_square(random)),
        pdf: cosine_hemisphere_pdf,
        most: 2.2,
        tick: (1.0, "1"),
    },
];

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let count = settings.values.index(&POINTS);
    let mut page = Drawing::new(PAGE, SLATE);
    for (i, way) in (0_u8..).zip(&WAYS) {
        let middle = COLUMN * (f32::from(i) + 0.5);
        let title = Lettering::new(20.0, CHALK).aligned(Align::Center);
        page.text(way.name, Vec2::new(middle, 34.0), title);
        page.text(way.claim, Vec2::new(middle, 62.0), Lettering { size: 17.0, color: FAINT, ..title });
        let mut random = Stream::new(0, i.into(), 0);
        let directions: Vec<Vec3> = (0..count).map(|_| (way.draw)(&mut random)).collect();
        // From the side x goes right, z up, and the viewer is at −y; from above y goes up.
        let [side, above] = MIDDLES.map(|height| Vec2::new(middle, height));
        sphere(&mut page, side, directions.iter().map(|d| Vec3::new(d.x, d.z, -d.y)), way.color);
        page.line(&[side - Vec2::X * RADIUS, side + Vec2::X * RADIUS], Pen::new(GRID, 1.2));
        sphere(&mut page, above, directions.iter().copied(), way.color);
        histogram(&mut page, middle, way, &bars(way, &mut random));
    }
    let note = Lettering::new(17.0, FAINT).aligned(Align::Center);
    page.text("from the side", Vec2::new(PAGE.x / 2.0, 272.0), note);
    page.text("from above", Vec2::new(PAGE.x / 2.0, 486.0), note);
    page.text("cosθ", Vec2::new(PAGE.x / 2.0, 648.0), note);
    Ok(Box::new(page))
}

/// Points of the unit sphere, seen from +z; those behind are dim.
fn sphere(page: &mut Drawing, middle: Vec2, points: impl Iterator<Item = Vec3>, color: Rgb) {
    let circle = |i: u8| {
        let angle = std::f32::consts::TAU * f32::from(i) / 72.0;
        middle + Vec2::new(float::cos(angle), float::sin(angle)) * RADIUS
    };
    page.line(&(0..=72).map(circle).collect::<Vec<_>>(), Pen::new(GRID, 1.4));
    // Those behind first; and neighbors one after the other, because a drawing looks at several marks together.
    let strip = |p: &Vec3| (p.z >= 0.0, (p.x * 12.0).floor(), p.y);
    let mut points: Vec<Vec3> = points.collect();
    points.sort_by(|a, b| strip(a).partial_cmp(&strip(b)).unwrap_or(std::cmp::Ordering::Equal));
    for point in points {
        let share = if point.z < 0.0 { 0.28 } else { 0.6 + 0.4 * point.z };
        page.disc(middle + Vec2::new(point.x, -point.y) * RADIUS, 1.5, SLATE.lerp(color, share));
    }
}

/// The density of cosθ in bars of equal width from −1 to 1.
fn bars(way: &Way, random: &mut Stream) -> [f32; BARS as usize] {
    let mut bars = [0.0; BARS as usize];
    for _ in 0..COUNTED {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 40")]
        let bar = (((way.draw)(random).z + 1.0) / 2.0 * f32::from(BARS)) as usize;
        bars[bar.min(BARS as usize - 1)] += 1.0;
    }
    #[expect(clippy::cast_precision_loss, reason = "a small number")]
    let scale = f32::from(BARS) / 2.0 / COUNTED as f32;
    bars.map(|count| count * scale)
}

/// Bars, and over them the line of the claimed density.
fn histogram(page: &mut Drawing, middle: f32, way: &Way, bars: &[f32]) {
    let [bottom, top] = EDGES;
    let at = |cosine: f32, density: f32| {
        Vec2::new(middle + cosine * HALF, bottom + (top - bottom) * (density / way.most).min(1.0))
    };
    let (tick, name) = way.tick;
    page.line(&[at(-1.0, tick), at(1.0, tick)], Pen::new(GRID, 1.2));
    let width = 2.0 / f32::from(BARS);
    for (i, &density) in (0_u8..).zip(bars) {
        let [left, right] = [0.1, 0.9].map(|part| (f32::from(i) + part) * width - 1.0);
        if density > 0.0 {
            let corners = [at(left, 0.0), at(right, 0.0), at(right, density), at(left, density)];
            page.polygon(&corners, way.color, 0.75);
        }
    }
    // The ring of all directions of one height has 2π times its height, whatever the height.
    let claimed = |cosine: f32| at(cosine, std::f32::consts::TAU * (way.pdf)(cosine));
    let start = if (way.pdf)(-0.5) > 0.0 { -1.0 } else { 1e-4 };
    page.line(&[claimed(start), claimed(1.0)], Pen::new(CHALK, 2.4));
    page.line(&[at(-1.0, 0.0), at(1.0, 0.0)], Pen::new(FAINT, 1.6));
    let letters = Lettering::new(17.0, FAINT);
    for (cosine, name) in [(-1.0, "−1"), (0.0, "0"), (1.0, "1")] {
        page.text(name, at(cosine, 0.0) + Vec2::Y * 22.0, letters.aligned(Align::Center));
    }
    page.text(name, at(-1.0, tick) + Vec2::new(-8.0, letters.drop()), letters.aligned(Align::Right));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All bars together are 1; those of the cube are off, those of the others right.
    #[test]
    fn only_the_cube_is_wrong() {
        for (i, way) in (0_u64..).zip(&WAYS) {
            let bars = bars(way, &mut Stream::new(0, i, 1));
            let width = 2.0 / f32::from(BARS);
            assert!((bars.iter().sum::<f32>() * width - 1.0).abs() < 1e-4, "{}", way.name);
            let claimed = |i: usize| std::f32::consts::TAU * (way.pdf)((i as f32 + 0.5) * width - 1.0);
            let off = (0..bars.len()).map(|i| (bars[i] - claimed(i)).abs()).fold(0.0, f32::max);
            assert_eq!(off > 0.08, i == 0, "{}: {off}", way.name);
        }
    }
}
