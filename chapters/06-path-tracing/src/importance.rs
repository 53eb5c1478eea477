//! Importance sampling: a path goes on where much of the light is sent on.

use common::{
    Rgb, Stream, Vec3,
    story::{number, triple},
};
use ray_casting::hit::Hit;
use sampling::{
    direction_sample::{Density, DirectionSample},
    direction_sampling::DirectionSampling,
    mirror::sample_mirror,
    sky_light::Choice,
    unit_square::sample_unit_square,
};

use crate::{
    material::Material,
    method::Method,
    probe::Probe,
    roulette::{Chances, Kind},
};

// ANCHOR: step
/// How a path goes on from a hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Where to, as a unit vector.
    pub direction: Vec3,
    /// What the radiance from there is multiplied by: the share that is sent on, divided by how likely the step was.
    pub weight: Rgb,
}
// ANCHOR_END: step

// Inlined, like what it calls: else each hit and each step is copied through memory.
// ANCHOR: step_from
/// A random step from a hit, seen from the unit vector `to_viewer`; `None` ends the path.
#[inline(always)]
pub fn step(
    method: &Method,
    material: &Material,
    hit: &Hit,
    to_viewer: Vec3,
    random: &mut Stream,
    probe: &mut impl Probe,
) -> Option<Step> {
    let reflectance = match method.choice {
        // The chance that a uniform direction is the mirror direction is 0: mirrors stay black.
        Choice::Uniform => Rgb::ZERO,
        Choice::CosineAndMirror => material.reflectance(to_viewer.dot(hit.shading_normal), method.fresnel),
    };
    // Choose a kind of reflection, or the end.
    let chances = Chances::of(material.albedo(), reflectance);
    let chances = if method.roulette { chances } else { chances.without_end() };
    let chosen = chances.choose(random);
    probe.tell(|| {
        let [diffuse, mirror, end] =
            [chances.diffuse, chances.mirror, (1.0 - chances.diffuse - chances.mirror).max(0.0)].map(number);
        format!("chances: diffuse s_d = {diffuse}, mirror s_m = {mirror}, end {end}")
    });
    let Some((kind, probability)) = chosen else {
        probe.tell(|| "chosen: the end".into());
        return None;
    };
    // Choose a direction, and weigh it.
    let (sample, weight) = match kind {
        Kind::Diffuse => diffuse_step(method.choice, material, hit, random),
        Kind::Mirror => (sample_mirror(hit.shading_normal, to_viewer), reflectance),
    };
    let step = Step { direction: sample.direction, weight: weight / probability };
    probe.tell(|| tell_step(kind, &sample, probability, &step));
    // A smoothly shaded surface may ask for a direction that lies below its triangle: nothing comes from there.
    if step.direction.dot(hit.geometric_normal) <= 0.0 {
        probe.tell(|| "that is below the surface: the end".into());
        return None;
    }
    Some(step)
}
// ANCHOR_END: step_from

// ANCHOR: diffuse
/// A direction at a matte surface, and `k_d cosθ / p`.
#[inline(always)]
fn diffuse_step(choice: Choice, material: &Material, hit: &Hit, random: &mut Stream) -> (DirectionSample, Rgb) {
    let u = sample_unit_square(random);
    match choice {
        Choice::Uniform => {
            let sample = DirectionSampling::UniformHemisphere.sample(hit.shading_normal, u);
            let cos_theta = sample.direction.dot(hit.shading_normal).max(0.0);
            (sample, material.diffuse * (cos_theta * sample.density.weight()))
        }
        // With p = cosθ/π the cosine cancels, and the weight is the albedo, whatever the direction.
        Choice::CosineAndMirror => {
            (DirectionSampling::CosineHemisphere.sample(hit.shading_normal, u), material.albedo())
        }
    }
}
// ANCHOR_END: diffuse

fn tell_step(kind: Kind, sample: &DirectionSample, probability: f32, step: &Step) -> String {
    let kind = match kind {
        Kind::Diffuse => "diffuse",
        Kind::Mirror => "mirror",
    };
    let density = match sample.density {
        Density::SolidAngle(p) => format!("density p = {} per steradian", number(p)),
        Density::Discrete(p) => format!("a discrete direction, of probability {}", number(p)),
    };
    let [direction, weight] = [step.direction, step.weight].map(triple);
    format!(
        "chosen: {kind}, with probability {}, direction {direction}\n  {density}; weight {weight}",
        number(probability)
    )
}
