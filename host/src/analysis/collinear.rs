//! Triangles without area, decided exactly.

/// Whether three finite points lie on one line, or two of them on one point. Exact: no rounding changes the answer, nor
/// does the order of the points.
pub(super) fn are_collinear([a, b, c]: [[f32; 3]; 3]) -> bool {
    // Points lie on one line if their shadows along all three axes do.
    [(0, 1), (1, 2), (2, 0)].into_iter().all(|(x, y)| {
        let project = |p: [f32; 3]| [f64::from(p[x]), f64::from(p[y])];
        area_is_zero(project(a), project(b), project(c))
    })
}

/// Whether `a × b + b × c + c × a = 0`, for coordinates that are `f32` values.
fn area_is_zero(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> bool {
    // Products of two 24-bit numbers are exact.
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
    let certainly_not = sum.abs() > 4.0 * f64::EPSILON * magnitude;
    !certainly_not && sum_is_zero(terms)
}

/// Whether the sum is zero, without rounding: GROW-EXPANSION of Shewchuk, "Adaptive Precision Floating-Point Arithmetic
/// and Fast Robust Geometric Predicates" (1997), section 2.4. The parts it yields do not overlap, so they cannot cancel.
fn sum_is_zero(terms: [f64; 6]) -> bool {
    let mut expansion = [0.0; 6];
    for (count, term) in terms.into_iter().enumerate() {
        let mut carry = term;
        for part in &mut expansion[..count] {
            (carry, *part) = two_sum(carry, *part);
        }
        expansion[count] = carry;
    }
    expansion == [0.0; 6]
}

/// `a + b` rounded, and what the rounding left out (Knuth).
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_share = sum - a;
    let a_share = sum - b_share;
    (sum, (a - a_share) + (b - b_share))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_points_are_told_from_slivers() {
        let on_a_line = [[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [5.0, 10.0, 15.0]];
        assert!(are_collinear(on_a_line));
        let mut beside = on_a_line;
        beside[1][2] = 6.0_f32.next_up();
        assert!(!are_collinear(beside));
        assert!(are_collinear([
            [1.0, 2.0, 3.0],
            [7.0, -5.0, 0.1],
            [1.0, 2.0, 3.0]
        ]));
        assert!(are_collinear([[4.0, 5.0, 6.0]; 3]));
    }

    #[test]
    fn tiny_terms_beside_huge_ones_count() {
        let tiny = f32::from_bits(1);
        let huge = f32::MAX;
        // In doubles alone, `huge * huge + tiny * tiny` loses the second term.
        let sliver = [[0.0, 0.0, 0.0], [huge, huge, 0.0], [huge, huge, tiny]];
        assert!(!are_collinear(sliver));
        let sliver = [[huge, huge, 0.0], [-huge, -huge, 0.0], [tiny, 0.0, 0.0]];
        assert!(!are_collinear(sliver));
        let line = [[huge, huge, 0.0], [-huge, -huge, 0.0], [tiny, tiny, 0.0]];
        assert!(are_collinear(line));
        assert!(!are_collinear([
            [0.0; 3],
            [tiny, 0.0, 0.0],
            [0.0, tiny, 0.0]
        ]));
    }

    #[test]
    fn all_orders_agree_with_integers() {
        // Corners on a small grid, far from the origin: the cross product in integers is the oracle.
        let grid = |n: i64| [n % 3, n / 3 % 3, n / 9];
        for n in 0..27 * 27 {
            let corners = [[0, 0, 0], grid(n / 27), grid(n % 27)];
            let [_, p, q] = corners;
            let collinear = [(0, 1), (1, 2), (2, 0)]
                .iter()
                .all(|&(x, y)| p[x] * q[y] == p[y] * q[x]);
            let [a, b, c] = corners.map(|p| p.map(|x| 8_388_608.0 + x as f32));
            assert_eq!(are_collinear([a, b, c]), collinear);
            assert_eq!(are_collinear([c, a, b]), collinear);
            assert_eq!(are_collinear([b, a, c]), collinear);
        }
    }
}
