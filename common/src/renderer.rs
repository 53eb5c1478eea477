//! The renderer: fills a film with samples, tile by tile, over all cores.

use glam::Vec2;

use crate::{
    color::Rgb,
    film::{Film, Size, Tile},
    parallel,
    picture::{FilmPoint, Render},
    random::Stream,
    story::Told,
};

/// What is to be rendered, besides the picture itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// Samples per pixel in the end, at least 1.
    pub samples: u32,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Number of threads; 0 for as many as there are cores.
    pub threads: usize,
}

impl Plan {
    /// Greatest number of samples per pixel.
    pub const MAX_SAMPLES: u32 = 100_000_000;
}

/// Somebody who watches a rendering and may end it.
pub trait Watch: Sync {
    /// A tile has received `samples` more samples, those of all its pixels together.
    fn tile_done(&self, _tile: &Tile, _samples: u64) {}

    /// A pass over the whole film is done; every pixel now has `samples` samples.
    fn pass_done(&self, _film: &Film, _samples: u32) {}

    /// Asked before each pixel: whether to stop.
    fn is_cancelled(&self) -> bool {
        false
    }

    /// Asked when every pixel has `samples` samples, at numbers of samples that are always the same: whether that is
    /// enough. An answer that depends on the film alone depends neither on threads nor on earlier interruptions.
    fn is_enough(&self, _film: &Film, _samples: u32) -> bool {
        false
    }
}

/// Nobody watches.
impl Watch for () {}

/// How a rendering ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// Every pixel has all its samples.
    Finished,
    /// The watcher found the film good enough: every pixel has the same number of samples.
    Enough,
    /// The watcher ended it at once. Some pixels may have more samples than others, and the mean of each is right.
    Cancelled,
}

/// Add samples to `film` until every pixel has `plan.samples`, in passes of growing size, so that a first rough
/// picture is there soon. Samples that the film already has are kept, also when some pixels have more than others:
/// what was interrupted and goes on ends in the same bits as what was not.
///
/// The result depends on the picture, the size, the samples and the seed; not on the threads.
pub fn render(picture: &dyn Render, film: &mut Film, plan: &Plan, watch: &dyn Watch) -> Ending {
    parallel::with_threads(plan.threads, || passes(picture, film, plan, watch))
}

/// Pass after pass over the whole film.
fn passes(picture: &dyn Render, film: &mut Film, plan: &Plan, watch: &dyn Watch) -> Ending {
    let (mut done, most) = film.counts();
    // A film that stands where a pass ends is asked about as it was then.
    let mut is_at_end_of_pass = done == most && done > 0 && pass_end(done - 1) == done;
    while done < plan.samples {
        if is_at_end_of_pass && watch.is_enough(film, done) {
            return Ending::Enough;
        }
        let until = pass_end(done).min(plan.samples);
        let size = film.size();
        let fill = |tile: &mut Tile| {
            let added = add_samples(picture, tile, size, plan, until, watch);
            if added > 0 {
                watch.tile_done(tile, added);
            }
        };
        #[cfg(feature = "threads")]
        {
            use rayon::prelude::*;
            film.tiles_mut().par_iter_mut().with_max_len(1).for_each(fill);
        }
        #[cfg(not(feature = "threads"))]
        film.tiles_mut().iter_mut().for_each(fill);
        if watch.is_cancelled() {
            return Ending::Cancelled;
        }
        done = until;
        is_at_end_of_pass = true;
        watch.pass_done(film, done);
    }
    Ending::Finished
}

/// How many samples per pixel there are at the end of the pass that begins with `done`: 1, 2, 4, 8, 16, 32, 48, …,
/// whatever number the film came with.
fn pass_end(done: u32) -> u32 {
    const LARGEST_PASS: u32 = 16;
    if done < LARGEST_PASS { (done + 1).next_power_of_two() } else { (done / LARGEST_PASS + 1) * LARGEST_PASS }
}

/// Add samples to the pixels of one tile until each has `until`: a piece of [`render`] for those who divide the work
/// themselves. The result is the same whoever renders which tile, in whatever order.
pub fn fill_tile(picture: &dyn Render, tile: &mut Tile, size: Size, plan: &Plan, until: u32) {
    add_samples(picture, tile, size, plan, until, &());
}

