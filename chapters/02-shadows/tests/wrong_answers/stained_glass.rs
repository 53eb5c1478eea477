//! Wrong ways through stained glass.

use common::{Interval, Rgb, exercise::Verdict};
use ray_casting::{
    hit::{Hit, Side},
    light::Illumination,
    ray::Ray,
    scene::Scene,
};
use shadows::{offset::Offset, shadow_ray::is_in_shadow};

use crate::{checks::stained_glass::check, name};

fn diagnosis(answer: impl Fn(&Scene<Rgb>, &Hit, &Illumination) -> Rgb) -> &'static str {
    name(check(answer))
}

/// The shadow ray and its range.
fn shadow_ray(hit: &Hit, light: &Illumination) -> (Ray, Interval) {
    let origin = Offset::Following.origin(hit, hit.geometric_normal);
    (Ray::new(origin, light.direction), Interval::POSITIVE.up_to(light.distance))
}

/// The transmittances of all hits of all objects on a way, one object after the other.
fn all_on(scene: &Scene<Rgb>, (ray, range): (Ray, Interval)) -> Vec<Rgb> {
    let mut found = Vec::new();
    for object in &scene.objects {
        let mut range = range;
        while let Some(hit) = object.shape.intersect(&ray, range) {
            found.push(object.material);
            range.min = hit.t;
        }
    }
    found
}

/// One object after the other. `weight` says how much a hit counts, `next` which range comes behind it.
fn stepping(
    scene: &Scene<Rgb>,
    (ray, range): (Ray, Interval),
    weight: impl Fn(&Hit) -> f32,
    next: impl Fn(&Hit, Interval) -> Interval,
) -> Rgb {
    let mut arrives = Rgb::ONE;
    for object in &scene.objects {
        let mut range = range;
        while let Some(hit) = object.shape.intersect(&ray, range) {
            arrives *= Rgb::ONE.lerp(object.material, weight(&hit));
            range = next(&hit, range);
        }
    }
    arrives
}

fn product(all: impl IntoIterator<Item = Rgb>) -> Rgb {
    all.into_iter().fold(Rgb::ONE, |product, transmittance| product * transmittance)
}

/// The right answer to other questions.
fn right(scene: &Scene<Rgb>, hit: &Hit, light: &Illumination) -> Rgb {
    product(all_on(scene, shadow_ray(hit, light)))
}

/// From hit to hit through the whole scene. `next` gives the range behind a hit, and how many hits may be found.
fn hit_by_hit(scene: &Scene<Rgb>, (ray, mut range): (Ray, Interval), limit: usize, next: fn(&Hit) -> f32) -> Rgb {
    let mut arrives = Rgb::ONE;
    for _ in 0..limit {
        let Some((hit, object)) = scene.intersect(&ray, range) else { break };
        arrives *= object.material;
        range.min = next(&hit);
    }
    arrives
}

/// From hit to hit with a new ray each time, which starts some way behind the last hit.
fn restarted(scene: &Scene<Rgb>, hit: &Hit, light: &Illumination, start: fn(&Hit, &Ray) -> Ray) -> Rgb {
    let (mut ray, _) = shadow_ray(hit, light);
    let (mut left, mut arrives) = (light.distance, Rgb::ONE);
    while let Some((hit, object)) = scene.intersect(&ray, Interval::POSITIVE.up_to(left)) {
        arrives *= object.material;
        if arrives == Rgb::ZERO {
            break;
        }
        left -= hit.t;
        ray = start(&hit, &ray);
    }
    arrives
}

#[test]
fn the_right_one_is_accepted() {
    let verdict: Verdict = check(right);
    assert_eq!(verdict, Ok(()));
    // In the opposite order.
    let reversed = |scene: &Scene<Rgb>, hit: &Hit, light: &Illumination| {
        product(all_on(scene, shadow_ray(hit, light)).into_iter().rev())
    };
    assert_eq!(check(reversed), Ok(()));
}

