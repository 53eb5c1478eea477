//! Two ways to find a tangent for every normal, and how each behaves over the sphere of all normals.

use common::{
    Basis, Error, Rgb, Stream, Vec2, Vec3,
    drawing::{
        CHALK, Drawing, FAINT, SLATE,
        lettering::{Align, Lettering},
        mark::Pen,
    },
    film::Size,
    float,
    picture::{FilmPoint, Integrator, PITCH, Picture, Render, Settings, YAW},
    story::{Story, number, triple},
};

use super::palette::{RED, ramp};

pub(super) const PICTURE: Picture = Picture {
    name: "tangent-frame",
    alt: "Two globes of all unit normals, each combed with short strokes along the tangent, and colored by how fast \
          the tangent turns from normal to normal, from dark violet for slowly to pale yellow for a hundred times \
          as fast as the normal. Left, the cross product of the normal and the x axis: the strokes run around the \
          place where the normal is the x axis, the colors glow toward it, and a red dot marks that there is no \
          tangent at all. Right, the basis of Duff and others: dark all over but for a thin bright seam, along \
          which the tangent jumps, and a tangent everywhere.",
    knobs: &[YAW, PITCH],
    size: Size::of::<960, 560>(),
    samples: 4,
    takes_mesh: false,
    make,
};

/// The page; middles of the globes, and their radius.
const PAGE: Vec2 = Vec2::new(960.0, 560.0);
const MIDDLES: [Vec2; 2] = [Vec2::new(245.0, 258.0), Vec2::new(715.0, 258.0)];
const RADIUS: f32 = 196.0;
/// The bar of colors: its left end and its size. It reaches from 1 to this.
const BAR: [Vec2; 2] = [Vec2::new(330.0, 504.0), Vec2::new(300.0, 14.0)];
const MOST: f32 = 100.0;

// ANCHOR: naive
/// The tangent by a cross product with a fixed axis. Where the normal lies along that axis, the product is zero, and
/// zero divided by its own length is not a number.
#[must_use]
pub fn naive(normal: Vec3) -> Vec3 {
    let across = normal.cross(Vec3::X);
    across / across.length()
}
// ANCHOR_END: naive

/// The tangent of the sound basis.
fn sound(normal: Vec3) -> Vec3 {
    Basis::around(normal).tangent
}

const TANGENTS: [fn(Vec3) -> Vec3; 2] = [naive, sound];

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    // Seen from here both the x axis and the plane z = 0 are in front.
    let [yaw, pitch] =
        [(YAW, 64.0_f32), (PITCH, 28.0)].map(|(knob, add)| (settings.values.number(&knob) + add).to_radians());
    let viewer = Vec3::new(float::sin(yaw) * float::cos(pitch), float::sin(pitch), float::cos(yaw) * float::cos(pitch));
    let right = Vec3::new(float::cos(yaw), 0.0, -float::sin(yaw));
    let globe = Globe { right, up: viewer.cross(right), viewer };
    let mut drawing = Drawing::new(PAGE, SLATE);
    for ((tangent, middle), name) in TANGENTS.into_iter().zip(MIDDLES).zip(["N × (1, 0, 0)", "Duff and others"]) {
        drawing.text(name, middle - Vec2::Y * (RADIUS + 26.0), Lettering::new(22.0, CHALK).aligned(Align::Center));
        comb(&mut drawing, &globe, tangent, middle);
    }
    for axis in [Vec3::X, Vec3::NEG_X] {
        if let Some(place) = globe.seen(axis) {
            let at = MIDDLES[0] + place * RADIUS;
            drawing.disc(at, 9.0, SLATE).disc(at, 6.5, RED.lerp(Rgb::X, 0.5));
            let beside = Lettering::new(19.0, CHALK);
            let corners = [[12.0, -15.0], [62.0, -15.0], [62.0, 15.0], [12.0, 15.0]];
            drawing.polygon(&corners.map(|corner| at + Vec2::from_array(corner)), SLATE, 0.8);
            drawing.text("NaN", at + Vec2::new(18.0, beside.drop()), beside);
        }
    }
    let [left, size] = BAR;
    let letters = Lettering::new(17.0, FAINT);
    for (share, name) in [(0.0, "1"), (0.5, "10"), (1.0, "100")] {
        drawing.text(name, left + Vec2::new(size.x * share, size.y + 24.0), letters.aligned(Align::Center));
    }
    let above = left + Vec2::new(size.x / 2.0, -12.0);
    drawing.text("turn of the tangent / turn of the normal", above, letters.aligned(Align::Center));
    Ok(Box::new(Globes { globe, drawing }))
}

/// The side of the unit sphere that is seen.
struct Globe {
    right: Vec3,
    up: Vec3,
    viewer: Vec3,
}

