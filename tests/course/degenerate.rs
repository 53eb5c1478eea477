//! Structures over whatever there can be: nothing, one, many in one place, flat, points, huge, tiny, and no numbers.

use std::sync::Arc;

use common::{Interval, Stream, Vec3, obj::ObjMesh};
use proptest::prelude::*;
use ray_casting::{
    mesh::{Mesh, Shading},
    ray::Ray,
    shape::Shape as _,
    sphere::Sphere,
    triangle::Triangle,
};
use space_partitioning::{
    bounding_volume::BoundingVolume,
    choice::Choice,
    every_one::every_one,
    grid::{Grid, grid},
    kd_tree::{KdTree, kd_tree, split::Rule},
    octree::{Octree, octree},
    primitives::{Bounded, Primitives},
    query::Found,
    structure::{Partition, Structure, StructureError},
    triangles::Triangles,
};

use crate::soups::soups;

/// What must hold for a structure, whatever it holds.
fn check<P: Primitives + Clone>(primitives: &P, rays: &[Ray]) -> Result<(), String> {
    check_in(Interval::POSITIVE, primitives, rays)
}

/// The same for hits in a range.
fn check_in<P: Primitives + Clone>(range: Interval, primitives: &P, rays: &[Ray]) -> Result<(), String> {
    /// Rays, and the nearest hit of each; and where hits count.
    type Asked<'r> = (Vec<(&'r Ray, Option<Found>)>, Interval);
    fn one<P: Primitives, T: Partition<P>>(
        structure: &Structure<P, T>,
        (rays, range): &Asked<'_>,
    ) -> Result<(), String> {
        structure.validate()?;
        for &(ray, expected) in rays {
            let found = structure.nearest(ray, *range, &mut ());
            if found != expected {
                return Err(format!("{found:?} instead of {expected:?} for {ray:?}"));
            }
            if structure.occluded(ray, *range) != expected.is_some() {
                return Err(format!("occlusion of {ray:?}"));
            }
        }
        Ok(())
    }
    let error = |error: StructureError| error.to_string();
    let all = every_one(primitives.clone()).map_err(error)?;
    let asked = (rays.iter().map(|ray| (ray, all.nearest(ray, range, &mut ()))).collect(), range);
    one(&grid(primitives.clone()).map_err(error)?, &asked).map_err(|e| format!("grid: {e}"))?;
    one(&octree(primitives.clone()).map_err(error)?, &asked).map_err(|e| format!("octree: {e}"))?;
    one(&kd_tree(primitives.clone()).map_err(error)?, &asked).map_err(|e| format!("kd-tree: {e}"))?;
    let few = |few| Structure { partition: Octree::over(primitives, few).unwrap(), primitives: primitives.clone() };
    one(&few(1), &asked).map_err(|e| format!("octree with few = 1: {e}"))?;
    let median = |few| {
        let partition = KdTree::over(primitives, Rule::Median { few }).unwrap();
        Structure { partition, primitives: primitives.clone() }
    };
    one(&median(1), &asked).map_err(|e| format!("median kd-tree: {e}"))?;
    let dense =
        |density| Structure { partition: Grid::over(primitives, density).unwrap(), primitives: primitives.clone() };
    one(&dense(0.01), &asked).map_err(|e| format!("grid of few cells: {e}"))?;
    // Checking many cells with many primitives in each would take too long.
    if primitives.count() < 400 {
        one(&dense(20.0), &asked).map_err(|e| format!("grid of many cells: {e}"))?;
    }
    Ok(())
}

/// Rays from around everything toward everything.
fn rays(points: &[Vec3], seed: u64) -> Vec<Ray> {
    let mut random = Stream::new(seed, 0, 0);
    let size = points.iter().map(|p| p.abs().max_element()).fold(1e-6, f32::max);
    let mut any = || points[((random.uniform() * points.len() as f32) as usize).min(points.len() - 1)];
    let ends: Vec<(Vec3, Vec3)> = (0..40).map(|_| (any(), any())).collect();
    let mut random = Stream::new(seed, 1, 0);
    let mut jitter = || Vec3::from_array([(); 3].map(|()| random.uniform() * 2.0 - 1.0)) * size;
    let aimed = |from: Vec3, to: Vec3| Ray::new(from, (to - from).try_normalize().unwrap_or(Vec3::Y));
    let mixed = ends.into_iter().flat_map(|(a, b)| {
        [
            aimed(a + jitter() * 3.0, b),
            aimed(a, b),
            Ray::new(a - Vec3::X * 2.0 * size, Vec3::X),
            aimed(jitter(), jitter()),
        ]
    });
    mixed.collect()
}

