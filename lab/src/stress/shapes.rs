//! Meshes of the families.

use glam::{Quat, Vec3};
use slimbvh::Mesh;
use slimbvh::generate::{append, ground, teapot, transformed};
use slimbvh::internals::Random;

/// A closed spindle from `-axis` to `axis` around the origin: two fans of needles over one ring of this radius. Its faces
/// point outward.
pub fn spindle(axis: Vec3, radius: f32, needle_count: u32) -> Mesh {
    let [u, v] = [axis.any_orthogonal_vector().normalize(), axis.normalize()];
    let across = [u, v.cross(u)];
    let mut vertices = vec![(-axis).to_array(), axis.to_array()];
    for i in 0..needle_count {
        let (sin, cos) = (std::f32::consts::TAU * i as f32 / needle_count as f32).sin_cos();
        vertices.push((radius * (cos * across[0] + sin * across[1])).to_array());
    }
    let ring = |i: u32| 2 + i % needle_count;
    let needles = |i: u32| [[1, ring(i), ring(i + 1)], [0, ring(i + 1), ring(i)]];
    Mesh {
        indices: (0..needle_count).flat_map(needles).collect(),
        vertices,
        ..Mesh::default()
    }
}

/// Triangles that overlap in one slanted plane. Each occurs five times: twice as it is, reversed, with rotated corners, and
/// as a smaller one.
pub fn coplanar(count: u32, seed: u64) -> Mesh {
    let mut random = Random::new(seed);
    let mut mesh = Mesh::default();
    for _ in 0..count {
        let middle = random.point();
        let corners = [0, 1, 2].map(|_| middle + 0.2 * random.point());
        // A grid of 1/512, so that the plane holds the corners exactly.
        let on_plane = corners.map(|p| {
            let [x, y] = [p.x, p.y].map(|x| (x * 512.0).round() / 512.0);
            [x, y, 0.5 * x - 2.0 * y]
        });
        let [a, b, c] = [0, 1, 2].map(|i| mesh.vertices.len() as u32 + i);
        mesh.vertices.extend(on_plane);
        let [p, q, _] = on_plane.map(Vec3::from);
        mesh.vertices.push(p.midpoint(q).to_array());
        let copies = [[a, b, c], [a, b, c], [a, c, b], [b, c, a], [a, c + 1, c]];
        mesh.indices.extend(copies);
    }
    mesh
}

/// Triangles of all sizes whose boxes are centered at the origin.
pub fn equal_centres(count: u32, seed: u64) -> Mesh {
    let mut random = Random::new(seed);
    let mut mesh = Mesh::default();
    for i in 0..count {
        let p = 2.0 * random.point() - Vec3::ONE;
        // Two opposite corners; the third stays inside their box.
        let third = p * Vec3::new(1.0, -1.0, 1.0) * (2.0 * random.unit() - 1.0);
        mesh.vertices.extend([p, -p, third].map(|p| p.to_array()));
        mesh.indices.push([0, 1, 2].map(|corner| 3 * i + corner));
    }
    mesh
}

/// A teapot on a field two thousand times as wide.
pub fn stadium(cells: u32) -> Mesh {
    let mut mesh = ground(4000.0, cells);
    let teapot = transformed(
        teapot(),
        1.0,
        Quat::from_rotation_y(0.3),
        Vec3::new(211.0, 0.0, -97.0),
    );
    append(&mut mesh, teapot, "teapot", 0);
    mesh
}

/// Moves all triangles into one plane across an axis.
pub fn flattened(mut mesh: Mesh, axis: usize, height: f32) -> Mesh {
    for vertex in &mut mesh.vertices {
        vertex[axis] = height;
    }
    mesh
}

/// Triangles whose coordinates are `±largest`, 0, or anything between.
pub fn extremes(count: u32, largest: f32, seed: u64) -> Mesh {
    let mut random = Random::new(seed);
    let mut mesh = Mesh::default();
    for i in 0..3 * count {
        let coordinate = |share: f32| match (share * 8.0) as u32 {
            0 | 1 => -largest,
            2 | 3 => largest,
            4 => 0.0,
            _ => largest * (8.0 * share - 6.5),
        };
        let corner = random.point().to_array().map(coordinate);
        mesh.vertices
            .push(corner.map(|x| x.clamp(-largest, largest)));
        if i % 3 == 2 {
            mesh.indices.push([i - 2, i - 1, i]);
        }
    }
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;
    use slimbvh::analysis::analyze;

    #[test]
    fn spindles_are_closed_and_face_out() {
        for radius in [0.5, 1e-2, 1e-6] {
            let analysis = analyze(&spindle(Vec3::new(0.6, 0.48, 0.64), radius, 24));
            assert_eq!(analysis.components.len(), 1);
            assert!(analysis.components[0].closed);
            assert_eq!(analysis.components[0].outward, Some(true));
            assert_eq!(analysis.degenerate_triangle_count, 0);
        }
    }

    #[test]
    fn shapes_are_what_they_are_named_for() {
        let mesh = coplanar(40, 1);
        let exact = |p: &[f32; 3]| p[2] == 0.5 * p[0] - 2.0 * p[1];
        assert!(mesh.validate().is_ok() && mesh.vertices.iter().all(exact));
        assert_eq!(analyze(&mesh).duplicate_triangle_count, 120);
        let mesh = equal_centres(100, 1);
        for face in &mesh.indices {
            let corners = face.map(|v| Vec3::from(mesh.vertices[v as usize]));
            let low = corners[0].min(corners[1]).min(corners[2]);
            assert_eq!(low, -corners[0].max(corners[1]).max(corners[2]));
        }
        let quarter = f32::MAX / 4.0;
        let mesh = extremes(50, quarter, 2);
        let bounds = mesh.bounds().map(|bounds| (bounds.min, bounds.max));
        assert_eq!(bounds, Some((Vec3::splat(-quarter), Vec3::splat(quarter))));
    }
}
