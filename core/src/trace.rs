//! Stage `trace`: one traversal for all trees, codecs and queries.

use crate::build::node::NodeRef;
use crate::geometry::planes::PlanePair;
use crate::geometry::ray::{Hit, PreparedRay, Ray};
use query::{Query, Single};

mod based;
#[cfg(not(target_arch = "spirv"))]
mod bundle;
mod collect;
mod filter;
#[cfg(not(target_arch = "spirv"))]
mod interval;
mod lane_stack;
#[cfg(not(target_arch = "spirv"))]
mod packet;
#[cfg(not(target_arch = "spirv"))]
mod prepare;
mod query;
mod rows;
mod sources;
mod stack;
mod wide;
mod wide_rows;
mod wide_stack;

pub use based::Based;
#[cfg(not(target_arch = "spirv"))]
pub use bundle::{Bundle, BundleStack, PACKETS, trace_bundle};
pub use collect::{AnyHit, ClosestHit, ClosestOrAny, Collector, Counted, FINAL, NearestHits, UpTo};
#[cfg(not(target_arch = "spirv"))]
pub use filter::EndsAnd;
pub use filter::{EndsFilter, EndsSource, HitFilter, PreparedEnds, Skip};
pub use lane_stack::{LANE_BOX_ROWS, LANE_ROWS, LaneBoxStack, LaneBoxWords, LaneStack, LaneWords};
#[cfg(not(target_arch = "spirv"))]
pub use packet::{Lane, PacketStacks, trace_alone, trace_packet};
#[cfg(not(target_arch = "spirv"))]
pub use prepare::PreparedRays;
pub use query::Distance;
pub(crate) use rows::in_order;
pub use rows::{NodeRow, NodeRows, TrianglePair, TriangleRows};
pub use sources::{BruteForce, LeafTriangles, PlainNodes};
pub use stack::{
    BoxColumns, BoxCursor, Column, Cursor, Empty, Enter, Rows, STACK_SIZE, Stack, Waiting,
};
pub use wide::{MOST_WIDE_NODES, WideFork, WideRef, child_count};
pub use wide_rows::{FullWideNodes, FullWideRow};
pub use wide_stack::{LaneListStack, LaneRows, ListStack, OwnRows, WideStack, WordRows};

/// Where the traversal finds nodes.
pub trait NodeSource {
    /// A node that is walked to: its reference, and the decoded box where decoding its children needs that.
    type Cursor: Copy;

    /// An inner node, opened: with two children or up to four.
    type Node: Fork<Cursor = Self::Cursor>;

    /// A leaf's decoded box, where triangles are decoded relative to it; else `()`.
    type Bounds: Copy;

    /// A leaf without triangles; where there are no nodes, anything.
    const NOTHING: Self::Cursor;

    /// Whether rays are tested against [`Self::root_planes`] before they walk: where the root's children's boxes may reach beyond
    /// it.
    const TESTS_ROOT: bool = false;

    /// Where to begin, for a ray whose axes are in this order.
    fn root(&self, axes: [u32; 3]) -> Self::Cursor;

    /// The planes of the root's exact box, twice.
    #[inline(always)]
    fn root_planes(&self, _axes: [u32; 3]) -> [PlanePair; 3] {
        [PlanePair::ZERO; 3]
    }

    /// Whether a cursor stands for a leaf.
    fn is_leaf(&self, cursor: Self::Cursor) -> bool;

    /// A leaf's triangles.
    fn leaf(&self, cursor: Self::Cursor, axes: [u32; 3]) -> LeafRun<Self::Bounds>;

    /// An inner node's children.
    fn children(&self, cursor: Self::Cursor, order: Order) -> Self::Node;

    /// The node that has waited.
    fn resume(&self, waited: <Self::Node as Fork>::Waiting) -> Self::Cursor;

    /// More than there are inner nodes: no traversal opens more nodes than this, whatever the source holds.
    fn step_limit(&self) -> u32;
}

/// In which order rays look at coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Order {
    /// Which of x, y, z comes first, second and last.
    pub axes: [u32; 3],
    /// For each of these axes 1 where a wide node's upper planes are asked for before its lower ones, else 0.
    pub reversed: [u32; 3],
}

impl Order {
    /// These axes, lower planes first.
    #[inline(always)]
    #[must_use]
    pub const fn of(axes: [u32; 3]) -> Self {
        Self {
            axes,
            reversed: [0; 3],
        }
    }
}

/// An inner node, opened.
pub trait Fork: Copy {
    /// A child that is walked to ([`NodeSource::Cursor`]).
    type Cursor: Copy;

