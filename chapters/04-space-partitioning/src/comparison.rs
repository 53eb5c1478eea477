//! The comparison: what each structure costs to build, and what rays of each kind cost in it.

mod table;

use std::{
    sync::Arc,
    time::{Duration, Instant},
};

use common::{Error, parallel};
use ray_casting::mesh::Mesh;

use crate::{
    choice::{Choice, Countable},
    probe::Counts,
    viewed_mesh::ViewedMesh,
    workload::{Cast, RayKind, Workload},
};

/// Structures over the same triangles, asked by the same rays.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// Number of triangles.
    pub triangles: usize,
    /// Number of rays of each kind, in the order of [`RayKind::ALL`].
    pub rays: [usize; 3],
    /// What each structure costs.
    pub rows: Vec<Row>,
}

/// What a structure costs.
#[derive(Clone, Debug)]
pub struct Row {
    /// Which structure.
    pub choice: Choice,
    /// How long it took to build.
    pub build: Duration,
    /// Its memory, in bytes, beside that of the mesh.
    pub bytes: usize,
    /// What the rays of each kind cost, in the order of [`RayKind::ALL`].
    pub costs: [Cost; 3],
}

/// What all rays of a kind cost.
#[derive(Clone, Copy, Debug, Default)]
pub struct Cost {
    /// Their steps: the same on every machine.
    pub counts: Counts,
    /// How many of them hit something, and what: a number made of all answers.
    pub answers: (u64, u64),
    /// How long they took, all threads together: the median of some rounds.
    pub time: Duration,
}

/// All rays are timed so often. One round alone may be off by a quarter.
const ROUNDS: usize = 5;
/// Without a structure so many tests are bearable.
const MOST_TESTS: usize = 400_000_000;

impl Comparison {
    // ANCHOR: comparison
    /// Compare the structures by about `rays` rays of each kind. Each step is told to `progress` before it begins.
    ///
    /// # Errors
    /// [`Error::Picture`] if there is no structure over these triangles.
    pub fn new(viewed: &ViewedMesh, rays: u32, seed: u64, progress: &(dyn Fn(&str) + Sync)) -> Result<Self, Error> {
        let triangles = viewed.mesh.len();
        let with_brute_force = 3 * rays as usize * triangles <= MOST_TESTS;
        let choices = Choice::ALL.into_iter().filter(|choice| !choice.looks_at_everything() || with_brute_force);
        let mut built = Vec::new();
        for choice in choices {
            progress(&format!("Building: {} over {triangles} triangles", choice.name()));
            built.push(Built::new(choice, &viewed.mesh)?);
        }
        progress("Looking around: which rays there are");
        let shape = built.iter().find(|built| built.choice == Choice::KdTree).unwrap_or(&built[0]);
        let workload = Workload::new(viewed, shape.structure.as_ref(), rays, seed);
        for built in &mut built {
            progress(&format!("Counting the steps of {} rays: {}", workload.len(), built.choice.name()));
            built.count(&workload);
        }
        // In turn, so that whatever else the machine does meanwhile meets all of them.
        for round in 1..=ROUNDS {
            progress(&format!("Timing all rays in all structures: round {round} of {ROUNDS}"));
            for kind in RayKind::ALL {
                built.iter_mut().for_each(|built| built.time(kind, workload.casts(kind)));
            }
        }
        let rows = built.into_iter().map(Built::row).collect();
        Ok(Self { triangles, rays: RayKind::ALL.map(|kind| workload.casts(kind).len()), rows })
    }
    // ANCHOR_END: comparison

    /// Whether all structures gave the same answers.
    #[must_use]
    pub fn agrees(&self) -> bool {
        let answers = |row: &Row| row.costs.map(|cost| cost.answers);
        self.rows.windows(2).all(|pair| answers(&pair[0]) == answers(&pair[1]))
    }
}

/// A structure, and what is known about it so far.
struct Built {
    choice: Choice,
    structure: Arc<dyn Countable>,
    build: Duration,
    costs: [Cost; 3],
    /// How long the rays of each kind took in each round.
    rounds: [Vec<Duration>; 3],
}

impl Built {
    fn new(choice: Choice, mesh: &Arc<Mesh>) -> Result<Self, Error> {
        let start = Instant::now();
        let structure = choice.over(Arc::clone(mesh))?;
        Ok(Self { choice, structure, build: start.elapsed(), costs: Default::default(), rounds: Default::default() })
    }

