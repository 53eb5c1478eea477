//! Renderings that end early and go on: Ctrl-C, `--until-error`, `--save-state` and `--resume`.

use std::{
    fs,
    path::Path,
    process::{Command, Output, Stdio},
};

use tempfile::TempDir;

/// A small picture with chance in it, and more words.
fn command(folder: &Path, words: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_chapter"));
    command.args("ray-casting still-life --no-window".split(' ')).args(words.split_whitespace());
    if !words.contains("--size") {
        command.args(["--size", "33x18"]);
    }
    command.current_dir(folder).stdin(Stdio::null());
    command
}

/// What came out: exit code, and what was said.
fn run(folder: &Path, words: &str) -> (i32, String) {
    let Output { status, stdout, stderr } = command(folder, words).output().unwrap();
    assert!(stdout.is_empty());
    (status.code().unwrap(), String::from_utf8(stderr).unwrap())
}

/// What is said when all goes well.
fn well(folder: &Path, words: &str) -> String {
    let (code, said) = run(folder, words);
    assert_eq!(code, 0, "{words}: {said}");
    said
}

/// The command must fail with this code and one line that contains `part`.
fn fails(folder: &Path, words: &str, code: i32, part: &str) {
    let (actual, said) = run(folder, words);
    assert_eq!((actual, said.lines().count()), (code, 1), "{words}: {said}");
    assert!(said.starts_with("error: ") && said.contains(part), "{words}: '{part}' is missing in: {said}");
}

/// The bytes of the radiances, which show every bit of the film's means.
fn exr(folder: &Path, name: &str) -> Vec<u8> {
    fs::read(folder.join(name)).unwrap()
}

#[test]
fn going_on_gives_the_same_bits_as_going_through() {
    let folder = TempDir::new().unwrap();
    let folder = folder.path();
    well(folder, "--samples 64 --output through.exr --save-state through.state");
    for threads in [["1", "1", "1"], ["2", "2", "2"], ["2", "1", "3"]] {
        let go_on = |samples, threads, resume| {
            let said = well(
                folder,
                &format!("--samples {samples} --threads {threads} --save-state a.state {resume} --output a.exr"),
            );
            assert!(
                said.contains("Wrote a.exr") && said.contains("Wrote a.state, from which --resume goes on"),
                "{said}"
            );
            said
        };
        go_on(1, threads[0], "");
        let said = go_on(7, threads[1], "--resume a.state");
        assert!(said.contains("a lone sample per pixel"), "{said}");
        assert!(!go_on(64, threads[2], "--resume a.state").contains("anew"));
        assert_eq!(exr(folder, "a.exr"), exr(folder, "through.exr"));
        // The sums of squares as well.
        assert_eq!(exr(folder, "a.state"), exr(folder, "through.state"));
    }
    // Nothing to add, and the picture is written all the same.
    fs::remove_file(folder.join("a.exr")).unwrap();
    let said = well(folder, "--resume a.state --samples 5 --output a.exr");
    assert!(said.contains("a.state has 64 samples per pixel already"), "{said}");
    assert_eq!(exr(folder, "a.exr"), exr(folder, "through.exr"));
    assert_eq!(fs::read_dir(folder).unwrap().count(), 4, "nothing may be left over");
}

/// Without `--samples` it goes on to what was asked for at first. Only the brightness of the file may be another.
#[test]
fn what_goes_on_remembers_where_to() {
    let folder = TempDir::new().unwrap();
    let folder = folder.path();
    well(folder, "--samples 3 --save-state a.state --output a.png");
    let said = well(folder, "--resume a.state --exposure 1 --output b.png");
    assert!(said.contains("has 3 samples per pixel already") && said.contains("3 per pixel"), "{said}");
}

#[test]
fn what_does_not_belong_together_is_refused() {
    let folder = TempDir::new().unwrap();
    let folder = folder.path();
    well(folder, "--samples 2 --save-state a.state --output a.png");
    let whole = fs::read(folder.join("a.state")).unwrap();
    fs::write(folder.join("cut.state"), &whole[..whole.len() / 2]).unwrap();
    fs::write(folder.join("thesis.txt"), "my thesis").unwrap();
    for (words, code, part) in [
        ("--resume a.state --seed 3", 1, "cannot go on from a.state: its seed is 0, not 3"),
        ("--resume a.state --set yaw=5", 1, "its knob 'yaw' is 0°, not 5°"),
        ("--resume a.state --size 18x33", 1, "its size is 33x18, not 18x33"),
        ("--resume cut.state", 1, "cannot go on from cut.state: it is damaged or cut off"),
        ("--resume thesis.txt", 1, "it is no state of a rendering"),
        ("--resume missing.state", 1, "cannot read missing.state"),
        ("--resume .", 1, "it is a folder"),
        ("--save-state thesis.txt", 1, "cannot write thesis.txt"),
        ("--save-state a.state/b", 1, "cannot write a.state/b"),
        ("--save-state a.png", 2, "'a.png' cannot name a state"),
        ("--resume -", 2, "'-' cannot name a state"),
        ("--resume a.state --pixel 1,1", 2, "leave out '--resume'"),
        ("--until-error 1% --samples 1", 2, "--until-error needs --samples 2 or more"),
        ("--until-error 0%", 2, "like 1%"),
        ("--until-error NaN", 2, "like 1%"),
        ("--until-error -3", 2, "like 1%"),
        ("--until-error much", 2, "like 1%"),
    ] {
        fails(folder, words, code, part);
    }
    assert_eq!(fs::read(folder.join("a.state")).unwrap(), whole);
    assert_eq!(fs::read(folder.join("thesis.txt")).unwrap(), b"my thesis");
    assert_eq!(fs::read_dir(folder).unwrap().count(), 4, "nothing may be left over");
}

