//! Triangles of a glTF mesh.

use super::super::LoadError;
use super::super::faces::{FaceSite, unit_or_zero};
use super::{Flat, GltfError, accessor};
use crate::text::excerpt;
use glam::{Mat3, Mat4, Vec3};
use gltf::mesh::Mode;
use gltf::{Primitive, Semantic};

/// Adds a primitive's triangles to a part. Points and lines add nothing.
pub(super) fn append(
    primitive: &Primitive<'_>,
    part: &str,
    transform: Mat4,
    flat: &mut Flat<'_>,
) -> Result<(), LoadError> {
    let mode = primitive.mode();
    let is_surface = matches!(
        mode,
        Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan
    );
    let Some(positions) = primitive.get(&Semantic::Positions).filter(|_| is_surface) else {
        return Ok(());
    };

    // Read the lists.
    let read = |result: Result<_, GltfError>| result.map_err(|error| flat.error(error));
    let positions = read(accessor::vectors(&positions, flat.buffers))?;
    let normals = match primitive.get(&Semantic::Normals) {
        Some(normals) => read(accessor::vectors(&normals, flat.buffers))?,
        None => Vec::new(),
    };
    if !normals.is_empty() && normals.len() != positions.len() {
        return Err(flat.error(GltfError::NormalCount {
            part: excerpt(part),
            normals: normals.len(),
            positions: positions.len(),
        }));
    }
    let indices = match primitive.indices() {
        Some(indices) => accessor::indices(&indices, flat.buffers),
        None => Ok((0..positions.len() as u32).collect()),
    };
    let indices = indices.map_err(|error| flat.error(error))?;

    let face_count = triangle_count(mode, indices.len());
    if face_count == 0 {
        return Ok(());
    }

    // Place the vertices.
    let run = flat.faces.next_run(positions.len())?;
    let mesh = &mut flat.faces.mesh;
    let first_vertex = flat.faces.vertices.len();
    let place = |p: [f32; 3]| transform.transform_point3(Vec3::from_array(p)).to_array();
    for position in positions {
        flat.faces.vertices.push(place(position).map(f64::from));
    }
    if !normals.is_empty() {
        let turn = normal_matrix(transform);
        mesh.normals.resize(first_vertex, [0.0; 3]);
        let turned = normals.into_iter().map(|n| turn * Vec3::from_array(n));
        mesh.normals
            .extend(turned.map(|n| unit_or_zero(n.to_array())));
    } else if !mesh.normals.is_empty() {
        mesh.normals.resize(flat.faces.vertices.len(), [0.0; 3]);
    }

    // A mirroring transform flips triangles, so flip them back.
    let is_mirrored = transform.determinant() < 0.0;
    for face in 0..face_count {
        let mut corners = corners(mode, face).map(|corner| i64::from(indices[corner]));
        if is_mirrored {
            corners.swap(1, 2);
        }
        let place = FaceSite {
            line: None,
            part: Some(part),
            face,
        };
        flat.faces.polygon(&corners, run, place)?;
    }
    Ok(())
}

fn triangle_count(mode: Mode, corner_count: usize) -> usize {
    match mode {
        Mode::Triangles => corner_count / 3,
        _ => corner_count.saturating_sub(2),
    }
}

/// The indices of a triangle's corners; glTF 2.0, section 3.7.2.1.
fn corners(mode: Mode, face: usize) -> [usize; 3] {
    match mode {
        Mode::TriangleStrip => [face, face + 1 + face % 2, face + 2 - face % 2],
        Mode::TriangleFan => [face + 1, face + 2, 0],
        _ => [3 * face, 3 * face + 1, 3 * face + 2],
    }
}

/// The inverse transpose up to a positive factor, defined also for singular matrices.
fn normal_matrix(transform: Mat4) -> Mat3 {
    let m = Mat3::from_mat4(transform);
    let cofactors = Mat3::from_cols(
        m.y_axis.cross(m.z_axis),
        m.z_axis.cross(m.x_axis),
        m.x_axis.cross(m.y_axis),
    );
    match m.determinant() < 0.0 {
        true => -cofactors,
        false => cofactors,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strips_keep_their_winding() {
        let strip = |face| corners(Mode::TriangleStrip, face);
        assert_eq!(
            [strip(0), strip(1), strip(2)],
            [[0, 1, 2], [1, 3, 2], [2, 3, 4]]
        );
        assert_eq!(corners(Mode::TriangleFan, 1), [2, 3, 0]);
        assert_eq!(triangle_count(Mode::TriangleStrip, 5), 3);
        assert_eq!(triangle_count(Mode::TriangleFan, 1), 0);
        assert_eq!(triangle_count(Mode::Triangles, 8), 2);
    }

    #[test]
    fn normals_stay_perpendicular_and_outside() {
        // A plane x + y = 1 stretched by 2 along x becomes x/2 + y = 1.
        let stretched =
            normal_matrix(Mat4::from_scale(Vec3::new(2.0, 1.0, 1.0))) * Vec3::new(1.0, 1.0, 0.0);
        assert_eq!(stretched.normalize(), Vec3::new(1.0, 2.0, 0.0).normalize());
        let mirrored = normal_matrix(Mat4::from_scale(Vec3::new(-1.0, 2.0, 3.0)));
        assert_eq!((mirrored * Vec3::X).normalize(), -Vec3::X);
        assert_eq!((mirrored * Vec3::Y).normalize(), Vec3::Y);
    }
}
