//! Three scenes, and in each another structure that loses.

mod bars;
mod scenes;

use std::sync::Arc;

use common::{
    Error, Interval, Rgb, Stream, Vec2, Vec3,
    drawing::{Drawing, SLATE},
    film::Size,
    knob::{Knob, Step},
    picture::{FilmPoint, Integrator, Picture, Render, Settings},
    story::Story,
};
use ray_casting::{camera::Camera, mesh::Mesh, pictures::stage::camera_error};

use self::scenes::SCENES;
use crate::{
    choice::{Choice, Countable},
    lit_model::LitModel,
    model::View,
    probe::Counts,
};

/// How many triangles each of the scenes has.
const TRIANGLES: Knob = Knob::number(
    "triangles",
    "about how many triangles each scene has",
    [500.0, 20_000.0],
    2000.0,
    "triangles",
    Step::Times(1.25),
);

pub(super) const PICTURE: Picture = Picture {
    name: "losers",
    alt: "Three scenes of about 2,000 triangles, and below each the mean number of steps of a camera ray in the \
          grid, the octree and the kd-tree as bars: cells visited dark, triangles tested bright. A teapot on a lawn \
          before far stands: the grid takes more than eight times as many steps as the others, nearly all of them \
          tests. A dandelion of thin triangles that meet in one point: the octree tests most of all triangles, the \
          others far fewer. An even cloud of small triangles: both trees take more than twice as many steps as the \
          grid. Bars at least twice as long as the shortest of their scene are marked in red as losers.",
    knobs: &[TRIANGLES],
    size: Size::of::<960, 468>(),
    samples: 4,
    takes_mesh: false,
    make,
};

/// The page.
const PAGE: Vec2 = Vec2::new(960.0, 468.0);
/// Where the first scene is seen, its size, and how far the next one is from it.
const FIRST: Vec2 = Vec2::new(15.0, 50.0);
const VIEW: Vec2 = Vec2::new(300.0, 200.0);
const NEXT: f32 = 315.0;
/// Rays in a row and rows of them, to count steps.
const RASTER: [u8; 2] = [48, 32];

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the knob's range is smaller")]
    let triangles = settings.values.number(&TRIANGLES) as u32;
    let mut drawing = Drawing::new(PAGE, SLATE);
    let mut views = Vec::new();
    let mut at = FIRST;
    for scene in &SCENES {
        let model = (scene.make)(triangles);
        let View { eye, lookat, field_of_view } = model.view;
        let camera = Camera::new(eye, lookat, Vec3::Y, field_of_view).map_err(camera_error)?;
        let mesh = Arc::new(Mesh::new(&model.mesh, model.shading)?);
        let view = LitModel::new(model, Choice::KdTree, camera)?;
        bars::draw(&mut drawing, scene, &steps(&mesh, view.structure.as_ref(), &camera)?, at);
        views.push(view);
        at.x += NEXT;
    }
    bars::draw_legend(&mut drawing);
    Ok(Box::new(Losers { drawing, views }))
}

/// Mean numbers of cells and tests of a camera ray, for each structure; one of them, the kd-tree, is there already.
fn steps(mesh: &Arc<Mesh>, kd_tree: &dyn Countable, camera: &Camera) -> Result<[[f32; 2]; 3], Error> {
    let [grid, octree] = [Choice::Grid, Choice::Octree].map(|choice| choice.over(Arc::clone(mesh)));
    Ok([means(grid?.as_ref(), camera), means(octree?.as_ref(), camera), means(kd_tree, camera)])
}

/// Mean numbers of cells and tests over a raster of camera rays.
fn means(structure: &dyn Countable, camera: &Camera) -> [f32; 2] {
    let [columns, rows] = RASTER;
    let size = Vec2::new(columns.into(), rows.into());
    let mut sum = Counts::default();
    for (x, y) in (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y))) {
        let position = Vec2::new(x.into(), y.into()) + 0.5;
        sum += structure.count_nearest(&camera.ray(FilmPoint { position, size }), Interval::POSITIVE).1;
    }
    [sum.cells, sum.tests].map(|count| count as f32 / (size.x * size.y))
}

/// The scenes, and what is drawn around them.
struct Losers {
    drawing: Drawing,
    views: Vec<LitModel>,
}

impl Integrator for Losers {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let place = self.drawing.place(point);
        let mut corner = FIRST;
        for view in &self.views {
            let position = place - corner;
            if position.cmpge(Vec2::ZERO).all() && position.cmplt(VIEW).all() {
                return view.radiance(FilmPoint { position, size: VIEW }, random, story);
            }
            corner.x += NEXT;
        }
        self.drawing.radiance(point, random, story)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The picture says who loses where, and so does its alt text.
    #[test]
    fn each_structure_loses_once() {
        for (i, scene) in SCENES.iter().enumerate() {
            let model = (scene.make)(2000);
            let View { eye, lookat, field_of_view } = model.view;
            let camera = Camera::new(eye, lookat, Vec3::Y, field_of_view).unwrap();
            let mesh = Arc::new(Mesh::new(&model.mesh, model.shading).unwrap());
            let kd_tree = Choice::KdTree.over(Arc::clone(&mesh)).unwrap();
            let steps = steps(&mesh, kd_tree.as_ref(), &camera).unwrap().map(|[cells, tests]| cells + tests);
            let best = steps.into_iter().fold(f32::INFINITY, f32::min);
            assert!(steps[i] >= bars::LOST * best, "{}: {steps:?}", scene.title);
            println!("{}: {steps:?}", scene.title);
        }
    }
}
