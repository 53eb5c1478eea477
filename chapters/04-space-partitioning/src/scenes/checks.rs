//! What every scene must keep to, of any size.

use super::Generator;

/// Assert that the scenes of a generator have the wanted size, are whole, and are the same every time.
pub(super) fn keeps_its_promises(generator: &Generator) {
    for wanted in [100, 300, 1_000, 3_000, 10_000, 100_000] {
        let model = (generator.make)(wanted);
        let name = format!("{} of {wanted}", generator.name);
        // The size.
        let size = model.mesh.triangles.len() as f32 / wanted as f32;
        let within = if wanted < 1_000 { 0.5..2.0 } else { 0.85..1.15 };
        assert!(within.contains(&size), "{name}: {size} times as many");
        // The mesh.
        assert!(model.mesh.positions.iter().all(|p| p.is_finite()), "{name}: not finite");
        let vertices = model.mesh.positions.len();
        assert!(model.mesh.triangles.iter().flatten().all(|&i| (i as usize) < vertices), "{name}: no such vertex");
        // The parts.
        assert_eq!(model.parts[0].first, 0, "{name}");
        let ends = model.parts.iter().skip(1).map(|part| part.first as usize);
        for (part, end) in model.parts.iter().zip(ends.chain([model.mesh.triangles.len()])) {
            assert!((part.first as usize) < end, "{name}: nothing in part '{}'", part.name);
        }
        // Once more.
        let again = (generator.make)(wanted);
        assert!(model.mesh == again.mesh && model.parts == again.parts, "{name}: not the same again");
    }
}
