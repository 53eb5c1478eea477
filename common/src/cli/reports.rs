//! Reports on the command line: what is asked for, and how it is told.

use std::{io::IsTerminal as _, path::PathBuf};

use clap::{ArgMatches, parser::ValueSource};

use super::{
    arguments::{Stop, values},
    say,
};
use crate::{
    error::Error,
    obj, output, parallel,
    picture::{Chapter, Settings},
    report::{Report, Task},
};

/// What a user asks for who wants a report.
pub(crate) struct Inquiry {
    report: &'static Report,
    settings: Settings,
    seed: u64,
    threads: usize,
    quiet: bool,
    /// The folder for the report's files, if they are wanted.
    folder: Option<PathBuf>,
}

/// Arguments that mean nothing to a report, and what to call them.
const FOR_PICTURES: [(&str, &str); 9] = [
    ("list", "--list"),
    ("size", "--size"),
    ("samples", "--samples"),
    ("until-error", "--until-error"),
    ("save-state", "--save-state"),
    ("resume", "--resume"),
    ("exposure", "--exposure"),
    ("pixel", "--pixel"),
    ("picture", ""),
];

/// The report that a command line asks for, if it asks for one.
pub(super) fn understand(chapter: &Chapter, matches: &ArgMatches) -> Result<Option<Inquiry>, Stop> {
    let is_said = |name: &str| matches.value_source(name) == Some(ValueSource::CommandLine);
    let mut asked = chapter.reports.iter().filter(|report| is_said(report.name));
    let Some(report) = asked.next() else { return Ok(None) };
    let name = report.name;
    if let Some(other) = asked.next() {
        return Err(Stop::Wrong(format!("--{name} and --{} are two reports; ask for one at a time", other.name)));
    }
    if let Some((argument, shown)) = FOR_PICTURES.into_iter().find(|(argument, _)| is_said(argument)) {
        let shown = if argument == "picture" { matches.get_one(argument).map_or(shown, String::as_str) } else { shown };
        return Err(Stop::Wrong(format!(
            "--{name} is a report, not a picture; leave out '{shown}' (--set, --seed, --threads and --quiet may stay)"
        )));
    }

    let mut values = values(matches, report.knobs, &format!("report '{name}'"))?;
    if let Some(knob) = report.subject {
        let word = matches.get_one::<String>(name).map_or("", String::as_str);
        values.set(knob, knob.parse(word).map_err(|e| e.to_string())?);
    }
    let mut settings = Settings { values, mesh: None };
    if let Some(path) = matches.get_one::<PathBuf>("mesh") {
        if !report.takes_mesh {
            return Err(Stop::Wrong(format!("report '{name}' does not take --mesh")));
        }
        settings.mesh = Some(obj::read(path).map_err(Stop::Unusable)?);
    }
    let folder = matches.get_one::<PathBuf>("output").cloned();
    match &folder {
        Some(_) if !report.gives_files => {
            return Err(Stop::Wrong(format!("report '{name}' has no files to give; leave out '--output'")));
        }
        Some(folder) if folder.as_os_str() == "-" => {
            return Err(Stop::Wrong(format!(
                "--{name} puts its table on standard output by itself; --output takes a folder for its files"
            )));
        }
        _ => {}
    }
    Ok(Some(Inquiry {
        report,
        settings,
        seed: matches.get_one("seed").copied().unwrap_or_default(),
        threads: matches.get_one("threads").copied().unwrap_or_default(),
        quiet: matches.get_flag("quiet"),
        folder,
    }))
}

impl Inquiry {
    /// Make the report and write it to standard output, and its files to where they are wanted. Meanwhile whoever sits
    /// at a terminal is told each step.
    pub(super) fn answer(&self) -> Result<(), Error> {
        if let Some(folder) = &self.folder {
            output::check_folder(folder)?;
        }
        let is_watched = !self.quiet && std::io::stderr().is_terminal();
        let progress = |step: &str| {
            if is_watched {
                say(step);
            }
        };
        let task = Task { settings: &self.settings, seed: self.seed, threads: self.threads, progress: &progress };
        let report = parallel::with_threads(self.threads, || (self.report.make)(&task));
        let told = report.map_err(|error| match error {
            Error::Picture(what) => Error::Report(what),
            other => other,
        })?;
        if let Some(folder) = &self.folder {
            for file in &told.files {
                let path = folder.join(&file.name);
                output::write(&path, file.content.as_bytes())?;
                if !self.quiet {
                    say(&format!("Wrote {}.", path.display()));
                }
            }
        }
        output::write_to_stdout(told.text.as_bytes())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        cli::arguments::{Wish, parse},
        knob::{Knob, Step},
        report::{Attachment, Told},
    };

