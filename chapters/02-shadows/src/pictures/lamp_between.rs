//! A lamp between two things, and what happens when a shadow ray does not stop at the lamp.

use common::{
    Error, Rgb, Vec3,
    color::srgb,
    film::Size,
    knob::Knob,
    picture::{ORBIT, Panels, Picture, Render, Settings},
};
use ray_casting::{
    frame::Frame,
    light::{Illumination, Light, PointLight},
    material::Phong,
    pictures::stage::{block, camera, square},
    quadric::Quadric,
    scene::Scene,
    sphere::Sphere,
};

use super::props::{Glowing, Mark};
use crate::{direct_light::DirectLight, offset::Offset};

const BUG: Knob = Knob::choice(
    "bug",
    "which mistake the right half makes",
    &["none", "forgets-the-distance", "takes-t-for-the-distance"],
    1,
);

pub(super) const PICTURE: Picture = Picture {
    name: "lamp-between",
    alt: "A candle between a white screen on the left and a pawn on the right, twice. Left, as it should be: the screen \
          is bright and empty, and the pawn is lit and throws its shadow away from the candle. Right, with a shadow \
          ray that does not stop at the lamp: the screen shows the shadow of the pawn upside down, and the pawn itself \
          stands in the shadow of the screen, though nothing is between them and the candle.",
    knobs: &[BUG, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 400>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let bug = match settings.values.index(&BUG) {
        1 => Bug::ForgetsTheDistance,
        2 => Bug::TakesTForTheDistance,
        _ => Bug::None,
    };
    Ok(Box::new(Panels::new(2, vec![Box::new(view(Bug::None, settings)?), Box::new(view(bug, settings)?)])))
}

// ANCHOR: bug
/// A lamp, and the mistake that is made with its distance.
struct Mistaken {
    lamp: PointLight,
    bug: Bug,
}

/// Mistakes at the far end of a shadow ray.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Bug {
    /// The shadow ray ends at the lamp.
    None,
    /// It never ends, so that things behind the lamp count.
    ForgetsTheDistance,
    /// Its direction is not of unit length, so that it ends at t = 1. But t is compared with the distance d: things
    /// count up to d times d.
    TakesTForTheDistance,
}

impl Light for Mistaken {
    fn illuminate(&self, point: Vec3) -> Illumination {
        let right = self.lamp.illuminate(point);
        let distance = match self.bug {
            Bug::None => right.distance,
            Bug::ForgetsTheDistance => f32::INFINITY,
            Bug::TakesTForTheDistance => right.distance * right.distance,
        };
        Illumination { distance, ..right }
    }
}
// ANCHOR_END: bug

fn view(bug: Bug, settings: &Settings) -> Result<Glowing, Error> {
    let lamp = PointLight { position: Vec3::new(-0.1, 0.78, 0.05), intensity: Rgb::new(7.2, 5.2, 3.2) };
    let mut scene = Scene::new();
    scene.ambient = Rgb::new(0.075, 0.09, 0.14);
    scene.light(Mistaken { lamp, bug });

    let ground = Phong::of(srgb(130, 122, 118), 0.0, 1.0);
    let paper = Phong::of(srgb(226, 220, 208), 0.0, 1.0);
    let wax = Phong::of(srgb(232, 222, 196), 0.2, 30.0);
    let lacquer = Phong::of(srgb(180, 48, 44), 0.7, 70.0);
    scene.surround(ground.ambient * scene.ambient);
    scene.add("floor", square(0.0, 60.0)?, ground);
    let standing = Frame::at(Vec3::new(-1.5, 0.85, -0.55)).turned(Vec3::Y, 50.0);
    scene.add("screen", block(standing, Vec3::new(0.95, 0.85, 0.03))?, paper);
    scene.add("candle", Quadric::cylinder(0.045, 0.66).placed(Frame::at(lamp.position.with_y(0.0))), wax);
    // A pawn of three quadrics and a ball.
    let foot = Vec3::new(1.1, 0.0, 0.52);
    let part = |height: f32| Frame::at(foot + Vec3::Y * height);
    scene.add("foot", Quadric::ellipsoid(Vec3::new(0.38, 0.17, 0.38)).placed(part(0.06)), lacquer);
    scene.add("body", Quadric::cone(0.29, 1.1).placed(part(0.1)), lacquer);
    scene.add("collar", Quadric::ellipsoid(Vec3::new(0.22, 0.045, 0.22)).placed(part(0.91)), lacquer);
    scene.add("head", Sphere::new(foot + Vec3::Y * 1.12, 0.22), lacquer);

    let camera = camera([0.75, 2.3, 5.4], [-0.2, 0.68, 0.0], 31.0, &settings.values)?;
    let direct = DirectLight { scene, camera, offset: Offset::Following };
    Ok(Glowing { direct, marks: vec![Mark::of(&lamp, 0.035)] })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_a_bug_the_lamp_is_the_real_one() {
        let lamp = PointLight { position: Vec3::new(1.0, 2.0, 3.0), intensity: Rgb::ONE };
        let none = Mistaken { lamp, bug: Bug::None };
        for point in [Vec3::ZERO, Vec3::new(5.0, -2.0, 0.5)] {
            assert_eq!(none.illuminate(point), lamp.illuminate(point));
        }
    }

    #[test]
    fn only_the_distance_is_wrong() {
        let lamp = PointLight { position: Vec3::Y * 3.0, intensity: Rgb::ONE };
        for (bug, distance) in [(Bug::ForgetsTheDistance, f32::INFINITY), (Bug::TakesTForTheDistance, 9.0)] {
            let wrong = Mistaken { lamp, bug }.illuminate(Vec3::ZERO);
            assert_eq!(wrong, Illumination { distance, ..lamp.illuminate(Vec3::ZERO) });
        }
    }
}
