//! Trees: trunks, branches that reach into lumps of the crown, and the leaves of those.

use common::{Vec3, color::srgb};
use ray_casting::material::Phong;

use super::FAR;
use crate::scenes::{
    budget::{number, ratio, share},
    builder::Builder,
    chance::Chance,
    foliage::{Cloud, leaf_length},
};

/// A tree: where it stands, and its crown.
struct Tree {
    foot: Vec3,
    /// The crown's middle, from the foot.
    crown: Vec3,
    /// Half the crown's size.
    half: Vec3,
    /// Radius of the trunk.
    trunk: f32,
}

/// The trees, the most important ones first. Of two only a little is seen: leaves on the right, a shadow on the ground.
const TREES: [Tree; 7] = [
    Tree {
        foot: Vec3::new(-5.6, 0.0, -6.6),
        crown: Vec3::new(0.1, 5.7, 0.0),
        half: Vec3::new(3.5, 2.5, 3.4),
        trunk: 0.3,
    },
    Tree {
        foot: Vec3::new(9.7, 0.0, -11.2),
        crown: Vec3::new(-0.2, 4.7, 0.2),
        half: Vec3::new(2.3, 2.1, 2.3),
        trunk: 0.2,
    },
    Tree {
        foot: Vec3::new(8.6, 0.0, 1.0),
        crown: Vec3::new(-2.8, 5.85, -0.2),
        half: Vec3::new(2.9, 1.75, 2.3),
        trunk: 0.24,
    },
    Tree {
        foot: Vec3::new(-5.4, 0.0, 4.2),
        crown: Vec3::new(1.0, 6.6, -0.4),
        half: Vec3::new(2.7, 1.7, 2.4),
        trunk: 0.24,
    },
    Tree {
        foot: Vec3::new(0.9, 0.0, FAR - 10.0),
        crown: Vec3::new(0.0, 6.6, 0.0),
        half: Vec3::new(1.0, 6.2, 1.0),
        trunk: 0.2,
    },
    Tree {
        foot: Vec3::new(-0.6, 0.0, FAR - 14.0),
        crown: Vec3::new(0.0, 7.4, 0.0),
        half: Vec3::new(1.1, 7.0, 1.1),
        trunk: 0.2,
    },
    Tree {
        foot: Vec3::new(-9.4, 0.0, -14.6),
        crown: Vec3::new(0.0, 3.7, 0.0),
        half: Vec3::new(1.6, 1.5, 1.6),
        trunk: 0.14,
    },
];

impl Tree {
    /// Whether the crown is a narrow flame, like a cypress's.
    fn is_narrow(&self) -> bool {
        self.half.y > 2.0 * self.half.x
    }

    /// The lumps of the crown: the more leaves there are, the more and the smaller.
    fn lumps(&self, index: u32, leaves: u32) -> Vec<Cloud> {
        let lumps = number(leaves, 60, [36, 190]);
        let middle = self.foot + self.crown;
        let mut chance = Chance::of("crowns", index);
        (0..lumps)
            .map(|i| {
                if self.is_narrow() {
                    // One above the other, narrow at both ends.
                    let t = 2.0 * ratio(i, lumps) - 1.0;
                    let wide = self.half.x * (1.0 - t * t).sqrt().max(0.15) * if t > 0.0 { 1.0 - 0.5 * t } else { 1.0 };
                    let center = middle + Vec3::new(chance.around(0.15), self.half.y * t, chance.around(0.15));
                    return Cloud { center, half: Vec3::new(wide, 0.5, wide) };
                }
                // Spread evenly over the crown's outside: as far up as around.
                let y = 1.0 - 1.72 * (ratio(i, lumps) + 0.5 / ratio(lumps, 1));
                let around = 137.5 * ratio(i, 1) + chance.around(20.0);
                let frame = ray_casting::frame::Frame::at(Vec3::ZERO).turned(Vec3::Y, around);
                let out = frame.vector_to_world(Vec3::new(0.0, y, (1.0 - y * y).max(0.0).sqrt()));
                let center = middle + self.half * out * chance.between(0.52, 0.9);
                let size = self.half.min_element() * chance.between(1.5, 2.7) / ratio(lumps, 1).sqrt();
                Cloud { center, half: Vec3::new(size * 1.2, size * 0.75, size * 1.2) }
            })
            .collect()
    }

