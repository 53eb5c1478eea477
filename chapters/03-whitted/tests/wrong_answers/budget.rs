//! Wrong searches.

use common::{Rgb, color::luminance};
use whitted::branches::Branch;

use crate::{
    checks::{
        budget::check,
        world::{Trace, World, depth_first},
    },
    name,
};

/// A search of which everything can be changed: how to rank rays by their share of the whole, share of their parent and
/// age, how many rays to follow, and what to add.
struct Search {
    rank: fn(Rgb, Rgb, u32) -> f32,
    limit: fn(u32) -> u32,
    found: fn(Rgb, Rgb) -> Rgb,
    guess: fn(Rgb, Rgb) -> Rgb,
    dark: bool,
    /// Whether a ray may wait, by its share of the whole, and whether it is the first of two.
    keeps: fn(Rgb, bool) -> bool,
    /// The share of the whole, by that of the parent and its own.
    whole: fn(Rgb, Rgb) -> Rgb,
    /// Whether the search ends early, by the number of rays followed and waiting, and the budget.
    ends: fn(usize, usize, u32) -> bool,
}

const RIGHT: Search = Search {
    rank: |whole, _, _| whole.element_sum(),
    limit: |budget| budget,
    found: |whole, radiance| whole * radiance,
    guess: |whole, background| whole * background,
    dark: false,
    keeps: |_, _| true,
    whole: |parent, share| parent * share,
    ends: |_, _, _| false,
};

fn run(search: &Search, world: &dyn World, camera_ray: Branch, budget: u32) -> Rgb {
    let mut radiance = Rgb::ZERO;
    let mut age = 0;
    let mut waiting = vec![(camera_ray, camera_ray.share, 0)];
    for followed in 0..(search.limit)(budget) {
        if (search.ends)(followed as usize, waiting.len(), budget) {
            break;
        }
        let rank = |i: &usize| (search.rank)(waiting[*i].0.share, waiting[*i].1, waiting[*i].2);
        let Some(best) = (0..waiting.len()).max_by(|a, b| rank(a).total_cmp(&rank(b))) else { break };
        let (branch, ..) = waiting.swap_remove(best);
        let surface = world.follow(&branch);
        radiance += (search.found)(branch.share, surface.radiance);
        for (i, next) in (0..).zip(surface.next) {
            let Some(next) = next else { continue };
            age += 1;
            let whole = (search.whole)(branch.share, next.share);
            if (search.keeps)(whole, i == 0) && (search.dark || whole != Rgb::ZERO) {
                waiting.push((Branch { share: whole, ..next }, next.share, age));
            }
        }
    }
    radiance + waiting.iter().map(|(b, ..)| (search.guess)(b.share, world.background(b))).sum::<Rgb>()
}

fn diagnosis(trace: Trace) -> &'static str {
    name(check(trace))
}

/// The diagnosis of the right search with one thing changed.
macro_rules! changed {
    ($field:ident: $value:expr) => {
        diagnosis(|world, ray, budget| run(&Search { $field: $value, ..RIGHT }, world, ray, budget))
    };
}

