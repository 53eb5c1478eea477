//! The probe: somebody who follows every ray of a tree.

use common::{Rgb, Vec3, story::Story};

// ANCHOR: probe
/// A [`Story`] that is also told of every ray: where it goes from and to, and why.
pub trait Probe: Story {
    /// A ray has been followed to its end.
    fn followed(&mut self, _segment: Segment) {}

    /// A ray of this weight is not followed: the background is taken in its place.
    fn cut(&mut self, _weight: Rgb) {}
}

/// A ray from its origin to what it hits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// Why it was sent.
    pub kind: Kind,
    /// How many surfaces lie between it and the eye.
    pub depth: u32,
    /// Which share of its radiance reaches the eye.
    pub weight: Rgb,
    /// Where it starts.
    pub from: Vec3,
    /// Where it ends; `None` if it hits nothing.
    pub to: Option<Vec3>,
    /// Where it goes, as a unit vector.
    pub direction: Vec3,
}

/// Why a ray was sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// From the eye.
    Camera,
    /// Off a mirror.
    Reflected,
    /// Through a surface.
    Refracted,
}
// ANCHOR_END: probe

/// Somebody who listens to the story alone.
pub struct Listener<'s, S>(pub &'s mut S);

impl<S: Story> Probe for Listener<'_, S> {}

impl<S: Story> Story for Listener<'_, S> {
    #[inline(always)]
    fn tell(&mut self, line: impl FnOnce() -> String) {
        self.0.tell(line);
    }

    #[inline(always)]
    fn enter(&mut self, line: impl FnOnce() -> String) {
        self.0.enter(line);
    }

    #[inline(always)]
    fn leave(&mut self) {
        self.0.leave();
    }
}

// ANCHOR: ray_tree
/// Writes down every ray of a tree: each one before those that it caused.
#[derive(Clone, Debug, Default)]
pub struct RayTree(pub Vec<Segment>);

impl Probe for RayTree {
    fn followed(&mut self, segment: Segment) {
        self.0.push(segment);
    }
}
// ANCHOR_END: ray_tree

/// Words are not for it.
impl Story for RayTree {
    fn tell(&mut self, _line: impl FnOnce() -> String) {}
    fn enter(&mut self, _line: impl FnOnce() -> String) {}
    fn leave(&mut self) {}
}
