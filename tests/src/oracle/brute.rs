//! Brute force: core's traversal over one leaf with all triangles. Every tree must agree with it bit for bit.

use slimbvh_core::trace::{
    self, BruteForce, LeafTriangles, NodeSource, PlainNodes, Skip, TriangleSource,
};
use slimbvh_core::{Hit, LeafTriangle, Node, Ray};

/// The answers of all queries of a ray.
#[derive(Clone, Copy, Debug)]
pub struct Answers {
    /// The closest hit.
    pub closest: Hit,
    /// Whether there is any hit.
    pub any: bool,
    /// The nearest hit, as a list of one.
    pub nearest_1: [Hit; 1],
    /// The nearest four hits.
    pub nearest_4: [Hit; 4],
    /// The nearest eight hits.
    pub nearest_8: [Hit; 8],
}

impl Answers {
    /// Traces a ray through any source of nodes, with each query.
    pub fn of<N: NodeSource, T: TriangleSource<N::Bounds>>(
        nodes: &N,
        triangles: &T,
        ray: &Ray,
        scene_exponent: i32,
    ) -> Self {
        Self {
            closest: trace::closest_hit(nodes, triangles, ray, scene_exponent, &Skip::NONE),
            any: trace::any_hit(nodes, triangles, ray, scene_exponent, &Skip::NONE),
            nearest_1: trace::nearest_hits(nodes, triangles, ray, scene_exponent, &Skip::NONE),
            nearest_4: trace::nearest_hits(nodes, triangles, ray, scene_exponent, &Skip::NONE),
            nearest_8: trace::nearest_hits(nodes, triangles, ray, scene_exponent, &Skip::NONE),
        }
    }

    /// Whether all bits are equal.
    #[must_use]
    pub fn same_bits(&self, other: &Self) -> bool {
        fn bits(hits: &[Hit]) -> &[u8] {
            bytemuck::cast_slice(hits)
        }
        bits(&[self.closest]) == bits(&[other.closest])
            && self.any == other.any
            && bits(&self.nearest_1) == bits(&other.nearest_1)
            && bits(&self.nearest_4) == bits(&other.nearest_4)
            && bits(&self.nearest_8) == bits(&other.nearest_8)
    }

    /// Whether the answers agree with each other: the closest hit is first in each list, lists are sorted, and a shorter list is
    /// a prefix of a longer one.
    #[must_use]
    pub fn are_consistent(&self) -> bool {
        let sorted = self.nearest_8.windows(2).all(|pair| {
            let (a, b) = (pair[0], pair[1]);
            // Two different t may both overflow when they are scaled back to the caller's unit.
            let collapsed = !a.t.is_normal() || a.t.abs() == f32::MAX;
            let ties_in_order = a.primitive < b.primitive || collapsed;
            !b.is_hit() || a.t < b.t || (a.t == b.t && ties_in_order)
        });
        sorted
            && self.any == self.closest.is_hit()
            && self.nearest_1[0] == self.closest
            && self.nearest_4[0] == self.closest
            && self.nearest_8[..4] == self.nearest_4
    }
}

/// A ray with different answers by a tree and by brute force.
#[derive(Clone, Copy, Debug)]
pub struct Disagreement {
    /// The ray.
    pub ray: Ray,
    /// The tree's answers.
    pub tree: Answers,
    /// The answers by brute force.
    pub brute: Answers,
}

/// A tree's parts, so that faults can be planted in them.
#[derive(Clone, Copy, Debug)]
pub struct Parts<'a> {
    /// The nodes.
    pub nodes: &'a [Node],
    /// The triangles in leaf order.
    pub triangles: &'a [LeafTriangle],
    /// The scene's magnitude.
    pub scene_exponent: i32,
}

impl<'a> From<&'a slimbvh::Bvh> for Parts<'a> {
    fn from(bvh: &'a slimbvh::Bvh) -> Self {
        Self {
            nodes: bvh.nodes(),
            triangles: bvh.leaf_triangles(),
            scene_exponent: bvh.scene_exponent(),
        }
    }
}

impl Parts<'_> {
    /// The tree's answers.
    #[must_use]
    pub fn ask_tree(&self, ray: &Ray) -> Answers {
        let triangles = LeafTriangles(self.triangles);
        Answers::of(
            &PlainNodes(self.nodes),
            &triangles,
            ray,
            self.scene_exponent,
        )
    }

    /// The answers by brute force.
    #[must_use]
    pub fn ask_all(&self, ray: &Ray) -> Answers {
        let triangles = LeafTriangles(self.triangles);
        let count = self.triangles.len() as u32;
        Answers::of(&BruteForce(count), &triangles, ray, self.scene_exponent)
    }

    /// Compares the answers to some rays. Returns the number of rays that hit.
    ///
    /// # Errors
    /// The first difference, or answers that contradict each other.
    pub fn compare<'r>(
        &self,
        rays: impl IntoIterator<Item = &'r Ray>,
    ) -> Result<usize, Box<Disagreement>> {
        let mut hit_count = 0;
        for ray in rays {
            let (tree, brute) = (self.ask_tree(ray), self.ask_all(ray));
            if !tree.same_bits(&brute) || !brute.are_consistent() {
                let ray = *ray;
                return Err(Box::new(Disagreement { ray, tree, brute }));
            }
            hit_count += usize::from(brute.any);
        }
        Ok(hit_count)
    }
}
