//! The film: what has arrived at each pixel so far.

use glam::DVec3;

use crate::{
    color::{ByteTable, Rgb, luminance},
    error::Error,
};

/// Width and height of a film in pixels, neither of them zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    width: u32,
    height: u32,
}

impl Size {
    /// Greatest length of a side in pixels.
    pub const MAX_SIDE: u32 = 65_535;
    /// Greatest number of pixels; a film of this size takes about 2 GB.
    pub const MAX_PIXELS: u64 = 34_000_000;

    /// A size within the limits.
    ///
    /// # Errors
    /// [`Error::Size`] for a side of zero, and for more than memory should be asked for.
    pub fn new(width: u64, height: u64) -> Result<Self, Error> {
        if !Self::fits(width, height) {
            return Err(Error::Size { width, height });
        }
        #[expect(clippy::cast_possible_truncation, reason = "at most MAX_SIDE")]
        Ok(Self { width: width as u32, height: height as u32 })
    }

    /// A size known when the program is compiled; it does not compile when the size is impossible.
    ///
    /// # Panics
    /// Only at compile time.
    #[must_use]
    pub const fn of<const WIDTH: u32, const HEIGHT: u32>() -> Self {
        const { assert!(Self::fits(WIDTH as u64, HEIGHT as u64), "an impossible size") };
        Self { width: WIDTH, height: HEIGHT }
    }

    /// Whether a film can have these sides.
    const fn fits(width: u64, height: u64) -> bool {
        let max = Self::MAX_SIDE as u64;
        width != 0 && height != 0 && width <= max && height <= max && width * height <= Self::MAX_PIXELS
    }

    /// Width in pixels.
    #[must_use]
    pub const fn width(self) -> u32 {
        self.width
    }

    /// Height in pixels.
    #[must_use]
    pub const fn height(self) -> u32 {
        self.height
    }

    /// Number of pixels.
    #[must_use]
    pub const fn pixels(self) -> usize {
        self.width as usize * self.height as usize
    }

    /// The same shape, with `side` pixels along the longer side.
    #[must_use]
    pub fn scaled_to(self, side: u32) -> Self {
        let longer = u64::from(self.width.max(self.height));
        // Rounded to the nearest pixel; at least one, and no more than the limits allow.
        let scaled = |n: u32| (u64::from(n) * u64::from(side) + longer / 2) / longer;
        let scale = |n: u32| u32::try_from(scaled(n)).unwrap_or(u32::MAX).clamp(1, Self::MAX_SIDE);
        Self { width: scale(self.width), height: scale(self.height) }
    }
}

/// What one pixel has received.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pixel {
    sum: DVec3,
    sum_of_squares: DVec3,
    count: u32,
    bad: u32,
}

impl Pixel {
    // ANCHOR: add
    /// Add one sample of linear RGB radiance. NaN and infinite samples are counted and left out.
    pub fn add(&mut self, sample: Rgb) {
        self.count += 1;
        if !sample.is_finite() {
            self.bad += 1;
            return;
        }
        let sample = sample.as_dvec3();
        self.sum += sample;
        self.sum_of_squares += sample * sample;
    }
    // ANCHOR_END: add

    /// Number of samples that count.
    fn good(&self) -> f64 {
        f64::from(self.count - self.bad)
    }

    /// Mean of the samples: the pixel's estimate of its radiance; black when there are none.
    #[must_use]
    pub fn mean(&self) -> Rgb {
        (self.sum / self.good().max(1.0)).as_vec3()
    }

    // ANCHOR: standard_error
    /// Standard error of the mean, for each channel: how far the pixel typically is from the true value.
    ///
    /// It is √(s²/n), with s² the unbiased estimate of the variance of one sample and n their number; infinite for
    /// fewer than two samples.
    #[must_use]
    pub fn standard_error(&self) -> Rgb {
        let n = self.good();
        if n < 2.0 {
            return Rgb::INFINITY;
        }
        let variance = (self.sum_of_squares - self.sum * self.sum / n).max(DVec3::ZERO) / (n - 1.0);
        DVec3::from_array((variance / n).to_array().map(f64::sqrt)).as_vec3()
    }
    // ANCHOR_END: standard_error

    /// Number of samples so far, bad ones included.
    #[must_use]
    pub fn count(&self) -> u32 {
        self.count
    }

    /// All that the pixel knows, to be stored: sums of the channels and of their squares, number of samples, and how
    /// many of those were bad.
    #[must_use]
    pub fn to_parts(&self) -> ([f64; 6], [u32; 2]) {
        let ([r, g, b], [rr, gg, bb]) = (self.sum.to_array(), self.sum_of_squares.to_array());
        ([r, g, b, rr, gg, bb], [self.count, self.bad])
    }

