//! Silhouettes, creases and other surfaces near a ray, at the scene's magnitude.

use super::distance::{between, to_triangle};
use glam::DVec3;
use slimbvh_core::orientation::Target;
use slimbvh_lab::oracle::Unculled;
use std::collections::HashMap;

/// The number of edges or triangles with a common bounding ball.
const RUN: usize = 32;

/// An edge with its triangles.
#[derive(Clone, Debug)]
struct Edge {
    ends: [DVec3; 2],
    triangles: Vec<u32>,
}

/// A ball around a run of edges or triangles.
#[derive(Clone, Copy, Debug)]
struct Ball {
    center: DVec3,
    radius: f64,
}

/// All edges and triangles of a scene, for queries of distances.
pub struct Surroundings {
    triangles: Vec<[DVec3; 3]>,
    triangle_balls: Vec<Ball>,
    edges: Vec<Edge>,
    edge_balls: Vec<Ball>,
    /// The component of each triangle: triangles connected by shared edges have one number.
    components: Vec<u32>,
}

impl Surroundings {
    pub fn new(unculled: &Unculled) -> Self {
        let count = unculled.count() as u32;
        let triangles = (0..count).map(|primitive| unculled.triangle(primitive).map(wide));
        let triangles: Vec<[DVec3; 3]> = triangles.collect();
        let mut edges: Vec<Edge> = Vec::new();
        let mut places: HashMap<[[u32; 3]; 2], usize> = HashMap::new();
        for primitive in 0..count {
            let corners = unculled.triangle(primitive);
            for i in 0..3 {
                let ends = [corners[i], corners[(i + 1) % 3]];
                let mut key = ends.map(|end| end.map(f32::to_bits));
                key.sort_unstable();
                let place = *places.entry(key).or_insert_with(|| {
                    edges.push(Edge {
                        ends: ends.map(wide),
                        triangles: Vec::new(),
                    });
                    edges.len() - 1
                });
                edges[place].triangles.push(primitive);
            }
        }
        Self {
            triangle_balls: triangles
                .chunks(RUN)
                .map(|run| ball(run.as_flattened()))
                .collect(),
            edge_balls: edges
                .chunks(RUN)
                .map(|run| ball(&run.iter().flat_map(|edge| edge.ends).collect::<Vec<_>>()))
                .collect(),
            components: components(triangles.len(), &edges),
            triangles,
            edges,
        }
    }

    /// The distance of a segment to the nearest silhouette, see [`Self::is_silhouette`].
    pub fn to_silhouette(&self, segment: [DVec3; 2], target: &Target, d: f64) -> f64 {
        self.to_edge(segment, |edge| self.is_silhouette(edge, target, d))
    }

    /// The distance of a point to the nearest crease: an edge whose triangles do not lie in one plane within `d`.
    pub fn to_crease(&self, point: DVec3, d: f64) -> f64 {
        self.to_edge([point; 2], |edge| {
            let first = self.triangles[edge.triangles[0] as usize];
            let normal = (first[1] - first[0])
                .cross(first[2] - first[0])
                .normalize_or_zero();
            let corners = edge
                .triangles
                .iter()
                .flat_map(|&other| self.triangles[other as usize]);
            corners
                .into_iter()
                .any(|corner| normal.dot(corner - first[0]).abs() > d)
        })
    }

    /// The distance of a point to the nearest triangle of another component than the given triangle's.
    pub fn to_other(&self, point: DVec3, own: Option<u32>) -> f64 {
        let component = |primitive: u32| self.components[primitive as usize];
        let own = own.map(component);
        let mut nearest = f64::INFINITY;
        for (run, ball) in self.triangle_balls.iter().enumerate() {
            if ball.center.distance(point) - ball.radius > nearest {
                continue;
            }
            let first = run * RUN;
            for (corners, primitive) in self
                .triangles
                .iter()
                .skip(first)
                .take(RUN)
                .zip(first as u32..)
            {
                if Some(component(primitive)) != own {
                    nearest = nearest.min(to_triangle(point, *corners));
                }
            }
        }
        nearest
    }

