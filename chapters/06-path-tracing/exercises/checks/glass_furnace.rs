//! Glass in surroundings for which the answer is known, for exercise 6.1.

use common::{
    Rgb, Stream, Vec3,
    exercise::{Finding, Verdict, trying},
    float,
    story::Untold,
};
use ray_casting::{
    background::Background, frame::Frame, hit::Side, pictures::stage::block, ray::Ray, scene::Scene, shape::Shape,
    sphere::Sphere,
};
use sampling::estimate::Estimate;

use super::{
    glass_case::Case,
    glass_world::{GlassStep, GlassWorld, Matter},
    words::{about, is_near, triple},
};

/// Accept glass that is invisible where all light is alike, and a pane that reflects what it should.
pub(super) fn furnaces(glass_step: GlassStep) -> Verdict {
    let ball = || Sphere::new(Vec3::ZERO, 1.0);
    furnace("a ball of glass", world(glass_step, ball(), 1.5, Rgb::ONE))?;
    furnace("a bubble of air in water", world(glass_step, ball(), 0.75, Rgb::ONE))?;
    if let Ok(block) = block(Frame::at(Vec3::ZERO).turned(Vec3::new(1.0, 2.0, 3.0), 40.0), Vec3::splat(0.7)) {
        furnace("a block of glass", world(glass_step, block, 1.5, Rgb::ONE))?;
    }
    pane(glass_step)
}

/// One thing of glass under some sky.
fn world(glass_step: GlassStep, shape: impl Shape + 'static, index: f32, sky: impl Background + 'static) -> GlassWorld {
    let mut scene = Scene::new();
    scene.surround(sky);
    scene.add("glass", shape, Matter::Glass(index));
    GlassWorld { scene, glass_step }
}

/// Where the sky is 1 everywhere, each path brings 1, whatever way it goes.
fn furnace(name: &str, world: GlassWorld) -> Verdict {
    let mut random = Stream::new(613, 0, 0);
    for _ in 0..2000 {
        let [x, y] = [(); 2].map(|()| 1.6 * random.uniform() - 0.8);
        let ray = Ray::new(Vec3::new(x, y, 5.0), -Vec3::Z);
        let tried = format!("a path from {} along −z to {name}, under a sky of radiance 1", triple(ray.origin));
        let radiance = trying(|| tried.clone(), || world.trace(ray, &mut random, &mut Untold)).x;
        if is_near(radiance.into(), 1.0, 1e-3) {
            continue;
        }
        let (name, advice) = if radiance == 0.0 {
            ("stuck", "The path never gets out of the glass. Does each new ray start on the side into which it goes?")
        } else {
            ("furnace", "Glass neither takes nor gives light. Under such a sky it cannot be seen.")
        };
        let (got, expected) = (format!("the radiance {}", about(radiance.into())), "1".into());
        return Err(Finding { tried, got, expected, advice: advice.into() }.named(name));
    }
    Ok(())
}

/// Bright above, dark below.
struct Above;

impl Background for Above {
    fn radiance(&self, direction: Vec3) -> Rgb {
        if direction.y > 0.0 { Rgb::ONE } else { Rgb::ZERO }
    }
}

/// A pane reflects at both sides, to and fro: F + (1 − F)² F + (1 − F)² F³ … = 2F / (1 + F).
fn pane(glass_step: GlassStep) -> Verdict {
    let Ok(block) = block(Frame::at(Vec3::ZERO), Vec3::new(20.0, 0.1, 20.0)) else { return Ok(()) };
    let world = world(glass_step, block, 1.5, Above);
    for degrees in [30.0_f32, 75.0] {
        let angle = degrees.to_radians();
        let toward = Vec3::new(float::sin(angle), -float::cos(angle), 0.0);
        let reflectance = Case::at(1.5, Side::Outside, degrees).reflectance();
        let right = 2.0 * reflectance / (1.0 + reflectance);
        let tried = format!("paths at {degrees}° from above to a pane of glass, bright sky above, none below");
        let mut estimate = Estimate::default();
        for i in 0..20_000 {
            let mut random = Stream::new(614, i, 0);
            let ray = Ray::new(-toward * 2.0, toward);
            estimate.add(trying(|| tried.clone(), || world.trace(ray, &mut random, &mut Untold)).x.into());
        }
        if !is_near(estimate.mean(), right, estimate.three_sigma() * 5.0 / 3.0 + 1e-4) {
            let advice = "Light is reflected by the upper side, and by the lower one, to and fro: 2F / (1 + F) in all. Ask for the \
                          story of a pixel in the picture, `--pixel 480,270`.";
            let (got, expected) = (format!("the mean {}", about(estimate.mean())), about(right));
            return Err(Finding { tried, got, expected, advice: advice.into() }.named("pane"));
        }
    }
    Ok(())
}
