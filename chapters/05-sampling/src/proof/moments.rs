//! Means of coordinates and of their products, against closed forms.

use common::Stream;

use super::subjects::{SUBJECTS, Subject};
use crate::estimate::Estimate;

/// Samples of one test.
const COUNT: u32 = 200_000;
/// How many standard deviations a mean may be off. There are 90 means here, so 3 would be too few.
const SIGMAS: f64 = 4.5;

/// The first moment that is off, if one is.
pub(super) fn wrong_moment(subject: &Subject, seed: u64) -> Option<String> {
    let mut random = Stream::new(seed, 0, 0);
    let mut moments = [Estimate::default(); 10];
    for _ in 0..COUNT {
        let [x, y, z] = (subject.draw)(&mut random);
        let values = [x, y, z, x * x, y * y, z * z, x * y, y * z, z * x, z * z * z * z];
        moments.iter_mut().zip(values).for_each(|(moment, value)| moment.add(value));
    }
    let [xx, yy, zz] = subject.mean_squares;
    let expected = [0.0, 0.0, subject.mean_z, xx, yy, zz, 0.0, 0.0, 0.0, subject.mean_fourth];
    let names = ["x", "y", "z", "x²", "y²", "z²", "xy", "yz", "zx", "z⁴"];
    let mut all = names.into_iter().zip(moments).zip(expected);
    all.find_map(|((name, moment), expected)| {
        // Where all samples are equal, as z is in the disc, nothing but rounding is allowed.
        let allowed = moment.three_sigma() / 3.0 * SIGMAS + 1e-9;
        let off = (moment.mean() - expected).abs();
        let is_off = off.is_nan() || off > allowed;
        is_off.then(|| format!("{}: mean of {name} is {}, not {expected}", subject.name, moment.mean()))
    })
}

#[test]
fn moments_are_those_of_the_closed_forms() {
    for (i, subject) in SUBJECTS.iter().enumerate() {
        assert_eq!(wrong_moment(subject, 100 + i as u64), None);
    }
}

/// Directions have length 1, and points of the disc no more than that.
#[test]
fn samples_lie_where_they_should() {
    for subject in SUBJECTS {
        let mut random = Stream::new(3, 0, 0);
        for _ in 0..COUNT {
            let [x, y, z] = (subject.draw)(&mut random);
            let length = (x * x + y * y + z * z).sqrt();
            match subject.domain {
                super::chart::Domain::Sphere => assert!((length - 1.0).abs() < 3e-7, "{}: {length}", subject.name),
                super::chart::Domain::Disc => assert!(length < 1.0 + 2e-7, "{}: {length}", subject.name),
            }
        }
    }
}
