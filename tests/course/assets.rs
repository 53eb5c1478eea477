//! The meshes in `assets` are made here, so that everybody can see how, and change them.
//!
//! `UPDATE_ASSETS=1 cargo test -p tests assets` writes them anew.

use std::{
    fmt::Write as _,
    fs,
    path::{Path, PathBuf},
};

use common::{Vec3, float};

/// Text of an OBJ file under construction.
#[derive(Default)]
struct Obj {
    text: String,
    vertices: usize,
}

impl Obj {
    fn comment(&mut self, text: &str) {
        writeln!(self.text, "# {text}").unwrap();
    }

    /// Add a vertex, rounded to four decimals, and return its number.
    fn vertex(&mut self, v: Vec3) -> usize {
        // Adding zero turns −0 into 0.
        let [x, y, z] = v.to_array().map(|c| (f64::from(c) * 1e4).round() / 1e4 + 0.0);
        writeln!(self.text, "v {x} {y} {z}").unwrap();
        self.vertices += 1;
        self.vertices
    }

    fn face(&mut self, corners: &[usize]) {
        let corners: Vec<_> = corners.iter().map(ToString::to_string).collect();
        writeln!(self.text, "f {}", corners.join(" ")).unwrap();
    }
}

/// A point on a circle around the y axis; `turn` in whole turns.
fn on_circle(radius: f32, y: f32, turn: f32) -> Vec3 {
    let angle = turn * std::f32::consts::TAU;
    Vec3::new(radius * float::cos(angle), y, radius * float::sin(angle))
}

/// The outline of the pawn from bottom to top: radius and height.
const PAWN: [(f32, f32); 13] = [
    (0.6, 0.0),
    (0.6, 0.14),
    (0.5, 0.26),
    (0.36, 0.46),
    (0.22, 0.8),
    (0.18, 1.12),
    (0.37, 1.2),
    (0.2, 1.3),
    (0.31, 1.42),
    (0.37, 1.58),
    (0.33, 1.76),
    (0.21, 1.91),
    (0.08, 1.98),
];

/// A pawn as a turner makes it: its outline turned about the y axis in 16 steps, in quads, closed at both ends.
fn pawn() -> String {
    const STEPS: usize = 16;
    let mut obj = Obj::default();
    obj.comment("A chess pawn, 2 units high, made by tests/course/assets.rs. Quads and two polygons; no normals.");
    let mut rings = Vec::new();
    for (radius, y) in PAWN {
        let ring: Vec<_> = (0..STEPS).map(|i| obj.vertex(on_circle(radius, y, i as f32 / STEPS as f32))).collect();
        rings.push(ring);
    }
    for pair in rings.windows(2) {
        for i in 0..STEPS {
            let next = (i + 1) % STEPS;
            obj.face(&[pair[0][i], pair[1][i], pair[1][next], pair[0][next]]);
        }
    }
    obj.face(&rings[0]);
    obj.face(&rings.last().unwrap().iter().rev().copied().collect::<Vec<_>>());
    obj.text
}

/// A cluster of pointed six-sided crystals that grow from the origin: axis, width at the foot, length.
const CRYSTALS: [(Vec3, f32, f32); 3] = [
    (Vec3::new(0.1, 1.0, 0.05), 0.26, 1.0),
    (Vec3::new(0.75, 0.8, 0.25), 0.17, 0.66),
    (Vec3::new(-0.6, 0.75, 0.35), 0.14, 0.52),
];

/// The crystals: for each a foot, shoulders and a tip, with flat sides.
fn gem() -> String {
    let mut obj = Obj::default();
    obj.comment("Three crystals, 1 unit high, made by tests/course/assets.rs. Quads and triangles; no normals.");
    for (axis, width, length) in CRYSTALS {
        let axis = axis.normalize();
        let basis = common::Basis::around(axis);
        let ring = |obj: &mut Obj, along: f32, width: f32| -> Vec<usize> {
            let corner = |i: usize| {
                let around = on_circle(width, 0.0, i as f32 / 6.0 + 0.04);
                // Every other side is wider, as in quartz.
                let around = around * if i.is_multiple_of(2) { 1.0 } else { 0.9 };
                axis * along + basis.tangent * around.x + basis.bitangent * around.z
            };
            (0..6).map(|i| obj.vertex(corner(i))).collect()
        };
        let foot = ring(&mut obj, -0.1 * length, width);
        let shoulder = ring(&mut obj, 0.68 * length, width * 0.92);
        let tip = obj.vertex(axis * length);
        for i in 0..6 {
            let next = (i + 1) % 6;
            obj.face(&[foot[i], foot[next], shoulder[next], shoulder[i]]);
            obj.face(&[shoulder[i], shoulder[next], tip]);
        }
    }
    obj.text
}

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../assets").join(name)
}

#[test]
fn assets_are_what_their_makers_make() {
    for (name, text) in [("pawn.obj", pawn()), ("gem.obj", gem())] {
        if std::env::var_os("UPDATE_ASSETS").is_some() {
            fs::write(path(name), &text).unwrap();
        }
        assert_eq!(fs::read_to_string(path(name)).unwrap(), text, "{name}: run with UPDATE_ASSETS=1 to write it anew");
    }
}

/// The normal of every face points away from the axis or along it: corners run counter-clockwise seen from outside.
#[test]
fn assets_face_outward() {
    for (name, center) in [("pawn.obj", Vec3::Y), ("gem.obj", Vec3::new(0.05, 0.4, 0.1))] {
        let mesh = common::obj::read(&path(name)).unwrap();
        let mut volume = 0.0;
        for corners in &mesh.triangles {
            let [a, b, c] = corners.map(|i| mesh.positions[i as usize] - center);
            volume += a.dot(b.cross(c)) / 6.0;
        }
        assert!(volume > 0.05, "{name} has volume {volume}");
    }
}
