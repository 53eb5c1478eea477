//! A unit sphere made of triangles, as fine as you like.

use std::collections::HashMap;

use common::{Vec3, obj::ObjMesh};

/// An icosahedron whose triangles are divided into four, `levels` times: 20·4^levels triangles, facing outward.
pub(crate) fn icosphere(levels: u32) -> ObjMesh {
    let golden = f32::midpoint(1.0, 5.0_f32.sqrt());
    let mut positions: Vec<Vec3> = Vec::new();
    for (a, b) in [(-1.0, golden), (1.0, golden), (-1.0, -golden), (1.0, -golden)] {
        positions.extend([Vec3::new(a, b, 0.0), Vec3::new(0.0, a, b), Vec3::new(b, 0.0, a)].map(Vec3::normalize));
    }
    // Three corners as near to each other as two can be form a triangle; turn it outward.
    let side = (positions[0] - positions[3]).length() * 1.01;
    let near = |a: u32, b: u32| (positions[a as usize] - positions[b as usize]).length() < side;
    let mut triangles = Vec::new();
    for a in 0..12_u32 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if near(a, b) && near(b, c) && near(c, a) {
                    let [p, q, r] = [a, b, c].map(|i| positions[i as usize]);
                    let is_outward = (q - p).cross(r - p).dot(p) > 0.0;
                    triangles.push(if is_outward { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    for _ in 0..levels {
        // Divide each edge once, whichever of its two triangles comes first.
        let mut middles = HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                positions.push((positions[a as usize] + positions[b as usize]).normalize());
                positions.len() as u32 - 1
            })
        };
        let mut finer = Vec::with_capacity(4 * triangles.len());
        for [a, b, c] in triangles {
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            finer.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
        triangles = finer;
    }
    ObjMesh { positions, triangles, ..ObjMesh::default() }
}

#[test]
fn an_icosphere_has_the_right_numbers_of_everything() {
    for (levels, triangles) in [(0, 20), (1, 80), (3, 1280)] {
        let mesh = icosphere(levels);
        assert_eq!((mesh.triangles.len(), mesh.positions.len()), (triangles, triangles / 2 + 2));
    }
}
