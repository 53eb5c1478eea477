//! Fresnel's equations, exact and approximated, against an independent table and in f64, and the shares of the branches.

#![expect(clippy::disallowed_methods, reason = "f64 has digits to spare: its last bits do not matter here")]

use common::{Interval, Rgb, Stream};
use ray_casting::{hit::Side, shape::Shape, sphere::Sphere};
use shadows::offset::Offset;
use whitted::{
    branches::branches,
    fresnel::{approximate, at_normal_incidence, exact},
    material::{Fresnel, Material},
    probe::Kind,
    refraction::refract,
};

use crate::{
    exact::EPSILON,
    optics::rows,
    rays::{aimed, between, direction, in_cube, magnitude, one_of},
};

/// How many roundings of 1 a reflectance may add up.
const ROUNDINGS: f64 = 4.0;

/// Fresnel's equations for a clear medium in f64, as amplitudes: another form than the course's, without complex numbers.
pub(crate) fn clear(cosine: f64, n: f64) -> f64 {
    let behind2 = 1.0 - (1.0 - cosine * cosine) / (n * n);
    if behind2 <= 0.0 {
        return 1.0;
    }
    let behind = behind2.sqrt();
    let across = (cosine - n * behind) / (cosine + n * behind);
    let along = (n * cosine - behind) / (n * cosine + behind);
    (across * across + along * along) / 2.0
}

/// The same for a metal, by squares: R∥ and R⊥ with a² + b² and 2a of the complex root.
pub(crate) fn metal(cosine: f64, n: f64, kappa: f64) -> f64 {
    let (c2, s2) = (cosine * cosine, 1.0 - cosine * cosine);
    let t = n * n - kappa * kappa - s2;
    let modulus = (t * t + 4.0 * n * n * kappa * kappa).sqrt();
    let twice = (2.0 * (modulus + t)).max(0.0).sqrt() * cosine;
    let across = (modulus + c2 - twice) / (modulus + c2 + twice);
    let along = across * (c2 * modulus + s2 * s2 - twice * s2) / (c2 * modulus + s2 * s2 + twice * s2);
    (across + along) / 2.0
}

/// The names of the course's metals in the table.
const METALS: [(&str, Material); 3] =
    [("gold", Material::GOLD), ("silver", Material::SILVER), ("copper", Material::COPPER)];

#[test]
fn reflectance_is_what_the_table_says() {
    let (mut metals, mut total) = (0, 0);
    for row in rows("reflectance", 105) {
        let [_, n, kappa, cosine, expected, approximated] = row.numbers[..] else { panic!("{}", row.name) };
        let [n32, kappa32, cosine32] = [n, kappa, cosine].map(|x| x as f32);
        let close = |found: f32, expected: f64| (f64::from(found) - expected).abs() <= ROUNDINGS * EPSILON;
        let found = exact(cosine32, n32, kappa32);
        assert!(close(found, expected), "{}: {found}, not {expected}", row.name);
        let found = approximate(cosine32, at_normal_incidence(n32, kappa32));
        assert!(close(found, approximated), "{}: {found}, not {approximated}", row.name);
        // The formulas in f64 that judge at all other angles agree with the table too.
        let judge = if kappa == 0.0 { clear(cosine, n) } else { metal(cosine, n, kappa) };
        assert!((judge - expected).abs() < 1e-14, "{}: {judge}, not {expected}", row.name);
        metals += u32::from(kappa > 0.0);
        total += u32::from(kappa == 0.0 && expected == 1.0);
    }
    assert_eq!((metals, total), (65, 6));
}

#[test]
fn reflectance_along_the_normal_is_what_the_table_says() {
    for row in rows("normal-incidence", 21) {
        let [channel, n, kappa, expected] = row.numbers[..] else { panic!("{}", row.name) };
        let [n, kappa] = [n, kappa].map(|x| x as f32);
        for found in
            [at_normal_incidence(n, kappa), exact(1.0, n, kappa), approximate(1.0, at_normal_incidence(n, kappa))]
        {
            assert!((f64::from(found) - expected).abs() <= EPSILON, "{}: {found}, not {expected}", row.name);
        }
        // The metals of the course have these very numbers.
        if let Some((_, metal)) = METALS.iter().find(|(name, _)| *name == row.name) {
            let channel = channel as usize;
            assert_eq!((metal.index[channel], metal.extinction[channel]), (n, kappa), "{}", row.name);
        }
    }
}

