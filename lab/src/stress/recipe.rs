//! Recipes of rays.

use slimbvh::{Mesh, Ray};

/// A point of a triangle.
#[derive(Clone, Copy, Debug)]
pub struct Face {
    /// The index of the triangle, modulo the number of triangles.
    pub triangle: u32,
    /// Weights of the second and third corner.
    pub weights: [f32; 2],
}

/// Where a ray starts.
#[derive(Clone, Copy, Debug)]
pub enum Start {
    /// In the mesh's box, whose sides are 0 to 1, or a little outside.
    Near([f32; 3]),
    /// In this direction from the middle of the box, at this power of ten times its size.
    Far([f32; 3], i32),
    /// On a triangle.
    On(Face),
    /// At a point in the mesh's unit.
    Exactly([f32; 3]),
}

/// Where a ray goes.
#[derive(Clone, Copy, Debug)]
pub enum Aim {
    /// In this direction.
    Direction([f32; 3]),
    /// Along an axis. The flags are the signs of the components, zeros included.
    Axis(usize, [bool; 3]),
    /// At a point of a triangle.
    At(Face),
    /// In the plane of a triangle, at this angle from its first edge. The ray starts in the plane.
    InPlane(u32, f32),
    /// Through both ends of an edge. The ray starts on the line of the edge, before it.
    AlongEdge(u32, usize),
    /// Parallel to an edge. The ray starts before the edge, and this far from its line in units of the mesh's size.
    BesideEdge(u32, usize, [f32; 3]),
}

/// The range of a ray, in units of the direction before scaling: 1 is where the ray aims.
#[derive(Clone, Copy, Debug)]
pub enum Range {
    /// From 0 to `f32::MAX`.
    Whole,
    /// From 0 to infinity.
    Infinite,
    /// From the first to the second.
    Between(f32, f32),
}

/// A ray that starts at, aims at or lies in a triangle of any mesh.
#[derive(Clone, Copy, Debug)]
pub struct RayRecipe {
    /// Where the ray starts.
    pub start: Start,
    /// Where the ray goes.
    pub aim: Aim,
    /// The exponent of the power of two that scales the direction.
    pub length: i32,
    /// The range of the ray.
    pub range: Range,
}

type Point = [f64; 3];

impl RayRecipe {
    /// The ray for a mesh. A mesh without triangles counts as the unit cube.
    #[must_use]
    pub fn cook(&self, mesh: &Mesh) -> Ray {
        let (low, size) = extent(mesh);
        let middle = add(low, size, 0.5);
        let largest = size.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let mut origin = match self.start {
            Start::Near(p) => [0, 1, 2].map(|axis| low[axis] + size[axis] * f64::from(p[axis])),
            Start::Far(direction, e) => {
                add(middle, direction.map(f64::from), largest * 10f64.powi(e))
            }
            Start::On(face) => point_of(mesh, face),
            Start::Exactly(point) => point.map(f64::from),
        };
        let mut signed_zeros = None;
        let direction = match self.aim {
            Aim::Direction(d) => d.map(|x| f64::from(x) * largest),
            Aim::Axis(axis, negative) => {
                let mut d = negative.map(|negative| if negative { -0.0 } else { 0.0 });
                d[axis] = if negative[axis] { -largest } else { largest };
                signed_zeros = Some(d);
                d
            }
            Aim::At(face) => sub(point_of(mesh, face), rounded(origin)),
            Aim::InPlane(triangle, angle) => {
                let [a, b, c] = corners(mesh, triangle);
                let (e1, e2) = (sub(b, a), sub(c, a));
                let (sin, cos) = f64::from(angle).sin_cos();
                let d = [0, 1, 2].map(|axis| cos * e1[axis] + sin * e2[axis]);
                origin = add(add(a, e1, 0.3), d, -1.0);
                d
            }
            Aim::AlongEdge(triangle, edge) => {
                let corners = corners(mesh, triangle);
                let d = sub(corners[(edge + 1) % 3], corners[edge]);
                origin = add(corners[edge], d, -1.0);
                d
            }
            Aim::BesideEdge(triangle, edge, offset) => {
                let corners = corners(mesh, triangle);
                let d = sub(corners[(edge + 1) % 3], corners[edge]);
                let before = add(corners[edge], d, -1.0);
                origin = add(before, offset.map(f64::from), largest);
                d
            }
        };
        let scaled = direction.map(|x| (x * 2f64.powi(self.length)) as f32);
        let direction = signed_zeros.map_or(scaled, |zeros| {
            // Restore the signs of zeros.
            [0, 1, 2].map(|axis| scaled[axis].copysign(zeros[axis] as f32))
        });
        let t = |t: f32| (f64::from(t) * 2f64.powi(-self.length)) as f32;
        let (t_min, t_max) = match self.range {
            Range::Whole => (0.0, f32::MAX),
            Range::Infinite => (0.0, f32::INFINITY),
            Range::Between(a, b) => (t(a), t(b)),
        };
        Ray {
            origin: origin.map(finite),
            t_min,
            direction: direction.map(|x| finite(f64::from(x))),
            t_max,
        }
    }
}

/// The nearest finite `f32`.
fn finite(x: f64) -> f32 {
    x.clamp(f64::from(f32::MIN), f64::from(f32::MAX)) as f32
}

/// The point as the ray stores it, where the direction starts.
fn rounded(p: Point) -> Point {
    p.map(|x| f64::from(finite(x)))
}

fn add(p: Point, q: Point, factor: f64) -> Point {
    [0, 1, 2].map(|axis| p[axis] + factor * q[axis])
}

fn sub(p: Point, q: Point) -> Point {
    add(p, q, -1.0)
}

fn corners(mesh: &Mesh, triangle: u32) -> [Point; 3] {
    if mesh.indices.is_empty() {
        return [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    }
    let face = mesh.indices[triangle as usize % mesh.indices.len()];
    face.map(|v| mesh.vertices[v as usize].map(f64::from))
}

fn point_of(mesh: &Mesh, face: Face) -> Point {
    let [a, b, c] = corners(mesh, face.triangle);
    let [u, v] = face.weights.map(f64::from);
    [0, 1, 2].map(|axis| (1.0 - u - v) * a[axis] + u * b[axis] + v * c[axis])
}

/// The minimum corner and the size of the mesh's box.
fn extent(mesh: &Mesh) -> (Point, Point) {
    let mut low = [f64::MAX; 3];
    let mut high = [-f64::MAX; 3];
    for &vertex in mesh.indices.iter().flatten() {
        for (axis, &x) in mesh.vertices[vertex as usize].iter().enumerate() {
            low[axis] = low[axis].min(f64::from(x));
            high[axis] = high[axis].max(f64::from(x));
        }
    }
    if mesh.indices.is_empty() {
        return ([0.0; 3], [1.0; 3]);
    }
    (low, sub(high, low))
}
