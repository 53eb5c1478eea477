//! How much light comes through panes, right or with a mistake that is known by what comes out, in f64.

use glam::DVec3;

/// One pane between the hit and anywhere.
#[derive(Clone, Copy)]
pub(crate) struct Crossing {
    pub(crate) t: f64,
    pub(crate) transmittance: DVec3,
    pub(crate) object: usize,
    /// Whether the light's side is the inside.
    pub(crate) is_turned: bool,
}

/// What comes out of crossings and the light's distance.
pub(crate) type Recipe = fn(&[Crossing], f64) -> DVec3;

fn product<'a>(crossings: impl IntoIterator<Item = &'a Crossing>) -> DVec3 {
    crossings.into_iter().fold(DVec3::ONE, |product, crossing| product * crossing.transmittance)
}

/// Those between the hit and the light.
fn between(crossings: &[Crossing], distance: f64) -> impl Iterator<Item = &Crossing> {
    crossings.iter().filter(move |c| c.t > 0.0 && c.t < distance)
}

/// Only the nearest few.
fn nearest(crossings: &[Crossing], distance: f64, count: usize) -> DVec3 {
    let mut all: Vec<_> = between(crossings, distance).collect();
    all.sort_by(|a, b| a.t.total_cmp(&b.t));
    product(all.into_iter().take(count))
}

pub(crate) fn right(crossings: &[Crossing], distance: f64) -> DVec3 {
    product(between(crossings, distance))
}

/// A mistake that is known by what comes out: name, recipe, advice.
pub(crate) type Mistake = (&'static str, Recipe, &'static str);

const FEW: &str = "Only the nearest few panes count here. Go on until nothing is hit any more.";

