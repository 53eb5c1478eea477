//! All structures over the same triangles, in a table.

use common::{
    Error,
    knob::{Knob, Step},
    report::{Report, Task, Told},
};

use crate::{comparison::Comparison, scenes, scenes::GENERATORS, viewed_mesh::ViewedMesh};

const SCENE: Knob = Knob::choice("scene", "what is looked at, without --mesh", &scenes::NAMES, 0);
const TRIANGLES: Knob = Knob::number(
    "triangles",
    "about how many triangles it has, without --mesh",
    [100.0, 20_000_000.0],
    100_000.0,
    "",
    Step::Whole,
);
const RAYS: Knob =
    Knob::number("rays", "about how many rays of each kind", [100.0, 2_000_000.0], 30_000.0, "", Step::Whole);

pub(super) const REPORT: Report = Report {
    name: "compare",
    what: "Compare the structures: build times, memory, steps and speed of rays",
    subject: None,
    knobs: &[SCENE, TRIANGLES, RAYS],
    takes_mesh: true,
    gives_files: false,
    make,
};

fn make(task: &Task) -> Result<Told, Error> {
    let (title, viewed) = viewed(task)?;
    #[expect(clippy::cast_possible_truncation, reason = "the knob's range is smaller")]
    let rays = task.settings.values.index(&RAYS) as u32;
    let comparison = Comparison::new(&viewed, rays, task.seed, task.progress)?;
    Ok(format!("{title}; triangles: {}\n\n{comparison}", comparison.triangles).into())
}

/// What is looked at, and what to call it.
fn viewed(task: &Task) -> Result<(String, ViewedMesh), Error> {
    let values = &task.settings.values;
    if let Some(mesh) = &task.settings.mesh {
        return Ok(("The mesh of the file".into(), ViewedMesh::of_file(mesh)?));
    }
    let generator = GENERATORS[values.index(&SCENE).min(GENERATORS.len() - 1)];
    #[expect(clippy::cast_possible_truncation, reason = "the knob's range is smaller")]
    let triangles = values.index(&TRIANGLES) as u32;
    (task.progress)(&format!("Making the scene: {} of about {triangles} triangles", generator.name));
    Ok((format!("Scene '{}'", generator.name), ViewedMesh::of_model((generator.make)(triangles))?))
}
