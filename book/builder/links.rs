//! Whether what the written pages refer to is there, and nothing of it in a network.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
};

use crate::{
    house::{files_under, name_of},
    html::{Tag, decode, loads, scan},
};

/// A written page: what it can be linked at, and what it refers to.
#[derive(Default)]
struct Page {
    ids: BTreeSet<String>,
    links: Vec<String>,
    /// Whether its addresses start at the root of the book.
    is_based_at_root: bool,
}

/// What is wrong with the references of the book that was written to `out`.
pub(crate) fn problems(out: &Path) -> Vec<String> {
    let mut problems = Vec::new();
    let mut pages = BTreeMap::new();
    for path in files_under(out) {
        let name = name_of(&path, out);
        let text = || String::from_utf8_lossy(&fs::read(&path).unwrap_or_default()).into_owned();
        match path.extension().and_then(|extension| extension.to_str()) {
            Some("html") => {
                let page = read(&name, &text(), &mut problems);
                pages.insert(path, page);
            }
            Some("css") => problems.extend(style(&text(), &path, &name)),
            _ => {}
        }
    }
    for (path, page) in &pages {
        let name = name_of(path, out);
        let broken = page.links.iter().filter_map(|link| Some((link, follow(link, path, page, out, &pages).err()?)));
        problems.extend(broken.map(|(link, what)| format!("{name}: `{link}` {what}")));
    }
    // The page for printing repeats all others, and says something new only if they are sound.
    let is_repeated = |problem: &String| problem.starts_with("print.html:");
    if !problems.iter().all(is_repeated) {
        problems.retain(|problem| !is_repeated(problem));
    }
    problems
}

/// Read a page, and tell what is wrong with it by itself.
fn read(name: &str, text: &str, problems: &mut Vec<String>) -> Page {
    let mut page = Page::default();
    let (tags, styles) = scan(text);
    for tag in &tags {
        page.ids.extend(tag.attribute("id").map(str::to_owned));
        page.is_based_at_root |= tag.name == "base";
        if tag.name == "img" && tag.attribute("alt").is_none_or(|alt| alt.trim().is_empty()) {
            let source = tag.attribute("src").unwrap_or("");
            problems.push(format!("{name}: the image `{source}` has no text for those who cannot see it (`alt`)"));
        }
        for address in resources(tag) {
            if is_remote(address) {
                problems.push(format!("{name}: `{address}` needs a network: put the file into the book"));
            } else {
                page.links.push(address.to_owned());
            }
        }
        if tag.name == "a" {
            page.links.extend(tag.attribute("href").filter(|href| !has_scheme(href)).map(str::to_owned));
        }
    }
    for address in styles.into_iter().flat_map(loads).filter(|address| is_remote(address)) {
        problems.push(format!("{name}: `{address}` needs a network: put the file into the book"));
    }
    page
}

/// What a browser loads because of a tag.
fn resources<'a>(tag: &'a Tag<'_>) -> impl Iterator<Item = &'a str> {
    let is_link = tag.name == "link";
    let href = tag.attribute("href").filter(|_| is_link);
    let style = tag.attribute("style").into_iter().flat_map(loads);
    let set =
        tag.attribute("srcset").into_iter().flat_map(|set| set.split(',').filter_map(|s| s.split_whitespace().next()));
    [
        href,
        tag.attribute("src"),
        tag.attribute("data-module"),
        tag.attribute("poster"),
        tag.attribute("data").filter(|_| tag.name == "object"),
    ]
    .into_iter()
    .flatten()
    .chain(style)
    .chain(set)
    .filter(|address| !address.starts_with("data:"))
}

/// Whether an address starts with `http:`, `mailto:` and the like.
fn has_scheme(address: &str) -> bool {
    let scheme = address.split(['/', '#', '?']).next().unwrap_or("");
    scheme.contains(':') || address.starts_with("//")
}

/// Whether an address lies in a network.
fn is_remote(address: &str) -> bool {
    has_scheme(address) && !address.starts_with("data:")
}

/// What is wrong with a style sheet.
fn style(css: &str, path: &Path, name: &str) -> Vec<String> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let local = loads(css).into_iter().filter(|address| !address.starts_with("data:") && !address.starts_with('#'));
    local
        .filter_map(|address| {
            let file = address.split(['?', '#']).next().unwrap_or("");
            if is_remote(address) {
                Some(format!("{name}: `{address}` needs a network: put the file into the book"))
            } else if folder.join(decode(file)).is_file() {
                None
            } else {
                Some(format!("{name}: `{address}` leads to no file"))
            }
        })
        .collect()
}

/// Follow a link from a page to a file and a place in it.
fn follow(link: &str, from: &Path, page: &Page, out: &Path, pages: &BTreeMap<PathBuf, Page>) -> Result<(), String> {
    let (address, fragment) = link.split_once('#').map_or((link, None), |(a, f)| (a, Some(decode(f))));
    let address = decode(address.split('?').next().unwrap_or(""));
    let folder = if page.is_based_at_root { out } else { from.parent().unwrap_or(out) };
    let target = if address.is_empty() {
        from.to_owned()
    } else if address.starts_with('/') && !page.is_based_at_root {
        return Err("starts at the root of a server: the book is also read from disk, so write it relative".into());
    } else {
        flatten(&folder.join(address.trim_start_matches('/')))
    };
    if !target.starts_with(out) {
        return Err("leads out of the book".into());
    }
    let target = if target.is_dir() { target.join("index.html") } else { target };
    if !target.is_file() {
        return Err("leads to no file".into());
    }
    match (fragment.filter(|f| !f.is_empty()), pages.get(&target)) {
        (Some(id), Some(page)) if !page.ids.contains(&id) => Err(format!("leads to a page without the anchor `{id}`")),
        _ => Ok(()),
    }
}

/// A path without `.` and `..`.
fn flatten(path: &Path) -> PathBuf {
    let mut flat = PathBuf::new();
    for part in path.components() {
        match part {
            std::path::Component::ParentDir => {
                flat.pop();
            }
            std::path::Component::CurDir => {}
            part => flat.push(part),
        }
    }
    flat
}
