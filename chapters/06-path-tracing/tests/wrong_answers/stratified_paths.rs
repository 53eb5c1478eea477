//! Wrong stratified paths.

use std::cell::Cell;

use common::{Rgb, Stream, Vec2, picture::FilmPoint, story::Untold};
use path_tracing::{importance::Step, path_tracer::PathTracer};
use sampling::{direction_sampling::DirectionSampling, unit_square::sample_unit_square};

use crate::{
    checks::{
        pixel_means::{Points, Trace, independent},
        stratified_paths::{Answer, check},
    },
    name,
};

pub(super) fn stratified(n: u16, random: &mut Stream) -> Vec<Vec2> {
    let cells = (0..n).flat_map(|row| (0..n).map(move |column| Vec2::new(column.into(), row.into())));
    let below_one = Vec2::splat(1.0 - f32::EPSILON / 2.0);
    cells.map(|cell: Vec2| ((cell + sample_unit_square(random)) / f32::from(n)).min(below_one)).collect()
}

/// A whole number below `count`.
pub(super) fn any(count: usize, random: &mut Stream) -> usize {
    (random.uniform() * count as f32) as usize
}

pub(super) fn shuffle(points: &mut [Vec2], random: &mut Stream) {
    (1..points.len()).for_each(|i| points.swap(any(i + 1, random), i));
}

/// Three sets of points, the second and third rearranged.
pub(super) fn sets(n: u16, random: &mut Stream, mut rearrange: impl FnMut(&mut [Vec2], &mut Stream)) -> Vec<[Vec2; 3]> {
    let [first, mut second, mut third] = [(); 3].map(|()| stratified(n, random));
    rearrange(&mut second, random);
    rearrange(&mut third, random);
    (0..first.len()).map(|i| [first[i], second[i], third[i]]).collect()
}

pub(super) fn path_points(n: u16, random: &mut Stream) -> Vec<[Vec2; 3]> {
    sets(n, random, shuffle)
}

/// A path whose directions come from `point`, by the number of the bounce and the points that are given.
fn path(
    tracer: &PathTracer,
    pixel: FilmPoint,
    [in_pixel, first, second]: [Vec2; 3],
    random: &mut Stream,
    point: impl Fn(u32, [Vec2; 2], &mut Stream) -> Vec2,
) -> Rgb {
    let bounce = Cell::new(0);
    let ray = tracer.camera.ray(FilmPoint { position: pixel.position + in_pixel, ..pixel });
    tracer.walk(ray, random, &mut Untold, |material, hit, _, random, _| {
        let u = point(bounce.replace(bounce.get() + 1), [first, second], random);
        let sample = DirectionSampling::CosineHemisphere.sample(hit.shading_normal, u);
        Some(Step { direction: sample.direction, weight: material.albedo() })
    })
}

/// The point that a bounce takes, counted from 0.
fn point(bounce: u32, given: [Vec2; 2], random: &mut Stream) -> Vec2 {
    match bounce {
        0 => given[0],
        1 => given[1],
        _ => sample_unit_square(random),
    }
}

fn trace(tracer: &PathTracer, pixel: FilmPoint, points: [Vec2; 3], random: &mut Stream) -> Rgb {
    path(tracer, pixel, points, random, point)
}

pub(super) const RIGHT: Answer = Answer { shuffle, path_points, trace };

/// The diagnosis of such points.
pub(super) fn points(path_points: Points) -> &'static str {
    name(check(Answer { path_points, ..RIGHT }))
}

/// The diagnosis of such paths.
fn paths(trace: Trace) -> &'static str {
    name(check(Answer { trace, ..RIGHT }))
}

