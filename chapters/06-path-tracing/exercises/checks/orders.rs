//! Whether a shuffle gives all orders alike.

use common::{
    Stream, Vec2,
    exercise::{Finding, Verdict, trying},
};
use sampling::chi_square::{chance, chi_square};

use super::even_counts::EvenCounts;

/// Things that are shuffled, all of their orders, and how often.
const COUNT: usize = 4;
const ORDERS: usize = 24;
const RUNS: u64 = 24_000;

/// A shuffle under test.
pub(super) type Shuffle = fn(&mut [Vec2], &mut Stream);

/// Shuffle that many points; where each of them came from.
fn shuffled(shuffle: Shuffle, count: u16, random: &mut Stream) -> Vec<Vec2> {
    let mut points: Vec<_> = (0..count).map(|i| Vec2::new(i.into(), -f32::from(i))).collect();
    trying(|| format!("`shuffle` of {count} points"), || shuffle(&mut points, random));
    points
}

/// Whether nothing is ever moved.
pub(super) fn does_nothing(shuffle: Shuffle) -> bool {
    (0..20).all(|run| {
        shuffled(shuffle, 9, &mut Stream::new(65, run, 0)) == shuffled(|_, _| (), 9, &mut Stream::new(0, 0, 0))
    })
}

/// Accept a shuffle, or name what is wrong with it.
pub(super) fn check(shuffle: Shuffle) -> Verdict {
    for count in [0, 1, 2, 3, 100, 1000] {
        let mut points = shuffled(shuffle, count, &mut Stream::new(66, count.into(), 0));
        points.sort_by(|a, b| a.x.total_cmp(&b.x));
        if points != shuffled(|_, _| (), count, &mut Stream::new(0, 0, 0)) {
            let advice = "A point was lost, or changed. `points.swap(i, j)` keeps them all.";
            return Err(Finding {
                tried: format!("`shuffle` of {count} points"),
                got: "other points than before".into(),
                expected: "the same points in another order".into(),
                advice: advice.into(),
            }
            .named("points-lost"));
        }
    }
    let (mut counts, mut stays) = (EvenCounts::new(ORDERS), 0);
    for run in 0..RUNS {
        let points = shuffled(shuffle, COUNT as u16, &mut Stream::new(67, run, 0));
        #[expect(clippy::cast_sign_loss, clippy::cast_possible_truncation, reason = "small whole numbers")]
        let order = [0, 1, 2, 3].map(|i| points[i].x as usize);
        stays += (0..COUNT).filter(|i| order[*i] == *i).count();
        counts.add(number(order));
    }
    if counts.fit() {
        return Ok(());
    }
    let seen = counts.counts().iter().filter(|count| **count > 0).count();
    let fits = |rival: Vec<f64>| {
        let expected: Vec<_> = rival.iter().map(|share| share * RUNS as f64).collect();
        chance(chi_square(counts.counts(), &expected), ORDERS - 1) > 1e-8
    };
    let (name, advice) = if seen == 1 {
        ("always-one-order", "The order is always the same one. It must come from `random`.")
    } else if stays == 0 {
        (
            "never-stays",
            "No point ever stays in its place. It must be able to: draw among those that have no place yet, *itself included*.",
        )
    } else if seen <= COUNT {
        (
            "rotated",
            "These are few orders: the points are only moved along. Each place needs a random number of its own.",
        )
    } else if fits(swaps_with_any()) {
        (
            "swaps-with-any",
            "Each point is swapped with any other. There are 4⁴ = 256 ways to do so with four points, and 24 orders. 256 is no \
             multiple of 24, so some orders come more often. Draw only among those that have no place yet.",
        )
    } else {
        (
            "not-all-orders-alike",
            "Draw for each place one of those that have no place yet, each as likely as any other.",
        )
    };
    Err(Finding {
        tried: format!("`shuffle` of four points, {RUNS} times"),
        got: format!("{seen} orders, {}", counts.got()),
        expected: format!("{ORDERS} orders, {}", counts.wanted()),
        advice: advice.into(),
    }
    .named(name))
}

/// The number of an order, from 0 to 23.
fn number(order: [usize; COUNT]) -> usize {
    let smaller_after = |i: usize| order[i + 1..].iter().filter(|x| **x < order[i]).count();
    smaller_after(0) * 6 + smaller_after(1) * 2 + smaller_after(2)
}

/// The shares of all orders when each of the four is swapped with any of the four.
fn swaps_with_any() -> Vec<f64> {
    let mut shares = vec![0.0; ORDERS];
    for way in 0..256_usize {
        let mut order = [0, 1, 2, 3];
        (0..COUNT).for_each(|i| order.swap(i, way >> (2 * i) & 3));
        shares[number(order)] += 1.0 / 256.0;
    }
    shares
}
