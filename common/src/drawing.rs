//! Drawing: lines, dots and lettering on a page, for plots and diagrams that are pictures like all others.
//!
//! A drawing has no pixels of its own. It answers for any point of a film of any size how much of which paint covers
//! it, so it is crisp at every size. Its letters are strokes of ours: no font is needed.

mod alphabet;
mod axis;
mod glyphs;
pub mod lettering;
pub mod mark;
pub mod plot;
mod polyline;

use glam::Vec2;

use crate::{
    color::Rgb,
    drawing::{
        lettering::{Lettering, outline},
        mark::{Bounds, Form, Mark, Pen},
    },
    picture::{FilmPoint, Integrator},
    random::Stream,
    story::{Story, triple},
};

/// A dark slate to draw on, good on light and on dark pages: sRGB 29, 33, 41.
pub const SLATE: Rgb = Rgb::new(0.0123, 0.0152, 0.0222);
/// The light gray of letters and axes: sRGB 222, 226, 232.
pub const CHALK: Rgb = Rgb::new(0.730, 0.760, 0.807);
/// The gray of what may be overlooked: sRGB 148, 155, 166.
pub const FAINT: Rgb = Rgb::new(0.296, 0.328, 0.381);
/// The dark gray of thin helping lines: sRGB 62, 69, 82.
pub const GRID: Rgb = Rgb::new(0.0482, 0.0595, 0.0844);

/// Marks on a page, painted in their order.
///
/// Places are in units of the page: `x` to the right from its left edge, `y` down from its top edge, like on the film.
/// The whole page is fitted into the middle of the film. Marks may lie outside it.
#[derive(Clone, Debug)]
pub struct Drawing {
    page: Vec2,
    ground: Rgb,
    runs: Vec<Run>,
}

/// Marks that follow each other, and what bounds them all: most points of a page lie far from most marks.
#[derive(Clone, Debug)]
struct Run {
    bounds: Bounds,
    marks: Vec<Mark>,
}

impl Drawing {
    /// An empty page of the given width and height on a ground of one color.
    #[must_use]
    pub fn new(page: Vec2, ground: Rgb) -> Self {
        Self { page, ground, runs: Vec::new() }
    }

    /// A line through `points`, its ends and corners round.
    pub fn line(&mut self, points: &[Vec2], pen: Pen) -> &mut Self {
        let lines = match pen.dashes {
            Some(dashes) => polyline::dashed(points, dashes),
            None => vec![points.to_vec()],
        };
        let mut mark = Mark::new(Form::lines(&lines, pen.width), pen.color, pen.opacity);
        if let (true, Some(&first), Some(&last)) = (pen.fades, points.first(), points.last()) {
            mark.fades(first, last);
        }
        self.mark(mark)
    }

    /// A filled disc.
    pub fn disc(&mut self, center: Vec2, radius: f32, color: Rgb) -> &mut Self {
        self.mark(Mark::new(Form::Disc { center, radius }, color, 1.0))
    }

    /// A filled convex polygon, its corners in either turning direction.
    pub fn polygon(&mut self, corners: &[Vec2], color: Rgb, opacity: f32) -> &mut Self {
        self.mark(Mark::new(Form::polygon(corners), color, opacity))
    }

    /// A line of text; `at` is where its baseline starts, ends or has its middle.
    pub fn text(&mut self, text: &str, at: Vec2, lettering: Lettering) -> &mut Self {
        let form = Form::lines(&outline(text, at, lettering), lettering.stroke());
        self.mark(Mark::new(form, lettering.color, 1.0))
    }

    /// Another drawing without its ground, its page's upper left corner at a place of this one.
    pub fn paste(&mut self, other: Drawing, at: Vec2) -> &mut Self {
        for mut mark in other.runs.into_iter().flat_map(|run| run.marks) {
            mark.shift(at);
            self.mark(mark);
        }
        self
    }

    /// The next mark.
    fn mark(&mut self, mark: Mark) -> &mut Self {
        /// How many marks are looked at together.
        const RUN: usize = 16;
        match self.runs.last_mut().filter(|run| run.marks.len() < RUN) {
            Some(run) => {
                run.bounds = run.bounds.union(mark.bounds());
                run.marks.push(mark);
            }
            None => self.runs.push(Run { bounds: mark.bounds(), marks: vec![mark] }),
        }
        self
    }

    /// What is seen at a point of the film if the drawing lies over the color `below`.
    ///
    /// All points of a pixel see the same, the mean over the pixel: lines have no noise, however few the samples.
    #[must_use]
    pub fn over(&self, below: Rgb, point: FilmPoint) -> Rgb {
        let (place, pixel) = self.locate(point);
        let near = self.runs.iter().filter(|run| run.bounds.contains(place, pixel));
        near.flat_map(|run| &run.marks).fold(below, |below, mark| mark.over(below, place, pixel))
    }

    /// Where a film point lies on the page.
    #[must_use]
    pub fn place(&self, point: FilmPoint) -> Vec2 {
        self.page / 2.0 + (point.position - point.size / 2.0) * self.pixel(point)
    }

    /// Width of a pixel on the page.
    fn pixel(&self, point: FilmPoint) -> f32 {
        (self.page / point.size).max_element()
    }

