//! Local illumination against its formula in f64, the lights, and the nearest hit of a whole scene.

#![expect(clippy::disallowed_methods, reason = "f64 has digits to spare: its last bits do not matter here")]

use common::{
    Interval, Rgb, Stream, Vec3,
    film::{Film, Size},
    picture::{PITCH, Settings},
    renderer::{self, Plan},
    story::Untold,
};
use ray_casting::{
    CHAPTER,
    camera::Camera,
    light::{DirectionalLight, Light, PointLight},
    local_illumination::{LocalIllumination, Terms},
    material::Phong,
    mesh::{Mesh, Shading},
    pictures::still_life,
    ray::Ray,
    scene::Scene,
    sphere::Sphere,
};

use crate::{
    exact::{EPSILON, V},
    icosphere::icosphere,
    rays::{aimed, direction, in_cube, magnitude, one_of},
};

/// A light as numbers only.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Lamp {
    Sun { toward: Vec3, strength: Rgb },
    Point { position: Vec3, intensity: Rgb },
}

impl Lamp {
    pub(crate) fn random(random: &mut Stream) -> Lamp {
        let color = random_color(random) * 3.0;
        match one_of(random, 2) {
            0 => Lamp::Sun { toward: direction(random) * magnitude(random, 0.1, 10.0), strength: color },
            _ => Lamp::Point { position: in_cube(random) * 8.0, intensity: color * 20.0 },
        }
    }

    pub(crate) fn shine_on(self, scene: &mut Scene<Phong>) {
        match self {
            Lamp::Sun { toward, strength } => scene.light(DirectionalLight::new(toward, strength)),
            Lamp::Point { position, intensity } => scene.light(PointLight { position, intensity }),
        };
    }

    /// L and L_l at a point.
    fn at(self, point: V) -> (V, V) {
        match self {
            Lamp::Sun { toward, strength } => (V::from(toward).unit(), strength.into()),
            Lamp::Point { position, intensity } => {
                let to_light = V::from(position) - point;
                (to_light.unit(), V::from(intensity) * (1.0 / to_light.dot(to_light)))
            }
        }
    }
}

pub(crate) fn random_color(random: &mut Stream) -> Rgb {
    (in_cube(random) + 1.0) / 2.0
}

/// Product channel by channel.
fn times(V([r, g, b]): V, other: Rgb) -> V {
    let V([x, y, z]) = other.into();
    V([r * x, g * y, b * z])
}

/// k_a L_a + Σ L_l {k_d (L·N)⁺ + k_s ((H·N)⁺)^shine}, and how far rounding may carry an f32 from it.
fn formula(material: &Phong, ambient: Rgb, lamps: &[Lamp], point: V, normal: V, viewer: V, terms: Terms) -> (V, f64) {
    let (mut sum, mut rounding) = (V::ZERO, 2e-7);
    if terms.ambient {
        sum = sum + times(ambient.into(), material.ambient);
    }
    for lamp in lamps {
        let (light, strength) = lamp.at(point);
        let both = light + viewer;
        let (diffuse, specular) = (light.dot(normal).max(0.0), both.unit().dot(normal).max(0.0));
        let shine = f64::from(material.shininess);
        if terms.diffuse {
            sum = sum + times(strength * diffuse, material.diffuse);
        }
        if terms.specular {
            sum = sum + times(strength * specular.powf(shine), material.specular);
        }
        // A cosine is off by some roundings, more so if H is the sum of nearly opposite vectors; a power multiplies it.
        let (cosine, slope) = (4.0 * EPSILON, shine * specular.powf(shine - 1.0).min(1.0));
        rounding += strength.length() * cosine * (3.0 + slope * (1.0 + 2.0 / both.length()));
    }
    (sum, rounding)
}

#[test]
fn brightness_is_what_the_formula_says() {
    let mut random = Stream::new(601, 0, 0);
    let [mut hits, mut lit, mut shiny] = [0; 3];
    let mesh = Mesh::new(&icosphere(0), Shading::Smooth).unwrap();
    for i in 0..30_000 {
        // Make a ball or a mesh of any material, up to three lights, and a ray toward it.
        let material = Phong {
            ambient: random_color(&mut random),
            diffuse: random_color(&mut random),
            specular: random_color(&mut random),
            shininess: magnitude(&mut random, 1.0, 1000.0),
        };
        let lamps: Vec<_> = (0..i % 4).map(|_| Lamp::random(&mut random)).collect();
        let mut scene = Scene::new();
        scene.ambient = random_color(&mut random);
        let background = random_color(&mut random);
        scene.surround(background);
        match one_of(&mut random, 2) {
            0 => scene.add("ball", Sphere::new(in_cube(&mut random), 1.0), material),
            _ => scene.add("smooth mesh", mesh.clone(), material),
        };
        lamps.iter().for_each(|lamp| lamp.shine_on(&mut scene));
        let ray = aimed(direction(&mut random) * 5.0, in_cube(&mut random));
        let terms = Terms { ambient: i & 4 == 0, diffuse: i & 8 == 0, specular: i & 16 == 0 };
        // Only the hit itself is taken from the chapter.
        let hit = scene.intersect(&ray, Interval::POSITIVE).map(|(hit, _)| hit);
        let ambient = scene.ambient;
        let camera = Camera::new(Vec3::Z, Vec3::ZERO, Vec3::Y, 40.0).unwrap();
        let radiance = LocalIllumination { scene, camera, terms }.trace(&ray, &mut Untold);
        let Some(hit) = hit else {
            assert_eq!(radiance, background);
            continue;
        };
        let viewer = -V::from(ray.direction).unit();
        let (normal, point) = (V::from(hit.shading_normal), V::from(hit.position));
        let (expected, rounding) = formula(&material, ambient, &lamps, point, normal, viewer, terms);
        let error = (V::from(radiance) - expected).length();
        assert!(error < rounding, "{material:?} {hit:?} {terms:?}: {radiance}, not {expected:?}; {error} {rounding}");
        let dark = formula(&material, ambient, &[], point, normal, viewer, terms).0;
        let dull = formula(&material, ambient, &lamps, point, normal, viewer, Terms { specular: false, ..terms }).0;
        hits += 1;
        lit += u32::from((expected - dark).length() > 0.01);
        shiny += u32::from((expected - dull).length() > 0.01);
    }
    assert!(hits > 10_000 && lit > 4_000 && shiny > 2_000, "{hits} {lit} {shiny}");
}

