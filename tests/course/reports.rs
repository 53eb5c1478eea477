//! The reports of all chapters, asked for rightly and wrongly.

use std::{
    fs,
    path::Path,
    process::{Command, Stdio},
};

use common::{
    knob::{Kind, Step},
    report::Report,
};
use tempfile::TempDir;

/// What came out of a chapter's program: exit code, standard output, standard error.
pub(crate) fn run(chapter: &str, folder: &Path, arguments: &[&str]) -> (i32, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_chapter"));
    command.arg(chapter).args(arguments).current_dir(folder).stdin(Stdio::null());
    let output = command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").output().unwrap();
    let [stdout, stderr] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    (output.status.code().unwrap(), stdout, stderr)
}

fn compare(folder: &Path, arguments: &[&str]) -> (i32, String, String) {
    run("space-partitioning", folder, &[&["--compare"], arguments].concat())
}

/// The command must fail with this code and one line on standard error that contains all `parts`.
fn fails(folder: &Path, arguments: &[&str], code: i32, parts: &[&str]) {
    let (actual, stdout, stderr) = compare(folder, arguments);
    assert_eq!((actual, stdout.as_str(), stderr.lines().count()), (code, "", 1), "{arguments:?}: {stderr}");
    for part in parts.iter().chain(&["error: "]) {
        assert!(stderr.contains(part), "{arguments:?}: '{part}' is missing in: {stderr}");
    }
}

/// Arguments that make a report of the least size: all whole numbers as small as they can be.
fn smallest(report: &Report) -> Vec<String> {
    let least = report.knobs.iter().filter_map(|knob| match knob.kind {
        Kind::Number { min, step: Step::Whole, .. } => Some(format!("{}={min}", knob.name)),
        _ => None,
    });
    let name = format!("--{}", report.name);
    let subject = report.subject.map(|knob| knob.show(knob.default()));
    std::iter::once(name).chain(subject).chain(least.flat_map(|set| ["--set".into(), set])).collect()
}

#[test]
fn every_report_is_told_in_narrow_lines_and_listed_with_its_knobs() {
    let folder = TempDir::new().unwrap();
    let mut told = 0;
    for chapter in course::CHAPTERS {
        let (_, help, _) = run(chapter.name, folder.path(), &["--help"]);
        let (_, list, _) = run(chapter.name, folder.path(), &["--list"]);
        for report in chapter.reports {
            let arguments = smallest(report);
            let arguments: Vec<_> = arguments.iter().map(String::as_str).collect();
            let (code, stdout, stderr) = run(chapter.name, folder.path(), &arguments);
            // Nobody sits at a terminal, so nobody is told how it goes.
            assert_eq!((code, stderr.as_str()), (0, ""), "{arguments:?}");
            assert!(stdout.ends_with('\n') && stdout.lines().all(|line| line.chars().count() <= 100), "{stdout}");
            assert!(!stdout.contains("NaN") && !stdout.contains("inf"), "{stdout}");
            assert!(help.contains(&format!("--{}", report.name)) && help.contains(report.what), "{help}");
            assert!(list.contains(&format!("\n--{}", report.name)) && list.contains(report.what), "{list}");
            assert!(report.knobs.iter().all(|knob| list.contains(&format!("    {} = ", knob.name))), "{list}");
            told += 1;
        }
    }
    assert!(told > 0);
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 0, "nothing may be written");
}

/// A table without its columns of times: what must be the same everywhere.
fn counts(table: &str) -> Vec<String> {
    let lines = table.lines().skip(4).take_while(|line| !line.is_empty());
    lines
        .map(|line| {
            let words: Vec<_> = line.split_whitespace().enumerate().collect();
            words
                .iter()
                .filter(|(i, _)| ![1, 5, 8, 11].contains(i))
                .map(|(_, word)| *word)
                .collect::<Vec<_>>()
                .join(" ")
        })
        .collect()
}

