//! `{{#crates}}`: which crate of the workspace depends on which, read from the manifests.

use std::{collections::BTreeSet, fs, path::Path};

use toml::{Table, Value};

use crate::{diagram, expand::Block, graph::Graph, house::House, output::Output};

/// The tables of a manifest that name what a crate depends on.
const DEPENDENCIES: [&str; 2] = ["dependencies", "dev-dependencies"];

/// The diagram of the workspace's crates.
pub(crate) fn block(house: &House, output: &mut Output) -> Result<Block, String> {
    let graph = crates(house)?;
    if let Some(circle) = graph.circle() {
        return Err(format!("crates depend on each other in a circle: {}", circle.join(" → ")));
    }
    let mut block = Block::default();
    block.push(&output.block(diagram::draw(&graph, "The crates of the course", "depends on")));
    Ok(block)
}

/// The crates of the workspace, and which depends on which.
fn crates(house: &House) -> Result<Graph, String> {
    let workspace = manifest(house, "Cargo.toml")?;
    let members = workspace.get("workspace").and_then(|w| w.get("members")).and_then(Value::as_array);
    let members = members.ok_or("`Cargo.toml` lists no members of the workspace")?;
    let mut crates = Vec::new();
    for folder in members.iter().filter_map(Value::as_str).flat_map(|member| folders(house, member)) {
        let manifest = manifest(house, &format!("{folder}/Cargo.toml"))?;
        let name = manifest.get("package").and_then(|p| p.get("name")).and_then(Value::as_str);
        let name = name.ok_or_else(|| format!("`{folder}/Cargo.toml` names no package"))?.to_owned();
        crates.push((name, manifest));
    }
    let names: Vec<_> = crates.iter().map(|(name, _)| name.clone()).collect();
    let mut arrows = BTreeSet::new();
    for (from, (_, manifest)) in crates.iter().enumerate() {
        let tables = DEPENDENCIES.iter().filter_map(|table| manifest.get(*table)?.as_table());
        let known = tables.flat_map(Table::keys).filter_map(|key| names.iter().position(|name| name == key));
        arrows.extend(known.map(|to| (from, to)));
    }
    Ok(Graph { names, arrows })
}

/// The folders with a manifest that a member stands for: itself, or all in `folder/*`.
fn folders(house: &House, member: &str) -> Vec<String> {
    let Some(parent) = member.strip_suffix("/*") else { return vec![member.to_owned()] };
    let entries = fs::read_dir(house.path(parent)).into_iter().flatten().flatten();
    let has_manifest = |path: &Path| path.join("Cargo.toml").is_file();
    let mut found: Vec<_> = entries
        .filter(|entry| has_manifest(&entry.path()))
        .map(|entry| format!("{parent}/{}", entry.file_name().to_string_lossy()))
        .collect();
    found.sort();
    found
}

/// A manifest.
fn manifest(house: &House, file: &str) -> Result<Table, String> {
    house.read(file)?.parse().map_err(|error: toml::de::Error| format!("`{file}`: {}", error.message()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixture::Fixture;

    #[test]
    fn manifests_are_read() {
        let fixture = Fixture::new();
        fixture.write("Cargo.toml", "[workspace]\nmembers = [\"common\", \"chapters/*\"]");
        fixture.write("common/Cargo.toml", "[package]\nname = \"common\"\n[dependencies]\nglam = \"1\"");
        fixture
            .write("chapters/01-toy/Cargo.toml", "[package]\nname = \"toy\"\n[dependencies]\ncommon.workspace = true");
        fixture.write("chapters/02-next/Cargo.toml", "[package]\nname = \"next\"\n[dev-dependencies]\ntoy = {}");
        fixture.write("chapters/notes.txt", "");
        let graph = crates(&fixture.house()).unwrap();
        assert_eq!(graph.names, ["common", "toy", "next"]);
        assert_eq!(graph.arrows, [(1, 0), (2, 1)].into());
        fixture.write("common/Cargo.toml", "[package]\nname = \"common\"\n[dependencies]\nnext = {}");
        let error = block(&fixture.house(), &mut Output::default()).unwrap_err();
        assert!(error.contains("circle"), "{error}");
        fixture.write("common/Cargo.toml", "[package");
        assert!(crates(&fixture.house()).unwrap_err().contains("common/Cargo.toml"));
    }
}
