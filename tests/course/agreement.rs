//! Every structure finds the same as the loop over all triangles: the same triangle, at the same `t`, to the last bit.
//!
//! A million rays in the test run. A hundred million, and larger scenes, in the long run:
//! `LONG_RUN=1 cargo test --release -p tests agreement -- --nocapture`.

use std::sync::Arc;

use common::{
    Interval, Stream,
    film::Film,
    picture::Settings,
    renderer::{Plan, render},
};
use ray_casting::{aabb::Aabb, mesh::Mesh, ray::Ray};
use space_partitioning::{
    choice::{Choice, Countable},
    grid::grid,
    kd_tree::kd_tree,
    octree::octree,
    triangles::Triangles,
};

use crate::soups::{Aim, Soup, soups};

const PLAN: Plan = Plan { samples: 1, seed: 0, threads: 0 };

/// Whether the long run is wanted.
pub(crate) fn is_long_run() -> bool {
    std::env::var_os("LONG_RUN").is_some()
}

/// Some cells of all structures of a mesh.
fn cells(mesh: &Arc<Mesh>) -> Vec<Aabb> {
    let triangles = || Triangles(Arc::clone(mesh));
    let grid = grid(triangles()).unwrap();
    let octree = octree(triangles()).unwrap();
    let kd_tree = kd_tree(triangles()).unwrap();
    let all = [grid.cells(), octree.cells(), kd_tree.cells()];
    all.into_iter().flatten().map(|cell| cell.aabb).collect()
}

/// The structures of a mesh, brute force first.
struct Rivals(Vec<(Choice, Arc<dyn Countable>)>);

impl Rivals {
    fn of(mesh: &Arc<Mesh>) -> Self {
        Self(Choice::ALL.map(|choice| (choice, choice.over(Arc::clone(mesh)).unwrap())).into())
    }

    /// What is wrong with the answers to a ray.
    fn disagreement(&self, ray: &Ray, range: Interval) -> Option<String> {
        let (_, brute_force) = &self.0[0];
        let expected = brute_force.find(ray, range);
        for (choice, structure) in &self.0[1..] {
            let found = structure.find(ray, range);
            let same = found.map(|f| (f.number, f.t.to_bits())) == expected.map(|f| (f.number, f.t.to_bits()));
            let occluded = structure.occluded(ray, range);
            if !same || occluded != expected.is_some() {
                let name = choice.name();
                return Some(format!("{name}: {found:?}, occluded: {occluded}; brute force: {expected:?}; {ray:?}"));
            }
        }
        None
    }
}

/// Send rays at a soup and return those that are answered differently, and how many hit.
fn race(soup: &Soup, rays: u64, seed: u64) -> (Vec<String>, u64) {
    let cells = cells(&soup.mesh);
    let aim = Aim { mesh: &soup.mesh, cells: &cells };
    let rivals = Rivals::of(&soup.mesh);
    const CHUNK: u64 = 1000;
    let chunks = common::parallel::map(rays.div_ceil(CHUNK) as usize, |chunk| {
        let (mut wrong, mut hits) = (Vec::new(), 0);
        for i in 0..CHUNK {
            let number = chunk as u64 * CHUNK + i;
            let mut random = Stream::new(seed, 4, number);
            let ray = aim.ray(number, &mut random);
            // Every eighth ray ends somewhere, as a shadow ray does.
            let end = if number % 8 == 7 { soup.mesh.bounds().diagonal() * random.uniform() } else { f32::INFINITY };
            let range = Interval::POSITIVE.up_to(end);
            hits += u64::from(rivals.0[0].1.find(&ray, range).is_some());
            wrong.extend(rivals.disagreement(&ray, range));
        }
        (wrong, hits)
    });
    let hits = chunks.iter().map(|(_, hits)| hits).sum();
    (chunks.into_iter().flat_map(|(wrong, _)| wrong).collect(), hits)
}

