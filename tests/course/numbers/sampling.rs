//! The numbers of chapter 5.

use std::f64::consts::FRAC_PI_4;

use common::{Basis, Stream, Vec3, picture::Settings};
use sampling::{
    experiments::{
        constant_sky,
        dimension::{Convergence, Effort},
        mean_cosine::{self, Scheme},
        outside_three_sigma::{NORMAL_SHARE, Outside},
    },
    integrals::{Integral, MAX_DIMENSION, MEAN, PRODUCT, Placement, STEP},
    pictures::{
        tangent_frame::naive,
        uniform_against_cosine::{seen, variance},
    },
    sky_light::Choice,
    uniform_sphere::sample_uniform_sphere,
    unit_square::sample_unit_square,
};

use super::{Numbers, figures, grouped, signed};

/// A quarter of the unit circle: a curve whose area is known.
const QUARTER: Integral = Integral {
    name: "quarter of a circle",
    function: |x| (1.0 - x[0] * x[0]).sqrt(),
    value: |_| FRAC_PI_4,
    variance: |_| 2.0 / 3.0 - FRAC_PI_4 * FRAC_PI_4,
};

/// A share in per cent with two decimals.
fn percent(share: f64) -> String {
    format!("{:.2} %", 100.0 * share)
}

pub(super) fn measured() -> String {
    let mut numbers = Numbers::titled("Numbers in the text of chapter 5, made by tests/course/numbers/sampling.rs.");
    integration(&mut numbers);
    dimensions(&mut numbers);
    three_sigma(&mut numbers);
    directions(&mut numbers);
    frames(&mut numbers);
    comparison(&mut numbers);
    numbers.0
}

fn integration(numbers: &mut Numbers) {
    numbers.about(
        "The error of π/4, the integral of √(1 − x²) from 0 to 1, with M regular samples: what 1/(2M) says, and\n\
         # what it is at the left ends and in the middles of the cells.",
    );
    for count in [10, 100, 1000] {
        let error = |placement| figures((QUARTER.regular(1, count, placement) - FRAC_PI_4).abs());
        numbers.pin(&format!("quarter-law-{count}"), figures(0.5 / f64::from(count)));
        numbers.pin(&format!("quarter-left-{count}"), error(Placement::LeftEnds));
        numbers.pin(&format!("quarter-middle-{count}"), error(Placement::Midpoints));
    }
}

fn dimensions(numbers: &mut Numbers) {
    const EFFORT: Effort = Effort { samples: 65_536, runs: 32, seed: 0 };
    numbers.about(
        "The integral 'product' in D dimensions with at most 65,536 samples: slopes on a log-log plot, of regular\n\
         # samples and of random ones over 32 runs; last errors; and the slope of the law. Then the slope of\n\
         # 'mean', of which the law is exact.",
    );
    for dimension in 1..=MAX_DIMENSION {
        let convergence = Convergence::measure(&PRODUCT, dimension, EFFORT);
        let [regular, random] = convergence.slopes().map(|slope| signed(slope.unwrap()));
        numbers.pin(&format!("slope-regular-{dimension}"), regular);
        numbers.pin(&format!("slope-random-{dimension}"), random);
        numbers.pin(&format!("slope-law-{dimension}"), signed(-1.0 / dimension as f64));
        numbers.pin(&format!("error-regular-{dimension}"), figures(convergence.regular.last().unwrap()[1]));
        numbers.pin(&format!("error-random-{dimension}"), figures(convergence.random.last().unwrap()[1]));
        let few = Effort { runs: 1, ..EFFORT };
        let exact = Convergence::measure(&MEAN, dimension, few).slopes()[0].unwrap();
        numbers.pin(&format!("slope-mean-{dimension}"), signed(exact));
    }
}

fn three_sigma(numbers: &mut Numbers) {
    const RUNS: usize = 50_000;
    numbers.about(
        "Of 50,000 runs in one dimension, the share that is off by more than 3σ: by the known σ, and by the\n\
         # estimated one.",
    );
    numbers.pin("outside-normal", percent(NORMAL_SHARE));
    numbers.pin("outside-runs", grouped(RUNS as u32));
    numbers.pin("outside-chance", percent(3.0 * (NORMAL_SHARE / RUNS as f64).sqrt()));
    for integral in [PRODUCT, STEP] {
        for count in [4, 10, 100, 1000] {
            let [known, estimated] = Outside::measure(&integral, 1, count, RUNS, 0).shares().map(percent);
            numbers.pin(&format!("outside-{}-{count}-known", integral.name), known);
            numbers.pin(&format!("outside-{}-{count}-estimated", integral.name), estimated);
        }
    }
}

