//! Solids from rings of vertices.

use crate::Mesh;
use glam::Vec3;

/// A position and its normal.
pub type Vertex = (Vec3, Vec3);

/// The solid between two points with rings of `sides` vertices in between, at least 3, each counter-clockwise as seen from
/// the last point: `2 * sides * rings` triangles. Without rings the mesh is empty.
pub fn close_rings(first: Vertex, rings: &[Vec<Vertex>], last: Vertex) -> Mesh {
    let sides = rings.first().map_or(0, Vec::len) as u32;
    if sides == 0 {
        return Mesh::default();
    }
    let mut mesh = Mesh::default();
    for &(position, normal) in rings.iter().flatten().chain([&first, &last]) {
        mesh.vertices.push(position.to_array());
        mesh.normals.push(normal.to_array());
    }
    let end = rings.len() as u32 - 1;
    let vertex = |ring: u32, side: u32| ring * sides + side % sides;
    let (first, last) = (vertex(end + 1, 0), vertex(end + 1, 1));
    for side in 0..sides {
        mesh.indices
            .push([first, vertex(0, side + 1), vertex(0, side)]);
    }
    for ring in 0..end {
        for side in 0..sides {
            let (a, b) = (vertex(ring, side), vertex(ring, side + 1));
            let (c, d) = (vertex(ring + 1, side), vertex(ring + 1, side + 1));
            mesh.indices.extend([[a, b, c], [c, b, d]]);
        }
    }
    for side in 0..sides {
        mesh.indices
            .push([last, vertex(end, side), vertex(end, side + 1)]);
    }
    mesh
}
