//! Picture of exercise 6.4: four lamps in three ways, and what each way costs.

use std::sync::Arc;

use common::{
    Error, Rgb, Stream, Vec2, Vec3,
    drawing::{
        CHALK, Drawing, FAINT, SLATE,
        lettering::{Align, Lettering},
        mark::Pen,
        plot::{Axis, Curve, Legend, Plot, Scale},
    },
    film::Size,
    picture::{FilmPoint, Integrator, Picture, Render},
    story::{Story, number, triple},
};
use ray_casting::{hit::Hit, ray::Ray, scene::Scene};
use sampling::unit_square::sample_unit_square;

use super::Make;
use crate::checks::{
    asked_or_found::Answer,
    effort::{Effort, HALVES, WAYS},
    lamp::Lamp,
    lamp_exact::irradiance,
    place::Place,
};

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    let alt = "Above, three panels with the same floor below four lamps, which are larger from left to right: four bright spots, the first \
               round, the last a large square. Asked: the small spots are smooth, and the large one is speckled. Found: the large one \
               is smooth, and the small ones are clouds of bright dots. Combined: all of them are nearly smooth. Below, a plot of the \
               rays that an error of 10 % takes, over the side of the lamp: the line of asking rises, that of finding falls, they \
               cross, and that of the combination stays below 40 everywhere.";
    Picture { knobs: &[], size: Size::of::<960, 620>(), samples: 1, ..super::picture("6.4-asked-or-found", alt, make) }
}

/// The page, a panel, and where the first panel begins.
const PAGE: Vec2 = Vec2::new(960.0, 620.0);
const PANEL: Vec2 = Vec2::new(304.0, 190.0);
const CORNER: Vec2 = Vec2::new(12.0, 38.0);
/// Rays for each pixel and lamp.
const RAYS: u8 = 8;
/// The range of the plot's axis. What lies outside is not drawn.
const RANGE: [f32; 2] = [0.01, 100_000.0];
/// A color for each way.
const COLORS: [Rgb; 3] = [Rgb::new(1.0, 0.36, 0.10), Rgb::new(0.15, 0.56, 1.0), Rgb::new(0.95, 0.86, 0.42)];

/// Scene units that a panel is wide, and how high the lamps hang above the floor.
const WIDE: f32 = 6.4;
const HEIGHT: f32 = 0.25;

/// Four lamps in three ways above a plot.
struct Sheet {
    answer: Answer,
    lamps: [Lamp; 4],
    /// Nothing stands between the floor and the lamps.
    nothing: Arc<Scene<()>>,
    drawing: Drawing,
}

impl Sheet {
    /// The floor from above, by a pair of rays to each lamp. The lamps are not drawn.
    fn color(&self, way: usize, local: Vec2, random: &mut Stream) -> Rgb {
        let floor = (local - PANEL / 2.0) * (WIDE / PANEL.x);
        let down = Ray::new(Vec3::new(floor.x, HEIGHT / 2.0, floor.y), -Vec3::Y);
        let hit = Hit::new(&down, HEIGHT / 2.0, Vec3::Y);
        let mut light = Rgb::ZERO;
        for lamp in self.lamps {
            let place = Place::new(hit, lamp, Arc::clone(&self.nothing));
            let mut point = || sample_unit_square(random);
            light += lamp.radiance
                * match way {
                    0 => ((self.answer.asked)(&place, point()) + (self.answer.asked)(&place, point())) / 2.0,
                    1 => ((self.answer.found)(&place, point()) + (self.answer.found)(&place, point())) / 2.0,
                    // One sample takes as many rays as two of the others.
                    _ => (self.answer.combined)(&place, point(), point()),
                };
        }
        light
    }
}

impl Integrator for Sheet {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let place = self.drawing.place(point);
        for (way, (name, _)) in WAYS.into_iter().enumerate() {
            let local = place - corner(way);
            if local.cmpge(Vec2::ZERO).all() && local.cmplt(PANEL).all() {
                let count = RAYS / 2;
                let sum: Rgb = (0..count)
                    .map(|_| {
                        let jitter = sample_unit_square(random) - 0.5;
                        self.color(way, local + jitter, random)
                    })
                    .sum();
                let mean = sum / f32::from(count);
                story.tell(|| {
                    format!("{name}: the mean of {} pairs of rays is {}", number(f32::from(count)), triple(mean))
                });
                return mean;
            }
        }
        self.drawing.radiance(point, random, story)
    }
}

/// The upper left corner of a panel.
fn corner(way: usize) -> Vec2 {
    #[expect(clippy::cast_precision_loss, reason = "three")]
    let way = way as f32;
    CORNER + Vec2::X * way * (PANEL.x + 12.0)
}

/// The lamps and the plot, by the student's samples.
pub(crate) fn make(answer: Answer) -> Result<Box<dyn Render>, Error> {
    // Each of them gives the same light to the floor below its middle.
    #[expect(clippy::cast_possible_truncation, reason = "a color")]
    let lamp = |x: f32, half: f32| {
        let lamp = Lamp::around(Vec3::new(x, HEIGHT, 0.0), [Vec3::X * half, Vec3::Z * half], Rgb::ONE);
        let received = irradiance(&lamp, Vec3::X * x, Vec3::Y) as f32;
        Lamp { radiance: Rgb::new(0.62, 0.5, 0.36) / received, ..lamp }
    };
    let lamps = [lamp(-2.5, 0.02), lamp(-1.5, 0.1), lamp(-0.3, 0.36), lamp(1.75, 1.2)];
    let mut drawing = Drawing::new(PAGE, SLATE);
    for (way, (name, _)) in WAYS.into_iter().enumerate() {
        let letters = Lettering::new(18.0, CHALK).aligned(Align::Center);
        drawing.text(name, corner(way) + Vec2::new(PANEL.x / 2.0, -12.0), letters);
    }
    let below = Lettering::new(15.0, FAINT).aligned(Align::Center);
    let caption = format!("the floor below four lamps, from above, with {RAYS} rays per pixel and lamp");
    drawing.text(&caption, Vec2::new(PAGE.x / 2.0, CORNER.y + PANEL.y + 22.0), below);
    drawing.paste(plot(answer).drawing(), Vec2::new(0.0, CORNER.y + PANEL.y + 30.0));
    Ok(Box::new(Sheet { answer, lamps, nothing: Arc::default(), drawing }))
}

/// Rays over the side of the lamp.
fn plot(answer: Answer) -> Plot {
    let efforts = HALVES.map(|half| Effort::measure(answer, half));
    let curve = |way: usize| {
        #[expect(clippy::cast_possible_truncation, reason = "a plot")]
        let point = |effort: &Effort| Vec2::new(2.0 * effort.half, effort.rays[way] as f32);
        let points = efforts.iter().map(point).filter(|point| (RANGE[0]..RANGE[1]).contains(&point.y)).collect();
        Curve { points, pen: Pen::new(COLORS[way], 2.6) }
    };
    let keys = (0..WAYS.len()).map(|way| (Pen::new(COLORS[way], 2.6), WAYS[way].0)).collect();
    Plot {
        page: Vec2::new(PAGE.x, PAGE.y - CORNER.y - PANEL.y - 30.0),
        x: Axis { name: "side of the lamp, at height 1", unit: "", range: [0.1, 25.6], scale: Scale::Logarithmic },
        y: Axis { name: "rays for an error of 10 %", unit: "", range: RANGE, scale: Scale::Logarithmic },
        curves: (0..WAYS.len()).map(curve).collect(),
        legends: vec![Legend { at: Vec2::new(1.2, 50_000.0), keys }],
    }
}
