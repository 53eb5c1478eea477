//! Checks exercise 4.3, median or cost.

use std::{
    hint::black_box,
    time::{Duration, Instant},
};

use common::{
    Interval, Vec3,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice, trying},
};
use ray_casting::aabb::Aabb;
use space_partitioning::{
    primitives::Primitives,
    probe::Counts,
    structure::{Partition, Structure},
};

use super::{
    meshes::{in_stadium, stadium},
    plane_tree::{median, plane_tree},
    words,
};

/// What one step in a tree costs.
pub(crate) const TRAVERSAL: f32 = 1.0;
/// What the test of a primitive costs.
pub(crate) const TEST: f32 = 1.5;

/// What a primitive takes up along an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Span {
    /// Its least coordinate.
    pub(crate) begin: f32,
    /// Its greatest coordinate.
    pub(crate) end: f32,
}

/// A plane that halves a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Plane {
    /// Where it is on its axis.
    pub(crate) position: f32,
    /// How many primitives reach below it.
    pub(crate) lower: usize,
    /// How many primitives reach above it.
    pub(crate) upper: usize,
    /// Expected cost of a ray that meets the cell.
    pub(crate) cost: f32,
}

/// Computes costs.
type Cost<'c> = &'c dyn Fn(&Aabb, usize, f32, usize, usize) -> f32;
/// Chooses planes.
type Cheapest<'c> = &'c dyn Fn(&Aabb, usize, &[Span]) -> Option<Plane>;

/// Accept two functions, or name what is wrong with them.
pub(crate) fn check(
    cost: impl Fn(&Aabb, usize, f32, usize, usize) -> f32,
    cheapest: impl Fn(&Aabb, usize, &[Span]) -> Option<Plane>,
) -> Verdict {
    let cube = Aabb { min: Vec3::ZERO, max: Vec3::splat(4.0) };
    let pair = [Span { begin: 0.0, end: 1.0 }, Span { begin: 3.0, end: 4.0 }];
    let gives_nothing = cost(&cube, 0, 1.0, 3, 5) == 0.0 && cost(&cube, 1, 2.0, 1, 1) == 0.0;
    if gives_nothing && [&pair[..], &pair[..1]].iter().all(|spans| chosen(&cheapest, &cube, 0, spans).is_none()) {
        return Err(Diagnosis::not_started("`cost` returns 0 for every plane, and `cheapest` finds none."));
    }
    costs(&cost)?;
    planes(&cheapest)?;
    pace(&cheapest)?;
    many(&cheapest)?;
    tree(&cheapest)
}

fn sides(cell: &Aabb) -> [f64; 3] {
    (cell.max.as_dvec3() - cell.min.as_dvec3()).to_array()
}

fn half_surface([x, y, z]: [f64; 3]) -> f64 {
    x * y + y * z + z * x
}

/// The cost in f64; `measure` says how large a box of some sides is.
fn cost_by(measure: fn([f64; 3]) -> f64, cell: &Aabb, axis: usize, position: f32, lower: usize, upper: usize) -> f64 {
    let whole = sides(cell);
    let [mut below, mut above] = [whole; 2];
    below[axis] = f64::from(position) - f64::from(cell.min[axis]);
    above[axis] = f64::from(cell.max[axis]) - f64::from(position);
    let tests = measure(below) * lower as f64 + measure(above) * upper as f64;
    f64::from(TRAVERSAL) + f64::from(TEST) * tests / measure(whole)
}

fn right_cost(cell: &Aabb, axis: usize, position: f32, lower: usize, upper: usize) -> f64 {
    cost_by(half_surface, cell, axis, position, lower, upper)
}

fn is_near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-4 * (1.0 + b.abs())
}

