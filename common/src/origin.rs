//! The origin of a film: all that its samples depend on, so that only what belongs together is added up.

use glam::Vec2;

use crate::{
    film::Size,
    fingerprint::Fingerprint,
    obj::ObjMesh,
    picture::{Chapter, FilmPoint, Picture, Render, Settings},
    random::Stream,
};

/// What a film was rendered from, as names and values. Two films with the same origin have the same samples.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Origin(pub(crate) Vec<(String, String)>);

impl Origin {
    /// The name of the entry that looks at the picture itself.
    const SPOT_CHECK: &str = "spot check";
    /// The name of the entry for a mesh.
    const MESH: &str = "mesh";

    /// The origin of a film of this picture. `made` is the picture as it was made of the settings.
    #[must_use]
    pub fn new(
        chapter: &Chapter,
        picture: &Picture,
        settings: &Settings,
        size: Size,
        seed: u64,
        made: &dyn Render,
    ) -> Self {
        let mut entries = vec![
            ("chapter".into(), chapter.name.into()),
            ("picture".into(), picture.name.into()),
            ("size".into(), format!("{}x{}", size.width(), size.height())),
            ("seed".into(), seed.to_string()),
        ];
        // Rust writes an f32 with as many digits as tell it from all others.
        let value = |knob| settings.values.number(knob);
        entries.extend(picture.knobs.iter().map(|knob| (format!("knob '{}'", knob.name), knob.show(value(knob)))));
        if let Some(mesh) = &settings.mesh {
            entries.push((Self::MESH.into(), hex(of_mesh(mesh))));
        }
        entries.push((Self::SPOT_CHECK.into(), hex(spot_check(made, size, seed))));
        Self(entries)
    }

    /// In what a stored film differs, as an end of the sentence 'it cannot go on here: …'; `None` if in nothing.
    #[must_use]
    pub fn difference(&self, stored: &Self) -> Option<String> {
        let find =
            |origin: &Self, name: &str| origin.0.iter().find(|entry| entry.0 == name).map(|entry| entry.1.clone());
        let names = self.0.iter().chain(&stored.0).map(|entry| entry.0.as_str());
        names.filter(|name| *name != Self::SPOT_CHECK).chain([Self::SPOT_CHECK]).find_map(|name| {
            match (find(stored, name), find(self, name)) {
                (theirs, ours) if theirs == ours => None,
                (Some(_), Some(_)) if name == Self::MESH => Some("it shows another mesh".into()),
                (Some(_), None) if name == Self::MESH => Some("it shows a mesh of its own; name it with --mesh".into()),
                (None, Some(_)) if name == Self::MESH => Some("it was rendered without --mesh".into()),
                _ if name == Self::SPOT_CHECK => {
                    Some("the same options give other samples now: the program has changed since".into())
                }
                (Some(theirs), Some(ours)) => Some(format!("its {name} is {theirs}, not {ours}")),
                (theirs, _) => Some(format!("its {name} is {}", theirs.unwrap_or_else(|| "not known".into()))),
            }
        })
    }
}

/// The fingerprint of a mesh as it was read: spaces and comments of its file do not count.
fn of_mesh(mesh: &ObjMesh) -> Fingerprint {
    let mut fingerprint = Fingerprint::default();
    for vectors in [&mesh.positions, &mesh.normals] {
        fingerprint.add(&(vectors.len() as u64).to_le_bytes());
        vectors.iter().flat_map(|v| v.to_array()).for_each(|x| fingerprint.add(&x.to_le_bytes()));
    }
    for triangles in [&mesh.triangles, &mesh.triangle_normals] {
        triangles.as_flattened().iter().for_each(|i| fingerprint.add(&i.to_le_bytes()));
    }
    fingerprint
}

