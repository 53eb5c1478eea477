//! Wrong costs and wrong planes.

use ray_casting::aabb::Aabb;

use crate::{
    checks::median_or_cost::{Plane, Span, TEST, TRAVERSAL, check},
    name,
};

type Cost = fn(&Aabb, usize, f32, usize, usize) -> f32;
type Cheapest = fn(&Aabb, usize, &[Span]) -> Option<Plane>;

/// The sides of the two halves and of the whole.
fn sides(cell: &Aabb, axis: usize, position: f32) -> [[f32; 3]; 3] {
    let whole = (cell.max - cell.min).to_array();
    let [mut below, mut above] = [whole; 2];
    below[axis] = position - cell.min[axis];
    above[axis] = cell.max[axis] - position;
    [below, above, whole]
}

fn half_surface([x, y, z]: [f32; 3]) -> f32 {
    x * y + y * z + z * x
}

/// The cost with another measure of boxes, and other numbers.
fn cost_by(measure: fn([f32; 3]) -> f32, [a, b, whole]: [[f32; 3]; 3], lower: usize, upper: usize) -> f32 {
    TRAVERSAL + TEST * (measure(a) * lower as f32 + measure(b) * upper as f32) / measure(whole)
}

const COST: Cost =
    |cell, axis, position, lower, upper| cost_by(half_surface, sides(cell, axis, position), lower, upper);

/// How planes are chosen.
#[derive(Clone, Copy)]
struct Choice {
    /// The planes in question.
    places: fn(&Span) -> Vec<f32>,
    /// Whether a span counts for the lower half.
    is_lower: fn(&Span, f32) -> bool,
    /// Whether it counts for the upper half.
    is_upper: fn(&Span, f32) -> bool,
    /// Whether planes in a face count, and whether the cell may be left whole.
    faces: bool,
    whole: bool,
    /// What is to be least: of the cost and the two numbers.
    key: fn(f32, usize, usize) -> f32,
}

const RIGHT: Choice = Choice {
    places: |span| vec![span.begin, span.end],
    is_lower: |span, at| span.begin < at || span.end <= at,
    is_upper: |span, at| span.end > at,
    faces: false,
    whole: true,
    key: |cost, _, _| cost,
};

impl Choice {
    fn choose(self, cell: &Aabb, axis: usize, spans: &[Span]) -> Option<Plane> {
        // Where it would take too long to count, look at a few planes only.
        self.choose_among(cell, axis, spans, 1 + spans.len() / 1000)
    }

    /// The best plane at every so many-th span.
    fn choose_among(self, cell: &Aabb, axis: usize, spans: &[Span], step: usize) -> Option<Plane> {
        let places = spans.iter().step_by(step).flat_map(|span| (self.places)(span));
        let is_inside = |at: &f32| self.faces || cell.min[axis] < *at && *at < cell.max[axis];
        let planes = places.filter(is_inside).map(|position| {
            let lower = spans.iter().filter(|span| (self.is_lower)(span, position)).count();
            let upper = spans.iter().filter(|span| (self.is_upper)(span, position)).count();
            Plane { position, lower, upper, cost: COST(cell, axis, position, lower, upper) }
        });
        let key = |plane: &Plane| (self.key)(plane.cost, plane.lower, plane.upper);
        let best = planes.min_by(|a, b| key(a).total_cmp(&key(b)))?;
        (!self.whole || best.cost < TEST * spans.len() as f32).then_some(best)
    }
}

fn by_cost(cost: Cost) -> &'static str {
    name(check(cost, |cell, axis, spans| RIGHT.choose(cell, axis, spans)))
}

fn by_choice(choice: Choice) -> &'static str {
    name(check(COST, |cell, axis, spans| choice.choose(cell, axis, spans)))
}

/// The right answer in time n·log n.
fn quick(cell: &Aabb, axis: usize, spans: &[Span]) -> Option<Plane> {
    let mut begins: Vec<f32> = spans.iter().filter(|s| s.begin < s.end).map(|s| s.begin).collect();
    let mut flat: Vec<f32> = spans.iter().filter(|s| s.begin == s.end).map(|s| s.end).collect();
    let mut ends: Vec<f32> = spans.iter().map(|s| s.end).collect();
    for list in [&mut begins, &mut flat, &mut ends] {
        list.sort_by(f32::total_cmp);
    }
    let places = begins.iter().chain(&ends).copied().filter(|at| cell.min[axis] < *at && *at < cell.max[axis]);
    let planes = places.map(|position| {
        let lower = begins.partition_point(|b| *b < position) + flat.partition_point(|f| *f <= position);
        let upper = spans.len() - ends.partition_point(|e| *e <= position);
        Plane { position, lower, upper, cost: COST(cell, axis, position, lower, upper) }
    });
    let best = planes.min_by(|a, b| a.cost.total_cmp(&b.cost))?;
    (best.cost < TEST * spans.len() as f32).then_some(best)
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(check(COST, quick), Ok(()));
}

#[test]
fn a_loop_over_all_spans_for_every_plane_is_too_slow() {
    let told = check(COST, |cell, axis, spans| RIGHT.choose_among(cell, axis, spans, 1)).unwrap_err();
    assert_eq!(told.name, "too-slow", "{told}");
}

#[test]
fn planes_that_depend_on_the_call_before() {
    // Every fourth call finds nothing; not yet for the small cells of the check.
    let calls = std::cell::Cell::new(0_u32);
    let tired = |cell: &Aabb, axis: usize, spans: &[Span]| {
        calls.set(calls.get() + 1);
        if calls.get() < 700 { quick(cell, axis, spans) } else { None }
    };
    assert_eq!(name(check(COST, tired)), "poor-tree");
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(name(check(|_, _, _, _, _| 0.0, |_, _, _| None)), "not-started");
    assert_eq!(name(check(COST, |_, _, _| None)), "none-found");
}

