//! Splitting triangles at the midpoints of their sides.

use std::collections::HashMap;

/// Every triangle split into four, with one new vertex an edge.
pub(super) struct Split {
    /// New vertex `vertex_count + i` belongs between the two vertices of `edges[i]`.
    pub(super) edges: Vec<[u32; 2]>,
    /// Triangle `t` becomes `4 * t..4 * t + 4`, wound as before.
    pub(super) indices: Vec<[u32; 3]>,
}

/// Splits triangles over `vertex_count` vertices. Triangles that share two vertices share the new one.
pub(super) fn split(indices: &[[u32; 3]], vertex_count: usize) -> Split {
    let mut edges = Vec::with_capacity(indices.len() * 3 / 2);
    let mut known = HashMap::with_capacity(indices.len() * 3 / 2);
    let mut middle = |a: u32, b: u32| {
        let edge = [a.min(b), a.max(b)];
        *known.entry(edge).or_insert_with(|| {
            edges.push(edge);
            (vertex_count + edges.len() - 1) as u32
        })
    };
    let mut split = Vec::with_capacity(indices.len() * 4);
    for &[a, b, c] in indices {
        let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
        split.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
    }
    Split {
        edges,
        indices: split,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_share_the_new_vertex() {
        let split = split(&[[0, 1, 2], [2, 1, 3]], 4);
        assert_eq!(split.edges, [[0, 1], [1, 2], [0, 2], [1, 3], [2, 3]]);
        let first = [[0, 4, 6], [4, 1, 5], [6, 5, 2], [4, 5, 6]];
        assert_eq!(split.indices[..4], first);
        assert_eq!(split.indices[4], [2, 5, 8]);
    }
}
