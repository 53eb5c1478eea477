//! Regular and random points of a square, and the shadows that they throw on one axis.

use std::collections::BTreeSet;

use common::{
    Error, Rgb, Stream, Vec2,
    drawing::{
        CHALK, Drawing, FAINT, GRID, SLATE,
        lettering::{Align, Lettering},
        mark::Pen,
    },
    film::Size,
    knob::{Knob, Step},
    picture::{Picture, Render, Settings},
};

use super::palette::{BLUE, GOLD};
use crate::unit_square::sample_unit_square;

/// Which random points.
const POINTS: Knob = Knob::number("points", "which random points are drawn", [0.0, 1000.0], 0.0, "", Step::Whole);

pub(super) const PICTURE: Picture = Picture {
    name: "regular-and-random",
    alt: "Six squares with 16, 64 and 256 points: in the upper row in regular rows and columns, blue, in the lower \
          row random, gold. Below each square is the shadow of its points on the lower edge. Sixteen regular points \
          fall together in four places, 64 in eight and 256 in sixteen. The shadows of random points all lie apart: \
          there are as many places as points.",
    knobs: &[POINTS],
    size: Size::of::<960, 690>(),
    samples: 1,
    takes_mesh: false,
    make,
};

/// The page, and on it a square: its side, where the first stands, and how far the next is from it.
const PAGE: Vec2 = Vec2::new(960.0, 690.0);
const SIDE: f32 = 226.0;
const FIRST: Vec2 = Vec2::new(126.0, 62.0);
const NEXT: Vec2 = Vec2::new(274.0, 322.0);
/// Points along each axis, and the radius of a dot.
const COLUMNS: [(u8, f32); 3] = [(4, 5.2), (8, 3.9), (16, 2.8)];

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let seed = settings.values.index(&POINTS) as u64;
    let mut page = Drawing::new(PAGE, SLATE);
    let heading = Lettering::new(21.0, CHALK);
    for (row, (name, color)) in (0_u8..).zip([("regular", BLUE), ("random", GOLD)]) {
        let corner = FIRST + NEXT * Vec2::new(0.0, row.into());
        let beside = corner + Vec2::new(-22.0, SIDE / 2.0 + heading.drop());
        page.text(name, beside, Lettering { color, ..heading }.aligned(Align::Right));
        for (column, (per_axis, radius)) in (0_u8..).zip(COLUMNS) {
            let points = if row == 0 { regular(per_axis) } else { random(per_axis, seed) };
            let corner = corner + NEXT * Vec2::new(column.into(), 0.0);
            if row == 0 {
                let title = format!("{} points", points.len());
                page.text(&title, corner + Vec2::new(SIDE / 2.0, -18.0), heading.aligned(Align::Center));
            }
            square(&mut page, corner, &points, radius, color);
        }
    }
    Ok(Box::new(page))
}

/// A point in the middle of each cell.
fn regular(per_axis: u8) -> Vec<Vec2> {
    let at = |cell: u8| (f32::from(cell) + 0.5) / f32::from(per_axis);
    (0..per_axis).flat_map(|y| (0..per_axis).map(move |x| Vec2::new(at(x), at(y)))).collect()
}

/// As many points anywhere.
fn random(per_axis: u8, seed: u64) -> Vec<Vec2> {
    let mut random = Stream::new(seed, per_axis.into(), 0);
    let count = u16::from(per_axis) * u16::from(per_axis);
    (0..count).map(|_| sample_unit_square(&mut random)).collect()
}

/// Points in a square, and below it their shadow.
fn square(page: &mut Drawing, corner: Vec2, points: &[Vec2], radius: f32, color: Rgb) {
    /// The strip of the shadow: where it begins below the square, and its height.
    const STRIP: [f32; 2] = [11.0, 20.0];
    let at = |x: f32, y: f32| corner + Vec2::new(x, y);
    page.line(&[at(0.0, 0.0), at(SIDE, 0.0), at(SIDE, SIDE), at(0.0, SIDE), at(0.0, 0.0)], Pen::new(GRID, 1.4));
    // Light falls from above along thin lines.
    let places = places(points);
    let opacity = if places.len() > 100 { 0.2 } else { 0.55 };
    let rays = Pen { opacity, ..Pen::new(GRID, 1.0) };
    let [top, height] = STRIP;
    for place in &places {
        page.line(&[at(place * SIDE, 0.0), at(place * SIDE, SIDE + top)], rays);
        let mark = [at(place * SIDE, SIDE + top), at(place * SIDE, SIDE + top + height)];
        page.line(&mark, Pen::new(color, 1.5));
    }
    for point in points {
        page.disc(corner + *point * SIDE, radius, color);
    }
    let count = format!("{} values of x", places.len());
    let below = at(SIDE / 2.0, SIDE + top + height + 20.0);
    page.text(&count, below, Lettering::new(17.0, FAINT).aligned(Align::Center));
}

/// The places where the points' shadows fall, each once and in their order.
fn places(points: &[Vec2]) -> Vec<f32> {
    // Numbers that are not negative are in the order of their bits.
    let bits: BTreeSet<u32> = points.iter().map(|point| point.x.to_bits()).collect();
    bits.into_iter().map(f32::from_bits).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regular_points_hide_behind_each_other_and_random_ones_do_not() {
        for (per_axis, _) in COLUMNS {
            let count = usize::from(per_axis) * usize::from(per_axis);
            assert_eq!((regular(per_axis).len(), places(&regular(per_axis)).len()), (count, per_axis.into()));
            assert_eq!(places(&random(per_axis, 0)).len(), count);
        }
    }
}
