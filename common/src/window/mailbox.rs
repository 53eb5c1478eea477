//! Orders from the window to the worker. The window never waits; the worker looks when it likes.

use std::{
    sync::{
        Condvar, Mutex, MutexGuard, PoisonError,
        atomic::{AtomicBool, Ordering},
    },
    time::{Duration, Instant},
};

use crate::{film::Size, knob::Values, picture::Picture};

/// What is to be shown.
#[derive(Clone, Debug)]
pub(crate) struct View {
    /// Which picture.
    pub(crate) picture: &'static Picture,
    /// With which values of its knobs.
    pub(crate) values: Values,
    /// How large.
    pub(crate) size: Size,
    /// How many samples per pixel.
    pub(crate) samples: u32,
}

/// All orders that the worker has not taken yet.
#[derive(Debug, Default)]
pub(crate) struct Orders {
    /// Show this instead; a later view takes the place of an earlier one.
    pub(crate) view: Option<View>,
    /// Save the picture.
    pub(crate) save: bool,
    /// Save the picture and end.
    pub(crate) quit: bool,
    since: Option<Instant>,
}

/// How much of the present view there is to see.
#[derive(Debug, Default)]
pub(crate) struct Progress {
    /// A rough picture at least.
    pub(crate) rough: AtomicBool,
    /// A sample in every pixel.
    pub(crate) whole: AtomicBool,
}

/// Where the window leaves orders for the worker.
#[derive(Debug, Default)]
pub(crate) struct Mailbox {
    orders: Mutex<Orders>,
    news: Condvar,
    /// Whether there are orders: quick to ask.
    waiting: AtomicBool,
}

impl Mailbox {
    /// How long a new view waits for a rough picture of the old one, so that something is seen while dragging.
    const BEFORE_VIEW: Duration = Duration::from_millis(200);
    /// How long quitting waits for the first sample in every pixel; saving has time.
    const BEFORE_QUITTING: Duration = Duration::from_secs(1);

    /// Leave an order.
    pub(crate) fn post(&self, order: impl FnOnce(&mut Orders)) {
        let mut orders = lock(&self.orders);
        order(&mut orders);
        orders.since.get_or_insert_with(Instant::now);
        self.waiting.store(true, Ordering::Release);
        self.news.notify_all();
    }

    /// Take all orders; wait until there are some.
    pub(crate) fn take(&self) -> Orders {
        let orders = lock(&self.orders);
        let waited = self.news.wait_while(orders, |orders| orders.since.is_none());
        let mut orders = waited.unwrap_or_else(PoisonError::into_inner);
        self.waiting.store(false, Ordering::Release);
        std::mem::take(&mut orders)
    }

    /// Whether the present rendering should make way for the orders.
    pub(crate) fn is_urgent(&self, progress: &Progress) -> bool {
        self.waiting.load(Ordering::Acquire) && urgent(&lock(&self.orders), progress)
    }

    /// Whether the present rendering is of no use any more, because another view will take its place.
    pub(crate) fn is_overtaken(&self, progress: &Progress) -> bool {
        if !self.waiting.load(Ordering::Acquire) {
            return false;
        }
        let orders = lock(&self.orders);
        orders.view.is_some() && urgent(&orders, progress)
    }

    /// Something that orders to quit when it goes away, however that comes about.
    pub(crate) fn closing(&self) -> Closing<'_> {
        Closing(self)
    }
}

/// Whether orders have waited long enough.
fn urgent(orders: &Orders, progress: &Progress) -> bool {
    let (enough, patience) = match orders {
        Orders { view: Some(_), .. } => (&progress.rough, Mailbox::BEFORE_VIEW),
        Orders { quit: true, .. } => (&progress.whole, Mailbox::BEFORE_QUITTING),
        _ => (&progress.whole, Duration::MAX),
    };
    orders.since.is_some_and(|since| enough.load(Ordering::Acquire) || since.elapsed() > patience)
}

/// See [`Mailbox::closing`].
pub(crate) struct Closing<'a>(&'a Mailbox);

impl Drop for Closing<'_> {
    fn drop(&mut self) {
        self.0.post(|orders| orders.quit = true);
    }
}

/// Lock, also when another thread panicked meanwhile: what is kept here is whole at any time.
pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::window::fixture::request;

    fn view(samples: u32) -> View {
        let request = request();
        View { picture: request.picture, values: Values::default(), size: request.size, samples }
    }

    fn progress(rough: bool, whole: bool) -> Progress {
        Progress { rough: rough.into(), whole: whole.into() }
    }

    #[test]
    fn the_last_view_counts() {
        let mailbox = Mailbox::default();
        mailbox.post(|orders| orders.view = Some(view(1)));
        mailbox.post(|orders| orders.save = true);
        mailbox.post(|orders| orders.view = Some(view(2)));
        let orders = mailbox.take();
        assert_eq!((orders.view.map(|v| v.samples), orders.save, orders.quit), (Some(2), true, false));
        assert!(!mailbox.is_urgent(&progress(true, true)));
    }

    #[test]
    fn a_view_waits_for_a_rough_picture_and_saving_for_a_whole_one() {
        let mailbox = Mailbox::default();
        mailbox.post(|orders| orders.save = true);
        let urgent = |rough, whole| {
            let progress = progress(rough, whole);
            (mailbox.is_urgent(&progress), mailbox.is_overtaken(&progress))
        };
        assert_eq!(
            [urgent(false, false), urgent(true, false), urgent(true, true)],
            [(false, false), (false, false), (true, false)]
        );
        mailbox.post(|orders| orders.view = Some(view(1)));
        assert_eq!([urgent(false, false), urgent(true, false)], [(false, false), (true, true)]);
        // But not for ever.
        std::thread::sleep(Mailbox::BEFORE_VIEW + Duration::from_millis(20));
        assert_eq!(urgent(false, false), (true, true));
    }

    #[test]
    fn a_window_that_goes_away_ends_the_worker() {
        let mailbox = Mailbox::default();
        std::thread::scope(|scope| {
            let worker = scope.spawn(|| mailbox.take().quit);
            drop(mailbox.closing());
            assert!(worker.join().unwrap());
        });
    }
}
