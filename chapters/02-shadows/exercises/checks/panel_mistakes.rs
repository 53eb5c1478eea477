//! Mistakes with a shining panel that are known by what comes out.

use common::Vec3;
use glam::{DVec2, Vec2Swizzles as _};
use shadows::offset::Offset;

use super::panel::{RIGHT, Recipe, cell, parts};

/// A mistake that is known by what comes out: name, recipe, advice.
pub(crate) type Mistake = (&'static str, Recipe, &'static str);

/// Mistakes in places and in the mean.
pub(crate) const PLACES: [Mistake; 24] = [
    (
        "sum-not-mean",
        Recipe { mean: |sum, count, seen| (seen / count, sum), ..RIGHT },
        "This irradiance is a sum over the places. Divide it by their number n·n: each stands for a part of the area only.",
    ),
    (
        "sum-not-mean",
        Recipe { mean: |sum, _, seen| (seen, sum), ..RIGHT },
        "Both are sums over the places. Divide them by the number of places, n·n.",
    ),
    (
        "visible-is-a-count",
        Recipe { mean: |sum, count, seen| (seen, sum / count), ..RIGHT },
        "`visible` is the number of places here. It is a share, 0 to 1: divide by n·n.",
    ),
    (
        "divided-by-n",
        Recipe { mean: |sum, count, seen| (seen / count.sqrt(), sum / count.sqrt()), ..RIGHT },
        "Both are divided by n. There are n·n places: n columns and n rows.",
    ),
    (
        "divided-by-n",
        Recipe { mean: |sum, count, seen| (seen / count, sum / count.sqrt()), ..RIGHT },
        "The irradiance is divided by n. There are n·n places: n columns and n rows.",
    ),
    (
        "divided-by-n",
        Recipe { mean: |sum, count, seen| (seen / count.sqrt(), sum / count), ..RIGHT },
        "`visible` is divided by n. There are n·n places: n columns and n rows.",
    ),
    (
        "mean-of-the-seen",
        Recipe { mean: |sum, count, seen| (seen / count, sum / seen), ..RIGHT },
        "This is the mean over the places that are seen. The hidden ones count too, with 0: divide by n·n.",
    ),
    (
        "shadow-twice",
        Recipe { mean: |sum, count, seen| (seen / count, sum / count * (seen / count)), ..RIGHT },
        "Hidden places are left out of this irradiance already, and then it is multiplied by the visible share. Once will do.",
    ),
    (
        "center-only",
        Recipe { place: |_, _, _, _| DVec2::splat(0.5), ..RIGHT },
        "All places seem to lie in the middle of the panel. Each part of the panel has a place of its own.",
    ),
    (
        "jitter-ignored",
        Recipe { place: |column, row, n, _| (cell(column, row) + 0.5) / parts(n), ..RIGHT },
        "All places lie in the middle of their parts. Where in its part a place lies, its entry of `jitter` says.",
    ),
    (
        "jitter-ignored",
        Recipe { place: |column, row, n, _| cell(column, row) / parts(n), ..RIGHT },
        "All places lie in the corners of their parts. Where in its part a place lies, its entry of `jitter` says.",
    ),
    (
        "jitter-shared",
        Recipe { place: |column, row, n, jitter| (cell(column, row) + jitter[0].as_dvec2()) / parts(n), ..RIGHT },
        "All parts use the first entry of `jitter`. Each has one of its own: `jitter[r * n + c]`.",
    ),
    (
        "jitter-transposed",
        Recipe {
            place: |column, row, n, jitter| (cell(column, row) + jitter[column * n + row].as_dvec2()) / parts(n),
            ..RIGHT
        },
        "Rows and columns are mixed up: the part in column c and row r takes `jitter[r * n + c]`. The column goes along \
         `edges[0]`, the row along `edges[1]`.",
    ),
    (
        "jitter-not-divided",
        Recipe {
            place: |column, row, n, jitter| cell(column, row) / parts(n) + jitter[row * n + column].as_dvec2(),
            ..RIGHT
        },
        "The jitter moves a place within its part, and a part is 1/n of the panel wide: add first, then divide by n.",
    ),
    (
        "no-grid",
        Recipe { place: |column, row, n, jitter| jitter[row * n + column].as_dvec2(), ..RIGHT },
        "The places are spread over the whole panel by the jitter alone. Add the column and the row, and divide by n.",
    ),
    (
        "corner-forgotten",
        Recipe { at: |[_, first, second], share| first * share.x + second * share.y, ..RIGHT },
        "The places lie as if the panel began in the origin of space. A place is corner + u·edges[0] + v·edges[1].",
    ),
    (
        "edges-mixed",
        Recipe { at: |[corner, first, second], share| corner + first * share.y + second * share.x, ..RIGHT },
        "u and v are mixed up: u, of the column and jitter.x, goes along `edges[0]`, and v along `edges[1]`.",
    ),
    (
        "jitter-mixed",
        Recipe {
            place: |column, row, n, jitter| (cell(column, row) + jitter[row * n + column].as_dvec2().yx()) / parts(n),
            ..RIGHT
        },
        "jitter.x and jitter.y are mixed up: u = (column + jitter.x) / n, v = (row + jitter.y) / n.",
    ),
    (
        "wrong-part",
        Recipe {
            place: |column, row, n, jitter| {
                (cell(column, row) + jitter[row * n + column].as_dvec2()) / (parts(n) - 1.0).max(1.0)
            },
            ..RIGHT
        },
        "The places reach beyond the panel. Columns and rows are counted from 0 to n − 1, and u = (column + jitter.x) / n: divide \
         by n, not by n − 1.",
    ),
    (
        "wrong-part",
        Recipe { place: |column, row, n, _| cell(column, row) / (parts(n) - 1.0).max(1.0), ..RIGHT },
        "The places reach from edge to edge of the panel. Each lies within its part: u = (column + jitter.x) / n.",
    ),
    (
        "wrong-part",
        Recipe {
            place: |column, row, n, jitter| (cell(column, row) + 1.0 + jitter[row * n + column].as_dvec2()) / parts(n),
            ..RIGHT
        },
        "The places reach beyond the panel. Count columns and rows from 0, not from 1.",
    ),
    (
        "jitter-centered",
        Recipe {
            place: |column, row, n, jitter| (cell(column, row) + jitter[row * n + column].as_dvec2() - 0.5) / parts(n),
            ..RIGHT
        },
        "The places are half a part too low. The jitter goes from 0 to 1 and is added as it is: u = (column + jitter.x) / n.",
    ),
    (
        "jitter-centered",
        Recipe {
            place: |column, row, n, jitter| (cell(column, row) + jitter[row * n + column].as_dvec2() + 0.5) / parts(n),
            ..RIGHT
        },
        "The places are half a part too high. The jitter goes from 0 to 1 and is added as it is: u = (column + jitter.x) / n.",
    ),
    (
        "point-forgotten",
        Recipe { from: |_| Vec3::ZERO, ..RIGHT },
        "ω and the distance are measured from the origin of space. Measure them from the point that is lit: \
         place − `hit.position`.",
    ),
];

