//! How the origins of rays are spread over the lens.

use common::{
    exercise::{Finding, Verdict},
    float,
};
use glam::DVec2;

use super::{
    even_counts::EvenCounts,
    lens_mistakes as mistakes,
    lens_rays::{Pixel, RAYS},
};

/// Parts of the lens of equal area: rings, and sectors of each.
const PARTS: [u8; 2] = [5, 8];

impl Pixel<'_> {
    /// Origins that are uniform over the lens.
    pub(super) fn fills_the_lens_evenly(&self) -> Verdict {
        let [rings, sectors] = PARTS.map(usize::from);
        let mut counts = EvenCounts::new(rings * sectors);
        // Those that were not drawn do not count.
        for place in self.origins().skip(5) {
            let turn = f64::from(float::atan2(place.y as f32, place.x as f32)) / std::f64::consts::TAU + 0.5;
            let cell = |share: f64, cells: usize| ((share * cells as f64) as usize).min(cells - 1);
            counts.add(cell(place.length_squared(), rings) * sectors + cell(turn, sectors));
        }
        if counts.fit() {
            return Ok(());
        }
        let mean = self.origins().skip(5).map(DVec2::length_squared).sum::<f64>() / RAYS as f64;
        let empty = counts.counts().iter().filter(|count| **count == 0).count();
        let (name, advice) = if mean > 0.9 {
            mistakes::RIM_ONLY
        } else if 2 * empty > counts.counts().len() {
            mistakes::ON_A_LINE
        } else if mean < 0.4 {
            mistakes::MIDDLE_CROWDED
        } else if mean > 0.6 {
            mistakes::RIM_CROWDED
        } else {
            mistakes::NOT_UNIFORM
        };
        let tried = self.tried_with(&format!("{RAYS} uniform points u"));
        let got = format!("{}; the mean of r²/R² is {mean:.3}", counts.got());
        let expected = format!("{}; the mean of r²/R² is 0.5", counts.wanted());
        Err(Finding { tried, got, expected, advice: advice.into() }.named(name))
    }
}
