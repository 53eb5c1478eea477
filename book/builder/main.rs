//! `cargo book`: builds the book, shows it, checks it.

use std::{
    path::{Path, PathBuf},
    process::{Command, ExitCode, Stdio},
};

use book::serve;

/// What is printed for `--help`.
const HELP: &str = "\
cargo book                  build the book into target/book
cargo book --open           and open it in the browser
cargo book --check          and look for dead links, images without words, and what the book forgot
cargo book --serve [PORT]   build it, show it at http://localhost:PORT (3000), and again after every change";

/// What a command line asks for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Task {
    open: bool,
    check: bool,
    help: bool,
    serve: Option<u16>,
}

fn main() -> ExitCode {
    let task = match parse(std::env::args().skip(1)) {
        Ok(task) => task,
        Err(wrong) => {
            eprintln!("{wrong}: there is --open, --check, --serve [PORT], --help");
            return ExitCode::from(2);
        }
    };
    if task.help {
        println!("{HELP}");
        return ExitCode::SUCCESS;
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(PathBuf::new, Path::to_owned);
    let out = root.join("target/book");
    let done = match task.serve {
        Some(port) => show(&root, &out, port, task.open),
        None => build(&root, &out, task),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

/// Read a command line; the error is what is wrong with it.
fn parse(arguments: impl Iterator<Item = String>) -> Result<Task, String> {
    let mut task = Task::default();
    let mut arguments = arguments.peekable();
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--open" => task.open = true,
            "--check" => task.check = true,
            "--help" | "-h" => task.help = true,
            "--serve" => {
                let port = arguments.next_if(|next| !next.starts_with('-'));
                let port =
                    port.map_or(Ok(3000), |port| port.parse().map_err(|_| format!("`{port}` is no port, 1 to 65535")));
                task.serve = Some(port?);
            }
            other => return Err(format!("`{other}` is no option")),
        }
    }
    Ok(task)
}

/// Build the book, and do with it what was asked for.
fn build(root: &Path, out: &Path, task: Task) -> Result<(), String> {
    book::build(root, out).map_err(|error| error.to_string())?;
    let page = out.join("index.html");
    println!("The book is in {}", page.display());
    if let Some(note) = book::note(root) {
        println!("{note}");
    }
    if task.check {
        let problems = book::check(root, out);
        if !problems.is_empty() {
            return Err(problems.join("\n"));
        }
    }
    if task.open { open(&page.to_string_lossy()) } else { Ok(()) }
}

/// Serve the book until the program is ended.
fn show(root: &Path, out: &Path, port: u16, is_opened: bool) -> Result<(), String> {
    let listener = serve::listen(port)
        .map_err(|error| format!("port {port} cannot be used ({error}): choose another with --serve PORT"))?;
    let port = listener.local_addr().map_or(port, |address| address.port());
    let address = format!("http://localhost:{port}/");
    println!("The book is at {address} until Ctrl-C");
    if is_opened {
        open(&address)?;
    }
    serve::serve(root, out, listener, |problem| match problem {
        Some(problem) => eprintln!("{problem}"),
        None => println!("built{}", book::note(root).map_or_else(String::new, |note| format!("; {note}"))),
    });
    Ok(())
}

/// Open a file or an address with whatever the system opens it.
fn open(what: &str) -> Result<(), String> {
    let (program, arguments): (_, &[&str]) = if cfg!(windows) {
        ("cmd", &["/C", "start", ""])
    } else if cfg!(target_os = "macos") {
        ("open", &[])
    } else {
        ("xdg-open", &[])
    };
    let mut command = Command::new(program);
    command.args(arguments).arg(what).stdout(Stdio::null()).stderr(Stdio::null());
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        _ => Err(format!("no browser could be started: open {what} yourself")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(line: &str) -> Result<Task, String> {
        parse(line.split_whitespace().map(str::to_owned))
    }

    #[test]
    fn command_lines_are_read() {
        assert_eq!(parsed(""), Ok(Task::default()));
        assert_eq!(parsed("--serve"), Ok(Task { serve: Some(3000), ..Task::default() }));
        assert_eq!(parsed("--serve 81 --open"), Ok(Task { serve: Some(81), open: true, ..Task::default() }));
        assert_eq!(parsed("--serve --open"), Ok(Task { serve: Some(3000), open: true, ..Task::default() }));
        for wrong in ["serve", "--serve x", "--serve 70000", "--open=1", "-x"] {
            assert!(parsed(wrong).is_err(), "{wrong}");
        }
    }
}