#[test]
fn critical_and_brewster_angles_are_what_the_table_says() {
    for row in rows("angles", 5) {
        let [n, critical, brewster] = row.numbers[..] else { panic!("{}", row.name) };
        // Within a hundredth of a degree of the critical angle from inside, light still gets out or does not.
        let outward = 1.0 / n as f32;
        let is_total = |degrees: f64| {
            let (sine, cosine) = degrees.to_radians().sin_cos();
            let leaving = common::Vec3::new(sine as f32, -cosine as f32, 0.0);
            let none = refract(leaving, common::Vec3::Y, outward).is_none();
            let all = exact(cosine as f32, outward, 0.0) >= 1.0 - 4.0 * f32::EPSILON;
            assert_eq!(none, all, "{} at {degrees}°", row.name);
            none
        };
        assert!(!is_total(critical - 0.01) && is_total(critical + 0.01), "{}", row.name);
        // At Brewster's angle only light that swings along the surface comes back: ½ ((n² − 1) / (n² + 1))².
        let found = f64::from(exact(brewster.to_radians().cos() as f32, n as f32, 0.0));
        let across = (n * n - 1.0) / (n * n + 1.0);
        assert!((found - across * across / 2.0).abs() <= ROUNDINGS * EPSILON, "{}: {found}", row.name);
    }
}

/// Between the rows of the table: any angle, any index.
#[test]
fn reflectance_is_right_for_all_indices_and_angles() {
    let (mut random, mut total) = (Stream::new(801, 0, 0), 0);
    for i in 0..200_000 {
        let n = magnitude(&mut random, 0.1, 10.0);
        let kappa = if i % 2 == 0 { 0.0 } else { magnitude(&mut random, 0.01, 10.0) };
        let cosine = if i % 3 == 0 { magnitude(&mut random, 1e-4, 1.0) } else { random.uniform() };
        let [c, m, k] = [cosine, n, kappa].map(f64::from);
        let expected = if i % 2 == 0 { clear(c, m) } else { metal(c, m, k) };
        // Near the critical angle the root has an endless slope: half of the digits remain there.
        let edge = (m * m - k * k - (1.0 - c * c)).hypot(2.0 * m * k);
        let sensitivity = 1.0 + 1.0 / edge.sqrt().max(EPSILON.sqrt());
        let error = (f64::from(exact(cosine, n, kappa)) - expected).abs();
        assert!(error < 2.0 * ROUNDINGS * EPSILON * sensitivity, "cos {c} n {m} kappa {k}: {error} {sensitivity}");
        total += u32::from(expected == 1.0);
    }
    assert!(total > 10_000, "{total}");
    // Light that grazes the surface comes back whole, whatever it is.
    assert_eq!([exact(0.0, 1.5, 0.0), exact(0.0, 0.2, 3.0), approximate(0.0, 0.04)], [1.0; 3]);
}

/// There and back through a border: the same share is reflected from both sides, by both formulas.
#[test]
fn both_sides_reflect_the_same_share() {
    let mut random = Stream::new(802, 0, 0);
    for _ in 0..100_000 {
        let material = Material::glass(between(&mut random, 1.05, 3.0));
        let n = material.index.x;
        let cosine = between(&mut random, 0.02, 1.0);
        let behind = (1.0 - (1.0 - cosine * cosine) / (n * n)).sqrt();
        for fresnel in [Fresnel::Exact, Fresnel::Approximate] {
            let there = material.reflectance(cosine, Side::Outside, fresnel);
            let back = material.reflectance(behind, Side::Inside, fresnel);
            // A rounding of the cosine inside becomes n² times as large outside, divided by the cosine there.
            let slack = 8.0 * f32::EPSILON * (1.0 + n * n / cosine);
            assert!((there - back).abs().max_element() < slack, "{there} {back}: cos {cosine}, n {n}");
        }
    }
}

