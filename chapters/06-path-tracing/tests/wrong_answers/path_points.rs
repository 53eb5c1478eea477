//! Wrong shuffles, and wrong points for the paths of a pixel.

use common::{Stream, Vec2};

use crate::{
    checks::{
        pixel_means::independent,
        stratified_paths::{Answer, check},
    },
    name,
    stratified_paths::{RIGHT, any, path_points, points, sets, shuffle, stratified},
};

/// The diagnosis of such a shuffle.
fn shuffles(shuffle: fn(&mut [Vec2], &mut Stream)) -> &'static str {
    name(check(Answer { shuffle, ..RIGHT }))
}

#[test]
fn wrong_shuffles() {
    assert_eq!(shuffles(|points, _| points.reverse()), "always-one-order");
    assert_eq!(
        shuffles(|points, random| {
            let count = points.len();
            (0..count).for_each(|i| points.swap(i, any(count, random)));
        }),
        "swaps-with-any"
    );
    // Sattolo's: all orders that are one round trip.
    assert_eq!(
        shuffles(|points, random| (1..points.len()).for_each(|i| points.swap(any(i, random), i))),
        "never-stays"
    );
    assert_eq!(
        shuffles(|points, random| {
            let by = any(points.len().max(1), random);
            points.rotate_left(by);
        }),
        "rotated"
    );
    assert_eq!(
        shuffles(|points, random| {
            if let Some(last) = points.len().checked_sub(1) {
                points.swap(any(last + 1, random), last);
                points.swap(any(last + 1, random), 0);
            }
        }),
        "not-all-orders-alike"
    );
    // Drawn with repetition.
    assert_eq!(
        shuffles(|points, random| {
            let before = points.to_vec();
            points.iter_mut().for_each(|point| *point = before[any(before.len(), random)]);
        }),
        "points-lost"
    );
}

#[test]
fn wrong_sets() {
    assert_eq!(points(|n, random| path_points(n, random).into_iter().take(n.into()).collect()), "n-samples");
    assert_eq!(points(|n, random| path_points(n + 1, random)), "wrong-count");
    assert_eq!(points(|n, random| path_points(n, random).into_iter().skip(1).collect()), "wrong-count");
    assert_eq!(points(independent), "cell-twice");
    // Only the places in the pixel are stratified.
    assert_eq!(
        points(|n, random| {
            let others = independent(n, random);
            stratified(n, random).into_iter().zip(others).map(|(place, [_, a, b])| [place, a, b]).collect()
        }),
        "cell-twice"
    );
    assert_eq!(
        points(|n, random| path_points(n, random).into_iter().map(|set| set.map(|p| p * 2.0 - 1.0)).collect()),
        "outside"
    );
    assert_eq!(
        points(|n, random| path_points(n, random).into_iter().map(|set| set.map(|p| p * f32::from(n))).collect()),
        "outside"
    );
    assert_eq!(points(|n, _| path_points(n, &mut Stream::new(1, 2, 3))), "same-in-every-pixel");
}

#[test]
fn wrong_pairs_of_sets() {
    assert_eq!(points(|n, random| sets(n, random, |_, _| ())), "same-shuffle");
    // One order for both.
    assert_eq!(
        points(|n, random| {
            let seed = (random.uniform() * 1e6) as u64;
            sets(n, random, |set, _| shuffle(set, &mut Stream::new(seed, 0, 0)))
        }),
        "same-shuffle"
    );
    assert_eq!(
        points(|n, random| {
            let mut seed = 0;
            sets(n, random, |set, _| {
                seed += 1;
                shuffle(set, &mut Stream::new(seed, 0, 0));
            })
        }),
        "same-order-in-every-pixel"
    );
    assert_eq!(points(|n, random| sets(n, random, |set, _| set.reverse())), "same-order-in-every-pixel");
    assert_eq!(
        points(|n, random| {
            sets(n, random, |set, random| {
                let by = any(set.len(), random);
                set.rotate_left(by);
            })
        }),
        "only-rotated"
    );
    assert_eq!(
        points(|n, random| {
            sets(n, random, |set, random| (0..set.len().min(2)).for_each(|i| set.swap(i, any(set.len(), random))))
        }),
        "not-independent"
    );
    // The points of one set for all.
    assert_eq!(
        points(|n, random| {
            let set = stratified(n, random);
            let [mut second, mut third] = [set.clone(), set.clone()];
            shuffle(&mut second, random);
            shuffle(&mut third, random);
            (0..set.len()).map(|i| [set[i], second[i], third[i]]).collect()
        }),
        "points-in-common"
    );
    // Places of the first set in the cells of the others.
    assert_eq!(
        points(|n, random| {
            let place = |[p, second, third]: [Vec2; 3]| {
                let place = (p * f32::from(n)).fract();
                [p, ((second * f32::from(n)).floor() + place) / f32::from(n), third]
            };
            path_points(n, random).into_iter().map(place).collect()
        }),
        "offsets-alike"
    );
    assert_eq!(
        points(|n, random| {
            let center = |p: Vec2| ((p * f32::from(n)).floor() + 0.5) / f32::from(n);
            path_points(n, random).into_iter().map(|set| set.map(center)).collect()
        }),
        "same-place-in-every-cell"
    );
}