/// `cost`.
fn costs(cost: Cost<'_>) -> Verdict {
    let mut dice = Dice::new(431);
    for i in 0..200_usize {
        let min = dice.point(3.0);
        let mut size = Vec3::from_array([(); 3].map(|()| dice.number(0.5, 6.0)));
        let axis = i % 3;
        // Every fourth one is flat, but not along the axis.
        if i % 4 == 3 {
            size[(axis + 1) % 3] = 0.0;
        }
        let cell = Aabb { min, max: min + size };
        let position = min[axis] + size[axis] * dice.choice([0.1, 0.25, 0.5, 0.8]);
        let (lower, upper) = dice.choice([(3, 5), (10, 1), (0, 7), (4, 0), (100, 90)]);
        let tried =
            || format!("{}, halved at {position} along axis {axis}, {lower} below, {upper} above", words::aabb(&cell));
        let got = trying(tried, || cost(&cell, axis, position, lower, upper));
        let expected = right_cost(&cell, axis, position, lower, upper);
        if is_near(f64::from(got), expected) {
            continue;
        }
        let (name, advice) = cost_mistake(f64::from(got), &cell, axis, position, lower, upper);
        let expected = words::number(expected);
        return Err(Finding { tried: tried(), got: got.to_string(), expected, advice: advice.into() }.named(name));
    }
    Ok(())
}

/// Name and advice for a wrong cost.
fn cost_mistake(
    got: f64,
    cell: &Aabb,
    axis: usize,
    position: f32,
    lower: usize,
    upper: usize,
) -> (&'static str, &'static str) {
    if !got.is_finite() {
        return (
            "not-a-number",
            "This is not a number. Was something divided by a side of length zero? A cell may be flat.",
        );
    }
    let right = right_cost(cell, axis, position, lower, upper);
    let (step, test) = (f64::from(TRAVERSAL), f64::from(TEST));
    let surface = half_surface(sides(cell));
    let is = |other: f64| is_near(got, other);
    let by = |measure| is(cost_by(measure, cell, axis, position, lower, upper));
    let volume: fn([f64; 3]) -> f64 = |[x, y, z]| x * y * z;
    let length: fn([f64; 3]) -> f64 = |[x, y, z]| x + y + z;
    // With 2 · (xy + yz + zx) for the halves, but half of that for the cell, or the other way round.
    let half_and_whole = [2.0, 0.5].map(|factor| step + factor * (right - step));
    let other_axis = |other: usize| {
        let share = (position - cell.min[axis]) / (cell.max[axis] - cell.min[axis]);
        let there = cell.min[other] + share * (cell.max[other] - cell.min[other]);
        is(right_cost(cell, other, there, lower, upper)) || is(right_cost(cell, other, position, lower, upper))
    };
    if is(right - step) {
        ("no-traversal", "The step itself costs `TRAVERSAL`, wherever the ray goes then.")
    } else if is(step + (right - step) / test) {
        ("no-test", "Each expected test costs `TEST`.")
    } else if is(step + test * (lower + upper) as f64) {
        ("no-surface", "A half counts only as much as rays get there: by its surface, divided by that of the cell.")
    } else if is(right_cost(cell, axis, position, upper, lower)) {
        (
            "sides-mixed",
            "The surface of the lower half belongs to the number below the plane, that of the upper half to the number above.",
        )
    } else if is(step + (right - step) * surface) || is(step + 2.0 * (right - step) * surface) {
        ("not-divided", "The probability is the surface of the half *divided by* that of the cell.")
    } else if by(volume) {
        (
            "volumes",
            "Rays are not points: the probability is a ratio of surfaces, not of volumes or of lengths along the axis.",
        )
    } else if by(length) {
        ("lengths", "The surface of a box is 2·(xy + yz + zx), from its three sides x, y, z.")
    } else if half_and_whole.iter().any(|other| is(*other)) {
        ("factor-two", "All three surfaces are to be computed alike, with the factor 2 or without it.")
    } else if (0..3).any(|other| other != axis && other_axis(other)) {
        ("wrong-axis", "The plane is at right angles to `axis`: only that side of the halves differs from the cell's.")
    } else {
        (
            "wrong-cost",
            "Compute one cost by hand: the three sides of each half, their surfaces, the two ratios, the sum.",
        )
    }
}

