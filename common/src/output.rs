//! Pictures as files: PNG for screens, OpenEXR for numbers.

use std::{
    fs::{self, File},
    io::{self, BufWriter, Cursor, Write},
    path::{Path, PathBuf},
};

use image::{
    ExtendedColorType, ImageEncoder,
    codecs::{
        openexr::OpenExrEncoder,
        png::{CompressionType, FilterType, PngEncoder},
    },
};

use crate::{
    error::{Error, reason},
    film::Film,
};

/// How a picture is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// 8 bits a channel, sRGB: what a screen shows.
    Png,
    /// 32-bit floats, linear: the radiances themselves.
    Exr,
}

impl Format {
    /// The format that a file name asks for.
    ///
    /// # Errors
    /// [`Error::Extension`] unless it ends in `.png` or `.exr`.
    pub fn of(path: &Path) -> Result<Self, Error> {
        match path.extension().and_then(|e| e.to_str()).map(str::to_ascii_lowercase).as_deref() {
            Some("png") => Ok(Self::Png),
            Some("exr") => Ok(Self::Exr),
            _ => Err(Error::Extension(path.into())),
        }
    }
}

/// The picture as the bytes of a file. `exposure`, in stops, brightens a PNG; an EXR keeps the radiances as they are.
///
/// # Errors
/// [`Error::Write`] if the encoder refuses.
pub fn encode(film: &Film, format: Format, exposure: f32) -> Result<Vec<u8>, Error> {
    let (width, height) = (film.size().width(), film.size().height());
    let mut bytes = Cursor::new(Vec::new());
    match format {
        Format::Png => PngEncoder::new_with_quality(&mut bytes, CompressionType::Fast, FilterType::Paeth).write_image(
            film.develop(exposure).as_flattened(),
            width,
            height,
            ExtendedColorType::Rgb8,
        ),
        Format::Exr => {
            let floats: Vec<u8> = film.linear().iter().flat_map(|c| c.to_array()).flat_map(f32::to_ne_bytes).collect();
            OpenExrEncoder::new(&mut bytes).write_image(&floats, width, height, ExtendedColorType::Rgb32F)
        }
    }
    .map_err(|e| Error::Write { name: "the picture".into(), reason: e.to_string() })?;
    Ok(bytes.into_inner())
}

/// Refuse a place that cannot be written before any work is done for it.
///
/// # Errors
/// [`Error::Extension`] for an unknown kind of file, [`Error::Write`] for a folder or a place without permission.
pub fn check_writable(path: &Path) -> Result<Format, Error> {
    let format = Format::of(path)?;
    check_place(path)?;
    Ok(format)
}

/// Refuse a place where no file can be written, whatever its kind.
///
/// # Errors
/// [`Error::Write`] for a folder or a place without permission.
pub fn check_place(path: &Path) -> Result<(), Error> {
    if path.is_dir() {
        return Err(failed(path, "it is a folder"));
    }
    // Create the neighbor that the file will be written to, and take it away again.
    let neighbor = neighbor(path)?;
    File::create(&neighbor).and_then(|_| fs::remove_file(&neighbor)).map_err(|e| failed(path, reason(&e)))
}

/// Refuse a folder in which nothing can be written before any work is done for it. It is made if need be.
///
/// # Errors
/// [`Error::Write`] with the reason that the system gives.
pub fn check_folder(folder: &Path) -> Result<(), Error> {
    if folder.is_file() {
        return Err(failed(folder, "it is a file, not a folder"));
    }
    fs::create_dir_all(folder).map_err(|e| failed(folder, reason(&e)))?;
    let trial = neighbor(&folder.join("trial"))?;
    File::create(&trial).and_then(|_| fs::remove_file(&trial)).map_err(|e| failed(folder, reason(&e)))
}

/// Write a file in one step: all of `bytes`, or, if anything goes wrong, the file as it was before.
///
/// The bytes go to a neighbor first, which then takes the file's name.
///
/// # Errors
/// [`Error::Write`] with the reason that the system gives.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    write_by(path, |file| file.write_all(bytes))
}

