//! Indexed triangle meshes and their validation.

mod error;
mod local;
#[cfg(feature = "scenes")]
mod narrow;
mod snap;

use crate::text::excerpt;
pub use error::MeshError;
#[cfg(feature = "scenes")]
pub(crate) use local::narrowed;
#[cfg(feature = "scenes")]
pub(crate) use narrow::Narrow;
use slimbvh_core::IndexedTriangles;

/// Triangles as indices into shared vertices; counter-clockwise is front.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Positions, in the caller's unit.
    pub vertices: Vec<[f32; 3]>,
    /// Three vertex indices a triangle. A triangle's position in this list is its primitive index.
    pub indices: Vec<[u32; 3]>,
    /// Unit shading normals, one a vertex, or empty for flat shading. A zero normal requests flat shading.
    pub normals: Vec<[f32; 3]>,
    /// Index into the scene's materials, one a triangle, or empty: then all triangles use material 0.
    pub materials: Vec<u32>,
    /// Named runs of triangles, in order and without gaps, or empty. Error messages name the part.
    pub parts: Vec<Part>,
}

/// A named run of triangles.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Part {
    /// The name in the file, or a number.
    pub name: String,
    /// The run's first triangle.
    pub first_triangle: u32,
    /// How many triangles it has.
    pub triangle_count: u32,
}

impl Mesh {
    /// Checks everything that the builder relies on: counts, indices in range, finite corners. Unused vertices may have any
    /// value.
    ///
    /// # Errors
    /// The first fault found, by face.
    pub fn validate(&self) -> Result<(), MeshError> {
        self.validate_counts()?;

        // Two plain sweeps accept most sound meshes. Only other meshes, and those with bad unused vertices, are searched by
        // face.
        let largest_index = self.indices.iter().flatten().fold(0, |a, &b| a.max(b));
        let in_range = self.indices.is_empty() || (largest_index as usize) < self.vertices.len();
        let magnitude = |x: &f32| x.to_bits() & 0x7fff_ffff;
        let coordinates = self.vertices.iter().flatten();
        let largest_magnitude = coordinates.map(magnitude).fold(0, u32::max);
        if in_range && largest_magnitude < f32::INFINITY.to_bits() {
            return Ok(());
        }
        match (0..self.indices.len()).find(|&face| !self.face_is_sound(face)) {
            Some(face) => Err(self.face_fault(face)),
            None => Ok(()),
        }
    }

    /// The triangles as core reads them.
    #[must_use]
    pub fn triangles(&self) -> IndexedTriangles<'_> {
        IndexedTriangles {
            vertices: &self.vertices,
            indices: &self.indices,
        }
    }

    /// The part that holds a triangle; `None` for a mesh without parts, or beyond its end. Takes logarithmic time.
    ///
    /// ```
    /// # use slimbvh::{Mesh, Part};
    /// let part = |name: &str, first_triangle, triangle_count| Part {
    ///     name: name.into(),
    ///     first_triangle,
    ///     triangle_count,
    /// };
    /// let mesh = Mesh {
    ///     parts: vec![part("wheel", 0, 300), part("door", 300, 20)],
    ///     ..Mesh::default()
    /// };
    /// assert_eq!(mesh.part_of(305).map(|part| part.name.as_str()), Some("door"));
    /// assert_eq!(mesh.part_of(320), None);
    /// ```
    #[must_use]
    pub fn part_of(&self, primitive: u32) -> Option<&Part> {
        let after = self
            .parts
            .partition_point(|part| part.first_triangle <= primitive);
        // Parts without triangles begin where the next one does.
        let part = self.parts.get(after.checked_sub(1)?)?;
        (primitive - part.first_triangle < part.triangle_count).then_some(part)
    }

    /// Drops every face with an index out of range or a corner that is not finite. Returns how many were dropped.
    pub fn drop_unsound_faces(&mut self) -> usize {
        let sound: Vec<bool> = (0..self.indices.len())
            .map(|face| self.face_is_sound(face))
            .collect();
        let dropped = sound.iter().filter(|&&sound| !sound).count();
        if dropped == 0 {
            return 0;
        }
        // Sound faces before each face, and in all.
        let mut sum = 0;
        let mut before = vec![0; sound.len() + 1];
        for (face, &sound) in sound.iter().enumerate() {
            sum += u32::from(sound);
            before[face + 1] = sum;
        }
        let kept_before = |face: u32| before.get(face as usize).copied().unwrap_or(sum);
        for part in &mut self.parts {
            let end = part.first_triangle.saturating_add(part.triangle_count);
            part.first_triangle = kept_before(part.first_triangle);
            part.triangle_count = kept_before(end) - part.first_triangle;
        }
        retain_by(&mut self.indices, &sound);
        if !self.materials.is_empty() {
            retain_by(&mut self.materials, &sound);
        }
        dropped
    }

    fn validate_counts(&self) -> Result<(), MeshError> {
        let limit = slimbvh_core::MAX_TRIANGLES as usize;
        if self.indices.len() > limit {
            return Err(MeshError::TooManyTriangles {
                triangle_count: self.indices.len(),
                limit,
            });
        }
        if self.vertices.len() > u32::MAX as usize {
            return Err(MeshError::TooManyVertices {
                vertex_count: self.vertices.len(),
            });
        }
        let mut end = 0;
        for part in &self.parts {
            if part.first_triangle as usize != end {
                return Err(MeshError::PartOutOfPlace {
                    part: excerpt(&part.name),
                    first_triangle: part.first_triangle,
                    expected: end,
                });
            }
            end += part.triangle_count as usize;
        }
        if !self.parts.is_empty() && end != self.indices.len() {
            return Err(MeshError::LengthMismatch {
                what: "triangles in parts",
                count: end,
                expected: self.indices.len(),
                of: "triangles",
            });
        }
        if !self.normals.is_empty() && self.normals.len() != self.vertices.len() {
            return Err(MeshError::LengthMismatch {
                what: "normals",
                count: self.normals.len(),
                expected: self.vertices.len(),
                of: "vertices",
            });
        }
        if !self.materials.is_empty() && self.materials.len() != self.indices.len() {
            return Err(MeshError::LengthMismatch {
                what: "materials",
                count: self.materials.len(),
                expected: self.indices.len(),
                of: "triangles",
            });
        }
        Ok(())
    }

    fn face_is_sound(&self, face: usize) -> bool {
        self.indices[face].iter().all(|&vertex| {
            self.vertices
                .get(vertex as usize)
                .is_some_and(|position| position.iter().all(|x| x.is_finite()))
        })
    }

    /// The first fault of an unsound face.
    fn face_fault(&self, face: usize) -> MeshError {
        let (part, face_in_part) = self.locate(face);
        for vertex in self.indices[face] {
            match self.vertices.get(vertex as usize) {
                None => {
                    return MeshError::IndexOutOfRange {
                        part,
                        face: face_in_part,
                        vertex,
                        vertex_count: self.vertices.len(),
                    };
                }
                Some(&[x, y, z]) if !(x.is_finite() && y.is_finite() && z.is_finite()) => {
                    return MeshError::NotFinite {
                        part,
                        face: face_in_part,
                        vertex,
                        x,
                        y,
                        z,
                    };
                }
                Some(_) => {}
            }
        }
        unreachable!("face {face} was found unsound")
    }

    /// The part that holds a face, as a phrase for messages, and the face's number within it.
    fn locate(&self, face: usize) -> (String, usize) {
        match u32::try_from(face).ok().and_then(|face| self.part_of(face)) {
            Some(part) => (
                format!("mesh \"{}\", ", excerpt(&part.name)),
                face - part.first_triangle as usize,
            ),
            None => (String::new(), face),
        }
    }
}