fn span_words(axis: usize, spans: &[Span]) -> String {
    let some: Vec<_> = spans.iter().take(12).map(|Span { begin, end }| format!("{begin} to {end}")).collect();
    let more = if spans.len() > 12 { format!(" and {} more", spans.len() - 12) } else { String::new() };
    format!("the spans {}{more} along axis {axis}", some.join(", "))
}

fn tried(cell: &Aabb, axis: usize, spans: &[Span]) -> String {
    format!("{}, with {}", words::aabb(cell), span_words(axis, spans))
}

fn chosen(cheapest: Cheapest<'_>, cell: &Aabb, axis: usize, spans: &[Span]) -> Option<Plane> {
    trying(|| tried(cell, axis, spans), || cheapest(cell, axis, spans))
}

fn plane_words(plane: &Plane) -> String {
    let Plane { position, lower, upper, cost } = plane;
    format!("a plane at {position}, {lower} below, {upper} above, cost {cost}")
}

/// How many spans reach below and above a plane.
fn counts(spans: &[Span], position: f32) -> (usize, usize) {
    let is_below = |span: &&Span| span.begin < position || span.end == position && span.begin == position;
    (spans.iter().filter(is_below).count(), spans.iter().filter(|span| span.end > position).count())
}

/// The plane of least cost among some positions, by trying them all.
fn best_of(cell: &Aabb, axis: usize, spans: &[Span], positions: impl Iterator<Item = f32>) -> Option<Plane> {
    let is_inside = |position: &f32| cell.min[axis] < *position && *position < cell.max[axis];
    let planes = positions.filter(is_inside).map(|position| {
        let (lower, upper) = counts(spans, position);
        #[expect(clippy::cast_possible_truncation, reason = "compared with some tolerance")]
        let cost = right_cost(cell, axis, position, lower, upper) as f32;
        Plane { position, lower, upper, cost }
    });
    planes.min_by(|a, b| a.cost.total_cmp(&b.cost))
}

/// `cheapest`, for cells of all kinds.
fn planes(cheapest: Cheapest<'_>) -> Verdict {
    let cube = Aabb { min: Vec3::ZERO, max: Vec3::splat(4.0) };
    let span = |begin: f32, end: f32| Span { begin, end };
    judge(cheapest, &cube, 0, &[span(0.0, 1.0), span(3.0, 4.0)])?;
    // In cells of many primitives, a plane is worth it even where some mistake is made.
    let mut dice = Dice::new(432);
    for i in 0..200 {
        let (cell, spans) = random(&mut dice, i % 3, [30, 60, 100]);
        judge(cheapest, &cell, i % 3, &spans)?;
    }
    // One that reaches over; flat ones; some that touch; on faces; all alike; none.
    let cases: [&[Span]; 7] = [
        &[span(0.0, 1.0), span(0.0, 1.0), span(0.0, 1.0), span(0.5, 3.5)],
        &[span(1.0, 1.0), span(1.0, 1.0), span(1.0, 1.0), span(3.0, 3.5), span(3.0, 3.5)],
        &[span(0.0, 2.0), span(0.0, 2.0), span(2.0, 4.0), span(2.0, 4.0), span(2.0, 4.0)],
        &[span(0.0, 0.0), span(4.0, 4.0), span(0.0, 4.0)],
        &[span(0.0, 4.0); 6],
        &[span(3.0, 4.0); 5],
        &[],
    ];
    for spans in cases {
        for axis in 0..3 {
            judge(cheapest, &cube, axis, spans)?;
        }
    }
    for i in 0..400 {
        let (cell, spans) = random(&mut dice, i % 3, [1, 2, 8]);
        judge(cheapest, &cell, i % 3, &spans)?;
    }
    Ok(())
}

