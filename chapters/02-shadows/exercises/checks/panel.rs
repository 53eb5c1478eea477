//! What arrives from a shining panel, in f64: place by place, right or with a mistake, and in closed form.

use common::{Rgb, Vec2, Vec3};
use glam::{DVec2, DVec3};
use ray_casting::hit::Hit;

use super::{
    blockers::{Blockers, Way},
    words,
};

/// A question: what arrives at this hit?
#[derive(Clone)]
pub(crate) struct Question {
    pub(crate) blockers: Blockers,
    pub(crate) hit: Hit,
    /// One corner of the panel, and the edges that start there.
    pub(crate) panel: [Vec3; 3],
    pub(crate) radiance: Rgb,
    pub(crate) n: u16,
    pub(crate) jitter: Vec<Vec2>,
}

/// What an answer is made of.
#[derive(Clone, Copy)]
pub(crate) struct Recipe {
    /// The shares of both edges, by column, row, n, and jitter.
    pub(crate) place: fn(usize, usize, usize, &[Vec2]) -> DVec2,
    /// Where these shares of both edges lie, by corner and edges.
    pub(crate) at: fn([DVec3; 3], DVec2) -> DVec3,
    /// Where ω and the distance are measured from.
    pub(crate) from: fn(&Hit) -> Vec3,
    /// Where the shadow ray aims, in shares of both edges, by those of the place.
    pub(crate) aim: fn(DVec2) -> DVec2,
    /// How far the shadow ray looks, by the distance.
    pub(crate) reach: fn(f64) -> f64,
    /// Whether light arrives, by the cosines at the surface and at the panel.
    pub(crate) arrives: fn(f64, f64) -> bool,
    /// The light from one place for a radiance of 1.
    pub(crate) strength: fn(Geometry) -> f64,
    /// The visible share and the irradiance, by the sum, the number of places, and the number of those that are seen.
    pub(crate) mean: fn(DVec3, f64, f64) -> (f64, DVec3),
    /// The normal of the lit surface.
    pub(crate) normal: fn(&Hit) -> Vec3,
}

/// Where a place on the panel lies.
#[derive(Clone, Copy)]
pub(crate) struct Geometry {
    /// Cosine at the lit surface.
    pub(crate) surface: f64,
    /// Cosine at the panel.
    pub(crate) panel: f64,
    pub(crate) distance: f64,
    /// Of the whole panel.
    pub(crate) area: f64,
}

pub(crate) const RIGHT: Recipe = Recipe {
    place: |column, row, n, jitter| (cell(column, row) + jitter[row * n + column].as_dvec2()) / parts(n),
    at: |[corner, first, second], share| corner + first * share.x + second * share.y,
    from: |hit| hit.position,
    aim: |share| share,
    reach: |distance| distance,
    arrives: |surface, panel| surface > 0.0 && panel > 0.0,
    strength: |g| g.area * g.surface * g.panel / (g.distance * g.distance),
    mean: |sum, count, seen| (seen / count, sum / count),
    normal: |hit| hit.shading_normal,
};

#[expect(clippy::cast_precision_loss, reason = "few parts")]
pub(crate) fn cell(column: usize, row: usize) -> DVec2 {
    DVec2::new(column as f64, row as f64)
}

#[expect(clippy::cast_precision_loss, reason = "few parts")]
pub(crate) fn parts(n: usize) -> f64 {
    n as f64
}

