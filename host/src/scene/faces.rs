//! Polygons, with their vertex indices checked, to triangles.

use super::cut::{Cutter, MOST_CORNERS};
use super::error::{Indexed, excerpt};
use super::load::{Found, Source};
use super::vertices::Vertices;
use super::{LoadError, Scene};
use crate::{Mesh, MeshError};
use glam::DVec3;

/// A mesh under construction.
pub(super) struct Faces<'a> {
    source: &'a Source<'a>,
    /// The reader fills everything but the triangles and the vertices.
    pub mesh: Mesh,
    pub vertices: Vertices,
    /// Faces left out so far.
    pub dropped_count: usize,
    cutter: Cutter,
    small_count: usize,
}

/// The place of a face, for messages.
#[derive(Clone, Copy)]
pub(super) struct FaceSite<'a> {
    /// The line, counted from 1, if the format has lines.
    pub line: Option<usize>,
    /// The name of the face's part, if it has one.
    pub part: Option<&'a str>,
    /// The face, counted from 0 in the file or the part.
    pub face: usize,
}

/// A run of the mesh's vertices, which faces index from 0.
#[derive(Clone, Copy)]
pub(super) struct Run {
    /// The run's first vertex in the mesh.
    pub first: u32,
    /// The number of vertices.
    pub count: usize,
}

impl<'a> Faces<'a> {
    pub fn new(source: &'a Source<'a>) -> Self {
        Self {
            source,
            mesh: Mesh::default(),
            vertices: Vertices::default(),
            dropped_count: 0,
            cutter: Cutter::default(),
            small_count: 0,
        }
    }

    /// The run of the next `count` vertices.
    pub fn next_run(&self, count: usize) -> Result<Run, LoadError> {
        let first = self.vertices.len();
        if first.saturating_add(count) > u32::MAX as usize {
            return Err(self.mesh_error(MeshError::TooManyVertices {
                vertex_count: first.saturating_add(count),
            }));
        }
        Ok(Run {
            first: first as u32,
            count,
        })
    }

    /// Adds a polygon whose vertices are there already. With lenient options, one with an index out of range is left out.
    #[inline]
    pub fn polygon(
        &mut self,
        corners: &[i64],
        run: Run,
        place: FaceSite<'_>,
    ) -> Result<(), LoadError> {
        if !self.are_inside(corners, run, place)? {
            return Ok(());
        }
        // Less than `run.count`, and so less than 2^32.
        self.cut(corners.len(), |i| run.first + corners[i] as u32)
    }

    /// Whether all indices are in range. If not, the face is dropped with lenient options, else an error.
    #[inline]
    pub fn are_inside(
        &mut self,
        corners: &[i64],
        run: Run,
        place: FaceSite<'_>,
    ) -> Result<bool, LoadError> {
        let outside = |&&corner: &&i64| !usize::try_from(corner).is_ok_and(|i| i < run.count);
        let Some(&index) = corners.iter().find(outside) else {
            return Ok(true);
        };
        if self.source.options.lenient {
            self.dropped_count += 1;
            return Ok(false);
        }
        Err(LoadError::IndexOutOfRange {
            file: self.source.file.clone(),
            line: place.line,
            part: place
                .part
                .map_or_else(String::new, |part| format!("mesh \"{}\", ", excerpt(part))),
            face: place.face,
            list: Indexed::Vertices,
            index,
            count: run.count,
        })
    }

    /// Adds the triangles of a polygon of `count` corners, whose vertices are in the mesh. Fewer than three corners add nothing, which is
    /// noted.
    #[inline]
    pub fn cut(&mut self, count: usize, vertex: impl Fn(usize) -> u32) -> Result<(), LoadError> {
        match count {
            0..3 => self.small_count += 1,
            3 => self.mesh.indices.push([vertex(0), vertex(1), vertex(2)]),
            _ => {
                let vertices = &self.vertices;
                let position = |i| DVec3::from(vertices.get(vertex(i)).unwrap_or_default());
                let indices = &mut self.mesh.indices;
                let push = |t: [u32; 3]| indices.push(t.map(|i| vertex(i as usize)));
                self.cutter.cut((0..count).map(position), push);
            }
        }
        self.check_triangle_count()
    }

    /// Refuses more triangles than a tree can hold, before they fill the memory.
    #[inline]
    fn check_triangle_count(&self) -> Result<(), LoadError> {
        let limit = slimbvh_core::MAX_TRIANGLES as usize;
        if self.mesh.indices.len() <= limit {
            return Ok(());
        }
        Err(self.mesh_error(MeshError::TooManyTriangles {
            triangle_count: self.mesh.indices.len(),
            limit,
        }))
    }

    fn mesh_error(&self, error: MeshError) -> LoadError {
        LoadError::Mesh {
            file: self.source.file.clone(),
            error,
        }
    }

    /// A scene with only the mesh.
    pub fn into_found(self) -> Found {
        let small = "faces with fewer than three corners";
        self.source.leave_out(small, self.small_count);
        if self.cutter.large_count > 0 {
            let large = format!("concave shapes of polygons with more than {MOST_CORNERS} corners");
            self.source.leave_out(&large, self.cutter.large_count);
        }
        Found {
            scene: Scene {
                mesh: self.mesh,
                dropped_face_count: self.dropped_count,
                ..Scene::default()
            },
            vertices: self.vertices,
            ..Found::default()
        }
    }
}

/// The normal, with length 1. Zero (flat shading) if it has no direction.
pub(super) fn unit_or_zero(normal: [f32; 3]) -> [f32; 3] {
    glam::Vec3::from_array(normal)
        .normalize_or_zero()
        .to_array()
}

/// A share, clamped to 0 to 1; 0 for NaN.
pub(super) fn share(value: f32) -> f32 {
    if value > 0.0 { value.min(1.0) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_and_normals_are_never_nan() {
        assert_eq!(share(f32::NAN), 0.0);
        assert_eq!(share(-2.0), 0.0);
        assert_eq!(share(7.0), 1.0);
        assert_eq!(unit_or_zero([0.0, 3.0, 4.0]), [0.0, 0.6, 0.8]);
        assert_eq!(unit_or_zero([f32::NAN, 1.0, 2.0]), [0.0; 3]);
        assert_eq!(unit_or_zero([0.0; 3]), [0.0; 3]);
        assert_eq!(unit_or_zero([1e30, 0.0, 0.0]), [0.0; 3]);
    }
}
