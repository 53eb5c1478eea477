//! The same scene by uniform directions, and by cosine-distributed and mirror directions.

use common::{
    Error, Rgb, Stream, Vec2, Vec3,
    color::{luminance, srgb},
    drawing::{
        CHALK, Drawing, FAINT, SLATE,
        lettering::{Align, Lettering},
    },
    film::Size,
    float,
    knob::{Knob, Step},
    parallel,
    picture::{FilmPoint, Integrator, ORBIT, Picture, Render, Settings},
    story::{Story, Untold, triple},
};
use ray_casting::{
    background::Background, frame::Frame, material::Phong, pictures::stage, quadric::Quadric, scene::Scene,
    sphere::Sphere,
};
use whitted::material::Material;

use super::palette::{BLUE, GREEN};
use crate::{
    estimate::Estimate,
    sky_light::{Choice, SkyLight},
    unit_square::sample_unit_square,
};

/// The middle panels have so many samples, those before them one, those behind them the square.
const FACTOR: Knob =
    Knob::number("factor", "how many times as many samples from panel to panel", [2.0, 16.0], 10.0, "", Step::Whole);

pub(super) const PICTURE: Picture = Picture {
    name: "uniform-against-cosine",
    alt: "Six panels of the same still life under a morning sky: a gold and a silver ball, a red and a white matte \
          ball, a blue egg and a small green ball on a pale floor. Upper row, uniform directions with 1, 10 and 100 \
          samples per pixel: coarse noise that gets finer, and black balls where gold and silver should be. Lower \
          row, cosine-distributed and mirror directions: much less noise at the same number of samples, and both \
          metal balls are there, showing the sky and their neighbors without any noise of their own. Below each \
          panel stands its variance, which falls to a tenth from panel to panel and is smaller in the lower row.",
    knobs: &[FACTOR, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 580>(),
    samples: 1,
    takes_mesh: false,
    make,
};

/// The page; where the first panel stands, its size, and how far the next is from it.
const PAGE: Vec2 = Vec2::new(960.0, 580.0);
const FIRST: Vec2 = Vec2::new(12.0, 72.0);
const PANEL: Vec2 = Vec2::new(304.0, 200.0);
const NEXT: Vec2 = Vec2::new(316.0, 266.0);
/// Who looks.
const EYE: [f32; 3] = [0.0, 2.7, 5.7];
const LOOKAT: [f32; 3] = [0.05, 0.5, 0.1];
const FIELD_OF_VIEW: f32 = 22.0;
/// The two rows.
const ROWS: [(Choice, &str, Rgb); 2] = [
    (Choice::Uniform, "uniform directions", BLUE),
    (Choice::CosineAndMirror, "cosine-distributed and mirror directions", GREEN),
];

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let factor = settings.values.index(&FACTOR) as u32;
    let counts = [1, factor, factor * factor];
    let mut drawing = Drawing::new(PAGE, SLATE);
    let [uniform, cosine] = ROWS.map(|(choice, ..)| seen(choice, settings));
    let rows = [uniform?, cosine?];
    for (column, samples) in (0_u8..).zip(counts) {
        let middle = FIRST.x + PANEL.x / 2.0 + NEXT.x * f32::from(column);
        let name = if samples == 1 { "1 sample per pixel".into() } else { format!("{samples} samples per pixel") };
        drawing.text(&name, Vec2::new(middle, 28.0), Lettering::new(20.0, CHALK).aligned(Align::Center));
        for (row, lit) in (0_u8..).zip(&rows) {
            let below = Vec2::new(middle, FIRST.y + NEXT.y * f32::from(row) + PANEL.y + 24.0);
            let variance = format!("variance {}", figures(variance(lit, samples)));
            drawing.text(&variance, below, Lettering::new(17.0, FAINT).aligned(Align::Center));
        }
    }
    for (row, (_, name, color)) in (0_u8..).zip(ROWS) {
        let above = FIRST + Vec2::new(0.0, NEXT.y * f32::from(row) - 12.0);
        drawing.text(name, above, Lettering::new(18.0, color.lerp(Rgb::ONE, 0.2)));
    }
    Ok(Box::new(Compared { rows, counts, drawing }))
}

/// A number in figures: two digits that count.
fn figures(x: f64) -> String {
    let decimals = if x >= 0.095 {
        2
    } else if x >= 0.0095 {
        3
    } else if x >= 0.00095 {
        4
    } else {
        5
    };
    format!("{x:.decimals$}")
}

