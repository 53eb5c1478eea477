//! How fast the structures of chapter 4 are, compared with others: `cargo bench -p space-partitioning`.
//!
//! It takes no benchmarking library. Single rounds scatter by 10 to 25 %, and more where other programs run: what was
//! measured a minute ago says nothing about now. So all rivals do the same in turn, round after round; each round gives a
//! ratio of two times that were measured side by side, and the median of these ratios is what is compared with a bound.
//! Rays are timed by what the processor spends on them, where the system tells it (Linux), builds by the clock.
//! Bounds are told, never enforced: whether the machine is busy is nobody's fault.

mod options;
mod results;
mod rivals;

use std::{process::ExitCode, sync::Arc};

use space_partitioning::{
    choice::{Choice, Countable},
    scenes::GENERATORS,
    viewed_mesh::ViewedMesh,
    workload::{Cast, RayKind, Workload},
};

use self::{
    options::Options,
    results::{Measured, Results},
    rivals::{Failure, Given, Rival},
};

fn main() -> ExitCode {
    let options = match Options::parse() {
        Ok(options) => options,
        Err(error) => error.exit(),
    };
    if let Err(failure) = run(&options) {
        println!("error: {failure}");
    }
    ExitCode::SUCCESS
}

fn run(options: &Options) -> Result<(), Failure> {
    let generator = GENERATORS.iter().find(|g| g.name == options.scene).ok_or("no such scene")?;
    let viewed = ViewedMesh::of_model((generator.make)(options.triangles)).map_err(|error| error.to_string())?;
    let kd_tree = Choice::KdTree.over(Arc::clone(&viewed.mesh)).map_err(|error| error.to_string())?;
    let [bounces, shadows] = rays(&viewed, kd_tree.as_ref(), options.rays as usize)?;
    println!(
        "Scene '{}', {} triangles; {} rays that bounce diffusely; rounds: {}.",
        generator.name,
        viewed.mesh.len(),
        bounces.len(),
        options.rounds
    );
    println!("Structures are built by {} threads, rays are traced by one.", common::parallel::threads());
    let given = Arc::new(Given { mesh: viewed.mesh, rays: bounces });
    let mut rivals = rivals::all(&given);
    let measured = rivals.iter_mut().map(|rival| Measured::new(rival.name())).collect();
    let mut results = Results { triangles: given.mesh.len(), rays: given.rays.len(), measured, occluded: Vec::new() };
    build(options, &mut rivals, &mut results)?;
    compare_answers(&mut rivals, &mut results)?;
    trace(options, &mut rivals, &mut results, &|| occluded(kd_tree.as_ref(), &shadows))?;
    print!("{results}");
    Ok(())
}

/// Bounce rays and as many shadow rays, or a few less.
fn rays(viewed: &ViewedMesh, structure: &dyn Countable, count: usize) -> Result<[Vec<Cast>; 2], Failure> {
    // Not every primary ray hits something: try again with more.
    let mut primary = count;
    for _ in 0..4 {
        let workload = Workload::new(viewed, structure, u32::try_from(primary).map_err(|e| e.to_string())?, 0);
        let [bounces, shadows] = [RayKind::Bounce, RayKind::Shadow].map(|kind| workload.casts(kind));
        let first = |rays: &[Cast]| rays[..count.min(rays.len())].to_vec();
        match bounces.len() {
            0 => break,
            enough if enough >= count => return Ok([first(bounces), first(shadows)]),
            few => primary = primary * count / few * 21 / 20 + 50,
        }
    }
    Err("too few rays hit anything".into())
}

/// All structures, built in turn.
fn build(options: &Options, rivals: &mut [Box<dyn Rival>], results: &mut Results) -> Result<(), Failure> {
    for round in 1..=options.rounds.clamp(1, 3) {
        println!("Building, round {round}");
        for (rival, measured) in rivals.iter_mut().zip(&mut results.measured) {
            measured.build.push(rival.build()?);
            measured.bytes = rival.bytes();
        }
    }
    Ok(())
}

/// Everybody must find what the first one finds.
fn compare_answers(rivals: &mut [Box<dyn Rival>], results: &mut Results) -> Result<(), Failure> {
    println!("Comparing the answers");
    let mut expected: Option<Vec<f32>> = None;
    for (rival, measured) in rivals.iter_mut().zip(&mut results.measured) {
        let answers = rival.answers()?;
        measured.compare(&answers, expected.get_or_insert_with(|| answers.clone()));
    }
    Ok(())
}

/// All rays, traced in turn.
fn trace(
    options: &Options,
    rivals: &mut [Box<dyn Rival>],
    results: &mut Results,
    occluded: &dyn Fn() -> f64,
) -> Result<(), Failure> {
    for round in 1..=options.rounds {
        println!("Tracing, round {round}");
        for (rival, measured) in rivals.iter_mut().zip(&mut results.measured) {
            measured.trace.push(rival.trace()?);
        }
        results.occluded.push(occluded());
    }
    Ok(())
}

/// Whether shadow rays are occluded: how many a second.
fn occluded(structure: &dyn Countable, shadows: &[Cast]) -> f64 {
    let is_occluded = |Cast { ray, range }: &&Cast| structure.occluded(ray, *range);
    let (seconds, hits) = rivals::timed_here(|| shadows.iter().filter(is_occluded).count());
    std::hint::black_box(hits);
    shadows.len() as f64 / seconds
}
