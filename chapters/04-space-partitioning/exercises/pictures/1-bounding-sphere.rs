//! Picture of exercise 4.1: a crowd of pawns in bubbles.

use common::{
    Error, Interval, Rgb, Stream, Vec3,
    color::srgb,
    picture::{FilmPoint, Integrator, Picture, Render, Settings},
    story::Story,
};
use ray_casting::{
    camera::Camera,
    frame::Frame,
    hit::Hit,
    light::DirectionalLight,
    local_illumination::tell_ray,
    material::Phong,
    mesh::{Mesh, Shading},
    pictures::stage::{camera, pawn, square},
    ray::Ray,
    scene::Scene,
    shape::Shape,
};
use shadows::{direct_light::DirectLight, offset::Offset};

use super::Make;
use crate::checks::bounding_sphere::Ball;

/// Whether a ray can hit anything in a ball.
type MayHit = fn(&Ball, &Ray, Interval) -> bool;

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "A crowd of ivory and ebony pawns on a dark green floor in the sun, standing and leaning in all directions, each of \
               them in a faint blue bubble that just holds it. Where bubbles overlap they are brighter.";
    super::picture("4.1-bounding-sphere", alt, make)
}

/// A mesh in a ball.
struct Wrapped {
    mesh: Mesh,
    ball: Ball,
    may_hit: MayHit,
}

impl Shape for Wrapped {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        let may_hit = (self.may_hit)(&self.ball, ray, range);
        may_hit.then(|| self.mesh.intersect(ray, range)).flatten()
    }

    fn occluded(&self, ray: &Ray, range: Interval) -> bool {
        (self.may_hit)(&self.ball, ray, range) && self.mesh.occluded(ray, range)
    }
}

/// The crowd, and the bubbles around it.
struct Bubbles {
    crowd: DirectLight,
    camera: Camera,
    balls: Vec<Ball>,
    may_hit: MayHit,
}

impl Integrator for Bubbles {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let ray = self.camera.ray(point);
        tell_ray(story, &ray);
        let asked = self.balls.iter().filter(|ball| (self.may_hit)(ball, &ray, Interval::POSITIVE)).count();
        story.tell(|| format!("may hit something in {asked} balls"));
        let tint = Rgb::new(0.010, 0.030, 0.075) * f32::from(u16::try_from(asked).unwrap_or(u16::MAX));
        self.crowd.radiance(point, random, story) + tint
    }
}

/// The crowd with balls that `around` makes of corners.
pub(crate) fn make(
    settings: &Settings,
    around: fn(&[Vec3]) -> Ball,
    may_hit: MayHit,
) -> Result<Box<dyn Render>, Error> {
    let mut scene = Scene::new();
    scene.ambient = Rgb::new(0.20, 0.22, 0.28);
    scene.surround(srgb(40, 52, 60));
    scene.light(DirectionalLight::new(Vec3::new(-0.5, 0.8, 0.4), Rgb::new(2.9, 2.7, 2.3)));
    scene.add("floor", square(0.0, 400.0)?, Phong::of(srgb(44, 78, 70), 0.0, 1.0));
    let mut balls = Vec::new();
    for (x, z) in (-3..=3_i8).flat_map(|x| (-4..=1_i8).map(move |z| (x, z))) {
        let (column, row) = (f32::from(x), f32::from(z));
        // No two pawns alike: some have fallen.
        let turn = column * 37.0 + row * 61.0;
        let has_fallen = (x * 3 + z * 5).rem_euclid(7) == 0;
        let tilt = if has_fallen { 83.0 } else { 0.0 };
        let place =
            Vec3::new(column * 2.3 + (z.rem_euclid(2) as f32) * 1.1, if has_fallen { 0.5 } else { 0.0 }, row * 2.1);
        let frame = Frame::at(place).turned(Vec3::X, tilt).turned(Vec3::Y, turn);
        let mut obj = pawn()?;
        for position in &mut obj.positions {
            *position = frame.point_to_world(*position);
        }
        obj.triangle_normals.clear();
        let ball = around(&obj.positions);
        balls.push(ball);
        let color = if (x + z).rem_euclid(2) == 0 { srgb(232, 218, 190) } else { srgb(74, 48, 40) };
        let mesh = Mesh::new(&obj, Shading::Smooth)?;
        scene.add("pawn", Wrapped { mesh, ball, may_hit }, Phong::of(color, 0.4, 40.0));
    }
    let camera = camera([3.0, 5.4, 9.2], [0.2, 0.6, -2.6], 34.0, &settings.values)?;
    let crowd = DirectLight { scene, camera, offset: Offset::Following };
    Ok(Box::new(Bubbles { crowd, camera, balls, may_hit }))
}
