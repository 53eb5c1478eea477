//! The cover: the still life of chapter 1, now with shadows.

use common::{
    Error,
    film::Size,
    picture::{ORBIT, Picture, Render, Settings},
};
use ray_casting::pictures::still_life::{scene, view};

use crate::{direct_light::DirectLight, offset::Offset};

// ANCHOR: picture
pub(super) const PICTURE: Picture = Picture {
    name: "still-life",
    alt: "The still life of chapter 1, each thing with two shadows: a long cool one away from the sun on the left, and a \
          short warm one away from the lamp.",
    knobs: &ORBIT,
    size: Size::of::<960, 540>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let (scene, camera) = (scene()?, view(settings)?);
    Ok(Box::new(DirectLight { scene, camera, offset: Offset::Following }))
}
// ANCHOR_END: picture