    /// What stands for a child that waits.
    type Waiting: Copy;

    /// A stack of the walk's own for such nodes.
    type Stack<E: Enter>: Waiting<Self, Enter = E> + Empty;

    /// A stack for a GPU's thread in its private memory, which should be small.
    type PrivateStack: Waiting<Self, Enter: Distance> + Empty;

    /// How many children there are.
    fn child_count(&self) -> u32;
}

/// A leaf's triangles.
#[derive(Clone, Copy, Debug)]
pub struct LeafRun<B> {
    /// Where its triangles begin.
    pub first: u32,
    /// The number of its triangles.
    pub count: u32,
    /// The leaf's decoded box, which codecs decode triangles relative to.
    pub bounds: B,
}

impl<B: Copy> LeafRun<B> {
    /// What a reference to a leaf stands for, and its decoded box.
    #[inline(always)]
    #[must_use]
    pub const fn of(node: NodeRef, bounds: B) -> Self {
        Self {
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
    /// How many there are.
    pub count: u32,
    /// The leaf's decoded box, which codecs decode triangles relative to.
    pub bounds: B,
}

/// An inner node with two children, opened.
#[derive(Clone, Copy)]
pub struct Children<C> {
    /// Both children's planes, left child first, in the order of the ray's axes.
    pub planes: [PlanePair; 3],
    /// The children.
    pub left: C,
    /// The children.
    pub right: C,
}

impl<C: Cursor> Fork for Children<C> {
    type Cursor = C;
    type Waiting = C;
    type Stack<E: Enter> = Stack<C, E>;
    type PrivateStack = Stack<C>;

    #[inline(always)]
    fn child_count(&self) -> u32 {
        2
    }
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
    let mut stack = <<N::Node as Fork>::Stack<f32> as Empty>::EMPTY;
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
    S: Waiting<N::Node, Enter: Distance>,
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
/// The walk skips a node only if all rays miss its box or enter it beyond their collectors' limits. How many children nodes have
/// is a matter of the source ([`NodeSource::Node`]) and of the stack ([`Waiting::go`]).
///
/// The inner loop opens nodes only, so that lanes of a GPU do the same for as long as possible, and what the leaves' hits need is
/// not carried through it (Aila and Laine 2009, "Understanding the Efficiency of Ray Traversal on GPUs", while-while).
#[inline(always)]
fn walk<N, T, Q, S>(stack: &mut S, nodes: &N, triangles: &T, mut query: Q) -> bool
where
    N: NodeSource,
    T: TriangleSource<N::Bounds>,
    S: Waiting<N::Node>,
    Q: Query<N, T, S::Enter>,
{
    let mut steps = nodes.step_limit();
    let mut waiting = if query.begin() { 0 } else { DONE };
    // Masked once here, so that no source has to check them at each node.
    let [a, b, c] = query.axes();
    let axes = [a & 3, b & 3, c & 3];
    let order = Order {
        axes,
        reversed: query.reversed(),
    };
    let mut cursor = nodes.root(axes);
    if N::TESTS_ROOT {
        let root = query.open(nodes.root_planes(axes));
        query.follow(root.enter_left);
        if !root.meets_left {
            waiting = DONE;
        }
    }

    while waiting <= S::ROWS {
        while (waiting <= S::ROWS) & !nodes.is_leaf(cursor) {
            let node = nodes.children(cursor, order);
            query.count_node(node.child_count());
            cursor = stack.go(node, nodes, &mut query, &mut waiting);
            steps = steps.wrapping_sub(1);
            if steps == 0 {
                waiting = DONE;
            }
        }
        if waiting <= S::ROWS {
            let run = nodes.leaf(cursor, axes);
            for number in 0..run.count {
                let slot = LeafSlot {
                    first: run.first,
                    number,
                    count: run.count,
                    bounds: run.bounds,
                };
                query.test(triangles, &slot);
            }
            cursor = stack.take(nodes, &mut query, &mut waiting);
            if query.is_done() {
                waiting = DONE;
            }
        }
    }
    waiting == DONE
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
pub fn nearest_hits<const K: usize, N: NodeSource, T: TriangleSource<N::Bounds>, F: HitFilter>(
    nodes: &N,
    triangles: &T,
    ray: &Ray,
    scene_exponent: i32,
    filter: &F,
) -> [Hit; K] {
    let prepared = PreparedRay::new(ray, scene_exponent);
    let mut collector = NearestHits::<K>::new(prepared.t_max);
    traverse(nodes, triangles, &prepared, filter, &mut collector);
    for i in 0..K {
        collector.hits[i] = prepared.restore(collector.hits[i]);
    }
    collector.hits
}
