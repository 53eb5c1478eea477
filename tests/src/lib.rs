//! Tests that look at the whole course from outside. They stand in `tests/course`; this library is empty.