fn directions(numbers: &mut Numbers) {
    const SAMPLES: u64 = 1_000_000;
    numbers.about("The mean of cosθ over a million directions, three standard deviations of it, and its closed form.");
    let schemes = mean_cosine::measure(SAMPLES, 0);
    for measured in &schemes {
        let name = measured.scheme.name().replace(" + ", "-plus-").replace(' ', "-");
        numbers.pin(&format!("cosine-{name}"), format!("{:.4}", measured.cosine.mean()));
        numbers.pin(&format!("cosine-{name}-known"), format!("{:.4}", measured.scheme.mean_cosine()));
    }
    let uncertain = schemes[Scheme::Uniform as usize].cosine.three_sigma();
    numbers.pin("cosine-three-sigma", format!("{uncertain:.4}"));
    numbers.about(
        "How much denser directions are toward a corner of the cube than toward the middle of a face; mean number\n\
         # of trials until a point of the cube lies in the ball, and of the square in the disc.",
    );
    numbers.pin("corner-crowding", format!("{:.1}", 27.0_f64.sqrt()));
    numbers.pin("trials-ball", format!("{:.2}", 1.5 / FRAC_PI_4));
    numbers.pin("trials-disc", format!("{:.2}", 1.0 / FRAC_PI_4));
    numbers.about(
        "A white surface under a sky of radiance 1, a million directions: the mean, and the variance of a sample.",
    );
    for measured in constant_sky::measure(SAMPLES, 0) {
        let name = measured.way.name();
        numbers.pin(&format!("sky-{name}-mean"), format!("{:.3}", measured.estimate.mean()));
        let variance = measured.estimate.variance();
        numbers
            .pin(&format!("sky-{name}-variance"), if variance < 1e-9 { "0".into() } else { format!("{variance:.3}") });
    }
}

fn frames(numbers: &mut Numbers) {
    const NORMALS: u32 = 100_000;
    numbers.about(
        "Tangents of 100,000 random normals and of the six axes: how many are not numbers by N × (1, 0, 0), of\n\
         # the random ones and of the axes; and how far the sound basis is off from right angles and unit lengths\n\
         # at most.",
    );
    let mut random = Stream::new(0, 0, 0);
    let mut normals: Vec<Vec3> = (0..NORMALS).map(|_| sample_uniform_sphere(sample_unit_square(&mut random))).collect();
    let is_lost = |normal: &&Vec3| naive(**normal).is_nan();
    numbers.pin("frame-normals", grouped(NORMALS));
    numbers.pin("frame-lost-random", normals.iter().filter(is_lost).count());
    let axes = [Vec3::X, Vec3::Y, Vec3::Z].into_iter().flat_map(|axis| [axis, -axis]);
    numbers.pin("frame-lost-axes", axes.clone().filter(|axis| is_lost(&axis)).count());
    normals.extend(axes);
    let off = |normal: &Vec3| {
        let basis = Basis::around(*normal);
        let [t, b, n] = [basis.tangent, basis.bitangent, basis.normal].map(|v| v.as_dvec3());
        [t.dot(b), b.dot(n), n.dot(t), t.length() - 1.0, b.length() - 1.0].map(f64::abs).into_iter().fold(0.0, f64::max)
    };
    let worst = normals.iter().map(off).fold(0.0, f64::max);
    numbers.pin("frame-off", format!("{:.1} · 10⁻⁷", worst * 1e7));
}

fn comparison(numbers: &mut Numbers) {
    numbers.about(
        "The variance of a pixel in the picture 'uniform-against-cosine', by samples per pixel; and how many\n\
         # times smaller it is with cosine-distributed and mirror directions.",
    );
    let [uniform, cosine] =
        [Choice::Uniform, Choice::CosineAndMirror].map(|choice| seen(choice, &Settings::default()).unwrap());
    for samples in [1, 10, 100] {
        let [uniform, cosine] = [&uniform, &cosine].map(|lit| variance(lit, samples));
        numbers.pin(&format!("uniform-{samples}"), figures(uniform));
        numbers.pin(&format!("cosine-{samples}"), figures(cosine));
        numbers.pin(&format!("times-{samples}"), format!("{:.1}", uniform / cosine));
    }
}
