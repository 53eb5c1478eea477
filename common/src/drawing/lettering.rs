//! Lettering: text as lines.

use glam::Vec2;

use super::glyphs::{self, Glyph};
use crate::color::Rgb;

/// Height of a capital letter above the baseline, as a share of the lettering's size.
pub const CAPITAL: f32 = 0.7;

/// How a text is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lettering {
    /// Height of the line in units of the page: room for capitals and for what hangs below the baseline.
    pub size: f32,
    /// Linear RGB.
    pub color: Rgb,
    /// Which end of the text is given.
    pub align: Align,
}

/// Which end of a text is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// Where it starts.
    Left,
    /// Its middle.
    Center,
    /// Where it ends.
    Right,
}

impl Lettering {
    /// Width of the strokes as a share of the size.
    const STROKE: f32 = 0.078;

    /// Lettering that starts at the given place.
    #[must_use]
    pub fn new(size: f32, color: Rgb) -> Self {
        Self { size, color, align: Align::Left }
    }

    /// The same with another end given.
    #[must_use]
    pub fn aligned(self, align: Align) -> Self {
        Self { align, ..self }
    }

    /// Width of a text in units of the page.
    #[must_use]
    pub fn width(&self, text: &str) -> f32 {
        text.chars().map(|c| glyphs::glyph(c).advance).sum::<f32>() * self.size
    }

    /// How far below the middle of a capital letter the baseline is.
    #[must_use]
    pub fn drop(&self) -> f32 {
        self.size * CAPITAL / 2.0
    }

    pub(super) fn stroke(&self) -> f32 {
        self.size * Self::STROKE
    }
}

/// The lines of all letters of a text.
pub(super) fn outline(text: &str, at: Vec2, lettering: Lettering) -> Vec<Vec<Vec2>> {
    let before = match lettering.align {
        Align::Left => 0.0,
        Align::Center => 0.5,
        Align::Right => 1.0,
    };
    let mut start = at - Vec2::X * lettering.width(text) * before;
    let mut all = Vec::new();
    for c in text.chars() {
        let Glyph { advance, lines } = glyphs::glyph(c);
        // A glyph has y upward from the baseline, the page downward.
        let place = |p: &Vec2| start + Vec2::new(p.x, -p.y) * lettering.size;
        all.extend(lines.iter().map(|line| line.iter().map(place).collect::<Vec<_>>()));
        start.x += advance * lettering.size;
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Least and greatest x of all lines of a text.
    fn extent(text: &str, align: Align) -> (f32, f32) {
        let lettering = Lettering::new(20.0, Rgb::ONE).aligned(align);
        let points = outline(text, Vec2::new(100.0, 50.0), lettering).into_iter().flatten();
        points.fold((f32::INFINITY, f32::NEG_INFINITY), |(min, max), p| (min.min(p.x), max.max(p.x)))
    }

    #[test]
    fn text_is_as_wide_as_its_letters() {
        let lettering = Lettering::new(20.0, Rgb::ONE);
        let [n, nn] = ["n", "nn"].map(|text| lettering.width(text));
        assert!((nn - 2.0 * n).abs() < 1e-5 && n > 5.0 && n < 20.0, "{n}");
        assert_eq!(lettering.width(""), 0.0);
        assert!(lettering.width("gold") > lettering.width("il"));
    }

    #[test]
    fn text_lies_where_its_end_is_given() {
        let width = Lettering::new(20.0, Rgb::ONE).width("HoH");
        // Beside the letters there is a little room on both sides.
        for (align, start) in
            [(Align::Left, 100.0), (Align::Center, 100.0 - width / 2.0), (Align::Right, 100.0 - width)]
        {
            let (min, max) = extent("HoH", align);
            let (before, after) = (min - start, start + width - max);
            assert!(before > 0.0 && before < 3.0 && (before - after).abs() < 1e-3, "{before} {after}");
        }
    }

    #[test]
    fn capitals_stand_on_the_baseline() {
        let lines = outline("H", Vec2::new(0.0, 50.0), Lettering::new(10.0, Rgb::ONE));
        let ys: Vec<_> = lines.iter().flatten().map(|p| p.y).collect();
        assert_eq!(ys.iter().copied().fold(f32::NEG_INFINITY, f32::max), 50.0);
        assert!((ys.iter().copied().fold(f32::INFINITY, f32::min) - (50.0 - 10.0 * CAPITAL)).abs() < 1e-5);
    }
}
