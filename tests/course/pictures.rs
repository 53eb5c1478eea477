//! Every picture of every chapter is pinned: `tests/snapshots/CHAPTER/PICTURE.snap.png`, which is also the book's figure.
//!
//! After a change that is meant, `INSTA_UPDATE=always cargo test -p tests pictures` pins them anew. Then look at them.

use std::{
    collections::BTreeSet,
    fs,
    panic::{AssertUnwindSafe, catch_unwind},
    path::{Path, PathBuf},
};

use common::{
    film::Film,
    output::{Format, encode},
    picture::{Picture, Settings},
    renderer::{Plan, fill_tile, render},
};
use image::RgbImage;
use insta::{Comparator, Snapshot, internals::SnapshotContents};

/// Length of the longer side of a pinned picture, in pixels.
const SIDE: u32 = 640;

fn snapshots() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("snapshots")
}

/// A picture as it is pinned: its own shape, small, as PNG; with its own samples, or more if it is a poster.
fn rendered(chapter: &str, picture: &Picture) -> Vec<u8> {
    let mut film = Film::new(picture.size.scaled_to(SIDE));
    let samples = course::poster_samples(chapter, picture).unwrap_or(picture.samples);
    let plan = Plan { samples, seed: 0, threads: 0 };
    render((picture.make)(&Settings::default()).unwrap().as_ref(), &mut film, &plan, &());
    assert_eq!(film.bad_samples(), 0, "{}: samples that are not numbers", picture.name);
    encode(&film, Format::Png, 0.0).unwrap()
}

/// Compares decoded pixels; on a difference writes expected, actual and difference side by side.
#[derive(Clone)]
struct Pixels {
    name: String,
}

impl Comparator for Pixels {
    fn matches(&self, reference: &Snapshot, test: &Snapshot) -> bool {
        let decoded = |snapshot: &Snapshot| match snapshot.contents() {
            SnapshotContents::Binary(Some(png)) => image::load_from_memory(png).ok().map(|i| i.into_rgb8()),
            _ => None,
        };
        let (Some(expected), Some(actual)) = (decoded(reference), decoded(test)) else { return false };
        if expected == actual {
            return true;
        }
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pictures").join(format!("{}.png", self.name));
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        side_by_side(&expected, &actual).save(&path).unwrap();
        eprintln!("{}: expected | actual | difference ×8 in {}", self.name, path.display());
        false
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}

/// Expected, actual and their difference, eight times as strong, from left to right.
fn side_by_side(expected: &RgbImage, actual: &RgbImage) -> RgbImage {
    let (width, height) = (expected.width().max(actual.width()), expected.height().max(actual.height()));
    RgbImage::from_fn(3 * width, height, |x, y| {
        let at = |image: &RgbImage| image.get_pixel_checked(x % width, y).map_or([0; 3], |p| p.0);
        image::Rgb(match x / width {
            0 => at(expected),
            1 => at(actual),
            _ => std::array::from_fn(|i| at(expected)[i].abs_diff(at(actual)[i]).saturating_mul(8)),
        })
    })
}

fn matches_snapshot(chapter: &str, picture: &Picture) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(snapshots().join(chapter));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_comparator(Box::new(Pixels { name: format!("{chapter}-{}", picture.name) }));
    settings.bind(|| insta::assert_binary_snapshot!(&format!("{}.png", picture.name), rendered(chapter, picture)));
}

/// Whether a poster is pinned, and some of its tiles, rendered again with all their samples, have the same pixels. All of
/// it would take a quarter of an hour, and no pixel depends on another.
fn poster_matches(chapter: &str, picture: &Picture, samples: u32) -> bool {
    /// One tile in so many is looked at: a prime number, so that they lie all over the picture.
    const EACH: usize = 97;
    let pinned = snapshots().join(chapter).join(format!("{}.snap.png", picture.name));
    let Ok(pinned) = image::open(pinned).map(image::DynamicImage::into_rgb8) else { return false };
    let scene = (picture.make)(&Settings::default()).unwrap();
    let mut film = Film::new(picture.size.scaled_to(SIDE));
    let (size, plan) = (film.size(), Plan { samples, seed: 0, threads: 0 });
    for tile in film.tiles_mut().iter_mut().step_by(EACH) {
        fill_tile(scene.as_ref(), tile, size, &plan, samples);
    }
    let again = image::load_from_memory(&encode(&film, Format::Png, 0.0).unwrap()).unwrap().into_rgb8();
    let is_rendered = |x: u32, y: u32| film.pixel(x, y).is_some_and(|pixel| pixel.count() == samples);
    again.dimensions() == pinned.dimensions()
        && again.enumerate_pixels().all(|(x, y, pixel)| !is_rendered(x, y) || pixel == pinned.get_pixel(x, y))
}

