//! The recursion: closed forms at every depth, both ways to write it, and no stack that overflows.

use common::{
    Rgb, Stream, Vec2, Vec3,
    obj::ObjMesh,
    picture::{FilmPoint, Picture, Settings},
    story::Story,
};
use ray_casting::{
    material::Phong,
    mesh::{Mesh, Shading},
    ray::Ray,
    scene::Scene,
    sphere::Sphere,
};
use whitted::{
    CHAPTER,
    branches::Branch,
    material::Material,
    probe::{Probe, RayTree, Segment},
    whitted::{Limits, Whitted},
};

use crate::{
    exact::{EPSILON, V},
    fresnel::metal,
    illumination::random_color,
    mirrors::{PERFECT, whitted},
    rays::{aimed, between, direction, in_cube, one_of},
    shadows::any_camera,
    trees::random_scene,
};

/// Half the distance of the mirrors.
const HALF: f32 = 0.5;
/// Half their width.
const WIDE: f32 = 40.0;

/// Two mirrors that face each other, at z = ±½, under a constant background B; each gives a radiance of its own too.
fn corridor(mirror: Material, own: Rgb, background: Rgb, max_depth: u32) -> Whitted {
    let mut scene = Scene::new();
    scene.ambient = own;
    scene.surround(background);
    let rough = Phong { ambient: Rgb::ONE, diffuse: Rgb::ZERO, specular: Rgb::ZERO, shininess: 1.0 };
    for z in [-HALF, HALF] {
        let corner = |x: f32, y: f32| Vec3::new(x * WIDE, y * WIDE, z);
        let positions = vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        let obj = ObjMesh { positions, triangles: vec![[0, 1, 2], [0, 2, 3]], ..ObjMesh::default() };
        scene.add("mirror", Mesh::new(&obj, Shading::Flat).unwrap(), Material { rough: Some(rough), ..mirror });
    }
    let mut corridor = whitted(scene, any_camera(), max_depth);
    corridor.limits.min_weight = 0.0;
    corridor
}

/// e (1 + F + F² + … + F^depth) + F^(depth+1) B, term by term in f64.
fn series(f: f64, own: f64, background: f64, depth: u32) -> f64 {
    let (mut sum, mut power) = (0.0, 1.0);
    for _ in 0..=depth {
        sum += own * power;
        power *= f;
    }
    sum + power * background
}

/// At every depth, for many materials and angles: the recursion adds up to the geometric series.
#[test]
fn two_mirrors_add_up_to_the_geometric_series() {
    let mut random = Stream::new(851, 0, 0);
    let mut mirrors = vec![Material::GOLD, Material::SILVER, Material::COPPER, PERFECT];
    mirrors.extend([0.5, 3.0, 20.0].map(|kappa| Material::metal(Rgb::new(0.2, 1.0, 2.0), Rgb::splat(kappa))));
    for (i, mirror) in mirrors.into_iter().enumerate() {
        for depth in 0..=50 {
            let (own, background) = (random_color(&mut random), random_color(&mut random));
            let corridor = corridor(mirror, own, background, depth);
            // Straight at a mirror, or so askew that fifty reflections still find a mirror.
            let slope = if depth % 3 == 0 { 0.0 } else { between(&mut random, 0.0, 0.7) };
            let way = Vec3::new(slope, 0.3 * slope, [1.0, -1.0][one_of(&mut random, 2)]).normalize();
            let branch = Branch::from_camera(Ray::new(in_cube(&mut random) * 0.3, way));
            let mut tree = RayTree::default();
            let found = corridor.trace(branch, 0, &mut tree);
            assert_eq!(tree.0.len(), depth as usize + 1);
            let plain = corridor.trace_plain(&branch, 0);
            let cosine = V::from(way).0[2].abs();
            for c in 0..3 {
                let f = metal(cosine, mirror.index[c].into(), mirror.extinction[c].into());
                let [own, background] = [own[c], background[c]].map(f64::from);
                let expected = series(f, own, background, depth);
                // A few roundings for each of the reflections.
                let slack = 8.0 * EPSILON * f64::from(depth + 1) * expected;
                for found in [found[c], plain[c]] {
                    let error = (f64::from(found) - expected).abs();
                    assert!(
                        error < slack,
                        "mirror {i}, depth {depth}, {way}: {found}, not {expected}; {error} {slack}"
                    );
                }
            }
        }
    }
}

/// Run in a thread of its own that has only so many bytes of stack.
fn with_stack<T: Send + 'static>(bytes: usize, run: impl FnOnce() -> T + Send + 'static) -> T {
    std::thread::Builder::new().stack_size(bytes).spawn(run).unwrap().join().unwrap()
}

const SMALL_STACK: usize = 256 << 10;

/// Counts rays, and how deep the recursion goes.
#[derive(Default)]
pub(crate) struct Counter {
    pub(crate) rays: u32,
    nesting: u32,
    pub(crate) deepest: u32,
}

