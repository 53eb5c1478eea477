//! Ways from the square to the disc: what becomes of the cells of a chessboard.

use common::{
    Error, Rgb, Stream, Vec2,
    color::{gradient, srgb},
    drawing::{
        CHALK, Drawing, FAINT, GRID, SLATE,
        lettering::{Align, Lettering},
        mark::Pen,
    },
    film::Size,
    float,
    knob::{Knob, Step},
    picture::{FilmPoint, Integrator, Picture, Render, Settings},
    story::{Story, triple},
};

use super::palette::{GREEN, RED};
use crate::disc::{
    invert_uniform_disc_concentric_sample, invert_uniform_disc_polar_sample, sample_uniform_disc_concentric,
    sample_uniform_disc_polar,
};

/// How many cells the board has.
const CELLS: Knob = Knob::number("cells", "cells along each side of the square", [2.0, 40.0], 16.0, "", Step::Whole);

pub(super) const PICTURE: Picture = Picture {
    name: "disc-samples",
    alt: "A square of 16 by 16 cells, colored from violet at the left to yellow at the right, with a dot in the \
          middle of each; and what four ways to the disc make of it. By rejection the square stays as it is, and \
          its corners outside the disc are thrown away. Polar without the root, marked as wrong: columns become \
          rings of equal width, and cells and dots crowd at the center. Polar: rings get thinner outward, and all \
          cells have equal area, but those at the rim are long and thin. Concentric: columns bend, neighbors stay \
          neighbors, and cells stay nearly square. A plot shows the share of the dots within each radius: without \
          the root it is a straight line, which lies above the share of the disc's area that all others follow.",
    knobs: &[CELLS],
    size: Size::of::<960, 690>(),
    samples: 4,
    takes_mesh: false,
    make,
};

/// The page; middles of the panels, and half the side of the square, which is the radius of the disc.
const PAGE: Vec2 = Vec2::new(960.0, 690.0);
const MIDDLES: [Vec2; 6] = [
    Vec2::new(170.0, 190.0),
    Vec2::new(480.0, 190.0),
    Vec2::new(790.0, 190.0),
    Vec2::new(170.0, 530.0),
    Vec2::new(480.0, 530.0),
    Vec2::new(800.0, 530.0),
];
const HALF: f32 = 128.0;

/// A way from the square to the disc.
struct Map {
    name: &'static str,
    /// Where a point of the square goes, in coordinates from −1 to 1.
    to: fn(Vec2) -> Vec2,
    /// The point of the square that comes to a place.
    from: fn(Vec2) -> Vec2,
    /// Whether a place has any.
    is_in: fn(Vec2) -> bool,
    color: Rgb,
}

const MAPS: [Map; 5] = [
    Map { name: "the unit square", to: spread, from: gathered, is_in: |_| true, color: CHALK },
    Map { name: "rejection", to: spread, from: gathered, is_in: is_in_disc, color: CHALK },
    Map { name: "polar without the root: wrong", to: rootless, from: from_rootless, is_in: is_in_disc, color: RED },
    Map {
        name: "polar",
        to: sample_uniform_disc_polar,
        from: invert_uniform_disc_polar_sample,
        is_in: is_in_disc,
        color: CHALK,
    },
    Map {
        name: "concentric",
        to: sample_uniform_disc_concentric,
        from: invert_uniform_disc_concentric_sample,
        is_in: is_in_disc,
        color: CHALK,
    },
];

fn is_in_disc(place: Vec2) -> bool {
    place.length_squared() < 1.0
}

fn spread(u: Vec2) -> Vec2 {
    u * 2.0 - 1.0
}

fn gathered(place: Vec2) -> Vec2 {
    (place + 1.0) / 2.0
}

// ANCHOR: rootless
/// The mistake: the radius is a uniform number itself, and not its root.
pub(crate) fn rootless(u: Vec2) -> Vec2 {
    let angle = std::f32::consts::TAU * u.y;
    Vec2::new(float::cos(angle), float::sin(angle)) * u.x
}
// ANCHOR_END: rootless

fn from_rootless(place: Vec2) -> Vec2 {
    invert_uniform_disc_polar_sample(place).with_x(place.length())
}

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let cells = settings.values.number(&CELLS);
    let mut drawing = Drawing::new(PAGE, SLATE);
    for (map, middle) in MAPS.iter().zip(MIDDLES) {
        let name = Lettering::new(20.0, map.color.lerp(CHALK, 0.25)).aligned(Align::Center);
        drawing.text(map.name, middle - Vec2::Y * (HALF + 18.0), name);
        dots(&mut drawing, map, middle, settings.values.index(&CELLS));
    }
    plot(&mut drawing, MIDDLES[MAPS.len()]);
    Ok(Box::new(Discs { cells, drawing }))
}