/// A cell, and spans in it along an axis, as many as one of three numbers.
fn random(dice: &mut Dice, axis: usize, counts: [usize; 3]) -> (Aabb, Vec<Span>) {
    let size = Vec3::from_array([(); 3].map(|()| dice.choice([1.0, 2.0, 8.0])));
    let min = dice.point(5.0);
    let cell = Aabb { min, max: min + size };
    // In some cells all places are multiples of an eighth, so that many fall together.
    let is_coarse = dice.happens(0.5);
    // In some, much of it is empty.
    let crowded = dice.choice([1.0, 0.4]);
    let place = |share: f32| {
        let share = if is_coarse { (share * 8.0).round() / 8.0 } else { share };
        (min[axis] + share * size[axis]).min(cell.max[axis])
    };
    let spans = (0..dice.choice(counts)).map(|_| {
        let begin = dice.number(0.0, 1.0) * crowded;
        let length = dice.choice([0.0, 0.1, 0.3]) * dice.number(0.0, 1.0);
        Span { begin: place(begin), end: place(begin + length) }
    });
    let spans = spans.collect();
    (cell, spans)
}

/// The mistake, if a plane is not the cheapest one.
fn judge(cheapest: Cheapest<'_>, cell: &Aabb, axis: usize, spans: &[Span]) -> Verdict {
    let got = chosen(cheapest, cell, axis, spans);
    let places = || spans.iter().flat_map(|span| [span.begin, span.end]);
    let whole = TEST * spans.len() as f32;
    let best = best_of(cell, axis, spans, places());
    let told = |plane: Option<Plane>| plane.map_or("None".into(), |plane| plane_words(&plane));
    let fault = |name, expected: Option<Plane>, advice: &str| {
        let tried = format!("{}; left whole it costs {whole}", tried(cell, axis, spans));
        Err(Finding { tried, got: told(got), expected: told(expected), advice: advice.into() }.named(name))
    };
    // Where a plane and the whole cell cost nearly the same, rounding decides.
    let is_close = best.is_some_and(|best| is_near(f64::from(best.cost), f64::from(whole)));
    let worth = best.filter(|best| best.cost < whole);
    let Some(plane) = got else {
        let advice = "There is a plane that costs less than to leave the cell whole.";
        return if worth.is_none() || is_close { Ok(()) } else { fault("none-found", worth, advice) };
    };
    if !plane.cost.is_finite() || !plane.position.is_finite() {
        return fault("not-a-number", worth, "This plane is not a number.");
    }
    if plane.position <= cell.min[axis] || plane.position >= cell.max[axis] {
        return fault("in-a-face", worth, "This plane lies in a face of the cell, or outside. It halves nothing.");
    }
    if !places().any(|place| place == plane.position) {
        return fault("no-such-place", worth, NO_SUCH_PLACE);
    }
    let (lower, upper) = counts(spans, plane.position);
    if (plane.lower, plane.upper) != (lower, upper) {
        let (name, advice) = count_mistake(spans, &plane);
        let (cost, position) = (right_cost(cell, axis, plane.position, lower, upper), plane.position);
        #[expect(clippy::cast_possible_truncation, reason = "for a message")]
        return fault(name, Some(Plane { position, lower, upper, cost: cost as f32 }), advice);
    }
    let cost = right_cost(cell, axis, plane.position, lower, upper);
    if !is_near(f64::from(plane.cost), cost) {
        let advice = format!("The numbers of this plane are right, but by `cost` it costs {}.", words::number(cost));
        return fault("other-cost", worth, &advice);
    }
    let Some(worth) = worth.filter(|_| !is_close || plane.cost < whole) else {
        let advice =
            "No plane costs less than to leave the cell whole, which is `TEST` times the number of its primitives.";
        return if is_close { Ok(()) } else { fault("not-worth-it", None, advice) };
    };
    if is_near(cost, f64::from(worth.cost)) {
        return Ok(());
    }
    let is_best_of = |places: &mut dyn Iterator<Item = f32>| {
        best_of(cell, axis, spans, places).is_some_and(|best| is_near(cost, f64::from(best.cost)))
    };
    if is_best_of(&mut spans.iter().map(|span| span.begin)) {
        return fault(
            "ends-forgotten",
            Some(worth),
            "This is the cheapest plane at a begin. Planes at ends are in question, too.",
        );
    }
    if is_best_of(&mut spans.iter().map(|span| span.end)) {
        return fault(
            "begins-forgotten",
            Some(worth),
            "This is the cheapest plane at an end. Planes at begins are in question, too.",
        );
    }
    if is_best_of(&mut spans.iter().map(|span| f32::midpoint(span.begin, span.end))) {
        return fault("no-such-place", Some(worth), NO_SUCH_PLACE);
    }
    let difference = |position: f32| {
        let (lower, upper) = counts(spans, position);
        lower.abs_diff(upper)
    };
    if places().all(|place| difference(place) >= lower.abs_diff(upper)) {
        let advice =
            "This is the plane that leaves the most equal numbers on both sides, the median. Choose by the cost.";
        return fault("median", Some(worth), advice);
    }
    fault(
        "not-cheapest",
        Some(worth),
        "Another plane costs less. Do you compare each cost with the least so far, and keep that one?",
    )
}

