//! The edges of a mesh, with the triangles at each.

use super::buckets::Buckets;

/// One side of one triangle: `larger vertex (32 bits) | triangle (31) | forward (1)`. Forward means from the smaller vertex
/// to the larger.
#[derive(Clone, Copy)]
pub struct Side(u64);

impl Side {
    fn new(larger: u32, triangle: u32, forward: bool) -> Self {
        Self(u64::from(larger) << 32 | u64::from(triangle) << 1 | u64::from(forward))
    }

    fn larger_vertex(self) -> u32 {
        (self.0 >> 32) as u32
    }

    /// The triangle of the side.
    #[must_use]
    pub fn triangle(self) -> u32 {
        self.0 as u32 >> 1
    }

    /// Whether the side runs from the smaller vertex to the larger.
    #[must_use]
    pub fn is_forward(self) -> bool {
        self.0 & 1 == 1
    }

    /// The two corners of the side in its triangle, the one with the smaller vertex first. `triangle` must be the side's
    /// triangle.
    #[must_use]
    pub fn corners(self, triangle: [u32; 3]) -> [usize; 2] {
        let leads_here = |&corner: &usize| {
            let (from, to) = (triangle[corner], triangle[(corner + 1) % 3]);
            let (smaller, larger) = if self.is_forward() {
                (from, to)
            } else {
                (to, from)
            };
            larger == self.larger_vertex() && smaller < larger
        };
        let from = (0..3).find(leads_here).unwrap_or(0);
        let to = (from + 1) % 3;
        if self.is_forward() {
            [from, to]
        } else {
            [to, from]
        }
    }
}

/// The sides of all triangles, in buckets by the smaller vertex.
pub struct Edges(Buckets);

impl Edges {
    /// The edges of triangles over welded vertices, each below `vertex_count`.
    #[must_use]
    pub fn new(triangles: &[[u32; 3]], vertex_count: usize) -> Self {
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

    /// Visits the sides at each undirected edge, ordered by triangle.
    pub fn for_each(&self, mut visit: impl FnMut(&[Side])) {
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

/// How many more of these sides run one way along their edge than the other way.
#[must_use]
pub fn excess(sides: &[Side]) -> usize {
    let forward = sides.iter().filter(|side| side.is_forward()).count();
    forward.abs_diff(sides.len() - forward)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_know_their_corners() {
        let triangles = [[7, 2, 5], [5, 2, 9], [2, 2, 5]];
        let mut seen = Vec::new();
        Edges::new(&triangles, 10).for_each(|sides| {
            for side in sides {
                let triangle = triangles[side.triangle() as usize];
                let ends = side.corners(triangle).map(|corner| triangle[corner]);
                seen.push((ends, side.triangle(), side.is_forward()));
            }
            if sides.len() == 4 {
                assert_eq!(excess(sides), 0);
            }
        });
        assert_eq!(
            seen,
            [
                ([2, 5], 0, true),
                ([2, 5], 1, false),
                ([2, 5], 2, false),
                ([2, 5], 2, true),
                ([2, 7], 0, false),
                ([2, 9], 1, true),
                ([5, 7], 0, true),
                ([5, 9], 1, false),
            ]
        );
    }
}
