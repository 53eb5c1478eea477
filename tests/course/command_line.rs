//! The command line of every chapter, used rightly and wrongly.

use std::{
    fs,
    io::Read as _,
    path::Path,
    process::{Command, Output, Stdio},
};

use tempfile::TempDir;

/// A chapter's program in an empty folder, without a display.
fn command(chapter: &str, folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_chapter"));
    command.arg(chapter).args(arguments).current_dir(folder);
    command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").stdin(Stdio::null());
    command
}

/// What came out: exit code, standard output, standard error.
fn run(folder: &Path, arguments: &[&str]) -> (i32, Vec<u8>, String) {
    run_chapter("ray-casting", folder, arguments)
}

fn run_chapter(chapter: &str, folder: &Path, arguments: &[&str]) -> (i32, Vec<u8>, String) {
    let Output { status, stdout, stderr } = command(chapter, folder, arguments).output().unwrap();
    (status.code().unwrap(), stdout, String::from_utf8(stderr).unwrap())
}

/// The command must fail with this code and one line on standard error that contains all `parts`.
fn fails(folder: &Path, arguments: &[&str], code: i32, parts: &[&str]) {
    let (actual, stdout, stderr) = run(folder, arguments);
    assert_eq!(actual, code, "{arguments:?}: {stderr}");
    assert!(stdout.is_empty(), "{arguments:?} wrote to standard output");
    assert_eq!(stderr.lines().count(), 1, "{arguments:?}: {stderr}");
    for part in parts.iter().chain(&["error: "]) {
        assert!(stderr.contains(part), "{arguments:?}: '{part}' is missing in: {stderr}");
    }
}

/// Small and quick.
const SMALL: [&str; 4] = ["--size", "32x18", "--samples", "1"];

fn small<'a>(arguments: &[&'a str]) -> Vec<&'a str> {
    [arguments, &SMALL].concat()
}

#[test]
fn every_chapter_renders_its_cover_without_a_display() {
    for chapter in course::CHAPTERS {
        let folder = TempDir::new().unwrap();
        // Only on Linux can a display be taken away.
        let has_note = cfg!(target_os = "linux");
        let arguments = if has_note { small(&[]) } else { small(&["--no-window"]) };
        let (code, _, stderr) = run_chapter(chapter.name, folder.path(), &arguments);
        let lines: Vec<_> = stderr.lines().collect();
        assert_eq!((code, lines.len()), (0, 1 + usize::from(has_note)), "{stderr}");
        assert_eq!(lines[0].starts_with("No display"), has_note, "{stderr}");
        let file = format!("pictures/{}/{}.png", chapter.name, chapter.pictures[0].name);
        assert!(lines[lines.len() - 1].contains(&file.replace('/', std::path::MAIN_SEPARATOR_STR)), "{stderr}");
        let image = image::open(folder.path().join(file)).unwrap();
        assert_eq!((image.width(), image.height()), (32, 18));
    }
}

#[test]
fn every_picture_is_listed_with_its_knobs() {
    let folder = TempDir::new().unwrap();
    for chapter in course::CHAPTERS {
        let (code, stdout, stderr) = run_chapter(chapter.name, folder.path(), &["--list"]);
        let text = String::from_utf8(stdout).unwrap();
        assert_eq!((code, stderr.as_str()), (0, ""));
        for picture in chapter.pictures {
            assert!(text.contains(&format!("\n{} (", picture.name)) && text.contains(picture.alt));
            assert!(picture.knobs.iter().all(|k| text.contains(&format!("    {} = ", k.name))));
        }
    }
}

#[test]
fn help_shows_examples() {
    let folder = TempDir::new().unwrap();
    let (code, stdout, _) = run(folder.path(), &["--help"]);
    let text = String::from_utf8(stdout).unwrap();
    assert_eq!(code, 0);
    for part in ["Examples", "--set yaw=40", "--pixel", "--output", "cargo run -p ray-casting --"] {
        assert!(text.contains(part), "{part} is missing in {text}");
    }
}

