//! What was measured once, kept in a file beside this one: the numbers behind the plots.

use crate::{choice::Choice, growth::Row, probe::Counts};

/// One structure over one scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// What was counted.
    pub row: Row,
    /// Seconds to build the structure, in one thread.
    pub build: f32,
    /// Seconds for one ray, the mean, in one thread.
    pub ray: f32,
}

/// The file that `cargo run --release -p space-partitioning --example space-partitioning-measure` prints.
const GROWTH: &str = include_str!("measured/growth.csv");

/// The names of the columns, in their order.
pub const COLUMNS: &str = "structure,triangles,rays,cells,tests,hits,bytes,build_seconds,ray_seconds";

/// All structures over scenes of growing size.
#[must_use]
pub fn growth() -> Vec<Measured> {
    rows(GROWTH).filter_map(Measured::read).collect()
}

/// The lines behind the columns' names.
fn rows(file: &str) -> impl Iterator<Item = &str> {
    file.lines().skip_while(|line| *line != COLUMNS).skip(1)
}

impl Measured {
    /// A line of the file.
    fn read(line: &str) -> Option<Self> {
        let [name, triangles, rays, cells, tests, hits, bytes, build, ray] =
            line.split(',').collect::<Vec<_>>().try_into().ok()?;
        let choice = Choice::ALL.into_iter().find(|choice| choice.name() == name)?;
        let [triangles, rays, bytes] = [triangles, rays, bytes].map(|number| number.parse().ok());
        let [cells, tests, hits] = [cells, tests, hits].map(|number| number.parse().ok());
        let counts = Counts { cells: cells?, tests: tests?, hits: hits? };
        let row = Row { choice, triangles: triangles?, rays: rays?, counts, bytes: bytes? };
        Some(Self { row, build: build.parse().ok()?, ray: ray.parse().ok()? })
    }

    /// The line of the table, as [`growth`] reads it.
    #[must_use]
    pub fn line(&self) -> String {
        let Row { choice, triangles, rays, counts, bytes } = self.row;
        let Counts { cells, tests, hits } = counts;
        let (name, build, ray) = (choice.name(), self.build, self.ray);
        format!("{name},{triangles},{rays},{cells},{tests},{hits},{bytes},{build:.3e},{ray:.3e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::growth::SIZES;

    #[test]
    fn every_line_of_the_file_can_be_read() {
        let growth = growth();
        assert_eq!(growth.len(), rows(GROWTH).count());
        for measured in &growth {
            assert!(measured.build > 0.0 && measured.ray > 0.0, "{measured:?}");
            assert_eq!(Measured::read(&measured.line()), Some(*measured));
        }
        for choice in Choice::STRUCTURES {
            assert_eq!(growth.iter().filter(|measured| measured.row.choice == choice).count(), SIZES.len());
        }
    }
}
