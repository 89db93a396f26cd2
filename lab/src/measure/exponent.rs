//! Powers that costs grow by, and over which meshes.

/// Cells along a side of a terrain of about 1,000 triangles, √10 times as many, and so on to 10 million: 2 · cells² each.
pub const CELLS: [u32; 9] = [22, 40, 71, 126, 224, 398, 707, 1265, 2236];

/// The slope of the line that fits the logarithms of pairs above 0 best, by least squares; none for fewer than two amounts.
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
        // By hand: (0, 0), (1, 1), (2, 3) in logarithms has 3/2.
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