/// The fingerprint of a few samples all over the picture: most changes of the code behind it change them.
fn spot_check(made: &dyn Render, size: Size, seed: u64) -> Fingerprint {
    const SIDE: u16 = 16;
    #[expect(clippy::cast_precision_loss, reason = "at most 65,535, exact in f32")]
    let size = Vec2::new(size.width() as f32, size.height() as f32);
    let mut fingerprint = Fingerprint::default();
    for i in 0..SIDE * SIDE {
        let position = (Vec2::new(f32::from(i % SIDE), f32::from(i / SIDE)) + 0.5) / f32::from(SIDE) * size;
        let color = made.sample(FilmPoint { position, size }, &mut Stream::new(seed, i.into(), 0));
        color.to_array().into_iter().for_each(|x| fingerprint.add(&x.to_bits().to_le_bytes()));
    }
    fingerprint
}

fn hex(fingerprint: Fingerprint) -> String {
    format!("{:016x}", fingerprint.bits())
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;
    use crate::{
        color::Rgb,
        knob::{Knob, Step},
        picture::Integrator,
        story::Story,
    };

    /// All of one color.
    struct Plain(f32);

    impl Integrator for Plain {
        fn radiance(&self, _point: FilmPoint, _random: &mut Stream, _story: &mut impl Story) -> Rgb {
            Rgb::splat(self.0)
        }
    }

    const DEPTH: Knob = Knob::number("depth", "how deep", [0.0, 9.0], 0.1, "m", Step::Add(0.1));
    const PICTURE: Picture = Picture {
        name: "ball",
        alt: "",
        knobs: &[DEPTH],
        size: Size::of::<4, 3>(),
        samples: 1,
        takes_mesh: true,
        make: |_| Ok(Box::new(Plain(1.0))),
    };
    const CHAPTER: Chapter = Chapter { number: 0, name: "toy", title: "Toy", pictures: &[PICTURE], reports: &[] };

    fn origin(settings: &Settings, size: Size, seed: u64, level: f32) -> Origin {
        Origin::new(&CHAPTER, &PICTURE, settings, size, seed, &Plain(level))
    }

    #[test]
    fn differences_are_said() {
        let (plain, size) = (Settings::default(), PICTURE.size);
        let ours = origin(&plain, size, 0, 1.0);
        assert_eq!(ours.difference(&ours.clone()), None);
        let said = |stored: Origin| ours.difference(&stored).unwrap();
        assert_eq!(said(origin(&plain, Size::of::<3, 4>(), 0, 1.0)), "its size is 3x4, not 4x3");
        // What it comes from is said before what comes of it.
        assert_eq!(said(origin(&plain, size, 7, 2.0)), "its seed is 7, not 0");
        assert!(said(origin(&plain, size, 0, 2.0)).ends_with("the program has changed since"));

        let mut turned = plain.clone();
        turned.values.set(&DEPTH, f32::from_bits(0.1_f32.to_bits() + 1));
        assert_eq!(said(origin(&turned, size, 0, 1.0)), "its knob 'depth' is 0.10000001 m, not 0.1 m");
        turned.values.set(&DEPTH, 0.1);
        assert_eq!(ours.difference(&origin(&turned, size, 0, 1.0)), None, "the default, set by hand");

        let (mut older, mut newer) = (ours.clone(), ours.clone());
        older.0.retain(|entry| entry.0 != "knob 'depth'");
        newer.0.insert(0, ("knob 'width'".into(), "3".into()));
        assert_eq!(said(older), "its knob 'depth' is not known");
        assert_eq!(said(newer), "its knob 'width' is 3");
    }

    #[test]
    fn a_mesh_counts_by_its_content() {
        let mesh =
            |x: f32| ObjMesh { positions: vec![Vec3::splat(x); 3], triangles: vec![[0, 1, 2]], ..ObjMesh::default() };
        let with = |mesh| origin(&Settings { mesh, ..Settings::default() }, PICTURE.size, 0, 1.0);
        let (none, one, other) = (with(None), with(Some(mesh(1.0))), with(Some(mesh(2.0))));
        assert_eq!(one.difference(&with(Some(mesh(1.0)))), None);
        assert_eq!(one.difference(&other).unwrap(), "it shows another mesh");
        assert_eq!(one.difference(&none).unwrap(), "it was rendered without --mesh");
        assert!(none.difference(&one).unwrap().contains("name it with --mesh"));
    }
}
