//! Stage `trace`: one traversal for all trees, codecs and queries.

use crate::build::node::NodeRef;
use crate::geometry::planes::PlanePair;
use crate::geometry::ray::{Hit, PreparedRay, Ray};
use query::{Query, Single};

mod collect;
mod filter;
mod lane_stack;
#[cfg(not(target_arch = "spirv"))]
mod packet;
#[cfg(not(target_arch = "spirv"))]
mod prepare;
mod query;
mod rows;
mod sources;
mod stack;

pub use collect::{AnyHit, ClosestHit, ClosestOrAny, Collector, Counted, FINAL, NearestHits, UpTo};
#[cfg(not(target_arch = "spirv"))]
pub use filter::SkipAnd;
pub use filter::{HitFilter, Skip};
pub use lane_stack::{LANE_BOX_ROWS, LANE_ROWS, LaneBoxStack, LaneBoxWords, LaneStack, LaneWords};
#[cfg(not(target_arch = "spirv"))]
pub use packet::{Lane, PacketStacks, trace_alone, trace_packet};
#[cfg(not(target_arch = "spirv"))]
pub use prepare::PreparedRays;
pub use query::Distance;
pub use rows::{NodeRow, NodeRows, TrianglePair, TriangleRows};
pub use sources::{BruteForce, LeafTriangles, PlainNodes};
pub use stack::{BoxColumns, BoxCursor, Column, Cursor, STACK_SIZE, Stack, Waiting};

/// Where the traversal finds nodes.
pub trait NodeSource {
    /// A node on the stack: its reference, and the decoded box where decoding its children needs that.
    type Cursor: Cursor;

    /// A leaf's decoded box, where triangles are decoded relative to it; else `()`.
    type Bounds: Copy;

    /// A leaf without triangles; where there are no nodes, anything.
    const NOTHING: Self::Cursor;

    /// Where to begin, for a ray whose axes are in this order.
    fn root(&self, axes: [u32; 3]) -> Self::Cursor;

    /// What a cursor stands for: a leaf and its triangles, or an inner node.
    fn leaf(&self, cursor: Self::Cursor) -> LeafRun<Self::Bounds>;

    /// An inner node's children.
    fn children(&self, cursor: Self::Cursor, axes: [u32; 3]) -> Children<Self::Cursor>;

    /// More than there are inner nodes: no traversal opens more nodes than this, whatever the source holds.
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

impl<B: Copy> LeafRun<B> {
    /// What a reference stands for, and its decoded box.
    #[inline(always)]
    #[must_use]
    pub const fn of(node: NodeRef, bounds: B) -> Self {
        Self {
            is_leaf: node.is_leaf(),
            first: node.first(),
            count: node.count(),
            bounds,
        }
    }
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
    let mut stack: Stack<N::Cursor> = Stack::EMPTY;
    traverse_with(&mut stack, nodes, triangles, ray, filter, collector);
}

/// Offers every triangle that the ray meets and the filter accepts to the collector. Returns whether the ray came to an end: false
/// where the stack was full ([`Waiting::ROWS`]), and the collector's answer means nothing.
#[inline(always)]
pub fn traverse_with<N, T, F, C, S>(
    stack: &mut S,
    nodes: &N,
    triangles: &T,
    ray: &PreparedRay,
    filter: &F,
    collector: &mut C,
) -> bool
where
    N: NodeSource,
    T: TriangleSource<N::Bounds>,
    F: HitFilter,
    C: Collector,
    S: Waiting<N::Cursor, Enter: Distance>,
{
    let query = Single {
        ray,
        filter,
        goes_farther_first: collector.goes_farther_first(),
        collector,
    };
    walk(stack, nodes, triangles, query)
}

/// What stands for the number of waiting nodes when the walk is over: one less than none, and more than any stack holds.
const DONE: u32 = u32::MAX;

/// Walks the tree from the root, the child that the query wants first, and lets the query test every triangle on the way.
/// Returns whether it came to an end: false where the stack was full.
///
/// The walk skips a node only if all rays miss its box or enter it beyond their collectors' limits. The tree is binary:
/// [`Children`], [`Query`] and the links of nodes hold two children.
///
/// The inner loop opens nodes only, so that lanes of a GPU do the same for as long as possible, and what the leaves' hits need is
/// not carried through it (Aila and Laine 2009, "Understanding the Efficiency of Ray Traversal on GPUs", while-while).
#[inline(always)]
fn walk<N, T, Q, S>(stack: &mut S, nodes: &N, triangles: &T, mut query: Q) -> bool
where
    N: NodeSource,
    T: TriangleSource<N::Bounds>,
    S: Waiting<N::Cursor>,
    Q: Query<N, T, S::Enter>,
{
    let mut steps = nodes.step_limit();
    let mut waiting = if query.begin() { 0 } else { DONE };
    // Masked once here, so that no source has to check them at each node.
    let [a, b, c] = query.axes();
    let axes = [a & 3, b & 3, c & 3];
    let mut cursor = nodes.root(axes);

    while waiting <= S::ROWS {
        while (waiting <= S::ROWS) & !nodes.leaf(cursor).is_leaf {
            let node = nodes.children(cursor, axes);
            let opened = query.open(node.planes);
            if opened.meets_left | opened.meets_right {
                let goes_left = opened.meets_left & (opened.left_first | !opened.meets_right);
                cursor = if goes_left { node.left } else { node.right };
                query.follow(if goes_left {
                    opened.enter_left
                } else {
                    opened.enter_right
                });
                if opened.meets_left & opened.meets_right {
                    let (far, enter) = if goes_left {
                        (node.right, opened.enter_right)
                    } else {
                        (node.left, opened.enter_left)
                    };
                    // Beyond the last row the loops end.
                    stack.put(waiting, far, enter);
                    waiting += 1;
                }
            } else {
                waiting = waiting.wrapping_sub(1);
                cursor = take::<N, T, Q, S>(stack, waiting, &mut query);
            }
            steps = steps.wrapping_sub(1);
            if steps == 0 {
                waiting = DONE;
            }
        }
        if waiting <= S::ROWS {
            let run = nodes.leaf(cursor);
            for number in 0..run.count {
                let slot = LeafSlot {
                    first: run.first,
                    number,
                    bounds: run.bounds,
                };
                query.test(triangles, &slot);
            }
            waiting = waiting.wrapping_sub(1);
            cursor = take::<N, T, Q, S>(stack, waiting, &mut query);
            if query.is_done() {
                waiting = DONE;
            }
        }
    }
    waiting == DONE
}

/// The node that waits in a row; one that the rays enter beyond their limits is a leaf without triangles. Where no node waits,
/// what comes out means nothing: the walk is over.
#[inline(always)]
fn take<N, T, Q, S>(stack: &S, row: u32, query: &mut Q) -> N::Cursor
where
    N: NodeSource,
    T: TriangleSource<N::Bounds>,
    S: Waiting<N::Cursor>,
    Q: Query<N, T, S::Enter>,
{
    if query.is_due(stack.enter(row)) {
        stack.cursor(row)
    } else {
        N::NOTHING
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
