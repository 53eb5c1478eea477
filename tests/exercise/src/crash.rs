//! Why a program ended before it had done its work.

use std::collections::BTreeSet;

/// How a program ended that did not do what it was asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Ending<'a> {
    /// Its exit code, if it ended with one.
    pub(crate) code: Option<i32>,
    /// The same in the words of the system.
    pub(crate) words: &'a str,
    /// What it has written on standard error.
    pub(crate) written: &'a str,
}

impl Ending<'_> {
    /// What happened, and the likely cause.
    pub(crate) fn cause(&self) -> String {
        let Self { code, words, written } = self;
        // So Windows says it when the stack is used up.
        const STACK_OVERFLOW: &str = "0xc00000fd";
        if written.contains("has overflowed its stack") || words.contains(STACK_OVERFLOW) {
            return "The stack is used up: too many calls are open at the same time, or a variable is very large.\n\n\
                    Does a function call itself? Then there must be a case in which it does not, and each call must come\n\
                    nearer to that case. If it comes there in the end, but only after many thousand calls, the depth is too\n\
                    much all the same: use a loop, and a Vec of what is still to be done. Is a very large array in a\n\
                    variable? The elements of a Vec do not lie on the stack."
                .into();
        }
        if let Some(bytes) = failed_allocation(written) {
            return format!(
                "The memory is used up: {bytes} more bytes were asked for, and there were none.\n\n\
                 Does a loop push into a Vec, or a String grow, without end? Or is the length wrong for which memory\n\
                 was asked?"
            );
        }
        if words.contains("SIGKILL") {
            return format!(
                "The system, or somebody, has stopped your program ({words}). The system does so when the memory is\n\
                 used up.\n\n\
                 Does a loop push into a Vec, or a String grow, without end?"
            );
        }
        // Other numbers are no exit codes: Windows says with them how a program was stopped.
        match code.filter(|code| (0..=255).contains(code)) {
            Some(_) => format!(
                "Your program ended by itself before its work was done ({words}).\n\n\
                 Does your code call `std::process::exit`? It ends the whole program: use `return` to leave a function.\n\
                 Or was `main` changed? It must stand as it was."
            ),
            None => format!(
                "Your program was stopped before its work was done ({words}).\n\n\
                 Does your code call `std::process::abort`, or does it panic while it is panicking already, in a `drop`?\n\
                 What it wrote on standard error may tell."
            ),
        }
    }
}

/// How many bytes of memory were asked for in vain.
fn failed_allocation(written: &str) -> Option<&str> {
    let (_, rest) = written.rsplit_once("memory allocation of ")?;
    let (bytes, _) = rest.split_once(" bytes failed")?;
    Some(bytes).filter(|bytes| bytes.parse::<u128>().is_ok())
}

/// The panics that a program has written on standard error, each of them once, whatever number of threads said it: the
/// place and the words.
pub(crate) fn panics(written: &str) -> Vec<String> {
    const LEAD: &str = " panicked at ";
    let mut known = BTreeSet::new();
    let mut panics = Vec::new();
    let mut lines = written.lines().peekable();
    while let Some(line) = lines.next() {
        let Some((_, place)) = line.split_once(LEAD).filter(|_| line.starts_with("thread '")) else { continue };
        let mut panic = place.to_owned();
        // The words end where Rust goes on, or another thread.
        let is_other = |line: &str| {
            ["thread '", "note: ", "stack backtrace:"].iter().any(|lead| line.starts_with(lead)) || line.is_empty()
        };
        while let Some(words) = lines.next_if(|line| !is_other(line)) {
            panic += &format!("\n  {words}");
        }
        if known.insert(panic.clone()) {
            panics.push(panic);
        }
    }
    panics
}

#[cfg(test)]
mod tests {
    use super::*;

    const ABORTED: &str = "signal: 6 (SIGABRT) (core dumped)";

    fn cause(code: Option<i32>, words: &str, written: &str) -> String {
        Ending { code, words, written }.cause()
    }

    #[test]
    fn a_full_stack_is_not_called_endless() {
        let written =
            "\nthread '<unnamed>' (7) has overflowed its stack\nfatal runtime error: stack overflow, aborting\n";
        let told = cause(None, ABORTED, written);
        assert!(told.starts_with("The stack is used up") && told.contains("a loop, and a Vec"), "{told}");
        assert!(!told.contains("without end"), "{told}");
        assert_eq!(cause(Some(-1_073_741_571), "exit code: 0xc00000fd", ""), told);
    }

    #[test]
    fn memory_that_is_used_up_is_no_recursion() {
        let told = cause(None, ABORTED, "memory allocation of 6979321856 bytes failed\n");
        assert!(told.starts_with("The memory is used up: 6979321856 more bytes") && !told.contains("stack"), "{told}");
        assert!(cause(None, "signal: 9 (SIGKILL)", "").contains("stopped your program"));
    }

    #[test]
    fn an_early_exit_is_no_crash() {
        let told = cause(Some(0), "exit status: 0", "");
        assert!(told.contains("by itself") && told.contains("process::exit") && !told.contains("stack"), "{told}");
        let told = cause(None, ABORTED, "");
        assert!(told.contains("was stopped") && told.contains("SIGABRT"), "{told}");
    }

    #[test]
    fn each_panic_is_told_once() {
        let one = "thread '<unnamed>' (11) panicked at cube.rs:3:4:\nattempt to add with overflow\n";
        let note = "note: run with `RUST_BACKTRACE=1` environment variable to display a backtrace\n";
        let written = format!("\n{one}{note}\n{}\n{one}", one.replace("11", "12").replace('3', "5"));
        assert_eq!(
            panics(&written),
            ["cube.rs:3:4:\n  attempt to add with overflow", "cube.rs:5:4:\n  attempt to add with overflow"]
        );
        let traced = format!("{one}stack backtrace:\n   0: core::panicking::panic_fmt\n");
        assert_eq!(panics(&traced), ["cube.rs:3:4:\n  attempt to add with overflow"]);
        assert_eq!(panics("Wrote a.png\nI panicked at once\n"), Vec::<String>::new());
    }
}
