//! Whether the points of a pixel are three stratified sets that know nothing of each other.

use common::{
    Stream, Vec2,
    exercise::{Diagnosis, Finding, Verdict, trying},
};
use sampling::chi_square::{chance, chi_square};

use super::{
    even_counts::EvenCounts,
    pixel_means::Points,
    set_mistakes::{self as mistakes, Mistake},
};

/// Names of the three sets.
const SETS: [&str; 3] = ["in the pixel", "first direction", "second direction"];
/// Cells of a set with n = 3, and how many pixels are drawn with it.
const CELLS: usize = 9;
const PIXELS: u64 = 3000;

/// The student's points of a pixel.
fn drawn(points: Points, n: u16, seed: u64) -> Vec<[Vec2; 3]> {
    trying(|| format!("`path_points({n}, random)`"), || points(n, &mut Stream::new(68, n.into(), seed)))
}

/// Accept sets of points, or name what is wrong with them.
pub(super) fn check(points: Points) -> Verdict {
    if drawn(points, 2, 0).is_empty() {
        let message = "`shuffle` is right. Now for `path_points`, which makes no points at all.";
        return Err(Diagnosis::new("points-not-started", message));
    }
    for n in [1, 2, 3, 4, 8] {
        for seed in 0..20 {
            stratified(n, &drawn(points, n, seed))?;
        }
    }
    if drawn(points, 4, 0) == drawn(points, 4, 1) {
        let got = "the same points from two different streams".into();
        return Err(wrong(4, got, "other points in each pixel".into(), mistakes::SAME_IN_EVERY_PIXEL));
    }
    let pixels: Vec<_> = (0..PIXELS).map(|seed| drawn(points, 3, seed)).collect();
    scattered(&pixels)?;
    for [a, b] in [[0, 1], [0, 2], [1, 2]] {
        in_common(&pixels[0], [a, b])?;
        paired(&pixels, [a, b])?;
    }
    unlike(&pixels)
}

fn wrong(n: u16, got: String, expected: String, (name, advice): Mistake) -> Diagnosis {
    Finding { tried: format!("`path_points({n}, random)`"), got, expected, advice: advice.into() }.named(name)
}

/// The cell of a point, row by row.
fn cell(point: Vec2, n: u16) -> usize {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to n − 1")]
    let [column, row] = point.to_array().map(|x| ((x * f32::from(n)) as usize).min(usize::from(n) - 1));
    row * usize::from(n) + column
}

/// The sets of one pixel, each with one point in each cell.
fn stratified(n: u16, points: &[[Vec2; 3]]) -> Verdict {
    let count = usize::from(n) * usize::from(n);
    if points.len() != count {
        let mistake = if points.len() == usize::from(n) { mistakes::N_SAMPLES } else { mistakes::WRONG_COUNT };
        return Err(wrong(n, format!("{} samples", points.len()), format!("{count} samples"), mistake));
    }
    for (set, name) in SETS.iter().enumerate() {
        let mut hits = vec![0; count];
        for point in points.iter().map(|sample| sample[set]) {
            if !(point.cmpge(Vec2::ZERO).all() && point.cmplt(Vec2::ONE).all()) {
                let got = format!("the point ({}, {}), {name}", point.x, point.y);
                return Err(wrong(n, got, "numbers that are at least 0 and below 1".into(), mistakes::OUTSIDE));
            }
            hits[cell(point, n)] += 1;
        }
        if let Some(twice) = hits.iter().position(|hits| *hits > 1) {
            let empty = hits.iter().filter(|hits| **hits == 0).count();
            let got = format!("{} points in cell {twice} and none in {empty} cells, {name}", hits[twice]);
            return Err(wrong(n, got, "one point in each cell".into(), mistakes::CELL_TWICE));
        }
    }
    Ok(())
}

