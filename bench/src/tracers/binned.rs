//! The crate bvh: its binary tree, built by binned surface areas.

use super::{Answer, Bytes, Tracer, answer_all, from_start, length};
use anyhow::Result;
use bvh::aabb::{Aabb, Bounded, IntersectsAabb};
use bvh::bounding_hierarchy::{BHShape, BoundingHierarchy};
use bvh::bvh::{Bvh, BvhNode};
use bvh::ray::Ray as PeerRay;
use glam::Vec3;
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use slimbvh::{Mesh, Stages};
use slimbvh_core::Ray;
use std::cell::Cell;

/// A triangle in the crate's form: it computes its own box and stores the number of its node.
struct Shape {
    corners: [Point3<f32>; 3],
    primitive: u32,
    node: u32,
}

impl Bounded<f32, 3> for Shape {
    fn aabb(&self) -> Aabb<f32, 3> {
        let [a, b, c] = &self.corners;
        Aabb::empty().grow(a).grow(b).grow(c)
    }
}

impl BHShape<f32, 3> for Shape {
    fn set_bh_node_index(&mut self, index: usize) {
        self.node = index as u32;
    }

    fn bh_node_index(&self) -> usize {
        self.node as usize
    }
}

/// The crate's `Bvh`, built in parallel.
///
/// The tree returns candidates, and the crate's own triangle test decides. As that test culls back faces, each triangle is
/// tested with both windings.
pub struct Binned {
    name: &'static str,
    order: Order,
    shapes: Vec<Shape>,
    bvh: Bvh<f32, 3>,
}

/// The order of candidates for the closest hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// By their boxes, nearest first, up to the first box behind the best hit.
    Nearest,
    /// All candidates, in the order of the tree.
    All,
    /// In the order of the tree, without boxes behind the best hit so far; the crate lets the caller choose the box test.
    Pruned,
}

impl Binned {
    /// A tracer without a tree yet, with the list of triangles.
    #[must_use]
    pub fn new(name: &'static str, order: Order, mesh: &Mesh) -> Self {
        let corner = |i: u32| Point3::from(mesh.vertices[i as usize]);
        let shape = |(primitive, face): (usize, &[u32; 3])| Shape {
            corners: face.map(corner),
            primitive: primitive as u32,
            node: 0,
        };
        Self {
            name,
            order,
            shapes: mesh.indices.par_iter().enumerate().map(shape).collect(),
            bvh: Bvh { nodes: Vec::new() },
        }
    }

    fn closest_hit(&self, ray: &Ray) -> Answer {
        let (ray, shift) = from_start(ray);
        let line = Line::new(&ray);
        let mut best = Answer::MISS;
        let mut add = |shape: &Shape, nearest: f32| {
            let distance = line.distance(shape);
            if distance >= nearest || line.t(distance) > ray.t_max {
                return nearest;
            }
            best = Answer {
                t: line.t(distance) + shift,
                primitive: shape.primitive,
            };
            distance
        };
        match self.order {
            Order::Nearest => {
                let mut nearest = f32::INFINITY;
                for shape in self.bvh.nearest_traverse_iterator(&line.ray, &self.shapes) {
                    let entry = line.ray.intersection_slice_for_aabb(&shape.aabb());
                    if entry.is_some_and(|(entry, _)| entry > nearest) {
                        break;
                    }
                    nearest = add(shape, nearest);
                }
            }
            Order::All => {
                let mut nearest = f32::INFINITY;
                for shape in self.bvh.traverse_iterator(&line.ray, &self.shapes) {
                    nearest = add(shape, nearest);
                }
            }
            Order::Pruned => {
                let query = Pruned {
                    ray: &line.ray,
                    nearest: Cell::new(f32::INFINITY),
                };
                for shape in self.bvh.traverse_iterator(&query, &self.shapes) {
                    query.nearest.set(add(shape, query.nearest.get()));
                }
            }
        }
        best
    }

    fn any_hit(&self, ray: &Ray) -> bool {
        let (ray, _) = from_start(ray);
        let line = Line::new(&ray);
        let mut shapes = self.bvh.traverse_iterator(&line.ray, &self.shapes);
        shapes.any(|shape| {
            let distance = line.distance(shape);
            distance < f32::INFINITY && line.t(distance) <= ray.t_max
        })
    }
}

/// A ray, and the t of its best hit.
struct Pruned<'a> {
    ray: &'a PeerRay<f32, 3>,
    nearest: Cell<f32>,
}

impl IntersectsAabb<f32, 3> for Pruned<'_> {
    fn intersects_aabb(&self, aabb: &Aabb<f32, 3>) -> bool {
        let entry = self.ray.intersection_slice_for_aabb(aabb);
        entry.is_some_and(|(entry, _)| entry <= self.nearest.get())
    }
}

/// A ray in the crate's form, with a direction of length 1.
struct Line {
    ray: PeerRay<f32, 3>,
    /// The length of the given direction.
    length: f32,
}

impl Line {
    fn new(ray: &Ray) -> Self {
        Self {
            ray: PeerRay::new(Point3::from(ray.origin), Vector3::from(ray.direction)),
            length: length(Vec3::from_array(ray.direction)),
        }
    }

    /// Infinite for a miss.
    fn distance(&self, shape: &Shape) -> f32 {
        let [a, b, c] = &shape.corners;
        let front = self.ray.intersects_triangle(a, b, c).distance;
        front.min(self.ray.intersects_triangle(a, c, b).distance)
    }

    fn t(&self, distance: f32) -> f32 {
        distance / self.length
    }
}

impl Tracer for Binned {
    fn name(&self) -> &'static str {
        self.name
    }

    fn build(&mut self) -> Result<Stages> {
        self.bvh = Bvh::build_par(&mut self.shapes);
        Ok(Stages::default())
    }

    fn forget(&mut self) {
        self.bvh = Bvh { nodes: Vec::new() };
    }

    fn closest_hits(&self, rays: &[Ray], answers: &mut [Answer]) {
        answer_all(rays, answers, |ray| self.closest_hit(ray));
    }

    fn any_hits(&self, rays: &[Ray], answers: &mut [bool]) {
        answer_all(rays, answers, |ray| self.any_hit(ray));
    }

    fn bytes(&self) -> Bytes {
        let nodes = self.bvh.nodes.len() * size_of::<BvhNode<f32, 3>>();
        Bytes {
            nodes: Some(nodes),
            all: Some(nodes + size_of_val(self.shapes.as_slice())),
        }
    }
}
