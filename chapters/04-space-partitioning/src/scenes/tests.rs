//! Tests of all generators.

use super::GENERATORS;
use crate::model::Model;

/// Numbers of triangles that are asked for, and by what factor the result may differ.
const SIZES: [(u32, f32); 7] =
    [(100, 2.0), (300, 2.0), (1000, 1.15), (3000, 1.15), (10_000, 1.15), (30_000, 1.15), (100_000, 1.15)];

/// The bits of all positions.
fn bits(model: &Model) -> Vec<[u32; 3]> {
    model.mesh.positions.iter().map(|position| position.to_array().map(f32::to_bits)).collect()
}

#[test]
fn scenes_have_about_the_wanted_size() {
    for generator in GENERATORS {
        for (wanted, factor) in SIZES {
            let count = (generator.make)(wanted).mesh.triangles.len() as f32;
            let ratio = count / wanted as f32;
            assert!((factor.recip()..=factor).contains(&ratio), "{}: {count} of {wanted}", generator.name);
        }
    }
}

#[test]
fn scenes_are_whole() {
    for generator in GENERATORS {
        for (wanted, _) in SIZES {
            let Model { mesh, parts, view, .. } = (generator.make)(wanted);
            let name = format!("{} of {wanted}", generator.name);
            // All vertices are somewhere, and all corners are vertices.
            assert!(mesh.positions.iter().all(|position| position.is_finite()), "{name}");
            assert!(mesh.triangles.iter().flatten().all(|&i| (i as usize) < mesh.positions.len()), "{name}");
            assert!(mesh.triangles.iter().all(|[a, b, c]| a != b && b != c && c != a), "{name}");
            // Nearly all triangles have an area.
            let flat = |&[a, b, c]: &[u32; 3]| {
                let [a, b, c] = [a, b, c].map(|i| mesh.positions[i as usize].as_dvec3());
                (b - a).cross(c - a).length() <= 0.0
            };
            let degenerate = mesh.triangles.iter().filter(|corners| flat(corners)).count();
            assert!(degenerate * 1000 <= mesh.triangles.len(), "{name}: {degenerate} without area");
            // Parts follow each other from the first triangle to the last, and none is empty.
            assert_eq!(parts[0].first, 0, "{name}");
            let ends = parts.iter().skip(1).map(|part| part.first).chain([mesh.triangles.len() as u32]);
            for (part, end) in parts.iter().zip(ends) {
                assert!(part.first < end, "{name}: {}", part.name);
            }
            // The eye sees something.
            assert!(view.eye.is_finite() && view.lookat.is_finite() && view.eye != view.lookat, "{name}");
        }
    }
}

#[test]
fn scenes_are_the_same_each_time() {
    for generator in GENERATORS {
        let (one, other) = ((generator.make)(10_000), (generator.make)(10_000));
        assert_eq!(bits(&one), bits(&other), "{}", generator.name);
        assert_eq!(one.mesh.triangles, other.mesh.triangles, "{}", generator.name);
        assert_eq!(one.parts, other.parts, "{}", generator.name);
    }
}
