//! Components: triangles connected by edges.

use super::Component;
use super::edges::{Edges, excess};
use super::labels::{Labels, NONE};
use super::volume::{Volume, middle, seen_from};
use crate::Mesh;
use glam::Vec3;
use slimbvh_core::Aabb;

/// The connected components, largest first. `triangles` are those of the mesh over welded vertices.
pub(super) fn components(mesh: &Mesh, triangles: &[[u32; 3]]) -> Vec<Component> {
    let edges = Edges::new(triangles, mesh.vertices.len());
    let labels = Labels::new(&edges, triangles);
    let mut components = measure(mesh, &labels);
    edges.for_each(|sides| {
        let component = &mut components[labels.of[sides[0].triangle() as usize] as usize];
        let excess = excess(sides);
        component.closed &= excess == 0;
        component.consistently_wound &= excess <= 1;
    });
    for component in &mut components {
        if !component.closed {
            component.outward = None;
        }
    }
    components.sort_by_key(|component| std::cmp::Reverse(component.triangle_count));
    components
}

/// Size, bounds and volume of each component, as if all were closed.
fn measure(mesh: &Mesh, labels: &Labels) -> Vec<Component> {
    let faces = || {
        let labelled = mesh.indices.iter().zip(&labels.of);
        labelled
            .filter(|(_, label)| **label != NONE)
            .map(|(indices, &label)| {
                let corners = indices.map(|vertex| mesh.vertices[vertex as usize]);
                (corners, label as usize)
            })
    };

    // Bounds first, because volumes are relative to their middle.
    let empty = Component {
        triangle_count: 0,
        closed: true,
        consistently_wound: true,
        outward: None,
        signed_volume: 0.0,
        bounds: Aabb::EMPTY,
    };
    let mut components = vec![empty; labels.count as usize];
    for (corners, label) in faces() {
        components[label].triangle_count += 1;
        let bounds = &mut components[label].bounds;
        *bounds = corners
            .map(Vec3::from_array)
            .into_iter()
            .fold(*bounds, Aabb::union_point);
    }

    // Sum the tetrahedra between the middle and each triangle.
    let mut volumes = vec![Volume::default(); components.len()];
    for (corners, label) in faces() {
        let [a, b, c] = seen_from(middle(&components[label].bounds), corners);
        volumes[label] += Volume::tetrahedron(a, b, c);
    }
    for (component, volume) in components.iter_mut().zip(volumes) {
        component.signed_volume = volume.signed;
        component.outward = volume.outward();
    }
    components
}