impl Probe for Counter {
    fn followed(&mut self, _segment: Segment) {
        self.rays += 1;
    }
}

impl Story for Counter {
    fn tell(&mut self, _line: impl FnOnce() -> String) {}

    fn enter(&mut self, _line: impl FnOnce() -> String) {
        self.nesting += 1;
        self.deepest = self.deepest.max(self.nesting);
    }

    fn leave(&mut self) {
        self.nesting -= 1;
    }
}

/// Ten thousand reflections and no weight limit: the sum of the endless series, on a small stack.
#[test]
fn ten_thousand_reflections_fit_a_small_stack() {
    for mirror in [Material::GOLD, Material::SILVER, Material::COPPER] {
        let found = with_stack(SMALL_STACK, move || {
            let corridor = corridor(mirror, Rgb::splat(0.3), Rgb::splat(0.7), 10_000);
            let mut tree = RayTree::default();
            let found = corridor.trace(Branch::from_camera(Ray::new(Vec3::splat(0.1), Vec3::Z)), 0, &mut tree);
            assert_eq!(tree.0.len(), 10_001);
            assert_eq!(tree.0.last().map(|segment| segment.depth), Some(10_000));
            found
        });
        for c in 0..3 {
            let f = metal(1.0, mirror.index[c].into(), mirror.extinction[c].into());
            let expected = f64::from(0.3_f32) / (1.0 - f);
            // The error of F is magnified by the sum that it makes.
            let slack = 4.0 * EPSILON * expected / (1.0 - f);
            assert!((f64::from(found[c]) - expected).abs() < slack, "{found}, not {expected}");
        }
    }
}

/// Every point of a small film once.
pub(crate) fn points() -> impl Iterator<Item = FilmPoint> {
    let size = Vec2::new(24.0, 14.0);
    let at = |i: u16| Vec2::new(f32::from(i % 24) + 0.5, f32::from(i / 24) + 0.5);
    (0..24 * 14).map(move |i| FilmPoint { position: at(i), size })
}

/// Glass between the mirrors, so that the tree of rays branches without end, and all pictures that have a depth, at the
/// greatest depth that their knob has.
#[test]
fn no_depth_overflows_the_stack() {
    let deepest = with_stack(SMALL_STACK, || {
        let mut corridor = corridor(Material::SILVER, Rgb::splat(0.1), Rgb::ONE, 10_000);
        corridor.limits.min_weight = Limits::DEFAULT.min_weight;
        corridor.scene.add("glass", Sphere::new(Vec3::new(0.1, 0.0, 0.0), 0.3), Material::glass(1.5));
        corridor.scene.add("bubble", Sphere::new(Vec3::new(0.15, 0.0, 0.0), 0.2), Material::glass(1.0 / 1.5));
        let mut random = Stream::new(852, 0, 0);
        let mut deepest = 0;
        for _ in 0..200 {
            let ray = aimed(in_cube(&mut random) * 0.45, in_cube(&mut random) * 0.2);
            let mut tree = RayTree::default();
            assert!(corridor.trace(Branch::from_camera(ray), 0, &mut tree).is_finite());
            deepest = deepest.max(tree.0.iter().map(|segment| segment.depth).max().unwrap());
        }
        deepest
    });
    assert!(deepest > 30, "{deepest}");
    let mut pictures = 0;
    for Picture { name, knobs, make, .. } in CHAPTER.pictures {
        let Some(depth) = knobs.iter().find(|knob| knob.name == "depth") else { continue };
        let mut settings = Settings::default();
        settings.values.set(depth, depth.parse("10000").or(depth.parse("20")).unwrap_or(depth.default()));
        let picture = make(&settings).unwrap();
        let sum: Rgb = with_stack(SMALL_STACK, move || {
            points().map(|point| picture.sample(point, &mut Stream::new(0, 0, 0))).sum()
        });
        assert!(sum.is_finite() && sum.max_element() > 0.0, "{name}: {sum}");
        pictures += 1;
    }
    assert!(pictures > 0);
}

/// The weaker branch has at most half of the weight, so no more than ten calls are nested until a thousandth is left, however
/// deep the tree is.
#[test]
fn few_calls_are_nested() {
    let mut random = Stream::new(855, 0, 0);
    let mut counter = Counter::default();
    for _ in 0..300 {
        let whitted = whitted(random_scene(true, &mut random), any_camera(), 10_000);
        for _ in 0..10 {
            let ray = aimed(direction(&mut random) * 5.0, in_cube(&mut random) * 2.0);
            whitted.trace(Branch::from_camera(ray), 0, &mut counter);
        }
    }
    assert!((3..=10).contains(&counter.deepest) && counter.rays > 10_000, "{} {}", counter.deepest, counter.rays);
}
