//! What each scene with a lamp shows, and which mistakes, for exercise 6.2.

use super::lamp_scenes::{Made, caustic, floor, furnished, indirect, mirror, panel, porcelain, straight};

/// A scene, and what is known of it.
pub(super) struct Room {
    /// What it is, in words.
    pub(super) tells: &'static str,
    /// The scene.
    pub(super) make: fn() -> Made,
    /// Whether the lamp is in full view of a matte surface.
    pub(super) is_open: bool,
    /// Mistakes with known results.
    pub(super) rivals: &'static [Rival],
    /// Name of all other mistakes that show here.
    pub(super) name: &'static str,
    /// What to do about them.
    pub(super) advice: &'static str,
}

/// A mistake, and how many times the right result it has.
pub(super) struct Rival {
    pub(super) times: f64,
    pub(super) name: &'static str,
    pub(super) advice: &'static str,
}

/// All scenes. Those that show one mistake only come first.
pub(super) const ROOMS: [Room; 8] = [
    Room {
        tells: "a matte floor with the lamp above it, and nothing else",
        make: floor,
        is_open: true,
        rivals: &[Rival {
            times: 2.0,
            name: "counted-twice",
            advice: "This is twice the light. The floor has asked the lamp, and then the path has hit it by chance and has added its \
                     light again. After a diffuse step the lamp's emission does not count.",
        }],
        name: "wrong-direct-light",
        advice: "Add what `lamp_light` returns, times the throughput of this hit, before the step.",
    },
    Room {
        tells: "straight at the lamp",
        make: straight,
        is_open: false,
        rivals: &[Rival {
            times: 0.0,
            name: "black-lamp",
            advice: "The lamp is black. On a camera ray nobody has asked for its light yet: its emission counts.",
        }],
        name: "wrong-lamp",
        advice: "Straight at the lamp there is nothing but its own radiance.",
    },
    Room {
        tells: "a mirror of gold in which the lamp is seen",
        make: mirror,
        is_open: false,
        rivals: &[Rival {
            times: 0.0,
            name: "black-in-the-mirror",
            advice: "The lamp is black in the mirror. A mirror does not ask, so after a mirror step the lamp's emission counts.",
        }],
        name: "wrong-mirror",
        advice: "In a mirror there is the radiance of the lamp times the reflectance of gold.",
    },
    Room {
        tells: "a matte floor with the lamp above it, and with a panel that glows as well, and is not `is_lamp`",
        make: panel,
        is_open: false,
        rivals: &[],
        name: "other-light-lost",
        advice: "Nobody asks the panel, so its light counts whenever it is hit. Only what `is_lamp` was asked.",
    },
    Room {
        tells: "a floor of porcelain, with the lamp above it and in it",
        make: porcelain,
        is_open: false,
        rivals: &[],
        name: "kind-ignored",
        advice: "Porcelain is matte and mirrors at once. After one of its diffuse steps the lamp does not count, after one of its mirror \
                 steps it does: ask for `kind`, not for the material.",
    },
    Room {
        tells: "a matte floor which a board hides from the lamp, and to which a mirror of gold sends its light",
        make: caustic,
        is_open: false,
        rivals: &[],
        name: "caustic-lost",
        advice: "The path goes from the floor to the mirror, and from there to the lamp. The mirror has not asked, so the lamp counts: only \
                 the last step decides.",
    },
    Room {
        tells: "a matte floor which a board hides from the lamp, and to which a matte wall sends light",
        make: indirect,
        is_open: false,
        rivals: &[
            Rival {
                times: 0.0,
                name: "first-hit-only",
                advice: "No light arrives. The lamp must be asked at every hit, not at the first alone.",
            },
            Rival {
                // The throughput of red is its albedo, 0.8, divided by the probability of the step, the luminance.
                times: 0.678,
                name: "throughput-forgotten",
                advice: "Of the light that the second hit sends on, the first sends on a share only: `lamp_light` times the throughput.",
            },
        ],
        name: "wrong-indirect-light",
        advice: "Here all light is reflected twice. Is the throughput that of the hit where the lamp is asked?",
    },
    Room {
        tells: "a room with a lamp, a lantern, and balls of porcelain and silver",
        make: furnished,
        is_open: false,
        rivals: &[],
        name: "differs-from-chance",
        advice: "All scenes before were right. Compare your loop with that of the page, line by line.",
    },
];
