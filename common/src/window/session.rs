//! One session at the window: from its opening until somebody closes it.

use std::{
    sync::{
        Mutex,
        mpsc::{self, Receiver},
    },
    time::{Duration, Instant},
};

use minifb::{MouseButton, MouseMode, Window};

use super::{
    controls::{Controls, Effect},
    keys::{Action, Ear},
    mailbox::{Mailbox, View, lock},
    mouse::{Drag, wheel},
    overlay::{self, GREY, Line, RED, WHITE},
    raster::Raster,
    resize::Rest,
    shown::Shown,
};
use crate::{cli::Request, film::Size, picture::Chapter};

/// The window and all that it knows.
pub(crate) struct Session<'a> {
    chapter: &'a Chapter,
    request: &'a Request,
    window: Window,
    mailbox: &'a Mailbox,
    shown: &'a Mutex<Shown>,
    actions: Receiver<Action>,
    drag: Drag,
    controls: Controls<'a>,
    rest: Rest,
    /// The size that the user gave the window, if so.
    resized: Option<Size>,
    /// When keys or mouse last did something.
    touched: Instant,
    /// What there is to tell, since when.
    message: Option<(Line, Instant)>,
    /// The picture as it was last picked up, its version, and when to look for another.
    picture: Raster,
    version: u64,
    next: Instant,
    title: String,
    /// The picture with the overlay, as large as the window, and when it was drawn.
    frame: Raster,
    drawn: Instant,
    /// What the overlay said then.
    overlay: [Vec<Line>; 2],
}

impl<'a> Session<'a> {
    /// How long the knobs and a message stay in view.
    const IN_VIEW: Duration = Duration::from_secs(6);
    /// How often a picture that refines is drawn; keys and mouse act at once.
    const REFINE: Duration = Duration::from_millis(33);
    /// The same for pictures so large that drawing them takes long.
    const SELDOM: Duration = Duration::from_millis(500);
    /// How often a picture that does not change is drawn, in case that something covered the window.
    const REDRAW: Duration = Duration::from_millis(250);
    /// How often keys and mouse are polled, a second.
    const RATE: usize = 60;

    /// A session with a window just opened.
    pub(crate) fn new(
        chapter: &'a Chapter,
        request: &'a Request,
        mut window: Window,
        mailbox: &'a Mailbox,
        shown: &'a Mutex<Shown>,
    ) -> Self {
        let (to, actions) = mpsc::channel();
        window.set_input_callback(Box::new(Ear::new(to)));
        window.set_target_fps(Self::RATE);
        let (now, size) = (Instant::now(), window.get_size());
        Self {
            chapter,
            request,
            window,
            mailbox,
            shown,
            actions,
            drag: Drag::default(),
            controls: Controls::new(chapter, request),
            rest: Rest::new(size, now),
            resized: None,
            touched: now,
            message: None,
            picture: Raster::new(1, 1),
            version: 0,
            next: now,
            title: String::new(),
            frame: Raster::new(1, 1),
            drawn: now,
            overlay: Default::default(),
        }
    }

    /// Go on until the window is closed or `is_over`.
    pub(crate) fn run(mut self, is_over: impl Fn() -> bool) {
        while self.window.is_open() && !is_over() && self.listen() {
            self.measure();
            if !self.draw() {
                break;
            }
        }
    }

    /// Do what keys and mouse ask for; false when it is to quit.
    fn listen(&mut self) -> bool {
        let down = self.window.get_mouse_down(MouseButton::Left);
        let drag = self.drag.moved(down, self.window.get_unscaled_mouse_pos(MouseMode::Pass));
        let notches = self.window.get_scroll_wheel().map_or(0.0, |(_, y)| y);
        let actions: Vec<_> = self.actions.try_iter().chain(drag).chain(wheel(notches)).collect();

        let mut changed = false;
        for action in actions {
            self.touched = Instant::now();
            match self.controls.apply(action) {
                Effect::Overlay => {}
                Effect::Render => changed = true,
                Effect::Save => self.save(),
                Effect::Refuse(reason) => self.message = Some((Line::new(reason, RED), self.touched)),
                Effect::Quit => return false,
            }
        }
        if changed {
            // What there was to tell was about the old picture.
            self.message = None;
            self.order();
        }
        true
    }

    /// Order to save the picture.
    fn save(&mut self) {
        if lock(self.shown).samples == 0 {
            let line = Line::new("to be saved as soon as every pixel has a sample", WHITE);
            self.message = Some((line, self.touched));
        }
        self.mailbox.post(|orders| orders.save = true);
    }

    /// Render in the size of the window once that is at rest.
    fn measure(&mut self) {
        let Some((width, height)) = self.rest.watch(self.window.get_size(), Instant::now()) else { return };
        // A window that is larger than any film shows the old one, scaled.
        if let Ok(size) = Size::new(width as u64, height as u64) {
            self.resized = Some(size);
            self.order();
        }
    }

    /// Order what the controls say.
    fn order(&self) {
        let Controls { picture, values, .. } = &self.controls;
        let is_first = picture.name == self.request.picture.name;
        let size = self.resized.unwrap_or(if is_first { self.request.size } else { picture.size });
        let samples = self.request.samples_in_window(picture);
        self.mailbox.post(|orders| orders.view = Some(View { picture, values: values.clone(), size, samples }));
    }

    /// Draw what is new, or do nothing for a moment; false when the window does not take it.
    fn draw(&mut self) -> bool {
        let start = Instant::now();
        let refined = start >= self.next && self.pick_up();
        let overlay = self.lines();
        let changed = refined || overlay != self.overlay || self.window.get_size() != self.frame.size();
        if !changed && self.drawn.elapsed() < Self::REDRAW {
            self.window.update();
            return true;
        }
        let (width, height) = self.window.get_size();
        if changed {
            if self.frame.size() != (width, height) {
                self.frame = Raster::new(width, height);
            }
            self.frame.fit(&self.picture);
            overlay::draw(&mut self.frame, &overlay[0], &overlay[1]);
            self.overlay = overlay;
        }
        self.drawn = Instant::now();
        if refined {
            // Drawing a very large picture takes long; most of the time is for rendering.
            self.next = self.drawn + (4 * start.elapsed()).clamp(Self::REFINE, Self::SELDOM);
        }
        self.window.update_with_buffer(self.frame.pixels(), width, height).is_ok()
    }

    /// Take what the worker has to show; whether there is something new to see.
    fn pick_up(&mut self) -> bool {
        let mut shown = lock(self.shown);
        if let Some(line) = shown.message.take() {
            self.message = Some((line, Instant::now()));
        }
        let title = shown.title(self.chapter.title, self.controls.picture.name);
        let is_new = shown.version != self.version;
        if is_new {
            self.picture.copy(&shown.raster);
            self.version = shown.version;
        }
        drop(shown);
        if title != self.title {
            self.window.set_title(&title);
            self.title = title;
        }
        is_new
    }

    /// What the overlay says: help above, knobs and messages below.
    fn lines(&self) -> [Vec<Line>; 2] {
        let Controls { help, pinned, .. } = self.controls;
        let help_lines = if help { self.controls.help_lines() } else { Vec::new() };
        let is_touched = self.touched.elapsed() < Self::IN_VIEW;
        let mut lines = if help || pinned || is_touched { self.controls.lines() } else { Vec::new() };
        let message = self.message.iter().filter(|(_, since)| since.elapsed() < Self::IN_VIEW);
        lines.extend(message.map(|(line, _)| line.clone()));
        if is_touched && !help {
            lines.push(Line::new("H: all keys", GREY));
        }
        [help_lines, lines]
    }
}
