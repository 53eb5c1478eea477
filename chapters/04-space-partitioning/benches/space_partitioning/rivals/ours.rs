//! The structures of the chapter.

use std::sync::Arc;

use space_partitioning::{
    choice::{Choice, Countable},
    workload::Cast,
};

use super::{Failure, Given, Rival, timed, traced};

struct Ours {
    choice: Choice,
    given: Arc<Given>,
    structure: Arc<dyn Countable>,
}

/// The three that the chapter teaches, the kd-tree first.
pub(super) fn all(given: &Arc<Given>) -> Vec<Box<dyn Rival>> {
    let mut rivals: Vec<Box<dyn Rival>> = Vec::new();
    for choice in [Choice::KdTree, Choice::Grid, Choice::Octree] {
        match choice.over(Arc::clone(&given.mesh)) {
            Ok(structure) => rivals.push(Box::new(Ours { choice, given: Arc::clone(given), structure })),
            Err(error) => println!("The {} takes no part: {error}", choice.name()),
        }
    }
    rivals
}

impl Rival for Ours {
    fn name(&self) -> &'static str {
        self.choice.name()
    }

    fn build(&mut self) -> Result<f64, Failure> {
        let (seconds, structure) = timed(|| self.choice.over(Arc::clone(&self.given.mesh)));
        self.structure = structure.map_err(|error| error.to_string())?;
        Ok(seconds)
    }

    fn bytes(&self) -> Option<usize> {
        Some(self.structure.bytes())
    }

    fn trace(&mut self) -> Result<f64, Failure> {
        Ok(traced(&self.given.rays, |cast| nearest(self.structure.as_ref(), cast)))
    }

    fn answers(&mut self) -> Result<Vec<f32>, Failure> {
        Ok(self.given.rays.iter().map(|cast| nearest(self.structure.as_ref(), cast)).collect())
    }
}

fn nearest(structure: &dyn Countable, cast: &Cast) -> f32 {
    structure.find(&cast.ray, cast.range).map_or(f32::INFINITY, |found| found.t)
}
