//! The live pictures: the chapters' own code, compiled to WebAssembly, as a script beside the pages.
//!
//! A page that is opened from disk may load scripts and nothing else, so the module travels as text in one. A page
//! loads it when somebody wants to see a picture live. `tests/wasm.sh` makes the module; without it the book is whole,
//! but has no live pictures.

use std::{
    fs,
    hash::{DefaultHasher, Hash, Hasher},
    path::Path,
    time::SystemTime,
};

use common::picture::{Chapter, Picture};

use crate::{
    error::BookError,
    expand::Page,
    house::{House, name_of},
    output::escape,
};

/// Where `tests/wasm.sh` puts the module, relative to the root.
pub(crate) const MODULE: &str = "target/wasm/wasm32-unknown-unknown/wasm/course.wasm";
/// With what every module begins.
const MAGIC: &[u8] = b"\0asm";

/// The module as the pages load it.
pub(crate) struct Module {
    /// The script relative to the folder of the book; its name changes with the module, so no old one is kept.
    script: String,
    /// The module's bytes.
    bytes: Vec<u8>,
}

impl Module {
    /// The module of a house, if it has one.
    pub(crate) fn of(house: &House) -> Option<Self> {
        let bytes = fs::read(house.path(MODULE)).ok().filter(|bytes| bytes.starts_with(MAGIC))?;
        let mut hasher = DefaultHasher::new();
        bytes.hash(&mut hasher);
        Some(Self { script: format!("live/course-{:08x}.js", hasher.finish() >> 32), bytes })
    }

    /// What stands below a picture: where the module is, and what the page must know of the picture.
    pub(crate) fn place(&self, page: &Page<'_>, chapter: &Chapter, picture: &Picture) -> Option<String> {
        let chapters = page.house.chapters;
        let number = chapters.iter().position(|c| c.name == chapter.name)?;
        let index = chapter.pictures.iter().position(|p| p.name == picture.name)?;
        let description = escape(&course::live::describe(chapters, number, index)?);
        let script = format!("{}{}", page.to_root(), self.script);
        Some(format!("<div class=\"live\" data-module=\"{script}\" data-picture=\"{description}\"></div>"))
    }

    /// Write the script into the book.
    pub(crate) fn write(&self, out: &Path) -> Result<(), BookError> {
        let path = out.join(&self.script);
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder).map_err(BookError::file(folder))?;
        }
        let script = format!("courseModule(\"{}\");\n", base64(&self.bytes));
        fs::write(&path, script).map_err(BookError::file(&path))
    }
}

/// What a reader would miss in the live pictures, in one line; `None` if nothing.
pub(crate) fn note(house: &House) -> Option<String> {
    let path = house.path(MODULE);
    if !path.exists() {
        return Some("no live pictures: run tests/wasm.sh first".into());
    }
    if Module::of(house).is_none() {
        return Some(format!("no live pictures: {MODULE} is no WebAssembly module: run tests/wasm.sh again"));
    }
    let newer = newer_source(&path)?;
    let newer = name_of(Path::new(&newer), &house.path(""));
    Some(format!("the live pictures are older than {newer}: run tests/wasm.sh again"))
}

/// A source of the module that was changed after it was made. Cargo lists them in a file beside the module, as make
/// would: `target: source source`, with a backslash before a space.
fn newer_source(module: &Path) -> Option<String> {
    let changed = |path: &Path| -> Option<SystemTime> { fs::metadata(path).ok()?.modified().ok() };
    let made = changed(module)?;
    let list = fs::read_to_string(module.with_extension("d")).ok()?;
    let (_, sources) = list.lines().next()?.split_once(": ")?;
    let sources = sources.replace("\\ ", "\0");
    let mut names = sources.split_whitespace().map(|name| name.replace('\0', " "));
    names.find(|name| changed(Path::new(name)).is_some_and(|time| time > made))
}

