//! A mark: a form and its paint.

use glam::Vec2;

use crate::color::Rgb;

/// What a line is drawn with. Lengths are in units of the page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pen {
    /// Linear RGB.
    pub color: Rgb,
    /// Width of the line.
    pub width: f32,
    /// 1 hides what is below, 0 is not there.
    pub opacity: f32,
    /// Lengths of a dash and of the gap after it.
    pub dashes: Option<[f32; 2]>,
    /// Whether the line vanishes from its first to its last point.
    pub fades: bool,
}

impl Pen {
    /// A pen for whole lines that hide what is below.
    #[must_use]
    pub fn new(color: Rgb, width: f32) -> Self {
        Self { color, width, opacity: 1.0, dashes: None, fades: false }
    }
}

/// A form with its paint.
#[derive(Clone, Debug)]
pub(super) struct Mark {
    form: Form,
    bounds: Bounds,
    color: Rgb,
    opacity: f32,
    /// Where the paint is whole, and the way from there to where it is gone, divided by its squared length.
    fade: Option<(Vec2, Vec2)>,
}

impl Mark {
    pub(super) fn new(form: Form, color: Rgb, opacity: f32) -> Self {
        Self { bounds: form.bounds(), form, color, opacity, fade: None }
    }

    pub(super) fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// Let the paint vanish from one point to another.
    pub(super) fn fades(&mut self, from: Vec2, to: Vec2) {
        let way = to - from;
        self.fade = Some((from, way / way.length_squared().max(f32::MIN_POSITIVE)));
    }

    /// Move it.
    pub(super) fn shift(&mut self, by: Vec2) {
        match &mut self.form {
            Form::Lines { handfuls, .. } => {
                for handful in handfuls {
                    handful.bounds = handful.bounds.shifted(by);
                    handful.pieces.iter_mut().flatten().for_each(|p| *p += by);
                }
            }
            Form::Disc { center, .. } => *center += by,
            Form::Polygon { edges, bounds } => {
                edges.iter_mut().for_each(|(corner, _)| *corner += by);
                *bounds = bounds.shifted(by);
            }
        }
        self.bounds = self.bounds.shifted(by);
        self.fade = self.fade.map(|(from, way)| (from + by, way));
    }

    /// The color at a place where `below` was before; `pixel` is the width of a pixel.
    pub(super) fn over(&self, below: Rgb, place: Vec2, pixel: f32) -> Rgb {
        if !self.bounds.contains(place, pixel) {
            return below;
        }
        let left = self.fade.map_or(1.0, |(from, way)| 1.0 - (place - from).dot(way).clamp(0.0, 1.0));
        below.lerp(self.color, self.form.coverage(place, pixel) * self.opacity * left)
    }
}

/// What is painted.
#[derive(Clone, Debug)]
pub(super) enum Form {
    /// Straight pieces with round ends, in handfuls that lie together.
    Lines { handfuls: Vec<Handful>, half: f32 },
    /// All points up to a distance.
    Disc { center: Vec2, radius: f32 },
    /// Inside of all edges: for each of them a point and the unit normal that points outward.
    Polygon { edges: Vec<(Vec2, Vec2)>, bounds: Bounds },
}

/// A few straight pieces and what bounds them with their width.
#[derive(Clone, Debug)]
pub(super) struct Handful {
    bounds: Bounds,
    pieces: Vec<[Vec2; 2]>,
}

impl Form {
    /// How many pieces of a line are looked at together.
    const HANDFUL: usize = 6;

    /// Lines of the given width through the points of each list. One point makes a dot.
    pub(super) fn lines(lines: &[Vec<Vec2>], width: f32) -> Self {
        let piece = |points: &[Vec2]| [points[0], points[points.len() - 1]];
        let pieces: Vec<_> =
            lines.iter().flat_map(|points| points.windows(points.len().clamp(1, 2)).map(piece)).collect();
        let handful = |pieces: &[[Vec2; 2]]| Handful {
            bounds: Bounds::of(pieces.iter().flatten().copied()).grown(width / 2.0),
            pieces: pieces.to_vec(),
        };
        Self::Lines { handfuls: pieces.chunks(Self::HANDFUL).map(handful).collect(), half: width / 2.0 }
    }

