//! Four cards that catch the same light at one, two, three and four times the distance.

use std::f32::consts::PI;

use common::{
    Error, Rgb, Vec3,
    color::srgb,
    film::Size,
    float,
    obj::ObjMesh,
    picture::{ORBIT, Picture, Render, Settings},
};
use ray_casting::{
    light::PointLight,
    material::Phong,
    mesh::{Mesh, Shading},
    pictures::stage::{camera, square},
    scene::Scene,
};

use super::props::{Glowing, Mark};
use crate::{direct_light::DirectLight, offset::Offset};

pub(super) const PICTURE: Picture = Picture {
    name: "inverse-square",
    alt: "A small lamp, and four cards around it at the distances 1, 2, 3 and 4, all facing it. The nearest card is one \
          tile and white. The next are made of 4, 9 and 16 such tiles, and each catches as much light as the first: \
          spread over more tiles, it makes each of them a quarter, a ninth and a sixteenth as bright. Thin lines lead from \
          the lamp to the corners of each card.",
    knobs: &ORBIT,
    size: Size::of::<960, 480>(),
    samples: 8,
    takes_mesh: false,
    make,
};

/// Share of the light that the cards scatter.
const ALBEDO: f32 = 0.9;

/// The lamp whose light makes a card at distance 1 as bright as a screen can be.
const LAMP: PointLight = PointLight {
    position: Vec3::new(0.0, 0.95, 0.0),
    intensity: Rgb::new(PI / ALBEDO, 0.86 * PI / ALBEDO, 0.66 * PI / ALBEDO),
};

/// For the cards at the distances 1, 2, 3 and 4 the direction in degrees, from straight back to the right.
const DIRECTIONS: [(u8, f32); 4] = [(1, -86.0), (2, -40.0), (3, -3.0), (4, 30.0)];

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let mut scene = Scene::new();
    scene.ambient = Rgb::new(0.03, 0.04, 0.06);
    scene.light(LAMP);
    let ground = Phong::of(srgb(120, 118, 122), 0.0, 1.0);
    scene.surround(ground.ambient * scene.ambient);
    scene.add("floor", square(0.0, 60.0)?, ground);
    // The cards show the light of the lamp and nothing else.
    let white = Phong { ambient: Rgb::ZERO, ..Phong::of(Rgb::splat(ALBEDO), 0.0, 1.0) };
    let mut marks = vec![Mark::of(&LAMP, 0.03)];
    for (distance, degrees) in DIRECTIONS {
        scene.add("card", card(distance, degrees)?, white);
        // Four lines from the lamp to the corners of the card show the light that it catches.
        let radiance = LAMP.intensity * 0.05;
        marks.extend(corners(distance, degrees).map(|to| Mark { from: LAMP.position, to, radius: 0.006, radiance }));
    }
    let camera = camera([0.95, 2.5, 3.6], [0.16, 0.76, -1.5], 28.5, &settings.values)?;
    let direct = DirectLight { scene, camera, offset: Offset::Following };
    Ok(Box::new(Glowing { direct, marks }))
}

/// Side of a tile, in scene units.
const TILE: f32 = 0.42;

/// The middle of a card that faces the lamp from a distance, and its right.
fn place(distance: u8, degrees: f32) -> (Vec3, Vec3) {
    let angle = degrees.to_radians();
    let away = Vec3::new(float::sin(angle), 0.0, -float::cos(angle));
    (LAMP.position + away * f32::from(distance), away.cross(Vec3::Y))
}

/// The corners of a card, which has as many tiles along each side as it is away.
fn corners(distance: u8, degrees: f32) -> [Vec3; 4] {
    let (middle, right) = place(distance, degrees);
    let half = f32::from(distance) * TILE / 2.0;
    [(-half, -half), (half, -half), (half, half), (-half, half)].map(|(x, y)| middle + right * x + Vec3::Y * y)
}

/// The tiles of a card.
fn card(distance: u8, degrees: f32) -> Result<Mesh, Error> {
    /// Half of what is seen of a tile: there is a thin gap between two.
    const HALF: f32 = TILE * 0.465;
    let (middle, right) = place(distance, degrees);
    let along = |i: u8| (f32::from(i) - f32::from(distance - 1) / 2.0) * TILE;
    let mut obj = ObjMesh::default();
    for (row, column) in (0..distance).flat_map(|row| (0..distance).map(move |column| (row, column))) {
        let tile = middle + right * along(column) + Vec3::Y * along(row);
        let corner = |x: f32, y: f32| tile + (right * x + Vec3::Y * y) * HALF;
        let first = u32::from(row * distance + column) * 4;
        obj.positions.extend([corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)]);
        obj.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    }
    Mesh::new(&obj, Shading::Flat)
}

#[cfg(test)]
mod tests {
    use super::*;
    use common::Interval;
    use ray_casting::{light::Light, ray::Ray, shape::Shape};

    #[test]
    fn each_card_has_its_tiles_and_is_as_bright_as_the_inverse_square_says() {
        for (distance, degrees) in DIRECTIONS {
            let card = card(distance, degrees).unwrap();
            assert_eq!(card.len(), 2 * usize::from(distance * distance));
            // Look from the lamp at a place near the middle of the card, where there is a tile for all of them.
            let toward = card.bounds().center() + Vec3::Y * 0.03 - LAMP.position;
            let beside = toward.cross(Vec3::Y).normalize() * 0.03;
            let hit = card.intersect(&Ray::new(LAMP.position, toward + beside), Interval::POSITIVE).unwrap();
            let light = LAMP.illuminate(hit.position);
            let radiance = light.strength.x * ALBEDO / PI * light.direction.dot(hit.shading_normal);
            let expected = 1.0 / f32::from(distance * distance);
            assert!((radiance / expected - 1.0).abs() < 5e-3, "{radiance} at {distance}");
        }
    }
}
