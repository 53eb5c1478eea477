//! Fingerprints of pictures: equal on every machine, in every build, and in the browser.

use common::{
    error::Error,
    film::Film,
    picture::{Picture, Settings},
    renderer::{Plan, render},
};

/// Number of pixels along the longer side of the picture whose bits are compared.
const SIDE: u32 = 64;
/// Samples per pixel, at least two, so that chance takes part.
const SAMPLES: u32 = 2;

/// A fingerprint of all bits of a small rendering: FNV-1a over the linear floats.
///
/// # Errors
/// As for [`Picture::make`].
pub fn fingerprint(picture: &Picture, threads: usize) -> Result<u64, Error> {
    const OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
    const PRIME: u64 = 0x0100_0000_01b3;
    let mut film = Film::new(picture.size.scaled_to(SIDE));
    let plan = Plan { samples: SAMPLES, seed: 1, threads };
    render((picture.make)(&Settings::default())?.as_ref(), &mut film, &plan, &());
    let bytes = film.linear().into_iter().flat_map(|c| c.to_array()).flat_map(|f| f.to_bits().to_le_bytes());
    Ok(bytes.fold(OFFSET, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(PRIME)))
}

/// One line for each picture of the course: chapter, picture, fingerprint.
#[must_use]
pub fn table(threads: usize) -> String {
    let line = |chapter: &str, picture: &Picture| match fingerprint(picture, threads) {
        Ok(bits) => format!("{chapter} {} {bits:016x}\n", picture.name),
        Err(error) => format!("{chapter} {} {error}\n", picture.name),
    };
    crate::CHAPTERS.iter().flat_map(|c| c.pictures.iter().map(move |p| line(c.name, p))).collect()
}
