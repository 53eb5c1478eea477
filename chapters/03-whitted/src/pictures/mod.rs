//! The pictures of this chapter.

mod cover;
mod minray;

use common::picture::Chapter;

/// Chapter 3 with all its pictures.
pub const CHAPTER: Chapter =
    Chapter { number: 3, name: "whitted", title: "Recursive ray tracing", pictures: &[cover::PICTURE, minray::PICTURE] };
