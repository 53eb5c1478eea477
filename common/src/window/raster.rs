//! A rectangle of screen pixels, each 0x00RRGGBB.

use crate::{
    color::{Rgb, to_byte},
    film::{Size, Tile},
};

/// Pixels row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Raster {
    width: usize,
    height: usize,
    pixels: Vec<u32>,
}

/// A linear color as a screen pixel.
pub(crate) fn screen(color: Rgb) -> u32 {
    let [r, g, b] = color.to_array().map(to_byte);
    u32::from_be_bytes([0, r, g, b])
}

impl Raster {
    /// A black rectangle.
    pub(crate) fn new(width: usize, height: usize) -> Self {
        Self { width, height, pixels: vec![0; width * height] }
    }

    /// A black rectangle as large as a film.
    pub(crate) fn of(size: Size) -> Self {
        Self::new(size.width() as usize, size.height() as usize)
    }

    /// Width and height.
    pub(crate) fn size(&self) -> (usize, usize) {
        (self.width, self.height)
    }

    /// All pixels, row by row from the top.
    pub(crate) fn pixels(&self) -> &[u32] {
        &self.pixels
    }

    /// The part of row `y` that starts at column `x` and has `width` pixels, as far as it lies inside.
    pub(crate) fn row_mut(&mut self, x: usize, y: usize, width: usize) -> &mut [u32] {
        let (left, right) = (x.min(self.width), (x + width).min(self.width));
        let start = y * self.width;
        self.pixels.get_mut(start + left..start + right).unwrap_or_default()
    }

    /// Become a copy of `other` without asking for memory when the sizes agree.
    pub(crate) fn copy(&mut self, other: &Self) {
        (self.width, self.height) = other.size();
        self.pixels.clone_from(&other.pixels);
    }

    /// Take a tile of a film of the same size, its pixels already developed.
    pub(crate) fn put(&mut self, tile: &Tile, developed: &[u32]) {
        for ((x, y, row), from) in tile.rows().zip(developed.chunks(tile.width as usize)) {
            for (to, from) in self.row_mut(x as usize, y as usize, row.len()).iter_mut().zip(from) {
                *to = *from;
            }
        }
    }

    /// Another size of the same pixels.
    pub(crate) fn stretched(&self, size: Size) -> Self {
        let mut target = Self::of(size);
        let (width, height) = target.size();
        target.draw(self, (0, 0), (width, height));
        target
    }

    /// Show `picture` as large as it fits with its shape kept, in the middle of black.
    pub(crate) fn fit(&mut self, picture: &Self) {
        let (width, height) = fitted(picture.size(), self.size());
        let corner = ((self.width - width) / 2, (self.height - height) / 2);
        if (width, height) != self.size() {
            self.pixels.fill(0);
        }
        self.draw(picture, corner, (width, height));
    }

    /// Draw `from` into the rectangle at `corner` of that size: smaller as means of pixels, larger as squares.
    fn draw(&mut self, from: &Self, corner: (usize, usize), (width, height): (usize, usize)) {
        // Which pixels of `from` become pixel `i` of `n`.
        let span = |i: usize, n: usize, of: usize| (i * of / n, ((i + 1) * of / n).max(i * of / n + 1));
        let columns: Vec<_> = (0..width).map(|x| span(x, width, from.width)).collect();
        for y in 0..height {
            let (top, bottom) = span(y, height, from.height);
            for (to, &(left, right)) in self.row_mut(corner.0, corner.1 + y, width).iter_mut().zip(&columns) {
                *to = if (right - left, bottom - top) == (1, 1) {
                    from.pixels[top * from.width + left]
                } else {
                    mean((top..bottom).flat_map(|y| &from.pixels[y * from.width..][left..right]))
                };
            }
        }
    }
}

/// The largest size of the same shape that fits.
fn fitted((width, height): (usize, usize), (into_width, into_height): (usize, usize)) -> (usize, usize) {
    if into_width * height <= into_height * width {
        (into_width, (into_width * height / width.max(1)).clamp(1, into_height.max(1)))
    } else {
        ((into_height * width / height.max(1)).clamp(1, into_width.max(1)), into_height)
    }
}

/// The mean of screen pixels, each channel by itself.
fn mean<'a>(pixels: impl Iterator<Item = &'a u32>) -> u32 {
    let (mut sum, mut count) = ([0_u64; 4], 0);
    for pixel in pixels {
        for (sum, byte) in sum.iter_mut().zip(pixel.to_be_bytes()) {
            *sum += u64::from(byte);
        }
        count += 1;
    }
    #[expect(clippy::cast_possible_truncation, reason = "a mean of bytes is a byte")]
    let mean = sum.map(|channel| (channel / count.max(1)) as u8);
    u32::from_be_bytes(mean)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::Film;

    /// Pixels numbered row by row.
    fn numbered(width: usize, height: usize) -> Raster {
        Raster { width, height, pixels: (0..).take(width * height).collect() }
    }

    #[test]
    fn the_same_size_is_copied_and_others_keep_their_shape() {
        let picture = numbered(4, 2);
        let mut target = Raster::new(4, 2);
        target.fit(&picture);
        assert_eq!(target, picture);
        assert_eq!(fitted((4, 2), (8, 8)), (8, 4));
        assert_eq!(fitted((4, 2), (100, 1)), (2, 1));
        assert_eq!(fitted((65_535, 1), (10, 10)), (10, 1));

        let mut target = Raster::new(8, 6);
        target.fit(&picture);
        assert_eq!(target.row_mut(0, 0, 8), [0; 8]);
        assert_eq!(target.row_mut(0, 4, 8), [4, 4, 5, 5, 6, 6, 7, 7]);
    }

    #[test]
    fn smaller_pictures_are_means() {
        let small = numbered(4, 2).stretched(Size::of::<2, 1>());
        // Means of 0, 1, 4, 5 and of 2, 3, 6, 7, rounded down.
        assert_eq!(small.pixels(), [2, 4]);
        let white = std::iter::repeat_n(&0xFF_FF_FF, 20_000_000);
        assert_eq!(mean(white), 0xFF_FF_FF);
        assert_eq!(mean([0x10_20_30, 0x30_20_10].iter()), 0x20_20_20);
    }

    #[test]
    fn tiles_land_where_they_belong() {
        let size = Size::of::<20, 18>();
        let mut raster = Raster::of(size);
        for tile in Film::new(size).tiles() {
            let developed: Vec<u32> = (0..tile.pixels.len()).map(|_| tile.left + tile.top).collect();
            raster.put(tile, &developed);
        }
        assert_eq!(raster.row_mut(14, 17, 9), [16, 16, 32, 32, 32, 32]);
        assert!(raster.row_mut(0, 18, 5).is_empty());
    }

    #[test]
    fn screens_are_srgb() {
        assert_eq!(screen(Rgb::new(1.0, 0.0, 0.215_861)), 0xFF_00_80);
    }
}
