//! The numbers of chapter 4. All of them are counts: not one is a time.

use std::sync::Arc;

use common::{Interval, Vec2, Vec3, parallel, picture::FilmPoint};
use ray_casting::{aabb::Aabb, camera::Camera, hit::Hit, mesh::Mesh, ray::Ray};
use space_partitioning::{
    choice::{Choice, Countable},
    grid::{DENSITY, Grid},
    kd_tree::{
        KdTree,
        split::{Costs, Rule},
    },
    model::Part,
    octree::octree,
    primitives::Primitives,
    probe::{Counts, Walk},
    scenes::GENERATORS,
    slabs::Slabs,
    structure::{Partition, Structure},
    triangles::Triangles,
};

use super::{Numbers, grouped};
use crate::slope::slope;

/// How many triangles the scenes have, where nothing else is said.
const TRIANGLES: u32 = 20_000;
/// Sizes of the scenes whose growth is measured.
const SIZES: [u32; 3] = [1_000, 10_000, 100_000];
/// Cells for each triangle, in grids that are compared.
const DENSITIES: [f32; 4] = [0.25, 1.0, 4.0, 16.0];

/// A scene and the rays of its camera.
struct Scene {
    name: &'static str,
    mesh: Arc<Mesh>,
    parts: Vec<Part>,
    rays: Vec<Ray>,
}

impl Scene {
    fn of(name: &str, triangles: u32) -> Self {
        let generator = GENERATORS.iter().find(|generator| generator.name == name).unwrap();
        let model = (generator.make)(triangles);
        let view = model.view;
        let camera = Camera::new(view.eye, view.lookat, Vec3::Y, view.field_of_view).unwrap();
        let size = Vec2::new(32.0, 18.0);
        let at = |i: u16| Vec2::new(f32::from(i % 32) + 0.5, f32::from(i / 32) + 0.5);
        let rays = (0..32 * 18).map(|i| camera.ray(FilmPoint { position: at(i), size })).collect();
        let mesh = Arc::new(Mesh::new(&model.mesh, model.shading).unwrap());
        Self { name: generator.name, mesh, parts: model.parts, rays }
    }

    fn triangles(&self) -> Triangles {
        Triangles(Arc::clone(&self.mesh))
    }

    /// What the rays of the camera cost behind a structure.
    fn cost(&self, structure: &dyn Countable) -> Cost {
        let mut counts = Counts::default();
        self.rays.iter().for_each(|ray| counts += structure.count_nearest(ray, Interval::POSITIVE).1);
        Cost { counts, rays: self.rays.len() as f64 }
    }

    fn cost_of(&self, choice: Choice) -> Cost {
        self.cost(choice.over(Arc::clone(&self.mesh)).unwrap().as_ref())
    }

    fn kd_tree(&self, costs: Costs) -> Structure<Triangles, impl Partition<Triangles>> {
        let primitives = self.triangles();
        let partition = KdTree::over(&primitives, Rule::SurfaceArea(costs)).unwrap();
        Structure { primitives, partition }
    }

    fn grid(&self, density: f32) -> Structure<Triangles, Grid<<Triangles as Primitives>::Entry>> {
        let primitives = self.triangles();
        let partition = Grid::over(&primitives, density).unwrap();
        Structure { primitives, partition }
    }

    /// Mean number of tests if each part of the scene has a box of its own.
    fn tests_in_boxes(&self) -> f64 {
        let firsts = self.parts.iter().map(|part| part.first as usize);
        let ends = firsts.clone().skip(1).chain([self.mesh.len()]);
        let around = |triangles: std::ops::Range<usize>| {
            let corners: Vec<_> = triangles.flat_map(|i| self.mesh.triangle(i).corners).collect();
            Aabb::around(&corners).unwrap()
        };
        let boxes: Vec<_> = firsts.zip(ends).map(|(first, end)| (around(first..end), end - first)).collect();
        let tests = |ray: &Ray| -> usize {
            let slabs = Slabs::of(ray);
            let meets = |aabb: &Aabb| slabs.cross(aabb, Interval::POSITIVE).is_some();
            boxes.iter().filter(|(aabb, _)| meets(aabb)).map(|(_, count)| count).sum()
        };
        self.rays.iter().map(|ray| tests(ray) as f64).sum::<f64>() / self.rays.len() as f64
    }
}

/// What rays cost, all together.
struct Cost {
    counts: Counts,
    rays: f64,
}

