//! Checks exercise 3.4, a budget of rays.

use common::{
    Rgb, Vec3,
    exercise::{Diagnosis, Finding, Verdict, trying},
    random::Stream,
};
use ray_casting::{camera::Camera, material::Phong, ray::Ray, scene::Scene, sphere::Sphere};
use shadows::offset::Offset;
use whitted::{
    branches::Branch,
    material::{Fresnel, Material},
    probe::Listener,
    whitted::{Limits, Terms, Whitted},
};

use super::{
    budget_mistakes::follows_the_rest,
    tree::{Tree, two},
    words,
    world::{Trace, depth_first},
};

impl Tree {
    /// Ask the student's search, and judge it.
    fn check(&self, trace: Trace, budget: u32) -> Verdict {
        self.followed.borrow_mut().clear();
        let asked = || format!("{}, with a budget of {budget}", self.words);
        let got = trying(asked, || trace(self, self.branch(0), budget));
        let followed = self.followed.borrow().clone();
        let [ideal, rest] = self.ideal(budget as usize);
        let finding = |got: String, expected: String, name, advice: &str| {
            Err(Finding { tried: asked(), got, expected, advice: advice.into() }.named(name))
        };
        let rays = |n: usize| if n == 1 { "1 ray followed".into() } else { format!("{n} rays followed") };
        let many = |n: usize| if n > self.end { format!("more than {}", rays(self.end)) } else { rays(n) };
        if followed.len() > budget as usize {
            let (name, advice) = match followed.len() - budget as usize {
                1 if follows_the_rest(trace) => (
                    "rest-followed",
                    "When the budget is spent, you still follow what waits. Guess it instead, by `world.background`.",
                ),
                1 => ("camera-ray-not-counted", "One ray too many. The camera ray is one of the budget, too."),
                _ => ("over-budget", "Each call of `follow` takes 1 of the budget, wherever it is made."),
            };
            return finding(many(followed.len()), format!("at most {budget}"), name, advice);
        }
        let is_dark = |n: &usize| self.nodes.borrow()[*n].whole == Rgb::ZERO;
        if followed.iter().any(is_dark) {
            let advice =
                "A ray was followed whose share of the whole is zero: whatever it finds, nothing of it arrives.";
            return finding(rays(followed.len()), rays(ideal.len()), "followed-for-nothing", advice);
        }
        if followed != ideal {
            let i = (0..).find(|&i| followed.get(i) != ideal.get(i)).unwrap_or_default();
            let is_short = followed.len() == i;
            let told = |nodes: &[usize]| match nodes.get(i) {
                Some(&n) if !is_short => {
                    let whole = self.nodes.borrow()[n].whole;
                    format!("as ray {} the one with the share {} of the whole", i + 1, words::color(whole))
                }
                _ => rays(nodes.len()),
            };
            let (name, advice) = self.wrong_order(trace, [&followed, &ideal], got, budget as usize);
            return finding(told(&followed), told(&ideal), name, advice);
        }
        let right = self.sum(&ideal, |n| n.whole * n.radiance) + self.sum(&rest, |n| n.whole * n.background);
        if words::is_near(got, right, 1e-3) {
            return Ok(());
        }
        let (name, advice) = self.wrong_sum(got, right, &ideal, &rest);
        finding(words::color(got), words::color(right), name, advice)
    }
}

/// Accept a search, or name what is wrong with it.
pub(crate) fn check(trace: Trace) -> Verdict {
    let leaf = || Tree::new("a ray that causes no others", 10, |_, _| [None; 2]);
    let first = leaf();
    let is_black = trying(|| first.words.into(), || trace(&first, first.branch(0), 1)) == Rgb::ZERO;
    if is_black && first.followed.borrow().is_empty() {
        return Err(Diagnosis::not_started("`trace` follows no ray, and its result is black."));
    }
    // One ray after the other.
    for budget in [4, 1, 10, 0, 2000] {
        let gray = |_: usize, _: &mut Stream| [Some(Rgb::splat(0.999)), None];
        Tree::new("rays between two mirrors, each causing one more", budget, gray).check(trace, budget)?;
    }
    for budget in [1, 10, 0] {
        leaf().check(trace, budget)?;
    }
    // Trees that have an end, and trees that have none.
    for budget in [20, 2, 3, 4, 6, 9, 77, 300] {
        Tree::new("a tree of rays, each causing two more", budget, two).check(trace, budget)?;
    }
    let some = |node: usize, random: &mut Stream| {
        let share = |u: f32| match node {
            n if n > 40 => None,
            _ if u < 0.25 => Some(Rgb::ZERO),
            _ => Some(Rgb::new(u, 1.0 - u, 0.5)),
        };
        [share(random.uniform()), share(random.uniform())]
    };
    for budget in [5, 20, 200] {
        Tree::new("a tree of rays, some with a share of zero", budget, some).check(trace, budget)?;
    }
    // As behind glass of exercise 3.3: some rays bring one channel only.
    let channels = |node: usize, random: &mut Stream| {
        let one = Rgb::AXES[node % 3];
        let mut part = |least: f32| least + 0.25 * random.uniform();
        [
            Some(if node < 3 { part(0.7) * one } else { Rgb::new(0.9, 0.8, 0.7) * part(0.6) }),
            Some(Rgb::splat(part(0.2))),
        ]
    };
    for budget in [3, 8, 50] {
        Tree::new("a tree of rays, some with a share in one channel only", budget, channels).check(trace, budget)?;
    }
    let weak = |_: usize, _: &mut Stream| [Some(Rgb::splat(1e-3)), None];
    for budget in [5, 10] {
        Tree::new("a ray that causes one of share 0.001, which causes one of share 0.001, and so on", budget, weak)
            .check(trace, budget)?;
    }
    mirrors(trace)?;
    heap_of_glass(trace)?;
    let tree = Tree::new("a tree of rays, each causing two more", 20_000, two);
    let got = trying(|| format!("{}, with a budget of 20000", tree.words), || trace(&tree, tree.branch(0), 20_000));
    let followed = tree.followed.borrow().len();
    if followed != 20_000 || !got.is_finite() {
        let (tried, got) = (format!("{}, with a budget of 20000", tree.words), format!("{followed} rays followed"));
        let advice = "Is there a limit besides the budget?".into();
        return Err(Finding { tried, got, expected: "20000".into(), advice }.named("budget-not-used"));
    }
    Ok(())
}

