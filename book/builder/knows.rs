//! `{{#knows chapter}}`: which module of a chapter knows which, read from its sources.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
};

use crate::{
    diagram,
    expand::Block,
    graph::Graph,
    house::{House, files_under, folder, name_of},
    output::Output,
    tokens::{Token, tokens, without_tests},
};

/// Files and folders at the top of a crate that only put its modules together, or prove them.
const GLUE: [&str; 5] = ["lib", "main", "bin", "pictures", "proof"];

/// The diagram of a chapter's modules.
pub(crate) fn block(house: &House, chapter: &str, output: &mut Output) -> Result<Block, String> {
    let chapter = house.chapter(chapter)?;
    let place = format!("chapters/{}/src", folder(chapter));
    let graph = modules(house, &place)?;
    if let Some(circle) = graph.circle() {
        return Err(format!("modules of `{place}` know each other in a circle: {}", circle.join(" → ")));
    }
    let mut block = Block::default();
    block.push(&output.block(diagram::draw(&graph, &format!("The modules of {}", chapter.name), "knows")));
    Ok(block)
}

/// The modules of a crate whose sources are in `place`; a folder is one module.
fn modules(house: &House, place: &str) -> Result<Graph, String> {
    let root = house.path(place);
    let mut sources: BTreeMap<String, Vec<(bool, String)>> = BTreeMap::new();
    let mut library = String::new();
    for path in files_under(&root).into_iter().filter(|path| path.extension().is_some_and(|e| e == "rs")) {
        let file = name_of(&path, &root);
        let text = fs::read_to_string(&path).map_err(|error| format!("`{place}/{file}` cannot be read: {error}"))?;
        let module = file.split('/').next().unwrap_or(&file).trim_end_matches(".rs").to_owned();
        if file == "lib.rs" {
            library.clone_from(&text);
        }
        // The tests of a module may have a file of their own.
        if !GLUE.contains(&module.as_str()) && !file.ends_with("/tests.rs") {
            let is_below_root = !file.contains('/') || file == format!("{module}/mod.rs");
            sources.entry(module).or_default().push((is_below_root, text));
        }
    }
    if sources.is_empty() {
        return Err(format!("there are no modules in `{place}`"));
    }
    let names: Vec<_> = sources.keys().cloned().collect();
    let exports = exports(&library, &names);
    let mut arrows = BTreeSet::new();
    for (from, texts) in sources.values().enumerate() {
        let roots = |is_below_root: bool| if is_below_root { ["crate", "super"].as_slice() } else { &["crate"] };
        for head in texts.iter().flat_map(|(is_below_root, text)| heads(text, roots(*is_below_root))) {
            let to = names.iter().position(|name| *name == head).or_else(|| exports.get(&head).copied());
            arrows.extend(to.filter(|&to| to != from).map(|to| (from, to)));
        }
    }
    Ok(Graph { names, arrows })
}

/// The names that follow `crate::`, or another word for the crate's root, in a source outside its tests.
fn heads(text: &str, roots: &[&str]) -> Vec<String> {
    let tokens = without_tests(tokens(text));
    let mut heads = Vec::new();
    for (index, window) in tokens.windows(3).enumerate() {
        if matches!(window, [Token::Name(root), Token::Sign(':'), Token::Sign(':')] if roots.contains(root)) {
            heads.extend(tree(&tokens[index + 3..]).into_iter().filter_map(|path| Some((*path.first()?).to_owned())));
        }
    }
    heads
}

/// What a library's root exports under another path, `pub use module::Name`, and the index of its module.
fn exports(text: &str, names: &[String]) -> BTreeMap<String, usize> {
    let tokens = without_tests(tokens(text));
    let mut exports = BTreeMap::new();
    for (index, window) in tokens.windows(2).enumerate() {
        if matches!(window, [Token::Name("pub"), Token::Name("use")]) {
            for path in tree(&tokens[index + 2..]) {
                let path: Vec<_> = path.into_iter().skip_while(|part| ["crate", "self"].contains(part)).collect();
                let module = path.first().and_then(|first| names.iter().position(|name| name == first));
                if let (Some(module), Some(last)) = (module, path.last()) {
                    exports.insert((*last).to_owned(), module);
                }
            }
        }
    }
    exports
}