/// Keeps the items whose flag is set.
fn retain_by<T>(items: &mut Vec<T>, keep: &[bool]) {
    let mut flags = keep.iter();
    items.retain(|_| flags.next().copied().unwrap_or(true));
}

#[cfg(test)]
mod tests {
    use super::*;

    fn two_parts() -> Mesh {
        Mesh {
            vertices: vec![
                [0.0, 0.0, 0.0],
                [1.0, 0.0, 0.0],
                [0.0, 2.0, 0.0],
                [0.0, 0.0, 3.0],
            ],
            indices: vec![[0, 1, 2], [0, 1, 3], [1, 2, 3]],
            materials: vec![7, 8, 9],
            parts: vec![
                Part {
                    name: "a".into(),
                    first_triangle: 0,
                    triangle_count: 1,
                },
                Part {
                    name: "b".into(),
                    first_triangle: 1,
                    triangle_count: 2,
                },
            ],
            ..Mesh::default()
        }
    }

    #[test]
    fn faults_name_part_face_and_vertex() {
        let mut mesh = two_parts();
        assert_eq!(mesh.validate(), Ok(()));
        mesh.indices[2][1] = 4;
        let message = mesh.validate().unwrap_err().to_string();
        assert_eq!(
            message,
            "mesh \"b\", face 1 names vertex 4, but there are only 4 vertices"
        );
        mesh.vertices[3][2] = f32::NAN;
        let message = mesh.validate().unwrap_err().to_string();
        assert_eq!(
            message,
            "mesh \"b\", face 0 has vertex 3 at (0, 0, NaN), which is not finite"
        );
    }

    #[test]
    fn unsound_faces_are_dropped_with_their_materials() {
        let mut mesh = two_parts();
        mesh.indices[1][0] = 99;
        assert_eq!(mesh.drop_unsound_faces(), 1);
        assert_eq!(mesh.indices, [[0, 1, 2], [1, 2, 3]]);
        assert_eq!(mesh.materials, [7, 9]);
        assert_eq!(
            (mesh.parts[1].first_triangle, mesh.parts[1].triangle_count),
            (1, 1)
        );
        assert_eq!(mesh.validate(), Ok(()));
        assert_eq!(mesh.drop_unsound_faces(), 0);
    }

    #[test]
    fn parts_out_of_place_are_refused() {
        let mut mesh = two_parts();
        mesh.parts[1].first_triangle = 2;
        assert_eq!(
            mesh.validate().unwrap_err().to_string(),
            "mesh \"b\" begins at triangle 2, but the one before it ends at 1"
        );
        // Dropping faces accepts an inconsistent list of parts without a panic.
        mesh.parts[0].triangle_count = u32::MAX;
        mesh.indices[0][0] = 99;
        assert_eq!(mesh.drop_unsound_faces(), 1);
        assert_eq!(mesh.parts[0].triangle_count, 2);
    }

    #[test]
    fn lists_of_the_wrong_length_are_refused() {
        let mut mesh = two_parts();
        mesh.normals = vec![[0.0, 0.0, 1.0]; 3];
        assert_eq!(
            mesh.validate().unwrap_err().to_string(),
            "3 normals for 4 vertices"
        );
    }
}
