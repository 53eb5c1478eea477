//! The worker: renders in the background whatever the window orders.

use std::{
    sync::{Mutex, atomic::Ordering},
    time::{Duration, Instant},
};

use super::{
    mailbox::{Mailbox, Progress, View, lock},
    overlay::{GREEN, Line, RED},
    shown::Shown,
    watcher::{Abandonable, Watcher},
};
use crate::{
    cli::{Request, Target, say, start},
    error::Error,
    film::{Film, Size},
    float,
    picture::{Chapter, Render},
    renderer::{self, Ending, Plan, Watch as _},
};

/// Renders one view after the other, and saves them.
pub(crate) struct Worker<'a> {
    chapter: &'a Chapter,
    first: &'a dyn Render,
    made: Option<Box<dyn Render>>,
    request: Request,
    film: Film,
    /// Samples per pixel that it was to have in the end.
    goal: u32,
    progress: Progress,
    /// How long a sample took lately, all threads together, in seconds.
    pace: Option<f64>,
    /// Whether the film is in a file as it is.
    saved: bool,
    mailbox: &'a Mailbox,
    shown: &'a Mutex<Shown>,
}

impl<'a> Worker<'a> {
    /// A worker that begins with the picture of the command line, already made, a film of it, and the
    /// number of samples per pixel that it was to have in the end.
    pub(crate) fn new(
        chapter: &'a Chapter,
        request: &Request,
        first: &'a dyn Render,
        (film, goal): (Film, u32),
        mailbox: &'a Mailbox,
        shown: &'a Mutex<Shown>,
    ) -> Self {
        Self {
            chapter,
            first,
            made: None,
            request: request.clone(),
            film,
            goal,
            progress: Progress::default(),
            pace: None,
            saved: false,
            mailbox,
            shown,
        }
    }

    /// Work until the order to quit. The error is that of the last saving.
    pub(crate) fn run(mut self) -> Result<(), Error> {
        let has = self.film.counts().0;
        if has > 0 {
            // A film that goes on is seen at once.
            let gain = float::exp2(self.request.exposure);
            let watcher = Watcher::new(self.mailbox, self.shown, &self.progress, gain, None);
            self.film.tiles().iter().for_each(|tile| watcher.tile_done(tile, 0));
            watcher.pass_done(&self.film, has);
        }
        loop {
            let ending = self.render();
            let orders = self.mailbox.take();
            if let Some(view) = orders.view {
                self.change(view);
                // Whatever else was asked for is about the new view.
                if orders.save || orders.quit {
                    self.mailbox.post(|again| {
                        again.save |= orders.save;
                        again.quit |= orders.quit;
                    });
                }
                continue;
            }
            if orders.quit {
                return if self.saved { Ok(()) } else { self.save().map(drop) };
            }
            if orders.save {
                let result = self.save();
                self.saved = result.is_ok() && ending != Ending::Cancelled;
                lock(self.shown).message = Some(match result {
                    Ok(text) => Line::new(text, GREEN),
                    Err(error) => {
                        say(&format!("error: {error}"));
                        Line::new(error.to_string(), RED)
                    }
                });
            }
        }
    }

    /// Make another picture, or the same one with other values or in another size.
    fn change(&mut self, view: View) {
        let Request { picture, settings, .. } = &mut self.request;
        if view.picture.name != picture.name || view.values != settings.values {
            let old = std::mem::replace(&mut settings.values, view.values);
            match (view.picture.make)(settings) {
                Ok(made) => {
                    self.made = Some(made);
                    *picture = view.picture;
                    self.request.plan.samples = view.samples;
                }
                Err(error) => {
                    settings.values = old;
                    let text = format!("{error} (the last picture that could be made stays)");
                    lock(self.shown).message = Some(Line::new(text, RED));
                }
            }
        }
        self.request.size = view.size;
        self.film = Film::new(view.size);
        self.goal = self.request.plan.samples;
        self.progress = Progress::default();
        self.saved = false;
        lock(self.shown).restart(view.size, self.request.plan.samples);
    }

    /// Render until all samples are there or an order wants to be done.
    fn render(&mut self) -> Ending {
        let picture = self.made.as_deref().unwrap_or(self.first);
        let Self { mailbox, shown, request, film, progress, pace, .. } = self;
        let (plan, size) = (&request.plan, request.size);
        let watcher = Watcher::new(mailbox, shown, progress, float::exp2(request.exposure), request.until_error);
        let picture = Abandonable { picture, watcher: &watcher };
        let begun = Instant::now();
        let mut sketched = Duration::ZERO;
        if !progress.rough.load(Ordering::Relaxed) {
            for small in sketches(size, *pace) {
                let ending = watcher.sketch(&picture, small, size, plan);
                let time = seconds_each(begun.elapsed() - sketched, small);
                // What was not finished takes longer than that.
                *pace = Some(if ending == Ending::Finished { time } else { pace.unwrap_or(0.0).max(2.0 * time) });
                sketched = begun.elapsed();
            }
        }
        let ending = renderer::render(&picture, film, plan, &watcher);
        let first_pass = watcher.first_pass().map(|time| time.saturating_duration_since(begun + sketched));
        *pace = first_pass.map(|time| seconds_each(time, size)).or(*pace);
        ending
    }

