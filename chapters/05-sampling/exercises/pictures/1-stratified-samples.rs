//! Picture of exercise 5.1: the light of the sky by random samples and by stratified ones.

use common::{
    Basis, Error, Interval, Rgb, Stream, Vec2,
    picture::{FilmPoint, Integrator, ORBIT, Panels, Picture, Render, Settings},
    story::{Story, triple},
};
use ray_casting::{
    camera::Camera,
    local_illumination::{tell_hit, tell_ray},
    material::Phong,
    ray::Ray,
    scene::Scene,
};
use sampling::{cosine_hemisphere::sample_cosine_hemisphere, unit_square::sample_unit_square};
use shadows::offset::Offset;

use super::{Make, evening};

/// Points of a grid of so many columns and rows.
type Points = fn(u16, u16, &mut Stream) -> Vec<Vec2>;

/// Columns and rows.
const SIDE: u16 = 4;

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "The same still life twice, side by side: a white, a red, a blue and a yellow matte ball and a green cone on a pale \
               floor under an orange and blue evening sky. Left, with 16 random directions for each point, the shadows are \
               grainy; right, with 16 stratified ones, the grain is finer.";
    Picture { knobs: &ORBIT, ..super::picture("5.1-stratified-samples", alt, make) }
}

/// Matte things under a sky.
struct UnderTheSky {
    scene: Scene<Phong>,
    camera: Camera,
    points: Points,
}

impl Integrator for UnderTheSky {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let ray = self.camera.ray(point);
        tell_ray(story, &ray);
        let Some((hit, object)) = self.scene.intersect(&ray, Interval::POSITIVE) else {
            return self.scene.background.radiance(ray.direction);
        };
        tell_hit(story, &hit, object);
        let points = (self.points)(SIDE, SIDE, random);
        let basis = Basis::around(hit.shading_normal);
        let origin = Offset::Following.origin(&hit, hit.geometric_normal);
        let seen = points.iter().map(|u| {
            let ray = Ray::new(origin, basis.to_world(sample_cosine_hemisphere(*u)));
            let hidden = self.scene.occluded(&ray, Interval::POSITIVE);
            if hidden { Rgb::ZERO } else { self.scene.background.radiance(ray.direction) }
        });
        let mean = seen.sum::<Rgb>() / f32::from(SIDE * SIDE);
        story.tell(|| format!("mean of the sky from {} directions: {}", points.len(), triple(mean)));
        // The density cosθ/π cancels the cosine.
        object.material.diffuse * std::f32::consts::PI * mean
    }
}

/// The two pictures, the right one with the student's points.
pub(crate) fn make(settings: &Settings, stratified: Points) -> Result<Box<dyn Render>, Error> {
    let random: Points = |columns, rows, random| (0..columns * rows).map(|_| sample_unit_square(random)).collect();
    let mut panels: Vec<Box<dyn Render>> = Vec::new();
    for points in [random, stratified] {
        let (scene, camera) = (evening::still_life()?, evening::camera(settings)?);
        panels.push(Box::new(UnderTheSky { scene, camera, points }));
    }
    Ok(Box::new(Panels::new(2, panels)))
}
