//! The directives that authors write in Markdown, `{{#name argument}}`, and where they stand.

use std::ops::Range;

use pulldown_cmark::{CodeBlockKind, Event, Parser, Tag};

use crate::math;

/// What an author asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Directive<'a> {
    /// `{{#listing file:anchor}}`: source text between two anchor comments, or the whole file.
    Listing { file: &'a str, anchor: Option<&'a str> },
    /// `{{#figure chapter/picture Caption.}}`: a pinned picture.
    Figure { picture: &'a str, caption: &'a str },
    /// `{{#number chapter/name}}`: a pinned number, inside a sentence.
    Number { name: &'a str },
    /// `{{#knows chapter}}`: which module of a chapter knows which.
    Knows { chapter: &'a str },
    /// `{{#crates}}`: which crate of the workspace depends on which.
    Crates,
    /// `{{#exercise 1.2}}`: task and hints of an exercise.
    Exercise { number: &'a str },
    /// `{{#pictures chapter}}`: all pictures of a chapter with their knobs.
    Pictures { chapter: &'a str },
}

impl<'a> Directive<'a> {
    /// Read what stands between `{{#` and `}}`.
    pub(crate) fn parse(text: &'a str) -> Result<Self, String> {
        let text = text.trim();
        let (name, argument) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
        let argument = argument.trim();
        let one = |what: &str| match argument.split_whitespace().count() {
            1 => Ok(argument),
            _ => Err(format!("`{{{{#{name}}}}}` takes one argument: `{{{{#{name} {what}}}}}`")),
        };
        match name {
            "listing" => {
                let file = one("path/of/file.rs:anchor")?;
                Ok(match file.split_once(':') {
                    Some((file, anchor)) => Self::Listing { file, anchor: Some(anchor) },
                    None => Self::Listing { file, anchor: None },
                })
            }
            "figure" => Ok(match argument.split_once(char::is_whitespace) {
                Some((picture, caption)) => Self::Figure { picture, caption: caption.trim() },
                None => Self::Figure { picture: one("chapter/picture")?, caption: "" },
            }),
            "number" => Ok(Self::Number { name: one("chapter/name")? }),
            "knows" => Ok(Self::Knows { chapter: one("chapter")? }),
            "crates" if argument.is_empty() => Ok(Self::Crates),
            "crates" => Err("`{{#crates}}` takes no argument".into()),
            "exercise" => Ok(Self::Exercise { number: one("1.2")? }),
            "pictures" => Ok(Self::Pictures { chapter: one("chapter")? }),
            _ => Err(format!(
                "there is no directive `{{{{#{name}}}}}`: there is listing, figure, number, knows, crates, exercise, \
                 pictures"
            )),
        }
    }

    /// Whether it may stand inside a sentence.
    pub(crate) fn is_inline(self) -> bool {
        matches!(self, Self::Number { .. })
    }
}

/// A directive where it was found.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Found<'a> {
    /// From `{{#` to `}}` in the line.
    pub(crate) range: Range<usize>,
    /// What stands between; `None` if it is not closed on its line.
    pub(crate) inside: Option<&'a str>,
}

/// Which parts of a page are code, where nothing is a directive.
pub(crate) struct Code {
    /// Byte ranges of fenced blocks and of inline code.
    ranges: Vec<Range<usize>>,
    /// Offsets of fenced blocks of Rust.
    pub(crate) rust: Vec<usize>,
}

impl Code {
    /// Find the code in a page.
    pub(crate) fn of(markdown: &str) -> Self {
        let mut code = Self { ranges: Vec::new(), rust: Vec::new() };
        for (event, range) in Parser::new_ext(markdown, math::options()).into_offset_iter() {
            match event {
                Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) => {
                    if info.split(',').next() == Some("rust") {
                        code.rust.push(range.start);
                    }
                    code.ranges.push(range);
                }
                Event::Code(_) => code.ranges.push(range),
                _ => {}
            }
        }
        code
    }

    /// The directives in a line of the page that starts at `offset`.
    pub(crate) fn directives<'a>(&self, line: &'a str, offset: usize) -> Vec<Found<'a>> {
        let mut found = Vec::new();
        let mut from = 0;
        while let Some(start) = line[from..].find("{{#").map(|at| from + at) {
            let rest = line[start..].trim_end();
            // A caption may hold formulas and numbers, so a figure ends with its line.
            let end =
                if rest.starts_with("{{#figure") { rest.strip_suffix("}}").map(str::len) } else { rest.find("}}") };
            let end = end.map(|end| start + end);
            let inside = end.and_then(|end| line.get(start + 3..end));
            let range = start..end.map_or(line.len(), |end| end + 2);
            from = range.end;
            if !self.ranges.iter().any(|code| code.contains(&(offset + start))) {
                found.push(Found { range, inside });
            }
        }
        found
    }
}

/// Whether nothing but the marks of a list or a quotation stand before a directive.
pub(crate) fn is_prefix(text: &str) -> bool {
    text.chars().all(|c| c.is_whitespace() || c == '>')
}

/// All directives of a page that can be read.
pub(crate) fn all(markdown: &str) -> Vec<Directive<'_>> {
    let code = Code::of(markdown);
    let mut offset = 0;
    let mut found = Vec::new();
    for line in markdown.split_inclusive('\n') {
        let inside = code.directives(line, offset).into_iter().filter_map(|d| d.inside);
        found.extend(inside.filter_map(|text| Directive::parse(text).ok()));
        offset += line.len();
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directives_are_read() {
        assert_eq!(Directive::parse("listing a.rs:b"), Ok(Directive::Listing { file: "a.rs", anchor: Some("b") }));
        assert_eq!(Directive::parse("listing a.rs"), Ok(Directive::Listing { file: "a.rs", anchor: None }));
        let figure = Directive::Figure { picture: "a/b", caption: "Two words." };
        assert_eq!(Directive::parse("figure  a/b  Two words. "), Ok(figure));
        assert_eq!(Directive::parse("crates"), Ok(Directive::Crates));
        for wrong in ["", "include a.rs", "listing", "listing a b", "figure", "number", "crates all", "exercise 1 2"] {
            let error = Directive::parse(wrong).unwrap_err();
            assert!(error.contains("{{#") || error.contains("there is no directive"), "{error}");
        }
    }

    #[test]
    fn nothing_in_code_is_a_directive() {
        let page = "`{{#crates}}` {{#number a/b}}\n\n```text\n{{#crates}}\n```\n\n- {{#figure a/b $\\frac{{1}}{2}$ {{#number c/d}}}}\n";
        let expected = [Directive::Number { name: "a/b" }];
        assert_eq!(all(page)[..1], expected);
        assert_eq!(all(page).len(), 2, "{:?}", all(page));
    }
}
