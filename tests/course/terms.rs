//! Rough, reflective and refractive: three properties that add up.

use common::{
    Interval, Rgb, Stream, Vec3,
    film::{Film, Size},
    picture::{PITCH, Settings},
    renderer::{self, Plan},
};
use ray_casting::camera::Camera;
use whitted::{CHAPTER, branches::Branch, probe::RayTree, whitted::Terms};

use crate::{
    mirrors::whitted,
    rays::{aimed, direction, in_cube},
    trees::random_scene,
};

/// Whether the parts add up to the sum, but for the rounding of some additions.
fn assert_sum(parts: [Rgb; 3], sum: Rgb) {
    let added: Rgb = parts.iter().sum();
    assert!((added - sum).abs().max_element() <= 4.0 * f32::EPSILON * (1.0 + sum.max_element()), "{added} {sum}");
}

#[test]
fn the_terms_of_a_surface_add_up() {
    let mut random = Stream::new(861, 0, 0);
    let mut present = [0; 3];
    for _ in 0..200 {
        let camera = Camera::new(Vec3::Z, Vec3::ZERO, Vec3::Y, 40.0).unwrap();
        let mut whitted = whitted(random_scene(true, &mut random), camera, 6);
        for _ in 0..20 {
            let ray = aimed(direction(&mut random) * 5.0, in_cube(&mut random) * 2.0);
            if whitted.scene.intersect(&ray, Interval::POSITIVE).is_none() {
                continue;
            }
            let mut with = |terms| {
                whitted.terms = terms;
                whitted.trace(Branch::from_camera(ray), 0, &mut RayTree::default())
            };
            let parts = [
                with(Terms { rough: true, ..Terms::NONE }),
                with(Terms { reflective: true, ..Terms::NONE }),
                with(Terms { refractive: true, ..Terms::NONE }),
            ];
            assert_sum(parts, with(Terms::ALL));
            for (count, part) in present.iter_mut().zip(parts) {
                *count += u32::from(part.max_element() > 0.01);
            }
        }
    }
    assert!(present.iter().all(|&n| n > 500), "{present:?}");
}

#[test]
fn the_panels_of_the_terms_add_up() {
    let picture = CHAPTER.picture("terms").unwrap();
    let term = picture.knobs.iter().find(|knob| knob.name == "term").unwrap();
    let [rough, reflective, refractive, sum] = ["rough", "reflective", "refractive", "sum"].map(|name| {
        let mut settings = Settings::default();
        settings.values.set(term, term.parse(name).unwrap());
        // Look a little upward, so that the sky is seen too.
        settings.values.set(&PITCH, -8.0);
        let mut film = Film::new(Size::of::<160, 90>());
        renderer::render(
            &*(picture.make)(&settings).unwrap(),
            &mut film,
            &Plan { samples: 1, seed: 0, threads: 1 },
            &(),
        );
        film.linear()
    });
    for (i, &sum) in sum.iter().enumerate() {
        assert_sum([rough[i], reflective[i], refractive[i]], sum);
    }
    // Each of the three is there.
    for part in [rough, reflective, refractive] {
        assert!(part.iter().filter(|color| color.max_element() > 0.05).count() > 100);
    }
}
