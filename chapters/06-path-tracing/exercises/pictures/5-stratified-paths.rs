//! Picture of exercise 6.5: light of one, two and three bounces, with independent points and with stratified ones.

use std::sync::Arc;

use common::{
    Error, Rgb, Stream, Vec2,
    drawing::{
        CHALK, Drawing, FAINT, SLATE,
        lettering::{Align, Lettering},
    },
    film::Size,
    picture::{FilmPoint, Integrator, ORBIT, Picture, Render, Settings},
    story::{Story, triple},
};
use path_tracing::{method::Method, path_tracer::PathTracer, pictures::room};

use crate::checks::pixel_means::{Points, Spread, Trace, independent, pixel_mean};

/// Makes a picture of what a user has chosen.
type Make = fn(&Settings) -> Result<Box<dyn Render>, Error>;

/// Rows of the grids: 36 samples per pixel.
const SIDE: u16 = 6;
/// The page, a panel, and where the first one stands.
const PAGE: Vec2 = Vec2::new(960.0, 490.0);
const PANEL: Vec2 = Vec2::new(304.0, 190.0);
const CORNER: Vec2 = Vec2::new(12.0, 34.0);
/// From one panel to the next.
const STEP: Vec2 = Vec2::new(316.0, 226.0);

/// The picture, made by `make`.
pub(crate) const fn picture(make: Make) -> Picture {
    Picture {
        name: "6.5-stratified-paths",
        alt: "A room with a red wall on the left and a blue one on the right, six times, with 36 samples per pixel. Above with \
              independent points, below with stratified ones; from left to right light of one, two and three bounces, brightened. \
              With one bounce the grain below is far finer than above; with two it is a little finer; with three it is the same.",
        knobs: &ORBIT,
        size: Size::of::<960, 490>(),
        samples: 1,
        takes_mesh: false,
        make,
    }
}

/// Panels with words above and below.
struct Sheet {
    drawing: Drawing,
    /// The tracer and the brightness of each column.
    columns: Vec<(PathTracer, f32)>,
    /// The points of each row.
    rows: [Points; 2],
    trace: Trace,
}

impl Sheet {
    /// The panel that a place of the page lies in, by column and row, and where in it.
    fn panel(&self, place: Vec2) -> Option<([usize; 2], Vec2)> {
        let from_corner = place - CORNER;
        let cell = (from_corner / STEP).floor();
        let local = from_corner - cell * STEP;
        let is_inside =
            cell.cmpge(Vec2::ZERO).all() && cell.cmplt(Vec2::new(3.0, 2.0)).all() && local.cmplt(PANEL).all();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 2")]
        is_inside.then_some(([cell.x as usize, cell.y as usize], local))
    }
}

impl Integrator for Sheet {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        // How many units of the page a pixel is wide and high.
        let unit = PAGE / point.size;
        let Some(([column, row], local)) = self.panel(self.drawing.place(point)) else {
            return self.drawing.radiance(point, random, story);
        };
        let (tracer, brightness) = &self.columns[column];
        let pixel = FilmPoint { position: (local / unit).floor(), size: PANEL / unit };
        let mean = pixel_mean(tracer, pixel, (self.rows[row], self.trace, SIDE), random);
        story.tell(|| format!("mean of {} paths: {}", SIDE * SIDE, triple(mean)));
        mean * *brightness
    }
}

/// The picture, its lower row with the student's points.
pub(crate) fn make(settings: &Settings, path_points: Points, trace: Trace) -> Result<Box<dyn Render>, Error> {
    let world = Arc::new(room::world_without_ball(room::Lamp::Abstract)?);
    let camera = room::view(settings)?;
    let mut drawing = Drawing::new(PAGE, SLATE);
    let mut columns = Vec::new();
    for (i, (bounces, brightness)) in (0_u8..).zip([(1, 1.0), (2, 2.0), (3, 4.0)]) {
        let method = Method { bounces: bounces..=bounces, roulette: false, ..Method::BEST };
        let tracer = PathTracer { world: Arc::clone(&world), camera, method };
        let variance = |points| Spread::measure(&tracer, (points, trace, SIDE), 100, 6).variance;
        let left = variance(path_points) / variance(independent);
        let title = if bounces == 1 { "light of 1 bounce".into() } else { format!("{bounces} bounces, brightened") };
        let middle = CORNER + Vec2::new(f32::from(i) * STEP.x + PANEL.x / 2.0, 0.0);
        let letters = |size, color| Lettering::new(size, color).aligned(Align::Center);
        drawing.text(&title, middle - Vec2::Y * 10.0, letters(18.0, CHALK));
        drawing.text("independent", middle + Vec2::Y * (PANEL.y + 22.0), letters(15.0, FAINT));
        let caption = format!("stratified: {:.0} % of the variance", left * 100.0);
        drawing.text(&caption, middle + Vec2::Y * (STEP.y + PANEL.y + 22.0), letters(15.0, FAINT));
        columns.push((tracer, brightness));
    }
    Ok(Box::new(Sheet { drawing, columns, rows: [independent, path_points], trace }))
}
