//! The pictures of this chapter.

mod knobs;
pub mod room;

use common::picture::Chapter;

/// Chapter 6 with all its pictures.
pub const CHAPTER: Chapter =
    Chapter { number: 6, name: "path-tracing", title: "Path tracing", pictures: &[room::PICTURE], reports: &[] };
