//! The keyboard: which key does what.

use std::sync::mpsc::Sender;

use minifb::{InputCallback, Key};

/// What a key or the mouse asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Action {
    /// Turn the camera by so many degrees, to the right and up.
    Orbit {
        /// To the right.
        yaw: f32,
        /// Up.
        pitch: f32,
    },
    /// Bring the camera nearer or farther by one step.
    Zoom {
        /// Nearer.
        nearer: bool,
    },
    /// Choose a knob by its index.
    Choose(usize),
    /// Choose the next or previous knob.
    ChooseNext {
        /// The next.
        forward: bool,
    },
    /// Turn the chosen knob by one step.
    Turn {
        /// To a greater value.
        up: bool,
    },
    /// All knobs as they were at the start.
    Reset,
    /// Go to the next or previous picture.
    Leaf {
        /// The next.
        forward: bool,
    },
    /// Save the picture.
    Save,
    /// Show or hide the help.
    Help,
    /// Keep the knobs in view or let them go.
    Pin,
    /// Save the picture and quit.
    Quit,
}

// ANCHOR: help
/// All keys in the order of the help text, with what they do.
pub(crate) const HELP: [(&str, &str); 11] = [
    ("drag, arrows", "turn the camera"),
    ("wheel, + -", "zoom"),
    ("Tab, 1 to 9", "choose a knob"),
    (". Page Up", "turn it up"),
    (", Page Down", "turn it down"),
    ("R", "all as at the start"),
    ("K", "keep knobs in view"),
    ("N, P", "next, previous picture"),
    ("S", "save the picture"),
    ("H", "hide this help"),
    ("Esc", "save and quit"),
];
// ANCHOR_END: help

/// One press of a key. Keys that write a letter come as that letter, so that every keyboard layout works.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Press {
    /// A letter, digit or sign.
    Letter(char),
    /// Another key, with Shift or without.
    Key(Key, bool),
}

impl Press {
    /// What it asks for. `repeated` means that the key is being held down.
    pub(crate) fn action(self, repeated: bool) -> Option<Action> {
        let action = match self {
            Self::Letter(letter) => of_letter(letter),
            Self::Key(key, shift) => of_key(key, shift),
        };
        action.filter(|action| !repeated || action.may_repeat())
    }
}

impl Action {
    /// Whether it goes on while the key is held down.
    fn may_repeat(self) -> bool {
        matches!(self, Self::Orbit { .. } | Self::Zoom { .. } | Self::Turn { .. } | Self::ChooseNext { .. })
    }
}

/// What a letter asks for.
fn of_letter(letter: char) -> Option<Action> {
    Some(match letter.to_ascii_lowercase() {
        // Without Shift, the key + of an American keyboard writes =.
        '+' | '=' => Action::Zoom { nearer: true },
        '-' | '_' => Action::Zoom { nearer: false },
        '.' | ']' => Action::Turn { up: true },
        ',' | '[' => Action::Turn { up: false },
        digit @ '1'..='9' => Action::Choose(digit as usize - '1' as usize),
        'r' => Action::Reset,
        'n' => Action::Leaf { forward: true },
        'p' => Action::Leaf { forward: false },
        's' => Action::Save,
        'h' | '?' => Action::Help,
        'k' => Action::Pin,
        'q' => Action::Quit,
        _ => return None,
    })
}

/// What a key that writes nothing asks for.
fn of_key(key: Key, shift: bool) -> Option<Action> {
    const DEGREES: f32 = 5.0;
    Some(match key {
        Key::Left => Action::Orbit { yaw: -DEGREES, pitch: 0.0 },
        Key::Right => Action::Orbit { yaw: DEGREES, pitch: 0.0 },
        Key::Up => Action::Orbit { yaw: 0.0, pitch: DEGREES },
        Key::Down => Action::Orbit { yaw: 0.0, pitch: -DEGREES },
        Key::Tab => Action::ChooseNext { forward: !shift },
        Key::PageUp => Action::Turn { up: true },
        Key::PageDown => Action::Turn { up: false },
        Key::F1 => Action::Help,
        Key::Escape => Action::Quit,
        _ => return None,
    })
}

