//! Meshes from Wavefront OBJ files.

use std::{fmt::Write as _, path::Path};

use glam::Vec3;

use crate::error::{Error, reason};

/// The triangles of an OBJ file. Polygons are cut into fans.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ObjMesh {
    /// Positions of the vertices, in the file's own unit.
    pub positions: Vec<Vec3>,
    /// Normals as the file gives them, not always of unit length. Empty if any face comes without.
    pub normals: Vec<Vec3>,
    /// For each triangle the indices of its three positions.
    pub triangles: Vec<[u32; 3]>,
    /// For each triangle the indices of its three normals. Empty if `normals` is.
    pub triangle_normals: Vec<[u32; 3]>,
}

/// What is wrong inside an OBJ file, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ObjError {
    /// The file is not text.
    #[error("this is not a text file, so not an OBJ file")]
    NotText,
    /// The file has no face.
    #[error("no face ('f' record) in the whole file: nothing to be seen")]
    NoFaces,
    /// A line cannot be understood.
    #[error("line {line}: {reason}")]
    Line {
        /// Its number, from 1.
        line: usize,
        /// What is wrong with it, and what would be right.
        reason: String,
    },
    /// The file passed our checks and still the library refused it.
    #[error("{0}")]
    Other(String),
}

/// Read the mesh in a file.
///
/// # Errors
/// [`Error::Read`] if there is no such file or it is a folder, [`Error::Obj`] if its content is damaged.
pub fn read(path: &Path) -> Result<ObjMesh, Error> {
    let name = path.display().to_string();
    if path.is_dir() {
        return Err(Error::Read { name, reason: "it is a folder, not an OBJ file".into() });
    }
    match std::fs::read(path) {
        Ok(bytes) => parse(&bytes).map_err(|error| Error::Obj { file: name, error }),
        Err(error) => Err(Error::Read { name, reason: reason(&error) }),
    }
}

/// Read the mesh in the bytes of an OBJ file.
///
/// Understood are positions, normals and faces of any number of corners, with positive or negative indices. All other
/// records (texture coordinates, groups, materials, lines, curves, colors of vertices) are left out. Files from
/// Windows, comments and lines continued by `\` are fine.
///
/// # Errors
/// [`ObjError`] says in which line and what would be right.
pub fn parse(bytes: &[u8]) -> Result<ObjMesh, ObjError> {
    if bytes.contains(&0) {
        return Err(ObjError::NotText);
    }
    let tidy = tidy(&String::from_utf8_lossy(bytes))?;
    let options = tobj::LoadOptions { triangulate: true, ..Default::default() };
    let no_materials = |_: &Path| Err(tobj::LoadError::GenericFailure);
    let (models, _) = tobj::load_obj_buf(&mut tidy.as_bytes(), &options, no_materials)
        .map_err(|error| ObjError::Other(error.to_string()))?;
    let mesh = models.into_iter().next().ok_or(ObjError::NoFaces)?.mesh;

    let vectors = |numbers: &[f32]| numbers.as_chunks().0.iter().copied().map(Vec3::from_array).collect();
    let triples = |indices: &[u32]| indices.as_chunks().0.to_vec();
    Ok(ObjMesh {
        positions: vectors(&mesh.positions),
        normals: vectors(&mesh.normals),
        triangles: triples(&mesh.indices),
        triangle_normals: triples(&mesh.normal_indices),
    })
}

