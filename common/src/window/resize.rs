//! When a window that changes its size has come to rest.

use std::time::{Duration, Instant};

/// Width and height in pixels.
pub(crate) type Extent = (usize, usize);

/// Waits until a size is stable.
#[derive(Debug)]
pub(crate) struct Rest {
    opened: Instant,
    accepted: Extent,
    last: Extent,
    since: Instant,
}

impl Rest {
    /// A size is stable when it has not changed for this long.
    const STABLE: Duration = Duration::from_millis(150);
    /// Window managers that set sizes themselves do so within this time.
    const SETTLING: Duration = Duration::from_millis(500);

    /// The window was opened with that size.
    pub(crate) fn new(size: Extent, now: Instant) -> Self {
        Self { opened: now, accepted: size, last: size, since: now }
    }

    /// The window has this size now. Some, once for each new size, when it came to rest there.
    pub(crate) fn watch(&mut self, size: Extent, now: Instant) -> Option<Extent> {
        if size != self.last {
            (self.last, self.since) = (size, now);
        }
        // Nobody asked for a picture of another size when the window manager chose the size of the window.
        if now - self.opened < Self::SETTLING {
            self.accepted = size;
        }
        if size == self.accepted || now - self.since < Self::STABLE {
            return None;
        }
        self.accepted = size;
        Some(size)
    }
}

/// The size of the window for a picture: its own, but neither too small to see nor larger than most screens.
pub(crate) fn opening((width, height): Extent) -> Extent {
    const SMALLEST: usize = 480;
    const LARGEST: Extent = (1600, 900);
    // Whole multiples, so that all pixels of the picture are equally large.
    let times = SMALLEST.div_ceil(width.max(height).max(1));
    let (width, height) = (width * times, height * times);
    // The larger of the two ratios decides, each as numerator and denominator.
    let (n, d) = if width * LARGEST.1 > height * LARGEST.0 { (LARGEST.0, width) } else { (LARGEST.1, height) };
    if n >= d { (width, height) } else { ((width * n / d).max(1), (height * n / d).max(1)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_size_at_rest_counts_and_only_once() {
        let start = Instant::now();
        let at = |ms: u64| start + Duration::from_millis(ms);
        let mut rest = Rest::new((640, 360), start);
        // The window manager's own choice.
        assert_eq!(rest.watch((800, 360), at(100)), None);
        assert_eq!(rest.watch((800, 360), at(1000)), None);
        // The user's.
        assert_eq!(rest.watch((801, 360), at(2000)), None);
        assert_eq!(rest.watch((850, 360), at(2100)), None);
        assert_eq!(rest.watch((850, 360), at(2200)), None);
        assert_eq!(rest.watch((850, 360), at(2250)), Some((850, 360)));
        assert_eq!(rest.watch((850, 360), at(9000)), None);
        // There and back again.
        assert_eq!(rest.watch((900, 360), at(9100)), None);
        assert_eq!(rest.watch((850, 360), at(9200)), None);
        assert_eq!(rest.watch((850, 360), at(9900)), None);
    }

    #[test]
    fn windows_open_at_a_size_to_look_at() {
        assert_eq!(opening((640, 360)), (640, 360));
        assert_eq!(opening((16, 9)), (480, 270));
        assert_eq!(opening((1, 1)), (480, 480));
        assert_eq!(opening((1920, 1080)), (1600, 900));
        assert_eq!(opening((1000, 2000)), (450, 900));
        assert_eq!(opening((65_535, 1)), (1600, 1));
    }
}
