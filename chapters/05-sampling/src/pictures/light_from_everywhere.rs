//! The cover: what a point of a surface sees.

mod point;

use std::f32::consts::TAU;

use common::{
    Error, Rgb, Stream, Vec2, Vec3,
    drawing::{
        CHALK, Drawing, FAINT, SLATE,
        lettering::{Align, Lettering},
        mark::Pen,
    },
    film::Size,
    float,
    knob::{Knob, Step},
    picture::{FilmPoint, Integrator, ORBIT, Picture, Render, Settings},
    story::{Story, triple},
};
use ray_casting::{camera::Camera, pictures::stage};
use shadows::offset::Offset;
use whitted::{
    material::Fresnel,
    pictures::treasure,
    whitted::{Limits, Terms, Whitted},
};

use self::point::Point;

/// Where the point is, seen from above.
const X: Knob = Knob::number("x", "the point, to the right", [-4.0, 4.0], -0.42, "scene units", Step::Add(0.1));
const Z: Knob = Knob::number("z", "the point, to the front", [-4.0, 4.0], 0.52, "scene units", Step::Add(0.1));

pub(super) const PICTURE: Picture = Picture {
    name: "light-from-everywhere",
    alt: "Left, balls of gold, silver, copper, glass and porcelain on a round terrace at sea in the evening. A \
          small white dome stands over one point of the terrace, in the shadow between the balls. Right, a large \
          disc shows all that this point sees, as a map from above: the violet and rosy sky in the middle, and \
          around it, bent along the edge, the balls that stand there. Below are two swatches of color: what the \
          point would send back under a constant ambient light, and what it sends back when all of the disc is \
          summed, which is darker and warmer.",
    knobs: &[X, Z, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 540>(),
    samples: 8,
    takes_mesh: false,
    make,
};

/// The page; the part of it where the scene is seen begins at the left edge.
const PAGE: Vec2 = Vec2::new(960.0, 540.0);
const SCENE: Vec2 = Vec2::new(596.0, 540.0);
/// The disc that shows the hemisphere.
const CENTER: Vec2 = Vec2::new(778.0, 226.0);
const RADIUS: f32 = 158.0;
/// The two swatches: their size, and where the first stands.
const SWATCH: Vec2 = Vec2::new(150.0, 46.0);
const SWATCHES: [Vec2; 2] = [Vec2::new(620.0, 438.0), Vec2::new(786.0, 438.0)];

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let camera = stage::camera([0.0, 3.7, 9.0], [0.0, 0.86, 0.1], 36.5, &settings.values)?;
    let scene = Whitted {
        scene: treasure::scene(),
        camera,
        limits: Limits::DEFAULT,
        terms: Terms::ALL,
        fresnel: Fresnel::Exact,
        offset: Offset::Following,
    };
    let [x, z] = [X, Z].map(|knob| settings.values.number(&knob));
    let point = Point::below(&scene, x, z);
    let swatches = point.swatches(&scene);
    let [cone, drawing] = drawings(&camera, &point);
    Ok(Box::new(Cover { scene, point, swatches, cone, drawing }))
}

/// The cone of light that does not lie over the disc, and what is drawn over all.
fn drawings(camera: &Camera, point: &Point) -> [Drawing; 2] {
    /// Radius of the dome, in scene units.
    const DOME: f32 = 0.3;
    let [mut cone, mut drawing] = [0; 2].map(|_| Drawing::new(PAGE, SLATE));
    // Where a point in space is seen on the page.
    let seen = |place: Vec3| {
        let window = camera.project(place)?;
        Some(SCENE / 2.0 + Vec2::new(window.x, -window.y) * SCENE.min_element() / 2.0)
    };
    let on_dome = |place: Vec2, height: f32| {
        seen(point.origin + (point.right * place.x + point.away * place.y + point.normal * height) * DOME)
    };
    let circle = |angle: f32| Vec2::new(float::cos(angle), float::sin(angle));
    let (middle, top) = (seen(point.origin), on_dome(Vec2::ZERO, 1.0));
    if let (Some(middle), Some(top)) = (middle, top) {
        // From the dome to the disc: a cone of light.
        let dome = middle.lerp(top, 0.35);
        let size = on_dome(Vec2::X, 0.0).map_or(10.0, |side| side.distance(middle));
        let apart = CENTER - dome;
        let turn = float::acos(((size - RADIUS) / apart.length()).clamp(-1.0, 1.0));
        let toward = float::atan2(apart.y, apart.x);
        let tangent = |sign: f32| {
            let out = circle(toward + sign * turn);
            [dome + out * size, CENTER + out * RADIUS]
        };
        let [one, other] = [tangent(1.0), tangent(-1.0)];
        cone.polygon(&[one[0], one[1], other[1], other[0]], CHALK, 0.09);
        let edge = Pen { opacity: 0.5, ..Pen::new(CHALK, 1.4) };
        cone.line(&one, edge).line(&other, edge);
        // The dome: its rim, two arcs over it, and the point itself.
        let arcs = [
            |angle: f32| (Vec2::new(float::cos(angle), float::sin(angle)), 0.0),
            |angle: f32| (Vec2::new(float::cos(angle), 0.0), float::sin(angle).abs()),
            |angle: f32| (Vec2::new(0.0, float::cos(angle)), float::sin(angle).abs()),
        ];
        for (arc, width) in arcs.into_iter().zip([2.4, 1.6, 1.6]) {
            let points = (0..=48_u8).filter_map(|i| {
                let (place, height) = arc(TAU * f32::from(i) / 48.0);
                on_dome(place, height)
            });
            drawing.line(&points.collect::<Vec<_>>(), Pen::new(CHALK, width));
        }
        drawing.disc(middle, 4.0, CHALK);
    }
    // The page at the right.
    let rim: Vec<Vec2> = (0..=96_u8).map(|i| CENTER + circle(TAU * f32::from(i) / 96.0) * RADIUS).collect();
    drawing.line(&rim, Pen::new(CHALK, 2.4));
    let heading = Lettering::new(22.0, CHALK).aligned(Align::Center);
    drawing.text("what this point sees", Vec2::new(CENTER.x, 42.0), heading);
    drawing.text("what it sends back", Vec2::new(CENTER.x, 422.0), Lettering { size: 19.0, ..heading });
    for (at, name) in SWATCHES.into_iter().zip(["ambient term", "sum of the disc"]) {
        let below = at + Vec2::new(SWATCH.x / 2.0, SWATCH.y + 24.0);
        drawing.text(name, below, Lettering::new(17.0, FAINT).aligned(Align::Center));
    }
    [cone, drawing]
}