    /// The pixel that [`Pixel::to_parts`] took apart; `None` if no samples could have made it.
    #[must_use]
    pub fn from_parts([r, g, b, rr, gg, bb]: [f64; 6], [count, bad]: [u32; 2]) -> Option<Self> {
        let (sum, sum_of_squares) = (DVec3::new(r, g, b), DVec3::new(rr, gg, bb));
        let is_possible = bad <= count && sum.is_finite() && sum_of_squares.is_finite();
        is_possible.then_some(Self { sum, sum_of_squares, count, bad })
    }
}

/// A small rectangle of the film, the piece of work that one core takes at a time.
#[derive(Clone, Debug)]
pub struct Tile {
    /// Column of its left pixels.
    pub left: u32,
    /// Row of its top pixels.
    pub top: u32,
    /// Width in pixels.
    pub width: u32,
    /// Pixels, row by row from the top.
    pub pixels: Vec<Pixel>,
}

impl Tile {
    /// Length of a side in pixels, but for the tiles at the right and lower edge.
    pub const SIDE: u32 = 16;

    /// Its pixels with their column and row on the film.
    pub fn pixels_mut(&mut self) -> impl Iterator<Item = (u32, u32, &mut Pixel)> {
        let Self { left, top, width, pixels } = self;
        (0_u32..).zip(pixels).map(|(i, pixel)| (*left + i % *width, *top + i / *width, pixel))
    }

    /// Its rows: column and row of the first pixel, and the pixels.
    pub fn rows(&self) -> impl Iterator<Item = (u32, u32, &[Pixel])> {
        (self.top..).zip(self.pixels.chunks(self.width as usize)).map(|(y, row)| (self.left, y, row))
    }
}

/// The film: sum and sum of squares of the samples of every pixel, kept in tiles.
#[derive(Clone, Debug)]
pub struct Film {
    size: Size,
    tiles: Vec<Tile>,
}

impl Film {
    /// A film that has seen nothing yet.
    #[must_use]
    pub fn new(size: Size) -> Self {
        let step = Tile::SIDE as usize;
        let tile = |left: u32, top: u32| {
            let (width, height) = (Tile::SIDE.min(size.width - left), Tile::SIDE.min(size.height - top));
            Tile { left, top, width, pixels: vec![Pixel::default(); (width * height) as usize] }
        };
        let rows = (0..size.height).step_by(step);
        let tiles = rows.flat_map(|top| (0..size.width).step_by(step).map(move |left| tile(left, top))).collect();
        Self { size, tiles }
    }

    /// Width and height.
    #[must_use]
    pub fn size(&self) -> Size {
        self.size
    }

    /// Its tiles, row by row from the top.
    #[must_use]
    pub fn tiles(&self) -> &[Tile] {
        &self.tiles
    }

    /// Its tiles, to be added to.
    pub fn tiles_mut(&mut self) -> &mut [Tile] {
        &mut self.tiles
    }

    /// The pixel in column `x` from the left and row `y` from the top; `None` outside.
    #[must_use]
    pub fn pixel(&self, x: u32, y: u32) -> Option<&Pixel> {
        if x >= self.size.width || y >= self.size.height {
            return None;
        }
        let per_row = self.size.width.div_ceil(Tile::SIDE);
        let tile = &self.tiles[(y / Tile::SIDE * per_row + x / Tile::SIDE) as usize];
        tile.pixels.get(((y - tile.top) * tile.width + x - tile.left) as usize)
    }

    /// The least and the greatest number of samples that a pixel has. They differ when a rendering was interrupted.
    #[must_use]
    pub fn counts(&self) -> (u32, u32) {
        let counts = self.tiles.iter().flat_map(|t| &t.pixels).map(Pixel::count);
        counts.fold((u32::MAX, 0), |(least, most), count| (least.min(count), most.max(count)))
    }

    /// How many samples were NaN or infinite. They are left out of the picture, and reported.
    #[must_use]
    pub fn bad_samples(&self) -> u64 {
        self.tiles.iter().flat_map(|t| &t.pixels).map(|p| u64::from(p.bad)).sum()
    }

    // ANCHOR: relative_error
    /// The picture's own error: the mean over all pixels of the standard error of their luminance, as a share of
    /// the mean luminance. `None` before the second sample, and for a black picture.
    #[must_use]
    pub fn relative_error(&self) -> Option<f64> {
        let (mut error, mut light) = (0.0, 0.0);
        for pixel in self.tiles.iter().flat_map(|t| &t.pixels) {
            error += f64::from(luminance(pixel.standard_error()));
            light += f64::from(luminance(pixel.mean()));
        }
        (error.is_finite() && light > 0.0).then_some(error / light)
    }
    // ANCHOR_END: relative_error

    /// Linear RGB means, row by row from the top.
    #[must_use]
    pub fn linear(&self) -> Vec<Rgb> {
        let mut image = vec![Rgb::ZERO; self.size.pixels()];
        for (x, y, row) in self.tiles.iter().flat_map(Tile::rows) {
            let start = y as usize * self.size.width as usize + x as usize;
            for (to, from) in image[start..].iter_mut().zip(row) {
                *to = from.mean();
            }
        }
        image
    }