fn mesh(corners: &[Vec3]) -> Triangles {
    let triangles = (0..corners.len() as u32 / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let obj = ObjMesh { positions: corners.to_vec(), triangles, ..ObjMesh::default() };
    Triangles(Arc::new(Mesh::new(&obj, Shading::Flat).unwrap()))
}

#[test]
fn every_soup_makes_valid_structures() {
    for soup in soups(&mut Stream::new(5, 6, 7)) {
        let corners: Vec<_> = soup.mesh.triangles().flat_map(|t| t.corners).collect();
        let checked = check(&Triangles(Arc::clone(&soup.mesh)), &rays(&corners, 1));
        assert_eq!(checked, Ok(()), "{}", soup.name);
    }
}

#[test]
fn nothing_is_never_hit() {
    let nothing: Vec<Sphere> = Vec::new();
    assert_eq!(check(&nothing, &[Ray::new(Vec3::ZERO, Vec3::X)]), Ok(()));
    // A structure of empty structures is empty too, and one of full ones is not.
    let empty = kd_tree(nothing).unwrap();
    let full = kd_tree(vec![Sphere::new(Vec3::X * 5.0, 1.0)]).unwrap();
    let both = grid(vec![empty, full]).unwrap();
    let hit = both.intersect(&Ray::new(Vec3::ZERO, Vec3::X), Interval::POSITIVE).unwrap();
    assert_eq!(hit.t, 4.0);
}

#[test]
fn a_thousand_in_one_place() {
    let triangle = [Vec3::ZERO, Vec3::X, Vec3::Y];
    let corners: Vec<_> = (0..1000).flat_map(|_| triangle).collect();
    assert_eq!(check(&mesh(&corners), &rays(&triangle, 2)), Ok(()));
    let points = vec![Vec3::splat(0.3); 3000];
    assert_eq!(check(&mesh(&points), &rays(&[Vec3::splat(0.3), Vec3::ONE], 3)), Ok(()));
    assert_eq!(check(&vec![Sphere::new(Vec3::ONE, 0.5); 1000], &rays(&[Vec3::ZERO, Vec3::ONE], 4)), Ok(()));
}

#[test]
fn what_is_no_number_is_refused_in_words() {
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX] {
        for place in 0..9 {
            let mut corners = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z, Vec3::X, Vec3::ONE];
            corners[3 + place / 3][place % 3] = bad;
            for choice in Choice::ALL {
                let Err(error) = choice.over(Arc::clone(&mesh(&corners).0)) else { panic!("{bad} is taken") };
                assert!(error.to_string().starts_with("primitive 1 has a box from"), "{error}");
            }
        }
    }
    let error = kd_tree(vec![Sphere::new(Vec3::ZERO, f32::NAN)]).map(|_| ()).unwrap_err();
    assert!(error.to_string().contains("finite"), "{error}");
}

#[test]
fn structures_hold_shapes_of_all_kinds() {
    let mut shapes: Vec<Box<dyn Bounded>> = vec![
        Box::new(Sphere::new(Vec3::new(3.0, 0.0, 0.0), 1.0)),
        Box::new(Triangle::new(Vec3::new(6.0, -1.0, -1.0), Vec3::new(6.0, 1.0, -1.0), Vec3::new(6.0, 0.0, 1.0))),
        Box::new(kd_tree(mesh(&[Vec3::Y * 3.0, Vec3::Y * 3.0 + Vec3::X, Vec3::Y * 3.0 + Vec3::Z])).unwrap()),
    ];
    shapes.push(Box::new(BoundingVolume::of(Sphere::new(Vec3::new(0.0, 0.0, 9.0), 2.0))));
    let tree = octree(shapes).unwrap();
    let t = |direction| tree.intersect(&Ray::new(Vec3::ZERO, direction), Interval::POSITIVE).map(|hit| hit.t);
    assert_eq!((t(Vec3::X), t(Vec3::Z), t(-Vec3::X)), (Some(2.0), Some(7.0), None));
    assert!(t(Vec3::new(0.1, 3.0, 0.1).normalize()).is_some());
}

/// A box around a shape changes no hit, and spares the shape the rays that miss the box.
#[test]
fn a_bounding_volume_changes_nothing() {
    let mut random = Stream::new(8, 8, 8);
    let ball = Sphere::new(Vec3::new(0.3, -0.2, 0.1), 0.7);
    let boxed = BoundingVolume::of(ball);
    for _ in 0..20_000 {
        let mut point = || Vec3::from_array([(); 3].map(|()| random.uniform() * 4.0 - 2.0));
        let ray = Ray::new(point(), point().normalize_or(Vec3::X));
        assert_eq!(boxed.intersect(&ray, Interval::POSITIVE), ball.intersect(&ray, Interval::POSITIVE));
        assert_eq!(boxed.occluded(&ray, Interval::POSITIVE), ball.occluded(&ray, Interval::POSITIVE));
    }
}

/// A coordinate of any kind that a mesh can have.
fn coordinate() -> impl Strategy<Value = f32> {
    prop_oneof![
        4 => -1.0_f32..1.0,
        // Values that meet again and again.
        4 => (-4_i8..=4).prop_map(|i| f32::from(i) / 4.0),
        1 => prop_oneof![Just(-0.0), Just(1e-20)],
    ]
}

fn corner() -> impl Strategy<Value = Vec3> {
    [coordinate(), coordinate(), coordinate()].prop_map(Vec3::from_array)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn any_triangles_of_any_size(
        corners in prop::collection::vec(corner(), 3..90),
        exponent in -6_i32..=6,
        shift in prop_oneof![Just(0.0_f32), Just(100.0)],
    ) {
        let scale = common::float::pow(10.0, exponent as f32);
        let corners: Vec<_> = corners.iter().map(|c| (*c + shift) * scale).collect();
        // A ray that starts on a triangle may hit it by rounding alone, at a `t` that means nothing.
        let size = corners.iter().map(|corner| corner.abs().max_element()).fold(0.0, f32::max);
        let range = Interval::new(1e-5 * size, f32::INFINITY);
        prop_assert_eq!(check_in(range, &mesh(&corners), &rays(&corners, 9)), Ok(()));
    }

    #[test]
    fn any_spheres(balls in prop::collection::vec((corner(), 0.0_f32..0.5), 0..60)) {
        let balls: Vec<_> = balls.into_iter().map(|(center, radius)| Sphere::new(center, radius)).collect();
        let mut points: Vec<_> = balls.iter().map(|ball| ball.center).collect();
        points.push(Vec3::ONE);
        prop_assert_eq!(check(&balls, &rays(&points, 10)), Ok(()));
    }
}
