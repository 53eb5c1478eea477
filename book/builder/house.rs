//! The house that the book is about: where its files are, and which chapters it has.

use std::{
    fs, io,
    path::{Path, PathBuf},
};

use common::picture::{Chapter, Picture};

/// A workspace and the chapters that are registered in it.
pub(crate) struct House {
    root: PathBuf,
    /// The chapters in their order.
    pub(crate) chapters: &'static [Chapter],
}

impl House {
    /// The house in a folder.
    pub(crate) fn new(root: &Path, chapters: &'static [Chapter]) -> Self {
        Self { root: root.to_owned(), chapters }
    }

    /// The path of a file that is named relative to the root.
    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.root.join(name)
    }

    /// The folder of the Markdown pages.
    pub(crate) fn pages(&self) -> PathBuf {
        self.path("book/src")
    }

    /// The text of a file that is named relative to the root; the error is what to tell the author.
    pub(crate) fn read(&self, name: &str) -> Result<String, String> {
        if name.starts_with('/') || name.split(['/', '\\']).any(|part| part == "..") {
            return Err(format!("`{name}` is no path inside the workspace: start from its root, without `..`"));
        }
        fs::read_to_string(self.path(name)).map_err(|error| match error.kind() {
            io::ErrorKind::NotFound => format!("there is no file `{name}` in the workspace"),
            _ => format!("`{name}` cannot be read: {error}"),
        })
    }

    /// The chapter of that name.
    pub(crate) fn chapter(&self, name: &str) -> Result<&'static Chapter, String> {
        self.chapters.iter().find(|chapter| chapter.name == name).ok_or_else(|| {
            format!("there is no chapter `{name}`: {}", these("chapter", self.chapters.iter().map(|c| c.name)))
        })
    }

    /// The picture that is named `chapter/picture`.
    pub(crate) fn picture(&self, name: &str) -> Result<(&'static Chapter, &'static Picture), String> {
        let (chapter, picture) = chapter_and_name(name, "picture")?;
        let chapter = self.chapter(chapter)?;
        let found = chapter.picture(picture).ok_or_else(|| {
            let known = these("picture", chapter.pictures.iter().map(|p| p.name));
            format!("there is no picture `{picture}` in `{}`: {known}", chapter.name)
        })?;
        Ok((chapter, found))
    }
}

/// The last folder of a chapter's paths, such as `01-ray-casting`.
pub(crate) fn folder(chapter: &Chapter) -> String {
    format!("{:02}-{}", chapter.number, chapter.name)
}

/// Take `chapter/name` apart.
pub(crate) fn chapter_and_name<'a>(text: &'a str, kind: &str) -> Result<(&'a str, &'a str), String> {
    text.split_once('/').ok_or_else(|| format!("`{text}` names no chapter: write `chapter/{kind}`"))
}

/// What there is instead of what was asked for.
pub(crate) fn these<'a>(kind: &str, names: impl IntoIterator<Item = &'a str>) -> String {
    let names: Vec<_> = names.into_iter().map(|name| format!("`{name}`")).collect();
    match names.as_slice() {
        [] => format!("there is no {kind} yet"),
        names => format!("there is {}", names.join(", ")),
    }
}

/// All files under a folder, in a fixed order; none if the folder is not there.
pub(crate) fn files_under(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut entries: Vec<_> = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            found.extend(files_under(&path));
        } else {
            found.push(path);
        }
    }
    found
}

/// A path relative to `root`, with slashes on every system.
pub(crate) fn name_of(path: &Path, root: &Path) -> String {
    let path = path.strip_prefix(root).unwrap_or(path);
    path.components().map(|part| part.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("/")
}