/// Check every line and keep only what is needed, so that the library meets nothing it would misread and every error
/// can say its line. (The crate tobj takes `l 1 2 3` for a triangle, fails on a comment behind a record, overflows on
/// some negative indices, and does not say where.)
fn tidy(text: &str) -> Result<String, ObjError> {
    let mut tidy = String::with_capacity(text.len());
    let mut tidy_normals = String::new();
    let (mut positions, mut normals) = (0, 0);
    let mut faces: Vec<Vec<(usize, Option<usize>)>> = Vec::new();
    let mut continued = String::new();
    for (line, text) in (1..).zip(text.lines()) {
        let wrong = |reason: String| ObjError::Line { line, reason };
        let text = text.split('#').next().unwrap_or_default().trim();
        if let Some(start) = text.strip_suffix('\\') {
            continued.push_str(start);
            continued.push(' ');
            continue;
        }
        let record = std::mem::take(&mut continued) + text;
        let mut words = record.split_whitespace();
        match words.next() {
            Some(kind @ ("v" | "vn")) => {
                let [x, y, z] = vector(kind, words).map_err(wrong)?;
                let (text, count) =
                    if kind == "v" { (&mut tidy, &mut positions) } else { (&mut tidy_normals, &mut normals) };
                // Writing to a string cannot fail.
                let _ = writeln!(text, "{kind} {x:?} {y:?} {z:?}");
                *count += 1;
            }
            Some("f") => {
                let corners: Result<Vec<_>, _> = words.map(|word| corner(word, positions, normals)).collect();
                let corners = corners.map_err(wrong)?;
                if corners.len() < 3 {
                    let found = corners.len();
                    return Err(wrong(format!("a face needs at least 3 corners, this one has {found}")));
                }
                faces.push(corners);
            }
            _ => {}
        }
    }
    if faces.is_empty() {
        return Err(ObjError::NoFaces);
    }
    let all_have_normals = faces.iter().flatten().all(|(_, normal)| normal.is_some());
    if all_have_normals {
        tidy.push_str(&tidy_normals);
    }
    for face in faces {
        tidy.push('f');
        for (position, normal) in face {
            let _ = match normal.filter(|_| all_have_normals) {
                Some(normal) => write!(tidy, " {position}//{normal}"),
                None => write!(tidy, " {position}"),
            };
        }
        tidy.push('\n');
    }
    Ok(tidy)
}

/// The first three numbers of a `v` or `vn` record.
fn vector<'a>(kind: &str, words: impl Iterator<Item = &'a str>) -> Result<[f32; 3], String> {
    let mut numbers = [0.0_f32; 3];
    let mut found = 0;
    for (number, word) in numbers.iter_mut().zip(words) {
        *number = word.parse().map_err(|_| format!("'{word}' in a '{kind}' record is not a number"))?;
        if !number.is_finite() {
            return Err(format!("'{word}' in a '{kind}' record is no finite number"));
        }
        found += 1;
    }
    if found == 3 { Ok(numbers) } else { Err(format!("a '{kind}' record needs 3 numbers, this one has {found}")) }
}

/// One corner of a face, `position/texture/normal`, as indices from 1 counted from the start of the file.
fn corner(word: &str, positions: usize, normals: usize) -> Result<(usize, Option<usize>), String> {
    let mut parts = word.split('/');
    let position = index(parts.next().unwrap_or_default(), word, positions, "vertices")?;
    let normal = match parts.nth(1) {
        None | Some("") => None,
        Some(part) => Some(index(part, word, normals, "normals")?),
    };
    Ok((position, normal))
}

