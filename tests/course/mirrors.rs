//! Perfect mirrors and perfect glass: what they show is known without any formula.

use common::{
    Interval, Rgb, Stream, Vec2, Vec3,
    obj::ObjMesh,
    picture::{FilmPoint, Render},
};
use ray_casting::{
    background::Background,
    camera::Camera,
    hit::Side,
    light::{DirectionalLight, PointLight},
    material::Phong,
    mesh::{Mesh, Shading},
    quadric::Quadric,
    scene::Scene,
    sphere::Sphere,
};
use shadows::offset::Offset;
use whitted::{
    material::{Fresnel, Material},
    whitted::{Limits, Terms, Whitted},
};

use crate::{
    exact::V,
    icosphere::icosphere,
    illumination::random_color,
    rays::{between, direction, in_cube, one_of},
};

/// A metal in which no light is lost: without a real part of its index it reflects everything.
pub(crate) const PERFECT: Material = Material::metal(Rgb::ZERO, Rgb::ONE);

#[test]
fn a_perfect_mirror_reflects_everything_to_the_last_bit() {
    let mut random = Stream::new(841, 0, 0);
    for _ in 0..100_000 {
        let cosine = random.uniform();
        for fresnel in [Fresnel::Exact, Fresnel::Approximate] {
            for side in [Side::Outside, Side::Inside] {
                assert_eq!(PERFECT.reflectance(cosine, side, fresnel), Rgb::ONE, "{cosine}");
            }
        }
    }
}

/// Surroundings that look different in every direction.
pub(crate) struct Colors;

impl Background for Colors {
    fn radiance(&self, direction: Vec3) -> Rgb {
        (direction.normalize() + 1.1) * 0.4
    }
}

/// The points of a small film, as the renderer takes them for one sample per pixel.
fn film(width: u16, height: u16) -> impl Iterator<Item = FilmPoint> {
    let size = Vec2::new(width.into(), height.into());
    let at = move |i: u16| Vec2::new(f32::from(i % width) + 0.5, f32::from(i / width) + 0.5);
    (0..width * height).map(move |i| FilmPoint { position: at(i), size })
}

pub(crate) fn whitted(scene: Scene<Material>, camera: Camera, max_depth: u32) -> Whitted {
    let limits = Limits { max_depth, ..Limits::DEFAULT };
    Whitted { scene, camera, limits, terms: Terms::ALL, fresnel: Fresnel::Exact, offset: Offset::Following }
}

/// A point mirrored in the plane through `q` with the unit normal `n`.
fn mirrored(point: Vec3, q: Vec3, n: V) -> Vec3 {
    let point = V::from(point);
    (point - n * (2.0 * (point - V::from(q)).dot(n))).to_f32()
}

/// Things of all shapes around `middle`, which cast shadows on each other; all of them rough, or some of them mirrors.
fn things(middle: Vec3, mirrors: bool, random: &mut Stream) -> Scene<Material> {
    let mut scene = Scene::new();
    scene.ambient = Rgb::splat(0.3);
    scene.surround(Colors);
    for i in 0..6 {
        let center = middle + in_cube(random) * 1.5;
        let phong = Phong::of(random_color(random), 0.04, 30.0);
        let materials = [Material::rough(phong), Material::GOLD, Material::coated(phong, 1.5)];
        let material = materials[if mirrors { one_of(random, 3) } else { 0 }];
        match i % 3 {
            0 => scene.add("ball", Sphere::new(center, between(random, 0.2, 0.6)), material),
            1 => {
                let frame = ray_casting::frame::Frame::at(center).turned(direction(random), 50.0);
                scene.add("egg", Quadric::ellipsoid(Vec3::new(0.3, 0.6, 0.4)).placed(frame), material)
            }
            _ => {
                let mut obj = icosphere(0);
                obj.positions.iter_mut().for_each(|p| *p = center + *p * 0.5);
                scene.add("crystal", Mesh::new(&obj, Shading::Flat).unwrap(), material)
            }
        };
    }
    scene
}