#[test]
fn all_or_nothing_is_not_started() {
    let brick = |scene: &Scene<Rgb>, hit: &Hit, light: &Illumination| {
        if is_in_shadow(scene, hit, light, Offset::Following) { Rgb::ZERO } else { Rgb::ONE }
    };
    assert_eq!(diagnosis(brick), "not-started");
}

#[test]
fn constants() {
    assert_eq!(diagnosis(|_, _, _| Rgb::ZERO), "free-way");
    assert_eq!(diagnosis(|_, _, _| Rgb::ONE), "no-shadow");
    assert_eq!(diagnosis(|_, _, _| Rgb::NAN), "not-a-number");
}

#[test]
fn wrong_sums() {
    let of_all = |sum: fn(Vec<Rgb>) -> Rgb| {
        diagnosis(move |scene, hit, light| {
            let all = all_on(scene, shadow_ray(hit, light));
            if all.is_empty() { Rgb::ONE } else { sum(all) }
        })
    };
    assert_eq!(of_all(|all| all.into_iter().sum()), "sum-not-product");
    assert_eq!(of_all(|all| all.into_iter().fold(Rgb::ONE, |a, b| a + b)), "sum-not-product");
    assert_eq!(of_all(|all| all.iter().sum::<Rgb>() / all.len() as f32), "mean-not-product");
    assert_eq!(of_all(|all| all.into_iter().fold(Rgb::ONE, |a, b| (a + b) / 2.0)), "mean-not-product");
    assert_eq!(of_all(|all| (all.iter().sum::<Rgb>() + 1.0) / (all.len() + 1) as f32), "mean-not-product");
    assert_eq!(of_all(|all| Rgb::splat(product(all).element_sum() / 3.0)), "one-channel");
    assert_eq!(of_all(|all| product(all.into_iter().map(|t| Rgb::splat(t.element_sum() / 3.0)))), "one-channel");
    assert_eq!(of_all(|all| all.into_iter().reduce(Rgb::min).unwrap()), "darkest-only");
    assert_eq!(of_all(|all| product(all.into_iter().map(|t| Rgb::ONE - t))), "complement");
    assert_eq!(of_all(|all| Rgb::ONE - product(all)), "absorbed");
    assert_eq!(of_all(|all| product(all.into_iter().map(|t| t * t))), "counted-twice");
    assert_eq!(of_all(|all| Rgb::splat(product(all).x)), "one-channel");
    assert_eq!(of_all(|all| all[0]), "first-object");
    assert_eq!(of_all(|all| all[all.len() - 1]), "last-only");
    assert_eq!(of_all(|all| product(all.into_iter().filter(|t| *t != Rgb::ZERO))), "opaque-ignored");
    // Nearly nothing is not nothing.
    assert_eq!(of_all(|all| product(all.into_iter().map(|t| t.max(Rgb::splat(1e-6))))), "opaque-ignored");
    assert_eq!(
        of_all(|all| product(all.iter().zip(0..).map(|(t, i)| if i == 0 { *t } else { *t * 0.99 }))),
        "wrong-product"
    );
}

