//! The business card, number for number.
//!
//! `minray.ppm` is the output of Heckbert's program as published in Graphics Gems IV, compiled from C and not by this
//! course; the header that makes it a PPM file was added.

#![allow(clippy::unwrap_used, reason = "in a test, helpers may fail too")]

use std::process::Command;

use common::{
    color::to_byte,
    film::{Film, Size},
    picture::Settings,
    renderer::{Plan, render},
};

const PUBLISHED: &str = include_str!("minray.ppm");

fn numbers(ppm: &str) -> Vec<u32> {
    ppm.split_whitespace().skip(4).map(|n| n.parse().unwrap()).collect()
}

#[test]
fn the_program_prints_what_was_published() {
    let output = Command::new(env!("CARGO_BIN_EXE_minray")).output().unwrap();
    assert!(output.status.success());
    let printed = String::from_utf8(output.stdout).unwrap();
    assert_eq!(numbers(PUBLISHED).len(), 3 * 32 * 32);
    assert_eq!(printed.lines().collect::<Vec<_>>(), PUBLISHED.lines().collect::<Vec<_>>());
    // There is something to be seen.
    assert!(numbers(PUBLISHED).iter().any(|&n| n > 200));
}

#[test]
fn the_program_takes_no_arguments() {
    let output = Command::new(env!("CARGO_BIN_EXE_minray")).arg("--size").output().unwrap();
    assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0));
    assert!(String::from_utf8(output.stderr).unwrap().contains("takes no arguments"));
}

/// The picture of 32 × 32 pixels with one sample each is the card, in both views.
#[test]
fn the_picture_is_the_card() {
    let picture = whitted::CHAPTER.picture("minray").unwrap();
    let view = picture.knobs.iter().find(|knob| knob.name == "view").unwrap();
    for name in ["card", "sharp"] {
        let mut settings = Settings::default();
        settings.values.set(view, view.parse(name).unwrap());
        let mut film = Film::new(Size::of::<32, 32>());
        let plan = Plan { samples: 1, seed: 0, threads: 1 };
        render((picture.make)(&settings).unwrap().as_ref(), &mut film, &plan, &());
        let bytes =
            film.linear().iter().flat_map(|color| color.to_array().map(to_byte)).map(u32::from).collect::<Vec<_>>();
        let published = numbers(PUBLISHED).into_iter().map(|n| n.min(255)).collect::<Vec<_>>();
        assert_eq!(bytes, published, "{name}");
    }
}
