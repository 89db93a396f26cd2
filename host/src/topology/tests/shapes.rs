//! Meshes with known surfaces.

use crate::Mesh;
use crate::generate::{TorusKnot, append, cuboid, icosphere, torus_knot};
use glam::Vec3;
use std::f64::consts::TAU;

/// A mesh without normals.
fn plain(vertices: Vec<[f32; 3]>, indices: Vec<[u32; 3]>) -> Mesh {
    Mesh {
        vertices,
        indices,
        ..Mesh::default()
    }
}

pub(super) fn sphere(center: [f32; 3], radius: f32) -> Mesh {
    let mesh = icosphere(Vec3::from(center), radius, 2);
    plain(mesh.vertices, mesh.indices)
}

/// A box with shared corners.
pub(super) fn block(min: [f32; 3], max: [f32; 3]) -> Mesh {
    let mesh = cuboid(Vec3::from(min), Vec3::from(max));
    plain(mesh.vertices, mesh.indices)
}

/// A trefoil; its tube intersects itself if `tube_radius` is above about 0.3.
pub(super) fn knot(tube_radius: f32) -> Mesh {
    let mesh = torus_knot(&TorusKnot {
        p: 2,
        q: 3,
        segments: 60,
        sides: 8,
        major_radius: 1.0,
        minor_radius: 0.4,
        tube_radius,
    });
    plain(mesh.vertices, mesh.indices)
}

/// A ring of rings of quadrilaterals. The last ring joins the first, flipped if `is_twisted`.
pub(super) fn rings(
    count: u32,
    sides: u32,
    is_twisted: bool,
    place: impl Fn(u32, u32) -> [f64; 3],
) -> Mesh {
    let vertex = |ring: u32, side: u32| {
        let side = side % sides;
        if ring < count {
            ring * sides + side
        } else if is_twisted {
            (sides - side) % sides
        } else {
            side
        }
    };
    let mut mesh = Mesh::default();
    for ring in 0..count {
        for side in 0..sides {
            mesh.vertices.push(place(ring, side).map(|x| x as f32));
            let [a, b] = [vertex(ring, side), vertex(ring, side + 1)];
            let [c, d] = [vertex(ring + 1, side), vertex(ring + 1, side + 1)];
            mesh.indices.extend([[a, c, b], [b, c, d]]);
        }
    }
    mesh
}

/// A lemniscate in the x–z plane around x = 3, revolved around the z axis. Its left lobe is inside out. With `offset` 0
/// both lobes share the corners where they meet; otherwise the tube intersects itself there. `sides` is a multiple of 4.
pub(super) fn figure_eight(sides: u32, offset: f64) -> Mesh {
    rings(24, sides, false, |ring, side| {
        let t = TAU * (f64::from(side) + offset) / f64::from(sides);
        let is_crossing = offset == 0.0 && side % (sides / 2) == sides / 4;
        let (sin, cos) = if is_crossing { (1.0, 0.0) } else { t.sin_cos() };
        let (x, z) = (3.0 + cos / (1.0 + sin * sin), sin * cos / (1.0 + sin * sin));
        let (sin, cos) = (TAU * f64::from(ring) / 24.0).sin_cos();
        [x * cos, x * sin, z]
    })
}

/// A Klein bottle: closed, but without an outer side.
pub(super) fn klein_bottle(is_twisted: bool) -> Mesh {
    rings(16, 12, is_twisted, |ring, side| {
        let (u, v) = (TAU * f64::from(ring) / 16.0, TAU * f64::from(side) / 12.0);
        let r = 3.0 + (u / 2.0).cos() * v.sin() - (u / 2.0).sin() * (2.0 * v).sin();
        [
            r * u.cos(),
            r * u.sin(),
            (u / 2.0).sin() * v.sin() + (u / 2.0).cos() * (2.0 * v).sin(),
        ]
    })
}

pub(super) fn inverted(mut mesh: Mesh) -> Mesh {
    for triangle in &mut mesh.indices {
        triangle.swap(0, 1);
    }
    mesh
}

/// Both meshes' triangles, in order.
pub(super) fn join(mut mesh: Mesh, other: Mesh) -> Mesh {
    append(&mut mesh, other, "other", 0);
    plain(mesh.vertices, mesh.indices)
}

/// Gives every triangle its own three vertices.
pub(super) fn unwelded(mesh: &Mesh) -> Mesh {
    let corners = mesh.indices.as_flattened().iter();
    plain(
        corners.map(|&v| mesh.vertices[v as usize]).collect(),
        (0..mesh.indices.len() as u32)
            .map(|t| [3 * t, 3 * t + 1, 3 * t + 2])
            .collect(),
    )
}

/// A mesh times a power of two.
pub(super) fn scaled(mut mesh: Mesh, exponent: i32) -> Mesh {
    let factor = 2_f32.powi(exponent);
    for x in mesh.vertices.as_flattened_mut() {
        *x *= factor;
    }
    mesh
}

pub(super) fn moved(mut mesh: Mesh, by: [f32; 3]) -> Mesh {
    for vertex in &mut mesh.vertices {
        *vertex = [0, 1, 2].map(|axis| vertex[axis] + by[axis]);
    }
    mesh
}
