//! Formulas, `$…$` and `$$…$$`, rendered while the book is built.

use std::ops::Range;

use katex::{KatexContext, ParseError, Settings, StrictMode, StrictSetting};
use pulldown_cmark::{Event, Options, Parser};

use crate::{
    error::Mistake,
    expand::{Line, join, place_at},
    output::Output,
};

/// How mdBook reads Markdown, and formulas besides.
pub(crate) fn options() -> Options {
    Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_TASKLISTS
        | Options::ENABLE_HEADING_ATTRIBUTES
        | Options::ENABLE_DEFINITION_LIST
        | Options::ENABLE_GFM
        | Options::ENABLE_MATH
}

/// A formula in a page.
struct Formula {
    range: Range<usize>,
    tex: String,
    is_display: bool,
}

/// What a `$` that belongs to no formula means.
const LONELY_DOLLAR: &str = "this `$` belongs to no formula: close it (no line of a formula starts with +, -, =, # or \
                             >, and in a table | is written \\vert), or write \\$ for the sign";

/// The page with a placeholder for each formula.
pub(crate) fn replace(lines: &[Line], output: &mut Output) -> Result<String, Vec<Mistake>> {
    let text = join(lines);
    let (formulas, lonely) = find(&text);
    let mistake = |offset: usize, what: String| Mistake { place: place_at(lines, offset), what };
    let mut mistakes: Vec<_> = lonely.into_iter().map(|at| mistake(at, LONELY_DOLLAR.into())).collect();

    let context = KatexContext::default();
    let mut replaced = String::with_capacity(text.len());
    let mut copied = 0;
    for Formula { range, tex, is_display } in formulas {
        replaced.push_str(&text[copied..range.start]);
        if has_bare_root(&tex) {
            mistakes.push(mistake(range.start, format!("write \\sqrt{{…}} with braces in `{}`", tex.trim())));
        }
        match render(&context, &tex, is_display) {
            Ok(html) => replaced.push_str(&output.inline(html)),
            Err(error) => {
                let what = error.to_string().replace('\n', " ");
                mistakes.push(mistake(range.start, format!("the formula `{}` is not right: {what}", tex.trim())));
            }
        }
        copied = range.end;
    }
    replaced.push_str(&text[copied..]);
    if mistakes.is_empty() { Ok(replaced) } else { Err(mistakes) }
}

/// Whether a root has its argument without braces: katex-rs 0.3 draws the sign of such a root in the wrong place.
fn has_bare_root(tex: &str) -> bool {
    tex.split("\\sqrt").skip(1).any(|argument| !argument.trim_start().starts_with(['{', '[']))
}

/// A formula as HTML to look at and MathML to hear.
fn render(context: &KatexContext, tex: &str, is_display: bool) -> Result<String, ParseError> {
    let settings = Settings::builder().display_mode(is_display).strict(StrictSetting::Mode(StrictMode::Error)).build();
    katex::render_to_string(context, tex.trim(), &settings)
}

/// The formulas in their order, and the places of `$` that belong to none.
fn find(text: &str) -> (Vec<Formula>, Vec<usize>) {
    let (mut formulas, mut lonely) = (Vec::new(), Vec::new());
    let mut in_code_block = false;
    for (event, range) in Parser::new_ext(text, options()).into_offset_iter() {
        match event {
            Event::Start(pulldown_cmark::Tag::CodeBlock(_)) => in_code_block = true,
            Event::End(pulldown_cmark::TagEnd::CodeBlock) => in_code_block = false,
            Event::InlineMath(tex) => formulas.push(Formula { range, tex: tex.to_string(), is_display: false }),
            Event::DisplayMath(tex) => formulas.push(Formula { range, tex: tex.to_string(), is_display: true }),
            Event::Html(_) => in_html(text, range, &mut formulas, &mut lonely),
            Event::Text(_) if !in_code_block => {
                let signs = text[range.clone()].match_indices('$').map(|(at, _)| range.start + at);
                lonely.extend(signs.filter(|&at| !text[..at].ends_with('\\')));
            }
            _ => {}
        }
    }
    (formulas, lonely)
}

/// The formulas of a piece of HTML, such as a summary: outside the tags, each within its line.
fn in_html(text: &str, range: Range<usize>, formulas: &mut Vec<Formula>, lonely: &mut Vec<usize>) {
    let mut at = range.start;
    while let Some(next) = text[at..range.end].find(['<', '$']).map(|n| at + n) {
        let rest = &text[next..range.end];
        if rest.starts_with('<') {
            at = rest.find('>').map_or(range.end, |end| next + end + 1);
            continue;
        }
        let sign = if rest.starts_with("$$") { "$$" } else { "$" };
        let Some(length) = rest[sign.len()..].find(['$', '\n']).filter(|&n| rest[sign.len() + n..].starts_with(sign))
        else {
            lonely.push(next);
            at = next + sign.len();
            continue;
        };
        let inside = next + sign.len()..next + sign.len() + length;
        at = inside.end + sign.len();
        let tex = text[inside].to_owned();
        formulas.push(Formula { range: next..at, tex, is_display: sign == "$$" });
    }
}
