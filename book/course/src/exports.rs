//! What a web page can call. A module for WebAssembly has no other way to be called than by names without mangling, and
//! those count as unsafe; nothing else here is.
//!
//! A worker calls [`choose`], [`turn`] for each knob, [`start`], and then [`step`] until it answers 0; after each step
//! it reads the tile. Whatever goes wrong is in the text afterwards.
#![allow(unsafe_code, reason = "only for the attribute no_mangle")]

use std::cell::{Cell, RefCell};

use common::{
    error::Error,
    film::Size,
    picture::{Picture, Settings},
};

use crate::{
    CHAPTERS,
    live::{Live, Share, describe, develop, nearest},
};

/// The tile that the page is about to read.
struct Ready {
    left: u32,
    top: u32,
    width: u32,
    pixels: Vec<u8>,
}

thread_local! {
    /// The text that the page is about to read.
    static TEXT: RefCell<String> = const { RefCell::new(String::new()) };
    /// The picture that was chosen.
    static CHOSEN: Cell<Option<&'static Picture>> = const { Cell::new(None) };
    /// What its knobs are set to.
    static SETTINGS: RefCell<Settings> = RefCell::default();
    /// The picture in the making.
    static LIVE: RefCell<Option<Live>> = const { RefCell::new(None) };
    /// The tile of the last step.
    static READY: RefCell<Ready> = const { RefCell::new(Ready { left: 0, top: 0, width: 0, pixels: Vec::new() }) };
}

/// Replace the text; the answer is its length in bytes.
fn say(new: String) -> usize {
    // A panic must not meet another one here.
    TEXT.with(|text| {
        text.try_borrow_mut().map_or(0, |mut text| {
            *text = new;
            text.len()
        })
    })
}

/// Make the table of fingerprints and return its length in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn make_bits() -> usize {
    say(crate::bits::table(1))
}

/// Make the description of a picture and return its length in bytes; empty if there is no such picture.
#[unsafe(no_mangle)]
pub extern "C" fn make_description(chapter: usize, picture: usize) -> usize {
    say(describe(CHAPTERS, chapter, picture).unwrap_or_default())
}

/// Where the text begins in the module's memory.
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    TEXT.with_borrow(|text| text.as_ptr())
}

/// Length of the text in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn text_length() -> usize {
    TEXT.with_borrow(String::len)
}

/// Choose a picture, with all knobs as they are when nothing is said. The text is empty then; a panic fills it.
#[unsafe(no_mangle)]
pub extern "C" fn choose(chapter: usize, picture: usize) {
    std::panic::set_hook(Box::new(|info| {
        say(info.to_string());
    }));
    CHOSEN.set(CHAPTERS.get(chapter).and_then(|chapter| chapter.pictures.get(picture)));
    SETTINGS.set(Settings::default());
    LIVE.set(None);
    say(String::new());
}

/// Turn a knob of the chosen picture.
#[unsafe(no_mangle)]
pub extern "C" fn turn(knob: usize, value: f32) {
    if let Some(knob) = CHOSEN.get().and_then(|picture| picture.knobs.get(knob)) {
        SETTINGS.with_borrow_mut(|settings| settings.values.set(knob, nearest(knob, value)));
    }
}

/// Begin the chosen picture. The answer is 0, or the length of the text that says why it cannot be made.
#[unsafe(no_mangle)]
pub extern "C" fn start(width: u32, height: u32, samples: u32, worker: usize, workers: usize) -> usize {
    let share = Share { worker, workers };
    let made = CHOSEN.get().ok_or_else(|| Error::Picture("no picture is chosen".into())).and_then(|picture| {
        let size = Size::new(width.into(), height.into())?;
        SETTINGS.with_borrow(|settings| Live::new(picture, settings, size, samples, share))
    });
    match made {
        Ok(live) => {
            LIVE.set(Some(live));
            0
        }
        Err(error) => say(error.to_string()),
    }
}

/// Add samples to one tile. The answer is 0 when the picture has all its samples.
#[unsafe(no_mangle)]
pub extern "C" fn step() -> u32 {
    let ready = LIVE.with_borrow_mut(|live| {
        let tile = live.as_mut()?.step()?;
        Some(Ready { left: tile.left, top: tile.top, width: tile.width, pixels: develop(tile) })
    });
    ready.map_or(0, |ready| {
        READY.set(ready);
        1
    })
}

/// Column of the tile's left pixels.
#[unsafe(no_mangle)]
pub extern "C" fn tile_left() -> u32 {
    READY.with_borrow(|tile| tile.left)
}

/// Row of the tile's top pixels.
#[unsafe(no_mangle)]
pub extern "C" fn tile_top() -> u32 {
    READY.with_borrow(|tile| tile.top)
}

/// Width of the tile in pixels.
#[unsafe(no_mangle)]
pub extern "C" fn tile_width() -> u32 {
    READY.with_borrow(|tile| tile.width)
}

/// Where the tile's pixels begin in the module's memory: four bytes each, row by row from the top.
#[unsafe(no_mangle)]
pub extern "C" fn pixels() -> *const u8 {
    READY.with_borrow(|tile| tile.pixels.as_ptr())
}

/// Number of bytes of the tile's pixels.
#[unsafe(no_mangle)]
pub extern "C" fn pixels_length() -> usize {
    READY.with_borrow(|tile| tile.pixels.len())
}

/// Samples per pixel that all tiles of this worker have.
#[unsafe(no_mangle)]
pub extern "C" fn samples() -> u32 {
    LIVE.with_borrow(|live| live.as_ref().map_or(0, Live::samples))
}

/// How many samples were no numbers.
#[unsafe(no_mangle)]
pub extern "C" fn bad_samples() -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "far fewer than 2^53")]
    LIVE.with_borrow(|live| live.as_ref().map_or(0.0, |live| live.bad_samples() as f64))
}