#[test]
fn wrong_ways() {
    let one = |limit| diagnosis(move |scene, hit, light| hit_by_hit(scene, shadow_ray(hit, light), limit, |hit| hit.t));
    assert_eq!(one(1), "nearest-only");
    assert_eq!([2, 3, 4, 5].map(one), ["upper-limit"; 4]);
    for limit in [8, 100] {
        // More than a few panes, or all of them but those in the same place.
        assert!(["object-once", "same-place", "upper-limit"].contains(&one(limit)), "{}", one(limit));
    }
    assert_eq!(one(usize::MAX), "same-place");
    let upper_limit = |scene: &Scene<Rgb>, hit: &Hit, light: &Illumination| {
        product(all_on(scene, shadow_ray(hit, light)).into_iter().take(100))
    };
    assert_eq!(diagnosis(upper_limit), "upper-limit");
    let object_once = |scene: &Scene<Rgb>, hit: &Hit, light: &Illumination| {
        let (ray, range) = shadow_ray(hit, light);
        product(scene.objects.iter().filter(|o| o.shape.occluded(&ray, range)).map(|o| o.material))
    };
    assert_eq!(diagnosis(object_once), "object-once");
    let many = |scene: &Scene<Rgb>, hit: &Hit, light: &Illumination| {
        product(all_on(scene, shadow_ray(hit, light)).into_iter().take(1000))
    };
    assert_eq!(diagnosis(many), "upper-limit");
    for least in [1.0 / 256.0, 1e-3, 1e-4] {
        let given_up = move |scene: &Scene<Rgb>, hit: &Hit, light: &Illumination| {
            let arrives = right(scene, hit, light);
            if arrives.max_element() < least { Rgb::ZERO } else { arrives }
        };
        assert_eq!(diagnosis(given_up), "given-up-early");
    }
    for side in [Side::Outside, Side::Inside] {
        let one_side = move |scene: &Scene<Rgb>, hit: &Hit, light: &Illumination| {
            stepping(
                scene,
                shadow_ray(hit, light),
                |hit| if hit.side == side { 1.0 } else { 0.0 },
                |hit, range| Interval { min: hit.t, ..range },
            )
        };
        assert_eq!(diagnosis(one_side), "one-side");
    }
    let strong = |scene: &Scene<Rgb>, hit: &Hit, light: &Illumination| right(scene, hit, light) * light.strength;
    assert_eq!(diagnosis(strong), "times-strength");
    // All hits of one object, but none at the same `t` as any before.
    let seen = |scene: &Scene<Rgb>, hit: &Hit, light: &Illumination| {
        let (ray, range) = shadow_ray(hit, light);
        let (mut seen, mut arrives) = (Vec::new(), Rgb::ONE);
        for object in &scene.objects {
            let mut range = range;
            while let Some(hit) = object.shape.intersect(&ray, range) {
                range.min = hit.t;
                if !seen.contains(&hit.t) {
                    seen.push(hit.t);
                    arrives *= object.material;
                }
            }
        }
        arrives
    };
    assert_eq!(diagnosis(seen), "same-place");
    let last = |scene: &Scene<Rgb>, hit: &Hit, light: &Illumination| {
        let (ray, mut range) = shadow_ray(hit, light);
        let mut arrives = Rgb::ONE;
        while let Some((hit, object)) = scene.intersect(&ray, range) {
            arrives = object.material;
            range.min = hit.t;
        }
        arrives
    };
    assert_eq!(diagnosis(last), "last-only");
}

#[test]
fn wrong_ranges() {
    let ranged = |range: fn(&Illumination) -> Interval| {
        diagnosis(move |scene, hit, light| {
            let (ray, _) = shadow_ray(hit, light);
            product(all_on(scene, (ray, range(light))))
        })
    };
    assert_eq!(ranged(|_| Interval::POSITIVE), "beyond-the-light");
    // The floor itself lies behind the point.
    assert_eq!(ranged(|light| Interval::new(-1e9, light.distance)), "free-way");
    assert_eq!(ranged(|light| Interval::new(0.0, light.distance - 0.2)), "before-the-light");
    assert_eq!(ranged(|light| Interval::new(0.0, light.distance.min(100.0))), "infinite-distance");
    assert_eq!(ranged(|light| Interval::new(1e-3, light.distance)), "start-too-high");
    let end_lost = |scene: &Scene<Rgb>, hit: &Hit, light: &Illumination| {
        stepping(scene, shadow_ray(hit, light), |_| 1.0, |hit, _| Interval::new(hit.t, f32::INFINITY))
    };
    assert_eq!(diagnosis(end_lost), "end-lost");
    // With a light in the point itself, 0·NaN.
    let not_ended = |scene: &Scene<Rgb>, hit: &Hit, light: &Illumination| {
        right(scene, hit, light) * (light.direction.length() / light.direction.length())
    };
    assert_eq!(diagnosis(not_ended), "light-in-the-point");
}

