//! Whole books, built from a small workspace with one mistake each.

use crate::{BookError, fixture::Fixture};

/// The mistakes in a page of the chapter.
fn mistakes(markdown: &str) -> String {
    let fixture = Fixture::new();
    fixture.page(markdown);
    fixture.build().unwrap_err().to_string()
}

#[test]
fn a_page_gets_what_it_asks_for() {
    let fixture = Fixture::new();
    fixture.build().unwrap();
    let page = fixture.built("01-toy/index.html");
    for expected in [
        "<code>chapters/01-toy/src/ball.rs</code>",
        "pub struct Ball&lt;'a&gt;(&amp;'a str);</code></pre>",
        "<a href=\"../pictures/toy/ball.png\"><img src=\"../pictures/toy/ball.png\" alt=\"A white ball.\" width=\"4\" height=\"3\" loading=\"lazy\"></a>",
        "alt=\"A &lt;box&gt;.\"",
        "<code class=\"command\">cargo run -p toy -- ball</code>",
        "It takes 12 000 rays, or <span class=\"katex\">",
        "<svg role=\"img\" aria-label=\"The modules of toy\"",
        "aria-label=\"The crates of the course\"",
        "<h2 id=\"exercise-1-1\">",
        "of <code>Ball</code>.",
        "cargo exercise 1.1",
        "<summary>Hint 1</summary>\n<p>Think.</p>",
        "<figcaption>\n<p>A ball at ",
        "<em>again</em>",
        "<td><code>shine</code></td>",
    ] {
        assert!(page.contains(expected), "{expected} is missing in\n{page}");
    }
    assert!(!page.contains("{{#") && !page.contains("data-fill") && !page.contains("play-button"));
    assert!(fixture.out().join("pictures/toy/box.png").is_file());
    let print = fixture.built("print.html");
    assert!(print.contains("src=\"pictures/toy/ball.png\"") && !print.contains("data-fill"));
}

#[test]
fn mistakes_name_place_and_remedy() {
    for (markdown, expected) in [
        ("{{#listing chapters/01-toy/src/cube.rs}}", "index.md:1: there is no file `chapters/01-toy/src/cube.rs`"),
        (
            "\n{{#listing chapters/01-toy/src/ball.rs:cube}}",
            "index.md:2: `chapters/01-toy/src/ball.rs` has no anchor `cube`: there is `ball`",
        ),
        ("{{#listing ../secret.rs}}", "index.md:1: `../secret.rs` is no path inside the workspace"),
        ("{{#listing tests/snapshots/toy/ball.snap.png}}", "is no kind of file that can be listed"),
        ("{{#figure toy/cube}}", "there is no picture `cube` in `toy`: there is `ball`, `box`"),
        ("{{#figure ball}}", "`ball` names no chapter: write `chapter/picture`"),
        ("{{#figure boy/ball}}", "there is no chapter `boy`: there is `toy`"),
        (
            "a {{#number toy/cubes}}",
            "index.md:1: there is no number `cubes` in `tests/numbers/toy.txt`: there is `rays`",
        ),
        ("{{#knows boy}}", "there is no chapter `boy`"),
        ("{{#exercise 1.2}}", "there is no exercise 1.2 in `chapters/01-toy/exercises`: there is `1.1`"),
        ("{{#exercise one}}", "`one` is no number of an exercise"),
        ("{{#pictures boy}}", "there is no chapter `boy`"),
        ("{{#include a.rs}}", "there is no directive `{{#include}}`"),
        ("see {{#crates}}", "`{{#crates}}` stands alone on its line"),
        ("{{#crates", "a directive is closed by `}}`"),
        ("a\n\n$\\sqrt D$", "index.md:3: write \\sqrt{…} with braces in `\\sqrt D`"),
        ("a\n\n$\\frac{1}$", "index.md:3: the formula `\\frac{1}` is not right"),
        ("a\n\n$$\nx\n+ y\n$$", "index.md:3: this `$` belongs to no formula"),
        ("<summary>$\\x$</summary>", "index.md:1: the formula `\\x` is not right"),
        ("It costs $5.", "this `$` belongs to no formula"),
        ("```rust\nfn a() {}\n```", "index.md:1: Rust is not pasted into a page"),
    ] {
        let mistakes = mistakes(markdown);
        assert!(mistakes.contains(expected), "{markdown}: {mistakes}");
        assert!(mistakes.lines().all(|line| line.starts_with("book/src/01-toy/index.md:")), "{mistakes}");
    }
}

