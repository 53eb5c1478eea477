//! What several pictures share: how many steps the ray of each pixel takes, as a color.

use common::{
    Rgb, Stream,
    color::{gradient, srgb},
    float,
    picture::{FilmPoint, Integrator},
    story::Story,
};
use ray_casting::{camera::Camera, local_illumination::tell_ray, ray::Ray};

/// How bright a share of the most steps is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Scale {
    /// Twice as many steps are twice as bright.
    Even,
    /// Eight times as many are: so that few and very many are both to be seen.
    CubeRoot,
}

/// Shows steps as a color.
pub(super) struct Steps<F> {
    /// Who looks.
    pub(super) camera: Camera,
    /// What so many steps are, is white.
    pub(super) most: f32,
    /// How bright a share of that is.
    pub(super) scale: Scale,
    /// Counts the steps of a ray.
    pub(super) count: F,
}

impl<F: Fn(&Ray) -> u64 + Send + Sync> Integrator for Steps<F> {
    #[expect(clippy::cast_precision_loss, reason = "few steps")]
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        let ray = self.camera.ray(point);
        tell_ray(story, &ray);
        let steps = (self.count)(&ray);
        story.tell(|| format!("takes {steps} steps"));
        let share = steps as f32 / self.most;
        heat(if self.scale == Scale::CubeRoot { float::cbrt(share) } else { share })
    }
}

/// From black through violet, red and yellow to white as `share` goes from 0 to 1.
pub(super) fn heat(share: f32) -> Rgb {
    let colors = [srgb(8, 10, 22), srgb(62, 28, 110), srgb(188, 55, 84), srgb(249, 142, 9), srgb(252, 255, 220)];
    gradient(&colors, share)
}
