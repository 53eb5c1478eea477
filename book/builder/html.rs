//! The tags of a page that mdBook has written, and what they refer to.

/// The start of an element.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Tag<'a> {
    /// Its name in small letters, as mdBook writes it.
    pub(crate) name: &'a str,
    attributes: Vec<(&'a str, String)>,
}

impl Tag<'_> {
    /// The value of an attribute; empty if it has none.
    pub(crate) fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(known, _)| *known == name).map(|(_, value)| value.as_str())
    }
}

/// The tags of a page, and the text of its style elements.
pub(crate) fn scan(page: &str) -> (Vec<Tag<'_>>, Vec<&str>) {
    let (mut tags, mut styles) = (Vec::new(), Vec::new());
    let mut rest = page;
    while let Some(start) = rest.find('<') {
        rest = &rest[start + 1..];
        if let Some(comment) = rest.strip_prefix("!--") {
            rest = comment.split_once("-->").map_or("", |(_, after)| after);
            continue;
        }
        if !rest.starts_with(|c: char| c.is_ascii_alphabetic()) {
            continue;
        }
        let (tag, after) = tag(rest);
        rest = after;
        // What stands in these elements is no markup.
        if matches!(tag.name, "script" | "style") {
            let (inside, after) = rest.split_at(rest.find(&format!("</{}", tag.name)).unwrap_or(rest.len()));
            if tag.name == "style" {
                styles.push(inside);
            }
            rest = after;
        }
        tags.push(tag);
    }
    (tags, styles)
}

/// A tag behind its `<`, and the text after it.
fn tag(text: &str) -> (Tag<'_>, &str) {
    let is_end = |c: char| c.is_ascii_whitespace() || matches!(c, '>' | '/' | '=');
    let (name, mut rest) = text.split_at(text.find(is_end).unwrap_or(text.len()));
    let mut attributes = Vec::new();
    loop {
        rest = rest.trim_start_matches(|c: char| c.is_ascii_whitespace() || matches!(c, '/' | '='));
        if let Some(after) = rest.strip_prefix('>') {
            return (Tag { name, attributes }, after);
        }
        if rest.is_empty() {
            return (Tag { name, attributes }, rest);
        }
        let (key, after) = rest.split_at(rest.find(is_end).unwrap_or(rest.len()));
        rest = after;
        let mut value = "";
        if let Some(after) = rest.trim_start().strip_prefix('=').map(str::trim_start) {
            (value, rest) = match after.chars().next().filter(|c| matches!(c, '"' | '\'')) {
                Some(quote) => after[1..].split_once(quote).unwrap_or((&after[1..], "")),
                None => {
                    after.split_at(after.find(|c: char| c.is_ascii_whitespace() || c == '>').unwrap_or(after.len()))
                }
            };
        }
        attributes.push((key, unescape(value)));
    }
}

/// Text without character references, as far as mdBook and this crate write them.
fn unescape(text: &str) -> String {
    let mut plain = text.to_owned();
    for (name, c) in [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&#39;", "'"), ("&#x27;", "'"), ("&amp;", "&")] {
        plain = plain.replace(name, c);
    }
    plain
}

/// What a style sheet loads: `url(…)` and `@import "…"`.
pub(crate) fn loads(css: &str) -> Vec<&str> {
    let ends: [(&str, char); 4] = [("url(", ')'), ("@import \"", '"'), ("@import '", '\''), ("@import url(", ')')];
    let mut loads = Vec::new();
    for (start, end) in ends {
        let found = css.match_indices(start).filter_map(|(at, _)| css[at + start.len()..].split(end).next());
        loads.extend(found.map(|url| url.trim().trim_matches(['"', '\''])));
    }
    loads
}

/// A path or a fragment of an address with its `%20` and such decoded.
pub(crate) fn decode(text: &str) -> String {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let Some((&byte, after)) = rest.split_first() {
        let digits = after.get(..2).filter(|_| byte == b'%').and_then(|hex| std::str::from_utf8(hex).ok());
        if let Some(decoded) = digits.and_then(|hex| u8::from_str_radix(hex, 16).ok()) {
            bytes.push(decoded);
            rest = &after[2..];
        } else {
            bytes.push(byte);
            rest = after;
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tags_are_found_with_their_attributes() {
        let page = "<!DOCTYPE html><!-- <a> --><a href=\"x.html#y\" hidden>1 < 2</a><img src='a&amp;b.png' alt=\"\"/>\
                    <script>if (a<b) \"<p>\"</script><style>p { background: url(\"q.png\") }</style><br>";
        let (tags, styles) = scan(page);
        assert_eq!(tags.iter().map(|tag| tag.name).collect::<Vec<_>>(), ["a", "img", "script", "style", "br"]);
        assert_eq!(tags[0].attribute("href"), Some("x.html#y"));
        assert_eq!((tags[0].attribute("hidden"), tags[0].attribute("id")), (Some(""), None));
        assert_eq!((tags[1].attribute("src"), tags[1].attribute("alt")), (Some("a&b.png"), Some("")));
        assert_eq!(loads(styles[0]), ["q.png"]);
    }

    #[test]
    fn broken_pages_end() {
        for page in ["<", "<a", "<a href=\"x", "<!-- x", "<script>", "<a href=>", "<a =x>"] {
            scan(page);
        }
    }

    #[test]
    fn addresses_are_decoded() {
        assert_eq!(decode("a%20b%C3%A9%"), "a bé%");
        assert_eq!(loads("@import \"a.css\"; b { c: url( d ) }"), ["d", "a.css"]);
    }
}