/// An index from 1. Negative ones count back from the last of `count`.
fn index(part: &str, word: &str, count: usize, what: &str) -> Result<usize, String> {
    let index: i64 =
        part.parse().map_err(|_| format!("'{word}' is not a corner of a face: expected like 7 or 7//3"))?;
    let from_start =
        if index < 0 { count.checked_add_signed(index as isize).map(|i| i + 1) } else { index.try_into().ok() };
    from_start
        .filter(|i| (1..=count).contains(i))
        .ok_or_else(|| format!("corner '{word}' asks for number {index} of {count} {what} so far"))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

    fn triangles(text: &str) -> Result<Vec<[u32; 3]>, String> {
        parse(text.as_bytes()).map(|m| m.triangles).map_err(|e| e.to_string())
    }

    #[test]
    fn polygons_become_fans() {
        let mesh = parse(b"v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\n").unwrap();
        assert_eq!(mesh.triangles.len(), 3);
        assert!(mesh.triangles.iter().all(|t| t[0] == 0));
    }

    #[test]
    fn all_ways_to_write_the_same_triangle() {
        for face in [
            "f 1 2 3",
            "f -3 -2 -1",
            "f 1/1 2/2 3/3",
            "f 1// 2// 3//",
            "f 1 2 \\\n 3",
            "f 1 2 3 # why not",
            "\tf\t1\t2\t3",
        ] {
            for end in ["\n", "\r\n"] {
                let unused = "o thing\ng\nusemtl none\nmtllib nowhere.mtl\ns off\nvt 0 0\nl 1 2 3\np 1\nvp 1 2\n";
                let text = format!("{unused}{TRIANGLE}{face}\n{unused}").replace('\n', end);
                assert_eq!(triangles(&text), Ok(vec![[0, 1, 2]]), "{text}");
            }
        }
    }

    #[test]
    fn normals_count_only_if_every_corner_has_one() {
        let with = parse(format!("{TRIANGLE}vn 0 0 2\nf 1//1 2//-1 3//1\n").as_bytes()).unwrap();
        assert_eq!((with.normals, with.triangle_normals), (vec![Vec3::Z * 2.0], vec![[0, 0, 0]]));
        let without = parse(format!("{TRIANGLE}vn 0 0 2\nf 1//1 2//1 3//1\nf 1 2 3\n").as_bytes()).unwrap();
        assert_eq!((without.normals, without.triangles.len()), (vec![], 2));
    }

    #[test]
    fn damage_is_told_with_its_line() {
        for (text, expected) in [
            ("", "no face ('f' record) in the whole file: nothing to be seen"),
            ("v 0 0\n", "line 1: a 'v' record needs 3 numbers, this one has 2"),
            ("v 0 zero 0\n", "line 1: 'zero' in a 'v' record is not a number"),
            ("v 0 0 nan\n", "line 1: 'nan' in a 'v' record is no finite number"),
            ("v 0 0 0\nv 0 0 0\nf 1 2\n", "line 3: a face needs at least 3 corners, this one has 2"),
            ("v 0 0 0\nf 1 2 3\n", "line 2: corner '2' asks for number 2 of 1 vertices so far"),
            ("v 0 0 0\nf 0 1 1\n", "line 2: corner '0' asks for number 0 of 1 vertices so far"),
            ("v 0 0 0\nf 1 1 -2\n", "line 2: corner '-2' asks for number -2 of 1 vertices so far"),
            ("v 0 0 0\nf 1 1 1//1\n", "line 2: corner '1//1' asks for number 1 of 0 normals so far"),
            ("v 0 0 0\nf 1 1 x\n", "line 2: 'x' is not a corner of a face: expected like 7 or 7//3"),
        ] {
            assert_eq!(triangles(text), Err(expected.into()));
        }
        assert_eq!(parse(b"v 0 0 0\0"), Err(ObjError::NotText));
    }

    proptest! {
        /// No text at all makes a panic, and whatever is accepted has all its indices in range.
        #[test]
        fn never_panics(lines in prop::collection::vec("(v|vn|f|l|#|o)( -?[0-9./e]{0,4}){0,5}", 0..30)) {
            if let Ok(mesh) = parse(lines.join("\n").as_bytes()) {
                let in_range = |all: &[[u32; 3]], n: usize| all.iter().flatten().all(|&i| (i as usize) < n);
                prop_assert!(in_range(&mesh.triangles, mesh.positions.len()));
                prop_assert!(in_range(&mesh.triangle_normals, mesh.normals.len()));
                prop_assert!(mesh.triangle_normals.is_empty() || mesh.triangle_normals.len() == mesh.triangles.len());
            }
        }
    }
}
