//! Direct light: what the abstract lights send straight to a matte surface.
//!
//! They have no size, so no walk ever hits one: they are asked at every hit, and nothing is counted twice. Surfaces that
//! glow, and the sky, are found by chance alone.

use common::{
    Rgb,
    story::{number, triple},
};
use ray_casting::hit::Hit;
use shadows::{offset::Offset, shadow_ray::is_in_shadow};

use crate::{material::Material, probe::Probe, world::World};

// ANCHOR: direct_light
/// `Σ k_d (L·N)⁺ L_l` over the lights that the point sees.
#[inline(always)]
pub fn direct_light(world: &World, material: &Material, hit: &Hit, probe: &mut impl Probe) -> Rgb {
    let mut radiance = Rgb::ZERO;
    if material.diffuse == Rgb::ZERO {
        return radiance;
    }
    for (i, light) in world.scene().lights.iter().enumerate() {
        let light = light.illuminate(hit.position);
        let cos_theta = light.direction.dot(hit.shading_normal);
        // Of a light behind the surface nothing arrives; nor of one in the very place of the hit.
        if cos_theta.is_nan() || cos_theta <= 0.0 {
            probe.tell(|| format!("light {}: behind the surface, adds nothing", i + 1));
            continue;
        }
        probe.shadow_ray();
        if is_in_shadow(world.scene(), hit, &light, Offset::Following) {
            probe.tell(|| format!("light {}: in shadow, adds nothing", i + 1));
            continue;
        }
        let reflected = material.diffuse * light.strength * cos_theta;
        radiance += reflected;
        probe.tell(|| {
            let [strength, reflected] = [light.strength, reflected].map(triple);
            format!("light {}: strength {strength}, L·N = {}, adds {reflected}", i + 1, number(cos_theta))
        });
    }
    radiance
}
// ANCHOR_END: direct_light
