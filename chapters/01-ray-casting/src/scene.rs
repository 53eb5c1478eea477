//! The scene: shapes with their materials, and lights.

use common::{Interval, Rgb};

use crate::{background::Background, hit::Hit, light::Light, ray::Ray, shape::Shape};

// ANCHOR: scene
/// Everything there is to see, generic in what a material is.
pub struct Scene<Material> {
    /// The things that rays can hit.
    pub objects: Vec<Object<Material>>,
    /// The abstract lights.
    pub lights: Vec<Box<dyn Light>>,
    /// `L_a`: the light that is taken to come from everywhere.
    pub ambient: Rgb,
    /// What a ray sees that hits nothing.
    pub background: Box<dyn Background>,
}

/// A shape and what it is made of.
pub struct Object<Material> {
    /// What to call it in a pixel's story.
    pub name: &'static str,
    /// Its form.
    pub shape: Box<dyn Shape>,
    /// What it is made of.
    pub material: Material,
}
// ANCHOR_END: scene

impl<Material> Scene<Material> {
    /// A dark, empty scene.
    #[must_use]
    pub fn new() -> Self {
        Self { objects: Vec::new(), lights: Vec::new(), ambient: Rgb::ZERO, background: Box::new(Rgb::ZERO) }
    }

    /// Put an object into the scene.
    pub fn add(&mut self, name: &'static str, shape: impl Shape + 'static, material: Material) -> &mut Self {
        self.objects.push(Object { name, shape: Box::new(shape), material });
        self
    }

    /// Put a light into the scene.
    pub fn light(&mut self, light: impl Light + 'static) -> &mut Self {
        self.lights.push(Box::new(light));
        self
    }

    /// Put the scene into surroundings: one color, or anything else that answers for every direction.
    pub fn surround(&mut self, background: impl Background + 'static) -> &mut Self {
        self.background = Box::new(background);
        self
    }

    // ANCHOR: nearest
    /// The nearest hit over all objects, and the object that was hit.
    #[must_use]
    pub fn intersect(&self, ray: &Ray, range: Interval) -> Option<(Hit, &Object<Material>)> {
        let mut nearest = None;
        let mut range = range;
        for object in &self.objects {
            if let Some(hit) = object.shape.intersect(ray, range) {
                // From now on only nearer hits count.
                range = range.up_to(hit.t);
                nearest = Some((hit, object));
            }
        }
        nearest
    }
    // ANCHOR_END: nearest

    // ANCHOR: occluded
    /// Whether anything at all is hit inside `range`. The first object that is hit answers.
    #[must_use]
    #[inline]
    pub fn occluded(&self, ray: &Ray, range: Interval) -> bool {
        self.objects.iter().any(|object| object.shape.occluded(ray, range))
    }
    // ANCHOR_END: occluded
}

impl<Material> Default for Scene<Material> {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use common::Vec3;

    use super::*;
    use crate::sphere::Sphere;

    #[test]
    fn the_nearest_of_all_wins_whatever_the_order() {
        let ray = Ray::new(Vec3::ZERO, Vec3::Z);
        for distances in [[3.0, 5.0, 9.0], [9.0, 5.0, 3.0], [5.0, 3.0, 9.0]] {
            let mut scene = Scene::new();
            for z in distances {
                scene.add("ball", Sphere::new(Vec3::Z * z, 1.0), z);
            }
            let (hit, object) = scene.intersect(&ray, Interval::POSITIVE).unwrap();
            assert_eq!((hit.t, object.material), (2.0, 3.0));
            // What lies before the range is passed over.
            assert_eq!(scene.intersect(&ray, Interval::new(4.0, 99.0)).unwrap().1.material, 5.0);
            assert!(scene.occluded(&ray, Interval::POSITIVE));
            assert!(!scene.occluded(&ray, Interval::new(0.0, 2.0)) && !scene.occluded(&ray, Interval::new(10.0, 99.0)));
        }
        assert!(Scene::<f32>::new().intersect(&ray, Interval::POSITIVE).is_none());
    }
}
