//! The picture contract: a chapter defines each picture once, and it appears on the command line, in the window, in
//! the snapshot tests and in the book.

use glam::{Vec2, Vec3};

use crate::{
    color::Rgb,
    error::Error,
    film::Size,
    knob::{Knob, Step, Values},
    obj::ObjMesh,
    random::Stream,
    report::Report,
    story::{Story, Told, Untold},
};

/// A chapter of the course: its name, its pictures, the cover first, and its reports.
#[derive(Clone, Copy, Debug)]
pub struct Chapter {
    /// Number in the course, from 1.
    pub number: u32,
    /// Name of its package: `cargo run -p name`.
    pub name: &'static str,
    /// Name for people.
    pub title: &'static str,
    /// Its pictures. The first one is the cover, and is what the chapter renders when nothing is said.
    pub pictures: &'static [Picture],
    /// What it tells in words and numbers.
    pub reports: &'static [Report],
}

impl Chapter {
    /// The picture of that name.
    #[must_use]
    pub fn picture(&self, name: &str) -> Option<&'static Picture> {
        self.pictures.iter().find(|p| p.name == name)
    }
}

// ANCHOR: picture
/// The definition of one picture.
#[derive(Clone, Copy, Debug)]
pub struct Picture {
    /// Name on the command line and of its files.
    pub name: &'static str,
    /// What is to be seen: its alt text in the book and its line in `--list`.
    pub alt: &'static str,
    /// The numbers that can be turned. Pictures with a camera include [`ORBIT`].
    pub knobs: &'static [Knob],
    /// Width and height in pixels when nothing is said.
    pub size: Size,
    /// Samples per pixel when nothing is said.
    pub samples: u32,
    /// Whether it can show a mesh that the user names with `--mesh FILE`.
    pub takes_mesh: bool,
    /// Builds the scene and the way to look at it.
    pub make: fn(&Settings) -> Result<Box<dyn Render>, Error>,
}
// ANCHOR_END: picture

/// What a user has chosen for a picture or a report.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    /// Values of the knobs.
    pub values: Values,
    /// The mesh that the user named.
    pub mesh: Option<ObjMesh>,
}

/// Turns the camera around what it looks at; the window moves these knobs by mouse.
pub const YAW: Knob =
    Knob::number("yaw", "camera turned around the vertical", [-180.0, 180.0], 0.0, "°", Step::Add(5.0));
/// Lifts the camera over what it looks at.
pub const PITCH: Knob = Knob::number("pitch", "camera lifted", [-90.0, 90.0], 0.0, "°", Step::Add(5.0));
/// Brings the camera nearer.
pub const ZOOM: Knob = Knob::number("zoom", "camera brought nearer", [0.1, 10.0], 1.0, "times", Step::Times(1.1));
/// The knobs of every picture that has a camera.
pub const ORBIT: [Knob; 3] = [YAW, PITCH, ZOOM];

/// A point of the film, in pixels: `x` to the right from the left edge, `y` down from the top edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FilmPoint {
    /// Position in pixels; the center of the first pixel is (½, ½).
    pub position: Vec2,
    /// Width and height of the film in pixels.
    pub size: Vec2,
}

impl FilmPoint {
    /// Normalised device coordinates: −1 to 1 from left to right and from bottom to top.
    #[must_use]
    pub fn ndc(&self) -> Vec2 {
        let Vec2 { x, y } = self.position / self.size * 2.0 - 1.0;
        Vec2::new(x, -y)
    }

    /// Width divided by height.
    #[must_use]
    pub fn aspect(&self) -> f32 {
        self.size.x / self.size.y
    }
}

// ANCHOR: integrator
/// Answers: what radiance arrives at this point of the film? (PBRT's word.)
///
/// Implement this; [`Render`] then comes for free.
pub trait Integrator: Send + Sync {
    /// An estimate of the linear RGB radiance that arrives at `point`, by chance from `random`, told to `story`.
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb;
}
// ANCHOR_END: integrator

/// The form of [`Integrator`] that can stand behind a pointer.
pub trait Render: Send + Sync {
    /// One sample, told to nobody.
    fn sample(&self, point: FilmPoint, random: &mut Stream) -> Rgb;

    /// The same sample with its story.
    fn explain(&self, point: FilmPoint, random: &mut Stream, story: &mut Told) -> Rgb;
}

impl<I: Integrator> Render for I {
    fn sample(&self, point: FilmPoint, random: &mut Stream) -> Rgb {
        self.radiance(point, random, &mut Untold)
    }

    fn explain(&self, point: FilmPoint, random: &mut Stream, story: &mut Told) -> Rgb {
        self.radiance(point, random, story)
    }
}

/// Several pictures in one, in rows and columns of equal size with a thin dark gap.
pub struct Panels {
    columns: usize,
    panels: Vec<Box<dyn Render>>,
}

impl Panels {
    /// Gap between panels, as a share of the film's width.
    const GAP: f32 = 0.006;

    /// Lay out `panels` from left to right, then from top to bottom.
    #[must_use]
    pub fn new(columns: usize, panels: Vec<Box<dyn Render>>) -> Self {
        Self { columns: columns.max(1), panels }
    }

    /// Which panel a film point lies in, and where there; `None` in a gap.
    fn locate(&self, point: FilmPoint) -> Option<(&dyn Render, FilmPoint)> {
        let columns = self.columns;
        let rows = self.panels.len().div_ceil(columns);
        let gap = Self::GAP * point.size.x;
        #[expect(clippy::cast_precision_loss, reason = "few panels")]
        let counts = Vec2::new(columns as f32, rows as f32);
        let size = (point.size - gap * (counts - 1.0)) / counts;
        let cell = (point.position / (size + gap)).floor();
        let position = point.position - cell * (size + gap);
        if position.x >= size.x || position.y >= size.y {
            return None;
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "few panels")]
        let index = cell.y as usize * columns + (cell.x as usize).min(columns - 1);
        Some((self.panels.get(index)?.as_ref(), FilmPoint { position, size }))
    }
}

impl Render for Panels {
    fn sample(&self, point: FilmPoint, random: &mut Stream) -> Rgb {
        self.locate(point).map_or(Vec3::ZERO, |(panel, point)| panel.sample(point, random))
    }

    fn explain(&self, point: FilmPoint, random: &mut Stream, story: &mut Told) -> Rgb {
        match self.locate(point) {
            Some((panel, point)) => panel.explain(point, random, story),
            None => {
                story.tell(|| "between two panels: black".into());
                Vec3::ZERO
            }
        }
    }
}
