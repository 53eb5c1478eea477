//! The bars below a scene.

use common::{
    Vec2,
    drawing::{
        CHALK, Drawing, FAINT, SLATE,
        lettering::{Align, Lettering},
    },
};

use super::{PAGE, VIEW, scenes::Scene};
use crate::{
    choice::Choice,
    pictures::palette::{RED, color},
};

/// Below the scene: where the first bar begins, and how far the next one is from it.
const BARS: Vec2 = Vec2::new(74.0, 70.0);
const STEP: f32 = 34.0;
/// Length of the longest bar, and height of all.
const BAR: Vec2 = Vec2::new(118.0, 20.0);

/// Who takes so many times as many steps as the best has lost.
pub(super) const LOST: f32 = 2.0;

/// A scene's title, why it is hard, and a bar for each structure; `at` is the scene's upper left corner.
pub(super) fn draw(drawing: &mut Drawing, scene: &Scene, steps: &[[f32; 2]; 3], at: Vec2) {
    let middle = at + Vec2::X * (VIEW.x / 2.0);
    drawing.text(scene.title, middle - Vec2::Y * 17.0, Lettering::new(23.0, CHALK).aligned(Align::Center));
    let foot = at + Vec2::Y * VIEW.y;
    let small = Lettering::new(16.0, FAINT);
    for (line, below) in scene.why.into_iter().zip([24.0, 44.0]) {
        drawing.text(line, foot + Vec2::Y * below, small);
    }
    let sums = steps.map(|[cells, tests]| cells + tests);
    let (least, most) = (sums.into_iter().fold(f32::INFINITY, f32::min), sums.into_iter().fold(1.0, f32::max));
    let mut left = foot + BARS;
    for (choice, &[cells, tests]) in Choice::STRUCTURES.into_iter().zip(steps) {
        draw_bar(drawing, choice, [cells, tests].map(|count| count / most * BAR.x), left);
        let is_loser = cells + tests >= LOST * least;
        let letters = Lettering::new(18.0, if is_loser { RED } else { CHALK });
        let words = format!("{:.0}", cells + tests);
        let right = left + Vec2::new((cells + tests) / most * BAR.x + 8.0, BAR.y / 2.0 + letters.drop());
        drawing.text(&words, right, letters);
        if is_loser {
            let behind = right + Vec2::X * (letters.width(&words) + 1.0);
            drawing.text(" loses", behind, Lettering::new(18.0, RED));
        }
        left.y += STEP;
    }
}

/// What the bars mean.
pub(super) fn draw_legend(drawing: &mut Drawing) {
    let words = "mean steps of a camera ray: cells dark, tests bright; twice as many as the best is lost";
    let below = Vec2::new(PAGE.x / 2.0, PAGE.y - 16.0);
    drawing.text(words, below, Lettering::new(17.0, CHALK).aligned(Align::Center));
}

/// Cells visited, dark, and behind them triangles tested, bright; at the left the name.
fn draw_bar(drawing: &mut Drawing, choice: Choice, [cells, tests]: [f32; 2], left: Vec2) {
    let bright = color(choice);
    let mut piece = |from: f32, length: f32, color| {
        let corners = [Vec2::ZERO, Vec2::X * length, Vec2::new(length, BAR.y), Vec2::Y * BAR.y];
        drawing.polygon(&corners.map(|corner| left + Vec2::X * from + corner), color, 1.0);
    };
    piece(0.0, cells, SLATE.lerp(bright, 0.35));
    piece(cells, tests, bright);
    let letters = Lettering::new(18.0, bright).aligned(Align::Right);
    drawing.text(choice.name(), left + Vec2::new(-8.0, BAR.y / 2.0 + letters.drop()), letters);
}