impl Globe {
    /// Where a normal is seen, from −1 to 1 to the right and down; `None` on the other side.
    fn seen(&self, normal: Vec3) -> Option<Vec2> {
        (normal.dot(self.viewer) > 0.0).then(|| Vec2::new(normal.dot(self.right), -normal.dot(self.up)))
    }

    /// The normal that is seen at a place.
    fn normal(&self, place: Vec2) -> Option<Vec3> {
        let depth = 1.0 - place.length_squared();
        let front = self.viewer * depth.max(0.0).sqrt();
        (depth > 0.0).then(|| (self.right * place.x - self.up * place.y + front).normalize())
    }
}

/// Short strokes along the tangent, at places that are spread evenly over the sphere.
fn comb(drawing: &mut Drawing, globe: &Globe, tangent: fn(Vec3) -> Vec3, middle: Vec2) {
    /// How many strokes, and half the length of one.
    const STROKES: u16 = 900;
    const LENGTH: f32 = 0.05;
    for i in 0..STROKES {
        // A spiral from pole to pole, turning by the golden angle.
        let height = 1.0 - (2.0 * f32::from(i) + 1.0) / f32::from(STROKES);
        let angle = 2.399_963_2 * f32::from(i);
        let across = (1.0 - height * height).sqrt();
        let normal = Vec3::new(across * float::cos(angle), height, across * float::sin(angle));
        let along = tangent(normal) * LENGTH;
        if normal.dot(globe.viewer) > 0.12 && along.is_finite() {
            let ends = [normal - along, normal + along].map(|end| globe.seen(end.normalize()));
            if let [Some(from), Some(to)] = ends {
                let pen = Pen { opacity: 0.85, ..Pen::new(CHALK, 1.5) };
                drawing.line(&[middle + from * RADIUS, middle + to * RADIUS], pen);
            }
        }
    }
}

// ANCHOR: turn
/// How far the tangent turns for a small turn of the normal, divided by that turn: the greatest over all directions.
fn turn(tangent: fn(Vec3) -> Vec3, normal: Vec3) -> f32 {
    const SMALL: f32 = 0.008;
    let Basis { tangent: one, bitangent: other, .. } = Basis::around(normal);
    let ways = [one, other, (one + other).normalize(), (one - other).normalize()];
    let turns = ways.map(|way| {
        let [before, after] = [-SMALL, SMALL].map(|small| tangent((normal + way * small).normalize()));
        (after - before).length() / (2.0 * SMALL)
    });
    turns.into_iter().fold(0.0, f32::max)
}
// ANCHOR_END: turn

/// Both globes, with what is drawn over them.
struct Globes {
    globe: Globe,
    drawing: Drawing,
}

impl Integrator for Globes {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        let place = self.drawing.place(point);
        let mut below = SLATE;
        for (tangent, middle) in TANGENTS.into_iter().zip(MIDDLES) {
            if let Some(normal) = self.globe.normal((place - middle) / RADIUS) {
                let turn = turn(tangent, normal);
                let share = float::ln(turn.max(1.0)) / float::ln(MOST);
                // A little darker toward the rim, so that it looks round.
                below = ramp(share) * (0.45 + 0.55 * normal.dot(self.globe.viewer));
                story.tell(|| format!("normal {}: the tangent turns {} times as fast", triple(normal), number(turn)));
            }
        }
        let [left, size] = BAR;
        let on_bar = (place - left) / size;
        if on_bar.cmpge(Vec2::ZERO).all() && on_bar.cmplt(Vec2::ONE).all() {
            below = ramp(on_bar.x);
        }
        let color = self.drawing.over(below, point);
        story.tell(|| format!("a point of a drawing: {}", triple(color)));
        color
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_cross_product_fails() {
        assert!(naive(Vec3::X).is_nan() && naive(Vec3::NEG_X).is_nan());
        for normal in [Vec3::X, Vec3::NEG_X, Vec3::Y, Vec3::NEG_Y, Vec3::Z, Vec3::NEG_Z] {
            let tangent = sound(normal);
            assert!((tangent.length() - 1.0).abs() < 1e-6 && tangent.dot(normal).abs() < 1e-6, "{normal}");
        }
    }

    /// Near the axis it turns by one over the sine of the angle to the axis; the sound one by a factor of a few.
    #[test]
    fn turns_are_those_of_the_formula() {
        for degrees in [5.0_f32, 20.0, 60.0] {
            let sine = float::sin(degrees.to_radians());
            let normal = Vec3::new(float::cos(degrees.to_radians()), 0.0, sine);
            assert!((turn(naive, normal) * sine - 1.0).abs() < 0.01, "{degrees}: {}", turn(naive, normal));
            assert!(turn(sound, normal) < 3.0, "{degrees}: {}", turn(sound, normal));
        }
    }
}
