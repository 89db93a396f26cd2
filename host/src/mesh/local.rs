//! Meshes far from zero: positions in `f64`, and their local origin.

use super::Mesh;
use glam::DVec3;

/// The mantissa bits of an `f32`, the hidden one included.
const F32_BITS: i32 = 24;

/// Edges looked at, at most.
const MOST_EDGES: usize = 1 << 16;

impl Mesh {
    /// A mesh from positions in `f64`, around a local origin, and that origin: add it to a hit's position for that in the caller's
    /// coordinates, and take it off origins of rays. It is zero unless rounding to `f32` so far away may exceed a thousandth of the median
    /// edge.
    ///
    /// ```
    /// use slimbvh::{BuildConfig, Builder, Mesh, Ray};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// // A square of 10 cm in UTM coordinates.
    /// let (x, y, z) = (500_123.4, 4_649_776.2, 212.0);
    /// let corner = |i: u32, j: u32| [x + 0.1 * f64::from(i), y + 0.1 * f64::from(j), z];
    /// let vertices = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
    /// let (mesh, origin) = Mesh::from_f64(&vertices, vec![[0, 1, 2], [0, 2, 3]]);
    ///
    /// let bvh = Builder::new(BuildConfig::default()).build(&mesh)?;
    /// let eye = [x + 0.05, y + 0.02, z + 3.0];
    /// let ray = Ray::new([0, 1, 2].map(|i| (eye[i] - origin[i]) as f32), [0.0, 0.0, -1.0]);
    /// let point = bvh.surface(&mesh, ray, &bvh.closest_hit(ray)).ok_or("it is missed")?;
    /// let place = [0, 1, 2].map(|i| f64::from(point.position[i]) + origin[i]);
    /// assert!((place[1] - eye[1]).abs() < 1e-5);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn from_f64(vertices: &[[f64; 3]], indices: Vec<[u32; 3]>) -> (Self, [f64; 3]) {
        let (vertices, origin) = narrowed(vertices, &indices);
        let mesh = Self {
            vertices,
            indices,
            ..Self::default()
        };
        (mesh, origin)
    }
}

/// The positions around their local origin, and that origin.
pub(crate) fn narrowed(vertices: &[[f64; 3]], triangles: &[[u32; 3]]) -> (Vec<[f32; 3]>, [f64; 3]) {
    let origin = local_origin(vertices, triangles);
    (around(vertices, origin), origin)
}

/// The positions less an origin.
pub(super) fn around<T: Copy + Into<f64>>(vertices: &[[T; 3]], origin: [f64; 3]) -> Vec<[f32; 3]> {
    let near = |v: &[T; 3]| [0, 1, 2].map(|i| (v[i].into() - origin[i]) as f32);
    vertices.iter().map(near).collect()
}

/// The origin to take off before narrowing: near the middle of the box, if rounding to `f32` without may exceed a thousandth of the
/// median edge. Else zero.
///
/// Numbers of `f32` count alike: rays, hits and cameras among them are rounded there.
pub(super) fn local_origin<T: Copy + Into<f64>>(
    vertices: &[[T; 3]],
    triangles: &[[u32; 3]],
) -> [f64; 3] {
    let vertex = |v: u32| vertices.get(v as usize).map(|&v| wide(v));
    let lengths = edge_lengths(triangles, vertex);
    let is_edge = |length: &f64| *length > 0.0 && length.is_finite();
    let Some(edge) = median(lengths.filter(is_edge).collect()) else {
        return [0.0; 3];
    };
    let may_lose = |far: f64| rounding(far) * 1000.0 > edge;
    // Most files are near: nobody looks at their triangles.
    if !may_lose(farthest(vertices)) {
        return [0.0; 3];
    }
    let (mut min, mut max) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let corners = triangles
        .iter()
        .flatten()
        .filter_map(|&corner| vertex(corner));
    for corner in corners.filter(|corner| corner.is_finite()) {
        (min, max) = (min.min(corner), max.max(corner));
    }
    let extent = (max - min).max_element();
    if !may_lose(min.abs().max(max.abs()).max_element()) || !extent.is_finite() {
        return [0.0; 3];
    }
    // A short number: few bits, so that it can be written down, and subtracted without rounding.
    let step = power_of_two_below(extent);
    let axis = |min: f64, max: f64| {
        // An axis that is near keeps its zero. What is taken off others leaves numbers no larger than the box, and so no larger than
        // any was: a number of `f32` stays one.
        match min.max(-max) >= extent {
            true => ((min + max) / 2.0 / step).round() * step,
            false => 0.0,
        }
    };
    [0, 1, 2].map(|i| axis(min[i], max[i]))
}

