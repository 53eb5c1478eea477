//! What a program says while it runs, as far as it is shown.

use std::io::{self, Read};

/// What a program has said in one place: the end of it, in full.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Said {
    /// The last lines.
    pub(crate) end: String,
    /// How many lines there were before.
    pub(crate) before: usize,
}

impl Said {
    /// What comes last from a pipe: an endless loop that prints must not fill the memory.
    pub(crate) fn read(mut pipe: impl Read) -> Self {
        const KEPT: usize = 1 << 20;
        let (mut all, mut part, mut before) = (Vec::new(), [0; 1 << 14], 0);
        loop {
            match pipe.read(&mut part) {
                Ok(0) => break,
                Ok(count) => all.extend_from_slice(&part[..count]),
                Err(e) if e.kind() == io::ErrorKind::Interrupted => {}
                Err(_) => break,
            }
            if all.len() > 2 * KEPT {
                before += all.drain(..all.len() - KEPT).filter(|&byte| byte == b'\n').count();
            }
        }
        Self { end: String::from_utf8_lossy(&all).replace("\r\n", "\n"), before }
    }

    /// The number of all lines.
    pub(crate) fn lines(&self) -> usize {
        self.before + self.end.trim_matches('\n').trim_end().lines().count()
    }

    /// The last lines under a heading; nothing if nothing was said.
    pub(crate) fn last_lines(&self, heading: &str) -> String {
        const LINES: usize = 20;
        let repeats = repeats(self.end.trim_matches('\n').trim_end().lines());
        let last = &repeats[repeats.len().saturating_sub(LINES)..];
        let (count, all) = (last.iter().map(|(_, count)| count).sum::<usize>(), self.lines());
        let heading = match count {
            0 => return String::new(),
            count if count == all => format!("{heading}:\n"),
            _ => format!("{heading}, the last {count} of {all} lines:\n"),
        };
        heading + &last.iter().map(shown).collect::<String>()
    }
}

/// A line, and how many times it was said.
type Repeated<'a> = (&'a str, usize);

/// Lines that are the same as the one before are only counted.
fn repeats<'a>(lines: impl Iterator<Item = &'a str>) -> Vec<Repeated<'a>> {
    let mut repeats: Vec<Repeated<'_>> = Vec::new();
    for line in lines {
        match repeats.last_mut() {
            Some((last, count)) if *last == line => *count += 1,
            _ => repeats.push((line, 1)),
        }
    }
    repeats
}

/// A line as it is shown: not too long, and once.
fn shown((line, count): &Repeated<'_>) -> String {
    const WIDTH: usize = 200;
    let end = line.char_indices().nth(WIDTH).map(|(end, _)| end);
    let line = end.map_or_else(|| (*line).into(), |end| format!("{} …", &line[..end]));
    let times = if *count > 1 && !line.is_empty() { format!("   ({count} times)") } else { String::new() };
    format!("  {line}{times}\n")
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// All that was said.
    pub(crate) fn said(text: &str) -> Said {
        Said::read(text.as_bytes())
    }

    #[test]
    fn of_very_much_only_the_end_is_kept_but_all_lines_are_counted() {
        let line = "x".repeat(99) + "\n";
        let kept = said(&(line.repeat(50_000) + "end\r\n"));
        assert!(kept.end.ends_with("x\nend\n") && kept.end.len() < 3 << 20);
        assert_eq!(kept.lines(), 50_001);
        let little = said("little");
        assert_eq!((little.end.as_str(), little.lines()), ("little", 1));
    }

    #[test]
    fn only_the_last_lines_are_shown() {
        let many: String = (1..=50).map(|i| format!("line {i}\n")).collect();
        let shown = said(&many).last_lines("It printed");
        assert!(shown.starts_with("It printed, the last 20 of 50 lines:\n  line 31\n"), "{shown}");
        assert!(shown.ends_with("  line 50\n"));
        let long = said(&"x".repeat(500)).last_lines("It printed");
        assert_eq!(long.lines().nth(1).map(|line| line.chars().count()), Some(204));
        assert_eq!(said(" \n\n").last_lines("It printed"), "");
    }

    #[test]
    fn a_line_that_is_repeated_is_shown_once() {
        let shown = said(&("a\n".to_owned() + &"b\n".repeat(900) + "a\n")).last_lines("It printed");
        assert_eq!(shown, "It printed:\n  a\n  b   (900 times)\n  a\n");
        assert_eq!(said("a\n\n\nb").last_lines("It printed"), "It printed:\n  a\n  \n  b\n");
    }
}
