//! The state of a rendering as a file: the film to the last bit, and what it was rendered from.
//!
//! All numbers are little-endian:
//!
//! | bytes | what |
//! |---|---|
//! | 8 | `MAGIC`, which text mode and other programs would damage or not have |
//! | 4 | `VERSION` |
//! | 4, and for each 4 + n + 4 + n | the origin: how many entries; length and UTF-8 text of each name and value |
//! | 4 | samples per pixel in the end |
//! | 4 + 4 | width and height |
//! | 56 for each pixel | row by row: sums of red, green, blue, of their squares (f64), samples, bad samples (u32) |
//! | 8 | fingerprint of all bytes before |

use std::{
    fs::File,
    io::{self, Read as _, Write},
    path::Path,
};

use crate::{
    error::{Error, reason},
    film::{Film, Pixel, Size},
    fingerprint::Fingerprint,
    origin::Origin,
    output,
    renderer::Plan,
};

const MAGIC: [u8; 8] = *b"\x89film\r\n\n";
const VERSION: u32 = 1;

/// A rendering that can go on.
#[derive(Clone, Debug)]
pub struct State {
    /// What the film was rendered from.
    pub origin: Origin,
    /// Samples per pixel that the rendering was to have in the end. (A lone one lies in the center of its pixel.)
    pub goal: u32,
    /// The film as far as it is.
    pub film: Film,
}

/// Write a state in one step: all of it, or, if anything goes wrong, the file as it was before.
///
/// # Errors
/// [`Error::Write`] with the reason that the system gives.
pub fn write(path: &Path, origin: &Origin, goal: u32, film: &Film) -> Result<(), Error> {
    output::write_by(path, |file| {
        encode(&mut *file, origin, goal, film)?;
        file.flush()?;
        // The new one is on the disk before it takes the place of the old one.
        file.get_ref().sync_all()
    })
}

/// Read the state in a file.
///
/// # Errors
/// [`Error::State`] for anything but a whole file that [`write()`] made, [`Error::Read`] if it cannot be read.
pub fn read(path: &Path) -> Result<State, Error> {
    let failed = |e: &io::Error| Error::Read { name: path.display().to_string(), reason: reason(e) };
    if path.is_dir() {
        return Err(Error::Read { name: path.display().to_string(), reason: "it is a folder, not a state".into() });
    }
    let mut file = File::open(path).map_err(|e| failed(&e))?;
    let mut bytes = Vec::new();
    // Other files may be of any length, and are known from their beginning.
    (&file).take(MAGIC.len() as u64).read_to_end(&mut bytes).map_err(|e| failed(&e))?;
    if bytes == MAGIC {
        file.read_to_end(&mut bytes).map_err(|e| failed(&e))?;
    }
    decode(&bytes).map_err(|reason| Error::State { file: path.display().to_string(), reason })
}

/// Refuse a place where a state cannot be written, or where it would take the place of something else.
///
/// # Errors
/// [`Error::Write`] with the reason.
pub fn check_writable(path: &Path) -> Result<(), Error> {
    let mut start = Vec::new();
    let old = File::open(path).and_then(|file| file.take(MAGIC.len() as u64).read_to_end(&mut start));
    if old.is_ok() && !start.is_empty() && start != MAGIC {
        let reason = "there is a file that is no state of a rendering, and it stays".into();
        return Err(Error::Write { name: path.display().to_string(), reason });
    }
    output::check_place(path)
}

/// Passes bytes on and takes their fingerprint.
struct Sealed<W> {
    to: W,
    fingerprint: Fingerprint,
}

impl<W: Write> Write for Sealed<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let count = self.to.write(bytes)?;
        self.fingerprint.add(&bytes[..count]);
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.to.flush()
    }
}

