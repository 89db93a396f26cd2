//! Borders and silhouettes of surfaces.

use crate::oracle::Unculled;
use crate::oracle::distance::{Point, between, sides};
use slimbvh::internals::{Edges, Side, excess, weld};
use slimbvh_core::Ray;
use std::collections::BTreeSet;

/// The triangles of a scene, and how they are connected.
#[derive(Clone, Debug)]
pub struct Surface {
    /// The edge on each side of each triangle; [`NO_EDGE`] if both ends of the side coincide.
    edge_of: Vec<[u32; 3]>,
    edges: Vec<Edge>,
    /// The triangles along the edges, in runs.
    along: Vec<u32>,
}

const NO_EDGE: u32 = u32::MAX;

/// The largest number of triangles that are visited near a ray. Beyond it the surface counts as ended.
const MOST_NEAR: usize = 4096;

#[derive(Clone, Copy, Debug)]
struct Edge {
    first: u32,
    count: u32,
    /// Whether triangles pass it more often in one direction than in the other.
    is_border: bool,
}

impl Surface {
    /// Corners at equal positions count as one.
    #[must_use]
    pub fn new(triangles: &[[[f32; 3]; 3]]) -> Self {
        let ids = weld(triangles.as_flattened());
        let welded: Vec<[u32; 3]> = ids.chunks(3).map(|id| [id[0], id[1], id[2]]).collect();
        let mut surface = Self {
            edge_of: vec![[NO_EDGE; 3]; triangles.len()],
            edges: Vec::new(),
            along: Vec::new(),
        };
        Edges::new(&welded, ids.len()).for_each(|sides| surface.add(sides, &welded));
        surface
    }

    fn add(&mut self, sides: &[Side], welded: &[[u32; 3]]) {
        let edge = self.edges.len() as u32;
        self.edges.push(Edge {
            first: self.along.len() as u32,
            count: sides.len() as u32,
            is_border: excess(sides) != 0,
        });
        for side in sides {
            let triangle = side.triangle();
            let [smaller, larger] = side.corners(welded[triangle as usize]);
            let from = if side.is_forward() { smaller } else { larger };
            self.edge_of[triangle as usize][from] = edge;
            self.along.push(triangle);
        }
    }

    /// Whether no edge is a border.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.edges.iter().all(|edge| !edge.is_border)
    }

    fn neighbours(&self, edge: Edge) -> &[u32] {
        &self.along[edge.first as usize..][..edge.count as usize]
    }

    /// Whether the surface continues around the point where a ray hits a triangle: neither a border nor a silhouette is
    /// within `reach`. `line` is the relevant part of the ray.
    #[must_use]
    pub fn goes_on(
        &self,
        scene: &Unculled,
        (ray, line): (&Ray, [Point; 2]),
        primitive: u32,
        reach: f64,
    ) -> bool {
        let facing = scene.facing(ray, primitive);
        let mut near = BTreeSet::from([primitive]);
        let mut waiting = vec![primitive];
        while let Some(triangle) = waiting.pop() {
            let corners = scene.triangle(triangle).map(|p| p.map(f64::from));
            let edges = self.edge_of[triangle as usize].into_iter();
            for (edge, side) in edges.zip(sides(corners)) {
                if edge == NO_EDGE || between(line, side) > reach {
                    continue;
                }
                let edge = self.edges[edge as usize];
                if edge.is_border {
                    return false;
                }
                for &next in self.neighbours(edge) {
                    if near.insert(next) {
                        waiting.push(next);
                        let is_turned = scene.facing(ray, next) == -facing;
                        if is_turned || near.len() > MOST_NEAR {
                            return false;
                        }
                    }
                }
            }
        }
        facing != 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use slimbvh::generate::icosphere;

    fn corners(mesh: &slimbvh::Mesh) -> Vec<[[f32; 3]; 3]> {
        let corner = |v: u32| mesh.vertices[v as usize];
        mesh.indices.iter().map(|face| face.map(corner)).collect()
    }

    fn asks(triangles: Vec<[[f32; 3]; 3]>, x: f32) -> bool {
        let (surface, scene) = (Surface::new(&triangles), Unculled::new(triangles));
        let ray = Ray::new([x, 0.013, 5.0], [0.0, 0.0, -1.0]);
        let line = [[x, 0.013, 5.0], [x, 0.013, -5.0]].map(|p| p.map(f64::from));
        let first = scene.crossings(&ray, u32::MAX)[0].primitive;
        surface.goes_on(&scene, (&ray, line), first, 0.01)
    }

    #[test]
    fn silhouettes_and_borders_end_a_surface() {
        let sphere = corners(&icosphere(Vec3::ZERO, 1.0, 3));
        assert!(asks(sphere.clone(), 0.1) && asks(sphere.clone(), 0.5));
        assert!(!asks(sphere.clone(), 0.9935));
        // Cut a hole beside the ray.
        let scene = Unculled::new(sphere.clone());
        let ray = Ray::new([0.1, 0.013, 5.0], [0.0, 0.0, -1.0]);
        let first = scene.crossings(&ray, u32::MAX)[0].primitive;
        let line = [[0.1, 0.013, 5.0], [0.1, 0.013, -5.0]].map(|p| p.map(f64::from));
        let surface = Surface::new(&sphere);
        let near = |reach: f64| surface.goes_on(&scene, (&ray, line), first, reach);
        assert!(near(0.05) && !near(3.0));
        let mut open = sphere;
        let kept = open[first as usize];
        open.retain(|triangle| *triangle == kept || !triangle.iter().any(|p| kept.contains(p)));
        let at = open.iter().position(|triangle| *triangle == kept);
        let (surface, scene) = (Surface::new(&open), Unculled::new(open));
        let at = at.map_or(0, |at| at as u32);
        assert!(!surface.goes_on(&scene, (&ray, line), at, 0.2));
        assert!(surface.goes_on(&scene, (&ray, line), at, 0.0));
    }
}
