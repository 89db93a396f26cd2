//! The Utah teapot.

use crate::Mesh;

/// Newell's teapot, 992 triangles facing outward, without normals: body, lid, handle and spout, open where they meet. +y is
/// up, the spout points to +x; 32.1 wide, 15.8 high, 20 deep, around the origin.
///
/// # Panics
/// Never: the file is embedded in the program, and a test reads it.
#[must_use]
pub fn teapot() -> Mesh {
    let mut mesh = Mesh::default();
    for line in include_str!("../../assets/teapot.obj").lines() {
        if let Some(position) = line.strip_prefix("v ") {
            mesh.vertices.push(three(position));
        } else if let Some(face) = line.strip_prefix("f ") {
            mesh.indices.push(three(face).map(|vertex: u32| vertex - 1));
        }
    }
    mesh
}

/// Reads three numbers.
fn three<T: std::str::FromStr + Default + Copy>(text: &str) -> [T; 3] {
    let mut numbers = [T::default(); 3];
    for (number, word) in numbers.iter_mut().zip(text.split(' ')) {
        *number = word
            .parse()
            .unwrap_or_else(|_| panic!("the embedded teapot has {word:?} for a number"));
    }
    numbers
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::analyze;

    #[test]
    fn four_open_parts_that_face_out() {
        let mesh = teapot();
        assert_eq!(mesh.validate(), Ok(()));
        let analysis = analyze(&mesh);
        assert_eq!((mesh.indices.len(), mesh.vertices.len()), (992, 792));
        assert_eq!(analysis.welded_vertex_count, 529);
        assert_eq!(analysis.degenerate_triangle_count, 0);
        assert_eq!(analysis.duplicate_triangle_count, 0);
        let found: Vec<_> = analysis
            .components
            .iter()
            .map(|c| {
                (
                    c.triangle_count,
                    c.consistently_wound,
                    c.signed_volume > 0.0,
                )
            })
            .collect();
        let expected = [496, 240, 128, 128].map(|count| (count, true, true));
        assert_eq!(found, expected);
        // The lid is on top, and the spout is the part that reaches far to +x.
        assert_eq!(analysis.components[1].bounds.max[1], 7.875);
        let spout = analysis.components.iter().find(|c| c.bounds.min[0] > 7.0);
        assert_eq!(spout.map(|c| c.bounds.max[0]), Some(16.070_313));
    }
}