/// Points in the middles of all cells.
fn regular(cells: usize) -> impl Iterator<Item = Vec2> {
    #[expect(clippy::cast_precision_loss, reason = "few cells")]
    let at = move |i: usize| (i as f32 + 0.5) / cells as f32;
    (0..cells).flat_map(move |x| (0..cells).map(move |y| Vec2::new(at(x), at(y))))
}

/// The middle of each cell.
fn dots(drawing: &mut Drawing, map: &Map, middle: Vec2, cells: usize) {
    for u in regular(cells) {
        let place = (map.to)(u);
        let color = if (map.is_in)(place) { SLATE } else { GRID };
        drawing.disc(middle + place * Vec2::new(1.0, -1.0) * HALF, 1.7, color);
    }
}

/// How many points lie within each radius, without the root and with it.
fn plot(drawing: &mut Drawing, middle: Vec2) {
    let corner = middle + Vec2::new(-HALF, HALF);
    let at = |x: f32, y: f32| corner + Vec2::new(x, -y) * 2.0 * HALF;
    let letters = Lettering::new(17.0, FAINT);
    for i in 1..=4_u8 {
        let share = f32::from(i) / 4.0;
        drawing.line(&[at(0.0, share), at(1.0, share)], Pen::new(GRID, 1.2));
        drawing.line(&[at(share, 0.0), at(share, 1.0)], Pen::new(GRID, 1.2));
    }
    drawing.line(&[at(0.0, 1.0), at(0.0, 0.0), at(1.0, 0.0)], Pen::new(FAINT, 1.6));
    // Dense near 0, where the root is steep.
    let share = |i: u8| (f32::from(i) / 64.0) * (f32::from(i) / 64.0);
    for (map, color) in [(&MAPS[2], RED), (&MAPS[3], GREEN)] {
        // The radius of the share u of all points is that of the map: both are measured along the square's axis.
        let points: Vec<Vec2> = (0..=64_u8).map(share).map(|u| at((map.to)(Vec2::new(u, 0.0)).x, u)).collect();
        drawing.line(&points, Pen::new(color, 2.8));
    }
    drawing.text("share of points", at(0.0, 1.0) - Vec2::Y * 18.0, letters);
    for (share, name) in [(0.0, "0"), (0.5, "½"), (1.0, "1")] {
        let [below, beside] = [at(share, 0.0) + Vec2::Y * 21.0, at(0.0, share) + Vec2::new(-8.0, letters.drop())];
        drawing.text(name, below, letters.aligned(Align::Center));
        if share > 0.0 {
            drawing.text(name, beside, letters.aligned(Align::Right));
        }
    }
    drawing.text("radius", at(0.76, 0.0) + Vec2::Y * 21.0, letters.aligned(Align::Center));
    drawing.text("without the root", at(0.06, 0.68), Lettering::new(17.0, RED.lerp(Rgb::ONE, 0.25)));
    drawing.text("area r²", at(0.62, 0.22), Lettering::new(17.0, GREEN.lerp(Rgb::ONE, 0.25)));
}

/// The color of a point of the square: by its column, and of every other cell a little darker.
fn color(u: Vec2, cells: f32) -> Rgb {
    let colors = [srgb(112, 76, 196), srgb(66, 132, 226), srgb(46, 184, 172), srgb(150, 206, 92), srgb(250, 206, 78)];
    let [column, row] = [u.x, u.y].map(|u| (u * cells).floor());
    let hue = gradient(&colors, column / (cells - 1.0).max(1.0));
    let is_dark = (column + row) % 2.0 == 0.0;
    if is_dark { hue * 0.66 } else { hue }
}

/// The boards, and what is drawn around them.
struct Discs {
    cells: f32,
    drawing: Drawing,
}

impl Integrator for Discs {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        let place = self.drawing.place(point);
        let mut below = SLATE;
        for (map, middle) in MAPS.iter().zip(MIDDLES) {
            let local = (place - middle) / HALF * Vec2::new(1.0, -1.0);
            if local.abs().max_element() < 1.0 {
                let color = color((map.from)(local), self.cells);
                // What is rejected shimmers through.
                let is_rejected = !(map.is_in)(local);
                let kept = if map.name == "rejection" { SLATE.lerp(color, 0.1) } else { SLATE };
                below = if is_rejected { kept } else { color };
            }
        }
        let color = self.drawing.over(below, point);
        story.tell(|| format!("a point of a drawing: {}", triple(color)));
        color
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_map_is_undone() {
        for map in &MAPS {
            for u in regular(16).filter(|u| (map.is_in)((map.to)(*u))) {
                assert!(((map.from)((map.to)(u)) - u).length() < 1e-5, "{} {u}", map.name);
            }
        }
    }
}