#[test]
fn loops_without_end() {
    // The range stays where it is.
    let stays = |scene: &Scene<Rgb>, hit: &Hit, light: &Illumination| {
        let way = shadow_ray(hit, light);
        hit_by_hit(scene, way, usize::MAX, |_| 0.0)
    };
    assert_eq!(diagnosis(stays), "endless");
    // Only clear glass has no end, and no answer is shown that was never given.
    let clear = |scene: &Scene<Rgb>, hit: &Hit, light: &Illumination| {
        stepping(
            scene,
            shadow_ray(hit, light),
            |_| 1.0,
            |hit, range| {
                let is_clear = scene.objects.iter().all(|o| o.material == Rgb::ONE || o.material == Rgb::ZERO);
                if is_clear { range } else { Interval { min: hit.t, ..range } }
            },
        )
    };
    let message = check(clear).unwrap_err();
    assert_eq!(message.name, "endless");
    assert!(message.to_string().contains("Got:      no end"), "{message}");
    // The new ray starts before the pane.
    let before = |scene: &Scene<Rgb>, hit: &Hit, light: &Illumination| {
        restarted(scene, hit, light, |hit, ray| {
            Ray::new(Offset::Following.origin(hit, hit.geometric_normal), ray.direction)
        })
    };
    assert!(["endless", "counted-twice", "wrong-product"].contains(&diagnosis(before)), "{}", diagnosis(before));
}

#[test]
fn new_rays() {
    let with = |start: fn(&Hit, &Ray) -> Ray| diagnosis(move |scene, hit, light| restarted(scene, hit, light, start));
    // What stands closer than the offset is lost, and so is what stands in the same place.
    let behind: fn(&Hit, &Ray) -> Ray =
        |hit, ray| Ray::new(Offset::Following.origin(hit, -hit.geometric_normal), ray.direction);
    assert_eq!(with(behind), "same-place");
    assert_eq!(with(|hit, ray| Ray::new(hit.position + ray.direction * 1e-3, ray.direction)), "same-place");
    // One object after the other, but with a step.
    let stepped = |step: fn(f32) -> f32| {
        check(move |scene: &Scene<Rgb>, hit: &Hit, light: &Illumination| {
            stepping(scene, shadow_ray(hit, light), |_| 1.0, |hit, range| Interval { min: step(hit.t), ..range })
        })
    };
    assert_eq!(name(stepped(|t| t + 1e-3)), "fixed-distance");
    assert_eq!(name(stepped(|t| t + 1e-5)), "fixed-distance");
    assert_eq!(name(stepped(|t| t * (1.0 + 1e-6))), "fixed-distance");
    assert_eq!(stepped(|t| t), Ok(()));
}

#[test]
fn wrong_offsets() {
    let from = |origin: fn(&Hit) -> common::Vec3| {
        diagnosis(move |scene, hit, light| {
            let (ray, range) = shadow_ray(hit, light);
            product(all_on(scene, (Ray::new(origin(hit), ray.direction), range)))
        })
    };
    assert_eq!(from(|hit| hit.position), "self-shadow");
    assert_eq!(from(|hit| Offset::Fixed(1e-5).origin(hit, hit.geometric_normal)), "fixed-offset");
    assert_eq!(from(|hit| Offset::Fixed(1e-3).origin(hit, hit.geometric_normal)), "start-too-high");
    assert_eq!(from(|hit| Offset::Following.origin(hit, hit.shading_normal)), "shading-normal");
    assert_eq!(from(|hit| hit.position - hit.geometric_normal * 1e-3), "free-way");
}
