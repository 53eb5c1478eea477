//! The tree of rays of one pixel, in the scene and as a diagram.

mod diagram;
mod overlay;

use common::{
    Error, Interval, Rgb, Stream, Vec2, Vec3,
    color::srgb,
    drawing::{Drawing, SLATE},
    film::Size,
    knob::{Knob, Step},
    picture::{FilmPoint, Integrator, ORBIT, Picture, Render, Settings},
    story::Story,
};
use ray_casting::{
    camera::Camera,
    light::PointLight,
    material::Phong,
    pictures::stage::{camera, camera_error},
    ray::Ray,
    scene::Scene,
    sphere::Sphere,
};

use super::{
    disc::Disc,
    evening::Evening,
    studio::{depth, limits, seen, wall},
};
use crate::{
    branches::Branch,
    material::Material,
    probe::{Kind, RayTree, Segment},
    whitted::{Whitted, mean},
};

/// Which pixel, from the left.
const X: Knob = Knob::number("x", "the pixel, from the left", [0.0, 100.0], 56.0, "%", Step::Add(1.0));
/// Which pixel, from above.
const Y: Knob = Knob::number("y", "the pixel, from above", [0.0, 100.0], 45.0, "%", Step::Add(1.0));
/// How many surfaces a ray may have behind it.
const DEPTH: Knob = depth(5.0);

pub(super) const PICTURE: Picture = Picture {
    name: "ray-tree",
    alt: "Left, a glass ball and a gold ball between a floor and a wall, seen from the side and dimmed; over them, as \
          colored lines, all rays that one pixel of an eye at the left asks for: white from the eye, gold where \
          reflected, blue where refracted, thinner the less they count. Right, what the eye sees, with the pixel \
          marked; below, the same rays as a tree, each with its share in per cent and what it hits.",
    knobs: &[X, Y, DEPTH, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 540>(),
    samples: 4,
    takes_mesh: false,
    make,
};

/// What the eye sees, in units of the diagram's page.
const FILM: Vec2 = Vec2::new(320.0, 180.0);

/// A ray of the tree, and what it hit.
struct Node {
    segment: Segment,
    /// `None` for the background.
    name: Option<&'static str>,
}

impl Node {
    /// Which share of its radiance reaches the eye: the mean over the colors.
    fn share(&self) -> f32 {
        mean(self.segment.weight)
    }

    /// White from the eye, gold if reflected, light blue if refracted.
    fn color(&self) -> Rgb {
        color(self.segment.kind)
    }
}

fn color(kind: Kind) -> Rgb {
    match kind {
        Kind::Camera => Rgb::new(0.9, 0.9, 0.9),
        Kind::Reflected => Rgb::new(1.0, 0.56, 0.08),
        Kind::Refracted => Rgb::new(0.15, 0.56, 1.0),
    }
}

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let number = |knob| settings.values.number(knob);
    let eye = eye()?;
    let seen_by_eye = seen(scene()?, eye, limits(settings, &DEPTH));
    // Trace the pixel's ray and write the tree down.
    let pixel = FilmPoint { position: Vec2::new(number(&X), number(&Y)) / 100.0 * FILM, size: FILM };
    let tree = nodes(&seen_by_eye, Branch::from_camera(eye.ray(pixel)));
    // Look at it from the side.
    let side = camera([-3.0, 6.0, 12.4], [-0.78, 0.95, 0.0], 34.0, &settings.values)?;
    Ok(Box::new(Sides {
        overlay: overlay::draw(&tree, &eye, pixel, &side),
        diagram: diagram::draw(&tree, pixel),
        from_side: seen(scene()?, side, limits(settings, &DEPTH)),
        seen_by_eye,
    }))
}

/// Who looks at the glass ball.
fn eye() -> Result<Camera, Error> {
    let (at, lookat) = (Vec3::new(-4.6, 2.1, 1.2), Vec3::new(0.3, 0.95, -0.3));
    Camera::new(at, lookat, Vec3::Y, 34.0).map_err(camera_error)
}

