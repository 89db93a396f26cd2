//! On which side a point lies, decided exactly. For finite points; no rounding changes an answer.

use super::expansion::{Expansion, sign, two_product, two_sum};

/// The sign of `(b - a) × (c - a)`: 1 where three points turn counter-clockwise, 0 on a line. Coordinates must be `f32`
/// values.
pub(crate) fn area_sign(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> i32 {
    // `a × b + b × c + c × a`. Products of two 24-bit numbers are exact.
    let terms = [
        a[0] * b[1],
        -a[1] * b[0],
        b[0] * c[1],
        -b[1] * c[0],
        c[0] * a[1],
        -c[1] * a[0],
    ];
    let magnitude: f64 = terms.iter().map(|term| term.abs()).sum();
    let sum: f64 = terms.iter().sum();
    // Five roundings of half an epsilon cannot make up so large a sum.
    if sum.abs() > 4.0 * f64::EPSILON * magnitude {
        return sign(sum);
    }
    let mut exact = Expansion::<6>::ZERO;
    terms.into_iter().for_each(|term| exact.add(term));
    exact.sign()
}

/// The sign of `((b - a) × (c - a)) · (p - a)`: 1 where `p` lies in front of the triangle a, b, c, 0 on its plane.
pub(crate) fn volume_sign([a, b, c]: [[f32; 3]; 3], p: [f32; 3]) -> i32 {
    // Differences first: most of the time they are exact.
    let origin = a.map(f64::from);
    let mut differences_are_exact = true;
    let [u, v, w] = [b, c, p].map(|q| {
        [0, 1, 2].map(|axis| {
            let (difference, rest) = two_sum(f64::from(q[axis]), -origin[axis]);
            differences_are_exact &= rest == 0.0;
            difference
        })
    });
    let (mut volume, mut magnitude) = (0.0, 0.0);
    for (x, y, z) in AXES {
        let (positive, negative) = (u[y] * v[z], u[z] * v[y]);
        volume += w[x] * (positive - negative);
        magnitude += w[x].abs() * (positive.abs() + negative.abs());
    }
    // Shewchuk 1997, section 4.3: below 8 halves of an epsilon, differences included.
    if volume.abs() > 8.0 * f64::EPSILON * magnitude {
        return sign(volume);
    }

    if differences_are_exact {
        let mut exact = Expansion::<24>::ZERO;
        add_determinant(&mut exact, u, v, w, 1.0);
        exact.sign()
    } else {
        // `b·(c × p) - a·(c × p) + a·(b × p) - a·(b × c)`, without any difference.
        let [b, c, p] = [b, c, p].map(|q| q.map(f64::from));
        let mut exact = Expansion::<96>::ZERO;
        add_determinant(&mut exact, b, c, p, 1.0);
        add_determinant(&mut exact, origin, c, p, -1.0);
        add_determinant(&mut exact, origin, b, p, 1.0);
        add_determinant(&mut exact, origin, b, c, -1.0);
        exact.sign()
    }
}

const AXES: [(usize, usize, usize); 3] = [(0, 1, 2), (1, 2, 0), (2, 0, 1)];

/// Adds `factor * u · (v × w)`, a sum of up to 24 terms. `factor` is 1 or −1. Coordinates are differences of `f32` values,
/// so no product can overflow or lose bits to underflow.
fn add_determinant<const N: usize>(
    exact: &mut Expansion<N>,
    u: [f64; 3],
    v: [f64; 3],
    w: [f64; 3],
    factor: f64,
) {
    for (x, y, z) in AXES {
        for (first, second, factor) in [(v[y], w[z], factor), (v[z], w[y], -factor)] {
            let (product, rest) = two_product(first, second);
            for part in [product, rest] {
                let (high, low) = two_product(part, factor * u[x]);
                exact.add(low);
                exact.add(high);
            }
        }
    }
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
        // A plane through the points (1, 1, 1) · t and (1, 2, 3) · t: only the last bit tells.
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
                // On the plane, or one step beside it.
                p = [0, 1, 2].map(|i| b[i] + c[i] - a[i] + p[i] % 2);
            }
            prop_assume!(p.iter().all(|x| x.abs() <= 1 << 24));
            let d = |q: [i64; 3]| [0, 1, 2].map(|i| i128::from(q[i] - a[i]));
            let (u, v, w) = (d(b), d(c), d(p));
            let exact: i128 = AXES.iter().map(|&(x, y, z)| w[x] * (u[y] * v[z] - u[z] * v[y])).sum();
            let float = |q: [i64; 3]| q.map(|x| (x as f64 * 2f64.powi(scale)) as f32);
            prop_assume!([a, b, c, p].iter().flatten().all(|&x| f64::from((x as f64 * 2f64.powi(scale)) as f32) == x as f64 * 2f64.powi(scale)));
            prop_assert_eq!(volume_sign([float(a), float(b), float(c)], float(p)), exact.signum() as i32);
            prop_assert_eq!(volume_sign([float(b), float(a), float(c)], float(p)), -exact.signum() as i32);
        }
    }
}
