//! The mouse: dragging turns the camera, the wheel brings it nearer.

use super::keys::Action;

/// Follows the left button.
#[derive(Debug, Default)]
pub(crate) struct Drag {
    last: Option<(f32, f32)>,
}

impl Drag {
    /// How far the camera turns for a pixel; a power of two, so that angles stay short numbers.
    const DEGREES_PER_PIXEL: f32 = 0.25;

    /// The mouse is at `position`, in pixels from the upper left, and its left button is down or not.
    ///
    /// What is seen follows the mouse: dragging to the right moves the camera to the left, dragging down lifts it.
    pub(crate) fn moved(&mut self, down: bool, position: Option<(f32, f32)>) -> Option<Action> {
        let now = position.filter(|_| down);
        let last = std::mem::replace(&mut self.last, now);
        let ((x, y), (last_x, last_y)) = (now?, last?);
        let [yaw, pitch] = [last_x - x, y - last_y].map(|pixels| pixels * Self::DEGREES_PER_PIXEL);
        (yaw != 0.0 || pitch != 0.0).then_some(Action::Orbit { yaw, pitch })
    }
}

/// The wheel was turned by so many notches, away from the user if positive.
pub(crate) fn wheel(notches: f32) -> impl Iterator<Item = Action> {
    // A fast wheel may give many notches at once; a camera that leaps is of no use.
    const MOST: usize = 5;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates, and NaN gives 0")]
    let times = notches.abs().ceil() as usize;
    std::iter::repeat_n(Action::Zoom { nearer: notches > 0.0 }, times.min(MOST))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_dragging_turns() {
        let mut drag = Drag::default();
        assert_eq!(drag.moved(false, Some((5.0, 5.0))), None);
        assert_eq!(drag.moved(true, Some((9.0, 9.0))), None);
        assert_eq!(drag.moved(true, Some((13.0, 7.0))), Some(Action::Orbit { yaw: -1.0, pitch: -0.5 }));
        assert_eq!(drag.moved(true, Some((13.0, 7.0))), None);
        assert_eq!(drag.moved(false, Some((20.0, 7.0))), None);
        assert_eq!(drag.moved(true, Some((30.0, 7.0))), None);
    }

    #[test]
    fn wheels_have_notches() {
        assert_eq!(wheel(2.0).collect::<Vec<_>>(), [Action::Zoom { nearer: true }; 2]);
        assert_eq!(wheel(-0.5).collect::<Vec<_>>(), [Action::Zoom { nearer: false }]);
        assert_eq!(wheel(-1e9).count(), 5);
        assert_eq!(wheel(f32::NAN).count() + wheel(0.0).count(), 0);
    }
}