    /// The inside of a convex polygon.
    pub(super) fn polygon(corners: &[Vec2]) -> Self {
        let next = |i: usize| corners[(i + 1) % corners.len()];
        // Twice the area; its sign is that of the turning direction.
        let area: f32 = corners.iter().enumerate().map(|(i, c)| c.perp_dot(next(i))).sum();
        let normal = |i: usize, c: Vec2| -(next(i) - c).perp().normalize_or_zero() * area.signum();
        let edges = corners.iter().enumerate().map(|(i, &c)| (c, normal(i, c))).collect();
        Self::Polygon { edges, bounds: Bounds::of(corners.iter().copied()) }
    }

    fn bounds(&self) -> Bounds {
        match self {
            Self::Lines { handfuls, .. } => Bounds::of(handfuls.iter().flat_map(|h| [h.bounds.min, h.bounds.max])),
            Self::Disc { center, radius } => Bounds::of([*center]).grown(*radius),
            Self::Polygon { bounds, .. } => *bounds,
        }
    }

    /// Which share of a pixel around a place is covered.
    fn coverage(&self, place: Vec2, pixel: f32) -> f32 {
        match self {
            Self::Lines { handfuls, half } => {
                let near = handfuls.iter().filter(|h| h.bounds.contains(place, pixel)).flat_map(|h| &h.pieces);
                let squared = near.map(|piece| distance_squared(place, *piece)).fold(f32::INFINITY, f32::min);
                covered(squared.sqrt(), *half, pixel)
            }
            Self::Disc { center, radius } => covered((place - center).length(), *radius, pixel),
            Self::Polygon { edges, .. } => {
                let outside = edges.iter().map(|(corner, normal)| (place - corner).dot(*normal));
                (0.5 - outside.fold(f32::NEG_INFINITY, f32::max) / pixel).clamp(0.0, 1.0)
            }
        }
    }
}

/// Which share of a pixel lies in a band: that of the interval of one pixel around `distance` from the band's middle.
fn covered(distance: f32, half: f32, pixel: f32) -> f32 {
    let inner = (distance - pixel / 2.0).max(-half);
    let outer = (distance + pixel / 2.0).min(half);
    ((outer - inner) / pixel).max(0.0)
}

/// Squared distance from a point to a straight piece.
fn distance_squared(point: Vec2, [a, b]: [Vec2; 2]) -> f32 {
    let (along, from) = (b - a, point - a);
    let t = (from.dot(along) / along.length_squared().max(f32::MIN_POSITIVE)).clamp(0.0, 1.0);
    (from - along * t).length_squared()
}

/// An upright rectangle; empty if `min` is beyond `max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bounds {
    min: Vec2,
    max: Vec2,
}

impl Bounds {
    /// The smallest that has all the points.
    fn of(points: impl IntoIterator<Item = Vec2>) -> Self {
        let empty = Self { min: Vec2::INFINITY, max: Vec2::NEG_INFINITY };
        points.into_iter().fold(empty, |b, p| Self { min: b.min.min(p), max: b.max.max(p) })
    }

    /// The smallest that has all of two.
    pub(super) fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    fn grown(self, by: f32) -> Self {
        Self { min: self.min - by, max: self.max + by }
    }

    fn shifted(self, by: Vec2) -> Self {
        Self { min: self.min + by, max: self.max + by }
    }

    /// Whether a point is inside or at most `margin` beside it.
    pub(super) fn contains(self, point: Vec2, margin: f32) -> bool {
        let Self { min, max } = self.grown(margin);
        point.x >= min.x && point.x <= max.x && point.y >= min.y && point.y <= max.y
    }
}