impl Cost {
    fn tests(&self) -> f64 {
        self.counts.tests as f64 / self.rays
    }

    fn cells(&self) -> f64 {
        self.counts.cells as f64 / self.rays
    }

    fn steps(&self) -> f64 {
        self.counts.steps() as f64 / self.rays
    }
}

/// Triangles that are clipped as if they filled their boxes.
struct ByBoxes(Triangles);

impl Primitives for ByBoxes {
    type View = <Triangles as Primitives>::View;
    type Entry = <Triangles as Primitives>::Entry;

    fn count(&self) -> u32 {
        self.0.count()
    }

    fn aabb(&self, number: u32) -> Aabb {
        self.0.aabb(number)
    }

    fn entry(&self, number: u32) -> Self::Entry {
        self.0.entry(number)
    }

    fn number(&self, entry: &Self::Entry) -> u32 {
        self.0.number(entry)
    }

    fn view(&self, ray: &Ray) -> Self::View {
        self.0.view(ray)
    }

    fn intersect(&self, entry: &Self::Entry, view: &Self::View, range: Interval) -> Option<f32> {
        self.0.intersect(entry, view, range)
    }

    fn hit(&self, number: u32, ray: &Ray, t: f32) -> Option<Hit> {
        self.0.hit(number, ray, t)
    }
}

/// A structure of each kind over primitives.
fn all_three<P: Primitives + 'static>(primitives: impl Fn() -> P) -> [(Box<dyn Countable>, f64); 3]
where
    P::Entry: 'static,
{
    let kd = KdTree::over(&primitives(), Rule::default()).unwrap();
    [
        counted(Structure { primitives: primitives(), partition: Grid::over(&primitives(), DENSITY).unwrap() }),
        counted(octree(primitives()).unwrap()),
        counted(Structure { primitives: primitives(), partition: kd }),
    ]
}

/// A structure, and how many entries its lists have for each primitive.
fn counted<P: Primitives + 'static, T: Partition<P> + 'static>(
    structure: Structure<P, T>,
) -> (Box<dyn Countable>, f64) {
    let entries: usize = lengths(&structure).iter().sum();
    let share = entries as f64 / f64::from(structure.primitives.count());
    (Box::new(structure), share)
}

/// The lengths of all lists.
fn lengths<P: Primitives, T: Partition<P>>(structure: &Structure<P, T>) -> Vec<usize> {
    structure.cells().iter().map(|cell| cell.list.len()).collect()
}

/// A number with so many digits that it says something.
fn short(x: f64) -> String {
    if x >= 1000.0 {
        grouped(x.round() as u32)
    } else if x >= 100.0 {
        format!("{x:.0}")
    } else {
        format!("{x:.1}")
    }
}

/// How much more one thing is than another, in per cent.
fn more(one: f64, other: f64) -> String {
    format!("{:.0} %", 100.0 * (one / other - 1.0))
}

/// Mean number of nodes that rays visit in the kd-tree, and of lines of memory that these nodes are in.
fn nodes_and_lines(scene: &Scene) -> (f64, f64) {
    let tree = scene.kd_tree(Costs::default());
    let (mut nodes, mut lines) = (0, 0);
    for ray in &scene.rays {
        let mut walk = Walk::default();
        tree.nearest(ray, Interval::POSITIVE, &mut walk);
        nodes += walk.cells.len();
        let mut visited: Vec<_> = walk.cells.iter().map(|number| number / 8).collect();
        visited.sort_unstable();
        visited.dedup();
        lines += visited.len();
    }
    let rays = scene.rays.len() as f64;
    (nodes as f64 / rays, lines as f64 / rays)
}