#[test]
fn the_comparison_shows_all_structures_and_threads_change_no_count() {
    let folder = TempDir::new().unwrap();
    let small = ["--set", "triangles=500", "--set", "rays=2000"];
    let table = |extra: &[&str]| {
        let (code, stdout, stderr) = compare(folder.path(), &[&small, extra].concat());
        assert_eq!((code, stderr.as_str()), (0, ""));
        stdout
    };
    let plain = table(&[]);
    for part in [
        "Scene 'interior'; ",
        "brute-force ",
        "eight-at-once ",
        "grid ",
        "octree ",
        "kd-tree ",
        "median-kd-tree ",
        "same hits",
    ] {
        assert!(plain.contains(part), "{part} is missing in {plain}");
    }
    assert_eq!(counts(&plain).len(), 6, "{plain}");
    assert_eq!(counts(&table(&["--threads", "3", "--quiet", "--no-window"])), counts(&plain));
    assert_ne!(counts(&table(&["--seed", "9"])), counts(&plain));
    assert_ne!(counts(&table(&["--set", "scene=square"])), counts(&plain));
    assert!(table(&["--threads", "1"]).contains("on one thread"));
    // Too many triangles for brute force.
    let large = table(&["--set", "triangles=100000"]);
    assert!(counts(&large).len() == 4 && large.contains("Brute force would take too long"), "{large}");
}

#[test]
fn any_mesh_can_be_compared() {
    let folder = TempDir::new().unwrap();
    let small = ["--set", "rays=200", "--mesh"];
    for (name, text) in [
        ("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
        ("far.obj", "v 1e6 0 0\nv 1000001 0 0\nv 1e6 1 0\nf 1 2 3\n"),
        ("large.obj", "v 0 0 0\nv 1e14 0 0\nv 0 1e14 0\nf 1 2 3\n"),
        // Nothing to be hit.
        ("point.obj", "v 1 2 3\nf 1 1 1\n"),
        ("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"),
    ] {
        fs::write(folder.path().join(name), text).unwrap();
        let (code, stdout, stderr) = compare(folder.path(), &[&small[..], &[name]].concat());
        assert_eq!((code, stderr.as_str()), (0, ""), "{name}");
        assert!(stdout.contains("; triangles: 1") && stdout.contains("same hits"), "{name}: {stdout}");
        assert!(!stdout.contains("NaN") && !stdout.contains("inf"), "{name}: {stdout}");
    }
}

#[test]
fn wrong_questions_are_explained_in_one_line() {
    let folder = TempDir::new().unwrap();
    let folder = folder.path();
    for (arguments, parts) in [
        (vec!["--set", "triangels=500"], vec!["report 'compare' has no knob", "did you mean 'triangles'?"]),
        (vec!["--set", "triangles=99"], vec!["a whole number from 100 to 20000000"]),
        (vec!["--set", "triangles=NaN"], vec!["a whole number from 100"]),
        (vec!["--set", "triangles=1000.5"], vec!["a whole number from 100"]),
        (vec!["--set", "triangles"], vec!["--set takes knob=value"]),
        (vec!["--set", "scene=moon"], vec!["one of interior, "]),
        (vec!["--set", "rays=inf"], vec!["a whole number"]),
        (vec!["some-picture"], vec!["--compare is a report, not a picture", "leave out 'some-picture'"]),
        (vec!["--size", "32x18"], vec!["leave out '--size'"]),
        (vec!["--output", "a.png"], vec!["leave out '--output'"]),
        (vec!["--pixel", "1,2"], vec!["leave out '--pixel'"]),
        (vec!["--list"], vec!["leave out '--list'"]),
        (vec!["--threads", "0"], vec!["from 1 to 1024"]),
        (vec!["--compare"], vec!["cannot be used multiple times"]),
    ] {
        fails(folder, &arguments, 2, &parts);
    }
    let (code, _, stderr) = run("ray-casting", folder, &["--compare"]);
    assert!(code == 2 && stderr.contains("--compare"), "{stderr}");
}

#[test]
fn unusable_meshes_are_explained_in_one_line() {
    let folder = TempDir::new().unwrap();
    let folder = folder.path();
    for (name, text, part) in [
        ("empty.obj", "", "no face"),
        ("nan.obj", "v NaN 0 0\nv 0 1 0\nv 1 0 0\nf 1 2 3\n", "no finite number"),
        (
            "huge.obj",
            "v 3e38 0 0\nv -3e38 0 0\nv 0 3e38 0\nf 1 2 3\n",
            "the report cannot be made: the mesh has a radius",
        ),
    ] {
        fs::write(folder.join(name), text).unwrap();
        fails(folder, &["--mesh", name], 1, &[part]);
    }
    fails(folder, &["--mesh", "missing.obj"], 1, &["cannot read missing.obj"]);
}

#[test]
fn a_closed_pipe_ends_a_report_quietly() {
    let folder = TempDir::new().unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_chapter"));
    command.args(["space-partitioning", "--compare", "--set", "triangles=100", "--set", "rays=100"]);
    let mut child = command.current_dir(&folder).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(0), &b""[..]));
}
