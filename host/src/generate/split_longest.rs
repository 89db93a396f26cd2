//! Refining meshes to a number of triangles.

use crate::Mesh;
use crate::analysis::weld;
use crate::dvec3::dot;
use glam::Vec3;
use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};

/// Splits the longest edge at its midpoint until there are at least `triangle_count` triangles. Splits all triangles at an
/// edge together, including those that share it only by equal positions, so a closed mesh stays closed. If each edge
/// belongs to two triangles, each split adds two, and even differences are met exactly.
///
/// The surface does not change, rounding aside. Normals are interpolated; each half keeps its triangle's material, part and
/// position in the order. Triangles with two corners at one position are not split, so a mesh of only these is unchanged.
/// The mesh must be [sound](Mesh::validate).
#[must_use]
pub fn split_longest(mesh: &Mesh, triangle_count: usize) -> Mesh {
    let mut splitting = Splitting::new(mesh.clone());
    while splitting.mesh.indices.len() < triangle_count {
        let Some((_, Reverse(edge))) = splitting.queue.pop() else {
            break;
        };
        splitting.split(edge);
    }
    splitting.finish()
}

/// Two positions, the smaller number first.
type Edge = [u32; 2];

/// A mesh whose edges are queued for splitting.
struct Splitting {
    mesh: Mesh,
    /// The position number of each vertex: equal for equal positions of the given mesh.
    places: Vec<u32>,
    place_count: u32,
    /// The triangle of the given mesh that each triangle is part of.
    origins: Vec<u32>,
    /// The triangles at each edge.
    sides: HashMap<Edge, Vec<u32>>,
    /// Each edge with the bits of its squared length, which order as lengths do; among equals, the smaller edge first.
    queue: BinaryHeap<(u64, Reverse<Edge>)>,
}

impl Splitting {
    fn new(mesh: Mesh) -> Self {
        let places = weld(&mesh.vertices);
        let mut splitting = Self {
            place_count: places.iter().max().map_or(0, |&last| last + 1),
            places,
            origins: (0..mesh.indices.len() as u32).collect(),
            sides: HashMap::with_capacity(mesh.indices.len() * 3 / 2),
            queue: BinaryHeap::with_capacity(mesh.indices.len() * 3 / 2),
            mesh,
        };
        for triangle in 0..splitting.mesh.indices.len() as u32 {
            let corners = splitting.mesh.indices[triangle as usize];
            let [a, b, c] = corners.map(|vertex| splitting.places[vertex as usize]);
            if a != b && b != c && c != a {
                for side in 0..3 {
                    splitting.add_side(corners[side], corners[(side + 1) % 3], triangle);
                }
            }
        }
        splitting
    }

    fn edge(&self, a: u32, b: u32) -> Edge {
        let [a, b] = [a, b].map(|vertex| self.places[vertex as usize]);
        [a.min(b), a.max(b)]
    }

    /// Adds a triangle to the edge between two vertices, and queues the edge.
    fn add_side(&mut self, a: u32, b: u32, triangle: u32) {
        let edge = self.edge(a, b);
        let sides = self.sides.entry(edge).or_default();
        if sides.is_empty() {
            let [a, b] = [a, b].map(|v| self.mesh.vertices[v as usize].map(f64::from));
            let side = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
            let squared = dot(side, side);
            self.queue.push((squared.to_bits(), Reverse(edge)));
        }
        sides.push(triangle);
    }

    /// Splits all triangles at an edge.
    fn split(&mut self, edge: Edge) {
        // Vertices at one position may differ in their normals, and so may the midpoints between them.
        let mut middles: Vec<([u32; 2], u32)> = Vec::new();
        let place = self.place_count;
        self.place_count += 1;
        for triangle in self.sides.remove(&edge).unwrap_or_default() {
            let corners = self.mesh.indices[triangle as usize];
            let side = (0..3).find(|&i| self.edge(corners[i], corners[(i + 1) % 3]) == edge);
            let first = side.unwrap_or_default();
            let [a, b, c] = [0, 1, 2].map(|i| corners[(first + i) % 3]);
            let ends = [a.min(b), a.max(b)];
            let known = middles.iter().find(|(other, _)| *other == ends);
            let middle = match known {
                Some(&(_, middle)) => middle,
                None => {
                    let middle = self.add_middle(ends, place);
                    middles.push((ends, middle));
                    middle
                }
            };

            // The first half keeps the index; the second takes over the side between b and c.
            let second = self.mesh.indices.len() as u32;
            let mut half = corners;
            half[(first + 1) % 3] = middle;
            self.mesh.indices[triangle as usize] = half;
            let mut half = corners;
            half[first] = middle;
            self.mesh.indices.push(half);
            self.origins.push(self.origins[triangle as usize]);
            let beside = self.edge(b, c);
            for side in self.sides.entry(beside).or_default() {
                if *side == triangle {
                    *side = second;
                }
            }
            self.add_side(a, middle, triangle);
            self.add_side(middle, b, second);
            self.add_side(middle, c, triangle);
            self.add_side(middle, c, second);
        }
    }

    /// Adds the midpoint of two vertices.
    fn add_middle(&mut self, ends: [u32; 2], place: u32) -> u32 {
        let mesh = &mut self.mesh;
        let ends = ends.map(|end| end as usize);
        let [a, b] = ends.map(|end| Vec3::from(mesh.vertices[end]));
        mesh.vertices.push((0.5 * a + 0.5 * b).to_array());
        if !mesh.normals.is_empty() {
            let [a, b] = ends.map(|end| Vec3::from(mesh.normals[end]));
            let is_flat = a == Vec3::ZERO || b == Vec3::ZERO;
            let normal = if is_flat {
                Vec3::ZERO
            } else {
                (a + b).normalize_or_zero()
            };
            mesh.normals.push(normal.to_array());
        }
        self.places.push(place);
        self.mesh.vertices.len() as u32 - 1
    }

    /// Moves the parts of each triangle to its position in the order.
    fn finish(self) -> Mesh {
        let Self {
            mut mesh, origins, ..
        } = self;
        let mut order: Vec<u32> = (0..origins.len() as u32).collect();
        order.sort_by_key(|&triangle| origins[triangle as usize]);
        let indices = order
            .iter()
            .map(|&triangle| mesh.indices[triangle as usize]);
        mesh.indices = indices.collect();
        let origin = |&triangle: &u32| origins[triangle as usize];
        if !mesh.materials.is_empty() {
            let materials = order
                .iter()
                .map(|triangle| mesh.materials[origin(triangle) as usize]);
            mesh.materials = materials.collect();
        }
        for part in &mut mesh.parts {
            let end = part.first_triangle + part.triangle_count;
            let before = |end: u32| order.partition_point(|triangle| origin(triangle) < end) as u32;
            part.first_triangle = before(part.first_triangle);
            part.triangle_count = before(end) - part.first_triangle;
        }
        mesh
    }
}

#[cfg(test)]
mod tests;