/// The scene, what a point of it sees, and what the point sends back.
struct Cover {
    scene: Whitted,
    point: Point,
    swatches: [Rgb; 2],
    cone: Drawing,
    drawing: Drawing,
}

impl Integrator for Cover {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let place = self.drawing.place(point);
        let on_disc = (place - CENTER) / RADIUS;
        let is_on_disc = on_disc.length_squared() < 1.0;
        let below = if is_on_disc {
            self.point.radiance(&self.scene, Vec2::new(on_disc.x, -on_disc.y), story)
        } else if place.cmpge(Vec2::ZERO).all() && place.cmplt(SCENE).all() {
            self.scene.radiance(FilmPoint { position: place, size: SCENE }, random, story)
        } else {
            let is_in = |corner: Vec2| place.cmpge(corner).all() && place.cmplt(corner + SWATCH).all();
            SWATCHES.into_iter().zip(self.swatches).find(|(at, _)| is_in(*at)).map_or(SLATE, |(_, color)| color)
        };
        let below = if is_on_disc { below } else { self.cone.over(below, point) };
        let color = self.drawing.over(below, point);
        story.tell(|| format!("with what is drawn over it: {}", triple(color)));
        color
    }
}

#[cfg(test)]
mod tests {
    use common::Interval;
    use ray_casting::ray::Ray;

    use super::*;

    /// The page says that the point of the cover lies in the shade, and that the sum is warmer than the ambient term.
    #[test]
    fn the_point_of_the_cover_lies_in_the_shade() {
        let cover = whitted_of(treasure::scene());
        let point = Point::below(&cover, X.default(), Z.default());
        let toward = cover.scene.lights[0].illuminate(point.origin).direction;
        assert!(cover.scene.occluded(&Ray::new(point.origin, toward), Interval::POSITIVE));
        let [ambient, sum] = point.swatches(&cover);
        assert!(sum.x / sum.z > 2.0 * ambient.x / ambient.z, "{ambient} {sum}");
        assert!(common::color::luminance(sum) < common::color::luminance(ambient), "{ambient} {sum}");
    }

    fn whitted_of(scene: ray_casting::scene::Scene<whitted::material::Material>) -> Whitted {
        let camera = Camera::new(Vec3::Z, Vec3::ZERO, Vec3::Y, 30.0).unwrap();
        let (limits, terms) = (Limits::DEFAULT, Terms::ALL);
        Whitted { scene, camera, limits, terms, fresnel: Fresnel::Exact, offset: Offset::Following }
    }

    /// On an empty terrace the map has the sky only; under a sky of one color the sum is that color times the albedo.
    #[test]
    fn the_mean_of_the_disc_is_what_is_reflected() {
        let mut scene = ray_casting::scene::Scene::new();
        scene.surround(Rgb::new(0.5, 1.0, 2.0));
        let whitted = whitted_of(scene);
        let point = Point { albedo: Rgb::splat(0.25), ..Point::below(&whitted, 0.0, 0.0) };
        assert!((point.swatches(&whitted)[1] - Rgb::new(0.125, 0.25, 0.5)).length() < 1e-5);
        assert_eq!(point.direction(Vec2::ZERO), Vec3::Y);
        assert_eq!(point.direction(Vec2::Y), -Vec3::Z);
    }
}
