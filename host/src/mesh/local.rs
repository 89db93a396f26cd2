//! Meshes far from zero: positions in `f64`, and their local origin.

use super::Mesh;
use glam::DVec3;

/// The mantissa bits of an `f32`, the hidden one included.
const F32_BITS: i32 = 24;

/// Edges looked at, at most.
const MOST_EDGES: usize = 1 << 16;

impl Mesh {
    /// A mesh from positions in `f64`, around a local origin, and that origin: add it to a hit's position for that in the caller's
    /// coordinates, and take it off origins of rays. It is zero unless `f32` would lose more than a thousandth of the median edge.
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
    let near = |v: &[f64; 3]| [0, 1, 2].map(|i| (v[i] - origin[i]) as f32);
    (vertices.iter().map(near).collect(), origin)
}

/// The origin to take off before narrowing: near the middle of the box, if `f32` would lose more than a thousandth of the median edge
/// without, and less with it. Else zero.
pub(super) fn local_origin(vertices: &[[f64; 3]], triangles: &[[u32; 3]]) -> [f64; 3] {
    // Most files are near: then rounding is far below any edge, and nobody looks at edges.
    let lost = vertices
        .iter()
        .flatten()
        .map(|&x| (x - f64::from(x as f32)).abs())
        .filter(|lost| lost.is_finite())
        .fold(0.0, f64::max);
    if lost == 0.0 {
        return [0.0; 3];
    }
    let Some(edge) = median_edge(vertices, triangles) else {
        return [0.0; 3];
    };
    if lost * 1000.0 <= edge {
        return [0.0; 3];
    }
    let corners = triangles.iter().flatten();
    let corners = corners.filter_map(|&corner| vertices.get(corner as usize));
    let (mut min, mut max) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for corner in corners.map(|&corner| DVec3::from(corner)) {
        if corner.is_finite() {
            (min, max) = (min.min(corner), max.max(corner));
        }
    }
    let (extent, far) = (max - min, min.abs().max(max.abs()).max_element());
    let middle = (min + max) / 2.0;
    // Where the box reaches around zero anyway, taking its middle off gains less than a bit.
    if !middle.is_finite() || extent.max_element() > far {
        return [0.0; 3];
    }
    // A short number: few bits, so that it can be written down, and subtracted without rounding.
    let step = power_of_two_below(extent.max_element());
    (middle / step).round().to_array().map(|steps| steps * step)
}

/// The largest power of two that is no larger, and not below the last bits of an `f32`; 1 for zero.
fn power_of_two_below(x: f64) -> f64 {
    if x > 0.0 {
        x.log2().floor().max(f64::from(-126 + F32_BITS)).exp2()
    } else {
        1.0
    }
}

/// The median length of edges that are not points, of some triangles.
fn median_edge(vertices: &[[f64; 3]], triangles: &[[u32; 3]]) -> Option<f64> {
    let vertex = |v: u32| vertices.get(v as usize).map(|&v| DVec3::from(v));
    let lengths = edge_lengths(triangles, vertex);
    median(
        lengths
            .filter(|&length| length > 0.0 && length.is_finite())
            .collect(),
    )
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
            // Far, but every coordinate is a number of `f32`.
            ([4_194_304.0, 4_194_304.0, 0.0], 2.0),
        ] {
            let (vertices, triangles) = strip(begin, edge);
            assert_eq!(local_origin(&vertices, &triangles), [0.0; 3], "{begin:?}");
        }
        // Around zero nothing is won.
        let (mut vertices, triangles) = strip([0.0; 3], 0.1);
        vertices[0] = [-1e7, 0.0, 0.0];
        vertices[1] = [1e7, 0.0, 0.0];
        assert_eq!(local_origin(&vertices, &triangles), [0.0; 3]);
        assert_eq!(local_origin(&[], &[]), [0.0; 3]);
        assert_eq!(local_origin(&[[f64::NAN; 3]; 3], &[[0, 1, 2]]), [0.0; 3]);
    }
}
