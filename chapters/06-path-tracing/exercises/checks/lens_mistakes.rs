//! Likely mistakes with the rays of a lens: what they are called, and what to say about them.

/// The name of a mistake, and what to say.
pub(super) type Mistake = (&'static str, &'static str);

pub(super) const NOT_A_NUMBER: Mistake =
    ("not-a-number", "Something was divided by zero, or a vector of length zero was normalized.");

pub(super) const ACROSS_THE_RAY: Mistake = (
    "lens-across-the-ray",
    "Your lens is at right angles to the ray of the pixel, so that each pixel has another lens. There is one lens, at right \
     angles to the view: it is spanned by `right` and `up`.",
);
pub(super) const ALONG_THE_AXES: Mistake = (
    "lens-along-the-axes",
    "Your lens is spanned by axes of the world. It must turn with the camera: it is spanned by `right` and `up`.",
);
pub(super) const LEANS: Mistake = (
    "lens-leans",
    "All points of the lens have the depth 0. It is spanned by `right` and `up`, and has its middle in the eye.",
);

pub(super) const NOT_USED: Mistake =
    ("lens-not-used", "All rays start in the eye: this is a pinhole still. Move the origin over the lens.");
pub(super) const ONE_QUARTER: Mistake = (
    "one-quarter",
    "All rays start to the right of the eye and above it. A point of the unit square has no negative numbers. A point of the \
     disc has: map the one to the other.",
);
pub(super) const SQUARE: Mistake = (
    "square-lens",
    "Your lens is a square. A lens is round, and so are the spots that it makes of distant lamps: \
     `sample_uniform_disc_concentric(u)` makes a point of a disc.",
);
pub(super) const DIAMETER_FOR_RADIUS: Mistake =
    ("diameter-for-radius", "Your lens is twice as large as it should be. `aperture` is its diameter.");
pub(super) const HALVED_TWICE: Mistake =
    ("halved-twice", "Your lens is half as large as it should be. The radius is half of `aperture`, not a quarter.");
pub(super) const WRONG_SIZE: Mistake =
    ("wrong-size", "The lens is a disc around the eye with the diameter `aperture`.");

pub(super) const RIM_ONLY: Mistake =
    ("rim-only", "All rays start at the rim of the lens. The radius needs a random number as well as the angle does.");
pub(super) const ON_A_LINE: Mistake = (
    "on-a-line",
    "All rays start on a line, and most of the lens gets none. A point needs two random numbers: use both of `u`.",
);
pub(super) const MIDDLE_CROWDED: Mistake = (
    "middle-crowded",
    "The points crowd in the middle of the lens. The share of the disc within a radius r is r², so the radius is the *root* of a \
     uniform number.",
);
pub(super) const RIM_CROWDED: Mistake = (
    "rim-crowded",
    "The points crowd at the rim of the lens. Each piece of the lens must get as many as its area says.",
);
pub(super) const NOT_UNIFORM: Mistake =
    ("not-uniform", "Some parts of the lens get more points than others. Use both numbers of `u`, each of them once.");

pub(super) const NOT_NORMALIZED: Mistake =
    ("not-normalized", "The ray goes the right way, but its direction is not of unit length. Normalize it.");
pub(super) const LOOKS_BACKWARDS: Mistake = (
    "looks-backwards",
    "The ray goes the wrong way. From the lens to the point in focus it is that point minus the origin.",
);
pub(super) const PARALLEL: Mistake = (
    "parallel-rays",
    "All rays of the pixel are parallel, so that nothing is sharp anywhere. The point in focus belongs to the *pinhole's* ray. \
     The ray from the lens must turn toward it.",
);
pub(super) const ON_SPHERE: Mistake = (
    "focus-on-sphere",
    "The rays meet at the distance `focus` from the eye, on a sphere. Take the point that `in_focus` gives.",
);
pub(super) const POINT_FOR_DIRECTION: Mistake = (
    "point-for-direction",
    "The direction is the point itself. A direction is a difference: the point minus the origin.",
);
pub(super) const MISSES: Mistake =
    ("misses-the-focus", "All rays of a pixel meet in the point that `in_focus` gives, wherever they start.");

pub(super) const PINHOLE_DIFFERS: Mistake = (
    "pinhole-differs",
    "A lens without an aperture is a pinhole: its ray is the one that you were given. Is there something that does not shrink \
     with the aperture, or a division by it?",
);
