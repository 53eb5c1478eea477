//! The rendering loop in its plainest form.

use common::{
    Rgb, Vec2,
    film::Size,
    picture::{FilmPoint, Render},
    random::Stream,
};

// ANCHOR: render
/// Render a picture, one ray through the center of each pixel, row by row from the top.
///
/// The renderer of `common` does the same for many pixels at once, and several times for each.
#[must_use]
pub fn render(picture: &dyn Render, size: Size) -> Vec<Rgb> {
    let mut pixels = Vec::with_capacity(size.pixels());
    for y in 0..size.height() {
        for x in 0..size.width() {
            let position = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
            let point = FilmPoint { position, size: Vec2::new(size.width() as f32, size.height() as f32) };
            let mut random = Stream::new(0, pixels.len() as u64, 0);
            pixels.push(picture.sample(point, &mut random));
        }
    }
    pixels
}
// ANCHOR_END: render
