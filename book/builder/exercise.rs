//! `{{#exercise 1.2}}`: an exercise as a reader meets it: the task, how to start, and hints that unfold one by one.
//!
//! The task is the documentation of the stub, so that the book and the file that a student opens say the same.

use std::{fs, sync::Arc};

use common::picture::Chapter;

use crate::{
    error::Place,
    expand::Block,
    house::{House, folder, these},
};

/// The files of an exercise.
struct Exercise {
    /// Its number, such as `1.2`.
    number: String,
    /// The stub, relative to the root.
    stub: String,
    /// The hints, relative to the root.
    hints: String,
}

/// Task and hints of an exercise.
pub(crate) fn block(house: &House, number: &str) -> Result<Block, String> {
    let exercise = find(house, number)?;
    let mut block = task(house, &exercise)?;
    block.push(&format!(
        "\nStart in `{}`, and let it be checked:\n\n```sh\ncargo exercise {number}\n```\n",
        exercise.stub
    ));
    block.append(hints(house, &exercise)?);
    Ok(block)
}

/// The exercises of a chapter by the files in its folder: number and stub, relative to the root.
pub(crate) fn all(house: &House, chapter: &Chapter) -> Vec<(String, String)> {
    let place = format!("chapters/{}/exercises", folder(chapter));
    let entries = fs::read_dir(house.path(&place)).into_iter().flatten().flatten();
    let mut found: Vec<_> = entries
        .filter_map(|entry| {
            let file = entry.file_name().into_string().ok()?;
            let number: u32 = file.strip_suffix(".rs")?.split_once('-')?.0.parse().ok()?;
            Some((number, format!("{place}/{file}")))
        })
        .collect();
    found.sort();
    found.into_iter().map(|(number, file)| (format!("{}.{number}", chapter.number), file)).collect()
}

/// The files of the exercise with that number.
fn find(house: &House, number: &str) -> Result<Exercise, String> {
    let wrong = || format!("`{number}` is no number of an exercise: write chapter and number, such as `1.2`");
    let (chapter, _) = number.split_once('.').ok_or_else(wrong)?;
    let chapter: u32 = chapter.parse().map_err(|_| wrong())?;
    let chapter = house.chapters.iter().find(|c| c.number == chapter);
    let chapter = chapter.ok_or_else(|| format!("there is no chapter for exercise {number}"))?;
    let all = all(house, chapter);
    let Some((_, stub)) = all.iter().find(|(n, _)| n == number) else {
        let known = these("exercise", all.iter().map(|(n, _)| n.as_str()));
        return Err(format!("there is no exercise {number} in `chapters/{}/exercises`: {known}", folder(chapter)));
    };
    let hints = stub.replace("/exercises/", "/exercises/hints/").replace(".rs", ".md");
    Ok(Exercise { number: number.to_owned(), stub: stub.clone(), hints })
}

/// The documentation of the stub, its first line as a heading.
fn task(house: &House, Exercise { number, stub, .. }: &Exercise) -> Result<Block, String> {
    let text = house.read(stub)?;
    let file: Arc<str> = stub.as_str().into();
    let documentation = |line: &str| {
        let text = line.trim_end().strip_prefix("//!")?;
        Some(text.strip_prefix(' ').unwrap_or(text).to_owned())
    };
    let mut lines = text.lines().map_while(documentation);
    let start = format!("# Exercise {number}: ");
    let title = lines.next().and_then(|line| Some(line.strip_prefix(&start)?.to_owned()));
    let title = title.ok_or_else(|| format!("`{stub}` does not start with `//! {start}title`"))?;
    let mut block = Block::default();
    let id = number.replace('.', "-");
    block.push_from(&format!("## Exercise {number}: {title} {{#exercise-{id}}}"), Place::new(&file, 1));
    let mut is_code = false;
    let mut is_empty = true;
    for (index, line) in lines.enumerate() {
        is_code ^= line.trim_start().starts_with("```");
        is_empty &= line.trim().is_empty();
        if line.contains("{{#") {
            return Err(format!("line {} of `{stub}` has a directive, which only a page can have", index + 2));
        }
        let line = if is_code { line } else { without_links(&line) };
        // A heading of the stub stands below the heading of the exercise.
        let line = if !is_code && line.starts_with('#') { format!("#{line}") } else { line };
        block.push_from(&line, Place::new(&file, index + 2));
    }
    if is_empty { Err(format!("`{stub}` has no task below its title")) } else { Ok(block) }
}

/// Links of rustdoc to items of the code, ``[`Name`]`` and ``[`Name`](path)``, as code without a link.
fn without_links(line: &str) -> String {
    let mut plain = String::new();
    let mut rest = line;
    while let Some((before, after)) = rest.split_once("[`") {
        plain.push_str(before);
        let Some((name, after)) = after.split_once("`]") else {
            rest = &rest[before.len()..];
            break;
        };
        plain.push_str(&format!("`{name}`"));
        rest = after;
        if let Some((_, after)) = rest.strip_prefix('(').and_then(|path| path.split_once(')')) {
            rest = after;
        }
    }
    plain + rest
}

/// The hints, each folded.
fn hints(house: &House, Exercise { hints, .. }: &Exercise) -> Result<Block, String> {
    let text = house.read(hints)?;
    let file: Arc<str> = hints.as_str().into();
    let numbered: Vec<_> = text.lines().enumerate().collect();
    let mut block = Block::default();
    for (index, hint) in numbered.split(|(_, line)| line.trim() == "---").enumerate() {
        if hint.iter().all(|(_, line)| line.trim().is_empty()) {
            return Err(format!("hint {} of `{hints}` is empty: hints are parted by a line `---`", index + 1));
        }
        block.push(&format!("<details class=\"hint\">\n<summary>Hint {}</summary>\n", index + 1));
        for (line, text) in hint {
            block.push_from(text, Place::new(&file, line + 1));
        }
        block.push("\n</details>\n");
    }
    Ok(block)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_of_rustdoc_become_code() {
        assert_eq!(
            without_links("See [`Shape`] and [`Hit`](crate::hit::Hit), not [x](y)."),
            "See `Shape` and `Hit`, not [x](y)."
        );
        assert_eq!(without_links("an open [`end"), "an open [`end");
    }
}
