//! `{{#number chapter/name}}`: a number that a test has measured and pinned, in the middle of a sentence.

use crate::house::{House, chapter_and_name, these};

/// The pinned value of `chapter/name`, from the lines `name = value` of `tests/numbers/chapter.txt`.
pub(crate) fn value(house: &House, name: &str) -> Result<String, String> {
    let (chapter, name) = chapter_and_name(name, "name")?;
    let chapter = house.chapter(chapter)?.name;
    let file = format!("tests/numbers/{chapter}.txt");
    let text = house.read(&file)?;
    let numbers = || {
        let lines = text.lines().map(|line| line.split('#').next().unwrap_or(line));
        lines.filter_map(|line| line.split_once('=')).map(|(name, value)| (name.trim(), value.trim()))
    };
    match numbers().find(|(known, _)| *known == name) {
        Some((_, "")) => Err(format!("`{name}` has no value in `{file}`")),
        Some((_, value)) => Ok(value.to_owned()),
        None => Err(format!("there is no number `{name}` in `{file}`: {}", these("number", numbers().map(|(n, _)| n)))),
    }
}
