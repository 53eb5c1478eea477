//! The tree as a diagram, below what the eye sees.

use common::{
    Vec2,
    drawing::{CHALK, Drawing, FAINT, SLATE, lettering::Lettering, mark::Pen},
    picture::FilmPoint,
};

use super::{FILM, Node, overlay::pen};

/// The page: what the scene leaves of a picture 960 wide and 540 high.
const PAGE: Vec2 = Vec2::new(355.0, 540.0);
/// Where on the page the film begins.
pub(super) const FILM_AT: Vec2 = Vec2::new(17.0, 17.0);
/// Where the first dot of the tree lies.
const ROOT_AT: Vec2 = Vec2::new(26.0, 232.0);
/// The lowest place for a dot.
const BOTTOM: f32 = 522.0;
/// From one line to the next, if there is room, and from one depth to the next.
const STEP: Vec2 = Vec2::new(26.0, 27.0);
/// How much room the words need beside the deepest dot.
const WORDS: f32 = 178.0;
/// The most rays that are drawn.
const MOST: usize = 15;

/// The film with the pixel marked, and the tree: a line of the page for each ray, the stronger rays if there are many.
pub(super) fn draw(tree: &[Node], pixel: FilmPoint) -> Drawing {
    let mut drawing = Drawing::new(PAGE, SLATE);
    draw_pixel(&mut drawing, pixel);
    let drawn = strongest(tree);
    let left_out = tree.len() - drawn.len();
    // Everything in the room there is.
    let lines = drawn.len() + usize::from(left_out > 0);
    let deepest = drawn.iter().map(|node| node.segment.depth).max().unwrap_or(0);
    let step = Vec2::new(
        STEP.x.min((PAGE.x - ROOT_AT.x - WORDS) / as_f32(deepest.max(1) as usize)),
        STEP.y.min((BOTTOM - ROOT_AT.y) / as_f32(lines.max(2) - 1)),
    );
    let place = |line: usize, depth: u32| ROOT_AT + Vec2::new(as_f32(depth as usize), as_f32(line)) * step;
    // Edges first, dots over them.
    for (line, node) in drawn.iter().enumerate() {
        let depth = node.segment.depth;
        let parent = drawn[..line].iter().rposition(|above| above.segment.depth + 1 == depth);
        let at = place(line, depth);
        if let Some(parent) = parent {
            let from = place(parent, depth - 1);
            drawing.line(&[from, Vec2::new(from.x, at.y), at], pen(node.color(), node.share()));
        }
    }
    for (line, node) in drawn.iter().enumerate() {
        draw_node(&mut drawing, node, place(line, node.segment.depth));
    }
    if left_out > 0 {
        let letters = Lettering::new(18.0, FAINT);
        let at = place(drawn.len(), 0) + Vec2::new(0.0, letters.drop());
        drawing.text(&format!("… and {left_out} weaker rays"), at, letters);
    }
    drawing
}

/// A dot, the share, and what was hit.
fn draw_node(drawing: &mut Drawing, node: &Node, at: Vec2) {
    let letters = |color| Lettering::new(18.0, color);
    drawing.disc(at, 5.5, node.color());
    // Nothing was hit: the dot is empty.
    if node.name.is_none() {
        drawing.disc(at, 3.3, SLATE);
    }
    let words = at + Vec2::new(13.0, letters(CHALK).drop());
    let share = format!("{} ", percent(node.share()));
    drawing.text(&share, words, letters(node.color()));
    let behind = words + Vec2::X * letters(CHALK).width(&share);
    drawing.text(node.name.unwrap_or("background"), behind, letters(CHALK));
}

/// The frame of the film and a ring around the pixel.
fn draw_pixel(drawing: &mut Drawing, pixel: FilmPoint) {
    let corners = [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y, Vec2::ZERO].map(|share| FILM_AT + share * FILM);
    drawing.line(&corners, Pen::new(FAINT, 1.6));
    let center = FILM_AT + pixel.position;
    for toward in [Vec2::X, Vec2::Y, Vec2::NEG_X, Vec2::NEG_Y] {
        drawing.line(&[center + toward * 5.0, center + toward * 14.0], Pen::new(SLATE, 5.0));
        drawing.line(&[center + toward * 5.0, center + toward * 14.0], Pen::new(CHALK, 2.2));
    }
}

/// The rays with the greatest shares, in the order of the tree. With a ray, that which caused it is there too.
fn strongest(tree: &[Node]) -> Vec<&Node> {
    let mut order: Vec<usize> = (0..tree.len()).collect();
    // Of equal ones that which comes first.
    order.sort_by(|a, b| tree[*b].share().total_cmp(&tree[*a].share()));
    order.truncate(MOST);
    order.sort_unstable();
    order.into_iter().filter_map(|i| tree.get(i)).collect()
}

/// A share with two or three figures.
fn percent(share: f32) -> String {
    let percent = share * 100.0;
    let decimals = if percent >= 9.95 { 0 } else { usize::from(percent < 0.995) + 1 };
    format!("{percent:.decimals$} %")
}

#[expect(clippy::cast_precision_loss, reason = "few lines")]
fn as_f32(count: usize) -> f32 {
    count as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_have_few_figures() {
        assert_eq!([1.0, 0.962, 0.0386, 0.0015].map(percent), ["100 %", "96 %", "3.9 %", "0.15 %"]);
    }
}
