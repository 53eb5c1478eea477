//! The command line.

use crate::Failure;

/// What is asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Command {
    /// How to use the program.
    Help,
    /// All exercises and how far they are.
    List,
    /// Whether stubs, checks and solutions fit together.
    Prove,
    /// Something about one exercise.
    One {
        /// Its number or name, as typed.
        name: String,
        /// What is to be done.
        wish: Wish,
    },
}

/// What is to be done with one exercise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wish {
    /// Check the answer.
    Check,
    /// Open the next hint.
    Hint,
    /// Show the solution.
    Solution,
    /// Bring the stub back.
    Reset,
}

/// The text for `--help`.
pub(crate) const HELP: &str = "\
cargo exercise                  all exercises, and how far you are
cargo exercise 1.2              check your answer to exercise 1.2, and show its picture once it is right
cargo exercise 1.2 --hint       open the first hint; again for the next one
cargo exercise 1.2 --solution   show the solution; before your answer is right, only when asked twice
cargo exercise 1.2 --reset      start again; what you wrote is kept beside it
cargo exercise --prove          check the exercises themselves (for authors)";

const USAGE: &str = "(cargo exercise --help shows what can be asked)";

/// Understand the command line.
pub(crate) fn parse(arguments: impl IntoIterator<Item = String>) -> Result<Command, Failure> {
    let mut name = None;
    let mut wish = None;
    let mut whole = None;
    for argument in arguments {
        let asked = match argument.as_str() {
            "--help" | "-h" => return Ok(Command::Help),
            "--prove" => whole.replace(Command::Prove).map(|_| ()),
            "--hint" => wish.replace(Wish::Hint).map(|_| ()),
            "--solution" => wish.replace(Wish::Solution).map(|_| ()),
            "--reset" => wish.replace(Wish::Reset).map(|_| ()),
            unknown if unknown.starts_with('-') => {
                return Err(Failure::usage(format!("there is no option '{unknown}' {USAGE}")));
            }
            _ => name.replace(argument).map(|_| ()),
        };
        if asked.is_some() {
            return Err(Failure::usage(format!("one exercise and one wish at a time {USAGE}")));
        }
    }
    match (name, wish, whole) {
        (None, None, None) => Ok(Command::List),
        (None, None, Some(command)) => Ok(command),
        (Some(name), wish, None) => Ok(Command::One { name, wish: wish.unwrap_or(Wish::Check) }),
        (None, Some(_), None) => Err(Failure::usage(format!("of which exercise? {USAGE}"))),
        (_, _, Some(_)) => Err(Failure::usage(format!("--prove stands alone {USAGE}"))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(line: &str) -> Result<Command, String> {
        parse(line.split_whitespace().map(String::from)).map_err(|failure| failure.message)
    }

    #[test]
    fn what_can_be_asked() {
        let one = |wish| Ok(Command::One { name: "1.2".into(), wish });
        assert_eq!(parsed(""), Ok(Command::List));
        assert_eq!(parsed("--prove"), Ok(Command::Prove));
        assert_eq!(parsed("1.2"), one(Wish::Check));
        assert_eq!(parsed("1.2 --hint"), one(Wish::Hint));
        assert_eq!(parsed("--hint 1.2"), one(Wish::Hint));
        assert_eq!(parsed("1.2 --solution"), one(Wish::Solution));
        assert_eq!(parsed("1.2 --reset"), one(Wish::Reset));
        assert_eq!(parsed("1.2 --hint --help"), Ok(Command::Help));
    }

    #[test]
    fn what_cannot_be_asked() {
        for (line, expected) in [
            ("--hint", "which exercise"),
            ("1.2 1.3", "one exercise"),
            ("1.2 --hint --reset", "one wish"),
            ("1.2 --prove", "stands alone"),
            ("--proof", "no option '--proof'"),
        ] {
            let message = parsed(line).unwrap_err();
            assert!(
                message.contains(expected) && message.contains("--help") && message.lines().count() == 1,
                "{message}"
            );
        }
    }
}
