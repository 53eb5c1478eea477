//! The build: pages are expanded, mdBook writes them, formulas, diagrams and pictures are put in.

use std::{
    fs,
    path::{Path, PathBuf},
};

use mdbook_driver::{MDBook, book::BookItem, config::Config, errors::Error};

use crate::{
    error::{BookError, Mistake},
    expand::Page,
    figure,
    house::{House, files_under, name_of},
    live::Module,
    math,
    output::{Medium, Output},
    warnings,
};

/// A file that mdBook writes into every book.
const MARK: &str = ".nojekyll";

/// Build the book of a house into `out`, which is replaced as a whole or not at all.
pub(crate) fn build(house: &House, out: &Path) -> Result<(), BookError> {
    let is_empty = fs::read_dir(out).map_or(true, |mut entries| entries.next().is_none());
    if !is_empty && !out.join(MARK).exists() {
        return Err(BookError::NotABook(out.to_owned()));
    }
    let new = beside(out);
    remove(&new)?;
    let built = write(house, &new).and_then(|()| {
        remove(out)?;
        fs::rename(&new, out).map_err(BookError::file(out))
    });
    if built.is_err() {
        // The first error is the one to tell.
        let _ = remove(&new);
    }
    built
}

/// A folder beside `out`, so that renaming it moves no data.
fn beside(out: &Path) -> PathBuf {
    let name = out.file_name().map_or_else(|| "book".into(), |name| name.to_string_lossy().into_owned());
    out.with_file_name(format!("{name}.new"))
}

/// Remove a folder if it is there.
fn remove(folder: &Path) -> Result<(), BookError> {
    if folder.exists() { fs::remove_dir_all(folder).map_err(BookError::file(folder)) } else { Ok(()) }
}

/// Write the whole book into a new folder.
fn write(house: &House, out: &Path) -> Result<(), BookError> {
    let root = house.path("book");
    let out = std::path::absolute(out).map_err(BookError::file(out))?;
    let mut config = Config::from_disk(root.join("book.toml")).map_err(|error| md_book(&error))?;
    config.build.build_dir.clone_from(&out);
    let (book, warnings) = warnings::collect(|| MDBook::load_with_config(&root, config));
    let mut book = book.map_err(|error| md_book(&error))?;
    refuse(warnings)?;

    let output = expand(house, &mut book)?;
    let (built, warnings) = warnings::collect(|| book.build());
    built.map_err(|error| md_book(&error))?;
    refuse(warnings)?;

    fill(&out, &output)?;
    if let Some(module) = &output.module {
        module.write(&out)?;
    }
    copy_pictures(house, &out, &output)
}

/// What mdBook said, with its causes, in one line.
fn md_book(error: &Error) -> BookError {
    BookError::MdBook(format!("{error:#}").split_whitespace().collect::<Vec<_>>().join(" "))
}

/// What mdBook warns of is a mistake.
fn refuse(warnings: Vec<String>) -> Result<(), BookError> {
    if warnings.is_empty() { Ok(()) } else { Err(BookError::Warnings(warnings)) }
}

/// Replace directives and formulas in all pages.
fn expand(house: &House, book: &mut MDBook) -> Result<Output, BookError> {
    let mut output = Output::new(Module::of(house));
    let mut mistakes: Vec<Mistake> = Vec::new();
    book.book.for_each_mut(|item| {
        if let BookItem::Chapter(chapter) = item
            && let Some(path) = &chapter.source_path
        {
            let page = Page { house, path: &name_of(path, Path::new("")) };
            let expanded = page.expand(&chapter.content, &mut output);
            match expanded.and_then(|lines| math::replace(&lines, &mut output)) {
                Ok(markdown) => chapter.content = markdown,
                Err(wrong) => mistakes.extend(wrong),
            }
        }
    });
    if mistakes.is_empty() { Ok(output) } else { Err(BookError::Mistakes(mistakes)) }
}

/// Put formulas and diagrams into the written pages.
fn fill(out: &Path, output: &Output) -> Result<(), BookError> {
    for path in files_under(out).into_iter().filter(|path| path.extension().is_some_and(|e| e == "html")) {
        let page = fs::read_to_string(&path).map_err(BookError::file(&path))?;
        let medium = if path == out.join("print.html") { Medium::Paper } else { Medium::Screen };
        fs::write(&path, output.fill(&page, medium)).map_err(BookError::file(&path))?;
    }
    Ok(())
}

/// Put the pictures that are shown into the book.
fn copy_pictures(house: &House, out: &Path, output: &Output) -> Result<(), BookError> {
    for (chapter, picture) in output.pictures.iter().filter_map(|name| name.split_once('/')) {
        let folder = out.join("pictures").join(chapter);
        fs::create_dir_all(&folder).map_err(BookError::file(&folder))?;
        let snapshot = house.path(&figure::snapshot(chapter, picture));
        fs::copy(&snapshot, folder.join(format!("{picture}.png"))).map_err(BookError::file(&snapshot))?;
    }
    Ok(())
}
