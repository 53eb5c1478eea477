//! Makes a stub of a solution.
//!
//! There is one source for both: in the solution, a block is marked with what stands in its place in the stub.
//!
//! ```text
//! // STUB: let _ = ray; // take this line away when you start
//! // STUB: None
//! the lines of the solution
//! // END STUB
//! ```
//!
//! A block that begins with a bare `// STUB:` leaves nothing in the stub. Everything outside the blocks is the same in both.

const BEGIN: &str = "// STUB:";
const END: &str = "// END STUB";

/// The text of the stub that belongs to the text of a solution.
///
/// # Errors
/// In one line, which mark has no partner.
pub(crate) fn stub_of(solution: &str) -> Result<String, String> {
    let mut stub = String::new();
    let mut place = Place::Outside;
    for (index, line) in solution.lines().enumerate() {
        let wrong = |what: &str| Err(format!("line {}: {what}", index + 1));
        let (indent, code) = line.split_at(line.len() - line.trim_start().len());
        place = match (code.strip_prefix(BEGIN), code.trim_end() == END) {
            (Some(_), _) if place == Place::Solution => return wrong("a block begins inside another one"),
            (Some(replacement), _) => {
                let replacement = replacement.strip_prefix(' ').unwrap_or(replacement);
                if !replacement.is_empty() {
                    stub += &format!("{indent}{replacement}\n");
                }
                Place::Marks
            }
            (None, true) if place == Place::Outside => return wrong("a block ends that has not begun"),
            (None, true) => Place::Outside,
            (None, false) if place == Place::Outside => {
                stub += line;
                stub.push('\n');
                Place::Outside
            }
            (None, false) => Place::Solution,
        };
    }
    if place == Place::Outside { Ok(stub) } else { Err(format!("the last block does not end: `{END}` is missing")) }
}

/// The text of a solution without its marks, as a reader wants it.
pub(crate) fn without_marks(solution: &str) -> String {
    let is_mark = |line: &&str| line.trim_start().starts_with(BEGIN) || line.trim() == END;
    solution.lines().filter(|line| !is_mark(line)).flat_map(|line| [line, "\n"]).collect()
}

/// Where a line stands.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Place {
    /// In what both have.
    Outside,
    /// Among the lines that the stub has in place of a block.
    Marks,
    /// In what only the solution has.
    Solution,
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOLUTION: &str = "\
fn half(x: f32) -> f32 {
    // STUB: let _ = x;
    // STUB:     0.0
    // Divide.
    x / two()
    // END STUB
}
// STUB:

fn two() -> f32 {
    2.0
}
// END STUB

fn main() {}
";

    #[test]
    fn blocks_are_replaced_and_keep_their_indent() {
        let stub = "fn half(x: f32) -> f32 {\n    let _ = x;\n        0.0\n}\n\nfn main() {}\n";
        assert_eq!(stub_of(SOLUTION).unwrap(), stub);
        assert_eq!(stub_of(&SOLUTION.replace('\n', "\r\n")).unwrap(), stub);
        assert_eq!(stub_of(stub).unwrap(), stub);
    }

    #[test]
    fn a_reader_sees_no_marks() {
        let text = without_marks(SOLUTION);
        assert!(!text.contains("STUB") && text.contains("    // Divide.\n    x / two()\n}\n\nfn two()"), "{text}");
    }

    #[test]
    fn marks_without_a_partner_are_told_by_line() {
        for (text, expected) in [
            ("a\n// END STUB\n", "line 2: a block ends"),
            ("// STUB: a\nb\n", "the last block does not end"),
            ("// STUB: a\nb\n// STUB: c\nd\n// END STUB\n", "line 3: a block begins inside"),
        ] {
            let message = stub_of(text).unwrap_err();
            assert!(message.starts_with(expected), "{message}");
        }
    }
}
