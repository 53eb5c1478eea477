//! The pictures of this chapter.

use common::picture::Chapter;

use crate::reports::REPORTS;

/// Chapter 5 with all its pictures.
pub const CHAPTER: Chapter =
    Chapter { number: 5, name: "sampling", title: "Monte Carlo sampling", pictures: &[], reports: REPORTS };
