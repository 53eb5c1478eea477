//! The world that rays are followed in: a scene, or a tree of rays made up for a check.

use common::{Rgb, story::Untold};
use shadows::direct_light::direct_light;
use whitted::{
    branches::{Branch, branches},
    whitted::Whitted,
};

/// Where rays can be followed.
pub(crate) trait World {
    /// Follow a ray to its end, for one ray of the budget.
    fn follow(&self, branch: &Branch) -> Surface;

    /// What a ray brings if nobody follows it: a guess.
    fn background(&self, branch: &Branch) -> Rgb;
}

/// What a ray finds at its end.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Surface {
    /// The radiance from there without any further ray: direct light, or the background where nothing is hit.
    pub(crate) radiance: Rgb,
    /// The rays that are caused. Their share is the part of their radiance that goes on along the ray that was followed.
    pub(crate) next: [Option<Branch>; 2],
}

/// What the student writes: the radiance that a camera ray brings with a budget of rays.
pub(crate) type Trace = fn(&dyn World, Branch, u32) -> Rgb;

impl World for Whitted {
    fn follow(&self, branch: &Branch) -> Surface {
        let Some((hit, object)) = self.scene.intersect(&branch.ray, branch.range) else {
            return Surface { radiance: World::background(self, branch), ..Surface::default() };
        };
        let rough = object.material.rough;
        let radiance = rough.map_or(Rgb::ZERO, |rough| {
            direct_light(&self.scene, &rough, &hit, -branch.ray.direction, self.offset, &mut Untold)
        });
        Surface { radiance, next: branches(&branch.ray, &hit, &object.material, self.fresnel, self.offset) }
    }

    fn background(&self, branch: &Branch) -> Rgb {
        self.scene.background.radiance(branch.ray.direction)
    }
}

/// The same budget spent as recursion would: down the first ray as far as it goes.
pub(crate) fn depth_first(world: &dyn World, camera_ray: Branch, budget: u32) -> Rgb {
    let mut radiance = Rgb::ZERO;
    let mut waiting = vec![camera_ray];
    for _ in 0..budget {
        let Some(branch) = waiting.pop() else { break };
        let surface = world.follow(&branch);
        radiance += branch.share * surface.radiance;
        let next = surface.next.into_iter().flatten().rev();
        waiting.extend(next.map(|next| Branch { share: branch.share * next.share, ..next }));
    }
    radiance + waiting.iter().map(|branch| branch.share * world.background(branch)).sum::<Rgb>()
}
