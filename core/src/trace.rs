//! Stage `trace`: one traversal for all trees, codecs and queries.

use crate::geometry::planes::PlanePair;
use crate::geometry::ray::{Hit, PreparedRay, Ray};
use query::{Query, Single};

mod collect;
mod filter;
#[cfg(not(target_arch = "spirv"))]
mod packet;
#[cfg(not(target_arch = "spirv"))]
mod prepare;
mod query;
mod sources;
mod stack;

pub use collect::{AnyHit, ClosestHit, ClosestOrAny, Collector, Counted, FINAL, NearestHits};
#[cfg(not(target_arch = "spirv"))]
pub use filter::SkipAnd;
pub use filter::{HitFilter, Skip};
#[cfg(not(target_arch = "spirv"))]
pub use packet::{Lane, PacketStacks, trace_alone, trace_packet};
#[cfg(not(target_arch = "spirv"))]
pub use prepare::PreparedRays;
pub use sources::{BruteForce, LeafTriangles, PlainNodes};
pub use stack::{BoxColumns, Column, Cursor, STACK_SIZE, Stack};

/// Where the traversal finds nodes.
pub trait NodeSource {
    /// A node on the stack: its reference, and the decoded box where decoding its children needs that.
    type Cursor: Cursor;

    /// A leaf's decoded box, where triangles are decoded relative to it; else `()`.
    type Bounds: Copy;

    /// Where to begin, for a ray whose axes are in this order.
    fn root(&self, axes: [u32; 3]) -> Self::Cursor;

    /// What a cursor stands for: a leaf and its triangles, or an inner node.
    fn leaf(&self, cursor: Self::Cursor) -> LeafRun<Self::Bounds>;

    /// An inner node's children.
    fn children(&self, cursor: Self::Cursor, axes: [u32; 3]) -> Children<Self::Cursor>;

    /// Bound on the number of nodes and leaves: no traversal takes more steps, whatever the source holds.
    fn step_limit(&self) -> u32;
}

/// What a cursor stands for.
#[derive(Clone, Copy, Debug)]
pub struct LeafRun<B> {
    /// Whether it is a leaf.
    pub is_leaf: bool,
    /// Where its triangles begin.
    pub first: u32,
    /// The number of its triangles.
    pub count: u32,
    /// The leaf's decoded box, which codecs decode triangles relative to.
    pub bounds: B,
}

/// A triangle of a leaf.
#[derive(Clone, Copy, Debug)]
pub struct LeafSlot<B> {
    /// Where its leaf's triangles begin.
    pub first: u32,
    /// Its number among them.
    pub number: u32,
    /// The leaf's decoded box, which codecs decode triangles relative to.
    pub bounds: B,
}

/// An inner node, opened.
#[derive(Clone, Copy)]
pub struct Children<C> {
    /// Both children's planes, left child first, in the order of the ray's axes.
    pub planes: [PlanePair; 3],
    /// The children.
    pub left: C,
    /// The children.
    pub right: C,
}

/// Where the traversal finds triangles, in leaves whose decoded boxes are of this type.
pub trait TriangleSource<B: Copy> {
    /// The corners of a triangle, coordinates in the order of the axes, as those of the leaf's box are.
    fn corners(&self, slot: &LeafSlot<B>, axes: [u32; 3]) -> [[f32; 3]; 3];

    /// Its index in the caller's list.
    fn primitive(&self, slot: &LeafSlot<B>) -> u32;
}

/// [`traverse_with`], with a stack of its own.
#[inline(always)]
pub fn traverse<N: NodeSource, T: TriangleSource<N::Bounds>, F: HitFilter, C: Collector>(
    nodes: &N,
    triangles: &T,
    ray: &PreparedRay,
    filter: &F,
    collector: &mut C,
) {
    let mut stack = Stack::EMPTY;
    traverse_with(&mut stack, nodes, triangles, ray, filter, collector);
}

/// Offers every triangle that the ray meets and the filter accepts to the collector.
#[inline(always)]
pub fn traverse_with<N: NodeSource, T: TriangleSource<N::Bounds>, F: HitFilter, C: Collector>(
    stack: &mut Stack<N::Cursor>,
    nodes: &N,
    triangles: &T,
    ray: &PreparedRay,
    filter: &F,
    collector: &mut C,
) {
    let query = Single {
        ray,
        filter,
        collector,
    };
    walk(stack, nodes, triangles, query);
}