#[test]
fn output_goes_where_it_is_told() {
    let folder = TempDir::new().unwrap();
    for name in ["a.png", "b.exr", "deep/er/c.PNG"] {
        let (code, _, stderr) = run(folder.path(), &small(&["sphere", "--no-window", "--output", name]));
        assert_eq!((code, stderr.lines().count()), (0, 1), "{stderr}");
        assert!(folder.path().join(name).is_file());
    }
    let (code, stdout, stderr) = run(folder.path(), &small(&["sphere", "--output", "-", "--quiet"]));
    assert_eq!((code, stderr.as_str()), (0, ""));
    assert_eq!(stdout, fs::read(folder.path().join("a.png")).unwrap());
}

#[test]
fn knobs_seeds_and_threads_reach_the_picture() {
    let folder = TempDir::new().unwrap();
    let bytes = |extra: &[&str]| {
        let arguments = [&["ambient", "--size", "32x18", "--samples", "2", "--output", "-"], extra].concat();
        let (code, stdout, stderr) = run(folder.path(), &arguments);
        assert_eq!(code, 0, "{stderr}");
        stdout
    };
    let plain = bytes(&[]);
    assert_eq!(bytes(&["--threads", "3"]), plain);
    assert_eq!(bytes(&["--set", "light=all three"]), plain);
    assert_ne!(bytes(&["--seed", "9"]), plain);
    assert_ne!(bytes(&["--set", "light=with ambient"]), plain);
    assert_ne!(bytes(&["--set", "yaw=-30", "--set", "zoom=1.5"]), plain);
    assert_ne!(bytes(&["--exposure", "-1"]), plain);
}

#[test]
fn a_pixel_tells_its_story() {
    let folder = TempDir::new().unwrap();
    let (code, stdout, stderr) = run(folder.path(), &small(&["still-life", "--pixel", "17,10"]));
    let story = String::from_utf8(stdout).unwrap();
    assert_eq!((code, stderr.as_str()), (0, ""));
    for part in ["ray from", "hits 'ball (sphere)'", "ambient k_a L_a", "light 1:", "L·N", "H·N", "sum =", "on screen"]
    {
        assert!(story.contains(part), "{part} is missing in {story}");
    }
}

#[test]
fn a_mesh_is_framed_whatever_its_size_and_place() {
    let folder = TempDir::new().unwrap();
    for (scale, shift) in [(1e-3, 0.0), (1.0, 50.0), (1e4, 0.0)] {
        let corner = |x: f32, y: f32, z: f32| format!("v {} {} {}\n", x * scale + shift, y * scale, z * scale);
        let text = corner(-1.0, -1.0, 0.0) + &corner(1.0, -1.0, 0.0) + &corner(0.0, 1.0, 0.0) + "f -3 -2 -1\n";
        fs::write(folder.path().join("my.obj"), text.replace('\n', "\r\n")).unwrap();
        let (code, _, stderr) = run(folder.path(), &small(&["--mesh", "my.obj", "--no-window", "--output", "m.png"]));
        assert_eq!(code, 0, "{stderr}");
        let image = image::open(folder.path().join("m.png")).unwrap().into_rgb8();
        let background = *image.get_pixel(0, 0);
        let covered = image.pixels().filter(|p| **p != background).count();
        assert!(covered > 60 && covered < 400, "{covered} of 576 pixels at scale {scale}");
    }
}

