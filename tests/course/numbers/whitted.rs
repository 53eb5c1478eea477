//! The numbers of chapter 3.

#![expect(clippy::disallowed_methods, reason = "f64 has digits to spare: its last bits do not matter here")]

use common::{
    Rgb, Vec2,
    picture::{FilmPoint, Settings},
};
use ray_casting::hit::Side;
use shadows::offset::Offset;
use whitted::{
    branches::Branch,
    fresnel::{approximate, at_normal_incidence},
    material::{Fresnel, Material},
    pictures::{glass, treasure},
    whitted::{Limits, Terms, Whitted},
};

use super::Numbers;
use crate::{
    fresnel::{clear, metal},
    recursion::Counter,
};

/// Cosines from 1 down to 0: angles in steps of a fiftieth of a degree.
fn cosines() -> impl Iterator<Item = f64> {
    (0..=4500_u16).map(|i| (f64::from(i) / 50.0).to_radians().cos())
}

/// The greatest difference of two reflectances over all angles.
fn greatest(difference: impl Fn(f64) -> f64) -> String {
    format!("{:.3}", cosines().map(|cosine| difference(cosine).abs()).fold(0.0, f64::max))
}

/// The greatest error of the approximation for a metal, over angles and colors.
fn error_for(material: &Material) -> String {
    greatest(|cosine| {
        let approximated = material.reflectance(cosine as f32, Side::Outside, Fresnel::Approximate);
        let error = |c: usize| {
            let exact = metal(cosine, material.index[c].into(), material.extinction[c].into());
            (f64::from(approximated[c]) - exact).abs()
        };
        error(0).max(error(1)).max(error(2))
    })
}

/// The points of a film of `width` × `height` pixels.
fn film(width: u16, height: u16) -> impl Iterator<Item = FilmPoint> {
    let size = Vec2::new(width.into(), height.into());
    let at = move |i: u16| Vec2::new(f32::from(i % width) + 0.5, f32::from(i / width) + 0.5);
    (0..width * height).map(move |i| FilmPoint { position: at(i), size })
}

/// All points of a small film, and what it took.
fn rendered(picture: &Whitted, film: impl Iterator<Item = FilmPoint>) -> (Vec<Rgb>, Counter) {
    let mut counter = Counter::default();
    let ray = |point| Branch::from_camera(picture.camera.ray(point));
    (film.map(|point| picture.trace(ray(point), 0, &mut counter)).collect(), counter)
}

fn mean(picture: &Whitted, film: impl Iterator<Item = FilmPoint>) -> String {
    let (colors, counter) = rendered(picture, film);
    format!("{:.2}", f64::from(counter.rays) / colors.len() as f64)
}

/// The cover, at some depth.
fn cover(max_depth: u32) -> Whitted {
    Whitted {
        scene: treasure::scene(),
        camera: treasure::view(&Settings::default()).unwrap(),
        limits: Limits { max_depth, ..Limits::DEFAULT },
        terms: Terms::ALL,
        fresnel: Fresnel::Exact,
        offset: Offset::Following,
    }
}

/// The mean absolute difference of two renderings, divided by the mean of the second.
fn relative_error(found: &[Rgb], right: &[Rgb]) -> f64 {
    let sum = |colors: &mut dyn Iterator<Item = Rgb>| -> f64 { colors.map(|c| f64::from(c.element_sum())).sum() };
    let differences = sum(&mut found.iter().zip(right).map(|(a, b)| (*a - *b).abs()));
    differences / sum(&mut right.iter().copied())
}

pub(super) fn measured() -> String {
    let mut numbers = Numbers::titled("Numbers in the text of chapter 3, made by tests/course/numbers/whitted.rs.");

    numbers.about("Greatest error of the approximation over all angles: from air to glass of index 1.5; from glass to air, if the");
    numbers
        .0
        .push_str("# angle in the glass is taken; the same with the angle in the air; for metals, over all colors.\n");
    let glass = Material::glass(1.5);
    let f0 = at_normal_incidence(1.5, 0.0);
    let by_material = |cosine: f64, side| f64::from(glass.reflectance(cosine as f32, side, Fresnel::Approximate).x);
    numbers.pin("schlick-outside", greatest(|c| by_material(c, Side::Outside) - clear(c, 1.5)));
    numbers.pin("schlick-inside-naive", greatest(|c| f64::from(approximate(c as f32, f0)) - clear(c, 1.0 / 1.5)));
    numbers.pin("schlick-inside", greatest(|c| by_material(c, Side::Inside) - clear(c, 1.0 / 1.5)));
    for (name, metal) in [("gold", Material::GOLD), ("silver", Material::SILVER), ("copper", Material::COPPER)] {
        numbers.pin(&format!("schlick-{name}"), error_for(&metal));
    }

    numbers.about("Angles: beyond the critical one everything is reflected from inside; at Brewster's angle, of light that swings in");
    numbers.0.push_str("# the plane of the ray and the normal, nothing.\n");
    for (name, n) in [("glass", 1.5_f64), ("water", 1.333)] {
        numbers.pin(&format!("critical-{name}"), format!("{:.1}°", (1.0 / n).asin().to_degrees()));
    }
    numbers.pin("brewster-glass", format!("{:.1}°", 1.5_f64.atan().to_degrees()));

    numbers.about("What gold reflects along the normal, of red, green and blue light.");
    let [r, g, b] = Material::GOLD.reflectance(1.0, Side::Outside, Fresnel::Exact).to_array();
    numbers.pin("gold-f0", format!("{r:.3}, {g:.3}, {b:.3}"));

    numbers.about("The cover: mean number of rays for each camera ray, itself among them, without shadow rays, at each greatest depth.");
    for depth in 0..=8 {
        numbers.pin(&format!("rays-depth-{depth}"), mean(&cover(depth), film(320, 180)));
    }
    numbers.about("The cover: mean difference to depth 20 in each channel, as a share of the mean radiance.");
    let (right, counter) = rendered(&cover(20), film(320, 180));
    for depth in 0..=7 {
        let error = relative_error(&rendered(&cover(depth), film(320, 180)).0, &right);
        numbers.pin(&format!("error-depth-{depth}"), format!("{:.2} %", 100.0 * error));
    }
    numbers.about("The cover at depth 20: how deep the recursion goes into weaker branches.");
    numbers.pin("deepest-nesting", counter.deepest);

    numbers.about("A ball of glass, the first panel of the picture `glass`: mean number of rays for each camera ray at depth 20, with the");
    numbers
        .0
        .push_str("# plain recursion, which follows each ray however weak it is, and with the limit of the weight.\n");
    let mut ball = glass::panel(&Settings::default(), glass::solid).unwrap();
    let panel = || film(160, 170);
    ball.limits = Limits { max_depth: 20, min_weight: 0.0 };
    numbers.pin("plain-rays-20", mean(&ball, panel()));
    ball.limits.min_weight = Limits::DEFAULT.min_weight;
    numbers.pin("trace-rays-20", mean(&ball, panel()));
    numbers.0
}
