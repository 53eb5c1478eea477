//! Barycentric coordinates as colors.

use common::{
    Error, Interval, Rgb, Stream, Vec3,
    film::Size,
    picture::{FilmPoint, Integrator, Picture, Render, Settings},
    story::{Story, triple},
};

use super::edges::straight_at;
use crate::{triangle::Triangle, triangle_barycentric::Shear};

pub(super) const PICTURE: Picture = Picture {
    name: "barycentric",
    alt: "A triangle whose corners are pure red, green and blue. Inside, the colors are mixed by the barycentric \
          coordinates of each point, so that the middle is gray, with lines where a coordinate is a multiple of a tenth.",
    knobs: &[],
    size: Size::of::<960, 480>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(_settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let triangle = Triangle::new(Vec3::new(-0.95, -0.8, 0.0), Vec3::new(1.05, -0.62, 0.0), Vec3::new(-0.05, 0.85, 0.0));
    Ok(Box::new(Weights { triangle }))
}

/// Shows the weights of the three corners.
struct Weights {
    triangle: Triangle,
}

impl Integrator for Weights {
    fn radiance(&self, point: FilmPoint, _random: &mut Stream, story: &mut impl Story) -> Rgb {
        let ray = straight_at(point);
        let hit = self.triangle.hit_by_barycentric(&Shear::along(&ray), Interval::POSITIVE);
        let Some(hit) = hit else {
            story.tell(|| "the ray misses the triangle".into());
            return Rgb::splat(0.012);
        };
        let weights = Rgb::from_array(hit.weights);
        story.tell(|| format!("(α, β, γ) = {}", triple(weights)));
        // Draw a line where a weight is within a hundredth of a multiple of a tenth.
        let tenths = weights * 10.0;
        let is_line = ((tenths - tenths.round()).abs().min_element()) < 0.045;
        if is_line { weights * 0.45 } else { weights }
    }
}