/// A glass ball and a gold one, a floor and a wall.
fn scene() -> Result<Scene<Material>, Error> {
    let mut scene = Scene::new();
    scene.surround(Evening { sun: Vec3::new(-0.62, 0.60, 0.58).normalize() });
    scene.ambient = Rgb::splat(0.25);
    scene.light(PointLight { position: Vec3::new(-3.0, 6.0, 3.5), intensity: Rgb::splat(95.0) });
    let rough = |color| Material::rough(Phong::of(color, 0.0, 1.0));
    let floor = Disc { center: Vec3::ZERO, inner: 0.0, outer: 3.8 };
    let wall = wall(Vec3::new(2.8, 0.0, -2.4), Vec3::new(2.8, 0.0, 2.4), 3.2)?;
    scene
        .add("floor", floor, rough(srgb(120, 126, 138)))
        .add("wall", wall, rough(srgb(176, 92, 78)))
        .add("glass ball", Sphere::new(Vec3::new(-0.7, 1.15, 0.35), 1.15), Material::glass(1.5))
        .add("gold ball", Sphere::new(Vec3::new(1.45, 0.9, -1.0), 0.9), Material::GOLD);
    Ok(scene)
}

/// All rays of a tree with what they hit, each after the one that caused it.
fn nodes(picture: &Whitted, root: Branch) -> Vec<Node> {
    let mut tree = RayTree::default();
    picture.trace(root, 0, &mut tree);
    let node = |segment: Segment| {
        let ray = Ray::new(segment.from, segment.direction);
        let hit = segment.to.and_then(|_| picture.scene.intersect(&ray, Interval::POSITIVE));
        Node { segment, name: hit.map(|(_, object)| object.name) }
    };
    tree.0.into_iter().map(node).collect()
}

/// The scene from the side with the rays over it; at its right what the eye sees and the diagram.
struct Sides {
    from_side: Whitted,
    seen_by_eye: Whitted,
    overlay: Drawing,
    diagram: Drawing,
}

impl Sides {
    /// How much of the film's width belongs to the scene.
    const SPLIT: f32 = 0.63;
    /// How much of its light the scene has left, so that the rays are seen.
    const DIMMED: f32 = 0.42;
}

impl Integrator for Sides {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let FilmPoint { position, size } = point;
        // Whole pixels, so that lines are as crisp as they can be.
        let width = (size.x * Self::SPLIT).round();
        if position.x < width {
            let point = FilmPoint { position, size: Vec2::new(width, size.y) };
            let scene = self.from_side.radiance(point, random, story);
            return self.overlay.over(SLATE.lerp(scene, Self::DIMMED), point);
        }
        let left = Vec2::X * width;
        let point = FilmPoint { position: position - left, size: size - left };
        let in_film = self.diagram.place(point) - diagram::FILM_AT;
        let is_in_film = in_film.cmpge(Vec2::ZERO).all() && in_film.cmplt(FILM).all();
        let below = if is_in_film {
            self.seen_by_eye.radiance(FilmPoint { position: in_film, size: FILM }, random, story)
        } else {
            story.tell(|| "a point of the diagram".into());
            SLATE
        };
        self.diagram.over(below, point)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::whitted::Limits;

    #[test]
    fn every_ray_starts_where_one_with_a_greater_share_ended() {
        let eye = eye().unwrap();
        let picture = seen(scene().unwrap(), eye, Limits { max_depth: 5, ..Limits::DEFAULT });
        let pixel = FilmPoint { position: Vec2::new(0.56, 0.45) * FILM, size: FILM };
        let tree = nodes(&picture, Branch::from_camera(eye.ray(pixel)));
        assert_eq!(tree.len(), 10);
        for (i, node) in tree.iter().enumerate().skip(1) {
            let parent = tree[..i].iter().rfind(|n| n.segment.depth + 1 == node.segment.depth).unwrap();
            assert!(parent.segment.to.unwrap().distance(node.segment.from) < 1e-4);
            assert!(parent.share() >= node.share() && parent.name.is_some());
        }
    }
}
