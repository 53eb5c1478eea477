//! Noise: chance that changes smoothly over the plane, and sums of it that look like nature.

/// A number between 0 and 1 that grows from `low` to `high` with a smooth start and end.
#[must_use]
pub fn smooth_step(low: f32, high: f32, x: f32) -> f32 {
    fade(((x - low) / (high - low)).clamp(0.0, 1.0))
}

/// A polynomial from 0 to 1 whose first two derivatives vanish at both ends.
fn fade(t: f32) -> f32 {
    t * t * t * (t * (t * 6.0 - 15.0) + 10.0)
}

/// The greatest whole number that is not above `x`.
fn whole_below(x: f32) -> i32 {
    // Several times as fast as `floor` on machines without an instruction for it.
    let toward_zero = x as i32;
    toward_zero - i32::from(x < toward_zero as f32)
}

/// Eight directions, an eighth of a turn apart.
const SLOPES: [(f32, f32); 8] = {
    const D: f32 = std::f32::consts::FRAC_1_SQRT_2;
    [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (D, D), (D, -D), (-D, D), (-D, -D)]
};

/// Gradient noise: about −1 to 1, zero in all points with whole coordinates, with hills and hollows about 1 apart.
///
/// Source: Perlin, *Improving Noise*, SIGGRAPH 2002, in two dimensions and with a hash in place of the table.
#[must_use]
pub fn noise(seed: u32, x: f32, z: f32) -> f32 {
    let (column, row) = (whole_below(x), whole_below(z));
    let (dx, dz) = (x - column as f32, z - row as f32);
    let corner = |i: i32, j: i32| {
        let hash = hash(seed, column.wrapping_add(i), row.wrapping_add(j));
        let (slope_x, slope_z) = SLOPES[(hash >> 29) as usize];
        (dx - i as f32) * slope_x + (dz - j as f32) * slope_z
    };
    let (u, v) = (fade(dx), fade(dz));
    let mix = |a: f32, b: f32, t: f32| a + (b - a) * t;
    1.4 * mix(mix(corner(0, 0), corner(1, 0), u), mix(corner(0, 1), corner(1, 1), u), v)
}

/// A sum of octaves of noise, each with half the size and half the height of the one before; about −1 to 1.
#[must_use]
pub fn fractal(seed: u32, x: f32, z: f32, octaves: u32) -> f32 {
    let (mut sum, mut height, mut scale) = (0.0, 0.5, 1.0);
    for octave in 0..octaves {
        sum += height * noise(seed.wrapping_add(octave), x * scale, z * scale);
        height /= 2.0;
        scale *= 2.0;
    }
    sum
}

/// A sum of octaves of noise folded at its zeros into sharp ridges, 0 to about 1: where it is low, finer octaves count
/// less, so that valleys stay smooth.
///
/// Source: Musgrave's ridged multifractal, in Ebert et al., *Texturing and Modeling*, 3rd edition, 2003, chapter 16.
#[must_use]
pub fn ridges(seed: u32, x: f32, z: f32, octaves: u32) -> f32 {
    let (mut sum, mut height, mut scale, mut weight) = (0.0, 0.5, 1.0, 1.0);
    for octave in 0..octaves {
        if weight <= 0.0 {
            break;
        }
        let ridge = 1.0 - noise(seed.wrapping_add(octave), x * scale, z * scale).abs();
        let ridge = ridge * ridge * weight;
        sum += ridge * height;
        weight = (ridge * 2.2).clamp(0.0, 1.0);
        height *= 0.48;
        scale *= 2.07;
    }
    sum
}

/// 32 bits that depend on every bit of all three numbers.
fn hash(seed: u32, column: i32, row: i32) -> u32 {
    let mut bits = seed.wrapping_mul(0x9e37_79b9) ^ column.cast_unsigned().wrapping_mul(0x85eb_ca6b);
    bits = (bits ^ (bits >> 15)).wrapping_mul(0x2c1b_3c6d);
    bits ^= row.cast_unsigned().wrapping_mul(0xc2b2_ae35);
    bits = (bits ^ (bits >> 16)).wrapping_mul(0x7feb_352d);
    bits = (bits ^ (bits >> 15)).wrapping_mul(0x846c_a68b);
    bits ^ (bits >> 16)
}
