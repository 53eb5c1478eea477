//! What the book forgot, and what leads nowhere in it.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::Path,
};

use crate::{
    anchor,
    directive::{self, Directive},
    exercise,
    house::{House, files_under, folder, name_of},
    links,
};

/// The list of all pages.
const SUMMARY: &str = "SUMMARY.md";

/// All problems of a house's book that was built into `out`, each in one line.
pub(crate) fn problems(house: &House, out: &Path) -> Vec<String> {
    let pages = pages(house);
    let mut problems = summary(house, &pages);
    problems.extend(chapters(house, &pages));
    problems.extend(anchors(house, &pages));
    problems.extend(exercises(house, &pages));
    if out.join("index.html").is_file() {
        problems.extend(links::problems(out));
    } else {
        problems.push(format!("{}: there is no book here: build it first", out.display()));
    }
    problems
}

/// The Markdown files of the book and their text, by their names relative to `book/src`.
fn pages(house: &House) -> BTreeMap<String, String> {
    let root = house.pages();
    let files = files_under(&root).into_iter().filter(|path| path.extension().is_some_and(|e| e == "md"));
    // What was taken from elsewhere, such as the fonts, says so in a README.
    files
        .map(|path| (name_of(&path, &root), fs::read_to_string(&path).unwrap_or_default()))
        .filter(|(name, _)| !name.ends_with("README.md"))
        .collect()
}

/// The files that the summary lists.
fn listed(pages: &BTreeMap<String, String>) -> BTreeSet<String> {
    let summary = pages.get(SUMMARY).map_or("", String::as_str);
    let links = summary.match_indices("](").filter_map(|(at, _)| summary[at + 2..].split(')').next());
    links.map(|link| link.trim_start_matches("./").to_owned()).collect()
}

/// Every entry of the summary is a page, and every page is an entry of the summary.
fn summary(house: &House, pages: &BTreeMap<String, String>) -> Vec<String> {
    let listed = listed(pages);
    let missing = listed.iter().filter(|page| !page.is_empty() && !house.pages().join(page).is_file());
    let forgotten = pages.keys().filter(|page| *page != SUMMARY && !listed.contains(*page));
    missing
        .map(|page| format!("book/src/{SUMMARY}: the page `{page}` is not there"))
        .chain(forgotten.map(|page| format!("book/src/{page}: the page is not listed in {SUMMARY}")))
        .collect()
}

/// Every chapter has its page, and every folder of a chapter is a registered chapter.
fn chapters(house: &House, pages: &BTreeMap<String, String>) -> Vec<String> {
    let folders: Vec<_> = house.chapters.iter().map(folder).collect();
    let missing = folders.iter().filter(|folder| !pages.contains_key(&format!("{folder}/index.md")));
    let mut problems: Vec<_> =
        missing.map(|folder| format!("book/src/{folder}/index.md: the chapter has no page")).collect();
    let entries = fs::read_dir(house.path("chapters")).into_iter().flatten().flatten();
    let mut unknown: Vec<_> = entries
        .filter(|entry| entry.path().join("Cargo.toml").is_file())
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .filter(|name| !folders.contains(name))
        .collect();
    unknown.sort();
    problems.extend(
        unknown.iter().map(|name| format!("chapters/{name}: the chapter is not registered in the crate `course`")),
    );
    problems
}

/// Every anchor in the sources of a chapter is sound and is shown on some page.
fn anchors(house: &House, pages: &BTreeMap<String, String>) -> Vec<String> {
    let shown: BTreeSet<_> = directives(pages)
        .filter_map(|directive| match directive {
            Directive::Listing { file, anchor: Some(anchor) } => Some((file, anchor)),
            _ => None,
        })
        .collect();
    let mut problems = Vec::new();
    for chapter in house.chapters {
        let root = house.path("");
        for path in files_under(&house.path(&format!("chapters/{}/src", folder(chapter)))) {
            let file = name_of(&path, &root);
            let text = fs::read_to_string(&path).unwrap_or_default();
            let (anchors, wrong) = anchor::scan(&text);
            problems.extend(wrong.into_iter().map(|(line, what)| format!("{file}:{line}: {what}")));
            let unused = anchors.iter().filter(|a| !shown.contains(&(file.as_str(), a.name)));
            problems.extend(unused.map(|a| format!("{file}:{}: no page shows the anchor `{}`", a.start, a.name)));
        }
    }
    problems
}

/// Every exercise is on some page, and on one only.
fn exercises(house: &House, pages: &BTreeMap<String, String>) -> Vec<String> {
    let mut problems = Vec::new();
    for (number, file) in house.chapters.iter().flat_map(|chapter| exercise::all(house, chapter)) {
        match directives(pages).filter(|d| *d == Directive::Exercise { number: &number }).count() {
            0 => problems.push(format!("{file}: no page has the exercise {number}")),
            1 => {}
            many => problems.push(format!("{file}: {many} pages have the exercise {number}")),
        }
    }
    problems
}