#[test]
fn all_structures_agree_with_brute_force_to_the_last_bit() {
    let all: u64 = if is_long_run() { 100_000_000 } else { 1_000_000 };
    let soups = soups(&mut Stream::new(1, 2, 3));
    let each = all.div_ceil(soups.len() as u64);
    let (mut sent, mut hit, mut failures) = (0, 0, Vec::new());
    for (i, soup) in soups.iter().enumerate() {
        let (wrong, hits) = race(soup, each, i as u64);
        if is_long_run() {
            println!("{}: {} triangles, {each} rays, {hits} hits, {} wrong", soup.name, soup.mesh.len(), wrong.len());
            wrong.iter().for_each(|wrong| println!("    {wrong}"));
        }
        failures.extend(wrong.first().map(|first| format!("{}: {} rays, first {first}", soup.name, wrong.len())));
        sent += each;
        hit += hits;
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    // The rays were worth sending.
    assert!(sent >= all && hit > sent / 5 && hit < sent * 19 / 20, "{hit} of {sent} hit");
}

/// A structure that stops one cell too early is found out, so the rays above would find it out too.
#[test]
fn a_hit_behind_the_cell_must_not_end_the_walk() {
    // A large triangle behind a small one, listed in the cell in front of it.
    let corners =
        [[-1.0, -1.0, 0.9], [1.0, -1.0, 1.1], [0.0, 1.0, 1.0], [-0.1, -0.1, 0.6], [0.1, -0.1, 0.6], [0.0, 0.1, 0.6]];
    let soup = Soup::new("two", corners.map(common::Vec3::from).to_vec());
    let rivals = Rivals::of(&soup.mesh);
    let ray = Ray::new(common::Vec3::ZERO, common::Vec3::Z);
    assert_eq!(rivals.disagreement(&ray, Interval::POSITIVE), None);
    assert_eq!(rivals.0[0].1.find(&ray, Interval::POSITIVE).map(|found| found.number), Some(1));
}

/// Scenes of the size of the pictures, seen from where the pictures see them: fewer rays, since brute force is slow.
#[test]
fn all_structures_agree_on_larger_scenes() {
    let (triangles, rays) = if is_long_run() { (200_000, 2_000) } else { (20_000, 300) };
    for (i, generator) in space_partitioning::scenes::GENERATORS.iter().enumerate() {
        let mesh = Arc::new(Mesh::new(&(generator.make)(triangles).mesh, ray_casting::mesh::Shading::Flat).unwrap());
        let soup = Soup { name: generator.name.into(), mesh };
        let (wrong, hits) = race(&soup, rays, 100 + i as u64);
        assert!(wrong.is_empty(), "{}: {wrong:#?}", soup.name);
        assert!(hits > 0);
    }
}

/// Each pixel of a picture is the end of several rays: to the light, through leaves, off a wall. Not one may differ.
#[test]
fn every_structure_shows_the_same_picture() {
    let chapter = space_partitioning::CHAPTER;
    let scenes = chapter.pictures.iter().filter_map(|picture| {
        let knob = |name| picture.knobs.iter().find(|knob| knob.name == name);
        Some((picture, knob("structure")?, knob("triangles")?))
    });
    let mut count = 0;
    for (picture, structure, triangles) in scenes {
        let linear = |choice: Choice| {
            let mut settings = Settings::default();
            settings.values.set(triangles, 20_000.0);
            settings.values.set(structure, choice as usize as f32);
            let mut film = Film::new(picture.size.scaled_to(320));
            render((picture.make)(&settings).unwrap().as_ref(), &mut film, &PLAN, &());
            film.linear()
        };
        let expected = linear(Choice::KdTree);
        for choice in [Choice::Grid, Choice::Octree] {
            let differ = linear(choice).iter().zip(&expected).filter(|(a, b)| a != b).count();
            assert_eq!(differ, 0, "pixels of '{}' differ between {} and kd-tree", picture.name, choice.name());
        }
        count += 1;
    }
    assert_eq!(count, space_partitioning::scenes::GENERATORS.len());
}
