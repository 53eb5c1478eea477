//! The book: it builds, and every listing, picture, number, link and anchor in it leads somewhere.

use std::path::Path;

#[test]
fn the_book_builds_and_has_no_loose_ends() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize().unwrap();
    let out = tempfile::TempDir::new().unwrap();
    let out = out.path().join("book");
    book::build(&root, &out).unwrap_or_else(|error| panic!("{error}"));
    let problems = book::check(&root, &out);
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}
