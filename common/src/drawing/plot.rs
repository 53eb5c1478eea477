//! A plot: curves over axes, as a drawing.

use glam::Vec2;

use super::{
    CHALK, Drawing, FAINT, GRID, SLATE,
    lettering::{Align, Lettering},
    mark::Pen,
};

pub use super::axis::{Axis, Scale};

/// Curves over two axes.
#[derive(Clone, Debug)]
pub struct Plot {
    /// Width and height in units of the page; for the margins around the axes, a letter is 18 high.
    pub page: Vec2,
    /// The axis to the right.
    pub x: Axis,
    /// The axis upward.
    pub y: Axis,
    /// What is drawn, one over the other.
    pub curves: Vec<Curve>,
    /// What the pens mean.
    pub legends: Vec<Legend>,
}

/// A line through values of the axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// The values.
    pub points: Vec<Vec2>,
    /// What it is drawn with.
    pub pen: Pen,
}

/// Keys one below the other.
#[derive(Clone, Debug)]
pub struct Legend {
    /// Values of the axes where the first key starts.
    pub at: Vec2,
    /// Pens and what they mean.
    pub keys: Vec<(Pen, &'static str)>,
}

impl Curve {
    /// A function, sampled at both ends of an interval and at equal distances between.
    #[must_use]
    pub fn of([from, to]: [f32; 2], pieces: u16, pen: Pen, function: impl Fn(f32) -> f32) -> Self {
        let at = |i: u16| from + (to - from) * f32::from(i) / f32::from(pieces.max(1));
        Self { points: (0..=pieces).map(|i| Vec2::new(at(i), function(at(i)))).collect(), pen }
    }
}

impl Plot {
    /// Size of the lettering.
    pub const LETTER: f32 = 18.0;
    /// Room at the left, above, at the right and below.
    const MARGIN: [f32; 4] = [70.0, 46.0, 22.0, 54.0];
    /// Between an axis and its figures.
    const GAP: f32 = 9.0;
    /// Length of a key's line, and from one key to the next.
    const KEY: [f32; 2] = [34.0, 23.0];

    /// Where a pair of values lies on the page.
    #[must_use]
    pub fn place(&self, value: Vec2) -> Vec2 {
        let [left, above, right, below] = Self::MARGIN;
        let size = self.page - Vec2::new(left + right, above + below);
        Vec2::new(left + self.x.share(value.x) * size.x, above + (1.0 - self.y.share(value.y)) * size.y)
    }

    /// The plot as a drawing on slate.
    #[must_use]
    pub fn drawing(&self) -> Drawing {
        let mut drawing = Drawing::new(self.page, SLATE);
        self.draw_axes(&mut drawing);
        for curve in &self.curves {
            let points: Vec<Vec2> = curve.points.iter().map(|p| self.place(*p)).collect();
            drawing.line(&points, curve.pen);
        }
        for legend in &self.legends {
            self.draw_legend(&mut drawing, legend);
        }
        drawing
    }

    /// Thin lines, then the two axes with figures and names.
    fn draw_axes(&self, drawing: &mut Drawing) {
        let (thin, axis) = (Pen::new(GRID, 1.2), Pen::new(FAINT, 1.6));
        let letters = Lettering::new(Self::LETTER, CHALK);
        let ([left, right], [bottom, top]) = (self.x.range, self.y.range);
        let at = |x, y| self.place(Vec2::new(x, y));
        for x in self.x.ticks() {
            let foot = at(x, bottom);
            drawing.line(&[foot, at(x, top)], thin);
            let below = Vec2::Y * (Self::GAP + 2.0 * letters.drop());
            drawing.text(&self.x.label(x), foot + below, letters.aligned(Align::Center));
        }
        for y in self.y.ticks() {
            let foot = at(left, y);
            drawing.line(&[foot, at(right, y)], thin);
            let beside = Vec2::new(-Self::GAP, letters.drop());
            drawing.text(&self.y.label(y), foot + beside, letters.aligned(Align::Right));
        }
        drawing.line(&[at(left, top), at(left, bottom), at(right, bottom)], axis);
        // The names stand where the axes end: one below the figures, one above them.
        let names = Lettering::new(Self::LETTER, FAINT);
        let below = Vec2::Y * (2.0 * Self::GAP + 4.0 * letters.drop());
        drawing.text(self.x.name, at(self.x.middle(), bottom) + below, names.aligned(Align::Center));
        let above = Vec2::new(0.0, -1.6 * Self::GAP);
        drawing.text(self.y.name, at(left, top) + above, names);
    }

    /// The keys, one below the other.
    fn draw_legend(&self, drawing: &mut Drawing, legend: &Legend) {
        let [length, height] = Self::KEY;
        let letters = Lettering::new(Self::LETTER, CHALK);
        let mut at = self.place(legend.at);
        for (pen, meaning) in &legend.keys {
            let end = at + Vec2::X * length;
            drawing.line(&[at, end], *pen);
            drawing.text(meaning, end + Vec2::new(Self::GAP, letters.drop()), letters);
            at.y += height;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Rgb, picture::FilmPoint};

    fn plot(curves: Vec<Curve>) -> Plot {
        let axis = |name, range, step| Axis { name, unit: "", range, scale: Scale::Linear { step } };
        let (x, y) = (axis("x", [-1.0, 1.0], 0.5), axis("y", [0.0, 4.0], 2.0));
        Plot { page: Vec2::new(480.0, 360.0), x, y, curves, legends: Vec::new() }
    }

    #[test]
    fn values_have_their_places() {
        let plot = plot(Vec::new());
        assert_eq!(plot.place(Vec2::new(-1.0, 4.0)), Vec2::new(70.0, 46.0));
        assert_eq!(plot.place(Vec2::new(1.0, 0.0)), Vec2::new(458.0, 306.0));
        assert_eq!(plot.place(Vec2::new(0.0, 2.0)), Vec2::new(264.0, 176.0));
    }

    #[test]
    fn the_curve_goes_through_its_values() {
        let plot = plot(vec![Curve::of([-1.0, 1.0], 100, Pen::new(Rgb::X, 6.0), |x| 4.0 * x * x)]);
        let drawing = plot.drawing();
        let at = |x: f32, y| drawing.over(SLATE, FilmPoint { position: plot.place(Vec2::new(x, y)), size: plot.page });
        for x in [-0.9, -0.3, 0.2, 0.71] {
            assert_eq!(at(x, 4.0 * x * x), Rgb::X);
        }
        assert_eq!(at(0.25, 1.0), SLATE);
    }
}
