//! The cells of each structure, drawn around the surface that they hold.

mod wires;

use std::sync::Arc;

use common::{
    Error, Rgb, Stream, Vec2, Vec3,
    drawing::{
        CHALK, Drawing, SLATE,
        lettering::{Align, Lettering},
    },
    film::Size,
    knob::{Knob, Step},
    picture::{FilmPoint, Integrator, ORBIT, Picture, Render, Settings},
    story::Story,
};
use ray_casting::{
    camera::Camera,
    light::{DirectionalLight, Light},
    mesh::{Mesh, Shading},
    pictures::stage::camera_error,
};

use self::wires::Wires;
use super::palette::color;
use crate::{
    choice::Choice,
    grid::{DENSITY, Grid},
    kd_tree::{
        KdTree,
        split::{Costs, Rule},
    },
    lit_model::LitModel,
    model::{Model, View},
    octree::Octree,
    scenes::{builder::Builder, stadium::teapot::teapot},
    structure::Partition,
    triangles::Triangles,
};

/// How coarse the cells are.
const COARSE: Knob = Knob::number("coarse", "times as coarse as usual", [0.5, 64.0], 4.0, "times", Step::Times(2.0));
/// How many triangles the scene has.
const TRIANGLES: Knob =
    Knob::number("triangles", "about how many triangles", [200.0, 20_000.0], 2000.0, "triangles", Step::Times(1.25));

pub(super) const PICTURE: Picture = Picture {
    name: "cells",
    alt: "A red teapot three times, dimmed, with the cells around its surface as colored boxes of lines. The grid has \
          many blue cubes of one size, as fine around the smooth body as around spout, handle and knob. The octree has \
          fewer green cubes of several sizes, small where triangles crowd. The kd-tree has golden boxes of all shapes: \
          long and flat ones against the body, small ones along spout, handle and knob. Above each stand the numbers \
          of all its cells and of those that are not empty.",
    knobs: &[COARSE, TRIANGLES, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 340>(),
    samples: 4,
    takes_mesh: false,
    make,
};

/// The page.
const PAGE: Vec2 = Vec2::new(960.0, 340.0);
/// Where the first view stands, its size, and how far the next one is from it.
const FIRST: Vec2 = Vec2::new(9.0, 70.0);
const VIEW: Vec2 = Vec2::new(310.0, 260.0);
const NEXT: f32 = 316.0;
/// How much of its light the scene has left, so that the lines are seen.
const DIMMED: f32 = 0.5;

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let (coarse, triangles) = (settings.values.number(&COARSE), settings.values.number(&TRIANGLES));
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the knobs' ranges are smaller")]
    let (few, triangles) = ((crate::octree::FEW as f32 * coarse) as usize, triangles as u32);
    let model = model(triangles);
    let view = model.view;
    let camera = Camera::orbited(view.eye, view.lookat, view.field_of_view, &settings.values).map_err(camera_error)?;
    let mesh = Triangles(Arc::new(Mesh::new(&model.mesh, model.shading)?));
    let scene = LitModel::new(model, Choice::KdTree, camera)?;
    // The structures, all of them as much coarser.
    let usual = Costs::default();
    let rule = Rule::SurfaceArea(Costs { traversal: usual.traversal * coarse, ..usual });
    let wires = Wires { camera: &camera, scene: scene.structure.as_ref(), size: VIEW };
    let mut page = Drawing::new(PAGE, SLATE);
    let wires = [
        draw(Choice::Grid, &Grid::over(&mesh, DENSITY / coarse)?, &wires, &mut page),
        draw(Choice::Octree, &Octree::over(&mesh, few)?, &wires, &mut page),
        draw(Choice::KdTree, &KdTree::over(&mesh, rule)?, &wires, &mut page),
    ];
    Ok(Box::new(Cells { scene, page, wires }))
}

/// A teapot in the air.
fn model(triangles: u32) -> Model {
    let sun = |direction, irradiance| -> Box<dyn Light> { Box::new(DirectionalLight::new(direction, irradiance)) };
    let mut builder = Builder::default();
    teapot(&mut builder, triangles);
    // A little flatter, so that the knob of its lid does not just reach into the upper half of the octree.
    for position in &mut builder.mesh.positions {
        position.y *= 0.95;
    }
    Model {
        mesh: builder.mesh,
        shading: Shading::Smooth,
        parts: builder.parts,
        view: View { eye: Vec3::new(0.3, 0.4, 0.72), lookat: Vec3::new(0.012, 0.12, 0.0), field_of_view: 31.0 },
        lights: vec![
            sun(Vec3::new(-0.5, 1.0, 0.6), Rgb::new(3.4, 3.2, 2.9)),
            sun(Vec3::new(1.0, 0.1, 0.7), Rgb::new(0.6, 0.7, 0.9)),
        ],
        ambient: Rgb::new(0.16, 0.17, 0.2),
        background: SLATE,
    }
}

/// The lines of a structure's cells that are not empty. Its name goes on the page.
fn draw(choice: Choice, partition: &impl Partition<Triangles>, wires: &Wires<'_>, page: &mut Drawing) -> Drawing {
    let cells = partition.cells();
    let full: Vec<_> = cells.iter().filter(|cell| !cell.list.is_empty()).map(|cell| cell.aabb).collect();
    let place = Choice::STRUCTURES.iter().position(|other| *other == choice).unwrap_or(0);
    let middle = FIRST + Vec2::new(VIEW.x / 2.0 + place as f32 * NEXT, -40.0);
    page.text(choice.name(), middle, Lettering::new(24.0, color(choice)).aligned(Align::Center));
    let words = format!("{} cells, {} not empty", cells.len(), full.len());
    page.text(&words, middle + Vec2::Y * 26.0, Lettering::new(17.0, CHALK).aligned(Align::Center));
    wires.draw(&full, color(choice))
}

/// The scene once for each structure, with the lines over it.
struct Cells {
    scene: LitModel,
    /// The names.
    page: Drawing,
    wires: [Drawing; 3],
}

impl Integrator for Cells {
    fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
        let pixel = (PAGE / point.size).max_element();
        let page_on_film = (point.size - PAGE / pixel) / 2.0;
        let mut corner = FIRST;
        for wires in &self.wires {
            // The view's part of the film, in whole pixels, so that lines are as crisp as they can be.
            let at = (page_on_film + corner / pixel).round();
            let view = FilmPoint { position: point.position - at, size: (VIEW / pixel).round() };
            if view.position.cmpge(Vec2::ZERO).all() && view.position.cmplt(view.size).all() {
                let scene = self.scene.radiance(view, random, story);
                return wires.over(SLATE.lerp(scene, DIMMED), view);
            }
            corner.x += NEXT;
        }
        self.page.radiance(point, random, story)
    }
}