    /// Count the steps of all rays.
    fn count(&mut self, workload: &Workload) {
        for kind in RayKind::ALL {
            let costs = on_all_threads(workload.casts(kind), |cast, cost: &mut Cost| {
                let (answer, counts) = count_one(self.structure.as_ref(), kind, cast);
                cost.counts += counts;
                cost.answers.0 += u64::from(answer != 0);
                cost.answers.1 = mixed(cost.answers.1, answer);
            });
            for Cost { counts, answers: (hits, mix), .. } in costs {
                let cost = &mut self.costs[kind as usize];
                cost.counts += counts;
                cost.answers = (cost.answers.0 + hits, mixed(cost.answers.1, mix));
            }
        }
    }

    /// Time one round of the rays of a kind.
    fn time(&mut self, kind: RayKind, casts: &[Cast]) {
        let structure = self.structure.as_ref();
        let start = Instant::now();
        let hits = on_all_threads(casts, |Cast { ray, range }, hits: &mut u64| {
            *hits += u64::from(match kind {
                RayKind::Shadow => structure.occluded(ray, *range),
                _ => structure.find(ray, *range).is_some(),
            });
        });
        // Nobody needs the hits any more, but the compiler must not know.
        std::hint::black_box(hits);
        self.rounds[kind as usize].push(start.elapsed());
    }

    fn row(self) -> Row {
        let Self { choice, structure, build, mut costs, rounds } = self;
        for (cost, mut times) in costs.iter_mut().zip(rounds) {
            times.sort_unstable();
            cost.time = times.get(times.len() / 2).copied().unwrap_or_default();
        }
        Row { choice, build, bytes: structure.bytes(), costs }
    }
}

/// The answer of a ray as a number, 0 for no hit, and its steps.
fn count_one(structure: &dyn Countable, kind: RayKind, Cast { ray, range }: &Cast) -> (u64, Counts) {
    if kind == RayKind::Shadow {
        let (is_hit, counts) = structure.count_any(ray, *range);
        return (u64::from(is_hit), counts);
    }
    let (found, counts) = structure.count_nearest(ray, *range);
    (found.map_or(0, |found| (u64::from(found.number) + 1) << 32 | u64::from(found.t.to_bits())), counts)
}

/// Both numbers in one, which depends on their order.
fn mixed(mix: u64, number: u64) -> u64 {
    (mix ^ number).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(29)
}

/// Sum up something over rays, by all threads, in pieces whose sums come in their order.
fn on_all_threads<S: Default + Send>(casts: &[Cast], add: impl Fn(&Cast, &mut S) + Send + Sync) -> Vec<S> {
    const PIECE: usize = 1024;
    let pieces: Vec<_> = casts.chunks(PIECE).collect();
    parallel::map(pieces.len(), |i| {
        let mut sum = S::default();
        pieces[i].iter().for_each(|cast| add(cast, &mut sum));
        sum
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::GENERATORS;

    fn compared(triangles: u32, rays: u32, threads: usize) -> Comparison {
        let viewed = ViewedMesh::of_model((GENERATORS[0].make)(triangles)).unwrap();
        parallel::with_threads(threads, || Comparison::new(&viewed, rays, 0, &|_| {})).unwrap()
    }

    #[test]
    fn structures_agree_and_threads_change_no_count() {
        let [one, three] = [1, 3].map(|threads| compared(1_000, 4_000, threads));
        assert!(one.agrees() && three.agrees());
        assert_eq!((one.rows.len(), one.rays), (Choice::ALL.len(), three.rays));
        for (a, b) in one.rows.iter().zip(&three.rows) {
            assert_eq!((a.choice, a.bytes), (b.choice, b.bytes));
            for (a, b) in a.costs.iter().zip(&b.costs) {
                assert_eq!((a.counts, a.answers), (b.counts, b.answers));
            }
        }
        // Whoever has no structure tests everything.
        let brute_force = &one.rows[Choice::BruteForce as usize].costs[0].counts;
        assert_eq!((brute_force.cells, brute_force.tests), (one.rays[0] as u64, (one.rays[0] * one.triangles) as u64));
        assert!(one.rows[1..].iter().all(|row| row.costs[0].counts.tests * 4 < brute_force.tests));
    }

    #[test]
    fn brute_force_is_left_out_where_it_takes_too_long() {
        let comparison = compared(100_000, 2_000, 0);
        assert!(comparison.rows.iter().all(|row| row.choice != Choice::BruteForce));
    }

    #[test]
    fn a_wrong_answer_is_noticed() {
        let mut comparison = compared(300, 1_000, 0);
        comparison.rows[2].costs[1].answers.1 ^= 1;
        assert!(!comparison.agrees());
    }
}
