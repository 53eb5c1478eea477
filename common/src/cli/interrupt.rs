//! Ctrl-C: the first one ends a rendering well, the second one ends the program at once.

use std::sync::{
    Arc, OnceLock,
    atomic::{AtomicBool, Ordering},
};

use signal_hook::{
    consts::{SIGINT, SIGTERM},
    flag,
};

/// Set by the first signal. There is one for the whole program, as there is one Ctrl-C.
static ASKED: OnceLock<Arc<AtomicBool>> = OnceLock::new();

/// From now on, Ctrl-C asks to end. (So does SIGTERM, which a system sends that shuts down.)
pub(crate) fn listen() {
    let asked = ASKED.get_or_init(|| {
        let asked = Arc::new(AtomicBool::new(false));
        for signal in [SIGINT, SIGTERM] {
            // In this order, so that the signal that sets the flag does not end the program by itself. Where signals
            // cannot be caught they end the program, as they do without us.
            let _ = flag::register_conditional_shutdown(signal, 128 + signal, Arc::clone(&asked));
            let _ = flag::register(signal, Arc::clone(&asked));
        }
        asked
    });
    asked.store(false, Ordering::Relaxed);
}

/// Whether somebody asked to end.
pub(crate) fn is_asked() -> bool {
    ASKED.get().is_some_and(|asked| asked.load(Ordering::Relaxed))
}
