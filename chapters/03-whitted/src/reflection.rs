//! The mirror direction.

use common::Vec3;

// ANCHOR: reflect
/// `R = d − 2 N (N·d)`: where a mirror with the unit normal N sends a ray of direction d. The length of d is kept.
#[must_use]
pub fn reflect(direction: Vec3, normal: Vec3) -> Vec3 {
    direction - 2.0 * normal * normal.dot(direction)
}
// ANCHOR_END: reflect

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_part_along_the_normal_turns_round() {
        assert_eq!(reflect(Vec3::new(3.0, -2.0, 1.0), Vec3::Y), Vec3::new(3.0, 2.0, 1.0));
        assert_eq!(reflect(-Vec3::Z, Vec3::Z), Vec3::Z);
    }
}
