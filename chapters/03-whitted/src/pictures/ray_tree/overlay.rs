//! The rays over the scene.

use common::{
    Rgb, Vec2, Vec3,
    drawing::{
        CHALK, Drawing, FAINT, SLATE,
        lettering::{Align, Lettering},
        mark::Pen,
    },
    picture::FilmPoint,
};
use ray_casting::camera::Camera;

use super::{FILM, Node, color};
use crate::probe::Kind;

/// The page: the square that the side camera's field of view is about.
const PAGE: f32 = 540.0;
/// How far from the eye the film is drawn, in scene units.
const FILM_DISTANCE: f32 = 1.7;
/// How long a ray is drawn that hits nothing.
const ESCAPE: f32 = 1.6;

/// The rays of a tree, and the eye with its film, as the side camera sees them.
pub(super) fn draw(tree: &[Node], eye: &Camera, pixel: FilmPoint, side: &Camera) -> Drawing {
    let mut drawing = Drawing::new(Vec2::splat(PAGE), SLATE);
    let place = |point: Vec3| side.project(point).map(|p| (Vec2::new(p.x, -p.y) + 1.0) * (PAGE / 2.0));
    draw_film(&mut drawing, eye, &place);
    // The weak rays first, so that they do not hide the strong ones.
    let mut by_share: Vec<&Node> = tree.iter().collect();
    by_share.sort_by(|a, b| a.share().total_cmp(&b.share()));
    for node in by_share {
        draw_ray(&mut drawing, node, &place);
    }
    // The eye, and where the ray goes through its film.
    if let (Some(eye_place), Some(pixel)) = (place(eye.eye()), place(eye.ray(pixel).at(FILM_DISTANCE))) {
        drawing.disc(eye_place, 7.0, CHALK).disc(eye_place + Vec2::X * 2.0, 3.4, SLATE).disc(pixel, 3.6, CHALK);
        let letters = Lettering::new(18.0, CHALK).aligned(Align::Center);
        drawing.text("eye", eye_place + Vec2::Y * 28.0, letters);
    }
    draw_legend(&mut drawing);
    drawing
}

/// The frame of the film, with thin lines from the eye to its corners.
fn draw_film(drawing: &mut Drawing, eye: &Camera, place: &impl Fn(Vec3) -> Option<Vec2>) {
    let corner = |share: Vec2| place(eye.ray(FilmPoint { position: share * FILM, size: FILM }).at(FILM_DISTANCE));
    let corners = [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y, Vec2::ZERO].map(corner);
    let corners: Option<Vec<Vec2>> = corners.into_iter().collect();
    let (Some(eye), Some(corners)) = (place(eye.eye()), corners) else { return };
    drawing.polygon(&corners[1..], CHALK, 0.10).line(&corners, Pen::new(FAINT, 1.6));
    for corner in &corners[1..] {
        drawing.line(&[eye, *corner], Pen { opacity: 0.4, ..Pen::new(FAINT, 1.2) });
    }
}

/// A ray from where it starts to what it hits. One that hits nothing fades away, with an arrow.
fn draw_ray(drawing: &mut Drawing, node: &Node, place: &impl Fn(Vec3) -> Option<Vec2>) {
    let segment = &node.segment;
    let end = segment.to.unwrap_or(segment.from + segment.direction * ESCAPE);
    let (Some(from), Some(to)) = (place(segment.from), place(end)) else { return };
    let pen = pen(node.color(), node.share());
    if segment.to.is_some() {
        drawing.line(&[from, to], pen).disc(to, pen.width * 0.5 + 1.6, node.color());
        return;
    }
    // The head of the arrow stands where half of the line is left.
    let (tip, along) = (from.lerp(to, 0.55), (to - from).normalize_or_zero() * (pen.width + 5.0));
    let barb = |side: f32| tip - along + along.perp() * (0.6 * side);
    drawing.line(&[from, to], Pen { fades: true, ..pen }).line(&[barb(1.0), tip, barb(-1.0)], pen);
}

/// The wider and the less transparent, the more a ray counts.
pub(super) fn pen(color: Rgb, share: f32) -> Pen {
    let root = share.sqrt();
    Pen { opacity: (0.45 + 0.55 * root).min(1.0), ..Pen::new(color, 1.2 + 3.0 * root) }
}

/// What the colors mean.
fn draw_legend(drawing: &mut Drawing) {
    let letters = Lettering::new(18.0, CHALK);
    let mut at = Vec2::new(-8.0, 452.0);
    for (kind, name) in [(Kind::Camera, "from the eye"), (Kind::Reflected, "reflected"), (Kind::Refracted, "refracted")]
    {
        drawing.line(&[at, at + Vec2::X * 32.0], pen(color(kind), 0.5));
        drawing.text(name, at + Vec2::new(42.0, letters.drop()), letters);
        at.y += 26.0;
    }
}