/// Two sets of which each cell of the one goes with each cell of the other.
fn paired(pixels: &[Vec<[Vec2; 3]>], sets: [usize; 2]) -> Verdict {
    let (mut pairs, mut steps) = (EvenCounts::new(CELLS * CELLS), EvenCounts::new(CELLS - 1));
    for pixel in pixels {
        let mut partner = [0; CELLS];
        for sample in pixel {
            let [a, b] = sets.map(|set| cell(sample[set], 3));
            pairs.add(a * CELLS + b);
            partner[a] = b;
        }
        // How far the partners of the first two cells lie apart: never 0.
        steps.add((partner[1] + CELLS - partner[0]) % CELLS - 1);
    }
    // The cells of a pixel are all different, so they stray a little less than chance would: by the factor 8/9.
    let mean = PIXELS as f64 / CELLS as f64;
    let strays = chi_square(pairs.counts(), &[mean; CELLS * CELLS]) * (CELLS - 1) as f64 / CELLS as f64;
    let kinds = pairs.counts().iter().filter(|count| **count > 0).count();
    let is_equal = (0..CELLS).all(|i| u64::from(pairs.counts()[i * CELLS + i]) == PIXELS);
    let mistake = if is_equal {
        mistakes::SAME_SHUFFLE
    } else if kinds == CELLS {
        mistakes::SAME_ORDER_IN_EVERY_PIXEL
    } else if chance(strays, (CELLS - 1) * (CELLS - 1)) <= 1e-8 {
        mistakes::NOT_INDEPENDENT
    } else if !steps.fit() {
        mistakes::ROTATED
    } else {
        return Ok(());
    };
    let names = sets.map(|set| SETS[set]);
    let got =
        format!("{kinds} different pairs of cells in {PIXELS} pixels, of the sets '{}' and '{}'", names[0], names[1]);
    Err(wrong(3, got, format!("all {} pairs, each as likely as any other", CELLS * CELLS), mistake))
}

/// Two sets that have no point in common.
fn in_common(pixel: &[[Vec2; 3]], [a, b]: [usize; 2]) -> Verdict {
    let has = |point: Vec2| pixel.iter().any(|sample| sample[b] == point);
    let common = pixel.iter().filter(|sample| has(sample[a])).count();
    if common < 2 {
        return Ok(());
    }
    let got = format!("{common} points that are in the sets '{}' and '{}'", SETS[a], SETS[b]);
    Err(wrong(3, got, "sets of different points".into(), mistakes::IN_COMMON))
}

/// Where a point lies in its cell: one of the six numbers of a sample.
fn offset(sample: &[Vec2; 3], i: usize) -> f64 {
    f64::from((sample[i / 2][i % 2] * 3.0).fract())
}

/// Points that lie anywhere in their cells.
fn scattered(pixels: &[Vec<[Vec2; 3]>]) -> Verdict {
    for i in 0..6 {
        let mut counts = EvenCounts::new(20);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 20")]
        pixels.iter().flatten().for_each(|sample| counts.add((offset(sample, i) * 20.0) as usize));
        let filled = counts.counts().iter().filter(|count| **count > 0).count();
        if !counts.fit() {
            let mistake = if filled == 1 { mistakes::SAME_PLACE } else { mistakes::NOT_UNIFORM };
            return Err(wrong(3, counts.got(), counts.wanted(), mistake));
        }
    }
    Ok(())
}

/// Places in their cells that know nothing of each other.
fn unlike(pixels: &[Vec<[Vec2; 3]>]) -> Verdict {
    let samples = || pixels.iter().flatten();
    for [i, j] in (0..6).flat_map(|i| (0..i).map(move |j| [i, j])) {
        let sum: f64 = samples().map(|sample| (offset(sample, i) - 0.5) * (offset(sample, j) - 0.5)).sum();
        // Of independent numbers it is 0 ± 0.006.
        let correlation = 12.0 * sum / samples().count() as f64;
        if correlation.abs() > 0.05 {
            let got = format!("places in their cells with a correlation of {correlation:.2}");
            return Err(wrong(3, got, "a correlation near 0".into(), mistakes::ALIKE));
        }
    }
    Ok(())
}
