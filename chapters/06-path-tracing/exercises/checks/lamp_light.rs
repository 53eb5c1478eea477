//! Checks what a matte surface sends on of a lamp's light, for exercise 6.2.

use common::{
    Rgb, Stream, Vec3,
    exercise::{Diagnosis, Finding, Verdict, trying},
};
use path_tracing::material::Material;
use ray_casting::{hit::Hit, ray::Ray, sphere::Sphere};
use sampling::estimate::Estimate;

use super::{
    lamp::Lamp,
    lamp_exact::{Seen, irradiance, mean},
    lamp_world::LampWorld,
    words::{about, is_near, triple},
};

type LampLight = fn(&LampWorld, &Material, &Hit, &mut Stream) -> Rgb;

/// Some quantity of a point of the lamp.
type Quantity<'q> = &'q dyn Fn(&Seen) -> f64;

/// Samples of each place.
const COUNT: u64 = 20_000;
/// Radiance of the lamp and albedo of the surface: each channel has its own.
const RADIANCE: Rgb = Rgb::new(3.0, 2.0, 5.0);
const ALBEDO: Rgb = Rgb::new(0.8, 0.5, 0.2);

/// The lamp of this check, above the origin.
fn lamp() -> Lamp {
    Lamp::around(Vec3::new(0.5, 2.0, 0.0), [Vec3::new(1.0, 0.0, 0.25), Vec3::new(0.0, 0.5, 1.0)], RADIANCE)
}

/// A hit at a point that faces some direction.
pub(super) fn hit_at(point: Vec3, normal: Vec3) -> Hit {
    let normal = normal.normalize();
    Hit::new(&Ray::new(point + normal, -normal), 1.0, normal)
}

/// Accept the light of a lamp, or name what is wrong with it.
pub(super) fn light(lamp_light: LampLight) -> Verdict {
    let open = LampWorld::new(lamp());
    // Below, above, beside with a part of the lamp below the horizon, and far away.
    let places = [
        hit_at(Vec3::new(0.0, 0.0, 0.0), Vec3::Y),
        hit_at(Vec3::new(1.0, 4.0, 0.5), Vec3::new(0.25, -1.0, 0.0)),
        hit_at(Vec3::new(0.5, 1.5, 0.25), Vec3::X),
        hit_at(Vec3::new(-5.0, -3.0, 2.0), Vec3::new(1.0, 1.0, 0.0)),
    ];
    let one = |hit: &Hit| lamp_light(&open, &Material::matte(ALBEDO), hit, &mut Stream::new(622, 0, 0));
    if places.iter().all(|hit| trying(|| words(hit), || one(hit)) == Rgb::ZERO) {
        let message = "`sample_lamp` is right. Now for `lamp_light`, which returns no light wherever it is asked. If you have written it: \
                       does `world.sees` get the sample, and do you drop what is seen, or what is not?";
        return Err(Diagnosis::new("light-not-started", message));
    }
    places.iter().try_for_each(|hit| in_the_open(lamp_light, &open, hit))?;
    hidden(lamp_light)
}

fn words(hit: &Hit) -> String {
    let (position, normal) = (triple(hit.position), triple(hit.shading_normal));
    format!(
        "`lamp_light` at {position} with the normal {normal}, for a lamp around {}",
        triple(Vec3::new(0.5, 2.0, 0.0))
    )
}

/// The mean of many samples, for each channel.
fn measure(lamp_light: LampLight, world: &LampWorld, material: &Material, hit: &Hit) -> [Estimate; 3] {
    let mut estimates = [Estimate::default(); 3];
    for i in 0..COUNT {
        let sample = trying(|| words(hit), || lamp_light(world, material, hit, &mut Stream::new(623, i, 0)));
        for (estimate, channel) in estimates.iter_mut().zip(sample.to_array()) {
            estimate.add(channel.into());
        }
    }
    estimates
}

/// Where nothing is in the way, the mean is known on paper.
fn in_the_open(lamp_light: LampLight, world: &LampWorld, hit: &Hit) -> Verdict {
    let material = Material::matte(ALBEDO);
    let estimates = measure(lamp_light, world, &material, hit);
    let scale = (material.diffuse * RADIANCE).to_array().map(f64::from);
    let right = irradiance(&world.lamp, hit.position, hit.shading_normal);
    let is = |scale: [f64; 3], other: f64| {
        let near = |(estimate, scale): (&Estimate, f64)| {
            let allowed = estimate.three_sigma() * 5.0 / 3.0 + 1e-4 * scale * other;
            is_near(estimate.mean(), scale * other, allowed)
        };
        estimates.iter().zip(scale).all(near)
    };
    if is(scale, right) {
        return Ok(());
    }
    let by = |quantity: Quantity<'_>| mean(&world.lamp, hit.position, hit.shading_normal, quantity);
    let (name, advice) = light_mistake(&|other| is(scale, other), right, &by);
    let (name, advice) = if is(RADIANCE.to_array().map(f64::from), right) {
        ("surface-forgotten", "k_d is missing: the surface sends on a share only, `material.diffuse`.")
    } else if is(material.diffuse.to_array().map(f64::from), right) {
        ("radiance-forgotten", "The radiance of the lamp is missing: `world.lamp.radiance`.")
    } else {
        (name, advice)
    };
    let got = estimates.map(|estimate| about(estimate.mean())).join(", ");
    let expected = scale.map(|scale| about(scale * right)).join(", ");
    let tried = format!("the mean of {COUNT} times {}", words(hit));
    Err(Finding { tried, got, expected, advice: advice.into() }.named(name))
}

