//! Wrong stratified samples.

use common::{Stream, Vec2};
use sampling::slope::log_log_slope;

use crate::{
    checks::stratified_samples::{Answer, ROUNDED, check},
    name,
};

const BELOW_ONE: f32 = 1.0 - f32::EPSILON / 2.0;

fn stratified(count: u16, random: &mut Stream) -> Vec<f32> {
    (0..count).map(|i| ((f32::from(i) + random.uniform()) / f32::from(count)).min(BELOW_ONE)).collect()
}

/// Points whose offsets come from `offset`.
fn grid(columns: u16, rows: u16, mut offset: impl FnMut() -> Vec2) -> Vec<Vec2> {
    let cells = (0..rows).flat_map(|row| (0..columns).map(move |column| Vec2::new(column.into(), row.into())));
    let size = Vec2::new(columns.into(), rows.into());
    cells.map(|corner| ((corner + offset()) / size).min(Vec2::splat(BELOW_ONE))).collect()
}

fn any(random: &mut Stream) -> Vec2 {
    let x = random.uniform();
    Vec2::new(x, random.uniform())
}

fn stratified_square(columns: u16, rows: u16, random: &mut Stream) -> Vec<Vec2> {
    grid(columns, rows, || any(random))
}

const RIGHT: Answer = Answer { stratified, stratified_square };

/// The diagnosis of such samples of the interval.
fn line(stratified: fn(u16, &mut Stream) -> Vec<f32>) -> &'static str {
    name(check(Answer { stratified, ..RIGHT }))
}

/// The diagnosis of such points of the square.
fn square(stratified_square: fn(u16, u16, &mut Stream) -> Vec<Vec2>) -> &'static str {
    name(check(Answer { stratified_square, ..RIGHT }))
}

/// Samples with an offset that is made of a random number.
fn with(offset: impl Fn(f32) -> f32, count: u16, random: &mut Stream) -> Vec<f32> {
    (0..count).map(|i| ((f32::from(i) + offset(random.uniform())) / f32::from(count)).min(BELOW_ONE)).collect()
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(check(RIGHT), Ok(()));
    // The order does not matter, and f64 is as good.
    let backward: fn(u16, &mut Stream) -> Vec<f32> = |count, random| {
        let at = |i: u16, u: f32| ((f64::from(i) + f64::from(u)) / f64::from(count)) as f32;
        (0..count).rev().map(|i| at(i, random.uniform()).min(BELOW_ONE)).collect()
    };
    let by_columns: fn(u16, u16, &mut Stream) -> Vec<Vec2> = |columns, rows, random| {
        stratified_square(rows, columns, random).into_iter().map(|p| Vec2::new(p.y, p.x)).collect()
    };
    assert_eq!(check(Answer { stratified: backward, stratified_square: by_columns }), Ok(()));
}

/// What the task says about errors: for e^x they fall like M^(−3/2) on the line, and for e^(x + y) like 1/M.
#[test]
fn errors_fall_as_the_task_says() {
    let e = std::f64::consts::E;
    let exp = |x: f32| common::float::exp_f64(x.into());
    let error = |measure: &dyn Fn(&mut Stream) -> f64, exact: f64| {
        let squares = (0..400)
            .map(|run| (measure(&mut Stream::new(5, run, 0)) - exact) * (measure(&mut Stream::new(5, run, 0)) - exact));
        (squares.sum::<f64>() / 400.0).sqrt()
    };
    let mean = |values: Vec<f64>| values.iter().sum::<f64>() / values.len() as f64;
    let slope = |points: Vec<[f64; 2]>| log_log_slope(&points).unwrap();
    let line = slope(
        [4, 8, 16, 32, 64]
            .map(|m: u16| {
                [f64::from(m), error(&|random| mean(stratified(m, random).into_iter().map(exp).collect()), e - 1.0)]
            })
            .to_vec(),
    );
    assert!((line + 1.5).abs() < 0.1, "{line}");
    let plane = slope(
        [2, 4, 8, 16]
            .map(|m: u16| {
                let measure = |random: &mut Stream| {
                    mean(stratified_square(m, m, random).iter().map(|p| exp(p.x + p.y)).collect())
                };
                [f64::from(m * m), error(&measure, (e - 1.0) * (e - 1.0))]
            })
            .to_vec(),
    );
    assert!((plane + 1.0).abs() < 0.1, "{plane}");
    let random = slope(
        [4, 16, 64]
            .map(|m: u16| {
                [f64::from(m), error(&|random| mean((0..m).map(|_| exp(random.uniform())).collect()), e - 1.0)]
            })
            .to_vec(),
    );
    assert!((random + 0.5).abs() < 0.1, "{random}");
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(name(check(Answer { stratified: |_, _| vec![], stratified_square: |_, _, _| vec![] })), "not-started");
    assert_eq!(square(|_, _, _| vec![]), "square-not-started");
}