    /// The picture that is rendered.
    fn picture(&self) -> &dyn Render {
        self.made.as_deref().unwrap_or(self.first)
    }

    /// How many samples per pixel the rendering is to have when it goes on without a window.
    fn goal(&self) -> u32 {
        if self.goal == Plan::MAX_SAMPLES { self.request.picture.samples.max(2) } else { self.goal }
    }

    /// Save the film as it is; says where it is now.
    fn save(&self) -> Result<String, Error> {
        let target = Target::prepare(self.chapter, &self.request)?;
        let stored = start::store(self.chapter, &self.request, self.picture(), self.goal(), &self.film);
        target.save(&self.film, &self.request, None).and(stored)?;
        Ok(match target {
            Target::File(path, _) => format!("saved as {}", path.display()),
            Target::Stdout => "written to standard output".into(),
        })
    }
}

/// The sizes of rough pictures that should come before the first pass: one that is there at once, and one in between;
/// none if the first pass itself is done at once.
fn sketches(size: Size, pace: Option<f64>) -> Vec<Size> {
    const AT_ONCE: f64 = 0.08;
    const COARSEST: u32 = 16;
    const BETWEEN: u32 = 4;
    #[expect(clippy::cast_precision_loss, reason = "at most MAX_PIXELS")]
    let first_pass = pace.unwrap_or(f64::INFINITY) * size.pixels() as f64;
    if first_pass < 2.0 * AT_ONCE {
        return Vec::new();
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates, and is limited then")]
    let divisor = ((first_pass / AT_ONCE).sqrt().ceil() as u32).min(COARSEST);
    let divisors = [divisor, BETWEEN].into_iter().take(if divisor >= 2 * BETWEEN { 2 } else { 1 });
    divisors.map(|divisor| size.scaled_to(size.width().max(size.height()).div_ceil(divisor))).collect()
}

/// The time of one sample of many.
#[expect(clippy::cast_precision_loss, reason = "at most MAX_PIXELS")]
fn seconds_each(time: Duration, size: Size) -> f64 {
    time.as_secs_f64() / size.pixels() as f64
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::*;
    use crate::{
        color::Rgb,
        knob::Values,
        window::fixture::{CHAPTER, request_to},
        window::raster::screen,
    };

    /// A file in a folder of its own.
    fn file(name: &str) -> PathBuf {
        std::env::temp_dir().join(format!("course-window-{}-{name}", std::process::id())).join("picture.png")
    }

    /// Let a worker work while `user` gives orders; the saved picture, and what was shown.
    fn saved(name: &str, user: impl FnOnce(&Mailbox, &Mutex<Shown>)) -> (image::RgbImage, Shown) {
        let file = file(name);
        let request = request_to(&file);
        let (mailbox, shown) = (Mailbox::default(), Mutex::new(Shown::new(request.size, request.plan.samples)));
        let first = (request.picture.make)(&request.settings).unwrap();
        let start = (Film::new(request.size), request.plan.samples);
        std::thread::scope(|scope| {
            let worker = scope.spawn(|| Worker::new(&CHAPTER, &request, first.as_ref(), start, &mailbox, &shown).run());
            let closing = mailbox.closing();
            user(&mailbox, &shown);
            drop(closing);
            assert_eq!(worker.join().unwrap(), Ok(()));
        });
        let picture = image::open(&file).unwrap().into_rgb8();
        std::fs::remove_dir_all(file.parent().unwrap()).unwrap();
        (picture, shown.into_inner().unwrap())
    }

    /// A view of a picture of the fixture with one knob set.
    fn view(index: usize, knob: Option<(&str, f32)>, size: Size) -> View {
        let picture = &CHAPTER.pictures[index];
        let mut values = Values::default();
        if let Some(knob_value) = knob {
            values.set(picture.knobs.iter().find(|k| k.name == knob_value.0).unwrap(), knob_value.1);
        }
        View { picture, values, size, samples: picture.samples }
    }

    /// Wait until something was shown.
    fn wait(shown: &Mutex<Shown>, condition: impl Fn(&Shown) -> bool) {
        let start = Instant::now();
        while !condition(&lock(shown)) {
            assert!(start.elapsed() < Duration::from_secs(20), "waited too long");
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    /// The red of a picture whose red is `linear`.
    fn red(linear: f32) -> u8 {
        crate::color::to_byte(linear)
    }

    #[test]
    fn slow_pictures_begin_with_a_sketch() {
        let size = Size::of::<640, 360>();
        let widths = |pace| sketches(size, pace).into_iter().map(Size::width).collect::<Vec<_>>();
        assert_eq!(widths(None), [40, 160]);
        assert_eq!(widths(Some(1e-7)), [0; 0]);
        // 0.23 s for all pixels: a third of them in 0.08 s, which is half of the width.
        assert_eq!(widths(Some(1e-6)), [320]);
        assert_eq!(widths(Some(1e-5)), [107]);
        assert_eq!([Some(1.0), Some(f64::INFINITY)].map(widths), [[40, 160]; 2]);
        assert_eq!(sketches(Size::of::<1, 1>(), Some(99.0)), [Size::of::<1, 1>(); 2]);
    }

    #[test]
    fn quitting_at_once_still_saves_a_whole_picture() {
        let (picture, _) = saved("quit", |_, _| ());
        assert_eq!(picture.dimensions(), (40, 20));
        assert!(picture.pixels().all(|p| p.0 == [red(0.5), 0, 0]));
    }

    #[test]
    fn all_samples_are_taken_and_shown() {
        let (_, shown) = saved("all", |_, shown| wait(shown, |shown| shown.samples == 4));
        assert_eq!((shown.total, shown.error), (4, Some(0.0)));
        assert!(shown.raster.pixels().iter().all(|p| *p == screen(Rgb::X * 0.5)));
    }

    /// Closed in the middle, twice, and finished without a window: the same bits as in one go.
    #[test]
    fn a_rendering_goes_on_from_window_to_window() {
        let file = file("state");
        let store = file.with_extension("state");
        let mut request = request_to(&file);
        (request.samples, request.save_state) = (None, Some(store.clone()));
        request.plan.samples = request.samples_in_window(request.picture);
        assert_eq!(request.plan.samples, Plan::MAX_SAMPLES);
        let first = (request.picture.make)(&request.settings).unwrap();
        let mut films = Vec::new();
        for _window in 0..2 {
            let start = start::Start::prepare(&CHAPTER, &request, first.as_ref()).unwrap();
            let start = start.film(&request, request.plan.samples);
            let has = start.0.counts().0;
            let (mailbox, shown) = (Mailbox::default(), Mutex::new(Shown::new(request.size, request.plan.samples)));
            std::thread::scope(|scope| {
                let worker = Worker::new(&CHAPTER, &request, first.as_ref(), start, &mailbox, &shown);
                let worker = scope.spawn(|| worker.run());
                wait(&shown, |shown| shown.samples > has);
                mailbox.post(|orders| orders.quit = true);
                assert_eq!(worker.join().unwrap(), Ok(()));
            });
            let state = crate::state::read(&store).unwrap();
            assert!(state.film.counts().0 > has);
            assert_eq!(state.goal, request.picture.samples);
            films.push(state.film);
            request.resume = Some(store.clone());
        }
        let plan = Plan { samples: films[1].counts().1, ..request.plan };
        let mut whole = Film::new(request.size);
        for film in films.iter_mut().chain([&mut whole]) {
            assert_eq!(renderer::render(first.as_ref(), film, &plan, &()), Ending::Finished);
        }
        assert_eq!(films[0].tiles()[0].pixels, whole.tiles()[0].pixels);
        assert_eq!(films[1].tiles()[0].pixels, whole.tiles()[0].pixels);
        std::fs::remove_dir_all(file.parent().unwrap()).unwrap();
    }

    #[test]
    fn the_last_of_many_views_is_saved_in_its_size() {
        let (picture, shown) = saved("views", |mailbox, _| {
            for (rings, width) in [(1.0, 30), (2.0, 50), (6.0, 33)] {
                let size = Size::new(width, 17).unwrap();
                mailbox.post(|orders| orders.view = Some(view(0, Some(("rings", rings)), size)));
            }
        });
        assert_eq!(picture.dimensions(), (33, 17));
        assert!(picture.pixels().all(|p| p.0 == [red(0.75), 0, 0]));
        assert_eq!(shown.raster.size(), (33, 17));
    }

    #[test]
    fn a_picture_that_cannot_be_made_leaves_the_last_one() {
        let size = Size::of::<40, 20>();
        let (picture, shown) = saved("broken", |mailbox, shown| {
            mailbox.post(|orders| orders.view = Some(view(0, Some(("broken", 1.0)), size)));
            wait(shown, |shown| shown.message.is_some() && shown.samples == 4);
        });
        assert!(picture.pixels().all(|p| p.0 == [red(0.5), 0, 0]));
        assert!(shown.message.unwrap().text.starts_with("knob 'broken' cannot be 'on'"));
    }

    #[test]
    fn slow_pictures_can_be_saved_and_left_before_they_are_done() {
        let start = Instant::now();
        let (picture, shown) = saved("slow", |mailbox, shown| {
            mailbox.post(|orders| orders.view = Some(view(1, None, Size::of::<40, 20>())));
            wait(shown, |shown| shown.samples >= 2);
            mailbox.post(|orders| orders.save = true);
            wait(shown, |shown| shown.message.is_some());
            let samples = lock(shown).samples;
            wait(shown, |shown| shown.samples > samples);
        });
        assert!(picture.pixels().all(|p| p.0 == [0, 255, 0]));
        assert_eq!(shown.message.unwrap().color, GREEN);
        assert!(start.elapsed() < Duration::from_secs(20));
    }
}
