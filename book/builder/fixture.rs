//! A small workspace in a temporary folder, to build books from in tests.

use std::{
    fs,
    path::{Path, PathBuf},
};

use common::{
    error::Error,
    film::Size,
    knob::{Knob, Step},
    picture::{Chapter, Picture, Render, Settings, YAW},
};
use tempfile::TempDir;

use crate::{error::BookError, house::House};

/// A chapter with two pictures.
pub(crate) const CHAPTERS: &[Chapter] = &[Chapter {
    number: 1,
    name: "toy",
    title: "Toy",
    pictures: &[picture("ball", "A white ball."), picture("box", "A <box>.")],
    reports: &[],
}];

/// A picture that is never made.
const fn picture(name: &'static str, alt: &'static str) -> Picture {
    const KNOBS: &[Knob] = &[YAW, Knob::number("shine", "how shiny", [1.0, 500.0], 50.0, "", Step::Times(1.1))];
    Picture { name, alt, knobs: KNOBS, size: Size::of::<4, 3>(), samples: 1, takes_mesh: false, make }
}

/// Nothing can be made of a fixture.
fn make(_: &Settings) -> Result<Box<dyn Render>, Error> {
    Err(Error::Size { width: 0, height: 0 })
}

/// A workspace in a temporary folder.
pub(crate) struct Fixture(TempDir);

impl Fixture {
    /// A workspace with one chapter that has a page for everything, and no mistakes.
    pub(crate) fn new() -> Self {
        let fixture = Self(tempfile::tempdir().unwrap());
        for (name, text) in [
            ("Cargo.toml", "[workspace]\nmembers = [\"chapters/*\"]\n"),
            ("chapters/01-toy/Cargo.toml", "[package]\nname = \"toy\"\n"),
            ("chapters/01-toy/src/lib.rs", "pub mod ball;\n"),
            ("chapters/01-toy/src/ball.rs", "// ANCHOR: ball\npub struct Ball<'a>(&'a str);\n// ANCHOR_END: ball\n"),
            (
                "chapters/01-toy/exercises/1-cube.rs",
                "//! # Exercise 1.1: A cube\n//!\n//! Make $x^2$ of [`Ball`].\n\nfn main() {}\n",
            ),
            ("chapters/01-toy/exercises/hints/1-cube.md", "Think.\n\n---\n\nThink *again*.\n"),
            ("tests/numbers/toy.txt", "# measured\nrays = 12 000 # per second\n"),
            ("book/book.toml", BOOK),
            ("book/src/SUMMARY.md", "# Summary\n\n[Start](start.md)\n\n- [Toy](01-toy/index.md)\n"),
            ("book/src/start.md", "# Start\n\nSee [the ball](01-toy/index.md#ball).\n"),
            ("book/src/01-toy/index.md", PAGE),
        ] {
            fixture.write(name, text);
        }
        for name in ["ball", "box"] {
            fixture.write_bytes(&format!("tests/snapshots/toy/{name}.snap.png"), PNG);
        }
        fixture
    }

    /// The house in the folder.
    pub(crate) fn house(&self) -> House {
        House::new(self.root(), CHAPTERS)
    }

    /// The folder.
    pub(crate) fn root(&self) -> &Path {
        self.0.path()
    }

    /// Where the book is built to.
    pub(crate) fn out(&self) -> PathBuf {
        self.root().join("target/book")
    }

    /// Write a file.
    pub(crate) fn write(&self, name: &str, text: &str) {
        self.write_bytes(name, text.as_bytes());
    }

    /// Write a file that is no text.
    pub(crate) fn write_bytes(&self, name: &str, bytes: &[u8]) {
        let path = self.root().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, bytes).unwrap();
    }

    /// Replace the page of the chapter.
    pub(crate) fn page(&self, markdown: &str) {
        self.write("book/src/01-toy/index.md", markdown);
    }

    /// Build the book.
    pub(crate) fn build(&self) -> Result<(), BookError> {
        crate::render::build(&self.house(), &self.out())
    }

    /// A built file.
    pub(crate) fn built(&self, name: &str) -> String {
        fs::read_to_string(self.out().join(name)).unwrap()
    }

    /// Build the book and check it.
    pub(crate) fn problems(&self) -> Vec<String> {
        self.build().unwrap();
        crate::check::problems(&self.house(), &self.out())
    }
}

const BOOK: &str = "\
[book]
title = \"Toy\"
[build]
create-missing = false
use-default-preprocessors = false
[output.html.playground]
runnable = false
[output.html.print]
enable = true
";

const PAGE: &str = "\
# Toy

## Ball

{{#listing chapters/01-toy/src/ball.rs:ball}}

{{#figure toy/ball A ball at $x = {{#number toy/rays}}$.}}

It takes {{#number toy/rays}} rays, or $\\sqrt{2}$.

{{#knows toy}}

{{#crates}}

{{#exercise 1.1}}

{{#pictures toy}}
";

/// The smallest picture.
const PNG: &[u8] = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x04\0\0\0\x03\x08\x02\0\0\0";
