//! The experiments of chapter 5 and their files: a table of all values and a plot.

use std::{fs, path::Path};

use common::knob::Kind;
use tempfile::TempDir;

use crate::reports::run;

/// An experiment of chapter 5 with little effort.
fn experiment(folder: &Path, arguments: &[&str]) -> (i32, String, String) {
    let little = ["--set", "samples=10000", "--set", "runs=4", "--set", "trials=1000"];
    run("sampling", folder, &[&["--experiment"], arguments, &little].concat())
}

/// All experiments, from the one place that knows them.
fn experiments() -> Vec<&'static str> {
    let chapter = course::CHAPTERS.iter().find(|chapter| chapter.name == "sampling").unwrap();
    let report = chapter.reports.iter().find(|report| report.name == "experiment").unwrap();
    let Kind::Choice { options, .. } = report.subject.unwrap().kind else { panic!("experiments have names") };
    options.to_vec()
}

#[test]
fn experiments_write_their_values_and_their_plot_where_they_are_told() {
    for name in experiments() {
        let folder = TempDir::new().unwrap();
        let (code, alone, stderr) = experiment(folder.path(), &[name]);
        assert_eq!((code, stderr.as_str(), fs::read_dir(&folder).unwrap().count()), (0, "", 0), "{name}");
        let (code, stdout, stderr) = experiment(folder.path(), &[name, "--output", "new/measured"]);
        // What is written changes nothing of what is told.
        assert_eq!((code, stdout == alone), (0, true), "{name}: {stderr}");
        let measured = folder.path().join("new/measured");
        let mut files: Vec<_> =
            fs::read_dir(&measured).unwrap().map(|f| f.unwrap().file_name().into_string().unwrap()).collect();
        files.sort();
        assert_eq!(files, [format!("{name}.csv"), format!("{name}.svg")]);
        let places: Vec<_> = files.iter().map(|file| Path::new("new/measured").join(file)).collect();
        let said: Vec<_> = places.iter().map(|place| format!("Wrote {}.", place.display())).collect();
        assert_eq!(stderr.lines().collect::<Vec<_>>(), said);
        is_table(&fs::read_to_string(measured.join(&files[0])).unwrap());
        is_plot(&fs::read_to_string(measured.join(&files[1])).unwrap());
        // Once more, over what is there; quietly; and with the same bytes.
        let before: Vec<_> = files.iter().map(|file| fs::read(measured.join(file)).unwrap()).collect();
        let (code, _, stderr) = experiment(folder.path(), &[name, "--output", "new/measured", "--quiet"]);
        assert_eq!((code, stderr.as_str()), (0, ""), "{name}");
        let after: Vec<_> = files.iter().map(|file| fs::read(measured.join(file)).unwrap()).collect();
        assert!(before == after && fs::read_dir(&measured).unwrap().count() == 2, "{name}");
    }
}

/// A line of three names, then lines of a name and two finite numbers.
fn is_table(csv: &str) {
    let mut lines = csv.lines();
    assert!(lines.next().unwrap().starts_with("line,") && csv.ends_with('\n'), "{csv}");
    assert!(lines.clone().count() > 5, "{csv}");
    for line in lines {
        let [name, x, y] = line.split(',').collect::<Vec<_>>()[..] else { panic!("{line}") };
        assert!(!name.is_empty() && [x, y].iter().all(|x| x.parse::<f64>().unwrap().is_finite()), "{line}");
    }
}

/// A drawing in which every element that is opened is closed, and every number is one.
fn is_plot(svg: &str) {
    assert!(
        svg.starts_with("<svg ")
            && svg.contains("xmlns=\"http://www.w3.org/2000/svg\"")
            && svg.trim_end().ends_with("</svg>")
    );
    assert!(!svg.contains("NaN") && !svg.contains("inf") && svg.contains("<polyline "));
    let mut open = Vec::new();
    for tag in svg.split('<').skip(1) {
        let (inside, text) = tag.split_once('>').unwrap();
        assert!(!text.contains('>') && inside.matches('"').count() % 2 == 0, "{tag}");
        let name = inside.trim_start_matches('/').split([' ', '/', '\n']).next().unwrap();
        if inside.starts_with('/') {
            assert_eq!(open.pop(), Some(name), "{tag}");
        } else if !inside.ends_with('/') {
            open.push(name);
        }
    }
    assert_eq!(open, Vec::<&str>::new());
}

#[test]
fn wrong_experiments_and_folders_are_explained_in_one_line() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("file"), "mine").unwrap();
    for (arguments, code, parts) in [
        (vec!["mean-cosinus"], 2, vec!["mean-cosinus", "one of dimension, "]),
        (vec!["mean-cosine", "--output", "file"], 1, vec!["file"]),
        (vec!["mean-cosine", "--output", "file/below"], 1, vec!["file/below"]),
        (vec!["mean-cosine", "--output", "-"], 2, vec!["--output takes a folder"]),
        (vec!["mean-cosine", "--set", "integral=moon"], 2, vec!["integral", "one of "]),
    ] {
        let (actual, stdout, stderr) = experiment(folder.path(), &arguments);
        assert_eq!((actual, stdout.as_str(), stderr.lines().count()), (code, "", 1), "{arguments:?}: {stderr}");
        for part in parts.iter().chain(&["error: "]) {
            assert!(stderr.contains(part), "{arguments:?}: '{part}' is missing in: {stderr}");
        }
    }
    assert_eq!(fs::read_to_string(folder.path().join("file")).unwrap(), "mine");
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 1, "nothing may be written");
}
