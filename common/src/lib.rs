//! What no chapter of the course teaches: the film, random streams, the picture contract, the renderer, the command
//! line and the window. It knows nothing of any chapter.
//!
//! The features `cli` (with it, files as output), `threads` and `window`, all on by default, are left out for
//! WebAssembly.

pub mod basis;
#[cfg(feature = "cli")]
pub mod cli;
pub mod color;
pub mod drawing;
pub mod error;
pub mod error_goal;
pub mod exercise;
pub mod film;
pub mod fingerprint;
pub mod float;
pub mod interval;
pub mod knob;
pub mod obj;
pub mod origin;
#[cfg(feature = "cli")]
pub mod output;
pub mod parallel;
pub mod picture;
pub mod random;
pub mod renderer;
pub mod report;
#[cfg(feature = "cli")]
pub mod state;
pub mod story;
#[cfg(feature = "window")]
pub mod window;

pub use glam::{Mat3, Vec2, Vec3};

pub use crate::{basis::Basis, color::Rgb, error::Error, interval::Interval, random::Stream};
