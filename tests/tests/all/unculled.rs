//! The oracle for any numbers agrees with the oracle for whole numbers.

use proptest::prelude::*;
use slimbvh_core::Ray;
use slimbvh_lab::oracle::Unculled;
use slimbvh_tests::oracle::exact::{GridRay, GridTriangle, intersect};

fn triangle() -> impl Strategy<Value = GridTriangle> {
    proptest::array::uniform3(proptest::array::uniform3(-3i32..=3))
}

proptest! {
    /// On a small grid most rays pass edges, corners and planes. At any magnitude, from denormal numbers to the largest.
    #[test]
    fn agrees_with_whole_numbers(triangles in proptest::collection::vec(triangle(), 1..80), origin in proptest::array::uniform3(-3i32..=3), direction in proptest::array::uniform3(-2i32..=2), shift in -149i32..=126, to_one in any::<bool>()) {
        prop_assume!(direction != [0; 3]);
        let float = |p: [i32; 3]| p.map(|x| (f64::from(x) * 2f64.powi(shift)) as f32);
        let oracle = Unculled::new(triangles.iter().map(|triangle| triangle.map(float)).collect());
        let mut ray = Ray::new(float(origin), float(direction));
        if to_one {
            ray.t_max = 1.0;
        }
        let grid_ray = GridRay { origin, direction };
        let hits = triangles.iter().zip(0..).filter_map(|(triangle, i)| Some((intersect(&grid_ray, triangle)?.t, i)));
        let mut hits: Vec<_> = hits.filter(|(t, _)| !to_one || t.over <= t.under).collect();
        hits.sort_by(|a, b| a.0.compare(&b.0).then(a.1.cmp(&b.1)));
        let crossings = oracle.crossings(&ray, u32::MAX);
        let found: Vec<u32> = crossings.iter().map(|crossing| crossing.primitive).collect();
        let expected: Vec<u32> = hits.iter().map(|hit| hit.1).collect();
        prop_assert_eq!(&found, &expected);
        prop_assert_eq!(oracle.is_met(&ray), !expected.is_empty());
        for (crossing, (t, _)) in crossings.iter().zip(&hits) {
            prop_assert!((crossing.t - t.value()).abs() <= 1e-12 * t.value());
        }
        if let Some(&first) = found.first() {
            prop_assert!(oracle.crossings(&ray, first).iter().all(|crossing| crossing.primitive != first));
        }
    }
}