fn encode(to: impl Write, origin: &Origin, goal: u32, film: &Film) -> io::Result<()> {
    let mut to = Sealed { to, fingerprint: Fingerprint::default() };
    let length = |n: usize| u32::try_from(n).unwrap_or(u32::MAX).to_le_bytes();
    to.write_all(&MAGIC)?;
    to.write_all(&VERSION.to_le_bytes())?;
    to.write_all(&length(origin.0.len()))?;
    for text in origin.0.iter().flat_map(|(name, value)| [name, value]) {
        to.write_all(&length(text.len()))?;
        to.write_all(text.as_bytes())?;
    }
    let size = film.size();
    for number in [goal, size.width(), size.height()] {
        to.write_all(&number.to_le_bytes())?;
    }
    for (x, y) in (0..size.height()).flat_map(|y| (0..size.width()).map(move |x| (x, y))) {
        let (sums, counts) = film.pixel(x, y).copied().unwrap_or_default().to_parts();
        to.write_all(sums.map(f64::to_le_bytes).as_flattened())?;
        to.write_all(counts.map(u32::to_le_bytes).as_flattened())?;
    }
    let seal = to.fingerprint.bits();
    to.write_all(&seal.to_le_bytes())
}

/// What is wrong with bytes that do not hold what they should.
fn damaged() -> String {
    "it is damaged or cut off".into()
}

fn decode(bytes: &[u8]) -> Result<State, String> {
    let mut rest = bytes;
    if bytes.len() < MAGIC.len() && !bytes.is_empty() && MAGIC.starts_with(bytes) {
        return Err(damaged());
    }
    if take(&mut rest).ok() != Some(MAGIC) {
        return Err("it is no state of a rendering; --save-state makes one".into());
    }
    let version = u32::from_le_bytes(take(&mut rest)?);
    let (content, seal) = bytes.split_last_chunk().ok_or_else(damaged)?;
    if Fingerprint::of(content).bits() != u64::from_le_bytes(*seal) {
        return Err(damaged());
    }
    if version != VERSION {
        return Err(format!("it is of version {version}, and this program reads version {VERSION}"));
    }
    let mut entries = Vec::new();
    for _ in 0..u32::from_le_bytes(take(&mut rest)?) {
        entries.push((text(&mut rest)?, text(&mut rest)?));
    }
    let [goal, width, height] = take_numbers(&mut rest)?;
    let size = Size::new(width.into(), height.into()).map_err(|_| damaged())?;
    if !(1..=Plan::MAX_SAMPLES).contains(&goal) || rest.len() != size.pixels() * PIXEL + seal.len() {
        return Err(damaged());
    }
    let mut film = Film::new(size);
    for tile in film.tiles_mut() {
        for (x, y, pixel) in tile.pixels_mut() {
            let mut at = &rest[(y as usize * width as usize + x as usize) * PIXEL..];
            *pixel = take_pixel(&mut at)?;
        }
    }
    Ok(State { origin: Origin(entries), goal, film })
}

/// How many bytes a pixel takes.
const PIXEL: usize = 6 * size_of::<f64>() + 2 * size_of::<u32>();

fn take_pixel(rest: &mut &[u8]) -> Result<Pixel, String> {
    let mut sums = [0.0; 6];
    for sum in &mut sums {
        *sum = f64::from_le_bytes(take(rest)?);
    }
    let counts = take_numbers(rest)?;
    Pixel::from_parts(sums, counts).filter(|p| p.count() <= Plan::MAX_SAMPLES).ok_or_else(damaged)
}

fn take<const N: usize>(rest: &mut &[u8]) -> Result<[u8; N], String> {
    let (first, others) = rest.split_first_chunk().ok_or_else(damaged)?;
    *rest = others;
    Ok(*first)
}

fn take_numbers<const N: usize>(rest: &mut &[u8]) -> Result<[u32; N], String> {
    let mut numbers = [0; N];
    for number in &mut numbers {
        *number = u32::from_le_bytes(take(rest)?);
    }
    Ok(numbers)
}

fn text(rest: &mut &[u8]) -> Result<String, String> {
    let length = u32::from_le_bytes(take(rest)?) as usize;
    let (text, others) = rest.split_at_checked(length).ok_or_else(damaged)?;
    *rest = others;
    Ok(std::str::from_utf8(text).map_err(|_| damaged())?.into())
}

#[cfg(test)]
mod tests;
