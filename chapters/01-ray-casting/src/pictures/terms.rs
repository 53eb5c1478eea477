//! The terms of local illumination, one by one and together.

use common::{
    Error,
    film::Size,
    knob::Knob,
    picture::{ORBIT, Panels, Picture, Render, Settings},
};

use super::still_life;
use crate::local_illumination::{LocalIllumination, Terms};

const TERM: Knob =
    Knob::choice("term", "which terms are shown", &["all four", "ambient", "diffuse", "specular", "sum"], 0);

pub(super) const PICTURE: Picture = Picture {
    name: "terms",
    alt: "The still life four times. Upper left, ambient only: flat, dark silhouettes of each thing's color. Upper \
          right, diffuse only: soft shading, no highlights. Lower left, specular only: nothing but highlights on \
          black. Lower right, the sum of the three.",
    knobs: &[TERM, ORBIT[0], ORBIT[1], ORBIT[2]],
    size: Size::of::<960, 540>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    const ONE_BY_ONE: [Terms; 4] = [
        Terms { ambient: true, ..Terms::NONE },
        Terms { diffuse: true, ..Terms::NONE },
        Terms { specular: true, ..Terms::NONE },
        Terms::ALL,
    ];
    let view = |terms: Terms| -> Result<Box<dyn Render>, Error> {
        let mut scene = still_life::scene()?;
        // The background counts as ambient light, so that the parts add up to the sum.
        if !terms.ambient {
            scene.surround(common::Rgb::ZERO);
        }
        Ok(Box::new(LocalIllumination { scene, camera: still_life::view(settings)?, terms }))
    };
    Ok(match settings.values.index(&TERM) {
        i @ 1..=4 => view(ONE_BY_ONE[i - 1])?,
        _ => Box::new(Panels::new(2, ONE_BY_ONE.into_iter().map(view).collect::<Result<_, _>>()?)),
    })
}
