//! What the pages and the README tell a reader to type is understood by the programs.

use std::{
    fs,
    path::{Path, PathBuf},
    process::{Command, Stdio},
};

use tempfile::TempDir;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize().unwrap()
}

/// The README and all pages.
fn pages() -> Vec<PathBuf> {
    let (mut pages, mut folders) = (vec![root().join("README.md")], vec![root().join("book/src")]);
    while let Some(folder) = folders.pop() {
        for path in fs::read_dir(folder).unwrap().map(|f| f.unwrap().path()) {
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "md") {
                pages.push(path);
            }
        }
    }
    pages
}

/// The lines of a page that run a chapter, as words behind `cargo run -p`.
fn commands(page: &str) -> Vec<Vec<String>> {
    let lines = page.lines().map(|line| line.trim_start_matches("> "));
    let commands = lines.filter_map(|line| line.strip_prefix("cargo run -p "));
    let commands = commands.map(|line| words(line.split(" #").next().unwrap()));
    commands.filter(|words| !words.contains(&"--bin".into())).collect()
}

/// Words as a shell parts them, as far as pages need it.
fn words(line: &str) -> Vec<String> {
    let quoted = line.split('"').enumerate();
    let mut words = vec![String::new()];
    for (i, part) in quoted {
        if i % 2 == 1 {
            words.last_mut().unwrap().push_str(part);
            continue;
        }
        for (j, word) in part.split(' ').enumerate() {
            if j > 0 {
                words.push(String::new());
            }
            words.last_mut().unwrap().push_str(word);
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

/// The same command for a small picture, quickly made, in a file that nobody needs.
fn quick(words: &[String]) -> Vec<String> {
    let mut arguments: Vec<String> = Vec::new();
    let asks_a_pixel = words.iter().any(|word| word == "--pixel");
    // A report makes no picture. Each has knobs that make it quick.
    const REPORTS: [(&str, &[&str]); 2] =
        [("--compare", &["rays=100"]), ("--experiment", &["samples=10000", "runs=4", "trials=1000"])];
    let report = REPORTS.iter().find(|(name, _)| words.iter().any(|word| word == name));
    let mut rest = words.iter().skip_while(|word| *word != "--").skip(1);
    while let Some(word) = rest.next() {
        match word.as_str() {
            // A pixel belongs to a size.
            "--size" if asks_a_pixel => arguments.push(word.clone()),
            // A lone sample has no error, and nobody needs its state.
            "--size" | "--samples" | "--output" | "--until-error" | "--save-state" | "--resume" => drop(rest.next()),
            "--no-window" => {}
            "your.obj" => arguments.push("assets/gem.obj".into()),
            _ => arguments.push(word.clone()),
        }
    }
    if let Some((_, quick)) = report {
        arguments.extend(quick.iter().flat_map(|set| ["--set".into(), String::from(*set)]));
        arguments.push("--quiet".into());
        return arguments;
    }
    arguments.extend(["--samples".into(), "1".into()]);
    if !asks_a_pixel {
        arguments.extend(["--no-window", "--size", "16x9", "--output"].map(String::from));
    }
    arguments
}

#[test]
fn every_command_of_the_pages_works() {
    let folder = TempDir::new().unwrap();
    let picture = folder.path().join("picture.png");
    let (mut tried, mut wrong) = (0, Vec::new());
    for page in pages() {
        for words in commands(&fs::read_to_string(&page).unwrap()) {
            let mut command = Command::new(env!("CARGO_BIN_EXE_chapter"));
            command.arg(&words[0]).current_dir(root()).stdin(Stdio::null()).stdout(Stdio::null());
            if words.iter().any(|word| word == "--list") {
                command.arg("--list");
            } else {
                let arguments = quick(&words);
                command.args(&arguments);
                if arguments.last().is_some_and(|word| word == "--output") {
                    command.arg(&picture);
                }
            }
            let output = command.output().unwrap();
            if !output.status.success() {
                let error = String::from_utf8_lossy(&output.stderr);
                wrong.push(format!("{}: {}: {error}", page.display(), words.join(" ")));
            }
            tried += 1;
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(tried > 80, "only {tried} commands found");
}

#[test]
fn words_are_parted_as_by_a_shell() {
    assert_eq!(words("a -- b --set \"c=d e\" f"), ["a", "--", "b", "--set", "c=d e", "f"]);
    let found = commands("text\n> cargo run -p x -- y   # why\ncargo run -p x --bin z\n");
    assert_eq!(found, [["x", "--", "y"]]);
}