/// A scene of that camera and nothing but the recursion.
fn whitted(scene: Scene<Material>, eye: Vec3, lookat: Vec3, limits: Limits) -> Option<Whitted> {
    let camera = Camera::new(eye, lookat, Vec3::Y, 40.0).ok()?;
    let (terms, fresnel, offset) = (Terms::ALL, Fresnel::Exact, Offset::Following);
    Some(Whitted { scene, camera, limits, terms, fresnel, offset })
}

/// Between two silver balls, a ray along their axis never escapes: with a budget of n, the same comes out as with the depth
/// n − 1.
fn mirrors(trace: Trace) -> Verdict {
    for budget in 1..12 {
        let mut scene = Scene::new();
        scene.surround(Rgb::new(0.5, 1.0, 2.0));
        for x in [-3.0, 3.0] {
            scene.add("mirror", Sphere::new(Vec3::X * x, 1.0), Material::SILVER);
        }
        let limits = Limits { max_depth: budget - 1, min_weight: 0.0 };
        let Some(world) = whitted(scene, Vec3::ZERO, Vec3::X, limits) else { return Ok(()) };
        let camera_ray = Branch::from_camera(Ray::new(Vec3::ZERO, Vec3::X));
        let tried = format!("a ray to and fro between two silver balls, with a budget of {budget}");
        let got = trying(|| tried.clone(), || trace(&world, camera_ray, budget));
        let right = world.trace_plain(&camera_ray, 0);
        if !words::is_near(got, right, 1e-4) {
            let (got, expected) =
                (words::color(got), format!("{}, as with a depth of {}", words::color(right), budget - 1));
            let advice = "One ray causes one more here, so that a budget of n is as good as a greatest depth of n − 1.";
            return Err(Finding { tried, got, expected, advice: advice.into() }.named("not-like-depth"));
        }
    }
    Ok(())
}

/// Budget of the comparison with depth-first search.
const EQUAL: u32 = 8;

/// Among glass balls, the greatest share first must be nearer to the truth than depth-first, for the same budget.
fn heap_of_glass(trace: Trace) -> Verdict {
    let mut scene = Scene::new();
    scene.surround(Rgb::new(0.3, 0.5, 0.9));
    scene.ambient = Rgb::ONE;
    let floor = Phong::of(Rgb::new(0.8, 0.2, 0.1), 0.0, 1.0);
    scene.add("floor", Sphere::new(Vec3::Y * -1001.0, 1000.0), Material::rough(floor));
    for (x, z) in [(-1.1, 0.0), (1.1, 0.0), (0.0, -1.8), (0.0, 1.8)] {
        scene.add("ball", Sphere::new(Vec3::new(x, 0.0, z), 1.0), Material::glass(1.5));
    }
    let limits = Limits { max_depth: 60, min_weight: 1e-5 };
    let Some(world) = whitted(scene, Vec3::new(0.0, 1.5, 8.0), Vec3::ZERO, limits) else { return Ok(()) };
    let mut errors = [0.0_f32; 2];
    let mut random = Stream::new(36, 0, 0);
    for _ in 0..400 {
        let target = Vec3::new(random.uniform() * 4.0 - 2.0, random.uniform() * 2.0 - 1.0, 0.0);
        let eye = world.camera.eye();
        let camera_ray = Branch::from_camera(Ray::new(eye, (target - eye).normalize()));
        let truth = world.trace(camera_ray, 0, &mut Listener(&mut common::story::Untold));
        let tried = || format!("glass balls on a floor, with a budget of {EQUAL}");
        let results = [trying(tried, || trace(&world, camera_ray, EQUAL)), depth_first(&world, camera_ray, EQUAL)];
        for (error, result) in errors.iter_mut().zip(results) {
            *error += (result - truth).abs().element_sum() / 3.0 / 400.0;
        }
    }
    let [yours, depth_first] = errors;
    // Written so that an error that is no number is wrong.
    let is_better = yours < depth_first;
    if is_better {
        return Ok(());
    }
    let told = |error: f32| format!("a mean error of {}", words::number(f64::from(error)));
    Err(Finding {
        tried: format!("400 camera rays at glass balls on a floor, each with a budget of {EQUAL}"),
        got: told(yours),
        expected: format!("less than {} of depth-first search", told(depth_first)),
        advice: "The greatest share first must be nearer to the truth than depth-first.".into(),
    }
    .named("not-better"))
}
