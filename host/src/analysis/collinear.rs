//! Triangles without area, decided exactly.

use super::predicates::area_sign;

/// Whether three finite points lie on one line, coincident points included. Exact: neither rounding nor the order of the
/// points changes the answer.
pub(crate) fn are_collinear([a, b, c]: [[f32; 3]; 3]) -> bool {
    // Points are collinear if their projections along all three axes are.
    [(0, 1), (1, 2), (2, 0)].into_iter().all(|(x, y)| {
        let project = |p: [f32; 3]| [f64::from(p[x]), f64::from(p[y])];
        area_sign(project(a), project(b), project(c)) == 0
    })
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
