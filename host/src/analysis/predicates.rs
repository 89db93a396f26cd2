//! Exact orientation predicates (Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
//! Predicates", 1997). For finite points; rounding never changes an answer.

use robust::{Coord, Coord3D, orient2d, orient3d};

/// The sign of `(b - a) × (c - a)`: 1 if the points turn counter-clockwise, 0 if they are collinear. Coordinates must be
/// `f32` values.
pub(crate) fn area_sign(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> i32 {
    let [a, b, c] = [a, b, c].map(|[x, y]| Coord { x, y });
    sign(orient2d(a, b, c))
}

/// The sign of `((b - a) × (c - a)) · (p - a)`: 1 if `p` lies in front of the triangle a, b, c, 0 if in its plane.
pub(crate) fn volume_sign([a, b, c]: [[f32; 3]; 3], p: [f32; 3]) -> i32 {
    let [a, b, c, p] = [a, b, c, p].map(|[x, y, z]| Coord3D { x, y, z });
    // `orient3d` is positive behind the triangle.
    -sign(orient3d(a, b, c, p))
}

/// −1, 0 or 1.
fn sign(x: f64) -> i32 {
    i32::from(x > 0.0) - i32::from(x < 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn known_sides() {
        let triangle = [[0.0, 0.0, 5.0], [3.0, 0.0, 5.0], [0.0, 2.0, 5.0]];
        assert_eq!(volume_sign(triangle, [9.0, 9.0, 5.0_f32.next_up()]), 1);
        assert_eq!(volume_sign(triangle, [9.0, 9.0, 5.0]), 0);
        assert_eq!(volume_sign(triangle, [9.0, 9.0, 4.0]), -1);
        assert_eq!(area_sign([0.0, 0.0], [3.0, 0.0], [0.0, 2.0]), 1);
    }

    #[test]
    fn tiny_heights_beside_huge_triangles_count() {
        let (tiny, huge) = (f32::from_bits(1), f32::MAX);
        let triangle = [[huge, huge, 0.0], [-huge, huge, 0.0], [0.0, -huge, 0.0]];
        assert_eq!(volume_sign(triangle, [1.0, 1.0, tiny]), 1);
        assert_eq!(volume_sign(triangle, [1.0, 1.0, -tiny]), -1);
        // The plane through the points (1, 1, 1) · t and (1, 2, 3) · t: the last bit decides.
        let slanted = [[huge, huge, huge], [tiny, 2.0 * tiny, 3.0 * tiny], [0.0; 3]];
        let point = [2.0_f32, 3.0, 4.0];
        assert_eq!(volume_sign(slanted, point), 0);
        let above = [2.0, 3.0, 4.0_f32.next_up()];
        assert_eq!(
            volume_sign(slanted, above),
            -volume_sign([slanted[1], slanted[0], slanted[2]], above)
        );
        assert_ne!(volume_sign(slanted, above), 0);
    }

    fn point() -> impl Strategy<Value = [i64; 3]> {
        let coordinate = prop_oneof![
            -3i64..=3,
            -(1i64 << 24)..=1 << 24,
            (1i64 << 24) - 2..=1 << 24
        ];
        proptest::array::uniform3(coordinate)
    }

    proptest! {
        #[test]
        fn volume_sign_agrees_with_integers(a in point(), b in point(), c in point(), mut p in point(), near in any::<bool>(), scale in -140i32..100) {
            if near {
                // In the plane, or one step beside it.
                p = [0, 1, 2].map(|i| b[i] + c[i] - a[i] + p[i] % 2);
            }
            prop_assume!(p.iter().all(|x| x.abs() <= 1 << 24));
            let d = |q: [i64; 3]| [0, 1, 2].map(|i| i128::from(q[i] - a[i]));
            let (u, v, w) = (d(b), d(c), d(p));
            let exact: i128 = [(0, 1, 2), (1, 2, 0), (2, 0, 1)].iter().map(|&(x, y, z)| w[x] * (u[y] * v[z] - u[z] * v[y])).sum();
            let float = |q: [i64; 3]| q.map(|x| (x as f64 * 2f64.powi(scale)) as f32);
            prop_assume!([a, b, c, p].iter().flatten().all(|&x| f64::from((x as f64 * 2f64.powi(scale)) as f32) == x as f64 * 2f64.powi(scale)));
            prop_assert_eq!(volume_sign([float(a), float(b), float(c)], float(p)), exact.signum() as i32);
            prop_assert_eq!(volume_sign([float(b), float(a), float(c)], float(p)), -exact.signum() as i32);
        }
    }
}
