//! The house stands as its plan says: who depends on whom, and what lies where.

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The folders of the chapters in their order, with the manifests in them.
fn chapters() -> BTreeMap<String, String> {
    let folders = fs::read_dir(root().join("chapters")).unwrap().map(|f| f.unwrap().path());
    let manifest = |folder: &Path| fs::read_to_string(folder.join("Cargo.toml")).unwrap();
    folders.map(|f| (f.file_name().unwrap().to_str().unwrap().to_string(), manifest(&f))).collect()
}

/// The crates of this workspace that a manifest depends on, but for its tests and benchmarks.
fn dependencies(manifest: &str, ours: &[String]) -> Vec<String> {
    let start = manifest.find("[dependencies]").unwrap();
    let section = manifest[start..].split("\n[").next().unwrap();
    let names = section.lines().filter_map(|line| line.split(['.', ' ', '=']).next());
    names.filter(|name| ours.iter().any(|o| o == name)).map(str::to_string).collect()
}

#[test]
fn every_chapter_is_in_the_list_under_its_number_and_name() {
    let folders: Vec<_> = chapters().into_keys().collect();
    let listed: Vec<_> = course::CHAPTERS.iter().map(|c| format!("{:02}-{}", c.number, c.name)).collect();
    assert_eq!(folders, listed, "folders in chapters/ and CHAPTERS in book/course/src/lib.rs");
    for (folder, manifest) in chapters() {
        assert!(manifest.contains(&format!("name = \"{}\"", &folder[3..])), "{folder}: package name");
    }
}

#[test]
fn chapters_know_only_earlier_ones_and_common_knows_none() {
    let names: Vec<_> = course::CHAPTERS.iter().map(|c| c.name.to_string()).collect();
    let common = fs::read_to_string(root().join("common/Cargo.toml")).unwrap();
    assert_eq!(dependencies(&common, &names), Vec::<String>::new());
    for (i, manifest) in chapters().into_values().enumerate() {
        for used in dependencies(&manifest, &names) {
            assert!(names[..i].contains(&used), "{} may not use {used}", names[i]);
        }
    }
    // The check itself sees a dependency when there is one.
    assert_eq!(dependencies("[dependencies]\nray-casting.workspace = true\n[lints]\n", &names), ["ray-casting"]);
}

#[test]
fn every_chapter_has_its_pages() {
    for folder in chapters().into_keys() {
        assert!(root().join("book/src").join(&folder).join("index.md").is_file(), "book/src/{folder}/index.md");
    }
}

#[test]
fn the_top_level_holds_what_the_plan_says() {
    let expected = ["Cargo.lock", "Cargo.toml", "README.md", "assets", "book", "chapters", "common", "tests"];
    let tolerated = ["target", "pictures", "clippy.toml", "rustfmt.toml", "CHANGELOG.md", "CONTRIBUTING.md"];
    for entry in fs::read_dir(root()).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let known = expected.contains(&name.as_str()) || tolerated.contains(&name.as_str());
        assert!(known || name.starts_with('.') || name.starts_with("LICENSE"), "what is {name} doing here?");
    }
    assert!(expected.iter().all(|name| root().join(name).exists()));
}

/// The front page shows every chapter with its cover.
#[test]
fn the_readme_shows_every_chapter() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    for chapter in course::CHAPTERS {
        let cover = format!("tests/snapshots/{}/{}.snap.png", chapter.name, chapter.pictures[0].name);
        assert!(readme.contains(&cover) && readme.contains(&format!("`{}`", chapter.name)), "{}", chapter.name);
        assert!(root().join(cover).is_file());
    }
    for line in readme.lines().filter(|l| l.starts_with("cargo run -p")) {
        let words: Vec<_> = line.split('#').next().unwrap().split_whitespace().collect();
        let chapter = course::CHAPTERS.iter().find(|c| c.name == words[3]).unwrap();
        let picture = words.get(5).filter(|w| !w.starts_with('-'));
        assert!(picture.is_none_or(|p| chapter.picture(p).is_some()), "{line}");
    }
}
