//! Triangles to try structures with: a soup of them, and a teapot in a stadium.

use std::sync::Arc;

use common::{Vec2, Vec3, exercise::dice::Dice, float, obj::ObjMesh};
use ray_casting::{
    frame::Frame,
    mesh::{Mesh, Shading},
    ray::Ray,
};
use space_partitioning::{
    scenes::{builder::Builder, chance::Chance},
    triangles::Triangles,
};

/// Triangles here and there, small and large, some of them long and thin. Every eighth one is there twice, so that some
/// rays hit two at the same `t`.
pub(crate) fn soup(seed: u64, count: usize) -> Triangles {
    let mut dice = Dice::new(seed);
    let mut builder = Builder::default();
    let mut last = [Vec3::ZERO; 3];
    for i in 0..count {
        if i % 8 != 7 {
            let (center, size) = (dice.point(5.0), dice.choice([0.3, 0.6, 3.0]));
            last = [(); 3].map(|()| center + dice.point(1.0) * size);
        }
        let corners = last.map(|corner| builder.vertex(corner));
        builder.triangle(corners);
    }
    triangles(&builder.mesh)
}

/// A ray through the soup.
pub(crate) fn through_soup(dice: &mut Dice) -> Ray {
    let (origin, aim) = (dice.point(7.0), dice.point(4.0));
    match dice.happens(0.2) {
        // Along an axis.
        true => Ray::new(origin, dice.choice(Vec3::AXES) * dice.choice([1.0, -1.0, 0.5])),
        false if aim == origin => Ray::new(origin, Vec3::X),
        false => Ray::new(origin, aim - origin),
    }
}

/// A teapot in a stadium, as one mesh.
pub(crate) fn stadium() -> Triangles {
    let mut builder = Builder::default();
    field(&mut builder);
    seats(&mut builder);
    pot(&mut builder);
    triangles(&builder.mesh)
}

/// A ray in the stadium: every second one toward the teapot.
pub(crate) fn in_stadium(dice: &mut Dice) -> Ray {
    let origin = dice.point(1.0) * Vec3::new(20.0, 5.0, 20.0) + Vec3::Y * 6.0;
    let aim = match dice.happens(0.5) {
        true => dice.point(1.0) * Vec3::new(1.0, 0.7, 1.0) + Vec3::Y * 0.7,
        false => dice.point(30.0),
    };
    Ray::new(origin, aim - origin)
}

/// The mesh of a few triangles.
pub(crate) fn triangles(obj: &ObjMesh) -> Triangles {
    Triangles(Arc::new(Mesh::new(obj, Shading::Smooth).expect("a mesh")))
}

/// The field.
pub(crate) fn field(builder: &mut Builder) {
    builder.block([-70.0, -1.0, -70.0], [70.0, 0.0, 70.0]);
}

/// The stadium: rising rings of seats around the field.
pub(crate) fn seats(builder: &mut Builder) {
    // A point twice makes an edge.
    let twice = |radius: f32, height: f32| [Vec2::new(radius, height); 2];
    let mut profile = Vec::new();
    for step in 0..12_u8 {
        let (radius, height) = (24.0 + 2.0 * f32::from(step), 1.0 + 1.1 * f32::from(step));
        profile.extend(twice(radius, height - 1.1));
        profile.extend(twice(radius, height));
    }
    profile.extend(twice(50.0, 13.1));
    profile.extend(twice(50.0, 0.0));
    builder.turned(&Frame::at(Vec3::ZERO), &profile, 48);
}

/// The teapot: 1.4 units high, on the field.
pub(crate) fn pot(builder: &mut Builder) {
    let body = [
        (0.0, 0.0),
        (0.5, 0.0),
        (0.78, 0.16),
        (0.95, 0.45),
        (0.84, 0.78),
        (0.56, 0.95),
        (0.5, 1.0),
        (0.36, 1.1),
        (0.1, 1.16),
        (0.08, 1.22),
        (0.15, 1.31),
        (0.1, 1.39),
        (0.0, 1.4),
    ]
    .map(|(radius, height)| Vec3::new(radius, height, 0.0));
    let mut profile: Vec<_> = smooth(&body, 6).iter().map(|p| Vec2::new(p.x.max(0.0), p.y)).collect();
    // The tips lie on the axis.
    for tip in [0, profile.len() - 1] {
        profile[tip].x = 0.0;
    }
    builder.turned(&Frame::at(Vec3::ZERO), &profile, 40);
    let spout = [[0.7, 0.35, 0.0], [1.05, 0.45, 0.0], [1.2, 0.75, 0.0], [1.45, 0.98, 0.0]].map(Vec3::from_array);
    let spout = smooth(&spout, 6);
    let last = f32::from(u16::try_from(spout.len() - 1).unwrap_or(1));
    let share = |i: usize| f32::from(u16::try_from(i).unwrap_or(0)) / last;
    builder.tube(&spout, 16, |i| 0.22 - 0.14 * share(i));
    let handle: Vec<_> = (0..=24_u8)
        .map(|i| std::f32::consts::PI * f32::from(i) / 24.0)
        .map(|angle| Vec3::new(-0.78 - 0.55 * float::sin(angle), 0.55 + 0.3 * float::cos(angle), 0.0))
        .collect();
    builder.tube(&handle, 12, |_| 0.07);
}

/// A smooth line through points, each piece in so many parts: Catmull and Rom's spline.
fn smooth(points: &[Vec3], parts: u8) -> Vec<Vec3> {
    let at = |i: usize| points[i.clamp(1, points.len()) - 1];
    let mut line = Vec::new();
    // Indices one higher than usual, so that there is one before the first.
    for i in 1..points.len() {
        let [a, b, c, d] = [at(i - 1), at(i), at(i + 1), at(i + 2)];
        for part in 0..parts {
            let t = f32::from(part) / f32::from(parts);
            let curve = (b * 2.0 + (c - a) * t)
                + (a * 2.0 - b * 5.0 + c * 4.0 - d) * (t * t)
                + (b * 3.0 - a - c * 3.0 + d) * (t * t * t);
            line.push(curve / 2.0);
        }
    }
    line.extend(points.last());
    line
}

/// A ball of long thin spikes, each a single triangle.
pub(crate) fn spikes(count: u16) -> Triangles {
    let mut builder = Builder::default();
    for i in 0..count {
        // Slices of a sphere of equal height have equal area; from slice to slice, turn by the golden angle.
        let height = 1.0 - (2.0 * f32::from(i) + 1.0) / f32::from(count);
        let angle = f32::from(i) * std::f32::consts::TAU * 0.381_966;
        let across = (1.0 - height * height).sqrt();
        let out = Vec3::new(across * float::cos(angle), height, across * float::sin(angle));
        let side = out.any_orthonormal_vector() * 0.03;
        let corners = [out * 0.2 - side, out * 0.2 + side, out].map(|corner| builder.vertex(corner));
        builder.triangle(corners);
    }
    triangles(&builder.mesh)
}

/// A bush: so many leaves in a ball above the floor, most of them small and some large.
pub(crate) fn bush(leaves: u16) -> Triangles {
    let mut builder = Builder::default();
    let mut chance = Chance::of("bush", 0);
    for _ in 0..leaves {
        let place = chance.in_ball() * Vec3::new(1.0, 0.85, 1.0) + Vec3::Y * 1.05;
        let length = if chance.happens(0.2) { 0.7 } else { 0.1 };
        let along = chance.direction() * length;
        let across = along.any_orthogonal_vector().normalize_or(Vec3::X) * (0.3 * along.length());
        builder.leaf(place, along, across, false);
    }
    triangles(&builder.mesh)
}