/// The things.
fn scene() -> Result<Scene<Material>, Error> {
    let matte = |color| Material::rough(Phong::of(color, 0.0, 1.0));
    let ball = |x: f32, z: f32, radius: f32| Sphere::new(Vec3::new(x, radius, z), radius);
    let egg = Quadric::ellipsoid(Vec3::new(0.4, 0.3, 0.3))
        .placed(Frame::at(Vec3::new(-0.62, 0.3, 1.0)).turned(Vec3::Y, 24.0));
    let mut scene = Scene::new();
    scene.surround(Morning);
    scene
        .add("floor", stage::square(0.0, 40.0)?, matte(srgb(206, 200, 192)))
        .add("gold", ball(-0.98, -0.35, 0.72), Material::GOLD)
        .add("silver", ball(1.22, -0.1, 0.58), Material::SILVER)
        .add("white", ball(0.22, -0.5, 0.5), matte(srgb(236, 232, 226)))
        .add("red", ball(0.38, 0.78, 0.34), matte(srgb(206, 48, 42)))
        .add("egg (ellipsoid)", egg, matte(srgb(44, 116, 190)))
        .add("green", ball(1.08, 1.05, 0.22), matte(srgb(70, 150, 74)));
    Ok(scene)
}

// ANCHOR: sky
/// A clear sky in the morning: bright blue above, warm toward the horizon, brightest on the left.
struct Morning;

impl Background for Morning {
    fn radiance(&self, direction: Vec3) -> Rgb {
        let direction = direction.normalize();
        let near = direction.dot(Vec3::new(-0.64, 0.6, 0.48)) / 2.0 + 0.5;
        let height = direction.y.max(0.0);
        let sky = Rgb::new(0.62, 0.52, 0.46).lerp(Rgb::new(0.34, 0.5, 0.82), height.sqrt());
        sky + Rgb::new(0.9, 0.74, 0.5) * float::pow(near, 4.0)
    }
}
// ANCHOR_END: sky

// ANCHOR: variance
/// The variance of a pixel's brightness from so many samples, measured over several runs, mean over a raster of pixels.
#[must_use]
pub fn variance(lit: &SkyLight, samples: u32) -> f64 {
    /// Pixels along both sides of the raster, and runs.
    const RASTER: [u16; 2] = [36, 24];
    const RUNS: u64 = 8;
    let [columns, rows] = RASTER;
    let size = Vec2::new(columns.into(), rows.into());
    let variances = parallel::map(usize::from(rows), |row| {
        let mut sum = 0.0;
        for column in 0..columns {
            let mut estimate = Estimate::default();
            #[expect(clippy::cast_precision_loss, reason = "few rows")]
            let position = Vec2::new(f32::from(column), row as f32) + 0.5;
            let ray = lit.camera.ray(FilmPoint { position, size });
            for run in 0..RUNS {
                let pixel = (row * usize::from(columns)) as u64 + u64::from(column);
                let mut random = Stream::new(u64::from(samples), pixel, run);
                let mean = (0..samples).map(|_| luminance(lit.trace(ray, &mut random, &mut Untold)));
                estimate.add(f64::from(mean.sum::<f32>()) / f64::from(samples));
            }
            sum += estimate.variance();
        }
        sum
    });
    variances.into_iter().sum::<f64>() / f64::from(size.x * size.y)
}
// ANCHOR_END: variance

/// The scene of the picture, and who looks at it.
///
/// # Errors
/// [`Error::Picture`] if the knobs leave no direction to look in.
pub fn seen(choice: Choice, settings: &Settings) -> Result<SkyLight, Error> {
    let camera = stage::camera(EYE, LOOKAT, FIELD_OF_VIEW, &settings.values)?;
    Ok(SkyLight { scene: scene()?, camera, choice })
}

/// The panels, and what is drawn around them.
struct Compared {
    rows: [SkyLight; 2],
    counts: [u32; 3],
    drawing: Drawing,
}

impl Integrator for Compared {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let place = self.drawing.place(point);
        let size = self.drawing.place(FilmPoint { position: point.position + 1.0, ..point }) - place;
        for (row, lit) in (0_u8..).zip(&self.rows) {
            for (column, samples) in (0_u8..).zip(self.counts) {
                let local = place - FIRST - NEXT * Vec2::new(column.into(), row.into());
                if local.cmpge(Vec2::ZERO).all() && local.cmplt(PANEL).all() {
                    let mut sum = Rgb::ZERO;
                    for sample in 0..samples {
                        // Several samples lie anywhere in the pixel, a lone one in its middle.
                        let offset = if samples == 1 { Vec2::ZERO } else { sample_unit_square(random) - 0.5 };
                        let ray = lit.camera.ray(FilmPoint { position: local + offset * size, size: PANEL });
                        // Only the first is told.
                        sum += if sample == 0 {
                            lit.trace(ray, random, story)
                        } else {
                            lit.trace(ray, random, &mut Untold)
                        };
                    }
                    let mean = sum / samples as f32;
                    story.tell(|| format!("mean of {samples} such samples: {}", triple(mean)));
                    return mean;
                }
            }
        }
        self.drawing.radiance(point, random, story)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ten_times_the_samples_have_a_tenth_of_the_variance_and_the_cosine_has_less() {
        let [uniform, cosine] = ROWS.map(|(choice, ..)| seen(choice, &Settings::default()).unwrap());
        let [one, ten] = [1, 10].map(|samples| variance(&uniform, samples));
        assert!((8.0..12.5).contains(&(one / ten)), "{one} {ten}");
        assert!(variance(&cosine, 1) < 0.7 * one, "{one}");
    }
}