    /// How much its leaves cover.
    fn area(&self) -> f32 {
        if self.is_narrow() { self.half.x * self.half.y * 10.0 } else { self.half.length_squared() * 5.5 }
    }
}

/// How many of the trees a budget for wood pays for.
fn trees(triangles: u32) -> Vec<(&'static Tree, u32)> {
    TREES.iter().zip(0..number(triangles, 10, [1, 7])).collect()
}

/// Trunks and branches.
pub(super) fn wood(builder: &mut Builder, triangles: u32) {
    builder.part("bark", Phong::of(srgb(136, 114, 92), 0.0, 1.0));
    let trees = trees(triangles);
    let each = triangles / u32::try_from(trees.len()).unwrap_or(1);
    let sides = number(each / 40, 3, [3, 64]);
    let rings = number(each / 200, 1, [1, 24]);
    for (tree, index) in trees {
        let mut chance = Chance::of("trunks", index);
        let fork = tree.foot + Vec3::new(tree.crown.x * 0.4, tree.crown.y - tree.half.y * 0.75, tree.crown.z * 0.4);
        let bend = Vec3::new(chance.around(0.25), 0.0, chance.around(0.25));
        let trunk: Vec<Vec3> = (0..=rings)
            .map(|i| ratio(i, rings))
            .map(|t| tree.foot.lerp(fork, t) + bend * (t * (1.0 - t) * 4.0))
            .collect();
        // The foot is wider.
        builder.tube(&trunk, sides, |i| {
            let t = ratio(u32::try_from(i).unwrap_or(0), rings);
            tree.trunk * (1.0 - 0.3 * t + 0.6 * (1.0 - t) * (1.0 - t) * (1.0 - t) * (1.0 - t))
        });
        if tree.is_narrow() {
            continue;
        }
        // One branch for each lump, as far as the budget goes: first outward, then up.
        let steps = number(rings, 3, [2, 8]);
        let cost = 2 * (sides / 2).max(3) * steps;
        let branches = (each.saturating_sub(2 * sides * rings) / cost) as usize;
        // They reach for lumps all around.
        let lumps = tree.lumps(index, 0);
        for lump in lumps.iter().take(branches) {
            let branch: Vec<Vec3> = (0..=steps)
                .map(|i| ratio(i, steps))
                .map(|t| fork.lerp(lump.center, t) - Vec3::Y * (t * (1.0 - t) * 0.7) - Vec3::Y * (0.15 * (1.0 - t)))
                .collect();
            builder.tube(&branch, (sides / 2).max(3), |i| {
                tree.trunk * (0.4 - 0.33 * ratio(u32::try_from(i).unwrap_or(0), steps))
            });
        }
    }
}

/// Leaves in several greens, as many as bring the square to its size.
pub(super) fn leaves(builder: &mut Builder, triangles: u32) {
    let trees = trees(share(triangles, 0.03));
    let left = builder.missing_to(triangles);
    let fine = left > 1_000_000;
    let number = left / if fine { 4 } else { 2 };
    let area: f32 = trees.iter().map(|(tree, _)| tree.area()).sum();
    let length = leaf_length(area, number).clamp(0.03, 0.8);
    let shades = [
        ("leaves", srgb(104, 146, 58), 0.4),
        ("young leaves", srgb(140, 172, 72), 0.25),
        ("old leaves", srgb(72, 116, 52), 0.35),
    ];
    for (name, color, part) in shades {
        builder.part(name, Phong::of(color, 0.12, 16.0));
        for &(tree, index) in trees.iter().filter(|(tree, _)| !tree.is_narrow()) {
            let count = share(number, part * tree.area() / area);
            let lumps = tree.lumps(index, share(number, tree.area() / area));
            builder.leaves(&lumps, count, length, fine, &mut Chance::of(name, index));
        }
    }
    builder.part("cypress leaves", Phong::of(srgb(52, 84, 56), 0.05, 10.0));
    for &(tree, index) in trees.iter().filter(|(tree, _)| tree.is_narrow()) {
        let count = share(number, tree.area() / area);
        builder.leaves(&tree.lumps(index, count), count, length * 0.8, fine, &mut Chance::of("cypress leaves", index));
    }
}