#[test]
fn wrong_words_are_explained_in_one_line() {
    let folder = TempDir::new().unwrap();
    let folder = folder.path();
    for (arguments, parts) in [
        (vec!["stil-life"], vec!["no picture is called 'stil-life'", "did you mean 'still-life'?"]),
        (vec!["zzz"], vec!["there are: still-life, "]),
        (vec!["--set", "color=3"], vec!["has no knob 'color'", "there are: yaw, pitch, zoom"]),
        (vec!["--set", "yaw=200"], vec!["knob 'yaw' cannot be '200'", "from -180 to 180"]),
        (vec!["--set", "yaw=NaN"], vec!["from -180 to 180"]),
        (vec!["--set", "yaw"], vec!["--set takes knob=value"]),
        (vec!["pixels", "--set", "columns=2.5"], vec!["a whole number from 2 to 400"]),
        (vec!["--size", "0x0"], vec!["size 0x0 is impossible", "1 to 65535 pixels"]),
        (vec!["--size", "100000000x100000000"], vec!["is impossible", "at most 34 million"]),
        (vec!["--size", "99999999999999999999x1"], vec!["expected WIDTHxHEIGHT"]),
        (vec!["--size", "640"], vec!["expected WIDTHxHEIGHT"]),
        (vec!["--samples", "0"], vec!["from 1 to 100000000"]),
        (vec!["--threads", "0"], vec!["from 1 to 1024"]),
        (vec!["--seed", "-1"], vec!["--seed"]),
        (vec!["--exposure", "inf"], vec!["from -20 to 20"]),
        (vec!["--pixel", "960,0"], vec!["pixel 960,0 is outside", "0 to 959", "0 to 539"]),
        (vec!["--pixel", "1;2"], vec!["expected X,Y"]),
        (vec!["sphere", "--mesh", "any.obj"], vec!["does not take --mesh", "these do: mesh"]),
        (vec!["--nonsense"], vec!["--nonsense", "--help shows all options"]),
        (vec!["--size"], vec!["--size", "--help shows all options"]),
    ] {
        fails(folder, &arguments, 2, &parts);
    }
    assert_eq!(fs::read_dir(folder).unwrap().count(), 0, "nothing may be written");
}

#[test]
fn unusable_meshes_are_explained_in_one_line() {
    let folder = TempDir::new().unwrap();
    let folder = folder.path();
    fs::create_dir(folder.join("folder.obj")).unwrap();
    for (name, bytes) in [
        ("empty.obj", &b""[..]),
        ("binary.obj", b"\x7fELF\0\0\x01v 1 2 3\n"),
        ("picture.obj", b"\x89PNG\r\n\x1a\n\xff\xfe"),
        ("damaged.obj", b"v 0 0 0\nv 1 0 0\nv 0 1\nf 1 2 3\n"),
        ("outside.obj", b"v 0 0 0\nf 1 2 3\n"),
        ("infinite.obj", b"v 0 0 1e99\nf 1 1 1\n"),
        ("huge.obj", b"v 3e38 0 0\nv -3e38 0 0\nv 0 3e38 0\nf 1 2 3\n"),
        ("tiny.obj", b"v 1e-40 0 0\nv 0 0 0\nv 0 1e-40 0\nf 1 2 3\n"),
    ] {
        fs::write(folder.join(name), bytes).unwrap();
    }
    for (name, part) in [
        ("missing.obj", "cannot read missing.obj"),
        ("folder.obj", "it is a folder"),
        ("empty.obj", "no face"),
        ("binary.obj", "not a text file"),
        ("picture.obj", "no face"),
        ("damaged.obj", "line 3: a 'v' record needs 3 numbers"),
        ("outside.obj", "line 2: corner '2'"),
        ("infinite.obj", "no finite number"),
    ] {
        fails(folder, &["--mesh", name, "--no-window"], 1, &[name, part]);
    }
    for name in ["huge.obj", "tiny.obj"] {
        fails(folder, &["--mesh", name, "--no-window"], 1, &["the mesh has a radius of", "can be framed"]);
    }
}

