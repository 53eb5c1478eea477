//! What was measured, as tables.

use std::fmt;

/// All that was measured.
pub(crate) struct Results {
    /// Number of triangles.
    pub(crate) triangles: usize,
    /// Number of rays.
    pub(crate) rays: usize,
    /// Each rival, the kd-tree first.
    pub(crate) measured: Vec<Measured>,
    /// Shadow rays that the kd-tree answers in a second, in each round.
    pub(crate) occluded: Vec<f64>,
}

/// What was measured of one rival.
#[derive(Default)]
pub(crate) struct Measured {
    name: &'static str,
    /// Seconds of each round.
    pub(crate) build: Vec<f64>,
    /// Seconds of each round.
    pub(crate) trace: Vec<f64>,
    /// Memory, if that is known.
    pub(crate) bytes: Option<usize>,
    /// Rays that hit something.
    hits: usize,
    /// Whether that are as many as the kd-tree's.
    agrees: bool,
    /// Rays that hit at another `t` than the kd-tree's.
    exceptions: usize,
}

impl Measured {
    pub(crate) fn new(name: &'static str) -> Self {
        Self { name, ..Self::default() }
    }

    /// Compare the `t` of all rays with what is expected.
    pub(crate) fn compare(&mut self, answers: &[f32], expected: &[f32]) {
        let hits = |answers: &[f32]| answers.iter().filter(|t| t.is_finite()).count();
        self.hits = hits(answers);
        self.agrees = answers.len() == expected.len()
            && self.hits.abs_diff(hits(expected)) as f64 <= 1e-4 * expected.len() as f64;
        // Where one of both is infinite, so is the difference.
        let differ = |(a, b): &(&f32, &f32)| a != b && (*a - *b).abs() > 1e-3 * a.abs().min(b.abs());
        self.exceptions = answers.iter().zip(expected).filter(differ).count();
    }
}

/// The ratios of two times that were measured side by side, sorted.
fn ratios(above: &[f64], below: &[f64]) -> Vec<f64> {
    let mut ratios: Vec<_> = above.iter().zip(below).map(|(above, below)| above / below).collect();
    ratios.sort_unstable_by(f64::total_cmp);
    ratios
}

/// The middle one of some numbers.
fn median(numbers: &[f64]) -> f64 {
    let mut numbers = numbers.to_vec();
    numbers.sort_unstable_by(f64::total_cmp);
    numbers.get(numbers.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Median, least and greatest of sorted numbers.
fn spread(sorted: &[f64]) -> String {
    let shown = |x: f64| if x < 1.0 { format!("{x:.3}") } else { format!("{x:.2}") };
    match sorted {
        [] => "-".into(),
        [only] => shown(*only),
        [least, .., most] => format!("{} ({}-{})", shown(median(sorted)), shown(*least), shown(*most)),
    }
}

impl fmt::Display for Results {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(kd_tree) = self.measured.first() else { return Ok(()) };
        writeln!(f, "\n{:12}{:>9}{:>24}{:>12}", "Building", "s", "speed / kd-tree's", "B/triangle")?;
        for rival in &self.measured {
            let ratios = spread(&ratios(&kd_tree.build, &rival.build));
            let bytes = rival.bytes.map_or("-".into(), |bytes| format!("{:.0}", bytes as f64 / self.triangles as f64));
            writeln!(f, "{:12}{:>9.3}{ratios:>24}{bytes:>12}", rival.name, median(&rival.build))?;
        }
        let heads = ["Mrays/s", "speed / kd-tree's", "hits", "other t"];
        writeln!(f, "\n{:12}{:>9}{:>24}{:>12}{:>12}", "Tracing", heads[0], heads[1], heads[2], heads[3])?;
        for rival in &self.measured {
            let ratios = spread(&ratios(&kd_tree.trace, &rival.trace));
            let speed = self.rays as f64 / 1e6 / median(&rival.trace);
            let wrong = if rival.agrees { "" } else { "  DISAGREES" };
            let Measured { name, hits, exceptions, .. } = rival;
            writeln!(f, "{name:12}{speed:>9.3}{ratios:>24}{hits:>12}{exceptions:>12}{wrong}")?;
        }
        writeln!(f, "{:12}{:>9.3}  (shadow rays, kd-tree)", "Occlusion", median(&self.occluded) / 1e6)?;
        self.bounds(f)
    }
}

impl Results {
    /// What was asked of the kd-tree, and what it reached.
    fn bounds(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "\n{:48}{:>8}{:>24}", "Bound, as ratios in the same round", "asked", "reached")?;
        let [kd_tree, grid, octree, obvhs, bvh, pruned, embree] =
            ["kd-tree", "grid", "octree", "obvhs", "bvh", "bvh, pruned", "Embree"]
                .map(|name| self.measured.iter().find(|m| m.name == name));
        type Times = fn(&Measured) -> &Vec<f64>;
        let (build, trace): (Times, Times) = (|m| &m.build, |m| &m.trace);
        for (what, times, above, below, at_least, asked) in [
            ("building: kd-tree's time / obvhs's", build, kd_tree, obvhs, false, 5.0),
            ("building: kd-tree's time / grid's", build, kd_tree, grid, true, 3.0),
            ("building: kd-tree's time / octree's", build, kd_tree, octree, true, 3.0),
            ("tracing: kd-tree's speed / Embree's (aim 0.45)", trace, embree, kd_tree, true, 0.3),
            ("tracing: kd-tree's speed / bvh's", trace, bvh, kd_tree, true, 2.0),
            ("tracing: kd-tree's speed / bvh's, pruned", trace, pruned, kd_tree, true, 2.0),
        ] {
            let sign = if at_least { ">=" } else { "<=" };
            let Some((above, below)) = above.zip(below) else {
                writeln!(f, "{what:48}{:>8}{:>24}", format!("{sign} {asked}"), "not installed")?;
                continue;
            };
            let ratios = ratios(times(above), times(below));
            let reached = median(&ratios);
            let missed = if (reached >= asked) == at_least { "" } else { "  missed" };
            writeln!(f, "{what:48}{:>8}{:>24}{missed}", format!("{sign} {asked}"), spread(&ratios))?;
        }
        Ok(())
    }
}