/// The same for those who may want to stop at any pixel; the number of samples added.
fn add_samples(picture: &dyn Render, tile: &mut Tile, size: Size, plan: &Plan, until: u32, watch: &dyn Watch) -> u64 {
    let mut added = 0;
    for (x, y, pixel) in tile.pixels_mut() {
        if watch.is_cancelled() {
            break;
        }
        added += u64::from(until.saturating_sub(pixel.count()));
        for sample in pixel.count()..until {
            let (point, mut random) = film_point((x, y), size, plan, sample);
            pixel.add(picture.sample(point, &mut random));
        }
    }
    added
}

// ANCHOR: film_point
/// Where on the film a sample lies, and the stream of its further random numbers.
///
/// A lone sample lies in the pixel's center. Several lie anywhere in the pixel with equal probability, so that their
/// mean is the mean over the pixel's area: a box filter.
fn film_point((x, y): (u32, u32), size: Size, plan: &Plan, sample: u32) -> (FilmPoint, Stream) {
    let pixel = u64::from(y) * u64::from(size.width()) + u64::from(x);
    let mut random = Stream::new(plan.seed, pixel, u64::from(sample));
    let offset = if plan.samples == 1 { Vec2::splat(0.5) } else { Vec2::new(random.uniform(), random.uniform()) };
    #[expect(clippy::cast_precision_loss, reason = "at most 65,535, exact in f32")]
    let [corner, size] = [(x, y), (size.width(), size.height())].map(|(x, y)| Vec2::new(x as f32, y as f32));
    (FilmPoint { position: corner + offset, size }, random)
}
// ANCHOR_END: film_point