#[test]
fn wrong_on_the_line() {
    assert_eq!(line(|count, random| (0..count).map(|_| random.uniform()).collect()), "stratum-missed");
    assert_eq!(line(|count, random| with(|u| 2.0 * u, count, random)), "stratum-missed");
    assert_eq!(line(|count, random| stratified(count + 1, random)), "wrong-count");
    assert_eq!(line(|count, random| stratified(count.max(1), random)), "wrong-count");
    assert_eq!(line(|count, random| (0..count).map(|i| f32::from(i) + random.uniform()).collect()), "outside");
    assert_eq!(
        line(|count, random| (1..=count).map(|i| (f32::from(i) + random.uniform()) / f32::from(count)).collect()),
        "outside"
    );
    assert_eq!(
        line(|count, random| (0..count).map(|i| (f32::from(i) + random.uniform()) / f32::from(count)).collect()),
        "rounded-to-one"
    );
}

#[test]
fn wrong_within_the_stratum() {
    assert_eq!(line(|count, random| with(|_| 0.5, count, random)), "not-random");
    assert_eq!(line(|count, random| with(|_| 0.0, count, random)), "not-random");
    assert_eq!(line(|count, random| with(|u| 0.5 * u, count, random)), "part-of-the-stratum");
    assert_eq!(line(|count, random| with(|u| 0.25 + 0.5 * u, count, random)), "part-of-the-stratum");
    assert_eq!(line(|count, random| with(|u| u * u, count, random)), "not-uniform");
    assert_eq!(
        line(|count, random| {
            let u = random.uniform();
            (0..count).map(|i| ((f32::from(i) + u) / f32::from(count)).min(BELOW_ONE)).collect()
        }),
        "one-number-for-all"
    );
}

#[test]
fn wrong_in_the_square() {
    assert_eq!(square(|columns, rows, random| stratified_square(rows, columns, random)), "cell-missed");
    assert_eq!(square(|columns, rows, random| (0..columns * rows).map(|_| any(random)).collect()), "cell-missed");
    assert_eq!(square(|columns, _, random| stratified_square(columns, columns, random)), "wrong-count");
    assert_eq!(square(|columns, rows, random| grid(columns, rows, || Vec2::splat(random.uniform()))), "diagonal");
    assert_eq!(square(|columns, rows, _| grid(columns, rows, || Vec2::splat(0.5))), "not-random");
    assert_eq!(
        square(|columns, rows, random| {
            let one = any(random);
            grid(columns, rows, || one)
        }),
        "one-number-for-all"
    );
    assert_eq!(
        square(|columns, rows, random| grid(columns, rows, || any(random).with_y(0.5))),
        "not-random",
        "only x is random"
    );
    assert_eq!(
        square(|columns, rows, random| grid(columns, rows, || any(random)).into_iter().map(|p| p * 2.0).collect()),
        "outside"
    );
}

/// The seeds in the check are worth their name: without `BELOW_ONE` there is a 1.
#[test]
fn what_is_rounded_is_seen() {
    let line = |i: u16, u: f32| (f32::from(i) + u) / 1000.0;
    let mut random = Stream::new(ROUNDED[0][0], 0, 0);
    assert!((0..1000).any(|i| line(i, random.uniform()) == 1.0));
    assert_eq!(line(999, Stream::new(ROUNDED[0][1], 0, 0).uniform()), 1.0);
    let mut random = Stream::new(ROUNDED[1][0], 0, 0);
    assert!((0..1000).any(|i| line(i, any(&mut random).x) == 1.0));
    assert_eq!(line(999, any(&mut Stream::new(ROUNDED[1][1], 0, 0)).x), 1.0);
    assert_eq!(
        square(|columns, rows, random| {
            let size = Vec2::new(columns.into(), rows.into());
            let cells = (0..rows).flat_map(|row| (0..columns).map(move |column| Vec2::new(column.into(), row.into())));
            cells.map(|corner| (corner + any(random)) / size).collect()
        }),
        "rounded-to-one"
    );
}