#[test]
fn the_error_ends_it_at_the_same_number_of_samples() {
    let folder = TempDir::new().unwrap();
    let folder = folder.path();
    let until = |words: &str| {
        let said = well(folder, words);
        let has = said.split(" per pixel").next().unwrap().rsplit(' ').next().unwrap().to_string();
        (has.parse::<u32>().unwrap(), said.contains("small enough for --until-error 2 %"), said)
    };
    let (samples, reached, said) = until("--until-error 2% --threads 1 --output one.exr");
    assert!(samples >= 16 && samples % 16 == 0 && reached && !said.contains("not yet"), "{said}");
    let again = until("--until-error 2 --threads 2 --output two.exr");
    assert_eq!(again.0, samples);
    assert_eq!(exr(folder, "one.exr"), exr(folder, "two.exr"));
    // In two pieces, the first of them of any length.
    well(folder, "--samples 5 --save-state a.state --output a.exr");
    assert_eq!(until("--until-error 2% --resume a.state --save-state a.state --output a.exr").0, samples);
    assert_eq!(exr(folder, "one.exr"), exr(folder, "a.exr"));
    // Small enough already.
    assert_eq!(until("--until-error 2% --resume a.state --output a.exr").0, samples);
    let (samples, _, said) = until("--until-error 2% --samples 9 --output a.exr");
    assert!(samples == 9 && said.contains("not yet small enough"), "{said}");
}

/// A limit on the size of files ends the write in the middle, as a full disk does. The picture is small enough.
#[cfg(target_os = "linux")]
#[test]
fn a_write_that_ends_in_the_middle_leaves_the_old_state_whole() {
    let folder = TempDir::new().unwrap();
    let folder = folder.path();
    well(folder, "--samples 2 --save-state a.state --output a.png");
    let old = fs::read(folder.join("a.state")).unwrap();
    let program = env!("CARGO_BIN_EXE_chapter");
    let line = format!(
        "trap '' XFSZ; ulimit -f 16; exec '{program}' ray-casting still-life --no-window --size 33x18 --samples 9 \
         --resume a.state --save-state a.state --output b.png"
    );
    let output = Command::new("sh").args(["-c", &line]).current_dir(folder).output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("cannot write a.state") && said.contains("Wrote b.png"), "{said}");
    assert_eq!(fs::read(folder.join("a.state")).unwrap(), old);
    assert_eq!(fs::read_dir(folder).unwrap().count(), 3);
}

/// Whether a program catches SIGINT, as the system sees it.
#[cfg(target_os = "linux")]
fn catches_ctrl_c(process: u32) -> bool {
    let status = fs::read_to_string(format!("/proc/{process}/status")).unwrap_or_default();
    let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:"));
    caught.is_some_and(|mask| u64::from_str_radix(mask.trim(), 16).is_ok_and(|mask| mask & 0b10 != 0))
}

/// Start a rendering that would take for ever, and send it Ctrl-C as soon as it listens.
#[cfg(target_os = "linux")]
fn interrupted(folder: &Path, words: &str) -> String {
    let mut child = command(folder, words).stderr(Stdio::piped()).spawn().unwrap();
    let listens = (0..6000).any(|_| {
        std::thread::sleep(std::time::Duration::from_millis(10));
        catches_ctrl_c(child.id())
    });
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    if !listens || !sent.is_ok_and(|status| status.success()) {
        let _ = child.kill();
    }
    let Output { status, stderr, .. } = child.wait_with_output().unwrap();
    let said = String::from_utf8(stderr).unwrap();
    assert_eq!((status.code(), listens), (Some(0), true), "{said}");
    said
}

#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_leaves_the_best_picture_so_far() {
    let folder = TempDir::new().unwrap();
    let folder = folder.path();
    let said = interrupted(folder, "--samples 100000000 --output a.png");
    assert!(
        said.contains("Wrote a.png") && said.contains("of 100000000 samples per pixel; with --save-state"),
        "{said}"
    );
    let image = image::open(folder.join("a.png")).unwrap();
    assert_eq!((image.width(), image.height()), (33, 18));
    assert_eq!(fs::read_dir(folder).unwrap().count(), 1);
}

/// Interrupted wherever that may be, again and again; then finished, to the bits of one run.
#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_and_going_on_give_the_same_bits() {
    let folder = TempDir::new().unwrap();
    let folder = folder.path();
    let mut said = interrupted(folder, "--samples 100000000 --threads 2 --save-state a.state --output a.png");
    for threads in [1, 3] {
        assert!(said.contains("the same command with --resume a.state goes on"), "{said}");
        // The goal is remembered.
        let words = format!("--threads {threads} --resume a.state --save-state a.state --output a.png");
        said = interrupted(folder, &words);
        assert!(said.contains("of 100000000 samples per pixel"), "{said}");
    }
    let has = said.split("Interrupted with ").nth(1).unwrap().split(" of").next().unwrap();
    let most: u32 = has.rsplit(' ').next().unwrap().parse().unwrap();
    let samples = most + 3;
    well(folder, &format!("--samples {samples} --resume a.state --output a.exr"));
    well(folder, &format!("--samples {samples} --output through.exr"));
    assert_eq!(exr(folder, "a.exr"), exr(folder, "through.exr"));
}