/// Why a mean is wrong: `by` is the mean of some quantity over all points of the lamp.
fn light_mistake(
    is: &dyn Fn(f64) -> bool,
    right: f64,
    by: &dyn Fn(Quantity<'_>) -> f64,
) -> (&'static str, &'static str) {
    use std::f64::consts::PI;
    let seen = |seen: &Seen| f64::from(u8::from(seen.cosine > 0.0));
    if is(by(&|s| seen(s) / s.density())) {
        return (
            "cosine-at-the-surface-forgotten",
            "The cosine at the surface is missing: light that arrives at a slant is spread out.",
        );
    }
    if is(by(&|s| s.cosine / s.density())) {
        return (
            "below-the-horizon",
            "Points of the lamp below the surface take light away: where the cosine is negative, there is none.",
        );
    }
    if is(by(&|s| s.cosine.abs() / s.density())) {
        return (
            "below-the-horizon",
            "Points of the lamp below the surface give light: where the cosine is negative, there is none.",
        );
    }
    if is(by(&|s| s.cosine.max(0.0))) {
        return ("density-forgotten", "The density is missing: a sample is divided by how likely it was.");
    }
    if is(by(&|s| s.cosine.max(0.0) * s.density())) {
        return ("density-multiplied", "A sample is divided by its density, not multiplied.");
    }
    if is(by(&|s| s.cosine.max(0.0) * s.cosine_there / s.density())) {
        return ("cosine-at-the-lamp-twice", "The cosine at the lamp is in the density already.");
    }
    if is(right * PI) {
        return ("pi-in-the-light", "This is π times too bright: k_d is the BRDF, `material.diffuse`, not the albedo.");
    }
    if is(right / PI) {
        return ("pi-in-the-light", "This is π times too dark: `material.diffuse` has been divided by π already.");
    }
    ("wrong-light", "k_d L cosθ / p, one channel after the other, with the p of `sample_lamp`.")
}

/// What stands between takes all light, and what stands behind the lamp none. A mirror is not asked.
fn hidden(lamp_light: LampLight) -> Verdict {
    let hit = hit_at(Vec3::ZERO, Vec3::Y);
    let matte = Material::matte(ALBEDO);
    let with_ball = |y: f32, radius: f32| {
        LampWorld::new(lamp()).with("ball", Sphere::new(Vec3::new(0.2, y, 0.0), radius), Material::BLACK)
    };
    let wrong = |tried: String, got: f64, expected: f64, name, advice: &str| {
        let (got, expected) = (format!("the mean {}", about(got)), about(expected));
        Err(Finding { tried, got, expected, advice: advice.into() }.named(name))
    };
    let between = measure(lamp_light, &with_ball(0.8, 0.75), &matte, &hit)[0].mean();
    if between != 0.0 {
        let advice = "A ball stands between the point and the whole lamp. Ask `world.sees(hit, &sample)`.";
        return wrong(format!("{}, behind a ball", words(&hit)), between, 0.0, "no-shadow", advice);
    }
    let right = irradiance(&lamp(), hit.position, hit.shading_normal) * f64::from(matte.diffuse.x * RADIANCE.x);
    let behind = measure(lamp_light, &with_ball(6.0, 1.5), &matte, &hit)[0];
    if !is_near(behind.mean(), right, behind.three_sigma() * 5.0 / 3.0 + 1e-4) {
        let advice =
            "The ball stands behind the lamp, where it hides nothing. `sample.distance` says where the lamp is.";
        return wrong(format!("{}, a ball behind it", words(&hit)), behind.mean(), right, "shadow-from-behind", advice);
    }
    let mirror = measure(lamp_light, &LampWorld::new(lamp()), &Material::GOLD, &hit)[0].mean();
    if mirror != 0.0 {
        let advice =
            "A mirror has no matte part, `material.diffuse` is 0: it sends nothing of the lamp on when it is asked.";
        return wrong(format!("{}, on gold", words(&hit)), mirror, 0.0, "mirror-asked", advice);
    }
    Ok(())
}