/// The same for what is written piece by piece.
///
/// # Errors
/// [`Error::Write`] with the reason that the system gives.
pub fn write_by(path: &Path, put: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>) -> Result<(), Error> {
    let neighbor = neighbor(path)?;
    let written = (|| {
        let mut file = BufWriter::new(File::create(&neighbor)?);
        put(&mut file)?;
        file.flush()?;
        drop(file);
        fs::rename(&neighbor, path)
    })();
    written.map_err(|e: io::Error| {
        // Nothing more can be done if this fails too; the first error is the one to report.
        let _ = fs::remove_file(&neighbor);
        failed(path, reason(&e))
    })
}

/// Write to standard output.
///
/// # Errors
/// [`Error::ClosedPipe`] if nobody reads any more, [`Error::Write`] otherwise.
pub fn write_to_stdout(bytes: &[u8]) -> Result<(), Error> {
    let mut out = io::stdout().lock();
    out.write_all(bytes).and_then(|()| out.flush()).map_err(|e| match e.kind() {
        io::ErrorKind::BrokenPipe => Error::ClosedPipe,
        _ => Error::Write { name: "standard output".into(), reason: reason(&e) },
    })
}

/// The file beside `path` that is written first, in a folder that is made if need be.
fn neighbor(path: &Path) -> Result<PathBuf, Error> {
    if let Some(folder) = path.parent().filter(|p| !p.as_os_str().is_empty()) {
        fs::create_dir_all(folder).map_err(|e| failed(path, reason(&e)))?;
    }
    let mut name = path.file_name().ok_or_else(|| failed(path, "it has no file name"))?.to_owned();
    name.push(format!(".{}.part", std::process::id()));
    Ok(path.with_file_name(name))
}

fn failed(path: &Path, reason: impl ToString) -> Error {
    Error::Write { name: path.display().to_string(), reason: reason.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{color::Rgb, film::Size};

    fn film() -> Film {
        let mut film = Film::new(Size::of::<3, 2>());
        for tile in film.tiles_mut() {
            for (x, y, pixel) in tile.pixels_mut() {
                #[allow(clippy::cast_precision_loss)]
                pixel.add(Rgb::new(x as f32 / 2.0, y as f32, 1e-7));
            }
        }
        film
    }

    #[test]
    fn exr_keeps_every_bit_and_png_the_screen_values() {
        let film = film();
        let exr = image::load_from_memory(&encode(&film, Format::Exr, 3.0).unwrap()).unwrap().into_rgb32f();
        let png = image::load_from_memory(&encode(&film, Format::Png, 0.0).unwrap()).unwrap().into_rgb8();
        let linear: Vec<f32> = film.linear().iter().flat_map(|c| c.to_array()).collect();
        assert_eq!(exr.into_raw(), linear);
        assert_eq!(png.into_raw(), film.develop(0.0).as_flattened());
    }

    #[test]
    fn a_failed_write_leaves_the_old_file_and_nothing_else() {
        let folder = std::env::temp_dir().join(format!("course-output-{}", std::process::id()));
        let file = folder.join("deep/a.png");
        write(&file, b"old").unwrap();
        write(&file, b"new").unwrap();
        assert_eq!(fs::read(&file).unwrap(), b"new");
        // A folder with something in it cannot be replaced by a file.
        let blocked = folder.join("deep");
        assert!(write(&blocked, b"x").unwrap_err().to_string().starts_with("cannot write "));
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        assert_eq!(fs::read_dir(folder.join("deep")).unwrap().count(), 1);
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn unknown_kinds_of_files_are_refused() {
        for bad in ["a.jpg", "a", ".png", "png"] {
            assert_eq!(Format::of(Path::new(bad)), Err(Error::Extension(bad.into())));
        }
        assert_eq!(Format::of(Path::new("x/a.PNG")), Ok(Format::Png));
        assert_eq!(Format::of(Path::new("a.b.exr")), Ok(Format::Exr));
    }
}