pub(crate) const MISTAKES: [Mistake; 26] = [
    (
        "no-shadow",
        |_, _| DVec3::ONE,
        "All the light arrives. Nothing is multiplied by the transmittance of what is in the way.",
    ),
    (
        "counted-twice",
        |all, distance| right(all, distance) * right(all, distance),
        "Every pane counts twice here. If you start new rays: does the next one hit the same pane again? If you move the \
         beginning of the range: is a hit multiplied both before the loop and in it?",
    ),
    (
        "nearest-only",
        |all, distance| {
            between(all, distance).min_by(|a, b| a.t.total_cmp(&b.t)).map_or(DVec3::ONE, |c| c.transmittance)
        },
        "Only the nearest pane counts here. Go on behind it, until nothing is hit any more.",
    ),
    (
        "last-only",
        |all, distance| {
            between(all, distance).max_by(|a, b| a.t.total_cmp(&b.t)).map_or(DVec3::ONE, |c| c.transmittance)
        },
        "Only the farthest pane counts here. Multiply by each transmittance, `*=`, instead of putting it in the place of the \
         last.",
    ),
    (
        "first-object",
        |all, distance| between(all, distance).next().map_or(DVec3::ONE, |c| c.transmittance),
        "Only one object of the scene counts here. Go on with the next one.",
    ),
    (
        "object-once",
        |all, distance| {
            let is_first = |c: &&Crossing| !between(all, distance).any(|o| o.object == c.object && o.t < c.t);
            product(between(all, distance).filter(is_first))
        },
        "An object that is hit several times counts only once here. Ask it again, with a range that begins at the last hit.",
    ),
    (
        "sum-not-product",
        |all, distance| between(all, distance).map(|c| c.transmittance).sum(),
        "The transmittances are added up. Of what one pane leaves over the next one passes its share: multiply.",
    ),
    (
        "sum-not-product",
        |all, distance| between(all, distance).fold(DVec3::ONE, |sum, c| sum + c.transmittance),
        "The transmittances are added to 1. Of what one pane leaves over the next one passes its share: multiply, `*=`.",
    ),
    (
        "mean-not-product",
        |all, distance| between(all, distance).fold(DVec3::ONE, |mean, c| (mean + c.transmittance) / 2.0),
        "Each pane is averaged with what came before. Of what one pane leaves over the next one passes its share: multiply, `*=`.",
    ),
    (
        "mean-not-product",
        |all, distance| {
            let sum = between(all, distance).fold(DVec3::ONE, |sum, c| sum + c.transmittance);
            sum / between(all, distance).fold(1.0, |count, _| count + 1.0)
        },
        "This is the mean of 1 and the transmittances. Of what one pane leaves over the next one passes its share: multiply, `*=`.",
    ),
    (
        "mean-not-product",
        |all, distance| {
            let sum: DVec3 = between(all, distance).map(|c| c.transmittance).sum();
            sum / between(all, distance).fold(0.0, |count, _| count + 1.0)
        },
        "This is the mean of the transmittances. Of what one pane leaves over the next one passes its share: multiply.",
    ),
    (
        "darkest-only",
        |all, distance| between(all, distance).fold(DVec3::ONE, |least, c| least.min(c.transmittance)),
        "This is the least transmittance of all. Of what one pane leaves over the next one passes its share: multiply.",
    ),
    (
        "complement",
        |all, distance| between(all, distance).fold(DVec3::ONE, |product, c| product * (DVec3::ONE - c.transmittance)),
        "This multiplies by 1 minus the transmittance, which is the share that stays in the glass. What passes is asked for.",
    ),
    (
        "absorbed",
        |all, distance| DVec3::ONE - right(all, distance),
        "This is the share that stays in the glass. What passes is asked for.",
    ),
    (
        "beyond-the-light",
        |all, _| right(all, f64::INFINITY),
        "Something beyond the light counts here. The range ends at the light's distance.",
    ),
    (
        "behind-the-point",
        |all, distance| product(all.iter().filter(|c| c.t < distance)),
        "Something behind the point counts here. Only what the ray meets at `t > 0` is in between.",
    ),
    (
        "one-channel",
        |all, distance| DVec3::splat(right(all, distance).x),
        "All three channels are the same here. Multiply whole colors, `Rgb` by `Rgb`: that goes channel by channel.",
    ),
    (
        "one-channel",
        |all, distance| DVec3::splat(right(all, distance).element_sum() / 3.0),
        "This is the mean of the three channels. Multiply whole colors, `Rgb` by `Rgb`: that goes channel by channel.",
    ),
    (
        "one-channel",
        |all, distance| {
            let grays = between(all, distance).map(|c| c.transmittance.element_sum() / 3.0);
            DVec3::splat(grays.product())
        },
        "Each pane counts as gray, with the mean of its channels. Multiply whole colors, `Rgb` by `Rgb`: that goes channel by \
         channel.",
    ),
    ("upper-limit", |all, distance| nearest(all, distance, 2), FEW),
    ("upper-limit", |all, distance| nearest(all, distance, 3), FEW),
    ("upper-limit", |all, distance| nearest(all, distance, 4), FEW),
    ("upper-limit", |all, distance| nearest(all, distance, 5), FEW),
    (
        "one-side",
        |all, distance| product(between(all, distance).filter(|c| c.is_turned)),
        "Only surfaces that the ray meets from outside count here. Glass colors the light on its way in and on its way out: do not \
         ask for `side`.",
    ),
    (
        "one-side",
        |all, distance| product(between(all, distance).filter(|c| !c.is_turned)),
        "Only surfaces that the ray meets from inside count here. Glass colors the light on its way in and on its way out: do not \
         ask for `side`.",
    ),
    (
        "end-lost",
        |all, distance| {
            let reaches = |c: &&Crossing| between(all, distance).any(|other| other.object == c.object);
            product(all.iter().filter(|c| c.t > 0.0).filter(reaches))
        },
        "Behind a hit the range goes on beyond the light here. Change only its beginning, `range.min = hit.t`: its end stays at the \
         light's distance.",
    ),
];
