//! Facts about a mesh: its connected components, their closedness and orientation, and its faults.

mod buckets;
mod collinear;
mod components;
pub(crate) mod edges;
mod labels;
mod predicates;
mod union_find;
mod volume;
pub(crate) mod weld;

#[cfg(test)]
mod tests;

use crate::Mesh;
use glam::Vec3;
use slimbvh_core::Aabb;

pub(crate) use buckets::Buckets;
pub(crate) use collinear::are_collinear;
pub(crate) use edges::{Edges, Side, excess};
pub(crate) use labels::{Labels, NONE};
pub(crate) use predicates::{area_sign, volume_sign};
pub(crate) use union_find::UnionFind;
pub(crate) use volume::{Volume, middle, seen_from};
pub(crate) use weld::weld;

/// The facts of one mesh. See [`analyze`].
#[derive(Clone, Debug, PartialEq)]
pub struct Analysis {
    /// Triangles, faulty ones included.
    pub triangle_count: usize,
    /// Vertices, unused ones included.
    pub vertex_count: usize,
    /// Distinct positions of used vertices. Only exactly equal positions weld; -0 equals +0.
    pub welded_vertex_count: usize,
    /// Components, largest first; components of equal size in the order of their first triangles. Triangles whose corners
    /// all weld to one vertex have no edge and belong to none.
    pub components: Vec<Component>,
    /// The box around all used vertices; `None` for a mesh without triangles.
    pub bounds: Option<Aabb>,
    /// Triangles whose corners lie on one line, decided exactly.
    pub degenerate_triangle_count: usize,
    /// Triangles with the same three positions as an earlier one, in any rotation and winding.
    pub duplicate_triangle_count: usize,
}

/// Triangles connected by shared edges between welded vertices. Touching in a point does not connect.
#[derive(Clone, Debug, PartialEq)]
pub struct Component {
    /// The number of triangles.
    pub triangle_count: usize,
    /// Whether every directed edge occurs as often as its reverse. So a closed surface with one flipped face is not closed,
    /// but two closed surfaces that share an edge are.
    pub closed: bool,
    /// Whether no edge is passed in one direction at least twice more than in the other; an edge of two triangles is passed
    /// once each way. True for every closed component, and unaffected by borders.
    pub consistently_wound: bool,
    /// Whether the front sides face outward, by the sign of the volume. `None` if the component is open, or if rounding
    /// could change the sign.
    pub outward: Option<bool>,
    /// The enclosed volume, negative if the front sides face inward. For an open component, the volume of the cone from the
    /// middle of its bounds.
    pub signed_volume: f64,
    /// The box around it.
    pub bounds: Aabb,
}

/// The smallest box around some points; `None` for no points.
pub(crate) fn around(points: impl IntoIterator<Item = [f32; 3]>) -> Option<Aabb> {
    let points = points.into_iter().map(Vec3::from_array);
    let bounds = points.fold(Aabb::EMPTY, Aabb::union_point);
    (!bounds.is_empty()).then_some(bounds)
}

/// Analyzes a mesh in time O(n log n) on one thread.
///
/// # Panics
/// If a triangle refers to a vertex that does not exist; [`Mesh::validate`] checks that.
#[must_use]
pub fn analyze(mesh: &Mesh) -> Analysis {
    // Replace every corner by the number of its position.
    let ids = weld(&mesh.vertices);
    let triangles: Vec<[u32; 3]> = mesh
        .indices
        .iter()
        .map(|triangle| triangle.map(|vertex| ids[vertex as usize]))
        .collect();

    // Count the positions that triangles use.
    let mut used = vec![false; mesh.vertices.len()];
    for &id in triangles.as_flattened() {
        used[id as usize] = true;
    }

    let corners = |triangle: &[u32; 3]| triangle.map(|vertex| mesh.vertices[vertex as usize]);
    Analysis {
        triangle_count: mesh.indices.len(),
        vertex_count: mesh.vertices.len(),
        welded_vertex_count: used.iter().filter(|&&used| used).count(),
        components: components::components(mesh, &triangles),
        bounds: around(mesh.indices.iter().flat_map(corners)),
        degenerate_triangle_count: mesh
            .indices
            .iter()
            .filter(|triangle| are_collinear(corners(triangle)))
            .count(),
        duplicate_triangle_count: count_duplicates(&triangles, mesh.vertices.len()),
    }
}

/// The number of triangles with the same three welded vertices as an earlier triangle.
fn count_duplicates(triangles: &[[u32; 3]], vertex_count: usize) -> usize {
    let by_smallest_vertex = Buckets::new(
        vertex_count,
        triangles.iter().map(|&triangle| {
            let mut sorted = triangle;
            sorted.sort_unstable();
            (sorted[0], u64::from(sorted[1]) << 32 | u64::from(sorted[2]))
        }),
    );
    by_smallest_vertex
        .iter()
        .map(|(_, others)| others.windows(2).filter(|pair| pair[0] == pair[1]).count())
        .sum()
}