const NO_SUCH_PLACE: &str =
    "The planes in question are at the begins and ends of spans. Is this one chosen among middles, or a mean?";

/// Name and advice for wrong numbers.
fn count_mistake(spans: &[Span], plane: &Plane) -> (&'static str, &'static str) {
    let Plane { position, lower, upper, .. } = *plane;
    let (right_lower, right_upper) = counts(spans, position);
    let count = |is: &dyn Fn(&Span) -> bool| spans.iter().filter(|span| is(span)).count();
    if lower == count(&|span| span.begin < position) && upper == right_upper {
        (
            "flat-lost",
            "A span whose begin and end both lie in the plane counts for the lower half, or it would be lost.",
        )
    } else if lower + upper == spans.len() && right_lower + right_upper > spans.len() {
        ("one-side-only", "A span that reaches over the plane counts for both halves.")
    } else if lower == count(&|span| span.begin <= position) || upper == count(&|span| span.end >= position) {
        (
            "touching",
            "A span that only touches the plane, with its end from below or with its begin from above, lies on one side of it. Where several \
             begins and ends fall together, count all the ends before the cost is computed, and the begins after it.",
        )
    } else {
        ("wrong-counts", "These are not the numbers of spans below and above. Count by hand for a short list of spans.")
    }
}

/// A cell, and so many spans in it along axis 1.
fn crowd(count: u32) -> (Aabb, Vec<Span>) {
    let spans = (0..count).map(|i| {
        // From place to place by the golden ratio; denser toward the lower end.
        let share = (f64::from(i) * 0.618_033_988_749_895).fract();
        #[expect(clippy::cast_possible_truncation, reason = "any place will do")]
        let begin = (9.0 * share * share) as f32;
        Span { begin, end: begin + 0.01 }
    });
    (Aabb { min: Vec3::ZERO, max: Vec3::new(1.0, 10.0, 1.0) }, spans.collect())
}

/// How long something takes: the least of so many times, so that it does not count what else the machine does.
fn time<T>(times: usize, act: impl Fn() -> T) -> Duration {
    let once = |_| {
        let begin = Instant::now();
        black_box(act());
        begin.elapsed()
    };
    (0..times).map(once).min().unwrap_or_default()
}

/// Whether it is fast enough for very many spans, by its time for not so many.
///
/// It is compared with sorting them, on the same machine at the same time. With so many spans a right answer takes a few
/// times as long, one that loops over all of them for every plane five hundred times or more.
fn pace(cheapest: Cheapest<'_>) -> Verdict {
    const MOST: f64 = 100.0;
    let (cell, spans) = crowd(10_000);
    let sorted = || {
        let mut places: Vec<f32> = spans.iter().flat_map(|span| [span.begin, span.end]).collect();
        places.sort_by(f32::total_cmp);
        places
    };
    let sorting = time(5, sorted).as_secs_f64();
    let mut ratio = f64::INFINITY;
    // One slow time may be chance.
    for _ in 0..3 {
        ratio = ratio.min(time(1, || chosen(cheapest, &cell, 1, &spans)).as_secs_f64() / sorting);
        if ratio <= MOST {
            return Ok(());
        }
    }
    let advice = "Is there a loop over all spans inside of another one? For twice as many spans it takes four times as long. Sort the begins \
                  and the ends once, before the loop over the planes; then no plane needs a loop of its own. (Or is there a print left \
                  over? Thousands of lines take long.)";
    Err(Finding {
        tried: tried(&cell, 1, &spans),
        got: format!("an answer that takes {ratio:.0} times as long as to sort all begins and ends"),
        expected: format!("a few times as long, and at most {MOST} times"),
        advice: advice.into(),
    }
    .named("too-slow"))
}

