//! The component of each triangle.

use super::edges::Edges;
use super::union_find::UnionFind;

/// The label of a triangle whose corners all weld to one vertex: it has no edge and no component.
pub(crate) const NONE: u32 = u32::MAX;

/// Components by number, in the order of their first triangles.
pub(crate) struct Labels {
    /// The component of each triangle, or [`NONE`].
    pub(crate) of: Vec<u32>,
    /// The number of components.
    pub(crate) count: u32,
}

impl Labels {
    /// Labels triangles over welded vertices by their edges. Triangles at one edge belong to one component.
    pub(crate) fn new(edges: &Edges, triangles: &[[u32; 3]]) -> Self {
        let mut sets = UnionFind::new(triangles.len());
        edges.for_each(|sides| {
            for pair in sides.windows(2) {
                sets.join(pair[0].triangle(), pair[1].triangle());
            }
        });
        let mut of = Vec::with_capacity(triangles.len());
        let mut count = 0;
        for (number, &[a, b, c]) in (0_u32..).zip(triangles) {
            let first = sets.find(number);
            of.push(if a == b && b == c {
                NONE
            } else if first == number {
                count += 1;
                count - 1
            } else {
                of[first as usize]
            });
        }
        Self { of, count }
    }
}
