//! The plane of a triangle, colored by what its edges say.

use common::{
    Error, Rgb, Stream, Vec3,
    film::Size,
    picture::{FilmPoint, Integrator, Picture, Render, Settings},
    story::{Story, number},
};

use crate::{ray::Ray, triangle::Triangle};

pub(super) const PICTURE: Picture = Picture {
    name: "edges",
    alt: "A plane cut by three straight lines, the edges of a triangle, into seven parts. Each line adds its own \
          color, red, green or blue, on its left side. Only in the triangle in the middle do all three meet, to \
          nearly white.",
    knobs: &[],
    size: Size::of::<960, 480>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(_settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let triangle = Triangle::new(Vec3::new(-0.75, -0.5, 0.0), Vec3::new(0.8, -0.35, 0.0), Vec3::new(-0.05, 0.62, 0.0));
    Ok(Box::new(Edges { triangle }))
}

/// The ray through a point of the film at right angles to the plane z = 0; the film is 2 units high there.
pub(super) fn straight_at(point: FilmPoint) -> Ray {
    let ndc = point.ndc();
    Ray::new(Vec3::new(ndc.x * point.aspect(), ndc.y, 1.0), -Vec3::Z)
}

/// Asks each edge of a triangle on its own.
struct Edges {
    triangle: Triangle,
}

impl Integrator for Edges {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        /// What each edge adds on its left side.
        const COLORS: [Rgb; 3] =
            [Rgb::new(0.3, 0.034, 0.025), Rgb::new(0.045, 0.22, 0.054), Rgb::new(0.034, 0.09, 0.35)];
        let ray = straight_at(point);
        let [r1, r2, r3] = self.triangle.corners;
        let n = self.triangle.normal();
        let p = ray.at((r1 - ray.origin).dot(n) / ray.direction.dot(n));
        let mut color = Rgb::splat(0.012);
        for ((from, to), own) in [(r1, r2), (r2, r3), (r3, r1)].into_iter().zip(COLORS) {
            let turn = (to - from).cross(p - from).dot(n);
            story.tell(|| format!("((to − from) × (p − from)) · n = {}", number(turn)));
            if turn >= 0.0 {
                color += own;
            }
        }
        color
    }
}
