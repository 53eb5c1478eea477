//! Refraction: how a ray bends where it enters another medium.

use common::Vec3;

// ANCHOR: refract
/// Where a ray of unit direction d goes on behind a surface with the unit normal N, which faces the ray. `eta` is the
/// refractive index of the medium behind the surface divided by that of the medium before it.
///
/// `None` if there is no such direction: then all the light is reflected. Snell's law, `sin θ = eta · sin θ_t`.
#[must_use]
pub fn refract(direction: Vec3, normal: Vec3, eta: f32) -> Option<Vec3> {
    let cosine = -direction.dot(normal);
    // cos² θ_t = 1 − sin² θ_t, by Snell's law.
    let cosine2_behind = 1.0 - (1.0 - cosine * cosine) / (eta * eta);
    if cosine2_behind < 0.0 {
        return None;
    }
    Some(direction / eta + normal * (cosine / eta - cosine2_behind.sqrt()))
}
// ANCHOR_END: refract

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thirty_degrees_in_glass_of_root_two_are_forty_five_outside() {
        let eta = std::f32::consts::SQRT_2;
        let inside = Vec3::new(0.5, -0.75_f32.sqrt(), 0.0);
        let outside = Vec3::new(0.5_f32.sqrt(), -0.5_f32.sqrt(), 0.0);
        assert!((refract(outside, Vec3::Y, eta).unwrap() - inside).length() < 1e-6);
        assert!((refract(inside, Vec3::Y, 1.0 / eta).unwrap() - outside).length() < 1e-6);
    }

    #[test]
    fn beyond_the_critical_angle_nothing_gets_out() {
        // In water, sin θ above 1/1.333 = 0.7502 is too much.
        let at = |sine: f32| Vec3::new(sine, -(1.0 - sine * sine).sqrt(), 0.0);
        assert!(refract(at(0.750), Vec3::Y, 1.0 / 1.333).is_some());
        assert_eq!(refract(at(0.751), Vec3::Y, 1.0 / 1.333), None);
    }
}
