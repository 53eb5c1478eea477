//! The mesh: many triangles that share their vertices.

use common::{Error, Interval, Vec3, obj::ObjMesh};

use crate::{aabb::Aabb, hit::Hit, ray::Ray, shape::Shape, triangle::Triangle, triangle_barycentric::Shear};

// ANCHOR: mesh
/// A surface made of triangles.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    positions: Vec<Vec3>,
    /// For each triangle the indices of its corners.
    triangles: Vec<[u32; 3]>,
    normals: VertexNormals,
    bounds: Aabb,
}

/// Normals to shade a mesh with.
#[derive(Clone, Debug, PartialEq)]
enum VertexNormals {
    /// None: every triangle is shaded with its own normal.
    Flat,
    /// Unit normals, or zero where there is none, and for each triangle the indices of those in its corners.
    Smooth { normals: Vec<Vec3>, triangles: Vec<[u32; 3]> },
}
// ANCHOR_END: mesh

/// How a mesh is shaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shading {
    /// Each triangle by its own normal: facets show.
    Flat,
    /// By normals interpolated between the corners: the surface looks round.
    Smooth,
}

impl Mesh {
    /// The mesh of an OBJ file, with the file's own normals for smooth shading, or computed ones if it has none.
    ///
    /// # Errors
    /// [`Error::Picture`] if it has no triangle, or an index leads outside.
    pub fn new(obj: &ObjMesh, shading: Shading) -> Result<Self, Error> {
        let ObjMesh { positions, normals, triangles, triangle_normals } = obj;
        let outside = |indices: &[[u32; 3]], count| indices.iter().flatten().any(|&i| i as usize >= count);
        if outside(triangles, positions.len()) || outside(triangle_normals, normals.len()) {
            return Err(Error::Picture("a triangle of the mesh has a corner that does not exist".into()));
        }
        let bounds = Aabb::around(positions)
            .filter(|_| !triangles.is_empty())
            .ok_or_else(|| Error::Picture("the mesh has no triangle".into()))?;
        let normals = match shading {
            Shading::Flat => VertexNormals::Flat,
            Shading::Smooth if triangle_normals.len() == triangles.len() => {
                VertexNormals::Smooth { normals: unit(normals), triangles: triangle_normals.clone() }
            }
            Shading::Smooth => VertexNormals::Smooth {
                normals: unit(&mean_normals(positions, triangles)),
                triangles: triangles.clone(),
            },
        };
        Ok(Self { positions: positions.clone(), triangles: triangles.clone(), normals, bounds })
    }

    /// The box around all vertices.
    #[must_use]
    #[inline]
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// Number of triangles.
    #[must_use]
    pub fn len(&self) -> usize {
        self.triangles.len()
    }

    /// Whether there is no triangle; never so for a mesh that was made.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    /// Its triangles, in the file's order.
    pub fn triangles(&self) -> impl Iterator<Item = Triangle> {
        self.triangles.iter().map(|corners| self.with_corners(corners))
    }

    /// One of its triangles, counted from 0.
    ///
    /// # Panics
    /// If there are not so many.
    #[must_use]
    #[inline]
    pub fn triangle(&self, index: usize) -> Triangle {
        self.with_corners(&self.triangles[index])
    }

    /// The triangle between three vertices.
    #[inline]
    fn with_corners(&self, corners: &[u32; 3]) -> Triangle {
        Triangle { corners: corners.map(|i| self.positions[i as usize]) }
    }
}

impl Mesh {
    // ANCHOR: shaded
    /// All that is known about the place where a ray hits the triangle of that index at `t`.
    #[must_use]
    #[inline]
    pub fn hit(&self, ray: &Ray, index: usize, t: f32) -> Hit {
        let triangle = self.triangle(index);
        let flat = Hit::new(ray, t, triangle.normal()).among(triangle.farthest());
        // Interpolate the normals of the three corners by the weights of the hit.
        match &self.normals {
            VertexNormals::Flat => flat,
            VertexNormals::Smooth { normals, triangles } => {
                let [n1, n2, n3] = triangles[index].map(|i| normals[i as usize]);
                // The same hit once more, for its weights.
                let range = Interval::new(t.next_down(), t.next_up());
                let Some(hit) = triangle.hit_by_barycentric(&Shear::along(ray), range) else { return flat };
                let [alpha, beta, gamma] = hit.weights;
                flat.shaded_with(n1 * alpha + n2 * beta + n3 * gamma)
            }
        }
    }
    // ANCHOR_END: shaded
}

/// The same normals with unit length, or zero.
fn unit(normals: &[Vec3]) -> Vec<Vec3> {
    normals.iter().map(|n| n.normalize_or_zero()).collect()
}

// ANCHOR: mean
/// For each vertex the sum of the normals of the triangles around it. The normals have twice their triangle's area as
/// length, so that large triangles count more.
fn mean_normals(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    let mut normals = vec![Vec3::ZERO; positions.len()];
    for corners in triangles {
        let normal = Triangle { corners: corners.map(|i| positions[i as usize]) }.normal();
        for &corner in corners {
            normals[corner as usize] += normal;
        }
    }
    normals
}
// ANCHOR_END: mean

// ANCHOR: intersect
impl Shape for Mesh {
    fn intersect(&self, ray: &Ray, range: Interval) -> Option<Hit> {
        // The nearest hit over all triangles.
        let along = Shear::along(ray);
        let mut nearest = None;
        let mut range = range;
        for (i, triangle) in self.triangles().enumerate() {
            if let Some(hit) = triangle.hit_by_barycentric(&along, range) {
                range = range.up_to(hit.t);
                nearest = Some((i, hit.t));
            }
        }
        let (i, t) = nearest?;
        Some(self.hit(ray, i, t))
    }
    // ANCHOR_END: intersect

    // ANCHOR: occluded
    fn occluded(&self, ray: &Ray, range: Interval) -> bool {
        let along = Shear::along(ray);
        self.triangles().any(|triangle| triangle.hit_by_barycentric(&along, range).is_some())
    }
    // ANCHOR_END: occluded
}
