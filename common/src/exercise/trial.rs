//! What is tried with an answer: it can be told when the answer panics, and when it never ends.

use std::{
    cell::RefCell,
    rc::Rc,
    sync::{
        Arc,
        atomic::{AtomicU64, Ordering},
        mpsc::Sender,
    },
    thread,
};

thread_local! {
    /// What was tried when the answer panicked in this thread.
    static TRIED: RefCell<Option<String>> = const { RefCell::new(None) };
    /// Who follows the trials of this thread; mostly nobody.
    static FOLLOWER: RefCell<Option<Rc<Follower>>> = const { RefCell::new(None) };
}

/// Do something with a student's answer. Should it panic or never end, `what` says what was tried.
pub fn trying<T>(what: impl Fn() -> String, act: impl FnOnce() -> T) -> T {
    struct Trial<F: Fn() -> String> {
        what: F,
        follower: Option<Rc<Follower>>,
        /// Number of the trial that this one is a part of.
        outer: u64,
    }
    impl<F: Fn() -> String> Drop for Trial<F> {
        fn drop(&mut self) {
            if thread::panicking() {
                TRIED.set(Some((self.what)()));
            }
            if let Some(follower) = &self.follower {
                follower.place.set(self.outer);
            }
        }
    }
    let follower = FOLLOWER.with_borrow(Clone::clone);
    let outer = follower.as_ref().map_or(Place::NOWHERE, |follower| follower.begin(&what));
    let _trial = Trial { what, follower, outer };
    act()
}

/// What was tried when the answer panicked in this thread.
pub(super) fn tried() -> Option<String> {
    TRIED.take()
}

/// Where a check is, to be seen from other threads.
#[derive(Debug, Default)]
pub(super) struct Place {
    /// How many trials have begun.
    begun: AtomicU64,
    /// Number of the trial at work, counted from 1, or [`Place::NOWHERE`].
    now: AtomicU64,
}

impl Place {
    /// Between two trials.
    pub(super) const NOWHERE: u64 = 0;

    /// How many trials have begun.
    pub(super) fn begun(&self) -> u64 {
        self.begun.load(Ordering::Relaxed)
    }

    /// Number of the trial at work, counted from 1, or [`Place::NOWHERE`].
    pub(super) fn now(&self) -> u64 {
        self.now.load(Ordering::Relaxed)
    }

    fn set(&self, number: u64) {
        self.now.store(number, Ordering::Relaxed);
    }
}

/// Follows the trials of one thread.
pub(super) struct Follower {
    /// Where the thread is.
    pub(super) place: Arc<Place>,
    /// Which trials are put into words before they begin.
    pub(super) telling: Telling,
}

/// Which trials are put into words, and for whom.
pub(super) enum Telling {
    /// None of them: it takes time.
    Nothing,
    /// The one of that number, for another thread.
    One(u64, Sender<String>),
    /// Each of them.
    Each(fn(&str)),
}

impl Follower {
    /// Follow the trials of this thread from now on.
    pub(super) fn follow(self) {
        FOLLOWER.set(Some(Rc::new(self)));
    }

    /// A trial begins. The number of the one that it is a part of.
    fn begin(&self, what: impl Fn() -> String) -> u64 {
        let number = self.place.begun.fetch_add(1, Ordering::Relaxed) + 1;
        let outer = self.place.now();
        self.place.set(number);
        match &self.telling {
            Telling::One(told, teller) if *told == number => {
                // Nobody listens any more only after the verdict is known.
                let _ = teller.send(what());
            }
            Telling::Each(tell) => tell(&what()),
            Telling::Nothing | Telling::One(..) => {}
        }
        outer
    }
}

#[cfg(test)]
mod tests {
    use std::sync::mpsc;

    use super::*;

    #[test]
    fn what_was_tried_is_noted_only_when_it_panics() {
        assert_eq!(trying(|| unreachable!(), || 1), 1);
        assert!(std::panic::catch_unwind(|| trying(|| "a ray".into(), || assert_eq!(1, 2))).is_err());
        assert_eq!(tried().as_deref(), Some("a ray"));
    }

    #[test]
    fn a_follower_knows_the_trial_and_hears_of_the_one_it_wants() {
        let place = Arc::<Place>::default();
        let (teller, told) = mpsc::channel();
        Follower { place: place.clone(), telling: Telling::One(3, teller) }.follow();
        trying(
            || unreachable!(),
            || {
                trying(|| unreachable!(), || assert_eq!(place.now(), 2));
                assert_eq!(place.now(), 1);
                trying(|| "a ray".into(), || assert_eq!(place.now(), 3));
            },
        );
        assert_eq!((place.begun(), place.now()), (3, Place::NOWHERE));
        assert_eq!(told.try_iter().collect::<Vec<_>>(), ["a ray"]);
    }

    #[test]
    fn a_follower_hears_of_each_trial_before_it_begins() {
        thread_local! {
            static TOLD: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) };
        }
        let tell = |words: &str| TOLD.with_borrow_mut(|told| told.push(words.into()));
        Follower { place: Arc::default(), telling: Telling::Each(tell) }.follow();
        for ray in ["a ray", "another one"] {
            trying(|| ray.into(), || assert_eq!(TOLD.with_borrow(|told| told.last().cloned()).as_deref(), Some(ray)));
        }
        assert_eq!(TOLD.take(), ["a ray", "another one"]);
    }
}