/// One sample of one pixel with its story, the same to the last bit as in the picture.
#[must_use]
pub fn explain(picture: &dyn Render, pixel: (u32, u32), size: Size, plan: &Plan, sample: u32) -> (Rgb, Told) {
    let mut story = Told::default();
    let (point, mut random) = film_point(pixel, size, plan, sample);
    let color = picture.explain(point, &mut random, &mut story);
    (color, story)
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicU32, Ordering};

    use super::*;
    use crate::{picture::Integrator, story::Story};

    /// Radiance that depends on place and chance, and tells what it did.
    struct Noise;

    impl Integrator for Noise {
        fn radiance(&self, point: FilmPoint, random: &mut Stream, story: &mut impl Story) -> Rgb {
            let color = Rgb::new(point.ndc().x, point.ndc().y, random.uniform());
            story.tell(|| format!("{color}"));
            color
        }
    }

    const SIZE: Size = Size::of::<50, 37>();
    const PLAN: Plan = Plan { samples: 20, seed: 3, threads: 2 };

    fn rendered(plan: &Plan) -> Vec<Rgb> {
        let mut film = Film::new(SIZE);
        assert_eq!(render(&Noise, &mut film, plan, &()), Ending::Finished);
        assert!(film.tiles().iter().flat_map(|t| &t.pixels).all(|p| p.count() == plan.samples));
        film.linear()
    }

    #[test]
    fn threads_do_not_change_the_picture() {
        let one = rendered(&Plan { threads: 1, ..PLAN });
        for threads in [2, 7] {
            assert_eq!(rendered(&Plan { threads, ..PLAN }), one);
        }
        assert_ne!(rendered(&Plan { seed: 4, ..PLAN }), one);
    }

    #[test]
    fn going_on_equals_going_through() {
        let mut film = Film::new(SIZE);
        for samples in [3, 20] {
            render(&Noise, &mut film, &Plan { samples, ..PLAN }, &());
        }
        assert_eq!(film.linear(), rendered(&PLAN));
    }

    /// Cancelled after so many pixels, again and again, and with another number of threads each time.
    #[test]
    fn interruptions_do_not_change_the_picture() {
        struct After(AtomicU32, u32);
        impl Watch for After {
            fn is_cancelled(&self) -> bool {
                self.0.fetch_add(1, Ordering::Relaxed) >= self.1
            }
        }
        for pixels in [1, 700, 1849, 3001] {
            let (mut film, mut runs, mut uneven) = (Film::new(SIZE), 0, 0);
            loop {
                let plan = Plan { threads: 1 + runs % 2, ..PLAN };
                let ending = render(&Noise, &mut film, &plan, &After(AtomicU32::new(0), pixels));
                let (least, most) = film.counts();
                (runs, uneven) = (runs + 1, uneven + u32::from(least < most));
                if least == PLAN.samples {
                    break;
                }
                assert_eq!(ending, Ending::Cancelled);
                // Few pixels at a time take long to go through; the rest is done at once.
                if runs > 20 {
                    assert_eq!(render(&Noise, &mut film, &PLAN, &()), Ending::Finished);
                    break;
                }
            }
            assert!(runs > 1 && uneven > 0, "{pixels}: {runs} runs, {uneven} uneven");
            assert_eq!(film.linear(), rendered(&PLAN), "{pixels}");
        }
    }

    /// Asked at the same numbers of samples, wherever it was interrupted before.
    #[test]
    fn enough_is_asked_at_fixed_numbers_of_samples() {
        #[derive(Default)]
        struct Asked(std::sync::Mutex<Vec<u32>>, u32);
        impl Watch for Asked {
            fn is_enough(&self, film: &Film, samples: u32) -> bool {
                assert_eq!(film.counts(), (samples, samples));
                self.0.lock().unwrap().push(samples);
                samples == self.1
            }
        }
        let plan = Plan { samples: 100, ..PLAN };
        for (begun, expected) in [
            (0, &[1, 2, 4, 8, 16, 32, 48][..]),
            (1, &[1, 2, 4, 8, 16, 32, 48]),
            (7, &[8, 16, 32, 48]),
            (16, &[16, 32, 48]),
            (20, &[32, 48]),
            (48, &[48]),
        ] {
            let mut film = Film::new(SIZE);
            if begun > 0 {
                render(&Noise, &mut film, &Plan { samples: begun, ..PLAN }, &());
            }
            let watch = Asked(Default::default(), 48);
            assert_eq!(render(&Noise, &mut film, &plan, &watch), Ending::Enough);
            assert_eq!(watch.0.into_inner().unwrap(), expected, "{begun}");
        }
    }

    #[test]
    fn one_sample_is_in_the_center_and_many_average_to_it() {
        let one = rendered(&Plan { samples: 1, ..PLAN });
        assert_eq!(one[0].truncate(), Vec2::new(1.0 / 50.0 - 1.0, 1.0 - 1.0 / 37.0));
        let many = rendered(&Plan { samples: 400, ..PLAN });
        let distance = |v: Vec2| (v * Vec2::new(50.0, 37.0) / 2.0).abs().max_element();
        // Uniform over one pixel: standard deviation √(1/12); 400 samples, 3700 numbers, five sigma.
        let worst = one.iter().zip(&many).map(|(a, b)| distance(a.truncate() - b.truncate())).fold(0.0, f32::max);
        assert!(worst < 5.0 * (1.0 / 12.0_f32 / 400.0).sqrt(), "{worst}");
    }

    #[test]
    fn the_story_ends_in_the_color_of_the_picture() {
        let plan = Plan { samples: 1, ..PLAN };
        let (color, story) = explain(&Noise, (5, 9), SIZE, &plan, 0);
        assert_eq!(color, rendered(&plan)[9 * 50 + 5]);
        assert_eq!(story.to_string(), format!("{color}\n"));
    }

    #[test]
    fn the_watcher_sees_every_tile_and_can_cancel() {
        #[derive(Default)]
        struct Counter {
            tiles: AtomicU32,
            passes: AtomicU32,
            stop_after: u32,
        }
        impl Watch for Counter {
            fn tile_done(&self, _tile: &Tile, _samples: u64) {
                self.tiles.fetch_add(1, Ordering::Relaxed);
            }
            fn pass_done(&self, _film: &Film, _samples: u32) {
                self.passes.fetch_add(1, Ordering::Relaxed);
            }
            fn is_cancelled(&self) -> bool {
                self.passes.load(Ordering::Relaxed) >= self.stop_after
            }
        }
        let watch = Counter { stop_after: 3, ..Counter::default() };
        let mut film = Film::new(SIZE);
        assert_eq!(render(&Noise, &mut film, &PLAN, &watch), Ending::Cancelled);
        // Passes of 1, 1 and 2 samples, twelve tiles each.
        assert_eq!((watch.passes.into_inner(), watch.tiles.into_inner()), (3, 36));
        assert_eq!(film.pixel(0, 0).map(|p| p.count()), Some(4));
    }
}
