//! Pieces that hang together by edges.

use super::Component;
use super::buckets::Buckets;
use super::union_find::UnionFind;
use crate::Mesh;
use glam::Vec3;
use slimbvh_core::Aabb;

/// The connected components, largest first. `triangles` are those of the mesh over welded vertices.
pub(super) fn components(mesh: &Mesh, triangles: &[[u32; 3]]) -> Vec<Component> {
    let edges = Edges::new(triangles, mesh.vertices.len());
    let labels = label_triangles(&edges, triangles);
    let mut components = measure(mesh, &labels);
    edges.for_each(|sides| {
        let component = &mut components[labels[sides[0].triangle() as usize] as usize];
        let forward = sides.iter().filter(|side| side.is_forward()).count();
        let excess = forward.abs_diff(sides.len() - forward);
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

/// One side of one triangle, along an edge: `larger vertex (32 bits) | triangle (31) | forward (1)`. Forward leads from
/// the smaller vertex to the larger.
#[derive(Clone, Copy)]
struct Side(u64);

impl Side {
    fn new(larger: u32, triangle: u32, forward: bool) -> Self {
        Self(u64::from(larger) << 32 | u64::from(triangle) << 1 | u64::from(forward))
    }

    fn larger_vertex(self) -> u32 {
        (self.0 >> 32) as u32
    }

    fn triangle(self) -> u32 {
        self.0 as u32 >> 1
    }

    fn is_forward(self) -> bool {
        self.0 & 1 == 1
    }
}

/// The sides of all triangles, in buckets by the smaller vertex.
struct Edges(Buckets);

impl Edges {
    fn new(triangles: &[[u32; 3]], vertex_count: usize) -> Self {
        let sides = (0_u32..).zip(triangles).flat_map(|(number, &[a, b, c])| {
            [(a, b), (b, c), (c, a)]
                .into_iter()
                // A side from a vertex to itself is its own reverse.
                .filter(|(from, to)| from != to)
                .map(move |(from, to)| {
                    let side = Side::new(from.max(to), number, from < to);
                    (from.min(to), side.0)
                })
        });
        Self(Buckets::new(vertex_count, sides))
    }

    /// Shows the sides along each undirected edge, ordered by triangle.
    fn for_each(&self, mut visit: impl FnMut(&[Side])) {
        let mut sides = Vec::new();
        for (_, bucket) in self.0.iter() {
            for run in bucket.chunk_by(|&a, &b| Side(a).larger_vertex() == Side(b).larger_vertex())
            {
                sides.clear();
                sides.extend(run.iter().map(|&side| Side(side)));
                visit(&sides);
            }
        }
    }
}

/// The label of a triangle that welding makes a point: it has no edge and belongs to no component.
const NONE: u32 = u32::MAX;

/// The component of each triangle, numbered by their first triangles.
fn label_triangles(edges: &Edges, triangles: &[[u32; 3]]) -> Vec<u32> {
    let mut sets = UnionFind::new(triangles.len());
    edges.for_each(|sides| {
        for pair in sides.windows(2) {
            sets.join(pair[0].triangle(), pair[1].triangle());
        }
    });
    let mut labels = Vec::with_capacity(triangles.len());
    let mut count = 0;
    for (number, &[a, b, c]) in (0_u32..).zip(triangles) {
        let first = sets.find(number);
        labels.push(if a == b && b == c {
            NONE
        } else if first == number {
            count += 1;
            count - 1
        } else {
            labels[first as usize]
        });
    }
    labels
}

/// Size, bounds and volume of each component, all taken to be closed.
fn measure(mesh: &Mesh, labels: &[u32]) -> Vec<Component> {
    let faces = || {
        let labelled = mesh.indices.iter().zip(labels);
        labelled
            .filter(|(_, label)| **label != NONE)
            .map(|(indices, &label)| {
                let corners = indices.map(|vertex| mesh.vertices[vertex as usize]);
                (corners, label as usize)
            })
    };

    // Bounds first: volumes are taken from the middle.
    let mut components: Vec<Component> = Vec::new();
    for (corners, label) in faces() {
        if label == components.len() {
            components.push(Component {
                triangle_count: 0,
                closed: true,
                consistently_wound: true,
                outward: None,
                signed_volume: 0.0,
                bounds: Aabb::EMPTY,
            });
        }
        components[label].triangle_count += 1;
        let bounds = &mut components[label].bounds;
        *bounds = corners
            .map(Vec3::from_array)
            .into_iter()
            .fold(*bounds, Aabb::union_point);
    }

    // Sum up the tetrahedra between the middle and each triangle.
    let mut magnitudes = vec![0.0; components.len()];
    for (corners, label) in faces() {
        let center = middle(&components[label].bounds);
        let [a, b, c] = corners.map(|p| [0, 1, 2].map(|axis| f64::from(p[axis]) - center[axis]));
        let (volume, magnitude) = tetrahedron(a, b, c);
        components[label].signed_volume += volume;
        magnitudes[label] += magnitude;
    }

    for (component, magnitude) in components.iter_mut().zip(magnitudes) {
        // A term has fewer than 10 roundings of half an epsilon, and the sum one more for each triangle.
        let error = (component.triangle_count + 10) as f64 * f64::EPSILON * magnitude;
        if component.signed_volume.abs() > error {
            component.outward = Some(component.signed_volume > 0.0);
        }
    }
    components
}

/// The signed volume of a triangle's tetrahedron with the origin, and the same with all terms made positive, which
/// bounds its rounding errors.
fn tetrahedron(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> (f64, f64) {
    let (mut volume, mut magnitude) = (0.0, 0.0);
    for (x, y, z) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
        let (positive, negative) = (b[y] * c[z], b[z] * c[y]);
        volume += a[x] * (positive - negative);
        magnitude += a[x].abs() * (positive.abs() + negative.abs());
    }
    (volume / 6.0, magnitude / 6.0)
}

/// The point in the middle of a box, which may span all of `f32`.
fn middle(bounds: &Aabb) -> [f64; 3] {
    [0, 1, 2].map(|axis| 0.5 * (f64::from(bounds.min[axis]) + f64::from(bounds.max[axis])))
}