/// The paths that a use tree spells out, such as `a::{b, c::D as E}`: here `a b` and `a c E`.
fn tree<'a>(tokens: &[Token<'a>]) -> Vec<Vec<&'a str>> {
    let (mut paths, mut path, mut open) = (Vec::new(), Vec::new(), Vec::new());
    // Whether the path goes on: at its start and behind `::`.
    let mut goes_on = true;
    for token in tokens {
        match token {
            Token::Name("as") => {
                path.pop();
                goes_on = true;
            }
            Token::Name(name) if goes_on => {
                path.push(*name);
                goes_on = false;
            }
            Token::Sign(':') => goes_on = true,
            Token::Sign('*') if goes_on => path.push("*"),
            Token::Sign('{') if goes_on => open.push(path.len()),
            Token::Sign(sign @ (',' | '}')) if !open.is_empty() => {
                let start = open.last().copied().unwrap_or(0);
                if path.len() > start {
                    paths.push(path.clone());
                }
                path.truncate(start);
                goes_on = *sign == ',';
                if *sign == '}' {
                    open.pop();
                    // The group itself is no path of the group around it.
                    path.truncate(open.last().copied().unwrap_or(0));
                }
            }
            _ => break,
        }
    }
    if !path.is_empty() {
        paths.push(path);
    }
    paths
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixture::Fixture;

    #[test]
    fn use_trees_are_spelled_out() {
        let paths = |text| tree(&tokens(text)).into_iter().map(|path| path.join(" ")).collect::<Vec<_>>();
        assert_eq!(paths("a::{b, c::{D as E, f}, *}; g"), ["a b", "a c E", "a c f", "a *"]);
        assert_eq!(paths("{hit::Hit, ray::Ray,};"), ["hit Hit", "ray Ray"]);
        assert_eq!(paths("ray::Ray { origin: a.b }"), ["ray Ray"]);
        assert_eq!(paths("Shape for Sphere {"), ["Shape"]);
    }

    #[test]
    fn modules_know_what_they_mention_outside_their_tests() {
        let fixture = Fixture::new();
        fixture.write(
            "chapters/01-toy/src/lib.rs",
            "pub mod ball; pub use ball::Ball; pub use self::ray::{Ray, Hit as Touch};",
        );
        fixture.write(
            "chapters/01-toy/src/ray.rs",
            "//! use crate::ball\npub struct Ray; #[cfg(test)] mod tests { use crate::ball::Ball; }",
        );
        fixture
            .write("chapters/01-toy/src/ball.rs", "use crate::{Touch}; fn f() -> &'static str { \"crate::scene::S\" }");
        fixture.write("chapters/01-toy/src/scene/mod.rs", "use super::ball::Ball; mod light;");
        fixture.write("chapters/01-toy/src/scene/light.rs", "fn f(ray: &crate::ray::Ray) {}");
        fixture.write("chapters/01-toy/src/ray/tests.rs", "use crate::{ball::Ball, scene};");
        fixture.write("chapters/01-toy/src/pictures/mod.rs", "use crate::scene;");
        let graph = modules(&fixture.house(), "chapters/01-toy/src").unwrap();
        assert_eq!(graph.names, ["ball", "ray", "scene"]);
        assert_eq!(graph.arrows, [(0, 1), (2, 0), (2, 1)].into());
    }

    #[test]
    fn circles_are_refused() {
        let fixture = Fixture::new();
        fixture.write("chapters/01-toy/src/ball.rs", "use crate::ray::Ray;");
        fixture.write("chapters/01-toy/src/ray.rs", "use crate::ball::Ball;");
        let error = block(&fixture.house(), "toy", &mut Output::default()).unwrap_err();
        assert!(error.contains("circle: ball → ray → ball"), "{error}");
    }
}