#[test]
fn all_right_ones_are_accepted() {
    let downward: fn(&mut [Vec2], &mut Stream) =
        |points, random| (1..points.len()).rev().for_each(|i| points.swap(any(i + 1, random), i));
    // A random number for each, and sorted by it.
    let by_keys: fn(&mut [Vec2], &mut Stream) = |points, random| {
        let mut keyed: Vec<_> = points.iter().map(|point| (random.uniform(), *point)).collect();
        keyed.sort_by(|a, b| a.0.total_cmp(&b.0));
        points.iter_mut().zip(keyed).for_each(|(point, (_, shuffled))| *point = shuffled);
    };
    for shuffle in [shuffle, downward, by_keys] {
        assert_eq!(check(Answer { shuffle, ..RIGHT }), Ok(()));
    }
    // All three shuffled, or the samples in another order.
    let all: Points = |n, random| {
        let mut sets = [(); 3].map(|()| stratified(n, random));
        sets.iter_mut().for_each(|set| shuffle(set, random));
        (0..sets[0].len()).map(|i| [sets[0][i], sets[1][i], sets[2][i]]).collect()
    };
    let backward: Points = |n, random| path_points(n, random).into_iter().rev().collect();
    for path_points in [all, backward] {
        assert_eq!(check(Answer { path_points, ..RIGHT }), Ok(()));
    }
    // Numbers may be drawn and not used.
    let generous: Trace = |tracer, pixel, points, random| {
        path(tracer, pixel, points, random, |bounce, given, random| {
            let drawn = sample_unit_square(random);
            if bounce < 2 { given[bounce as usize] } else { drawn }
        })
    };
    assert_eq!(check(Answer { trace: generous, ..RIGHT }), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    let nothing = Answer { shuffle: |_, _| (), path_points: |_, _| vec![], trace: |_, _, _, _| Rgb::ZERO };
    assert_eq!(name(check(nothing)), "not-started");
    assert_eq!(name(check(Answer { shuffle, ..nothing })), "points-not-started");
    assert_eq!(paths(|_, _, _, _| Rgb::ZERO), "trace-not-started");
}

#[test]
fn wrong_places_in_the_pixel() {
    assert_eq!(
        paths(|t, pixel, [_, a, b], random| trace(t, pixel, [Vec2::splat(0.5), a, b], random)),
        "middle-of-the-pixel"
    );
    assert_eq!(paths(|t, pixel, [_, a, b], random| trace(t, pixel, [Vec2::ZERO, a, b], random)), "corner-of-the-pixel");
    assert_eq!(paths(|t, pixel, [p, a, b], random| trace(t, pixel, [p - 0.5, a, b], random)), "half-a-pixel-off");
    assert_eq!(paths(|t, pixel, [p, a, b], random| trace(t, pixel, [p + 0.5, a, b], random)), "half-a-pixel-off");
    assert_eq!(
        paths(|t, pixel, [_, a, b], random| {
            let place = sample_unit_square(random);
            trace(t, pixel, [place, a, b], random)
        }),
        "pixel-by-chance"
    );
    assert_eq!(paths(|t, pixel, [p, a, b], random| trace(t, pixel, [p * 8.0, a, b], random)), "wrong-path");
}

#[test]
fn wrong_bounces() {
    assert_eq!(paths(|t, pixel, [p, a, b], random| trace(t, pixel, [p, b, a], random)), "bounces-swapped");
    assert_eq!(paths(|t, pixel, [p, a, _], random| trace(t, pixel, [p, p, a], random)), "one-bounce-late");
    assert_eq!(paths(|t, pixel, [p, a, _], random| trace(t, pixel, [p, a, a], random)), "first-point-twice");
    assert_eq!(
        paths(|t, pixel, points, random| path(t, pixel, points, random, |_, _, random| sample_unit_square(random))),
        "points-not-used"
    );
    // Only the first is used.
    assert_eq!(
        paths(|t, pixel, points, random| {
            path(
                t,
                pixel,
                points,
                random,
                |i, given, random| if i == 0 { given[0] } else { sample_unit_square(random) },
            )
        }),
        "points-not-used"
    );
    assert_eq!(
        paths(|t, pixel, points, random| path(t, pixel, points, random, |i, given, _| given[i as usize % 2])),
        "rest-not-random"
    );
    assert_eq!(
        paths(|t, pixel, points, random| {
            path(
                t,
                pixel,
                points,
                random,
                |i, given, random| {
                    if i < 2 { given[i as usize] } else { Vec2::splat(random.uniform() * 0.1) }
                },
            )
        }),
        "rest-wrong"
    );
    assert_eq!(
        paths(|t, pixel, points, random| {
            let radiance = trace(t, pixel, points, random);
            if *t.method.bounces.end() > 2 && radiance == Rgb::ZERO { Rgb::NAN } else { radiance }
        }),
        "rest-wrong"
    );
}

/// A path with other directions or weights, by the cosine and the density's weight.
fn weighed(
    (tracer, pixel, points): (&PathTracer, FilmPoint, [Vec2; 3]),
    random: &mut Stream,
    sampling: DirectionSampling,
    factor: fn(f32, f32) -> f32,
) -> Rgb {
    let bounce = Cell::new(0);
    let ray = tracer.camera.ray(FilmPoint { position: pixel.position + points[0], ..pixel });
    tracer.walk(ray, random, &mut Untold, |material, hit, _, random, _| {
        let u = point(bounce.replace(bounce.get() + 1), [points[1], points[2]], random);
        let sample = sampling.sample(hit.shading_normal, u);
        let factor = factor(sample.direction.dot(hit.shading_normal), sample.density.weight());
        Some(Step { direction: sample.direction, weight: material.albedo() * factor })
    })
}

#[test]
fn wrong_weights() {
    use DirectionSampling::{CosineHemisphere, UniformHemisphere};
    use std::f32::consts::PI;
    assert_eq!(
        paths(|t, p, points, random| weighed((t, p, points), random, CosineHemisphere, |c, _| c)),
        "cosine-twice"
    );
    assert_eq!(
        paths(|t, p, points, random| weighed((t, p, points), random, UniformHemisphere, |c, w| c * w / PI)),
        "uniform-directions"
    );
    assert_eq!(
        paths(|t, p, points, random| weighed((t, p, points), random, UniformHemisphere, |_, _| 1.0)),
        "uniform-directions"
    );
    assert_eq!(
        paths(|t, p, points, random| weighed((t, p, points), random, CosineHemisphere, |_, _| 1.0 / PI)),
        "wrong-path"
    );
}

/// Whatever is right for the small questions and wrong for the large one.
#[test]
fn the_whole_is_measured() {
    assert_eq!(points(|n, random| if n == 5 { independent(n, random) } else { path_points(n, random) }), "no-gain");
    assert_eq!(
        points(|n, random| if n == 5 { sets(n, random, |_, _| ()) } else { path_points(n, random) }),
        "mean-off"
    );
}
