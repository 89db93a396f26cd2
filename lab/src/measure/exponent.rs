//! Exponents of growth, and the terrains that they are measured on.

/// Cells along a side of the terrains, whose 2 · cells² triangles grow from about 1,000 to 10 million by √10 each.
pub const CELLS: [u32; 9] = [22, 40, 71, 126, 224, 398, 707, 1265, 2236];

/// The slope of the least squares line through the logarithms of the pairs above 0; `None` for fewer than two amounts.
#[must_use]
pub fn exponent(pairs: impl Iterator<Item = [f64; 2]>) -> Option<f64> {
    let above = pairs.filter(|[x, y]| *x > 0.0 && *y > 0.0);
    let logs: Vec<[f64; 2]> = above.map(|pair| pair.map(f64::ln)).collect();
    let count = logs.len() as f64;
    let mean = [0, 1].map(|i: usize| logs.iter().map(|pair| pair[i]).sum::<f64>() / count);
    let products = |i: usize| {
        let terms = logs
            .iter()
            .map(|pair| (pair[0] - mean[0]) * (pair[i] - mean[i]));
        terms.sum::<f64>()
    };
    let [square, product] = [products(0), products(1)];
    (square > 0.0).then(|| product / square)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_are_exponents() {
        let power = |power: f64| [1.0, 2.0, 8.0, 64.0].map(|x: f64| [x, 3.0 * x.powf(power)]);
        for expected in [-0.5, 0.0, 1.0, 1.75] {
            let found = exponent(power(expected).into_iter()).unwrap();
            assert!((found - expected).abs() < 1e-12, "{found}");
        }
        // By hand: the logarithms (0, 0), (1, 1), (2, 3) have the slope 3/2.
        let [e, e2] = [1.0f64, 2.0].map(f64::exp);
        let found = exponent([[1.0, 1.0], [e, e], [e2, 3f64.exp()]].into_iter()).unwrap();
        assert!((found - 1.5).abs() < 1e-12);
        assert_eq!(exponent([[2.0, 1.0]].into_iter()), None);
        assert_eq!(
            exponent([[2.0, 1.0], [2.0, 3.0], [0.0, 1.0]].into_iter()),
            None
        );
    }
}