    const COUNT: Knob = Knob::number("count", "how many", [1.0, 9.0], 2.0, "", Step::Whole);
    const WHICH: Knob = Knob::choice("which", "about what", &["one", "two"], 0);
    const PLAIN: Report = Report {
        name: "plain",
        what: "counts",
        subject: None,
        knobs: &[COUNT],
        takes_mesh: false,
        gives_files: false,
        make: |task| Ok(format!("{}\n", task.settings.values.index(&COUNT)).into()),
    };
    const ABOUT: Report = Report {
        name: "about",
        subject: Some(&WHICH),
        knobs: &[],
        gives_files: true,
        make: |_| {
            let files = ["a.csv", "b.svg"].map(|name| Attachment { name: name.into(), content: format!("<{name}>\n") });
            Ok(Told { text: String::new(), files: files.into() })
        },
        ..PLAIN
    };
    const CHAPTER: Chapter = Chapter { number: 0, name: "toy", title: "Toy", pictures: &[], reports: &[PLAIN, ABOUT] };

    fn asked(line: &str) -> Result<Inquiry, String> {
        let words = std::iter::once("toy").chain(line.split_whitespace());
        match parse(&CHAPTER, words.map(Into::into)) {
            Ok(Wish::Report(inquiry)) => Ok(inquiry),
            Ok(Wish::Picture(_)) => Err("a picture".into()),
            Err(Stop::Help(what) | Stop::Wrong(what)) => Err(what),
            Err(Stop::Unusable(error)) => Err(error.to_string()),
        }
    }

    #[test]
    fn a_report_is_asked_for_by_its_name() {
        let inquiry = asked("--plain --set count=7 --threads 3 --seed 5 --quiet --no-window").unwrap();
        assert_eq!((inquiry.report.name, inquiry.settings.values.index(&COUNT)), ("plain", 7));
        assert_eq!((inquiry.threads, inquiry.seed, inquiry.quiet), (3, 5, true));
        assert_eq!(asked("--about two").unwrap().settings.values.index(&WHICH), 1);
    }

    #[test]
    fn wrong_questions_are_explained() {
        for (line, part) in [
            ("--plain --about one", "--plain and --about are two reports"),
            ("--plain ball", "leave out 'ball'"),
            ("--plain --size 4x3", "leave out '--size'"),
            ("--plain --until-error 1%", "leave out '--until-error'"),
            ("--plain --save-state x", "leave out '--save-state'"),
            ("--resume x --plain", "leave out '--resume'"),
            ("--list --plain", "leave out '--list'"),
            ("--plain --output x", "report 'plain' has no files to give; leave out '--output'"),
            ("--about one --output -", "--output takes a folder"),
            ("--plain --set conut=7", "report 'plain' has no knob 'conut'; did you mean 'count'?"),
            ("--about one --set count=7", "report 'about' has no knobs"),
            ("--plain --set count=NaN", "from 1 to 9"),
            ("--plain --mesh x.obj", "does not take --mesh"),
            ("--about three", "knob 'which' cannot be 'three': it takes one of one, two"),
            ("--about", "a value is required"),
            ("--plain=3", "unexpected value"),
            ("--plain --plain", "cannot be used multiple times"),
            ("", "no pictures yet"),
        ] {
            let said = asked(line).map(|_| ()).unwrap_err();
            assert!(said.contains(part), "{line}: {said}");
        }
    }

    #[test]
    fn files_go_to_the_folder_that_is_named() {
        let folder = std::env::temp_dir().join(format!("course-report-{}", std::process::id()));
        let plots = folder.join("deep/plots");
        for _again in 0..2 {
            asked(&format!("--about one --quiet --output {}", plots.display())).unwrap().answer().unwrap();
        }
        let mut names: Vec<_> = std::fs::read_dir(&plots).unwrap().map(|file| file.unwrap().file_name()).collect();
        names.sort();
        assert_eq!(names, ["a.csv", "b.svg"]);
        assert_eq!(std::fs::read_to_string(plots.join("b.svg")).unwrap(), "<b.svg>\n");
        // A file is no folder.
        let blocked = asked(&format!("--about one --quiet --output {}", plots.join("a.csv").display())).unwrap();
        assert!(blocked.answer().unwrap_err().to_string().ends_with("it is a file, not a folder"));
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn the_help_names_them() {
        let help = asked("--help").map(|_| ()).unwrap_err();
        assert!(help.contains("--plain ") && help.contains("--about <which>"), "{help}");
    }
}
