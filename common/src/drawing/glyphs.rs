//! The forms of letters: strokes after the manner of technical lettering.

use glam::Vec2;

use super::{
    alphabet::{GLYPHS, MISSING},
    polyline::{Corner, rounded},
};

/// The form of a letter, in shares of the lettering's size: `x` to the right from where it starts, `y` up from the
/// baseline.
pub(super) struct Glyph {
    /// How far behind the start of this letter the next one starts.
    pub(super) advance: f32,
    /// Its strokes.
    pub(super) lines: Vec<Vec<Vec2>>,
}

/// Units of the alphabet to the size of lettering: a capital is 14 of these 20 high, a small letter 10.
const UNITS: f32 = 20.0;
/// Longest rounding of a corner.
const ROUND: f32 = 6.0;
/// How far from its center the line of a dot goes round.
const DOT: f32 = 0.45;
/// Size of a small raised letter, and how far it is raised.
const RAISED: (f32, f32) = (0.62, 6.6);

/// The form of a letter; for one that we do not have, an empty frame.
pub(super) fn glyph(letter: char) -> Glyph {
    if let Some((raised, base)) = raised(letter) {
        let Glyph { advance, lines } = glyph(base);
        let (size, up) = raised;
        let place = |p: Vec2| p * size + Vec2::Y * up / UNITS;
        return Glyph {
            advance: advance * size,
            lines: lines.into_iter().map(|l| l.into_iter().map(place).collect()).collect(),
        };
    }
    let (_, left, right, path) = GLYPHS.iter().find(|g| g.0 == letter).unwrap_or(&MISSING);
    let lines: Vec<Vec<Vec2>> = path.split(';').filter_map(stroke).collect();
    let width = lines.iter().flatten().map(|p| p.x).fold(0.0, f32::max);
    let place = |p: Vec2| (p + Vec2::X * *left) / UNITS;
    Glyph {
        advance: (left + width + right) / UNITS,
        lines: lines.into_iter().map(|l| l.into_iter().map(place).collect()).collect(),
    }
}

/// A raised letter as its size, how far it is raised, and the letter that it is.
fn raised(letter: char) -> Option<((f32, f32), char)> {
    let index = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻".chars().position(|c| c == letter)?;
    Some((RAISED, "0123456789−".chars().nth(index)?))
}

/// A stroke of a path: places `x,y`, with a `~` before those where the corner is round. `*x,y` is a dot.
fn stroke(path: &str) -> Option<Vec<Vec2>> {
    let place = |text: &str| {
        let (x, y) = text.split_once(',')?;
        Some(Vec2::new(x.parse().ok()?, y.parse().ok()?))
    };
    if let Some(dot) = path.trim().strip_prefix('*') {
        let center = place(dot)?;
        let corners = [Vec2::X, Vec2::Y, Vec2::NEG_X, Vec2::NEG_Y, Vec2::X];
        return Some(corners.map(|c| center + c * DOT).to_vec());
    }
    let corner = |text: &str| {
        let is_round = text.starts_with('~');
        place(text.trim_start_matches('~')).map(|place| Corner { place, is_round })
    };
    let corners: Option<Vec<Corner>> = path.split_whitespace().map(corner).collect();
    corners.filter(|c| !c.is_empty()).map(|corners| rounded(&corners, ROUND))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_stroke_of_the_table_can_be_read() {
        for (letter, _, _, path) in GLYPHS.iter().chain([&MISSING]).filter(|g| g.0 != ' ') {
            assert!(path.split(';').all(|s| stroke(s).is_some()), "{letter}");
            let glyph = glyph(*letter);
            let inside = |p: &Vec2| (-0.25..=0.85).contains(&p.y) && p.x >= 0.0 && p.x <= glyph.advance;
            assert!(glyph.lines.iter().flatten().all(inside), "{letter}");
        }
    }

    #[test]
    fn each_letter_has_one_form() {
        for (i, (letter, ..)) in GLYPHS.iter().enumerate() {
            assert!(GLYPHS[..i].iter().all(|g| g.0 != *letter), "{letter}");
        }
        for letter in ('a'..='z').chain('A'..='Z').chain('0'..='9').chain("°%.,−+×=()/κλθ≤".chars()) {
            assert!(GLYPHS.iter().any(|g| g.0 == letter), "{letter}");
        }
    }

    #[test]
    fn raised_digits_are_small_and_missing_letters_framed() {
        assert!(glyph('³').advance < glyph('3').advance && glyph('⁻').advance < glyph('−').advance);
        assert_eq!(glyph('語').lines[0].len(), 5);
        assert!(glyph(' ').lines.is_empty() && glyph(' ').advance > 0.0);
    }
}
