//! Text over the picture, on dark translucent boxes.

use font8x8::legacy::{BASIC_LEGACY, GREEK_LEGACY, LATIN_LEGACY};

use super::raster::Raster;

/// One line of text.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Line {
    /// What it says.
    pub(crate) text: String,
    /// Color as a screen pixel.
    pub(crate) color: u32,
}

/// Ordinary text.
pub(crate) const WHITE: u32 = 0xFF_FF_FF;
/// Text that is less important.
pub(crate) const GREY: u32 = 0xB8_B8_B8;
/// What is chosen.
pub(crate) const YELLOW: u32 = 0xFF_DD_55;
/// Something went well.
pub(crate) const GREEN: u32 = 0x88_EE_88;
/// Something went wrong.
pub(crate) const RED: u32 = 0xFF_99_88;

/// Side of a letter in dots.
const LETTER: usize = 8;
/// From one line of text to the next, in dots.
const PITCH: usize = 10;
/// Between text and the edge of its box, and between box and edge of the window, in dots.
const MARGIN: usize = 4;

impl Line {
    /// A line in some color.
    pub(crate) fn new(text: impl Into<String>, color: u32) -> Self {
        Self { text: text.into(), color }
    }
}

/// Draw one box in the upper left corner and one in the lower left, with letters as large as both fit and leave half
/// of the picture free if only the lower one is there. If there is no room for both, the lower one is left out.
pub(crate) fn draw(raster: &mut Raster, upper: &[Line], lower: &[Line]) {
    let (width, height) = raster.size();
    let wrap = |lines: &[Line], scale: usize| wrapped(lines, (width / scale / LETTER).saturating_sub(2));
    let largest = if width >= 2000 { 3 } else { 2 };
    let fits = |scale: &usize| {
        let words_fit = width / scale / LETTER >= 34;
        let rows: usize = [upper, lower].map(|lines| box_height(wrap(lines, *scale).len())).iter().sum();
        let free = if upper.is_empty() { height / scale / 2 } else { MARGIN };
        words_fit && rows + free <= height / scale
    };
    let scale = (1..=largest).rev().find(fits);
    let lower = if scale.is_none() && !upper.is_empty() { &[] } else { lower };
    let scale = scale.unwrap_or(1);
    boxed(raster, MARGIN, scale, &wrap(upper, scale));
    let lower = wrap(lower, scale);
    boxed(raster, (height / scale).saturating_sub(box_height(lower.len())), scale, &lower);
}

/// Height of a box with its distance to the window's edge, in dots.
fn box_height(lines: usize) -> usize {
    if lines == 0 { 0 } else { lines * PITCH + 3 * MARGIN - (PITCH - LETTER) }
}

/// One box at the left edge; `top` in dots.
fn boxed(raster: &mut Raster, top: usize, scale: usize, lines: &[Line]) {
    let Some(longest) = lines.iter().map(|line| line.text.chars().count()).max() else { return };
    let (width, height) = (longest * LETTER + 2 * MARGIN, box_height(lines.len()) - MARGIN);
    for y in 0..height * scale {
        for pixel in raster.row_mut(MARGIN * scale, top * scale + y, width * scale) {
            *pixel = darkened(*pixel);
        }
    }
    for (i, line) in lines.iter().enumerate() {
        text(raster, (2 * MARGIN, top + MARGIN + i * PITCH), scale, line);
    }
}

/// A fifth of the brightness, so that white text stands out of any picture.
fn darkened(pixel: u32) -> u32 {
    u32::from_be_bytes(pixel.to_be_bytes().map(|byte| byte / 5))
}

/// Letters from the place `(x, y)`, in dots, to the right.
fn text(raster: &mut Raster, (x, y): (usize, usize), scale: usize, line: &Line) {
    for (i, letter) in line.text.chars().enumerate() {
        for (row, bits) in glyph(letter).into_iter().enumerate() {
            for dot in (0..LETTER).filter(|dot| bits >> dot & 1 == 1) {
                for sub_row in 0..scale {
                    let (x, y) = ((x + i * LETTER + dot) * scale, (y + row) * scale + sub_row);
                    raster.row_mut(x, y, scale).fill(line.color);
                }
            }
        }
    }
}

