//! What several pictures share: a dark stage without a visible horizon, its lights, and the eye in front of it.

use std::ops::RangeInclusive;

use common::{
    Error, Rgb, Vec3,
    color::srgb,
    knob::Values,
    obj::{ObjMesh, parse},
};

use crate::{
    aabb::Aabb,
    camera::{Camera, CameraError},
    frame::Frame,
    light::{DirectionalLight, PointLight},
    material::Phong,
    mesh::{Mesh, Shading},
    scene::Scene,
};

/// The sun of the stage: low, from the left and behind, a little cool.
pub fn sun() -> DirectionalLight {
    DirectionalLight::new(Vec3::new(-0.9, 0.3, -0.35), Rgb::new(1.7, 2.1, 3.1))
}

/// The lamp of the stage: near, warm, from the right and in front.
pub fn lamp() -> PointLight {
    PointLight { position: Vec3::new(2.2, 3.9, 3.0), intensity: Rgb::new(75.4, 61.3, 45.6) }
}

/// A stage with a floor that fades into the background.
pub fn stage() -> Result<Scene<Phong>, Error> {
    let mut scene = Scene::new();
    scene.ambient = Rgb::new(0.07, 0.085, 0.12);
    let floor = Phong::of(srgb(92, 96, 108), 0.0, 1.0);
    // Far from the lamp the floor shows the ambient light and the sun. The background is the same.
    let sunlight = crate::light::Light::illuminate(&sun(), Vec3::ZERO);
    scene.surround(floor.ambient * scene.ambient + sunlight.strength * floor.diffuse_term(sunlight.direction, Vec3::Y));
    scene.light(sun()).light(lamp());
    scene.add("floor", square(0.0, 400.0)?, floor);
    Ok(scene)
}

/// A horizontal square around the y axis at height `y`, with sides of twice `half` scene units.
pub fn square(y: f32, half: f32) -> Result<Mesh, Error> {
    let corner = |x: f32, z: f32| Vec3::new(x * half, y, z * half);
    let obj = ObjMesh {
        positions: vec![corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        ..ObjMesh::default()
    };
    Mesh::new(&obj, Shading::Flat)
}

/// A box around the origin of `frame`, reaching `half` to both sides along each axis of the frame.
///
/// # Errors
/// None, since it has triangles.
pub fn block(frame: Frame, half: Vec3) -> Result<Mesh, Error> {
    /// The corners of each face, counter-clockwise from outside. A corner's bits say on which side of x, y, z it lies.
    const FACES: [[u32; 4]; 6] = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let side = |corner: u32, bit: u32| if corner >> bit & 1 == 1 { 1.0 } else { -1.0 };
    let corner = |i| frame.point_to_world(half * Vec3::new(side(i, 0), side(i, 1), side(i, 2)));
    let obj = ObjMesh {
        positions: (0..8).map(corner).collect(),
        triangles: FACES.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect(),
        ..ObjMesh::default()
    };
    Mesh::new(&obj, Shading::Flat)
}

/// The crystals of `assets/gem.obj`, 1 unit high, scaled and put at `place`.
pub fn crystals(place: Vec3, scale: f32) -> Result<Mesh, Error> {
    let mut obj = asset("assets/gem.obj", include_bytes!("../../../../assets/gem.obj"))?;
    for position in &mut obj.positions {
        *position = *position * scale + place;
    }
    Mesh::new(&obj, Shading::Flat)
}

/// The pawn of `assets/pawn.obj`: 2 units high.
pub fn pawn() -> Result<ObjMesh, Error> {
    asset("assets/pawn.obj", include_bytes!("../../../../assets/pawn.obj"))
}

fn asset(file: &str, bytes: &[u8]) -> Result<ObjMesh, Error> {
    parse(bytes).map_err(|error| Error::Obj { file: file.into(), error })
}

/// A camera that the orbit knobs move.
pub fn camera(eye: [f32; 3], lookat: [f32; 3], field_of_view: f32, values: &Values) -> Result<Camera, Error> {
    Camera::orbited(Vec3::from_array(eye), Vec3::from_array(lookat), field_of_view, values).map_err(camera_error)
}

/// A camera that sees the whole of a box, from the front and a little above, and that the orbit knobs move.
///
/// # Errors
/// [`Error::Picture`] if the box is too small or too large.
pub fn whole(bounds: Aabb, values: &Values) -> Result<Camera, Error> {
    // Stand back until the sphere around the box fills the field of view. A box of one point gets a radius too.
    const FIELD_OF_VIEW: f32 = 30.0;
    let radius = (bounds.diagonal() / 2.0).max(bounds.center().abs().max_element() * 1e-6);
    // Squares of larger and smaller numbers leave the range of f32.
    const RADII: RangeInclusive<f32> = 1e-15..=1e15;
    if !RADII.contains(&radius) {
        let (least, most) = (RADII.start(), RADII.end());
        let message =
            format!("the mesh has a radius of {radius:e} units, and only {least:e} to {most:e} can be framed");
        return Err(Error::Picture(message));
    }
    let distance = 0.95 * radius / common::float::sin((FIELD_OF_VIEW / 2.0).to_radians());
    let eye = bounds.center() + Vec3::new(0.5, 0.35, 1.0).normalize() * distance;
    Camera::orbited(eye, bounds.center(), FIELD_OF_VIEW, values).map_err(camera_error)
}

/// A camera that cannot be made, as an error of the picture.
pub fn camera_error(error: CameraError) -> Error {
    Error::Picture(error.to_string())
}

#[cfg(test)]
mod tests {
    use common::Interval;

    use super::*;
    use crate::{hit::Side, ray::Ray, shape::Shape};

    #[test]
    fn every_face_of_a_block_looks_outward() {
        let block = block(Frame::at(Vec3::splat(3.0)), Vec3::new(1.0, 2.0, 3.0)).unwrap();
        for axis in Vec3::AXES {
            for toward in [axis, -axis] {
                let ray = Ray::new(Vec3::splat(3.0) - toward * 10.0 + Vec3::splat(0.1), toward);
                let hit = block.intersect(&ray, Interval::POSITIVE).unwrap();
                assert_eq!((hit.geometric_normal, hit.side), (-toward, Side::Outside));
            }
        }
    }
}
