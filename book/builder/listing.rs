//! `{{#listing file:anchor}}`: source text as it is compiled, with the name of its file.

use std::path::Path;

use crate::{anchor, expand::Block, house::House, output::escape};

/// The text between two anchor comments of `file`, or all of it, as a block of code.
pub(crate) fn block(house: &House, file: &str, anchor: Option<&str>) -> Result<Block, String> {
    let language = language(file)?;
    let text = house.read(file)?;
    let (code, line) = anchor::extract(&text, anchor).map_err(|what| format!("`{file}` {what}"))?;
    // Code may hold fences of its own, in a documentation comment.
    let longest = code.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat((longest + 1).max(3));
    let from = if anchor.is_some() { format!(" <span class=\"from\">from line {line}</span>") } else { String::new() };
    let mut block = Block::default();
    block.push("<figure class=\"listing\">");
    block.push(&format!("<figcaption><code>{}</code>{from}</figcaption>", escape(file)));
    block.push("");
    block.push(&format!("{fence}{language}"));
    block.push(code.trim_end());
    block.push(&fence);
    block.push("");
    block.push("</figure>");
    Ok(block)
}

/// The language of a file, as mdBook's highlighter calls it.
fn language(file: &str) -> Result<&'static str, String> {
    match Path::new(file).extension().and_then(|extension| extension.to_str()) {
        Some("rs") => Ok("rust"),
        Some("toml") => Ok("toml"),
        Some("sh") => Ok("sh"),
        Some("md") => Ok("markdown"),
        Some("txt" | "obj") => Ok("text"),
        _ => Err(format!("`{file}` is no kind of file that can be listed: rs, toml, sh, md, txt or obj")),
    }
}
