//! An experiment: something of this chapter, measured.

use common::{
    Error,
    knob::{Knob, Step},
    report::{Attachment, Report, Task, Told},
};

use crate::{
    experiments::{Findings, constant_sky, dimension, mean_cosine, outside_three_sigma},
    integrals::{INTEGRALS, NAMES},
};

const EXPERIMENTS: [&str; 4] = ["dimension", "outside-three-sigma", "mean-cosine", "constant-sky"];
const EXPERIMENT: Knob = Knob::choice("experiment", "what is measured", &EXPERIMENTS, 0);
const INTEGRAL: Knob = Knob::choice("integral", "what dimension and outside-three-sigma integrate", &NAMES, 1);
const SAMPLES: Knob = Knob::number(
    "samples",
    "samples of each scheme, or at most of each run (not for outside-three-sigma)",
    [10_000.0, 10_000_000.0],
    1_000_000.0,
    "",
    Step::Whole,
);
const RUNS: Knob = Knob::number("runs", "over how many runs dimension averages", [4.0, 1_000.0], 16.0, "", Step::Whole);
const TRIALS: Knob = Knob::number(
    "trials",
    "how many runs outside-three-sigma counts",
    [1_000.0, 1_000_000.0],
    50_000.0,
    "",
    Step::Whole,
);

pub(super) const REPORT: Report = Report {
    name: "experiment",
    what: "Measure an error, a mean or a variance against what theory says",
    subject: Some(&EXPERIMENT),
    knobs: &[INTEGRAL, SAMPLES, RUNS, TRIALS],
    takes_mesh: false,
    gives_files: true,
    make,
};

fn make(task: &Task) -> Result<Told, Error> {
    let (values, seed) = (&task.settings.values, task.seed);
    let integral = &INTEGRALS[values.index(&INTEGRAL).min(INTEGRALS.len() - 1)];
    let samples = values.index(&SAMPLES) as u64;
    let name = EXPERIMENTS[values.index(&EXPERIMENT).min(EXPERIMENTS.len() - 1)];
    let findings = match name {
        "outside-three-sigma" => {
            let all = outside_three_sigma::measure(integral, values.index(&TRIALS), seed, task.progress);
            outside_three_sigma::findings(integral, &all)
        }
        "mean-cosine" => mean_cosine::findings(&mean_cosine::measure(samples, seed)),
        "constant-sky" => constant_sky::findings(&constant_sky::measure(samples, seed)),
        _ => {
            let effort = dimension::Effort { samples, runs: values.index(&RUNS), seed };
            dimension::findings(integral, effort, &dimension::measure(integral, effort, task.progress))
        }
    };
    let files = files(name, &findings)?;
    Ok(Told { text: findings.text, files })
}

/// The values of the chart, and the chart itself where charts can be drawn.
fn files(name: &str, findings: &Findings) -> Result<Vec<Attachment>, Error> {
    let chart = &findings.chart;
    Ok(vec![
        Attachment { name: format!("{name}.csv"), content: chart.csv() },
        #[cfg(feature = "cli")]
        Attachment { name: format!("{name}.svg"), content: crate::plot::svg(chart)? },
    ])
}

#[cfg(test)]
mod tests {
    use common::picture::Settings;

    use super::*;

    /// Every experiment at its least effort: narrow lines, and two files.
    #[test]
    fn every_experiment_is_told() {
        for name in EXPERIMENTS {
            for integral in NAMES {
                let mut settings = Settings::default();
                let set = [(EXPERIMENT, name), (INTEGRAL, integral), (SAMPLES, "10000"), (RUNS, "4"), (TRIALS, "1000")];
                for (knob, word) in &set {
                    settings.values.set(knob, knob.parse(word).unwrap());
                }
                let task = Task { settings: &settings, seed: 1, threads: 1, progress: &|_| {} };
                let told = make(&task).unwrap();
                assert!(
                    told.text.ends_with('\n') && told.text.lines().all(|l| l.chars().count() <= 100),
                    "{}",
                    told.text
                );
                assert!(!told.text.contains("NaN") && !told.text.contains("inf"), "{}", told.text);
                assert_eq!(told.files[0].name, format!("{name}.csv"));
                let columns = |line: &str| line.split(',').count();
                assert!(
                    told.files[0].content.lines().count() > 6 && told.files[0].content.lines().all(|l| columns(l) == 3)
                );
                assert_eq!(make(&task).unwrap(), told, "the same seed tells the same");
            }
        }
    }
}
