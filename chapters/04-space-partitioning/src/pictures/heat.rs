//! Heat maps: each point in a color that says how many steps its ray took.

use std::sync::{Arc, LazyLock};

use common::{
    Error, Interval, Rgb, Stream, Vec2,
    color::{gradient, srgb},
    drawing::{
        CHALK, Drawing, FAINT, SLATE,
        lettering::{Align, Lettering},
    },
    float,
    picture::{FilmPoint, Integrator},
    story::Story,
};
use ray_casting::{camera::Camera, mesh::Mesh};

use crate::{
    choice::{Choice, Countable},
    probe::Counts,
};

/// Width and height of the page that the maps are laid out on.
const PAGE: Vec2 = Vec2::new(1280.0, 440.0);
/// Where the first map stands, how large it is, and how far the next one is from it.
const FIRST: Vec2 = Vec2::new(20.0, 56.0);
const MAP: Vec2 = Vec2::new(400.0, 300.0);
const NEXT: f32 = 420.0;
/// The scale below the maps.
const SCALE: [Vec2; 2] = [Vec2::new(280.0, 386.0), Vec2::new(720.0, 16.0)];

/// The colors from no step at all to the hottest.
static COLORS: LazyLock<[Rgb; 6]> = LazyLock::new(|| {
    [[8, 10, 32], [32, 44, 130], [24, 128, 150], [96, 190, 90], [250, 200, 60], [250, 250, 220]]
        .map(|[r, g, b]| srgb(r, g, b))
});

/// From the coldest color to the hottest, steps grow by this factor, and between the figures under the scale by four.
const RANGE: f32 = 1024.0;
const FIGURES: u8 = 5;

// ANCHOR: color
/// How hot a number of steps is, from 0 to 1. Each further factor of four is hotter by a fifth: some rays take a
/// thousand times as many steps as others, and all should be told apart.
#[must_use]
fn heat(steps: f32, hottest: f32) -> f32 {
    1.0 - float::ln(hottest / steps.max(1.0)) / float::ln(RANGE)
}

/// The color of a heat.
#[must_use]
fn color(heat: f32) -> Rgb {
    gradient(&*COLORS, heat)
}
// ANCHOR_END: color

/// The maps of all three structures side by side, with their common scale.
pub(super) struct HeatMaps {
    structures: Vec<Arc<dyn Countable>>,
    camera: Camera,
    counted: Counted,
    /// Steps of the hottest color.
    hottest: f32,
    /// Names, and the scale's figures.
    drawing: Drawing,
}

/// Which steps are shown.
type Counted = fn(&Counts) -> u64;
const COUNTED: [Counted; 3] = [Counts::steps, |counts| counts.cells, |counts| counts.tests];
const WORDS: [&str; 3] = [
    "cells visited and triangles tested by a camera ray",
    "cells visited by a camera ray",
    "triangles tested by a camera ray",
];

impl HeatMaps {
    /// The maps of a mesh, as a camera sees it.
    pub(super) fn new(mesh: Mesh, camera: Camera, counted: usize, hottest: f32) -> Result<Self, Error> {
        let mesh = Arc::new(mesh);
        let structures: Result<Vec<_>, _> =
            Choice::STRUCTURES.iter().map(|choice| choice.over(Arc::clone(&mesh))).collect();
        let counted = counted.min(COUNTED.len() - 1);
        let mut maps = Self {
            structures: structures?,
            camera,
            counted: COUNTED[counted],
            hottest,
            drawing: Drawing::new(PAGE, SLATE),
        };
        maps.letter(WORDS[counted]);
        Ok(maps)
    }

    /// Write the names over the maps, each with the mean over its rays, and the figures under the scale.
    fn letter(&mut self, what: &str) {
        for (i, choice) in Choice::STRUCTURES.into_iter().enumerate() {
            let middle = FIRST + Vec2::new(i as f32 * NEXT + MAP.x / 2.0, -18.0);
            let text = format!("{}: {:.1} on average", choice.name(), self.mean(i));
            self.drawing.text(&text, middle, Lettering::new(22.0, CHALK).aligned(Align::Center));
        }
        let [corner, size] = SCALE;
        for i in 0..=FIGURES {
            let share = f32::from(i) / f32::from(FIGURES);
            let foot = corner + Vec2::new(share * size.x, size.y + 20.0);
            let beyond = [" or less", "", " or more"][usize::from(i > 0) + usize::from(i == FIGURES)];
            let steps = self.hottest * float::pow(RANGE, share - 1.0);
            let text = if steps < 0.5 { format!("{steps:.2}{beyond}") } else { format!("{steps:.0}{beyond}") };
            self.drawing.text(&text, foot, Lettering::new(16.0, CHALK).aligned(Align::Center));
        }
        let beside = corner + Vec2::new(size.x / 2.0, -8.0);
        self.drawing.text(what, beside, Lettering::new(16.0, FAINT).aligned(Align::Center));
    }

    /// The mean number of steps over a raster of rays through a map.
    fn mean(&self, structure: usize) -> f32 {
        /// Points of the raster along each side.
        const SIDE: u8 = 48;
        let at = |x: u8, y: u8| (Vec2::new(x.into(), y.into()) + 0.5) / f32::from(SIDE) * MAP;
        let points = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y)));
        let sum: u64 = points.map(|(x, y)| self.steps(structure, at(x, y))).sum();
        sum as f32 / (f32::from(SIDE) * f32::from(SIDE))
    }

    // ANCHOR: steps
    /// How many steps the ray through a point of a map takes.
    fn steps(&self, structure: usize, position: Vec2) -> u64 {
        let ray = self.camera.ray(FilmPoint { position, size: MAP });
        let (_, counts) = self.structures[structure].count_nearest(&ray, Interval::POSITIVE);
        (self.counted)(&counts)
    }
    // ANCHOR_END: steps
}

impl Integrator for HeatMaps {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        let place = self.drawing.place(point);
        let is_in =
            |corner: Vec2, size: Vec2| (place - corner).cmpge(Vec2::ZERO).all() && (place - corner).cmplt(size).all();
        // A map?
        for (i, choice) in Choice::STRUCTURES.into_iter().enumerate() {
            let corner = FIRST + Vec2::X * (i as f32 * NEXT);
            if is_in(corner, MAP) {
                let steps = self.steps(i, place - corner);
                story.tell(|| format!("the {}: {steps} steps", choice.name()));
                return color(heat(steps as f32, self.hottest));
            }
        }
        // The scale?
        let [corner, size] = SCALE;
        if is_in(corner, size) {
            return color((place - corner).x / size.x);
        }
        self.drawing.radiance(point, _random, story)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_times_as_many_steps_are_a_fifth_hotter() {
        let heats = [4.0, 16.0, 64.0, 256.0, 1024.0, 4096.0].map(|steps| heat(steps, 4096.0));
        for (heat, share) in heats.into_iter().zip([0.0, 0.2, 0.4, 0.6, 0.8, 1.0]) {
            assert!((heat - share).abs() < 1e-6, "{heats:?}");
        }
        // Nothing is colder than the coldest color, and nothing hotter than the hottest.
        assert_eq!([heat(0.0, 4096.0), heat(1e9, 4096.0)].map(color), [0.0, 1.0].map(color));
    }
}
