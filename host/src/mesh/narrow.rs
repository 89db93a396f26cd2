//! Positions narrowed to `f32` as they come.

use super::local::{around, edge_lengths, farthest, local_origin, median, rounding};

/// Positions in `f32`.
#[derive(Default)]
pub(crate) struct Narrow {
    pub(crate) list: Vec<[f32; 3]>,
    /// The largest difference to a coordinate before narrowing.
    lost: f64,
}

impl Narrow {
    /// Adds positions, narrowed.
    pub(crate) fn extend(&mut self, positions: impl Iterator<Item = [f64; 3]>) {
        let mut lost = self.lost;
        self.list.extend(positions.map(|position| {
            position.map(|x| {
                let near = x as f32;
                // NaN, which is no maximum, for what was infinite.
                lost = lost.max((x - f64::from(near)).abs());
                near
            })
        }));
        self.lost = lost;
    }

    /// Whether narrowing has lost something, and rounding may exceed a thousandth of the median edge. If not, the list has the same
    /// [`local_origin`](super::local::local_origin) as the positions before.
    ///
    /// Rounding moves a corner by at most √3 of `rounding`, and an edge's length by less than 4. Edges that became points count
    /// here. So this median is at most 4 of `rounding` above that of the positions before.
    pub(crate) fn may_lose(&self, triangles: &[[u32; 3]]) -> bool {
        if self.lost == 0.0 {
            return false;
        }
        let vertex = |v: u32| {
            let vertex = self.list.get(v as usize)?;
            Some(glam::Vec3::from(*vertex).as_dvec3())
        };
        let lengths = edge_lengths(triangles, vertex).filter(|length| length.is_finite());
        let edge = median(lengths.collect()).unwrap_or(0.0);
        edge <= 1004.0 * self.lost.max(rounding(farthest(&self.list)))
    }

    /// The positions around their local origin, and that origin.
    pub(crate) fn around_origin(self, triangles: &[[u32; 3]]) -> (Vec<[f32; 3]>, [f64; 3]) {
        match local_origin(&self.list, triangles) {
            [0.0, 0.0, 0.0] => (self.list, [0.0; 3]),
            origin => (around(&self.list, origin), origin),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::local::tests::strip;
    use super::*;

    /// Whether narrowing at once tells that it may lose something, and whether it lost the origin.
    fn told_and_lost(vertices: &[[f64; 3]], triangles: &[[u32; 3]]) -> (bool, bool) {
        let mut narrow = Narrow::default();
        narrow.extend(vertices.iter().copied());
        let origin = local_origin(vertices, triangles);
        let found = local_origin(&narrow.list, triangles);
        (narrow.may_lose(triangles), found != origin)
    }

    #[test]
    fn narrowing_at_once_tells_where_it_loses() {
        for begin in [
            0.0,
            0.1,
            1.1,
            1e3 + 0.1,
            1e6 + 0.1,
            1e9 + 0.1,
            1e12,
            1e38,
            1e39,
            1e300,
        ] {
            for edge in [1e-30, 1e-9, 1e-3, 1.0 / 3.0, 1e3, 1e30] {
                let (vertices, triangles) = strip([begin, 0.0, 1.0 / 3.0], edge);
                let (told, lost) = told_and_lost(&vertices, &triangles);
                assert!(told || !lost, "{begin} {edge}");
            }
        }
        // Most files are not read twice.
        for begin in [0.0, 1.1, 100.1] {
            let (vertices, triangles) = strip([begin, 0.0, 0.3], 0.1);
            assert_eq!(told_and_lost(&vertices, &triangles), (false, false));
        }
        let (vertices, triangles) = strip([1e9 + 0.1, 0.0, 0.0], 0.1);
        assert_eq!(told_and_lost(&vertices, &triangles), (true, true));
        // Numbers of `f32` need no second reading, but an origin.
        let (vertices, triangles) = strip([500_000.0, 4_600_000.0, 100.0], 1.0);
        assert_eq!(told_and_lost(&vertices, &triangles), (false, false));
        assert_ne!(local_origin(&vertices, &triangles), [0.0; 3]);
    }

    proptest::proptest! {
        /// Also where some corners fall on one another by rounding, and the median would be another edge's.
        #[test]
        fn no_origin_is_missed(
            far in -1e8f64..1e8,
            numbers in proptest::collection::vec(-1.0f64..1.0, 9..90),
            scale in -12i32..12,
            triangles in proptest::collection::vec(proptest::array::uniform3(0u32..30), 1..60),
        ) {
            let scale = f64::from(scale).exp2();
            let vertices: Vec<[f64; 3]> = numbers
                .chunks_exact(3)
                .map(|v| [far + v[0] * scale, v[1] * scale, far / 3.0 + v[2] * scale.powi(3)])
                .collect();
            let (told, lost) = told_and_lost(&vertices, &triangles);
            proptest::prop_assert!(told || !lost);
        }
    }
}
