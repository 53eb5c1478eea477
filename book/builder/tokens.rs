//! As much of Rust's tokens as it takes to see which names a source mentions.

/// A name or a sign; literals, lifetimes and comments are left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Token<'a> {
    /// An identifier or a keyword.
    Name(&'a str),
    /// One character of punctuation.
    Sign(char),
}

/// The tokens of a source.
pub(crate) fn tokens(source: &str) -> Vec<Token<'_>> {
    let mut tokens = Vec::new();
    let mut rest = source;
    while let Some(c) = rest.chars().next() {
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            block_comment(rest)
        } else if let Some(length) = raw_string(rest) {
            length
        } else if c == '"' {
            quoted(rest, '"')
        } else if c == '\'' {
            // A character such as 'x' or '\n', or a lifetime such as 'a.
            let mut after = rest.chars().skip(1);
            match (after.next(), after.next()) {
                (Some('\\'), _) | (Some(_), Some('\'')) => quoted(rest, '\''),
                _ => 1 + rest[1..].find(|c: char| !is_word(c)).unwrap_or(rest.len() - 1),
            }
        } else if is_word(c) {
            let length = rest.find(|c: char| !is_word(c)).unwrap_or(rest.len());
            if !c.is_ascii_digit() {
                tokens.push(Token::Name(&rest[..length]));
            }
            length
        } else {
            if !c.is_whitespace() {
                tokens.push(Token::Sign(c));
            }
            c.len_utf8()
        };
        rest = &rest[length..];
    }
    tokens
}

/// Whether a character is part of a name.
fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The length of a comment that may hold others.
fn block_comment(text: &str) -> usize {
    let mut depth = 0;
    let mut at = 0;
    while let Some(rest) = text.get(at..).filter(|rest| !rest.is_empty()) {
        if rest.starts_with("/*") {
            (depth, at) = (depth + 1, at + 2);
        } else if rest.starts_with("*/") {
            (depth, at) = (depth - 1, at + 2);
            if depth == 0 {
                break;
            }
        } else {
            at += rest.chars().next().map_or(1, char::len_utf8);
        }
    }
    at
}

/// The length of a raw string such as `r#"…"#` or `br"…"` at the start of a text.
fn raw_string(text: &str) -> Option<usize> {
    let after = text.strip_prefix("br").or_else(|| text.strip_prefix("cr")).or_else(|| text.strip_prefix('r'))?;
    let hashes = after.len() - after.trim_start_matches('#').len();
    let inside = after[hashes..].strip_prefix('"')?;
    let end = format!("\"{}", "#".repeat(hashes));
    let length = inside.find(&end).map_or(inside.len(), |at| at + end.len());
    Some(text.len() - inside.len() + length)
}

/// The length of a quoted literal, in which a backslash takes the next character with it.
fn quoted(text: &str, quote: char) -> usize {
    let mut is_escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        match c {
            _ if is_escaped => is_escaped = false,
            '\\' => is_escaped = true,
            c if c == quote => return at + 1,
            _ => {}
        }
    }
    text.len()
}

/// The tokens without the items that are compiled for tests only.
pub(crate) fn without_tests(tokens: Vec<Token<'_>>) -> Vec<Token<'_>> {
    let mut kept = Vec::with_capacity(tokens.len());
    let mut rest = tokens.as_slice();
    while let Some((&token, after)) = rest.split_first() {
        if let [Token::Sign('#'), Token::Sign('['), Token::Name("cfg"), ..] = rest {
            let attribute = &rest[..group(&rest[1..]) + 1];
            let names = |name| attribute.contains(&Token::Name(name));
            rest = &rest[attribute.len()..];
            if names("test") && !names("not") {
                rest = &rest[item(rest)..];
            }
        } else {
            kept.push(token);
            rest = after;
        }
    }
    kept
}

/// The length of a group that starts with a bracket.
fn group(tokens: &[Token<'_>]) -> usize {
    let mut depth = 0;
    for (index, token) in tokens.iter().enumerate() {
        match token {
            Token::Sign('(' | '[' | '{') => depth += 1,
            Token::Sign(')' | ']' | '}') => depth -= 1,
            _ => {}
        }
        if depth <= 0 {
            return index + 1;
        }
    }
    tokens.len()
}

/// The length of an item: to its semicolon, or to the end of its braces.
fn item(tokens: &[Token<'_>]) -> usize {
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        match token {
            Token::Sign(';') => return at + 1,
            Token::Sign('{') => return at + group(&tokens[at..]),
            Token::Sign('(' | '[') => at += group(&tokens[at..]),
            _ => at += 1,
        }
    }
    tokens.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(source: &str) -> Vec<&str> {
        let names = without_tests(tokens(source)).into_iter();
        names.filter_map(|token| if let Token::Name(name) = token { Some(name) } else { None }).collect()
    }

    #[test]
    fn comments_and_literals_are_left_out() {
        let source = r####"// a
            /* b /* c */ d */ let e = "f \" g"; 'h'; '\''; let i: &'static str = r#"j " k"#; 1.0e5_f32 b'x' l"####;
        assert_eq!(names(source), ["let", "e", "let", "i", "str", "b", "l"].map(|n| n));
    }

    #[test]
    fn items_for_tests_are_left_out() {
        let source = "use a; #[cfg(test)] #[allow(x)] mod tests { use b; fn f() { {} } } #[cfg(test)] use c::{d, e}; \
                      #[cfg(not(test))] fn g() {} #[cfg(test)] const H: [u8; 2] = [1; 2]; i";
        assert_eq!(names(source), ["use", "a", "fn", "g", "i"]);
    }

    #[test]
    fn unfinished_sources_end() {
        for source in ["\"open", "/* open", "r#\"open", "'", "'\\", "#[cfg(test", "#[cfg(test)] mod x {", "é'é"] {
            without_tests(tokens(source));
        }
    }
}
