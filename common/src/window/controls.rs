//! What is chosen in the window: the picture, the values of its knobs, what is in view.

use super::keys::{Action, HELP};
use super::overlay::{GREY, Line, WHITE, YELLOW};
use crate::{
    cli::{Output, Request},
    knob::{Kind, Knob, Values},
    picture::{Chapter, ORBIT, PITCH, Picture, YAW, ZOOM},
};

/// The state of the window that keys and mouse change.
#[derive(Debug)]
pub(crate) struct Controls<'a> {
    chapter: &'a Chapter,
    request: &'a Request,
    /// The picture.
    pub(crate) picture: &'static Picture,
    /// The values of its knobs.
    pub(crate) values: Values,
    /// Index of the knob that is turned, among those that are not the camera's.
    chosen: usize,
    /// Whether the help is in view.
    pub(crate) help: bool,
    /// Whether the knobs stay in view.
    pub(crate) pinned: bool,
}

/// What must happen after an [`Action`].
#[derive(Debug, PartialEq)]
pub(crate) enum Effect {
    /// The overlay changes at most.
    Overlay,
    /// The picture must be rendered anew, or another one.
    Render,
    /// The picture must be saved.
    Save,
    /// The window must be closed.
    Quit,
    /// It cannot be done, for this reason.
    Refuse(&'static str),
}

impl<'a> Controls<'a> {
    /// As the command line asked for it.
    pub(crate) fn new(chapter: &'a Chapter, request: &'a Request) -> Self {
        let values = request.settings.values.clone();
        Self { chapter, request, picture: request.picture, values, chosen: 0, help: false, pinned: false }
    }

    /// Do what can be done at once, and say what else must happen.
    pub(crate) fn apply(&mut self, action: Action) -> Effect {
        let before = self.values.clone();
        match action {
            Action::Orbit { yaw, pitch } => self.orbit(yaw, pitch),
            Action::Zoom { nearer } => self.turn(own(self.picture, &ZOOM), nearer),
            Action::Choose(index) if index < self.knobs().count() => self.chosen = index,
            Action::Choose(_) => {}
            Action::ChooseNext { forward } => {
                let count = self.knobs().count().max(1);
                self.chosen = (self.chosen + if forward { 1 } else { count - 1 }) % count;
            }
            Action::Turn { up } => {
                let knob = self.knobs().nth(self.chosen);
                self.turn(knob, up);
            }
            Action::Reset => self.values = self.values_at_start(),
            Action::Leaf { forward } => return self.leaf(forward),
            Action::Help => self.help = !self.help,
            Action::Pin => self.pinned = !self.pinned,
            Action::Save => return Effect::Save,
            Action::Quit => return Effect::Quit,
        }
        if self.values == before { Effect::Overlay } else { Effect::Render }
    }

    /// The knobs of the picture without the camera's.
    fn knobs(&self) -> impl Iterator<Item = &'static Knob> + use<> {
        self.picture.knobs.iter().filter(|knob| ORBIT.iter().all(|orbit| orbit.name != knob.name))
    }

    /// What the values were when the picture was first shown.
    fn values_at_start(&self) -> Values {
        let is_first = self.picture.name == self.request.picture.name;
        if is_first { self.request.settings.values.clone() } else { Values::default() }
    }

    /// Turn a knob, if there is one, by one step.
    fn turn(&mut self, knob: Option<&Knob>, up: bool) {
        if let Some(knob) = knob {
            self.values.set(knob, knob.turned(self.values.number(knob), up));
        }
    }

    /// Turn the camera by so many degrees.
    fn orbit(&mut self, yaw: f32, pitch: f32) {
        for (knob, by) in [(YAW, yaw), (PITCH, pitch)] {
            let Some(knob) = own(self.picture, &knob).filter(|_| by != 0.0) else { continue };
            if let Kind::Number { min, max, .. } = knob.kind {
                let value = self.values.number(knob) + by;
                // All the way round is where it began.
                let goes_round = max - min == 360.0 && !(min..=max).contains(&value);
                let value = if goes_round { (value - min).rem_euclid(360.0) + min } else { value.clamp(min, max) };
                self.values.set(knob, value);
            }
        }
    }

    /// Go to the next or previous picture of the chapter.
    fn leaf(&mut self, forward: bool) -> Effect {
        let pictures = self.chapter.pictures;
        if let Output::File(_) = self.request.output {
            return Effect::Refuse("other pictures only without --output: they would take the same file");
        }
        if pictures.len() < 2 {
            return Effect::Refuse("this chapter has no other picture");
        }
        let now = pictures.iter().position(|p| p.name == self.picture.name).unwrap_or(0);
        let next = (now + if forward { 1 } else { pictures.len() - 1 }) % pictures.len();
        self.picture = &pictures[next];
        self.values = self.values_at_start();
        self.chosen = 0;
        Effect::Render
    }

