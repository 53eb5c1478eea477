//! Recursive ray tracing after Whitted: a tree of rays for each point of the film.
//!
//! Source: Whitted, *An Improved Illumination Model for Shaded Display*, Communications of the ACM 23(6), 1980.

use common::{
    Rgb, Stream,
    picture::{FilmPoint, Integrator},
    story::{Story, Untold, triple},
};
use ray_casting::{
    camera::Camera,
    hit::Hit,
    local_illumination::{tell_hit, tell_ray},
    scene::{Object, Scene},
};
use shadows::{direct_light::direct_light, offset::Offset};

use crate::{
    branches::{Branch, branches},
    material::{Fresnel, Material},
    probe::{Kind, Listener, Probe, Segment},
};

// ANCHOR: whitted
/// A scene of rough, mirroring and clear things, seen by a camera.
pub struct Whitted {
    /// What is to be seen.
    pub scene: Scene<Material>,
    /// Who looks.
    pub camera: Camera,
    /// When the recursion ends.
    pub limits: Limits,
    /// Which terms of the formula are shown.
    pub terms: Terms,
    /// Which formula says how much is reflected.
    pub fresnel: Fresnel,
    /// How far from the surface new rays start.
    pub offset: Offset,
}

/// When the recursion ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// How many surfaces a ray may have behind it and still be followed; 0 for camera rays only.
    pub max_depth: u32,
    /// The least share of a ray's radiance, averaged over the channels, that is worth following the ray.
    pub min_weight: f32,
}
// ANCHOR_END: whitted

impl Limits {
    /// Eight surfaces, and nothing below a thousandth.
    pub const DEFAULT: Limits = Limits { max_depth: 8, min_weight: 1.0 / 1024.0 };
}

/// Which terms of the formula are shown at the first surface; behind it all of them count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Terms {
    /// The direct light on rough surfaces.
    pub rough: bool,
    /// `F · L(R)`.
    pub reflective: bool,
    /// `(1 − F) · L(T)`.
    pub refractive: bool,
}

impl Terms {
    /// The whole formula.
    pub const ALL: Terms = Terms { rough: true, reflective: true, refractive: true };
    /// Nothing of it.
    pub const NONE: Terms = Terms { rough: false, reflective: false, refractive: false };

    /// Whether a branch of this kind is shown.
    fn shows(self, kind: Kind) -> bool {
        match kind {
            Kind::Camera => true,
            Kind::Reflected => self.reflective,
            Kind::Refracted => self.refractive,
        }
    }
}

impl Whitted {
    // ANCHOR: plain
    /// `L(V) = direct + F · L(R) + (1 − F) · L(T)`, as it stands on paper: the function calls itself.
    #[must_use]
    pub fn trace_plain(&self, branch: &Branch, depth: u32) -> Rgb {
        let background = self.scene.background.radiance(branch.ray.direction);
        // Nobody knows what comes from there: guess.
        if depth > self.limits.max_depth {
            return background;
        }
        let Some((hit, object)) = self.scene.intersect(&branch.ray, branch.range) else { return background };
        let mut radiance = self.rough(branch, &hit, &object.material, &mut Untold);
        for next in branches(&branch.ray, &hit, &object.material, self.fresnel, self.offset).into_iter().flatten() {
            radiance += next.share * self.trace_plain(&next, depth + 1);
        }
        radiance
    }
    // ANCHOR_END: plain