/// Mistakes in what one place gives.
pub(crate) const LIGHT: [Mistake; 8] = [
    (
        "no-inverse-square",
        Recipe { strength: |g| g.area * g.surface * g.panel, ..RIGHT },
        "The light of each place must fall with the square of its distance. If you divide by it: is `direction` a unit \
         vector in both dot products?",
    ),
    (
        "inverse-not-squared",
        Recipe { strength: |g| g.area * g.surface * g.panel / g.distance, ..RIGHT },
        "The light of each place must fall with the square of its distance, not with the distance.",
    ),
    (
        "surface-cosine-forgotten",
        Recipe { strength: |g| g.area * g.panel / (g.distance * g.distance), ..RIGHT },
        "The cosine at the surface is missing, N·ω. Irradiance is power per area of the surface, and slanting light is \
         spread over more of it.",
    ),
    (
        "panel-cosine-forgotten",
        Recipe { strength: |g| g.area * g.surface / (g.distance * g.distance), ..RIGHT },
        "The cosine at the panel is missing, M·−ω. Seen from the side a panel looks smaller, and gives less light.",
    ),
    (
        "area-forgotten",
        Recipe { strength: |g| g.surface * g.panel / (g.distance * g.distance), ..RIGHT },
        "The area of the panel is missing. It is the length of `edges[0] × edges[1]`: do not normalize that vector.",
    ),
    (
        "area-twice",
        Recipe { strength: |g| g.area * g.area * g.surface * g.panel / (g.distance * g.distance), ..RIGHT },
        "The area comes in twice. The length of `edges[0] × edges[1]` is the area already.",
    ),
    (
        "only-radiance",
        Recipe { strength: |_| 1.0, ..RIGHT },
        "Here every place gives the same. What it gives depends on its distance and on both cosines.",
    ),
    (
        "divided-by-pi",
        Recipe {
            strength: |g| g.area * g.surface * g.panel / (g.distance * g.distance) / std::f64::consts::PI,
            ..RIGHT
        },
        "A division by π too many. It belongs to the material, which has it already: here is asked what arrives.",
    ),
];

/// Mistakes in what hides what.
pub(crate) const SHADOWS: [Mistake; 6] = [
    (
        "reach-squared",
        Recipe { reach: |distance| distance * distance, ..RIGHT },
        "This shadow ray looks as far as the square of the distance. Is `distance` a distance, with the root taken, and is \
         `direction` a unit vector?",
    ),
    (
        "beyond-the-light",
        Recipe { reach: |_| f64::INFINITY, ..RIGHT },
        "Something behind the panel casts a shadow here. The shadow ray ends at the place on the panel: `distance`.",
    ),
    (
        "range-too-short",
        Recipe { reach: |_| 1.0, ..RIGHT },
        "This ray sees only what lies within 1 of its start. The direction has unit length, and the range ends at the \
         distance of the place.",
    ),
    (
        "no-shadow",
        Recipe { reach: |_| 0.0, ..RIGHT },
        "Nothing casts a shadow. Ask for each place whether the light from there arrives: `is_in_shadow`.",
    ),
    (
        "below-horizon",
        Recipe { arrives: |_, panel| panel > 0.0, ..RIGHT },
        "Places below the horizon of the surface, where N·ω is negative, give nothing.",
    ),
    (
        "one-shadow-ray",
        Recipe { aim: |_| DVec2::splat(0.5), ..RIGHT },
        "All places seem to share one shadow ray, to the middle of the panel. Each place needs its own: a penumbra is where some \
         places are seen and others are not.",
    ),
];

/// Mistakes that show only here and there.
pub(crate) const HIDDEN: [Mistake; 2] = [
    (
        "both-behind",
        Recipe { arrives: |surface, panel| surface * panel > 0.0, ..RIGHT },
        "Light arrives from places that lie below the horizon and turn their back to the point: both dot products are \
         negative, and their product is not. Ask for both signs by themselves.",
    ),
    (
        "lifted-start",
        Recipe { from: |hit| Offset::Following.origin(hit, hit.geometric_normal), ..RIGHT },
        "ω and the distance seem to be measured from the start of the shadow ray, which is lifted. Measure them from the point \
         that is lit, `hit.position`.",
    ),
];
