//! Chance: what makes things differ from each other, the same in every run.

use common::{Stream, Vec3, float};

/// The random numbers of one thing.
pub struct Chance(Stream);

impl Chance {
    /// The numbers of the thing of that index, among all things of a kind: its name is the seed.
    #[must_use]
    pub fn of(kind: &str, index: u32) -> Self {
        // The stream hashes its seed once more, so a simple sum of letters is enough.
        let seed = kind.bytes().fold(0_u64, |sum, letter| sum.wrapping_mul(257).wrapping_add(u64::from(letter)));
        Self::numbered(seed, u64::from(index))
    }

    /// The numbers of the kind of things that has a number instead of a name, in the scene of that seed.
    #[must_use]
    pub fn numbered(seed: u64, kind: u64) -> Self {
        Self(Stream::new(seed, kind, 0))
    }

    /// A number from `low` to `high`.
    pub fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.0.uniform()
    }

    /// A number from `-reach` to `reach`.
    pub fn around(&mut self, reach: f32) -> f32 {
        self.between(-reach, reach)
    }

    /// Whether something happens that has this probability.
    pub fn happens(&mut self, probability: f32) -> bool {
        self.0.uniform() < probability
    }

    /// One of `n` indices.
    #[expect(clippy::cast_precision_loss, reason = "few things to choose from")]
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to n")]
    pub fn index(&mut self, n: usize) -> usize {
        ((self.0.uniform() * n as f32) as usize).min(n.saturating_sub(1))
    }

    /// An angle of the whole circle, in radians.
    pub fn angle(&mut self) -> f32 {
        std::f32::consts::TAU * self.0.uniform()
    }

    /// A point of the unit ball, each as likely as any other.
    pub fn in_ball(&mut self) -> Vec3 {
        // A few tries are nearly always enough: the ball fills half of the cube.
        for _ in 0..64 {
            let point = Vec3::new(self.around(1.0), self.around(1.0), self.around(1.0));
            if point.length_squared() <= 1.0 {
                return point;
            }
        }
        Vec3::ZERO
    }

    /// A direction, each as likely as any other.
    pub fn direction(&mut self) -> Vec3 {
        self.in_ball().normalize_or(Vec3::Y)
    }

    /// A point of the unit sphere, each as likely as any other: what [`Self::direction`] gives, but always from two
    /// numbers, a height and an angle.
    ///
    /// Source: Archimedes, *On the Sphere and Cylinder*: slices of equal height have equal areas.
    pub fn on_sphere(&mut self) -> Vec3 {
        let height = self.around(1.0);
        let across = (1.0 - height * height).max(0.0).sqrt();
        let angle = self.angle();
        Vec3::new(across * float::cos(angle), height, across * float::sin(angle))
    }
}