/// Bytes as text: 64 letters, six bits each (RFC 4648).
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let byte = |i: usize| u32::from(three.get(i).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for i in 0..4 {
            // One byte fills two letters, two bytes fill three.
            let letter = LETTERS[(bits >> (18 - 6 * i)) as usize & 63];
            text.push(if i <= three.len() { char::from(letter) } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixture::Fixture;

    /// A book with a module that no browser would run.
    fn with_module(bytes: &[u8]) -> Fixture {
        let fixture = Fixture::new();
        fixture.write_bytes(MODULE, bytes);
        fixture
    }

    #[test]
    fn base64_is_that_of_the_standard() {
        for (plain, coded) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ] {
            assert_eq!(base64(plain.as_bytes()), coded);
        }
        assert_eq!(base64(&[0xfb, 0xff, 0xbf]), "+/+/");
    }

    #[test]
    fn with_the_module_pictures_are_live() {
        let fixture = with_module(b"\0asm\x01\0\0\0");
        assert_eq!(fixture.problems(), [""; 0]);
        let page = fixture.built("01-toy/index.html");
        let start = "<div class=\"live\" data-module=\"../live/course-";
        let described =
            "data-picture=\"{&quot;name&quot;:&quot;toy/ball&quot;,&quot;chapter&quot;:0,&quot;picture&quot;:0,";
        assert!(page.contains(start) && page.contains(described), "{page}");
        let name = page.split("data-module=\"../").nth(1).and_then(|rest| rest.split('"').next()).unwrap();
        assert_eq!(fixture.built(name), "courseModule(\"AGFzbQEAAAA=\");\n");
        // On paper nothing moves.
        let print = fixture.built("print.html");
        assert!(print.contains("ball.png") && !print.contains("class=\"live\"") && !print.contains("data-fill"));
    }

    #[test]
    fn without_the_module_the_book_is_whole() {
        for (fixture, expected) in [
            (Fixture::new(), "no live pictures: run tests/wasm.sh first"),
            (with_module(b"\0as"), "course.wasm is no WebAssembly module: run tests/wasm.sh again"),
        ] {
            assert_eq!(fixture.problems(), [""; 0]);
            assert!(!fixture.built("01-toy/index.html").contains("class=\"live\""));
            assert!(!fixture.out().join("live").exists());
            let note = note(&fixture.house()).unwrap();
            assert!(note.contains(expected), "{note}");
        }
    }

    #[test]
    fn a_script_that_is_gone_is_found() {
        let fixture = with_module(b"\0asm");
        fixture.build().unwrap();
        fs::remove_dir_all(fixture.out().join("live")).unwrap();
        let problems = crate::check::problems(&fixture.house(), &fixture.out());
        assert!(problems.iter().any(|p| p.starts_with("01-toy/index.html: `../live/course-")), "{problems:?}");
        assert!(problems.iter().all(|p| p.ends_with("leads to no file")), "{problems:?}");
    }

    #[test]
    fn a_module_that_is_older_than_its_sources_is_found() {
        let fixture = with_module(b"\0asm");
        assert_eq!(note(&fixture.house()), None);
        let source = fixture.root().join("chapters/01-toy/src/a ball.rs");
        fixture.write("chapters/01-toy/src/a ball.rs", "");
        let list = format!("course.wasm: gone.rs {}\n", source.display().to_string().replace(' ', "\\ "));
        fixture.write(&MODULE.replace(".wasm", ".d"), &list);
        for (seconds, is_newer) in [(60, true), (0, false)] {
            let made = fs::metadata(fixture.root().join(MODULE)).unwrap().modified().unwrap();
            let time = made + std::time::Duration::from_secs(seconds);
            fs::File::options().append(true).open(&source).unwrap().set_modified(time).unwrap();
            let expected = "the live pictures are older than chapters/01-toy/src/a ball.rs: run tests/wasm.sh again";
            assert_eq!(note(&fixture.house()), is_newer.then_some(expected.into()));
        }
    }
}