/// Walks the tree from the root, near child first, and lets the query test every triangle on the way.
///
/// The walk skips a node only if all rays miss its box or enter it beyond their collectors' limits. It ends after at most as
/// many steps as a sound tree takes. The tree is binary: [`Children`], [`Query`] and the links of nodes hold two children.
#[inline(always)]
fn walk<N: NodeSource, T: TriangleSource<N::Bounds>, Q: Query<N, T>>(
    stack: &mut Stack<N::Cursor, Q::Enter>,
    nodes: &N,
    triangles: &T,
    mut query: Q,
) {
    let mut steps = nodes.step_limit();
    let mut cursor = nodes.root(query.axes());
    let mut depth = 0usize;
    let mut at_node = query.begin();

    while (at_node || depth > 0) && steps > 0 {
        if !at_node {
            // Take the nearest node that waits, unless hits have been found before it.
            depth -= 1;
            cursor = stack.cursor(depth);
            at_node = query.is_due(stack.enter(depth));
        }
        if at_node {
            steps -= 1;
            let run = nodes.leaf(cursor);
            if run.is_leaf {
                for number in 0..run.count {
                    let slot = LeafSlot {
                        first: run.first,
                        number,
                        bounds: run.bounds,
                    };
                    query.test(triangles, &slot);
                }
                at_node = false;
                if query.is_done() {
                    depth = 0;
                }
            } else {
                let node = nodes.children(cursor, query.axes());
                let opened = query.open(node.planes);
                let left_first = opened.left_first;
                if opened.meets_left && opened.meets_right {
                    let far = if left_first { node.right } else { node.left };
                    stack.put(depth, far, opened.far_enter());
                    depth += 1;
                    cursor = if left_first { node.left } else { node.right };
                    query.follow(opened.near_enter());
                } else {
                    cursor = if opened.meets_left {
                        query.follow(opened.enter_left);
                        node.left
                    } else {
                        query.follow(opened.enter_right);
                        node.right
                    };
                    at_node = opened.meets_left || opened.meets_right;
                }
            }
        }
    }
}

/// The hit with the smallest `(t, primitive)`, or [`Hit::MISS`].
#[inline]
#[must_use]
pub fn closest_hit<N: NodeSource, T: TriangleSource<N::Bounds>, F: HitFilter>(
    nodes: &N,
    triangles: &T,
    ray: &Ray,
    scene_exponent: i32,
    filter: &F,
) -> Hit {
    let prepared = PreparedRay::new(ray, scene_exponent);
    let mut collector = ClosestHit::new(prepared.t_max);
    traverse(nodes, triangles, &prepared, filter, &mut collector);
    prepared.restore(collector.hit)
}

/// Whether the ray meets anything; stops at the first.
#[doc(alias = "occluded")]
#[inline]
#[must_use]
pub fn any_hit<N: NodeSource, T: TriangleSource<N::Bounds>, F: HitFilter>(
    nodes: &N,
    triangles: &T,
    ray: &Ray,
    scene_exponent: i32,
    filter: &F,
) -> bool {
    let prepared = PreparedRay::new(ray, scene_exponent);
    let mut collector = AnyHit::new(prepared.t_max);
    traverse(nodes, triangles, &prepared, filter, &mut collector);
    collector.found
}

/// The K hits with the smallest `(t, primitive)` in order, the rest [`Hit::MISS`].
#[inline]
#[must_use]
pub fn nearest_hits<const K: usize, N: NodeSource, T: TriangleSource<N::Bounds>>(
    nodes: &N,
    triangles: &T,
    ray: &Ray,
    scene_exponent: i32,
) -> [Hit; K] {
    let prepared = PreparedRay::new(ray, scene_exponent);
    let mut collector = NearestHits::<K>::new(prepared.t_max);
    traverse(nodes, triangles, &prepared, &Skip::NONE, &mut collector);
    for i in 0..K {
        collector.hits[i] = prepared.restore(collector.hits[i]);
    }
    collector.hits
}
