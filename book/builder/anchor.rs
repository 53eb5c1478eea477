//! Anchors: the comments in a source file between which a page shows it.

use crate::house::these;

/// The lines of a file between `ANCHOR: name` and `ANCHOR_END: name`.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Anchor<'a> {
    /// Its name.
    pub(crate) name: &'a str,
    /// The line of its start, from 1.
    pub(crate) start: usize,
    /// The line of its end, from 1; `None` if it is not closed.
    pub(crate) end: Option<usize>,
}

/// The start or the end of an anchor.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Marker<'a> {
    Start(&'a str),
    End(&'a str),
}

/// The anchor comment in a line.
fn marker(line: &str) -> Option<Marker<'_>> {
    let name = |text: &'_ str| -> usize {
        text.find(|c: char| !c.is_alphanumeric() && c != '_' && c != '-').unwrap_or(text.len())
    };
    let (is_end, text) = match line.split_once("ANCHOR_END:") {
        Some((_, text)) => (true, text.trim_start()),
        None => (false, line.split_once("ANCHOR:")?.1.trim_start()),
    };
    let name = &text[..name(text)];
    Some(if is_end { Marker::End(name) } else { Marker::Start(name) })
}

/// The anchors of a file, and what is wrong with them: the line and what would be right.
pub(crate) fn scan(text: &str) -> (Vec<Anchor<'_>>, Vec<(usize, String)>) {
    let (mut anchors, mut wrong): (Vec<Anchor<'_>>, Vec<(usize, String)>) = (Vec::new(), Vec::new());
    for (line, marker) in text.lines().enumerate().filter_map(|(index, line)| Some((index + 1, marker(line)?))) {
        match marker {
            Marker::Start("") | Marker::End("") => wrong.push((line, "an anchor has a name: `ANCHOR: name`".into())),
            Marker::Start(name) if anchors.iter().any(|a| a.name == name) => {
                wrong.push((line, format!("a second anchor `{name}`: names are unique in a file")));
            }
            Marker::Start(name) => anchors.push(Anchor { name, start: line, end: None }),
            Marker::End(name) => match anchors.iter_mut().find(|a| a.name == name && a.end.is_none()) {
                Some(anchor) => anchor.end = Some(line),
                None => wrong.push((line, format!("the end of an anchor `{name}` that has not started"))),
            },
        }
    }
    for Anchor { name, start, .. } in anchors.iter().filter(|a| a.end.is_none()) {
        wrong.push((*start, format!("the anchor `{name}` is not closed: end it with `ANCHOR_END: {name}`")));
    }
    (anchors, wrong)
}

/// The text of an anchor, or of the whole file, as it is shown: without anchor comments and without the indentation
/// that all lines share. With it comes the line where it starts.
pub(crate) fn extract(text: &str, name: Option<&str>) -> Result<(String, usize), String> {
    let (first, last) = match name {
        None => (0, usize::MAX),
        Some(name) => {
            let (anchors, wrong) = scan(text);
            let Some(anchor) = anchors.iter().find(|a| a.name == name) else {
                return Err(format!("has no anchor `{name}`: {}", these("anchor", anchors.iter().map(|a| a.name))));
            };
            let trouble = wrong.into_iter().find(|(_, what)| what.contains(&format!("`{name}`")));
            if let Some((line, what)) = trouble {
                return Err(format!("line {line}: {what}"));
            }
            (anchor.start, anchor.end.map_or(usize::MAX, |end| end - 1))
        }
    };
    let shown = || text.lines().enumerate().take(last).skip(first).filter(|(_, line)| marker(line).is_none());
    // Blank lines at both ends are no part of what is shown.
    let mut lines: Vec<_> = shown().skip_while(|(_, line)| line.trim().is_empty()).collect();
    while lines.last().is_some_and(|(_, line)| line.trim().is_empty()) {
        lines.pop();
    }
    let Some((start, _)) = lines.first() else { return Err("shows nothing: there is no line to show".into()) };
    let indentation = |line: &str| line.len() - line.trim_start().len();
    let shared = lines.iter().filter(|(_, l)| !l.trim().is_empty()).map(|(_, l)| indentation(l)).min().unwrap_or(0);
    let mut extracted = String::new();
    for (_, line) in &lines {
        extracted.push_str(line.get(shared..).unwrap_or("").trim_end());
        extracted.push('\n');
    }
    Ok((extracted, start + 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOURCE: &str = "\
//! Sphere.

// ANCHOR: sphere
pub struct Sphere;
// ANCHOR_END: sphere

impl Sphere {
    // ANCHOR: intersect
    fn intersect() {
        // ANCHOR: roots
        let q = 1;

        // ANCHOR_END: roots
    }
    // ANCHOR_END: intersect
}
";

    #[test]
    fn text_is_exactly_what_stands_between() {
        assert_eq!(extract(SOURCE, Some("sphere")), Ok(("pub struct Sphere;\n".into(), 4)));
        let intersect = "fn intersect() {\n    let q = 1;\n\n}\n";
        assert_eq!(extract(SOURCE, Some("intersect")), Ok((intersect.into(), 9)));
        assert_eq!(extract(SOURCE, Some("roots")), Ok(("let q = 1;\n".into(), 11)));
    }

    #[test]
    fn whole_file_is_shown_without_markers() {
        let (text, start) = extract(SOURCE, None).unwrap();
        assert_eq!(start, 1);
        assert!(text.starts_with("//! Sphere.\n\npub struct Sphere;\n\nimpl Sphere {\n    fn intersect()"), "{text}");
        assert!(!text.contains("ANCHOR"));
    }

    #[test]
    fn mistakes_are_named() {
        assert_eq!(
            extract(SOURCE, Some("cube")),
            Err("has no anchor `cube`: there is `sphere`, `intersect`, `roots`".into())
        );
        let open = extract("// ANCHOR: a\nx\n", Some("a")).unwrap_err();
        assert_eq!(open, "line 1: the anchor `a` is not closed: end it with `ANCHOR_END: a`");
        let empty = extract("// ANCHOR: a\n\n// ANCHOR_END: a\n", Some("a")).unwrap_err();
        assert!(empty.contains("nothing"), "{empty}");
        assert!(extract("\n\n", None).is_err());
        let (_, wrong) = scan("// ANCHOR_END: b\n// ANCHOR: a\n// ANCHOR: a\n// ANCHOR_END: a\n// ANCHOR:\n");
        assert_eq!(wrong.iter().map(|(line, _)| *line).collect::<Vec<_>>(), [1, 3, 5]);
    }
}