#[test]
fn all_mistakes_are_told_at_once() {
    assert_eq!(mistakes("{{#crates x}}\n\n{{#listing a.rs}}\n").lines().count(), 2);
}

#[test]
fn mistakes_in_an_exercise_are_told_where_they_are() {
    for (file, text, expected) in [
        ("1-cube.rs", "//! # Cube\n", "index.md:15: `chapters/01-toy/exercises/1-cube.rs` does not start with"),
        ("1-cube.rs", "//! # Exercise 1.1: Cube\n", "has no task below its title"),
        (
            "1-cube.rs",
            "//! # Exercise 1.1: Cube\n//!\n//! $\\x$\n",
            "chapters/01-toy/exercises/1-cube.rs:3: the formula",
        ),
        ("hints/1-cube.md", "a\n---\n\n", "hint 2 of `chapters/01-toy/exercises/hints/1-cube.md` is empty"),
        ("hints/1-cube.md", "a\n---\n$\\x$\n", "chapters/01-toy/exercises/hints/1-cube.md:3: the formula"),
    ] {
        let fixture = Fixture::new();
        fixture.write(&format!("chapters/01-toy/exercises/{file}"), text);
        let error = fixture.build().unwrap_err().to_string();
        assert!(error.contains(expected), "{error}");
    }
    let fixture = Fixture::new();
    std::fs::remove_file(fixture.root().join("chapters/01-toy/exercises/hints/1-cube.md")).unwrap();
    assert!(fixture.build().unwrap_err().to_string().contains("there is no file `chapters/01-toy/exercises/hints"));
}

#[test]
fn pictures_need_their_snapshot() {
    let fixture = Fixture::new();
    std::fs::remove_file(fixture.root().join("tests/snapshots/toy/box.snap.png")).unwrap();
    let error = fixture.build().unwrap_err().to_string();
    assert!(error.contains("`toy/box` has no snapshot `tests/snapshots/toy/box.snap.png`"), "{error}");
}

#[test]
fn what_mdbook_warns_of_fails() {
    assert!(mistakes_of_mdbook("<div>\n\nopen\n").contains("unclosed HTML tag `<div>`"));
    let fixture = Fixture::new();
    fixture.write("book/src/SUMMARY.md", "# Summary\n\n- [Gone](gone.md)\n");
    assert!(fixture.build().unwrap_err().to_string().contains("gone.md"));
}

/// What mdBook says of a page.
fn mistakes_of_mdbook(markdown: &str) -> String {
    let fixture = Fixture::new();
    fixture.page(markdown);
    match fixture.build() {
        Err(BookError::Warnings(warnings)) => warnings.join("\n"),
        other => format!("{other:?}"),
    }
}

#[test]
fn a_failed_build_leaves_the_old_book() {
    let fixture = Fixture::new();
    fixture.build().unwrap();
    fixture.page("{{#crates");
    fixture.build().unwrap_err();
    assert!(fixture.built("01-toy/index.html").contains("struct Ball"));
    assert!(!fixture.root().join("target/book.new").exists());
}

#[test]
fn a_folder_that_holds_something_else_is_left_alone() {
    let fixture = Fixture::new();
    fixture.write("target/book/thesis.txt", "years of work");
    assert!(matches!(fixture.build(), Err(BookError::NotABook(_))));
    assert_eq!(fixture.built("thesis.txt"), "years of work");
}

#[test]
fn code_is_left_as_it_is() {
    let fixture = Fixture::new();
    let code = "{{#crates}} $x$ a_b";
    fixture.page(&format!("# Toy\n\n## Ball\n\n`{code}`\n\n```text\n{code}\n```\n\n> quoted $x$\n>\n> {{{{#listing chapters/01-toy/src/ball.rs:ball}}}}\n\nsign \\$5\n"));
    fixture.build().unwrap();
    let page = fixture.built("01-toy/index.html");
    assert_eq!(page.matches(code).count(), 2, "{page}");
    assert!(page.contains("sign $5"));
    let quotation = &page[page.find("<blockquote>").unwrap()..page.find("</blockquote>").unwrap()];
    assert!(quotation.contains("struct Ball") && quotation.contains("katex"), "{quotation}");
}
