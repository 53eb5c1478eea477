//! The pictures of this chapter.

mod ambient;
mod barycentric;
mod by_hit;
mod edges;
mod far_sphere;
mod field_of_view;
mod hits;
mod implicit;
mod lights;
mod mesh;
mod normals;
mod pixels;
mod quadrics;
mod shading;
mod shininess;
mod sphere;
pub mod stage;
pub mod still_life;
mod terms;

use common::picture::Chapter;

/// Chapter 1 with all its pictures.
pub const CHAPTER: Chapter = Chapter {
    number: 1,
    name: "ray-casting",
    title: "Ray casting",
    pictures: &[
        still_life::PICTURE,
        hits::PICTURE,
        sphere::PICTURE,
        far_sphere::PICTURE,
        implicit::PICTURE,
        quadrics::PICTURE,
        edges::PICTURE,
        barycentric::PICTURE,
        mesh::PICTURE,
        shading::PICTURE,
        normals::PICTURE,
        field_of_view::PICTURE,
        pixels::PICTURE,
        terms::PICTURE,
        shininess::PICTURE,
        lights::PICTURE,
        ambient::PICTURE,
    ],
    reports: &[],
};
