//! What the pages need besides their Markdown: ready HTML, and pictures.

use std::collections::BTreeSet;

use crate::live::Module;

/// Collected while the pages are expanded, written after mdBook has written the pages.
///
/// Ready HTML would meet the Markdown parser, and formulas would get into the search index. So Markdown gets an empty
/// element with a number, and the written pages get the HTML in its place.
#[derive(Default)]
pub(crate) struct Output {
    html: Vec<Html>,
    /// The pictures that are shown, as `chapter/picture`.
    pub(crate) pictures: BTreeSet<String>,
    /// The chapters' code for the browser, if pictures are to be live.
    pub(crate) module: Option<Module>,
}

/// Where a page is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Medium {
    /// In a browser.
    Screen,
    /// Printed: the page with all others on it.
    Paper,
}

/// Ready HTML.
struct Html {
    text: String,
    is_on_paper: bool,
}

impl Html {
    /// The HTML as it stands in a page.
    fn shown(&self, medium: Medium) -> &str {
        if medium == Medium::Screen || self.is_on_paper { &self.text } else { "" }
    }
}

impl Output {
    /// Nothing collected yet; pictures are live if there is a module.
    pub(crate) fn new(module: Option<Module>) -> Self {
        Self { module, ..Self::default() }
    }

    /// Keep HTML that stands inside a paragraph; the answer is its placeholder.
    pub(crate) fn inline(&mut self, html: String) -> String {
        self.html.push(Html { text: html, is_on_paper: true });
        format!("<span data-fill=\"{}\"></span>", self.html.len() - 1)
    }

    /// Keep HTML that is a block of its own; the answer is its placeholder.
    pub(crate) fn block(&mut self, html: String) -> String {
        self.keep_block(html, true)
    }

    /// Keep HTML that is a block of its own and is nothing to print; the answer is its placeholder.
    pub(crate) fn on_screen(&mut self, html: String) -> String {
        self.keep_block(html, false)
    }

    /// Keep a block; the answer is its placeholder.
    fn keep_block(&mut self, text: String, is_on_paper: bool) -> String {
        self.html.push(Html { text, is_on_paper });
        format!("<div data-fill=\"{}\"></div>", self.html.len() - 1)
    }

    /// Put the HTML into a written page.
    pub(crate) fn fill(&self, page: &str, medium: Medium) -> String {
        let mut filled = String::with_capacity(page.len());
        let mut rest = page;
        while let Some(at) = rest.find(" data-fill=\"") {
            // The element's start lies before the attribute, and its end after it.
            let (before, after) = rest.split_at(at);
            let number = after.split('"').nth(1).and_then(|n| n.parse::<usize>().ok());
            let html = number.and_then(|n| self.html.get(n));
            let (start, end) =
                (before.rfind('<'), after.find("></").and_then(|e| Some(e + after[e + 2..].find('>')? + 3)));
            match (html, start, end) {
                (Some(html), Some(start), Some(end)) => {
                    filled.push_str(&before[..start]);
                    filled.push_str(html.shown(medium));
                    rest = &after[end..];
                }
                _ => {
                    filled.push_str(before);
                    filled.push_str(&after[..1]);
                    rest = &after[1..];
                }
            }
        }
        filled.push_str(rest);
        filled
    }
}

/// Text as it stands in HTML, also inside a quoted attribute.
pub(crate) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            c => escaped.push(c),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn placeholders_are_filled_wherever_they_stand() {
        let mut output = Output::default();
        let (formula, diagram) = (output.inline("<b>x</b>".into()), output.block("<svg></svg>".into()));
        let button = output.on_screen("<hr>".into());
        let page = format!("<p>a {formula} b</p><p>{formula}</p>{diagram}<i data-fill=\"99\"></i>{button}");
        let paper = "<p>a <b>x</b> b</p><p><b>x</b></p><svg></svg><i data-fill=\"99\"></i>";
        assert_eq!(output.fill(&page, Medium::Paper), paper);
        assert_eq!(output.fill(&page, Medium::Screen), format!("{paper}<hr>"));
    }

    #[test]
    fn escaped_text_is_no_markup() {
        assert_eq!(escape("a<b & \"c\">"), "a&lt;b &amp; &quot;c&quot;&gt;");
    }
}