    /// The distance of a point to a triangle.
    pub fn to_primitive(&self, point: DVec3, primitive: u32) -> f64 {
        to_triangle(point, self.triangles[primitive as usize])
    }

    /// Whether two triangles share a corner.
    pub fn are_neighbors(&self, a: u32, b: u32) -> bool {
        let [a, b] = [a, b].map(|primitive| self.triangles[primitive as usize]);
        a.iter().any(|corner| b.contains(corner))
    }

    /// The ends of all edges, or of the silhouettes for a target.
    pub fn edges(&self, silhouettes: Option<(&Target, f64)>) -> Vec<[DVec3; 2]> {
        let edges = self.edges.iter().filter(|edge| {
            silhouettes.is_none_or(|(target, d)| self.is_silhouette(edge, target, d))
        });
        edges.map(|edge| edge.ends).collect()
    }

    /// Whether an edge may be a silhouette: it does not belong to two triangles, or these do not certainly both face a target or
    /// both face away. A fact is certain if it holds after moving the corners and the target by `d`.
    fn is_silhouette(&self, edge: &Edge, target: &Target, d: f64) -> bool {
        let [a, b] = edge.triangles[..] else {
            return true;
        };
        let [a, b] = [a, b].map(|primitive| self.facing(primitive, target, d));
        a == 0 || a != b
    }

    /// 1 if the front of a triangle certainly faces a target, −1 if its back does, else 0.
    fn facing(&self, primitive: u32, target: &Target, d: f64) -> i32 {
        let [a, b, c] = self.triangles[primitive as usize];
        let normal = (b - a).cross(c - a);
        let perimeter = a.distance(b) + b.distance(c) + c.distance(a);
        let point = wide(target.point);
        let (volume, doubt) = if target.is_position == 1 {
            let farthest = [a, b, c]
                .map(|corner| corner.distance(point))
                .into_iter()
                .fold(0.0, f64::max);
            (
                normal.dot(point - a),
                d * (normal.length() + perimeter * farthest),
            )
        } else {
            (normal.dot(point), d * perimeter * point.length())
        };
        i32::from(volume > doubt) - i32::from(volume < -doubt)
    }

    fn to_edge(&self, segment: [DVec3; 2], counts: impl Fn(&Edge) -> bool) -> f64 {
        let mut nearest = f64::INFINITY;
        for (run, ball) in self.edge_balls.iter().enumerate() {
            if between(segment, [ball.center; 2]) - ball.radius > nearest {
                continue;
            }
            for edge in self.edges.iter().skip(run * RUN).take(RUN) {
                let distance = between(segment, edge.ends);
                if distance < nearest && counts(edge) {
                    nearest = distance;
                }
            }
        }
        nearest
    }
}

pub fn wide(p: [f32; 3]) -> DVec3 {
    DVec3::from_array(p.map(f64::from))
}

/// A ball that holds all points, slightly enlarged.
fn ball(points: &[DVec3]) -> Ball {
    let least = points.iter().fold(DVec3::INFINITY, |a, &b| a.min(b));
    let largest = points.iter().fold(DVec3::NEG_INFINITY, |a, &b| a.max(b));
    let center = 0.5 * (least + largest);
    let radius = points
        .iter()
        .map(|point| point.distance(center))
        .fold(0.0, f64::max);
    Ball {
        center,
        radius: radius * (1.0 + 1e-9) + 1e-12,
    }
}

fn components(count: usize, edges: &[Edge]) -> Vec<u32> {
    let mut parents: Vec<u32> = (0..count as u32).collect();
    for edge in edges {
        for pair in edge.triangles.windows(2) {
            let [a, b] = [root(&mut parents, pair[0]), root(&mut parents, pair[1])];
            parents[a as usize] = b;
        }
    }
    (0..count as u32)
        .map(|primitive| root(&mut parents, primitive))
        .collect()
}

fn root(parents: &mut [u32], mut primitive: u32) -> u32 {
    while parents[primitive as usize] != primitive {
        let parent = parents[primitive as usize];
        parents[primitive as usize] = parents[parent as usize];
        primitive = parent;
    }
    primitive
}