    /// Where the center of a film point's pixel lies on the page, and the width of a pixel there.
    fn locate(&self, point: FilmPoint) -> (Vec2, f32) {
        let center = FilmPoint { position: point.position.floor() + 0.5, ..point };
        (self.place(center), self.pixel(point))
    }
}

impl Integrator for Drawing {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        let color = self.over(self.ground, point);
        story.tell(|| format!("a point of a drawing: {}", triple(color)));
        color
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Paint at the centers of a column of 100 pixels, added up.
    fn sum_of_column(drawing: &Drawing) -> f32 {
        let size = Vec2::splat(100.0);
        (0..100_u8)
            .map(|y| drawing.over(Rgb::ZERO, FilmPoint { position: Vec2::new(50.5, f32::from(y) + 0.5), size }).x)
            .sum()
    }

    #[test]
    fn a_line_covers_its_width() {
        for (width, y) in [(3.0, 50.0), (0.4, 50.0), (1.0, 33.3), (2.7, 20.71), (0.1, 70.49)] {
            let mut drawing = Drawing::new(Vec2::splat(100.0), Rgb::ZERO);
            drawing.line(&[Vec2::new(-5.0, y), Vec2::new(200.0, y)], Pen::new(Rgb::ONE, width));
            let sum = sum_of_column(&drawing);
            assert!((sum - width).abs() < 1e-3, "{sum} {width}");
        }
    }

    #[test]
    fn discs_and_polygons_cover_their_height() {
        let mut disc = Drawing::new(Vec2::splat(100.0), Rgb::ZERO);
        disc.disc(Vec2::new(50.5, 40.2), 7.3, Rgb::ONE);
        assert!((sum_of_column(&disc) - 14.6).abs() < 1e-3);
        // Both turning directions are the same polygon.
        let mut corners = [[40.0, 10.2], [60.0, 10.2], [60.0, 33.9], [40.0, 33.9]].map(Vec2::from_array);
        for _ in 0..2 {
            let mut square = Drawing::new(Vec2::splat(100.0), Rgb::ZERO);
            square.polygon(&corners, Rgb::ONE, 1.0);
            assert!((sum_of_column(&square) - 23.7).abs() < 1e-3);
            corners.reverse();
        }
    }

    #[test]
    fn the_page_lies_in_the_middle_of_any_film() {
        let drawing = Drawing::new(Vec2::new(200.0, 100.0), Rgb::ZERO);
        for size in [Vec2::new(201.0, 101.0), Vec2::new(31.0, 77.0), Vec2::new(5001.0, 1001.0)] {
            assert_eq!(drawing.locate(FilmPoint { position: size / 2.0, size }).0, Vec2::new(100.0, 50.0));
        }
        // A wide film is as high as the page, a high one as wide.
        let corner = |size| drawing.locate(FilmPoint { position: Vec2::splat(0.9), size });
        assert_eq!(corner(Vec2::new(800.0, 200.0)), (Vec2::new(-99.75, 0.25), 0.5));
        assert_eq!(corner(Vec2::new(400.0, 400.0)), (Vec2::new(0.25, -49.75), 0.5));
    }

    #[test]
    fn many_marks_are_all_there() {
        // More than are looked at together, and from one page pasted to another.
        let mut dots = Drawing::new(Vec2::splat(100.0), Rgb::ZERO);
        let place = |i: u8| Vec2::new(f32::from(i % 10), f32::from(i / 10)) * 7.0 + 2.5;
        (0..100).for_each(|i| {
            dots.disc(place(i), 1.5, Rgb::X);
        });
        let mut page = Drawing::new(Vec2::splat(100.0), Rgb::ZERO);
        page.paste(dots, Vec2::splat(20.0));
        let at = |position| page.over(Rgb::ZERO, FilmPoint { position, size: Vec2::splat(100.0) });
        for i in 0..100 {
            assert_eq!(at(place(i) + 20.0), Rgb::X);
            assert_eq!(at(place(i) + 23.0), Rgb::ZERO);
        }
    }

    #[test]
    fn paint_lies_in_order_and_fades() {
        let at = |drawing: &Drawing, x| {
            drawing.over(Rgb::ZERO, FilmPoint { position: Vec2::new(x, 50.0), size: Vec2::splat(100.0) })
        };
        let ends = [Vec2::new(10.5, 50.0), Vec2::new(90.5, 50.0)];
        let mut drawing = Drawing::new(Vec2::splat(100.0), Rgb::ZERO);
        drawing.line(&ends, Pen::new(Rgb::X, 4.0)).line(&ends, Pen { opacity: 0.5, ..Pen::new(Rgb::Y, 4.0) });
        assert_eq!(at(&drawing, 50.0), Rgb::new(0.5, 0.5, 0.0));
        let mut fading = Drawing::new(Vec2::splat(100.0), Rgb::ZERO);
        fading.line(&ends, Pen { fades: true, ..Pen::new(Rgb::ONE, 4.0) });
        assert_eq!([10.0, 30.0, 90.0].map(|x| at(&fading, x).x), [1.0, 0.75, 0.0]);
    }
}