/// As many spans as in a real scene.
fn many(cheapest: Cheapest<'_>) -> Verdict {
    let (cell, spans) = crowd(400_000);
    let told =
        || format!("{}; so many that a loop over all of them for every plane takes minutes", tried(&cell, 1, &spans));
    let got = trying(told, || cheapest(&cell, 1, &spans));
    let Some(plane) = got else {
        let expected = "a plane".into();
        let advice = "Among so many spans there are planes that cost less than the whole cell.".into();
        return Err(
            Finding { tried: tried(&cell, 1, &spans), got: "None".into(), expected, advice }.named("none-found")
        );
    };
    let (lower, upper) = counts(&spans, plane.position);
    if (plane.lower, plane.upper) != (lower, upper) {
        let (name, advice) = count_mistake(&spans, &plane);
        let expected = format!("{lower} below, {upper} above");
        return Err(Finding {
            tried: tried(&cell, 1, &spans),
            got: plane_words(&plane),
            expected,
            advice: advice.into(),
        }
        .named(name));
    }
    Ok(())
}

/// The axis and place of the cheapest plane of all three axes.
pub(crate) fn of_three_axes(cheapest: Cheapest<'_>, cell: &Aabb, boxes: &[Aabb]) -> Option<(usize, f32)> {
    let size = cell.max - cell.min;
    let flat = (0..3).filter(|&axis| size[axis] <= 0.0).count();
    let axes = (0..3).filter(|&axis| size[axis] > 0.0 && flat < 2);
    let planes = axes.filter_map(|axis| {
        let clamped = |x: f32| x.clamp(cell.min[axis], cell.max[axis]);
        let span = |aabb: &Aabb| Span { begin: clamped(aabb.min[axis]), end: clamped(aabb.max[axis]) };
        let spans: Vec<_> = boxes.iter().map(span).collect();
        chosen(cheapest, cell, axis, &spans).map(|plane| (axis, plane))
    });
    planes.min_by(|(_, a), (_, b)| a.cost.total_cmp(&b.cost)).map(|(axis, plane)| (axis, plane.position))
}

/// A whole tree by these planes takes less than two thirds of the steps of one by the median.
fn tree(cheapest: Cheapest<'_>) -> Verdict {
    let triangles = stadium();
    let by_median = plane_tree(triangles.clone(), &median);
    let by_cost = plane_tree(triangles, &|cell, boxes| of_three_axes(cheapest, cell, boxes));
    let [by_median, by_cost] = [steps(&by_median), steps(&by_cost)];
    if by_cost * 3 < by_median * 2 {
        return Ok(());
    }
    let advice = "Each of your planes seemed right, but a tree of them is not good. Does `cheapest` keep something from one call to the \
                  next?";
    Err(Finding {
        tried: "1000 rays in two kd-trees over a teapot in a stadium".into(),
        got: format!("{by_cost} steps with your planes"),
        expected: format!("less than two thirds of the {by_median} steps with planes through the median"),
        advice: advice.into(),
    }
    .named("poor-tree"))
}

/// The steps of many rays.
fn steps<P: Primitives, T: Partition<P>>(structure: &Structure<P, T>) -> u64 {
    let mut dice = Dice::new(433);
    let mut counts = Counts::default();
    for _ in 0..1000 {
        structure.nearest(&in_stadium(&mut dice), Interval::POSITIVE, &mut counts);
    }
    counts.steps()
}
