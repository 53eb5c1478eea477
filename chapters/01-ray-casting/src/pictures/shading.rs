//! One mesh, flat beside smooth.

use common::{
    Error,
    color::srgb,
    film::Size,
    picture::{ORBIT, Panels, Picture, Render, Settings},
};

use super::stage::{camera, pawn, stage};
use crate::{
    local_illumination::{LocalIllumination, Terms},
    material::Phong,
    mesh::{Mesh, Shading},
};

pub(super) const PICTURE: Picture = Picture {
    name: "flat-and-smooth",
    alt: "The same chess pawn twice. Left, shaded flat: every triangle is a facet of one brightness. Right, shaded \
          smooth: the surface looks round, and only the outline still shows its corners.",
    knobs: &ORBIT,
    size: Size::of::<960, 540>(),
    samples: 4,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let view = |shading| -> Result<Box<dyn Render>, Error> {
        let mut scene = stage()?;
        scene.add("pawn", Mesh::new(&pawn()?, shading)?, Phong::of(srgb(214, 196, 164), 0.45, 40.0));
        let camera = camera([0.0, 2.4, 5.6], [0.0, 1.0, 0.0], 25.0, &settings.values)?;
        Ok(Box::new(LocalIllumination { scene, camera, terms: Terms::ALL }))
    };
    Ok(Box::new(Panels::new(2, vec![view(Shading::Flat)?, view(Shading::Smooth)?])))
}