#[test]
fn wrong_costs() {
    assert_eq!(by_cost(|cell, axis, at, a, b| COST(cell, axis, at, a, b) - TRAVERSAL), "no-traversal");
    assert_eq!(by_cost(|cell, axis, at, a, b| TRAVERSAL + (COST(cell, axis, at, a, b) - TRAVERSAL) / TEST), "no-test");
    assert_eq!(by_cost(|_, _, _, a, b| TRAVERSAL + TEST * (a + b) as f32), "no-surface");
    assert_eq!(by_cost(|cell, axis, at, a, b| COST(cell, axis, at, b, a)), "sides-mixed");
    let not_divided: Cost = |cell, axis, at, a, b| {
        let [below, above, _] = sides(cell, axis, at).map(half_surface);
        TRAVERSAL + TEST * (below * a as f32 + above * b as f32)
    };
    assert_eq!(by_cost(not_divided), "not-divided");
    assert_eq!(by_cost(|cell, axis, at, a, b| cost_by(|[x, y, z]| x * y * z, sides(cell, axis, at), a, b)), "volumes");
    assert_eq!(by_cost(|cell, axis, at, a, b| cost_by(|[x, y, z]| x + y + z, sides(cell, axis, at), a, b)), "lengths");
    let twice: Cost = |cell, axis, at, a, b| TRAVERSAL + 2.0 * (COST(cell, axis, at, a, b) - TRAVERSAL);
    assert_eq!(by_cost(twice), "factor-two");
    let always_x: Cost = |cell, _, at, a, b| COST(cell, 0, at, a, b);
    assert_eq!(by_cost(always_x), "wrong-axis");
    // Without the division, by the ratio of lengths.
    let by_length: Cost = |cell, axis, at, a, b| {
        let share = (at - cell.min[axis]) / (cell.max[axis] - cell.min[axis]);
        TRAVERSAL + TEST * (share * a as f32 + (1.0 - share) * b as f32)
    };
    assert_eq!(by_cost(by_length), "volumes");
    // A position is no length.
    let from_zero: Cost = |cell, axis, at, a, b| {
        let [mut below, mut above, whole] = sides(cell, axis, at);
        (below[axis], above[axis]) = (at, whole[axis] - at);
        cost_by(half_surface, [below, above, whole], a, b)
    };
    assert_eq!(by_cost(from_zero), "wrong-cost");
    assert_eq!(by_cost(|_, _, _, _, _| f32::NAN), "not-a-number");
}

#[test]
fn wrong_places() {
    assert_eq!(by_choice(Choice { places: |span| vec![span.begin], ..RIGHT }), "ends-forgotten");
    assert_eq!(by_choice(Choice { places: |span| vec![span.end], ..RIGHT }), "begins-forgotten");
    assert_eq!(
        by_choice(Choice { places: |span| vec![f32::midpoint(span.begin, span.end)], ..RIGHT }),
        "no-such-place"
    );
    assert_eq!(by_choice(Choice { faces: true, ..RIGHT }), "in-a-face");
    assert_eq!(by_choice(Choice { whole: false, ..RIGHT }), "not-worth-it");
    let median: Choice = Choice { key: |_, a, b| a.abs_diff(b) as f32, ..RIGHT };
    assert_eq!(by_choice(median), "median");
    assert_eq!(by_choice(Choice { key: |cost, _, _| -cost, ..RIGHT }), "not-cheapest");
    assert_eq!(by_choice(Choice { key: |cost, _, _| -cost, whole: false, ..RIGHT }), "not-cheapest");
}

#[test]
fn wrong_numbers() {
    assert_eq!(by_choice(Choice { is_lower: |span, at| span.begin < at, ..RIGHT }), "flat-lost");
    assert_eq!(by_choice(Choice { is_upper: |span, at| span.begin >= at && span.end > at, ..RIGHT }), "one-side-only");
    assert_eq!(by_choice(Choice { is_lower: |span, at| span.end <= at, ..RIGHT }), "one-side-only");
    assert_eq!(by_choice(Choice { is_lower: |span, at| span.begin <= at, ..RIGHT }), "touching");
    assert_eq!(by_choice(Choice { is_upper: |span, at| span.end >= at, ..RIGHT }), "touching");
    let other_cost: Cheapest = |cell, axis, spans| {
        let plane = RIGHT.choose(cell, axis, spans)?;
        Some(Plane { cost: plane.cost - TRAVERSAL, ..plane })
    };
    assert_eq!(name(check(COST, other_cost)), "other-cost");
}

#[test]
fn begins_and_ends_counted_in_the_wrong_order() {
    // A sweep that meets begins before ends at the same place.
    let sweep: Cheapest = |cell, axis, spans| {
        let mut events: Vec<(f32, bool)> = spans.iter().flat_map(|s| [(s.begin, false), (s.end, true)]).collect();
        events.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let (mut lower, mut upper) = (0, spans.len());
        let mut best: Option<Plane> = None;
        for (position, is_end) in events {
            if is_end {
                upper -= 1;
            }
            let cost = COST(cell, axis, position, lower, upper);
            let is_inside = cell.min[axis] < position && position < cell.max[axis];
            if is_inside && cost < best.map_or(TEST * spans.len() as f32, |best| best.cost) {
                best = Some(Plane { position, lower, upper, cost });
            }
            if !is_end {
                lower += 1;
            }
        }
        best
    };
    assert_eq!(name(check(COST, sweep)), "touching");
}