#[test]
fn the_panels_of_the_terms_add_up() {
    let picture = CHAPTER.picture("terms").unwrap();
    let term = picture.knobs.iter().find(|knob| knob.name == "term").unwrap();
    let [ambient, diffuse, specular, sum] = ["ambient", "diffuse", "specular", "sum"].map(|name| {
        let mut settings = Settings::default();
        settings.values.set(term, term.parse(name).unwrap());
        // Look level, so that the background is seen too.
        settings.values.set(&PITCH, -16.0);
        let mut film = Film::new(Size::of::<192, 108>());
        let plan = Plan { samples: 1, seed: 0, threads: 1 };
        renderer::render(&*(picture.make)(&settings).unwrap(), &mut film, &plan, &());
        film.linear()
    });
    for (i, &sum) in sum.iter().enumerate() {
        let added = ambient[i] + diffuse[i] + specular[i];
        assert!((added - sum).abs().max_element() <= 2.0 * f32::EPSILON * (1.0 + sum.max_element()), "{added} {sum}");
    }
    // Each of the three is there.
    for term in [ambient, diffuse, specular] {
        assert!(term.iter().any(|color| color.max_element() > 0.05));
    }
}

#[test]
fn a_point_light_falls_with_the_square_of_the_distance() {
    let mut random = Stream::new(602, 0, 0);
    for _ in 0..10_000 {
        let lamp = PointLight { position: in_cube(&mut random), intensity: random_color(&mut random) };
        let toward = direction(&mut random) * magnitude(&mut random, 0.01, 1000.0);
        let light = lamp.illuminate(lamp.position - toward);
        let distance = (V::from(lamp.position) - V::from(lamp.position - toward)).length();
        let expected = V::from(lamp.intensity) * (1.0 / (distance * distance));
        assert!((V::from(light.strength) - expected).length() < 4.0 * EPSILON * expected.length());
        assert!((f64::from(light.distance) - distance).abs() < 2.0 * EPSILON * distance);
        assert!((light.direction.length() - 1.0).abs() < 3.0 * f32::EPSILON);
        assert!(light.direction.dot(toward.normalize()) > 0.999);
        // Twice as far, a quarter as strong.
        let farther = lamp.illuminate(lamp.position - toward * 2.0);
        assert!((farther.strength * 4.0 - light.strength).length() < 1e-3 * light.strength.length());
    }
}

#[test]
fn a_directional_light_is_the_same_everywhere() {
    let mut random = Stream::new(603, 0, 0);
    for _ in 0..1_000 {
        let toward = direction(&mut random) * magnitude(&mut random, 1e-3, 1e3);
        let sun = DirectionalLight::new(toward, random_color(&mut random));
        let (here, there) = (sun.illuminate(Vec3::ZERO), sun.illuminate(in_cube(&mut random) * 1e6));
        assert_eq!(here, there);
        assert!((here.direction - toward.normalize()).length() < 1e-6);
        assert_eq!(here.distance, f32::INFINITY);
    }
}

#[test]
fn the_nearest_of_all_objects_is_hit() {
    let scene = still_life::scene().unwrap();
    let mut random = Stream::new(604, 0, 0);
    let mut hits = vec![0; scene.objects.len()];
    for _ in 0..100_000 {
        let origin = in_cube(&mut random) * 5.0 + Vec3::Y * 2.0;
        let aim = Vec3::new(2.5, 0.8, 1.5) * in_cube(&mut random) + Vec3::Y * 0.8;
        let Ray { origin, direction } = aimed(origin, aim);
        let ray = Ray::new(origin, direction * [1.0, 3.7][one_of(&mut random, 2)]);
        let range = [Interval::POSITIVE, Interval::new(0.5, 4.0)][one_of(&mut random, 2)];
        // Ask every object on its own, and compare.
        let alone = scene.objects.iter().map(|object| object.shape.intersect(&ray, range));
        let nearest = alone.flatten().map(|hit| hit.t).reduce(f32::min);
        let together = scene.intersect(&ray, range);
        assert_eq!(together.map(|(hit, _)| hit.t), nearest, "{ray:?} {range:?}");
        // The object that is named is the one that was hit.
        if let Some((hit, object)) = together {
            assert_eq!(object.shape.intersect(&ray, range), Some(hit));
            hits[scene.objects.iter().position(|o| std::ptr::eq(o, object)).unwrap()] += 1;
        }
    }
    assert!(hits.iter().all(|&n| n > 500), "{hits:?}");
}