/// A flat mirror shows what a camera sees that stands where the mirror image of the camera is. Where an outline is rounded
/// differently, a pixel may differ: at most one in 10,000.
#[test]
fn a_mirror_shows_what_the_mirrored_camera_sees() {
    let [mut seen, mut differ, mut of_things] = [0; 3];
    for seed in 0..8 {
        // The mirror stands behind the things, as seen by the camera, which looks over them.
        let build = || {
            let mut random = Stream::new(842, seed, 0);
            let n = direction(&mut random);
            let side = n.any_orthonormal_vector();
            let q = in_cube(&mut random) * 3.0;
            let eye = q + n * 6.0 + side * 4.0;
            let mut scene = things(q + n * 3.0, false, &mut random);
            // Light from before the mirror, which so casts no shadow.
            scene.light(DirectionalLight::new(n + side * 0.7, Rgb::splat(1.5)));
            scene.light(PointLight { position: q + n * 8.0 - side * 4.0, intensity: Rgb::splat(20.0) });
            (scene, n, side, q, eye)
        };
        let (mut scene, n, side, q, eye) = build();
        let other = n.cross(side);
        let corner = |a: f32, b: f32| q + (side * a + other * b) * 4.0;
        let positions = vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        let obj = ObjMesh { positions, triangles: vec![[0, 1, 2], [0, 2, 3]], ..ObjMesh::default() };
        let mirror = Mesh::new(&obj, Shading::Flat).unwrap();
        scene.add("mirror", mirror, PERFECT);
        let camera = Camera::new(eye, q - side * 1.5, other, 40.0).unwrap();
        let with_mirror = whitted(scene, camera, 9);
        // The same things without the mirror, seen from behind it.
        let normal = V::from((corner(1.0, 0.0) - q).cross(corner(0.0, 1.0) - q)).unit();
        let [eye, lookat] = [eye, q - side * 1.5].map(|point| mirrored(point, q, normal));
        let camera = Camera::new(eye, lookat, mirrored(q + other, q, normal) - q, 40.0).unwrap();
        let without = whitted(build().0, camera, 8);
        for point in film(120, 90) {
            let ray = with_mirror.camera.ray(point);
            let Some((_, object)) = with_mirror.scene.intersect(&ray, Interval::POSITIVE) else { continue };
            if object.name != "mirror" {
                continue;
            }
            // Left and right are exchanged.
            let turned = FilmPoint { position: Vec2::new(point.size.x - point.position.x, point.position.y), ..point };
            let image = with_mirror.sample(point, &mut Stream::new(0, 0, 0));
            let direct = without.sample(turned, &mut Stream::new(0, 0, 0));
            seen += 1;
            differ += u32::from((image - direct).abs().max_element() > 1e-4);
            let ray = without.camera.ray(turned);
            of_things += u32::from(without.scene.intersect(&ray, Interval::POSITIVE).is_some());
        }
    }
    assert!(seen > 20_000 && of_things > 4_000, "{seen} {of_things}");
    assert!(differ * 10_000 < seen, "{differ} of {seen} pixels differ");
}

/// A ball with the index of what is around it changes no bit of the picture, wherever it is: before things, around them, inside
/// other glass, around the camera. It casts a shadow nevertheless, so there are no lights here. And it takes two steps of
/// the depth, so the depth is no limit here. Nor are there implicit surfaces: their march starts where the ray's range does, so
/// that the last bit of their hits depends on it.
#[test]
fn a_ball_of_index_one_is_invisible_to_the_last_bit() {
    const DEPTH: u32 = 100_000;
    let mut met = 0;
    for seed in 0..6 {
        let scene = || {
            let mut scene = things(Vec3::ZERO, true, &mut Stream::new(843, seed, 0));
            scene.add("glass", Sphere::new(Vec3::new(0.3, 0.2, 1.5), 0.8), Material::glass(1.5));
            scene.add("mirror", Sphere::new(Vec3::new(-1.0, 0.4, -3.0), 1.5), Material::SILVER);
            scene
        };
        let eye = Vec3::new(0.5, 1.0, 7.0);
        let camera = Camera::new(eye, Vec3::ZERO, Vec3::Y, 45.0).unwrap();
        let mut with = scene();
        let mut random = Stream::new(844, seed, 0);
        let balls = [
            // Before all, around all, inside the glass, across its border, around the eye, and anywhere.
            Sphere::new(Vec3::new(0.2, 0.3, 4.5), 1.0),
            Sphere::new(Vec3::ZERO, 5.0),
            Sphere::new(Vec3::new(0.3, 0.1, 1.6), 0.4),
            Sphere::new(Vec3::new(0.3, 0.9, 1.7), 0.5),
            Sphere::new(eye, 0.7),
            Sphere::new(in_cube(&mut random) * 3.0, between(&mut random, 0.5, 2.0)),
        ];
        for ball in balls {
            with.add("nothing", ball, Material::glass(1.0));
        }
        // They are there: nearly all rays meet them first.
        let nothing =
            |point| with.intersect(&camera.ray(point), Interval::POSITIVE).is_some_and(|(_, o)| o.name == "nothing");
        met += film(60, 45).filter(|point| nothing(*point)).count();
        let (without, with) = (whitted(scene(), camera, DEPTH), whitted(with, camera, DEPTH));
        for point in film(60, 45) {
            let [a, b] = [&without, &with].map(|picture| picture.sample(point, &mut Stream::new(0, 0, 0)));
            assert_eq!(a.to_array().map(f32::to_bits), b.to_array().map(f32::to_bits), "{point:?}: {a} {b}");
        }
    }
    assert!(met > 12_000, "{met}");
}