/// All directives of all pages.
fn directives(pages: &BTreeMap<String, String>) -> impl Iterator<Item = Directive<'_>> {
    pages.values().flat_map(|page| directive::all(page))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixture::Fixture;

    /// What is found after one change to a book without problems.
    fn found(change: impl FnOnce(&Fixture)) -> String {
        let fixture = Fixture::new();
        change(&fixture);
        fixture.problems().join("\n")
    }

    #[test]
    fn a_sound_book_has_no_problems() {
        assert_eq!(found(|_| {}), "");
    }

    #[test]
    fn a_book_that_is_not_built_is_one_problem() {
        let fixture = Fixture::new();
        let problems = problems(&fixture.house(), &fixture.out());
        assert!(matches!(problems.as_slice(), [only] if only.contains("no book here")), "{problems:?}");
    }

    #[test]
    fn pages_and_summary_agree() {
        let forgotten = found(|f| f.write("book/src/01-toy/more.md", "# More\n"));
        assert_eq!(forgotten, "book/src/01-toy/more.md: the page is not listed in SUMMARY.md");
        let fixture = Fixture::new();
        fixture.build().unwrap();
        fixture.write("book/src/SUMMARY.md", "# Summary\n\n- [A](start.md)\n- [B](01-toy/index.md)\n- [C](gone.md)\n");
        let missing = super::problems(&fixture.house(), &fixture.out());
        assert_eq!(missing, ["book/src/SUMMARY.md: the page `gone.md` is not there"]);
    }

    #[test]
    fn chapters_have_pages_and_are_registered() {
        let unknown = found(|f| f.write("chapters/02-new/Cargo.toml", "[package]\nname = \"new\"\n"));
        assert_eq!(unknown, "chapters/02-new: the chapter is not registered in the crate `course`");
        let fixture = Fixture::new();
        fixture.build().unwrap();
        std::fs::remove_file(fixture.root().join("book/src/01-toy/index.md")).unwrap();
        let missing = super::problems(&fixture.house(), &fixture.out()).join("\n");
        assert!(missing.contains("book/src/01-toy/index.md: the chapter has no page"), "{missing}");
    }

    #[test]
    fn anchors_are_shown_and_closed() {
        let unused = found(|f| f.write("chapters/01-toy/src/cube.rs", "\n// ANCHOR: cube\nx\n// ANCHOR_END: cube\n"));
        assert_eq!(unused, "chapters/01-toy/src/cube.rs:2: no page shows the anchor `cube`");
        let open = found(|f| f.write("chapters/01-toy/src/deep/cube.rs", "// ANCHOR: cube\n"));
        assert!(open.contains("chapters/01-toy/src/deep/cube.rs:1: the anchor `cube` is not closed"), "{open}");
    }

    #[test]
    fn exercises_are_on_one_page() {
        let forgotten = found(|f| f.write("chapters/01-toy/exercises/2-more.rs", "//! # Exercise 1.2: More\n"));
        assert_eq!(forgotten, "chapters/01-toy/exercises/2-more.rs: no page has the exercise 1.2");
        let twice = found(|f| f.write("book/src/start.md", "# Start\n\n{{#exercise 1.1}}\n"));
        assert_eq!(twice, "chapters/01-toy/exercises/1-cube.rs: 2 pages have the exercise 1.1");
    }

    #[test]
    fn links_lead_somewhere() {
        for (markdown, expected) in [
            ("[a](gone.md)", "`gone.html` leads to no file"),
            ("[a](01-toy/index.md#gone)", "`01-toy/index.html#gone` leads to a page without the anchor `gone`"),
            ("[a](#gone)", "`#gone` leads to a page without the anchor `gone`"),
            ("[a](../../Cargo.toml)", "`../../Cargo.toml` leads out of the book"),
            ("[a](/01-toy/index.html)", "`/01-toy/index.html` starts at the root of a server"),
            ("![a ball](ball.png)", "`ball.png` leads to no file"),
        ] {
            let problems = found(|f| f.write("book/src/start.md", &format!("# Start\n\n{markdown}\n")));
            assert!(problems.contains(&format!("start.html: {expected}")), "{problems}");
        }
        assert_eq!(found(|f| f.write("book/src/start.md", "# Start\n\n[a](https://example.org) [b](#start)\n")), "");
    }

    #[test]
    fn images_have_words() {
        let problems = found(|f| {
            f.page("# Toy\n\n{{#listing chapters/01-toy/src/ball.rs:ball}}\n\n{{#exercise 1.1}}\n\n<img src=\"../favicon.svg\" alt=\" \">\n")
        });
        assert!(problems.contains("01-toy/index.html: the image `../favicon.svg` has no text"), "{problems}");
    }

    #[test]
    fn nothing_is_loaded_from_a_network() {
        for remote in [
            "<img src=\"https://example.org/a.png\" alt=\"a\">",
            "<script src=\"//example.org/a.js\"></script>",
            "<link rel=\"stylesheet\" href=\"http://example.org/a.css\">",
            "<style>p { background: url(https://example.org/a.png) }</style>",
            "<p style=\"background: url('https://example.org/a.png')\">x</p>",
        ] {
            let problems = found(|f| f.write("book/src/start.md", &format!("# Start\n\n## Ball\n\n{remote}\n")));
            assert!(problems.contains("start.html: `") && problems.contains("needs a network"), "{remote} {problems}");
        }
        let css = found(|f| f.write("book/src/a.css", "a { b: url(https://example.org/c); d: url(gone.png) }"));
        assert!(css.contains("a.css: `https://example.org/c` needs a network"), "{css}");
        assert!(css.contains("a.css: `gone.png` leads to no file"), "{css}");
    }
}