pub(super) fn measured() -> String {
    let file = "Numbers in the text of chapter 4, made by tests/course/numbers/space_partitioning.rs.";
    let mut numbers = Numbers::titled(file);
    let scenes = parallel::map(GENERATORS.len(), |i| Scene::of(GENERATORS[i].name, TRIANGLES));
    let scene = |name: &str| scenes.iter().find(|scene| scene.name == name).unwrap();
    numbers.about("Each scene with about 20,000 triangles: how many exactly; then for each structure cells visited and triangles tested");
    numbers.0.push_str("# by a camera ray, mean over 32 × 18 of them.\n");
    let costs =
        parallel::map(scenes.len(), |i| Choice::STRUCTURES.iter().map(|c| scenes[i].cost_of(*c)).collect::<Vec<_>>());
    for (scene, costs) in scenes.iter().zip(&costs) {
        numbers.pin(&format!("{}-triangles", scene.name), grouped(scene.mesh.len() as u32));
        for (choice, cost) in Choice::STRUCTURES.iter().zip(costs) {
            numbers.pin(&format!("{}-{}-cells", scene.name, choice.name()), short(cost.cells()));
            numbers.pin(&format!("{}-{}-tests", scene.name, choice.name()), short(cost.tests()));
        }
    }
    numbers.about("The court, in a kd-tree that halves through the median.");
    let median = scene("court").cost_of(Choice::MedianKdTree);
    numbers.pin("court-median-kd-tree-tests", short(median.tests()));

    numbers
        .about("Entries of all lists for each triangle, and how many more tests there are if triangles are clipped as");
    numbers.0.push_str("# if they filled their boxes.\n");
    for name in ["mountain", "hair-ball"] {
        let scene = scene(name);
        let by_boxes = all_three(|| ByBoxes(scene.triangles()));
        let exact = all_three(|| scene.triangles());
        for (choice, (exact, by_boxes)) in Choice::STRUCTURES.iter().zip(exact.iter().zip(&by_boxes)) {
            let pin = format!("{name}-{}", choice.name());
            numbers.pin(&format!("{pin}-entries"), format!("{:.1}", exact.1));
            let [tests, box_tests] = [exact, by_boxes].map(|(structure, _)| scene.cost(structure.as_ref()).tests());
            numbers.pin(&format!("{pin}-boxes-tests"), more(box_tests, tests));
        }
    }
    numbers.about("The interior, each of its parts in a box of its own: parts, and triangles in the boxes that a camera ray meets.");
    let interior = scene("interior");
    numbers.pin("interior-parts", interior.parts.len());
    numbers.pin("interior-boxed-tests", short(interior.tests_in_boxes()));
    numbers.about("The stadium's grid: cells, triangles in the fullest of them, and cells that list nothing.");
    let lists = lengths(&scene("stadium").grid(DENSITY));
    let fullest = lists.iter().copied().max().unwrap_or(0);
    numbers.pin("stadium-grid-count", grouped(lists.len() as u32));
    numbers.pin("stadium-grid-fullest", grouped(fullest as u32));
    numbers.pin(
        "stadium-grid-empty",
        super::percent(lists.iter().filter(|&&n| n == 0).count() as u32, lists.len() as u32),
    );
    numbers.about("The mountain in grids of more and more cells for each triangle.");
    for density in DENSITIES {
        let cost = scene("mountain").cost(&scene("mountain").grid(density));
        numbers.pin(&format!("density-{density}-cells"), short(cost.cells()));
        numbers.pin(&format!("density-{density}-tests"), short(cost.tests()));
    }
    numbers.about("The stadium's kd-tree without a bonus for empty halves, and with a traversal that is taken to cost nothing or much.");
    let usual = Costs::default();
    for (what, costs) in [
        ("usual", usual),
        ("no-bonus", Costs { empty_bonus: 0.0, ..usual }),
        ("cheap", Costs { traversal: 0.1, ..usual }),
        ("dear", Costs { traversal: 10.0, ..usual }),
    ] {
        let tree = scene("stadium").kd_tree(costs);
        let cost = scene("stadium").cost(&tree);
        numbers.pin(&format!("stadium-{what}-cells"), short(cost.cells()));
        numbers.pin(&format!("stadium-{what}-tests"), short(cost.tests()));
        numbers.pin(&format!("stadium-{what}-leaves"), grouped(lengths(&tree).len() as u32));
    }
    numbers.about("The square's kd-tree: nodes that a camera ray visits, and lines of memory that they are in.");
    let (nodes, lines) = nodes_and_lines(scene("square"));
    numbers.pin("square-nodes", short(nodes));
    numbers.pin("square-lines", short(lines));
    numbers
        .about("Growth from 1,000 to 100,000 triangles: slope of the steps of a camera ray, on axes with logarithms.");
    for name in ["mountain", "stadium"] {
        let sizes = parallel::map(SIZES.len(), |i| Scene::of(name, SIZES[i]));
        for choice in Choice::STRUCTURES {
            let points = parallel::map(sizes.len(), |i| (sizes[i].mesh.len() as f64, sizes[i].cost_of(choice).steps()));
            numbers.pin(&format!("{name}-{}-slope", choice.name()), format!("{:.2}", slope(&points)));
        }
    }
    numbers.0
}