    /// The knobs and their values as text.
    pub(crate) fn lines(&self) -> Vec<Line> {
        let width = self.knobs().map(|knob| knob.name.chars().count()).max().unwrap_or(0);
        let mut lines = Vec::new();
        for (i, knob) in self.knobs().enumerate() {
            let (mark, color) = if i == self.chosen { ('>', YELLOW) } else { (' ', WHITE) };
            let value = knob.show(self.values.number(knob));
            lines.push(Line::new(format!("{mark}{} {:width$}  {value}", i + 1, knob.name), color));
        }
        if let Some(knob) = self.knobs().nth(self.chosen) {
            lines.push(Line::new(format!("   {}", knob.what), GREY));
        }
        let camera = ORBIT.iter().filter_map(|knob| own(self.picture, knob));
        let camera: Vec<_> =
            camera.map(|knob| format!("{} {}", knob.name, knob.show(self.values.number(knob)))).collect();
        if !camera.is_empty() {
            lines.push(Line::new(format!(" {}", camera.join("  ")), WHITE));
        }
        lines
    }

    /// The picture's name and all keys as text.
    pub(crate) fn help_lines(&self) -> Vec<Line> {
        let title = Line::new(format!("{}: {}", self.chapter.title, self.picture.name), YELLOW);
        let width = HELP.iter().map(|(keys, _)| keys.len()).max().unwrap_or(0);
        let keys = HELP.iter().map(|(keys, what)| Line::new(format!("{keys:width$}  {what}"), WHITE));
        std::iter::once(title).chain(keys).collect()
    }
}

/// The picture's own knob of that name, which may have another range or default.
fn own(picture: &'static Picture, knob: &Knob) -> Option<&'static Knob> {
    picture.knobs.iter().find(|k| k.name == knob.name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::window::fixture::{CHAPTER, request};

    fn value(controls: &Controls, name: &str) -> f32 {
        let knob = controls.picture.knobs.iter().find(|k| k.name == name).unwrap();
        controls.values.number(knob)
    }

    #[test]
    fn the_camera_goes_round_and_stops_at_the_poles() {
        let request = request();
        let mut controls = Controls::new(&CHAPTER, &request);
        assert_eq!(controls.apply(Action::Orbit { yaw: 170.0, pitch: 80.0 }), Effect::Render);
        assert_eq!(controls.apply(Action::Orbit { yaw: 20.0, pitch: 20.0 }), Effect::Render);
        assert_eq!((value(&controls, "yaw"), value(&controls, "pitch")), (-170.0, 90.0));
        assert_eq!(controls.apply(Action::Orbit { yaw: 0.0, pitch: 1.0 }), Effect::Overlay);
        controls.apply(Action::Orbit { yaw: -20.5, pitch: 0.0 });
        assert_eq!(value(&controls, "yaw"), 169.5);
    }

    #[test]
    fn zoom_has_short_numbers_and_stays_in_range() {
        let request = request();
        let mut controls = Controls::new(&CHAPTER, &request);
        for _ in 0..3 {
            controls.apply(Action::Zoom { nearer: true });
        }
        assert_eq!(value(&controls, "zoom"), 1.331);
        for _ in 0..99 {
            controls.apply(Action::Zoom { nearer: true });
        }
        assert_eq!(value(&controls, "zoom"), 10.0);
    }

    #[test]
    fn knobs_are_chosen_turned_and_reset() {
        let request = request();
        let mut controls = Controls::new(&CHAPTER, &request);
        assert_eq!(controls.apply(Action::Turn { up: true }), Effect::Render);
        assert_eq!(value(&controls, "rings"), 5.0);
        assert_eq!(controls.apply(Action::ChooseNext { forward: false }), Effect::Overlay);
        assert_eq!(controls.apply(Action::Turn { up: true }), Effect::Render);
        assert_eq!(value(&controls, "broken"), 1.0);
        controls.apply(Action::ChooseNext { forward: true });
        controls.apply(Action::Choose(9));
        controls.apply(Action::Turn { up: false });
        assert_eq!(value(&controls, "rings"), 4.0);
        assert_eq!(controls.apply(Action::Reset), Effect::Render);
        assert_eq!(controls.values, request.settings.values);
    }

    #[test]
    fn pictures_without_knobs_ignore_them() {
        let request = request();
        let mut controls = Controls::new(&CHAPTER, &request);
        assert_eq!(controls.apply(Action::Leaf { forward: false }), Effect::Render);
        assert_eq!(controls.picture.name, "plain");
        for action in [
            Action::Orbit { yaw: 1.0, pitch: 1.0 },
            Action::Zoom { nearer: true },
            Action::Turn { up: true },
            Action::ChooseNext { forward: false },
            Action::Choose(0),
        ] {
            assert_eq!(controls.apply(action), Effect::Overlay);
        }
        assert!(controls.lines().is_empty());
    }

    #[test]
    fn an_output_file_belongs_to_one_picture() {
        let request = Request { output: Output::File("a.png".into()), ..request() };
        let mut controls = Controls::new(&CHAPTER, &request);
        assert!(matches!(controls.apply(Action::Leaf { forward: true }), Effect::Refuse(_)));
        assert_eq!(controls.picture.name, request.picture.name);
    }

    #[test]
    fn the_text_tells_all_knobs() {
        let request = request();
        let mut controls = Controls::new(&CHAPTER, &request);
        controls.apply(Action::Choose(1));
        let lines = controls.lines();
        let texts: Vec<_> = lines.iter().map(|line| line.text.as_str()).collect();
        assert_eq!(
            texts,
            [" 1 rings   4", ">2 broken  off", "   whether it cannot be made", " yaw 0°  pitch 0°  zoom 1 times"]
        );
        assert_eq!(lines[1].color, YELLOW);
        assert!(controls.help_lines().iter().all(|line| line.text.chars().count() <= 37));
    }
}