/// Reflected and refracted share add up to one, from both sides, at total reflection too.
#[test]
fn no_light_is_lost_or_made_in_clear_media() {
    let mut random = Stream::new(803, 0, 0);
    let [mut outside, mut inside, mut total, mut straight] = [0; 4];
    while outside + inside < 100_000 {
        let index = [1.0, magnitude(&mut random, 0.3, 3.0)][usize::from(one_of(&mut random, 20) > 0)];
        let (material, sphere) = (Material::glass(index), Sphere::new(in_cube(&mut random), 1.0));
        let origin = if one_of(&mut random, 2) == 0 { 3.0 } else { 0.95 };
        let ray = aimed(sphere.center + direction(&mut random) * origin, sphere.center + in_cube(&mut random));
        let Some(hit) = sphere.intersect(&ray, Interval::POSITIVE) else { continue };
        let fresnel = [Fresnel::Exact, Fresnel::Approximate][one_of(&mut random, 2)];
        let [reflected, refracted] = branches(&ray, &hit, &material, fresnel, Offset::Following);
        let shares = [reflected, refracted].into_iter().flatten().map(|branch| branch.share);
        assert!(shares.clone().all(|share| share.min_element() >= 0.0), "{ray:?} {material:?}");
        // The subtraction 1 − F is exact or rounded once.
        let sum = shares.sum::<Rgb>();
        assert!((sum - Rgb::ONE).abs().max_element() <= f32::EPSILON / 2.0, "{ray:?} {material:?}: {sum}");
        match (reflected, refracted) {
            (Some(reflected), None) => {
                assert_eq!((reflected.kind, reflected.share), (Kind::Reflected, Rgb::ONE));
                total += 1;
            }
            (None, Some(refracted)) => {
                assert_eq!((refracted.kind, refracted.ray, index), (Kind::Refracted, ray, 1.0));
                straight += 1;
            }
            _ => assert!(reflected.is_some() && refracted.is_some()),
        }
        *if hit.side == Side::Outside { &mut outside } else { &mut inside } += 1;
    }
    assert!(
        outside > 30_000 && inside > 30_000 && total > 5_000 && straight > 1_000,
        "{outside} {inside} {total} {straight}"
    );
}

/// Metals and coated things let nothing through; what they do not reflect is gone. Rough things send nothing on.
#[test]
fn only_smooth_things_send_rays_on() {
    let mut random = Stream::new(804, 0, 0);
    let phong = ray_casting::material::Phong::of(Rgb::splat(0.5), 0.0, 1.0);
    let sphere = Sphere::new(common::Vec3::ZERO, 1.0);
    for i in 0..10_000 {
        let eye = direction(&mut random) * [3.0, 0.9][i % 2];
        let Some(hit) = sphere.intersect(&aimed(eye, in_cube(&mut random)), Interval::POSITIVE) else { continue };
        let ray = aimed(eye, hit.position);
        let of = |material| branches(&ray, &hit, &material, Fresnel::Exact, Offset::Following);
        assert_eq!(of(Material::rough(phong)), [None, None]);
        for material in [Material::GOLD, Material::SILVER, Material::COPPER, Material::coated(phong, 1.5)] {
            let [Some(reflected), None] = of(material) else { panic!("{material:?}") };
            // Both sides of a metal are the same.
            let cosine = -f64::from(ray.direction.dot(hit.shading_normal));
            for c in 0..3 {
                let [n, kappa] = [material.index[c], material.extinction[c]].map(f64::from);
                let expected = metal(cosine, n, kappa);
                assert!(
                    (f64::from(reflected.share[c]) - expected).abs() < 2.0 * ROUNDINGS * EPSILON,
                    "{material:?} {c}"
                );
            }
        }
    }
}
