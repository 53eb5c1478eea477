//! Likely mistakes with a path and its points: what they are called, and what to say about them.

/// The name of a mistake, and what to say.
pub(super) type Mistake = (&'static str, &'static str);

pub(super) const MIDDLE_OF_THE_PIXEL: Mistake = (
    "middle-of-the-pixel",
    "The path goes through the middle of the pixel, whatever `points[0]` says. All samples of a pixel see the same there, and edges \
     are stairs.",
);
pub(super) const CORNER_OF_THE_PIXEL: Mistake = (
    "corner-of-the-pixel",
    "The path goes through the upper left corner of the pixel. Add `points[0]` to `pixel.position`.",
);
pub(super) const HALF_A_PIXEL_OFF: Mistake = (
    "half-a-pixel-off",
    "The path is half a pixel off. `pixel.position` is the corner of the pixel, not its middle: add `points[0]` as it is.",
);
pub(super) const PIXEL_BY_CHANCE: Mistake = (
    "pixel-by-chance",
    "Two streams bring two different radiances, though no direction was drawn. The place in the pixel is `points[0]`, not drawn.",
);
pub(super) const SWAPPED: Mistake = (
    "bounces-swapped",
    "`points[1]` is for the first bounce and `points[2]` for the second one: you have swapped them.",
);
pub(super) const ONE_LATE: Mistake = (
    "one-bounce-late",
    "The first bounce takes `points[0]`, which is the place in the pixel already. Two questions with one point are tied together, \
     and the picture is wrong on average. Does the count of the bounces begin one too low?",
);
pub(super) const FIRST_TWICE: Mistake = (
    "first-point-twice",
    "The second bounce takes the point of the first one. So the two directions are tied together, and the picture is wrong on \
     average. Is the bounce counted?",
);
pub(super) const UNIFORM: Mistake = (
    "uniform-directions",
    "Directions are uniform over the hemisphere. Here they are cosine-distributed: `DirectionSampling::CosineHemisphere`.",
);
pub(super) const COSINE_TWICE: Mistake = (
    "cosine-twice",
    "The cosine is in the density of the directions already. The weight is the albedo alone: `material.albedo()`.",
);
pub(super) const BY_CHANCE: Mistake = (
    "points-not-used",
    "Two streams bring two different radiances, though so short a path takes all of its points from `points`. Draw from `random` \
     from the third bounce on only, and let nothing end the path early.",
);
pub(super) const WRONG_PATH: Mistake = (
    "wrong-path",
    "The path does not go where its points say, or is weighed wrongly. Its first direction is \
     `DirectionSampling::CosineHemisphere.sample(hit.shading_normal, points[1]).direction`, and the weight of each step is \
     `material.albedo()`.",
);
pub(super) const REST_NOT_RANDOM: Mistake = (
    "rest-not-random",
    "The third bounce and all later ones should draw a point each, by `sample_unit_square(random)`. Yours take the same points \
     again, or none.",
);
pub(super) const REST_BIASED: Mistake = (
    "rest-wrong",
    "Up to the second bounce all is right. From the third one on each bounce draws a point of its own, by \
     `sample_unit_square(random)`, and is weighed as the others are.",
);
