//! A page with its directives replaced by what they ask for.

use std::{fmt::Write, sync::Arc};

use crate::{
    crates,
    directive::{Code, Directive, Found, is_prefix},
    error::{Mistake, Place},
    exercise, figure,
    house::House,
    knows, listing, number,
    output::Output,
};

/// A line of Markdown and where it comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Line {
    /// The line without its end.
    pub(crate) text: String,
    /// Where an author finds it.
    pub(crate) place: Place,
}

/// What a directive is replaced by: lines, and where they come from if it is not the directive's line.
#[derive(Debug, Default)]
pub(crate) struct Block(Vec<(String, Option<Place>)>);

impl Block {
    /// Add lines that were made by the directive.
    pub(crate) fn push(&mut self, text: &str) {
        self.0.extend(text.split('\n').map(|line| (line.to_owned(), None)));
    }

    /// Add a line that an author wrote in another file.
    pub(crate) fn push_from(&mut self, line: &str, place: Place) {
        self.0.push((line.to_owned(), Some(place)));
    }

    /// Add another block.
    pub(crate) fn append(&mut self, mut other: Self) {
        self.0.append(&mut other.0);
    }
}

/// A page that is being expanded.
pub(crate) struct Page<'a> {
    /// The house.
    pub(crate) house: &'a House,
    /// The page relative to the folder of the pages.
    pub(crate) path: &'a str,
}

impl Page<'_> {
    /// The way from the page to the folder of the book, such as `../`.
    pub(crate) fn to_root(&self) -> String {
        "../".repeat(self.path.matches('/').count())
    }

    /// The lines of the page with its directives replaced.
    pub(crate) fn expand(&self, markdown: &str, output: &mut Output) -> Result<Vec<Line>, Vec<Mistake>> {
        let file: Arc<str> = format!("book/src/{}", self.path).into();
        let code = Code::of(markdown);
        let (mut lines, mut mistakes) = (Vec::new(), Vec::new());
        let mut offset = 0;
        for (index, whole) in markdown.split_inclusive('\n').enumerate() {
            let place = Place::new(&file, index + 1);
            if code.rust.iter().any(|at| (offset..offset + whole.len()).contains(at)) {
                let what = "Rust is not pasted into a page: show compiled source with `{{#listing file.rs:anchor}}`";
                mistakes.push(Mistake { place: place.clone(), what: what.into() });
            }
            let line = whole.trim_end_matches(['\n', '\r']);
            match self.expand_line(line, &code.directives(line, offset), output) {
                Ok(block) => lines.extend(
                    block.0.into_iter().map(|(text, from)| Line { text, place: from.unwrap_or_else(|| place.clone()) }),
                ),
                Err(what) => mistakes.push(Mistake { place, what }),
            }
            offset += whole.len();
        }
        if mistakes.is_empty() { Ok(lines) } else { Err(mistakes) }
    }

    /// A line with its directives replaced.
    fn expand_line(&self, line: &str, found: &[Found<'_>], output: &mut Output) -> Result<Block, String> {
        let mut block = Block::default();
        let mut text = String::new();
        let mut copied = 0;
        for Found { range, inside } in found {
            let inside = inside.ok_or("a directive is closed by `}}` on the line where it starts")?;
            let directive = Directive::parse(inside)?;
            let (before, after) = (&line[copied..range.start], &line[range.end..]);
            if directive.is_inline() {
                let Directive::Number { name } = directive else { continue };
                let _ = write!(text, "{before}{}", number::value(self.house, name)?);
                copied = range.end;
            } else if is_prefix(&line[..range.start]) && after.trim().is_empty() {
                let made = self.block(directive, output)?;
                // Blank lines part the block from the text around it.
                let lines = [(String::new(), None)].into_iter().chain(made.0).chain([(String::new(), None)]);
                block.0.extend(lines.map(|(text, from)| (format!("{before}{text}").trim_end().to_owned(), from)));
                return Ok(block);
            } else {
                return Err(format!("`{{{{#{}}}}}` stands alone on its line", inside.trim()));
            }
        }
        text.push_str(&line[copied..]);
        block.0.push((text, None));
        Ok(block)
    }

    /// What replaces a directive that stands alone.
    fn block(&self, directive: Directive<'_>, output: &mut Output) -> Result<Block, String> {
        match directive {
            Directive::Listing { file, anchor } => listing::block(self.house, file, anchor),
            Directive::Figure { picture, caption } => {
                let code = Code::of(caption);
                let caption = self.expand_line(caption, &code.directives(caption, 0), output)?;
                figure::block(self, picture, caption, output)
            }
            Directive::Knows { chapter } => knows::block(self.house, chapter, output),
            Directive::Crates => crates::block(self.house, output),
            Directive::Exercise { number } => exercise::block(self.house, number),
            Directive::Pictures { chapter } => figure::gallery(self, chapter, output),
            Directive::Number { name } => {
                let mut block = Block::default();
                block.push(&number::value(self.house, name)?);
                Ok(block)
            }
        }
    }
}

/// The lines as one text.
pub(crate) fn join(lines: &[Line]) -> String {
    lines.iter().flat_map(|line| [line.text.as_str(), "\n"]).collect()
}

/// Where an author finds what stands at `offset` in the joined text.
pub(crate) fn place_at(lines: &[Line], offset: usize) -> Place {
    let mut end = 0;
    let line = lines.iter().find(|line| {
        end += line.text.len() + 1;
        offset < end
    });
    line.or(lines.last()).map_or_else(|| Place::new(&"an empty page".into(), 1), |line| line.place.clone())
}
