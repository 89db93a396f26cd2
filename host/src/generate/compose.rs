//! Combining meshes.

use crate::{Mesh, Part};
use glam::{Quat, Vec3};

/// Adds another mesh as one part. Its material `i` becomes `material + i`, and its own parts are dropped. If only one of
/// the two has normals, the other is shaded flat. Triangles of no part become a part "0".
///
/// # Panics
/// If the vertices of both are more than a `u32` can index.
pub fn append(mesh: &mut Mesh, mut other: Mesh, name: &str, material: u32) {
    let (first, count) = (mesh.indices.len(), other.indices.len());
    if mesh.parts.is_empty() && first > 0 {
        mesh.parts.push(part("0", 0, first));
    }
    mesh.parts.push(part(name, first, count));
    mesh.materials.resize(first, 0);
    other.materials.resize(count, 0);
    mesh.materials
        .extend(other.materials.iter().map(|own| material + own));
    concatenate(mesh, &other);
}

/// A mesh scaled about the origin, then rotated, then moved. `scale` must be above 0.
#[must_use]
pub fn transformed(mut mesh: Mesh, scale: f32, rotation: Quat, translation: Vec3) -> Mesh {
    for vertex in &mut mesh.vertices {
        *vertex = (rotation * (scale * Vec3::from(*vertex)) + translation).to_array();
    }
    for normal in &mut mesh.normals {
        *normal = (rotation * Vec3::from(*normal))
            .normalize_or_zero()
            .to_array();
    }
    mesh
}

/// Adds another mesh's vertices, normals and triangles, but not its materials or parts.
///
/// # Panics
/// If the vertices of both are more than a `u32` can index.
pub fn concatenate(mesh: &mut Mesh, other: &Mesh) {
    let vertex_count = mesh.vertices.len();
    assert!(
        u32::try_from(vertex_count + other.vertices.len()).is_ok(),
        "vertices are numbered by a u32"
    );
    if !mesh.normals.is_empty() || !other.normals.is_empty() {
        mesh.normals.resize(vertex_count, [0.0; 3]);
        mesh.normals.extend(&other.normals);
        mesh.normals
            .resize(vertex_count + other.vertices.len(), [0.0; 3]);
    }
    mesh.vertices.extend(&other.vertices);
    let first = vertex_count as u32;
    mesh.indices.extend(
        other
            .indices
            .iter()
            .map(|triangle| triangle.map(|vertex| first + vertex)),
    );
}

fn part(name: &str, first: usize, count: usize) -> Part {
    Part {
        name: name.into(),
        first_triangle: first as u32,
        triangle_count: count as u32,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::checks::{assert_solid, assert_unit_normals};
    use crate::generate::{cuboid, icosphere};
    use std::f32::consts::FRAC_PI_2;

    #[test]
    fn appended_meshes_keep_their_lists_in_step() {
        let mut mesh = cuboid(Vec3::splat(2.0), Vec3::new(3.0, 4.0, 5.0));
        let mut sphere = icosphere(Vec3::ZERO, 1.0, 0);
        sphere.materials = (0..20).collect();
        let normal = sphere.normals[0];
        append(&mut mesh, sphere, "sphere", 5);
        append(
            &mut mesh,
            cuboid(Vec3::splat(9.0), Vec3::splat(9.5)),
            "box",
            1,
        );
        assert_eq!(assert_solid(&mesh).len(), 3);
        assert_eq!(mesh.normals[8], normal);
        assert_eq!((mesh.normals[7], mesh.normals[20]), ([0.0; 3], [0.0; 3]));
        assert_eq!(mesh.materials[11..14], [0, 5, 6]);
        assert_eq!(mesh.materials[31..33], [24, 1]);
        let names: Vec<_> = mesh
            .parts
            .iter()
            .map(|p| (p.name.as_str(), p.first_triangle, p.triangle_count))
            .collect();
        assert_eq!(names, [("0", 0, 12), ("sphere", 12, 20), ("box", 32, 12)]);
    }

    #[test]
    fn scaled_then_rotated_then_moved() {
        let mesh = cuboid(Vec3::ZERO, Vec3::new(1.0, 2.0, 3.0));
        let quarter = Quat::from_rotation_y(FRAC_PI_2);
        let moved = transformed(mesh, 2.0, quarter, Vec3::new(10.0, 20.0, 30.0));
        let component = &assert_solid(&moved)[0];
        assert!((component.signed_volume - 48.0).abs() < 1e-4);
        let (min, max) = (component.bounds.min, component.bounds.max);
        assert!(min.distance(Vec3::new(10.0, 20.0, 28.0)) < 1e-5);
        assert!(max.distance(Vec3::new(16.0, 24.0, 30.0)) < 1e-5);
        let sphere = icosphere(Vec3::ZERO, 1.0, 1);
        let moved = transformed(sphere.clone(), 0.1, quarter, Vec3::ONE);
        assert_unit_normals(&moved);
        let turned = quarter * Vec3::from(sphere.normals[3]);
        assert!(Vec3::from(moved.normals[3]).distance(turned) < 1e-6);
    }
}