/// The largest coordinate, without its sign; those that are not finite count for nothing.
pub(super) fn farthest<T: Copy + Into<f64>>(vertices: &[[T; 3]]) -> f64 {
    let numbers = vertices.iter().flatten().map(|&x| x.into().abs());
    numbers.filter(|x| x.is_finite()).fold(0.0, f64::max)
}

/// How much a number up to this changes by rounding to `f32`, at most: half a step.
pub(super) fn rounding(far: f64) -> f64 {
    let far = far as f32;
    match far < f32::MAX {
        true => (f64::from(far.next_up()) - f64::from(far)) / 2.0,
        false => f64::INFINITY,
    }
}

fn wide<T: Into<f64>>(vertex: [T; 3]) -> DVec3 {
    DVec3::from(vertex.map(Into::into))
}

/// The largest power of two that is no larger, and not below the last bits of an `f32`; 1 for zero.
fn power_of_two_below(x: f64) -> f64 {
    if x > 0.0 {
        x.log2().floor().max(f64::from(-126 + F32_BITS)).exp2()
    } else {
        1.0
    }
}

/// The lengths of the edges of some triangles.
pub(super) fn edge_lengths(
    triangles: &[[u32; 3]],
    vertex: impl Fn(u32) -> Option<DVec3>,
) -> impl Iterator<Item = f64> {
    let step = (3 * triangles.len()).div_ceil(MOST_EDGES).max(1);
    let edges = triangles
        .iter()
        .step_by(step)
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    edges.filter_map(move |[a, b]| Some(vertex(a)?.distance(vertex(b)?)))
}