#[test]
fn unusable_outputs_are_refused_and_leave_the_old_file_whole() {
    let folder = TempDir::new().unwrap();
    let folder = folder.path();
    fs::write(folder.join("old.jpg"), "old").unwrap();
    fs::write(folder.join("old.png"), "old").unwrap();
    fs::create_dir(folder.join("folder.png")).unwrap();
    let write_to = |output| small(&["sphere", "--no-window", "--output", output]);
    fails(folder, &write_to("old.jpg"), 1, &["old.jpg", "must end in .png or .exr"]);
    fails(folder, &write_to("folder.png"), 1, &["folder.png", "it is a folder"]);
    fails(folder, &write_to("old.png/a.png"), 1, &["cannot write"]);
    fails(folder, &[&write_to("old.png")[..], &["--set", "yaw=999"]].concat(), 2, &["yaw"]);
    for old in ["old.jpg", "old.png"] {
        assert_eq!(fs::read_to_string(folder.join(old)).unwrap(), "old");
    }
    assert_eq!(fs::read_dir(folder).unwrap().count(), 3, "nothing may be left over");
}

/// A folder that nobody may write to. (The system administrator may, so there is nothing to see as root.)
#[cfg(unix)]
#[test]
fn a_folder_without_permission_is_refused() {
    use std::os::unix::fs::PermissionsExt as _;
    let folder = TempDir::new().unwrap();
    let closed = folder.path().join("closed");
    fs::create_dir(&closed).unwrap();
    fs::set_permissions(&closed, fs::Permissions::from_mode(0o555)).unwrap();
    if fs::write(closed.join("probe"), "").is_err() {
        let arguments = small(&["sphere", "--no-window", "--output", "closed/a.png"]);
        fails(folder.path(), &arguments, 1, &["cannot write closed/a.png", "permission denied"]);
    }
    // A place where not even the administrator can create a file.
    let arguments = small(&["sphere", "--no-window", "--output", "/proc/a.png"]);
    if cfg!(target_os = "linux") {
        fails(folder.path(), &arguments, 1, &["cannot write /proc/a.png"]);
    }
}

/// `/dev/full` is a device on which every write fails as on a full disk.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    let folder = TempDir::new().unwrap();
    let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let output = command("ray-casting", folder.path(), &small(&["sphere", "--output", "-", "--quiet"]))
        .stdout(full)
        .output()
        .unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!((output.status.code(), stderr.lines().count()), (Some(1), 1), "{stderr}");
    assert!(stderr.contains("no space left"), "{stderr}");
}

/// A limit on the size of files, which ends a write in the middle, as a disk does that fills up meanwhile.
#[cfg(target_os = "linux")]
#[test]
fn a_write_that_ends_in_the_middle_leaves_the_old_file_whole() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("old.png"), "old").unwrap();
    let program = env!("CARGO_BIN_EXE_chapter");
    let line = format!(
        "trap '' XFSZ; ulimit -f 1; exec '{program}' ray-casting sphere --no-window --samples 1 --output old.png"
    );
    let output = Command::new("sh").args(["-c", &line]).current_dir(folder.path()).output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!((output.status.code(), stderr.lines().count()), (Some(1), 1), "{stderr}");
    assert!(stderr.contains("cannot write old.png"), "{stderr}");
    assert_eq!(fs::read_to_string(folder.path().join("old.png")).unwrap(), "old");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn a_closed_pipe_ends_quietly() {
    let folder = TempDir::new().unwrap();
    for arguments in [&["--list"][..], &["--help"], &["sphere", "--output", "-", "--quiet"]] {
        let mut child = command("ray-casting", folder.path(), arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        // Close the pipe before anything is read.
        drop(child.stdout.take());
        let mut stderr = String::new();
        child.stderr.take().unwrap().read_to_string(&mut stderr).unwrap();
        assert_eq!((child.wait().unwrap().code(), stderr.as_str()), (Some(0), ""), "{arguments:?}");
    }
}

#[test]
fn no_progress_bar_in_a_pipe_and_silence_when_quiet() {
    let folder = TempDir::new().unwrap();
    let (_, _, stderr) = run(folder.path(), &["sphere", "--no-window", "--output", "a.png"]);
    assert!(stderr.starts_with("Wrote a.png") && stderr.lines().count() == 1, "{stderr}");
    let (code, stdout, stderr) = run(folder.path(), &small(&["--quiet", "--no-window"]));
    assert_eq!((code, stdout.len(), stderr.as_str()), (0, 0, ""));
}
