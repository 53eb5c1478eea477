//! A glass ball whose index can be turned, with two mistakes.

use common::{
    Error, Interval, Rgb, Stream, Vec3,
    film::Size,
    knob::{Knob, Step},
    picture::{FilmPoint, Integrator, ORBIT, Picture, Render, Settings},
    story::{Story, Untold},
};
use ray_casting::{
    hit::{Hit, Side},
    pictures::stage,
    ray::Ray,
    shape::Shape,
    sphere::Sphere,
};
use shadows::direct_light::direct_light;

use super::studio::{paper, pencils, seen};
use crate::{
    branches::{Branch, branches},
    material::Material,
    probe::Kind,
    whitted::{Limits, Whitted, mean},
};

const INDEX: Knob = Knob::number("index", "refractive index of the glass", [1.0, 2.5], 1.5, "", Step::Add(0.05));
const BUG: Knob = Knob::choice("bug", "a mistake to look at", &["none", "forgets-the-side", "invents-a-direction"], 0);

pub(super) const PICTURE: Picture = Picture {
    name: "glass-ball",
    alt: "A glass ball with an air bubble in it lies before nine colored pencils and casts a full shadow. In the glass \
          the pencils are upside down and in reverse order. The bubble shows some of them small and upright, inside a \
          broad rim with bright and dark curls: there all the light is reflected.",
    knobs: &[INDEX, BUG, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<800, 450>(),
    samples: 8,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let index = settings.values.number(&INDEX);
    let ball = Sphere::new(Vec3::new(0.0, 1.0, 0.0), 1.0);
    let bubble = Sphere::new(Vec3::new(-0.3, 1.22, 0.36), 0.36);
    let camera = stage::camera([0.0, 1.5, 7.0], [0.0, 1.0, 0.0], 21.0, &settings.values)?;
    let mut scene = paper();
    pencils(&mut scene, -3.3, 1.7);
    let (glass, air) = (Material::glass(index), Material::glass(1.0 / index));
    let side_is_known = settings.values.index(&BUG) != 1;
    let sided = |sphere| Sided { sphere, side_is_known };
    scene.add("glass", sided(ball), glass).add("air in the glass", sided(bubble), air);
    let whitted = seen(scene, camera, Limits::DEFAULT);
    Ok(match settings.values.index(&BUG) {
        2 => Box::new(Inventive(whitted)),
        _ => Box::new(whitted),
    })
}

/// A sphere that can make the mistake 'forgets the side': then it always says that the ray comes from outside.
struct Sided {
    sphere: Sphere,
    side_is_known: bool,
}

impl Shape for Sided {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        let hit = self.sphere.intersect(ray, range)?;
        Some(if self.side_is_known { hit } else { Hit { side: Side::Outside, ..hit } })
    }
}

/// The mistake 'invents a direction': where no light can get out, it sends a ray out along the surface.
struct Inventive(Whitted);

impl Inventive {
    fn trace(&self, branch: &Branch, depth: u32) -> Rgb {
        let Whitted { scene, limits, fresnel, offset, .. } = &self.0;
        let Branch { ray, range, share, .. } = branch;
        let ends = depth > limits.max_depth || mean(*share) < limits.min_weight;
        let nearest = if ends { None } else { scene.intersect(ray, *range) };
        let Some((hit, object)) = nearest else { return share * scene.background.radiance(ray.direction) };
        let rough = |rough| direct_light(scene, &rough, &hit, -ray.direction, *offset, &mut Untold);
        let mut radiance = share * object.material.rough.map_or(Rgb::ZERO, rough);
        let mut next = branches(ray, &hit, &object.material, *fresnel, *offset);
        if object.material.refractive && next[1].is_none() {
            next = [None, Some(invented(ray, &hit, offset.origin(&hit, -hit.geometric_normal)))];
        }
        for next in next.into_iter().flatten() {
            radiance += self.trace(&Branch { share: share * next.share, ..next }, depth + 1);
        }
        radiance
    }
}

/// Snell's law with a zero in place of the root that does not exist, and all the light.
fn invented(ray: &Ray, hit: &Hit, origin: Vec3) -> Branch {
    let normal = hit.shading_normal;
    let along = ray.direction - normal * ray.direction.dot(normal);
    let ray = Ray::new(origin, along.normalize_or(-normal));
    Branch { kind: Kind::Refracted, ray, range: Interval::POSITIVE, share: Rgb::ONE }
}

impl Integrator for Inventive {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        story.tell(|| "traced with a mistake: total reflection is not known".into());
        self.trace(&Branch::from_camera(self.0.camera.ray(point)), 0)
    }
}
