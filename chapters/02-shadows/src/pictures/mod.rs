//! The pictures of this chapter.

mod still_life;

use common::picture::Chapter;

/// Chapter 2 with all its pictures.
pub const CHAPTER: Chapter = Chapter { number: 2, name: "shadows", title: "Shadows", pictures: &[still_life::PICTURE] };
