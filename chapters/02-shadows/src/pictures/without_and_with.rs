//! What shadows do for a picture.

use common::{
    Error,
    film::Size,
    picture::{ORBIT, Panels, Picture, Render, Settings},
};
use ray_casting::local_illumination::{LocalIllumination, Terms};

use super::still_life::{scene, view};
use crate::{direct_light::DirectLight, offset::Offset};

pub(super) const PICTURE: Picture = Picture {
    name: "without-and-with",
    alt: "The same still life twice, in the light of a low warm lamp on the left and a faint cool moon. Left, without \
          shadows: the things seem to float, and nobody can say where they stand. Right, with shadows: long ones \
          run to the right, over the floor and up the things behind, and tie everything to its place.",
    knobs: &ORBIT,
    size: Size::of::<960, 300>(),
    samples: 16,
    takes_mesh: false,
    make,
};

fn make(settings: &Settings) -> Result<Box<dyn Render>, Error> {
    let (scene, camera) = (self::scene()?, view(settings)?);
    let without = LocalIllumination { scene, camera, terms: Terms::ALL };
    let (scene, camera) = (self::scene()?, view(settings)?);
    let with = DirectLight { scene, camera, offset: Offset::Following };
    Ok(Box::new(Panels::new(2, vec![Box::new(without), Box::new(with)])))
}