impl Question {
    /// The share that is seen and the irradiance by a recipe; `None` if rounding decides what is seen.
    pub(crate) fn value(&self, recipe: &Recipe) -> Option<(f64, DVec3)> {
        let panel = self.panel.map(|v| v.as_dvec3());
        let across = panel[1].cross(panel[2]);
        let normal = (recipe.normal)(&self.hit).as_dvec3();
        let position = (recipe.from)(&self.hit).as_dvec3();
        let n = usize::from(self.n);
        let (mut seen, mut sum) = (0.0, DVec3::ZERO);
        for (row, column) in (0..n).flat_map(|row| (0..n).map(move |column| (row, column))) {
            let share = (recipe.place)(column, row, n, &self.jitter);
            let to_panel = (recipe.at)(panel, share) - position;
            let to_aim = (recipe.at)(panel, (recipe.aim)(share)) - position;
            let distance = to_panel.length();
            let direction = to_panel / distance;
            let (surface, panel) = (direction.dot(normal), -direction.dot(across.normalize_or_zero()));
            let is_clear = surface.abs() > 1e-3 && (panel.abs() > 1e-3 || across == DVec3::ZERO);
            if !is_clear {
                return None;
            }
            if !(recipe.arrives)(surface, panel) {
                continue;
            }
            let geometric = self.hit.geometric_normal.as_dvec3();
            match self.blockers.way(position, geometric, to_aim.normalize(), (recipe.reach)(to_aim.length())) {
                Way::Unclear => return None,
                Way::Blocked => {}
                Way::Free => {
                    seen += 1.0;
                    let geometry = Geometry { surface, panel, distance, area: across.length() };
                    sum += self.radiance.as_dvec3() * (recipe.strength)(geometry);
                }
            }
        }
        Some((recipe.mean)(sum, parts(n * n), seen))
    }

    /// Where the places lie, if they are few.
    pub(crate) fn places(&self) -> Option<String> {
        const FEW: u16 = 2;
        let (n, panel) = (usize::from(self.n), self.panel.map(|v| v.as_dvec3()));
        let cells = (0..n).flat_map(|row| (0..n).map(move |column| (row, column)));
        let place = |(row, column)| words::rounded((RIGHT.at)(panel, (RIGHT.place)(column, row, n, &self.jitter)));
        let verb = if n == 1 { "place" } else { "places" };
        (self.n <= FEW).then(|| format!("{verb} {}", cells.map(place).collect::<Vec<_>>().join(", ")))
    }

    /// What arrives from the whole panel, if nothing hides it and all of it lies above the horizon.
    ///
    /// Source: Lambert, *Photometria*, 1760: half the sum over the edges of the angle that an edge covers, times the
    /// cosine between the surface's normal and the normal of the triangle of the edge and the point.
    #[allow(clippy::disallowed_methods, reason = "the platform's functions are the second opinion here")]
    pub(crate) fn closed_form(&self) -> DVec3 {
        let [corner, first, second] = self.panel.map(|v| v.as_dvec3());
        let corner = corner - self.hit.position.as_dvec3();
        let corners = [corner, corner + first, corner + first + second, corner + second].map(DVec3::normalize);
        let sum: f64 = (0..4)
            .map(|i| {
                let (a, b) = (corners[i], corners[(i + 1) % 4]);
                a.dot(b).clamp(-1.0, 1.0).acos()
                    * b.cross(a).normalize_or_zero().dot(self.hit.shading_normal.as_dvec3())
            })
            .sum();
        self.radiance.as_dvec3() * sum / 2.0
    }

    pub(crate) fn tried(&self) -> String {
        let [corner, first, second] = self.panel.map(words::triple);
        let jitter = match &*self.jitter {
            all if all.iter().all(|j| *j == Vec2::splat(0.5)) => "in the middle of each part".into(),
            all if all.len() <= 9 => {
                let entries: Vec<_> = all.iter().map(|j| format!("({}, {})", j.x, j.y)).collect();
                format!("jitter {}", entries.join(", "))
            }
            _ => "any jitter".into(),
        };
        let leaning = if self.hit.shading_normal == self.hit.geometric_normal {
            String::new()
        } else {
            format!(" and shading normal {}", words::triple(self.hit.shading_normal))
        };
        format!(
            "{}{leaning}, a panel with corner {corner} and edges {first} and {second}, radiance {}, n = {}, {jitter}, {}",
            words::hit(&self.hit),
            words::triple(self.radiance),
            self.n,
            self.blockers.words()
        )
    }
}