    /// The picture for a screen: linear means times 2^`exposure`, clamped, encoded as sRGB once, 8 bits a channel,
    /// row by row from the top.
    #[must_use]
    pub fn develop(&self, exposure: f32) -> Vec<[u8; 3]> {
        let gain = crate::float::exp2(exposure);
        let table = ByteTable::new();
        let encode = |color: Rgb| (color * gain).to_array().map(|linear| table.to_byte(linear));
        let linear = self.linear();
        #[cfg(feature = "threads")]
        {
            use rayon::prelude::*;
            linear.into_par_iter().with_min_len(4096).map(encode).collect()
        }
        #[cfg(not(feature = "threads"))]
        linear.into_iter().map(encode).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_have_limits() {
        for (width, height) in [(0, 1), (1, 0), (65_536, 1), (100_000_000, 100_000_000), (u64::MAX, 2), (8000, 8000)] {
            assert_eq!(Size::new(width, height), Err(Error::Size { width, height }));
        }
        let size = Size::of::<1280, 720>();
        assert_eq!((size.width(), size.height(), size.pixels()), (1280, 720, 921_600));
        assert_eq!(size.scaled_to(640), Size::of::<640, 360>());
    }

    #[test]
    fn every_pixel_is_in_one_tile() {
        for (width, height) in [(1, 1), (16, 16), (17, 33), (100, 1)] {
            let size = Size::new(width, height).unwrap();
            let mut film = Film::new(size);
            for tile in film.tiles_mut() {
                for (x, y, pixel) in tile.pixels_mut() {
                    #[allow(clippy::cast_precision_loss)]
                    pixel.add(Rgb::new(x as f32, y as f32, 1.0));
                }
            }
            for y in 0..size.height() {
                for x in 0..size.width() {
                    #[allow(clippy::cast_precision_loss)]
                    let expected = Rgb::new(x as f32, y as f32, 1.0);
                    assert_eq!(film.pixel(x, y).map(Pixel::mean), Some(expected));
                    assert_eq!(film.linear()[(y * size.width() + x) as usize], expected);
                }
            }
            assert_eq!(film.pixel(size.width(), 0), None);
            assert_eq!(film.pixel(0, size.height()), None);
        }
    }

    #[test]
    fn mean_and_standard_error_by_hand() {
        let mut pixel = Pixel::default();
        for sample in [1.0, 2.0, 4.0, 5.0] {
            pixel.add(Rgb::splat(sample));
        }
        // Mean 3; squares of the deviations 4 + 1 + 1 + 4 = 10; variance 10/3; standard error √(10/3/4).
        assert_eq!(pixel.mean(), Rgb::splat(3.0));
        assert!((pixel.standard_error() - Rgb::splat((10.0_f32 / 12.0).sqrt())).length() < 1e-6);
    }

    #[test]
    fn bad_samples_are_counted_and_left_out() {
        let mut film = Film::new(Size::of::<1, 1>());
        for sample in [Rgb::ONE, Rgb::new(f32::NAN, 0.0, 0.0), Rgb::new(0.0, f32::INFINITY, 0.0), Rgb::ONE] {
            film.tiles_mut()[0].pixels[0].add(sample);
        }
        assert_eq!(film.bad_samples(), 2);
        assert_eq!(film.linear(), [Rgb::ONE]);
        assert_eq!(film.pixel(0, 0).map(Pixel::count), Some(4));
    }

    #[test]
    fn a_pixel_can_be_taken_apart_and_put_together() {
        let mut pixel = Pixel::default();
        for sample in [Rgb::new(0.1, 2.0, -3.0), Rgb::NAN, Rgb::splat(1e30)] {
            pixel.add(sample);
        }
        let (sums, counts) = pixel.to_parts();
        assert_eq!((Pixel::from_parts(sums, counts), counts), (Some(pixel), [3, 1]));
        assert_eq!(Pixel::from_parts(sums, [1, 2]), None);
        assert_eq!(Pixel::from_parts([0.0, 0.0, f64::NAN, 0.0, 0.0, 0.0], [1, 0]), None);
    }

    #[test]
    fn exposure_is_in_stops() {
        let mut film = Film::new(Size::of::<1, 1>());
        film.tiles_mut()[0].pixels[0].add(Rgb::new(0.215_861, 0.107_930, 9.0));
        assert_eq!(film.develop(0.0), [[128, 92, 255]]);
        assert_eq!(film.develop(1.0)[0][1], 128);
    }

    #[test]
    fn relative_error_needs_two_samples_and_light() {
        let mut film = Film::new(Size::of::<2, 1>());
        assert_eq!(film.relative_error(), None);
        for sample in [0.5, 1.5] {
            film.tiles_mut()[0].pixels.iter_mut().for_each(|p| p.add(Rgb::splat(sample)));
        }
        // Each pixel: mean 1, variance ½, standard error √(½/2) = ½.
        assert!((film.relative_error().unwrap() - 0.5).abs() < 1e-6);
    }
}
