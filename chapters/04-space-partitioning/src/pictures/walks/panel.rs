//! One panel: all cells of a structure, and the walk of the ray through them.

use common::{
    Interval, Rgb, Vec2, Vec3,
    drawing::{
        CHALK, Drawing, FAINT, SLATE,
        lettering::{Align, Lettering},
        mark::Pen,
    },
};
use ray_casting::{aabb::Aabb, ray::Ray};

use super::paper::{Paper, is_cut, seen};
use crate::{
    choice::Choice,
    pictures::palette::{RAY, RED, color},
    probe::Walk,
    query::Found,
    slabs::Slabs,
    structure::{Partition, Structure},
    triangles::Triangles,
};

/// Width and height of the scene in a panel, in units of the page.
pub(super) const SIDE: f32 = 300.0;
/// How much of the scene's surroundings is seen at each edge, as a share of its width.
const RIM: f32 = 0.03;
/// Cells that are not so wide have no room for a number, in units of the page.
const ROOM: f32 = 17.0;

/// The walk of a ray through a structure, on a page of its own; its name and its counts stand above the page.
pub(super) fn draw<T: Partition<Triangles>>(paper: &Paper, choice: Choice, partition: T, ray: &Ray) -> Drawing {
    let structure = Structure { primitives: paper.triangles.clone(), partition };
    let mut walk = Walk::default();
    let found = structure.nearest(ray, Interval::POSITIVE, &mut walk);
    // The cells that are seen, and of those the ones on the way of the ray, in its order.
    let cells = structure.partition.cells();
    let seen: Vec<(u32, Aabb)> = cells
        .iter()
        .filter(|cell| is_cut([cell.aabb.min.z, cell.aabb.max.z]))
        .map(|cell| (cell.number, cell.aabb))
        .collect();
    let on_way: Vec<Aabb> =
        walk.cells.iter().filter_map(|&number| Some(seen.iter().find(|cell| cell.0 == number)?.1)).collect();
    let mut panel = Drawing::new(Vec2::splat(SIDE), SLATE);
    draw_cells(&mut panel, &seen, &on_way, color(choice));
    draw_lines(&mut panel, paper, &walk, found);
    draw_ray(&mut panel, ray, found);
    draw_numbers(&mut panel, &on_way, color(choice));
    draw_title(&mut panel, choice, &walk, on_way.len());
    panel
}

/// Where a point of the scene lies in the panel.
fn place(point: Vec2) -> Vec2 {
    let share = (point + RIM) / (1.0 + 2.0 * RIM);
    Vec2::new(share.x, 1.0 - share.y) * SIDE
}

/// The corners of a cell as they are seen.
fn corners(cell: &Aabb) -> [Vec2; 4] {
    let (low, high) = (seen(cell.min), seen(cell.max));
    [low, Vec2::new(high.x, low.y), high, Vec2::new(low.x, high.y)].map(place)
}

/// Tints on the way, and a thin line around every cell.
fn draw_cells(panel: &mut Drawing, all: &[(u32, Aabb)], on_way: &[Aabb], color: Rgb) {
    for cell in on_way {
        panel.polygon(&corners(cell), color, 0.15);
    }
    for (_, cell) in all {
        outline(panel, cell, Pen::new(SLATE.lerp(color, 0.3), 1.0));
    }
    for cell in on_way {
        outline(panel, cell, Pen::new(color, 1.4));
    }
}

fn outline(panel: &mut Drawing, cell: &Aabb, pen: Pen) {
    let [a, b, c, d] = corners(cell);
    panel.line(&[a, b, c, d, a], pen);
}

/// The lines of the scene: red if they were tested, white and thick if hit.
fn draw_lines(panel: &mut Drawing, paper: &Paper, walk: &Walk, found: Option<Found>) {
    for (number, line) in (0..).zip(&paper.lines) {
        let line = line.map(place);
        let pen = if found.is_some_and(|found| found.number == number) {
            Pen::new(RAY, 4.6)
        } else if walk.tests.contains(&number) {
            Pen::new(RED, 3.4)
        } else {
            Pen::new(FAINT, 2.2)
        };
        panel.line(&line, pen);
    }
}

/// The ray up to its hit, or to the edge of the panel.
fn draw_ray(panel: &mut Drawing, ray: &Ray, found: Option<Found>) {
    let at = |t: f32| place(seen(ray.at(t)));
    let end = found.map_or_else(|| leaves(ray), |found| found.t);
    panel.line(&[at(0.0), at(end)], Pen::new(SLATE, 4.0)).line(&[at(0.0), at(end)], Pen::new(RAY, 2.0));
    panel.disc(at(0.0), 4.0, RAY);
    if found.is_some() {
        panel.disc(at(end), 6.0, SLATE).disc(at(end), 4.6, RAY);
    }
}

/// The `t` at which a ray leaves what is seen.
fn leaves(ray: &Ray) -> f32 {
    let edges = Aabb { min: Vec3::splat(-RIM), max: Vec3::splat(1.0 + RIM) };
    Slabs::of(ray).cross(&edges, Interval::POSITIVE).map_or(0.0, |inside| inside.max)
}

/// The number of each cell on the way, where there is room for it.
fn draw_numbers(panel: &mut Drawing, on_way: &[Aabb], color: Rgb) {
    let letters = Lettering::new(14.0, color.lerp(Rgb::ONE, 0.55));
    for (number, cell) in (1..).zip(on_way) {
        let [low, _, high, _] = corners(cell);
        let size = (high - low).abs();
        let text = format!("{number}");
        if size.min_element() >= ROOM && size.x > letters.width(&text) + 4.0 {
            let corner = Vec2::new(low.x + 2.5, high.y + 3.5 + 2.0 * letters.drop());
            panel.text(&text, corner, letters);
        }
    }
}

/// The name of the structure, and how many steps the ray took.
fn draw_title(panel: &mut Drawing, choice: Choice, walk: &Walk, leaves: usize) {
    let middle = Vec2::new(SIDE / 2.0, -50.0);
    panel.text(choice.name(), middle, Lettering::new(24.0, color(choice)).aligned(Align::Center));
    let (nodes, tests) = (walk.cells.len(), walk.tests.len());
    let cells = match choice {
        Choice::Grid => format!("{nodes} cells"),
        _ => format!("{nodes} nodes ({leaves} leaves)"),
    };
    let letters = Lettering::new(17.0, CHALK).aligned(Align::Center);
    panel.text(&format!("{cells}, {tests} tests"), middle + Vec2::Y * 26.0, letters);
}
