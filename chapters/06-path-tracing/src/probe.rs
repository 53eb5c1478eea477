//! The probe: somebody who follows a path.

use common::story::{Story, Untold};
use whitted::probe::Listener;

// ANCHOR: probe
/// A [`Story`] that is also told of every ray. To nobody, told by [`Untold`], it costs nothing.
pub trait Probe: Story {
    /// A ray of the path itself is followed.
    fn path_ray(&mut self) {}

    /// A light is looked for.
    fn shadow_ray(&mut self) {}
}

/// Nobody counts.
impl Probe for Untold {}

/// Somebody listens to the story alone.
impl<S: Story> Probe for Listener<'_, S> {}

/// Counts rays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RayCounts {
    /// Rays of the path itself.
    pub path_rays: u64,
    /// Rays toward lights.
    pub shadow_rays: u64,
}
// ANCHOR_END: probe

impl Probe for RayCounts {
    fn path_ray(&mut self) {
        self.path_rays += 1;
    }

    fn shadow_ray(&mut self) {
        self.shadow_rays += 1;
    }
}

/// Words are not for it.
impl Story for RayCounts {
    fn tell(&mut self, _line: impl FnOnce() -> String) {}
    fn enter(&mut self, _line: impl FnOnce() -> String) {}
    fn leave(&mut self) {}
}