    // ANCHOR: trace
    /// The radiance that a camera ray brings, and each ray told to a probe.
    ///
    /// Each of two branches is followed with the share that it has of the whole. The weaker one is followed by
    /// recursion: its share is at most half, so the recursion is never deep. The stronger one goes on in the loop.
    pub fn trace(&self, branch: Branch, depth: u32, probe: &mut impl Probe) -> Rgb {
        let mut radiance = Rgb::ZERO;
        let mut depths = depth..;
        let mut followed = Some(branch);
        while let (Some(branch), Some(depth)) = (followed, depths.next()) {
            let weight = branch.share;
            let Some((hit, object)) = self.hit(&branch, depth, probe) else {
                radiance += weight * self.scene.background.radiance(branch.ray.direction);
                break;
            };
            if depth > 0 || self.terms.rough {
                radiance += weight * self.rough(&branch, &hit, &object.material, probe);
            }
            // Find the rays that the surface sends on, and their share of the whole.
            let next = branches(&branch.ray, &hit, &object.material, self.fresnel, self.offset);
            let next = next.map(|b| b.filter(|b| depth > 0 || self.terms.shows(b.kind)));
            let next = next.map(|b| b.map(|b| Branch { share: weight * b.share, ..b }));
            // Where the recursion ends, guess what comes from there.
            let ends = |b: &Branch| depth >= self.limits.max_depth || mean(b.share) < self.limits.min_weight;
            for cut in next.iter().flatten().filter(|b| ends(b)) {
                radiance += cut.share * self.scene.background.radiance(cut.ray.direction);
                probe.tell(|| tell_cut(cut));
                probe.cut(cut.share);
            }
            let [reflected, refracted] = next.map(|b| b.filter(|b| !ends(b)));
            let (stronger, weaker) = by_weight(reflected, refracted);
            // Follow the weaker branch by recursion and the stronger one in this loop.
            if let Some(weaker) = weaker {
                probe.enter(|| "aside:".into());
                radiance += self.trace(weaker, depth + 1, probe);
                probe.leave();
            }
            followed = stronger;
        }
        radiance
    }
    // ANCHOR_END: trace
}

impl Whitted {
    /// The first hit of a branch, told to the probe.
    fn hit(&self, branch: &Branch, depth: u32, probe: &mut impl Probe) -> Option<(Hit, &Object<Material>)> {
        let nearest = self.scene.intersect(&branch.ray, branch.range);
        probe.tell(|| tell_branch(branch, depth));
        tell_ray(probe, &branch.ray);
        match &nearest {
            Some((hit, object)) => tell_hit(probe, hit, object),
            None => probe.tell(|| {
                let background = self.scene.background.radiance(branch.ray.direction);
                format!("hits nothing: background {}", triple(background))
            }),
        }
        probe.followed(Segment {
            kind: branch.kind,
            depth,
            weight: branch.share,
            from: branch.ray.origin,
            to: nearest.as_ref().map(|(hit, _)| hit.position),
            direction: branch.ray.direction,
        });
        nearest
    }

    /// The direct light on a rough surface; nothing on others.
    fn rough(&self, branch: &Branch, hit: &Hit, material: &Material, story: &mut impl Story) -> Rgb {
        let to_viewer = -branch.ray.direction;
        material.rough.map_or(Rgb::ZERO, |rough| direct_light(&self.scene, &rough, hit, to_viewer, self.offset, story))
    }
}

/// Two branches, that with the greater share first.
fn by_weight(a: Option<Branch>, b: Option<Branch>) -> (Option<Branch>, Option<Branch>) {
    match (a, b) {
        (Some(x), Some(y)) if mean(y.share) > mean(x.share) => (b, a),
        (None, _) => (b, None),
        _ => (a, b),
    }
}

/// The mean of the three channels.
pub(crate) fn mean(color: Rgb) -> f32 {
    color.element_sum() / 3.0
}

fn tell_branch(branch: &Branch, depth: u32) -> String {
    format!("depth {depth}: {} ray, carries {} of the whole", name(branch.kind), triple(branch.share))
}

fn tell_cut(branch: &Branch) -> String {
    format!("not followed any more: {} ray that carries {}", name(branch.kind), triple(branch.share))
}

fn name(kind: Kind) -> &'static str {
    match kind {
        Kind::Camera => "camera",
        Kind::Reflected => "reflected",
        Kind::Refracted => "refracted",
    }
}

// ANCHOR: integrator
impl Integrator for Whitted {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        self.trace(Branch::from_camera(self.camera.ray(point)), 0, &mut Listener(story))
    }
}
// ANCHOR_END: integrator
