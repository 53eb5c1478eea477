//! What is true of every picture of every chapter: its story ends in its color, and no knob breaks it.

use common::{
    Rgb,
    film::{Film, Pixel, Size},
    knob::Kind,
    picture::{Picture, Settings},
    renderer::{self, Plan},
};
use course::CHAPTERS;

fn pictures() -> impl Iterator<Item = &'static Picture> {
    CHAPTERS.iter().flat_map(|chapter| chapter.pictures)
}

fn render(picture: &Picture, settings: &Settings, size: Size, samples: u32) -> Film {
    let render = (picture.make)(settings).unwrap_or_else(|error| panic!("{}: {error}", picture.name));
    let mut film = Film::new(size);
    renderer::render(&*render, &mut film, &Plan { samples, seed: 0, threads: 1 }, &());
    film
}

/// No sample is NaN, infinite or negative.
fn assert_sound(film: &Film, what: &str) {
    assert_eq!(film.bad_samples(), 0, "{what}");
    assert!(film.linear().into_iter().all(|color| color.min_element() >= 0.0), "{what} is darker than black");
}

#[test]
fn every_story_ends_in_the_color_of_its_pixel() {
    for picture in pictures() {
        let render = (picture.make)(&Settings::default()).unwrap();
        let size = picture.size.scaled_to(48);
        // One sample lies in the pixel's center, several anywhere.
        for samples in [1, 3] {
            let film = self::render(picture, &Settings::default(), size, samples);
            let plan = Plan { samples, seed: 0, threads: 1 };
            let (right, bottom) = (size.width() - 1, size.height() - 1);
            for (x, y) in
                [(0, 0), (right, bottom), (right / 2, bottom / 2), (right / 4, bottom / 3), (right / 2, bottom / 4)]
            {
                let mut told = Pixel::default();
                for sample in 0..samples {
                    let (color, story) = renderer::explain(&*render, (x, y), size, &plan, sample);
                    told.add(color);
                    let text = story.to_string();
                    assert!(text.len() > 10 && text.ends_with('\n'), "{} at {x}, {y} says '{text}'", picture.name);
                }
                let bits = |color: Rgb| color.to_array().map(f32::to_bits);
                let shown = film.pixel(x, y).unwrap().mean();
                assert_eq!(bits(told.mean()), bits(shown), "{} at {x}, {y}", picture.name);
            }
        }
    }
}

#[test]
fn every_picture_is_sound_and_shows_something() {
    for picture in pictures() {
        let film = render(picture, &Settings::default(), picture.size.scaled_to(64), 2);
        assert_sound(&film, picture.name);
        let linear = film.linear();
        let brightness = linear.iter().map(|color| color.max_element());
        let (least, most) = (brightness.clone().fold(f32::INFINITY, f32::min), brightness.fold(0.0, f32::max));
        assert!(most > 0.1 && most - least > 0.1, "{} has brightness {least} to {most}", picture.name);
    }
}

/// All values at the ends of a knob's range, and all its words.
fn extremes(kind: Kind) -> Vec<f32> {
    match kind {
        Kind::Number { min, max, .. } => vec![min, max],
        Kind::Choice { options, .. } => (0..options.len()).map(|i| i as f32).collect(),
        Kind::Switch { .. } => vec![0.0, 1.0],
    }
}

#[test]
fn no_knob_breaks_a_picture() {
    for picture in pictures() {
        for knob in picture.knobs {
            for value in extremes(knob.kind) {
                let mut settings = Settings::default();
                // Millions of triangles would take minutes: few of them show as well whether a knob breaks anything.
                if let Some(triangles) = picture.knobs.iter().find(|knob| knob.name == "triangles") {
                    settings.values.set(triangles, 1000.0);
                }
                settings.values.set(knob, if knob.name == "triangles" { value.min(2000.0) } else { value });
                let film = render(picture, &settings, Size::of::<24, 16>(), 1);
                assert_sound(&film, &format!("{} with {}={}", picture.name, knob.name, knob.show(value)));
            }
        }
    }
}