#[test]
fn pictures_are_unchanged() {
    // Look at all of them, also after the first that differs.
    let differ = |chapter: &str, picture: &Picture| {
        if course::poster_samples(chapter, picture).is_some_and(|samples| poster_matches(chapter, picture, samples)) {
            return false;
        }
        catch_unwind(AssertUnwindSafe(|| matches_snapshot(chapter, picture))).is_err()
    };
    let changed: Vec<_> = course::CHAPTERS
        .iter()
        .flat_map(|c| c.pictures.iter().map(move |p| (c.name, p)))
        .filter(|(chapter, picture)| differ(chapter, picture))
        .map(|(chapter, picture)| format!("{chapter}/{}", picture.name))
        .collect();
    assert!(changed.is_empty(), "changed: {}; the lines above name the files to look at", changed.join(", "));
}

#[test]
fn a_difference_of_one_step_in_one_pixel_is_seen() {
    let plain = RgbImage::from_pixel(3, 2, image::Rgb([10, 20, 30]));
    let mut other = plain.clone();
    other.put_pixel(2, 1, image::Rgb([10, 21, 30]));
    let picture = side_by_side(&plain, &other);
    assert_eq!(picture.dimensions(), (9, 2));
    assert_eq!(picture.get_pixel(8, 1).0, [0, 8, 0]);
    assert_eq!(picture.get_pixel(7, 1).0, [0, 0, 0]);
    assert_eq!((picture.get_pixel(2, 1).0, picture.get_pixel(5, 1).0), ([10, 20, 30], [10, 21, 30]));
}

/// A snapshot that is missing fails [`pictures_are_unchanged`]; here it is about those that nobody needs any more.
#[test]
fn no_snapshot_is_left_over() {
    let expected: BTreeSet<_> = course::CHAPTERS
        .iter()
        .flat_map(|chapter| chapter.pictures.iter().map(|picture| (chapter.name, picture.name)))
        .flat_map(|(chapter, picture)| ["snap", "snap.png"].map(|end| format!("{chapter}/{picture}.{end}")))
        .map(|file| snapshots().join(file))
        .collect();
    let folders = fs::read_dir(snapshots()).unwrap().map(|f| f.unwrap().path());
    let found = folders.flat_map(|f| fs::read_dir(f).unwrap().map(|f| f.unwrap().path()));
    let pinned = found.filter(|path| !path.to_string_lossy().contains(".snap.new"));
    let left: Vec<_> = pinned.filter(|path| !expected.contains(path)).collect();
    assert!(left.is_empty(), "no picture has these snapshots: {left:?}");
}

/// Names are unique and made for a command line; what is to be seen is said in whole sentences.
#[test]
fn every_picture_introduces_itself() {
    for chapter in course::CHAPTERS {
        let mut names = BTreeSet::new();
        for Picture { name, alt, knobs, .. } in chapter.pictures {
            assert!(names.insert(name), "two pictures called {name}");
            assert!(name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-'), "{name}");
            assert!(alt.len() > 60 && alt.ends_with('.') && !alt.contains("  "), "{name}: {alt}");
            let unique: BTreeSet<_> = knobs.iter().map(|k| k.name).collect();
            assert_eq!(unique.len(), knobs.len(), "{name}: two knobs of one name");
        }
    }
}

/// The bits of every picture: the same for any number of threads, and the same as those pinned in `tests/bits.txt`,
/// which debug and release builds and WebAssembly are compared with too. `UPDATE_BITS=1` pins them anew.
#[test]
fn bits_are_the_same_everywhere() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("bits.txt");
    let one = course::bits::table(1);
    for threads in [2, 7] {
        assert_eq!(course::bits::table(threads), one, "{threads} threads");
    }
    if std::env::var_os("UPDATE_BITS").is_some() {
        fs::write(&file, &one).unwrap();
    }
    assert_eq!(one, fs::read_to_string(file).unwrap(), "bits differ from tests/bits.txt");
}