/// Hears every key, however quickly it was tapped, and passes on what it asks for.
pub(crate) struct Ear {
    to: Sender<Action>,
    held: Vec<Key>,
    repeated: bool,
}

impl Ear {
    /// An ear that tells `to`.
    pub(crate) fn new(to: Sender<Action>) -> Self {
        Self { to, held: Vec::new(), repeated: false }
    }

    fn hear(&self, press: Press) {
        if let Some(action) = press.action(self.repeated) {
            // If nobody listens any more, the window is closing.
            let _ = self.to.send(action);
        }
    }
}

impl InputCallback for Ear {
    /// Called after `set_key_state`, for keys that write something.
    fn add_char(&mut self, letter: u32) {
        if let Some(letter) = char::from_u32(letter) {
            self.hear(Press::Letter(letter));
        }
        self.repeated = false;
    }

    fn set_key_state(&mut self, key: Key, down: bool) {
        self.repeated = down && self.held.contains(&key);
        if !down {
            self.held.retain(|held| *held != key);
            return;
        }
        if !self.repeated {
            self.held.push(key);
        }
        let shift = self.held.iter().any(|held| matches!(held, Key::LeftShift | Key::RightShift));
        self.hear(Press::Key(key, shift));
    }
}

#[cfg(test)]
mod tests {
    use std::sync::mpsc;

    use super::*;

    /// What an ear makes of these keys, each down (with the letter that it writes) or up.
    fn heard(events: &[(Key, bool, Option<char>)]) -> Vec<Action> {
        let (to, from) = mpsc::channel();
        let mut ear = Ear::new(to);
        for (key, down, letter) in events {
            ear.set_key_state(*key, *down);
            if let Some(letter) = letter {
                ear.add_char(u32::from(*letter));
            }
        }
        from.try_iter().collect()
    }

    #[test]
    fn letters_count_not_places_on_the_keyboard() {
        // The key + of a German keyboard, which minifb does not know, and a 3 that needs Shift in France.
        let (to, from) = mpsc::channel();
        let mut ear = Ear::new(to);
        ear.add_char(u32::from('+'));
        ear.set_key_state(Key::LeftShift, true);
        ear.add_char(u32::from('3'));
        ear.add_char(u32::from('S'));
        ear.add_char(u32::MAX);
        let expected = [Action::Zoom { nearer: true }, Action::Choose(2), Action::Save];
        assert_eq!(from.try_iter().collect::<Vec<_>>(), expected);
    }

    #[test]
    fn tab_goes_forward_and_with_shift_back() {
        let (tab, shift) = (Key::Tab, Key::RightShift);
        let up_down = [(tab, true, Some('\t')), (tab, false, None), (shift, true, None), (tab, true, None)];
        assert_eq!(heard(&up_down), [true, false].map(|forward| Action::ChooseNext { forward }));
    }

    #[test]
    fn held_keys_turn_but_do_not_toggle() {
        let help = (Key::H, true, Some('h'));
        assert_eq!(heard(&[help, help, help, (Key::H, false, None), help]), [Action::Help; 2]);
        let right = (Key::Right, true, None);
        assert_eq!(heard(&[right, right, right]).len(), 3);
    }

    #[test]
    fn every_action_has_a_key_and_a_line_of_help() {
        for (keys, _) in HELP {
            let first = keys.chars().next().unwrap();
            let known = of_letter(first).is_some() || ["drag", "wheel", "Tab", "Esc"].iter().any(|k| keys.contains(k));
            assert!(known, "{keys}");
        }
        assert_eq!(of_key(Key::Escape, false), Some(Action::Quit));
        assert_eq!(of_letter('x'), None);
        assert_eq!(of_key(Key::LeftAlt, false), None);
    }
}
