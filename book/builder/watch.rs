//! Whether anything has changed that the book is made of.

use std::{
    fs,
    hash::{DefaultHasher, Hash, Hasher},
    path::Path,
};

use crate::house::files_under;

/// What the book is made of, relative to the root of the workspace.
const SOURCES: [&str; 9] = [
    "book/book.toml",
    "book/src",
    "book/theme",
    "chapters",
    "common/Cargo.toml",
    "tests/snapshots",
    "tests/numbers",
    "Cargo.toml",
    crate::live::MODULE,
];

/// A number that changes when a source of the book is written, added or removed.
pub(crate) fn fingerprint(root: &Path) -> u64 {
    let mut hasher = DefaultHasher::new();
    for source in SOURCES.map(|source| root.join(source)) {
        let files = if source.is_dir() { files_under(&source) } else { vec![source] };
        for file in files {
            let metadata = fs::metadata(&file).ok();
            (file, metadata.map(|m| (m.len(), m.modified().ok()))).hash(&mut hasher);
        }
    }
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixture::Fixture;

    #[test]
    fn changes_are_seen() {
        let fixture = Fixture::new();
        let before = fingerprint(fixture.root());
        assert_eq!(before, fingerprint(fixture.root()));
        for name in ["book/src/start.md", "chapters/01-toy/src/ball.rs", "tests/numbers/toy.txt"] {
            fixture.write(name, "something else");
            assert_ne!(before, fingerprint(fixture.root()), "{name}");
        }
        let after = fingerprint(fixture.root());
        fixture.write("target/anything", "");
        assert_eq!(after, fingerprint(fixture.root()));
    }
}