#[test]
fn the_right_one_is_accepted() {
    assert_eq!(check(|world, ray, budget| run(&RIGHT, world, ray, budget)), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(diagnosis(|_, _, _| Rgb::ZERO), "not-started");
    assert_eq!(diagnosis(|world, ray, _| ray.share * world.background(&ray)), "nothing-followed");
}

#[test]
fn wrong_orders() {
    assert_eq!(diagnosis(depth_first), "depth-first");
    assert_eq!(changed!(rank: |_, _, age| age as f32), "depth-first");
    assert_eq!(changed!(rank: |_, _, age| -(age as f32)), "breadth-first");
    assert_eq!(changed!(rank: |whole, _, _| -whole.element_sum()), "least-first");
    assert_eq!(changed!(rank: |_, share, _| share.element_sum()), "share-of-parent");
    assert_eq!(changed!(rank: |whole, _, _| whole.x), "one-channel");
    assert_eq!(changed!(rank: |whole, _, _| luminance(whole)), "luminance");
    assert_eq!(changed!(rank: |whole, _, _| whole.max_element()), "greatest-channel");
    assert_eq!(changed!(rank: |whole, _, _| whole.length()), "vector-length");
    assert_eq!(changed!(rank: |whole, _, age| whole.y - age as f32 / 8.0), "wrong-order");
}

#[test]
fn wrong_budgets() {
    assert_eq!(changed!(limit: |budget| budget + 1), "camera-ray-not-counted");
    assert_eq!(changed!(limit: |_| 1000), "over-budget");
    assert_eq!(changed!(limit: |_| u32::MAX), "over-budget");
    assert_eq!(changed!(limit: |budget| budget.min(8)), "budget-not-used");
    assert_eq!(changed!(limit: |budget| budget.min(5000)), "budget-not-used");
    assert_eq!(changed!(dark: true), "followed-for-nothing");
    // Recursion that shares out its budget evenly.
    fn halves(world: &dyn World, ray: Branch, budget: u32) -> Rgb {
        if budget == 0 {
            return ray.share * world.background(&ray);
        }
        let surface = world.follow(&ray);
        let next = surface.next.into_iter().flatten();
        let rest = next.map(|b| halves(world, Branch { share: ray.share * b.share, ..b }, (budget - 1) / 2));
        ray.share * surface.radiance + rest.sum::<Rgb>()
    }
    assert_eq!(diagnosis(halves), "budget-not-used");
}

#[test]
fn rays_that_are_lost() {
    assert_eq!(changed!(keeps: |_, is_first| is_first), "ray-lost");
    assert_eq!(
        diagnosis(|world, ray, budget| {
            let mut radiance = Rgb::ZERO;
            let mut branch = ray;
            for _ in 0..budget {
                let surface = world.follow(&branch);
                radiance += branch.share * surface.radiance;
                let Some(next) = surface.next.into_iter().flatten().next() else { return radiance };
                branch = Branch { share: branch.share * next.share, ..next };
            }
            radiance + branch.share * world.background(&branch)
        }),
        "ray-lost"
    );
    assert_eq!(changed!(keeps: |whole, _| whole.min_element() != 0.0), "channel-zero-dropped");
    assert_eq!(changed!(keeps: |whole, _| whole.x != 0.0), "channel-zero-dropped");
    assert_eq!(changed!(keeps: |whole, _| whole.z != 0.0), "channel-zero-dropped");
    assert_eq!(changed!(keeps: |whole, _| whole.element_sum() / 3.0 > 1e-12), "weak-dropped");
    assert_eq!(changed!(keeps: |whole, _| whole.element_sum() / 3.0 > 1e-24), "weak-dropped");
}

#[test]
fn rays_that_count_twice() {
    // What waits is followed in the end.
    assert_eq!(
        diagnosis(|world, ray, budget| {
            let mut radiance = Rgb::ZERO;
            let mut waiting = vec![ray];
            for _ in 0..budget {
                let rank = |i: &usize| waiting[*i].share.element_sum();
                let Some(best) = (0..waiting.len()).max_by(|a, b| rank(a).total_cmp(&rank(b))) else { break };
                let branch = waiting.swap_remove(best);
                let surface = world.follow(&branch);
                radiance += branch.share * surface.radiance;
                let next = surface.next.into_iter().flatten();
                waiting.extend(next.map(|next| Branch { share: branch.share * next.share, ..next }));
            }
            radiance + waiting.iter().map(|b| b.share * world.follow(b).radiance).sum::<Rgb>()
        }),
        "rest-followed"
    );
    assert_eq!(changed!(ends: |followed, waiting, budget| followed + waiting >= budget as usize), "waiting-counted");
    assert_eq!(changed!(ends: |followed, waiting, budget| followed + waiting > budget as usize), "waiting-counted");
}

#[test]
fn wrong_sums() {
    assert_eq!(changed!(whole: |parent, share| parent + share), "shares-added");
    assert_eq!(diagnosis(|world, ray, budget| run(&RIGHT, world, ray, budget).min(Rgb::ONE)), "clamped");
    assert_eq!(changed!(found: |whole, radiance| whole * radiance * f32::NAN), "not-a-number");
    assert_eq!(changed!(guess: |_, _| Rgb::ZERO), "rest-forgotten");
    assert_eq!(changed!(guess: |_, background| background), "rest-unweighted");
    assert_eq!(changed!(found: |_, radiance| radiance), "shares-missing");
    assert_eq!(changed!(found: |_, _| Rgb::ZERO), "radiance-forgotten");
    assert_eq!(
        diagnosis(|world, ray, budget| run(&RIGHT, world, Branch { share: Rgb::ONE, ..ray }, budget)),
        "camera-share"
    );
    assert_eq!(changed!(found: |whole, radiance| 2.0 * whole * radiance), "wrong-sum");
}