pub(super) fn median(mut lengths: Vec<f64>) -> Option<f64> {
    let middle = lengths.len() / 2;
    if lengths.is_empty() {
        return None;
    }
    let (_, median, _) = lengths.select_nth_unstable_by(middle, f64::total_cmp);
    Some(*median)
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// A strip of triangles with edges of this length, from here on.
    pub fn strip(begin: [f64; 3], edge: f64) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
        let vertex = |i: u32| {
            let [x, y, z] = begin;
            [
                x + 0.5 * edge * f64::from(i),
                y + edge * f64::from(i % 2),
                z,
            ]
        };
        let vertices = (0..100).map(vertex).collect();
        (vertices, (0..98).map(|i| [i, i + 1, i + 2]).collect())
    }

    #[test]
    fn far_vertices_have_a_local_origin() {
        let begin = [500_123.4, 4_649_776.2, 212.0];
        let (vertices, triangles) = strip(begin, 0.1);
        let origin = local_origin(&vertices, &triangles);
        let (mesh, found) = Mesh::from_f64(&vertices, triangles.clone());
        assert_eq!(found, origin);
        for (near, far) in mesh.vertices.iter().zip(&vertices) {
            for i in 0..3 {
                let restored = f64::from(near[i]) + origin[i];
                assert!((restored - far[i]).abs() < 1e-6, "{near:?} {far:?}");
                assert!(near[i].abs() < 16.0);
            }
        }
        assert_eq!(origin.map(|x| x % 4.0), [0.0; 3], "{origin:?}");
    }

    #[test]
    fn near_vertices_stay_where_they_are() {
        for (begin, edge) in [
            ([0.1, 0.2, 0.3], 0.1),
            ([100.1, -3.0, 0.0], 0.1),
            ([1e6, 1e6, 0.0], 1000.7),
        ] {
            let (vertices, triangles) = strip(begin, edge);
            assert_eq!(local_origin(&vertices, &triangles), [0.0; 3], "{begin:?}");
        }
        // Around zero nothing is won.
        let (mut vertices, triangles) = strip([0.0; 3], 0.1);
        vertices[0] = [-1e7, 0.0, 0.0];
        vertices[1] = [1e7, 0.0, 0.0];
        assert_eq!(local_origin(&vertices, &triangles), [0.0; 3]);
        assert_eq!(local_origin::<f64>(&[], &[]), [0.0; 3]);
        assert_eq!(local_origin(&[[f64::NAN; 3]; 3], &[[0, 1, 2]]), [0.0; 3]);
    }

    #[test]
    fn numbers_of_f32_have_an_origin_too() {
        let (vertices, triangles) = strip([500_000.0, 4_600_000.0, 100.0], 1.0);
        let origin = local_origin(&vertices, &triangles);
        assert!(origin.iter().all(|x| *x > 0.0), "{origin:?}");
        let rounded: Vec<[f32; 3]> = vertices.iter().map(|v| v.map(|x| x as f32)).collect();
        assert_eq!(local_origin(&rounded, &triangles), origin);
    }

    #[test]
    fn near_axes_keep_their_zero() {
        let (vertices, triangles) = strip([500_000.0, -20.0, 0.25], 0.01);
        let [x, y, z] = local_origin(&vertices, &triangles);
        assert!(x > 499_999.0 && y < -19.0 && z == 0.0, "{x} {y} {z}");
    }

    /// Whether all numbers are the same after an origin is taken off and added back.
    fn is_restored(vertices: &[[f32; 3]], triangles: &[[u32; 3]], origin: [f64; 3]) -> bool {
        let near = |v: &[f32; 3]| [0, 1, 2].map(|i| (f64::from(v[i]) - origin[i]) as f32);
        let same = |v: &[f32; 3], n: [f32; 3]| {
            (0..3).all(|i| f64::from(n[i]) + origin[i] == f64::from(v[i]))
        };
        let corners = triangles.iter().flatten();
        let mut corners = corners.filter_map(|&corner| vertices.get(corner as usize));
        corners.all(|v| same(v, near(v)))
    }

    proptest::proptest! {
        /// Taking an origin off rounds no number of `f32`.
        #[test]
        fn numbers_of_f32_stay_exact(
            far in proptest::array::uniform3(-1e8f32..1e8),
            numbers in proptest::collection::vec(-1.0f32..1.0, 9..90),
            scale in proptest::array::uniform3(-24i32..24),
            triangles in proptest::collection::vec(proptest::array::uniform3(0u32..30), 1..60),
        ) {
            let vertices: Vec<[f32; 3]> = numbers
                .chunks_exact(3)
                .map(|v| [0, 1, 2].map(|i| far[i] + v[i] * (scale[i] as f32).exp2()))
                .collect();
            let origin = local_origin(&vertices, &triangles);
            proptest::prop_assert!(is_restored(&vertices, &triangles, origin), "{origin:?}");
        }
    }

    /// The negative control of the property: the middle of a box that reaches toward zero rounds.
    #[test]
    fn the_middle_of_a_near_box_would_round() {
        let vertices = [[0.1, 0.0, 0.0], [1000.0, 0.0, 0.0], [1000.0, 1e-6, 0.0]];
        let triangles = [[0, 1, 2]; 3];
        assert!(!is_restored(&vertices, &triangles, [512.0, 0.0, 0.0]));
        let origin = local_origin(&vertices, &triangles);
        assert!(is_restored(&vertices, &triangles, origin));
    }
}