/// The rows of a letter from the top; in each, the lowest bit is the leftmost dot.
fn glyph(letter: char) -> [u8; LETTER] {
    // The font has no dashes, arrows and curly quotes.
    let letter = match letter {
        '−' | '–' | '—' => '-',
        '’' | '‘' => '\'',
        '“' | '”' => '"',
        '→' => '>',
        '←' => '<',
        '…' => ':',
        other => other,
    };
    let find = |table: &[[u8; LETTER]], first: char| {
        (letter as usize).checked_sub(first as usize).and_then(|i| table.get(i).copied())
    };
    find(&BASIC_LEGACY, '\0')
        .or_else(|| find(&LATIN_LEGACY, '\u{A0}'))
        .or_else(|| find(&GREEK_LEGACY, '\u{390}'))
        .unwrap_or_else(|| BASIC_LEGACY['?' as usize])
}

/// The same words with no line longer than `columns` letters; what goes on is indented.
fn wrapped(lines: &[Line], columns: usize) -> Vec<Line> {
    const INDENT: usize = 2;
    let columns = columns.max(2 * INDENT);
    let mut result = Vec::new();
    for line in lines {
        let mut rest: Vec<char> = line.text.chars().collect();
        while rest.len() > columns {
            let at_space = rest[..=columns].iter().rposition(|c| *c == ' ').filter(|i| *i > INDENT);
            let mut next: Vec<char> = rest.split_off(at_space.unwrap_or(columns));
            result.push(Line::new(rest.iter().collect::<String>(), line.color));
            if at_space.is_some() {
                next.remove(0);
            }
            rest = std::iter::repeat_n(' ', INDENT).chain(next).collect();
        }
        result.push(Line::new(rest.iter().collect::<String>(), line.color));
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(lines: &[Line]) -> Vec<&str> {
        lines.iter().map(|line| line.text.as_str()).collect()
    }

    #[test]
    fn long_lines_are_wrapped_at_words() {
        let lines = [Line::new("one two three", WHITE), Line::new("abcdefghijkl", RED), Line::new("", WHITE)];
        assert_eq!(words(&wrapped(&lines, 8)), ["one two", "  three", "abcdefgh", "  ijkl", ""]);
        assert_eq!(words(&wrapped(&lines, 100)), words(&lines));
        assert!(wrapped(&lines, 0).iter().all(|line| line.text.chars().count() <= 4));
    }

    #[test]
    fn letters_are_found_or_replaced() {
        // The lowest bit is the dot on the left: an L has its stem there, and a foot.
        let l = glyph('L');
        assert!(l[1] & 0b0000_1111 != 0 && l[1] & 0b1111_0000 == 0 && l[6] & 0b1111_0000 != 0);
        for there in ['°', '×', '²', 'ε', 'λ'] {
            assert_ne!(glyph(there), glyph('?'), "{there}");
        }
        assert_eq!(glyph('−'), glyph('-'));
        assert_eq!(glyph('漢'), glyph('?'));
    }

    #[test]
    fn text_is_bright_on_dark_and_stays_inside() {
        let mut raster = Raster::new(300, 60);
        for y in 0..60 {
            raster.row_mut(0, y, 300).fill(WHITE);
        }
        draw(&mut raster, &[], &[Line::new("I", YELLOW)]);
        let count = |color: u32| raster.pixels().iter().filter(|p| **p == color).count();
        let dots: u32 = glyph('I').iter().map(|row| row.count_ones()).sum();
        assert_eq!(count(YELLOW), dots as usize);
        assert_eq!(count(darkened(WHITE)), 16 * 16 - dots as usize);
        assert_eq!(raster.pixels()[0], WHITE);

        // Windows that are too small for any text.
        for (width, height) in [(1, 1), (1, 500), (500, 1), (40, 9)] {
            let many = vec![Line::new("a long line of many words", WHITE); 30];
            draw(&mut Raster::new(width, height), &many, &many);
        }
    }
}
