//! The pictures of this chapter.

use common::picture::Chapter;

use crate::reports::REPORTS;

/// Chapter 4 with all its pictures.
pub const CHAPTER: Chapter =
    Chapter { number: 4, name: "space-partitioning", title: "Space partitioning", pictures: &[], reports: REPORTS };
