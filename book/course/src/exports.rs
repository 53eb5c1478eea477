//! What a web page can call. A module for WebAssembly has no other way to be called than by names without mangling, and
//! those count as unsafe; nothing else here is.
#![allow(unsafe_code, reason = "only for the attribute no_mangle")]

use std::cell::RefCell;

thread_local! {
    /// The text that the page is about to read.
    static TEXT: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Make the table of fingerprints and return its length in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn make_bits() -> usize {
    TEXT.with_borrow_mut(|text| {
        *text = crate::bits::table(1);
        text.len()
    })
}

/// Where the text begins in the module's memory.
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    TEXT.with_borrow(|text| text.as_ptr())
}
