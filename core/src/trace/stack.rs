//! Nodes that wait in a traversal.

use super::query::Rays;
use super::{Children, Fork, NodeSource};
use crate::build::node::NodeRef;
use crate::build::topology::depth_bound;
use glam::Vec4;

/// The stack holds one entry a level below the root. Trees of 63-bit codes have at most 63 + 28 levels
/// ([`crate::build::topology::depth_bound`]), trees of 30-bit codes 30 + 28, clustered ones 126 ([`crate::build::cluster::depth_bound`]).
pub const STACK_SIZE: usize = 128;
const _: () = assert!(STACK_SIZE as u32 > depth_bound(63, crate::MAX_TRIANGLES));
const _: () = assert!(STACK_SIZE as u32 > crate::build::cluster::depth_bound(crate::MAX_TRIANGLES));

/// Memory for the nodes that wait in a traversal: an array of its own ([`Stack`], [`super::WideStack`]), or a lane's rows of an
/// array that a workgroup shares ([`super::LaneStack`], [`super::LaneBoxStack`], [`super::LaneListStack`]).
///
/// `F` is what nodes are once they are opened.
pub trait Waiting<F: Fork> {
    /// Where the rays enter a node, or `()` where that is not kept: then every node that waits is walked to.
    type Enter: Enter;

    /// How many rows there are. A walk that needs more ends without an answer.
    const ROWS: u32;

    /// Lets the rays test the children of a node. Returns the child to walk to; the others that are met wait. Where none is met,
    /// [`Self::take`].
    fn go<N: NodeSource<Node = F, Cursor = F::Cursor>, R: Rays<Self::Enter>>(
        &mut self,
        node: F,
        nodes: &N,
        rays: &mut R,
        waiting: &mut u32,
    ) -> F::Cursor;

    /// The node that waits last; one that the rays enter beyond their limits is a leaf without triangles. Where none waits,
    /// `waiting` becomes `u32::MAX`, and what comes out means nothing.
    fn take<N: NodeSource<Node = F, Cursor = F::Cursor>, R: Rays<Self::Enter>>(
        &mut self,
        nodes: &N,
        rays: &mut R,
        waiting: &mut u32,
    ) -> F::Cursor;
}

/// Rows of nodes that wait.
pub trait Rows<C> {
    /// Where the rays enter a node, or `()` where that is not kept.
    type Enter: Enter;

    /// How many nodes may wait.
    const ROWS: u32;

    /// Lets a node wait in a row. A row beyond the last overwrites another: the walk then ends without an answer.
    fn put(&mut self, row: u32, cursor: C, enter: Self::Enter);

    /// The node that waits in a row.
    fn cursor(&self, row: u32) -> C;

    /// Where the rays enter the node that waits in a row.
    fn enter(&self, row: u32) -> Self::Enter;
}

impl<C: Cursor, S: Rows<C>> Waiting<Children<C>> for S {
    type Enter = S::Enter;

    const ROWS: u32 = S::ROWS;

    #[inline(always)]
    fn go<N: NodeSource<Node = Children<C>, Cursor = C>, R: Rays<S::Enter>>(
        &mut self,
        node: Children<C>,
        nodes: &N,
        rays: &mut R,
        waiting: &mut u32,
    ) -> C {
        let opened = rays.open(node.planes);
        if opened.meets_left | opened.meets_right {
            let goes_left = opened.meets_left & (opened.left_first | !opened.meets_right);
            let cursor = if goes_left { node.left } else { node.right };
            rays.follow(if goes_left {
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
                self.put(*waiting, far, enter);
                *waiting += 1;
            }
            cursor
        } else {
            self.take(nodes, rays, waiting)
        }
    }

    #[inline(always)]
    fn take<N: NodeSource<Node = Children<C>, Cursor = C>, R: Rays<S::Enter>>(
        &mut self,
        nodes: &N,
        rays: &mut R,
        waiting: &mut u32,
    ) -> C {
        *waiting = waiting.wrapping_sub(1);
        if rays.is_due(self.enter(*waiting)) {
            nodes.resume(self.cursor(*waiting))
        } else {
            N::NOTHING
        }
    }
}

/// A number of each entry of the stack.
pub type Column<T> = [T; STACK_SIZE];

/// What names a node on the stack, with all that decoding it needs.
///
/// Entries are kept in columns, a number each: drivers whose compilers are LLVM take time with the square of a private array's
/// size. With entries of a node and its box in one array, Mesa's lavapipe took 20 seconds a kernel.
pub trait Cursor: Copy {
    /// All entries.
    type Columns: Copy;

    /// All bits zero, so that one constant does it.
    const EMPTY: Self::Columns;

    /// Puts an entry in place.
    fn put(self, columns: &mut Self::Columns, place: usize);

    /// What was put there.
    fn at(columns: &Self::Columns, place: usize) -> Self;
}

impl Cursor for NodeRef {
    type Columns = Column<Self>;
    const EMPTY: Column<Self> = [Self::inner(0); STACK_SIZE];

    #[inline(always)]
    fn put(self, columns: &mut Column<Self>, place: usize) {
        columns[place % STACK_SIZE] = self;
    }

    #[inline(always)]
    fn at(columns: &Column<Self>, place: usize) -> Self {
        columns[place % STACK_SIZE]
    }
}

impl Cursor for () {
    type Columns = ();
    const EMPTY: () = ();

    #[inline(always)]
    fn put(self, (): &mut (), _: usize) {}

    #[inline(always)]
    fn at((): &(), _: usize) {}
}

/// A node on the stack whose children are decoded from its box.
pub trait BoxCursor: Copy {
    /// A node and its box, coordinates in the order of the ray's axes.
    fn new(node: NodeRef, min: [f32; 3], max: [f32; 3]) -> Self;

    /// The node.
    fn node(&self) -> NodeRef;

    /// Its box's smallest and largest coordinates.
    fn corners(&self) -> [[f32; 3]; 2];
}

/// Columns of a node and its box.
#[derive(Clone, Copy, Debug)]
pub struct BoxColumns {
    node: Column<NodeRef>,
    min_a: Column<f32>,
    min_b: Column<f32>,
    min_c: Column<f32>,
    max_a: Column<f32>,
    max_b: Column<f32>,
    max_c: Column<f32>,
}

impl<C: BoxCursor> Cursor for C {
    type Columns = BoxColumns;
    const EMPTY: BoxColumns = BoxColumns {
        node: NodeRef::EMPTY,
        min_a: [0.0; STACK_SIZE],
        min_b: [0.0; STACK_SIZE],
        min_c: [0.0; STACK_SIZE],
        max_a: [0.0; STACK_SIZE],
        max_b: [0.0; STACK_SIZE],
        max_c: [0.0; STACK_SIZE],
    };

    #[inline(always)]
    fn put(self, columns: &mut BoxColumns, place: usize) {
        let place = place % STACK_SIZE;
        let [min, max] = self.corners();
        columns.node[place] = self.node();
        columns.min_a[place] = min[0];
        columns.min_b[place] = min[1];
        columns.min_c[place] = min[2];
        columns.max_a[place] = max[0];
        columns.max_b[place] = max[1];
        columns.max_c[place] = max[2];
    }

    #[inline(always)]
    fn at(columns: &BoxColumns, place: usize) -> Self {
        let place = place % STACK_SIZE;
        let BoxColumns {
            min_a,
            min_b,
            min_c,
            max_a,
            max_b,
            max_c,
            ..
        } = columns;
        Self::new(
            columns.node[place],
            [min_a[place], min_b[place], min_c[place]],
            [max_a[place], max_b[place], max_c[place]],
        )
    }
}

/// Where the rays of a traversal enter a node: one number, or one a ray; or `()` where that is not kept.
pub trait Enter: Copy {
    /// All bits zero.
    const ZERO: Self;

    /// Where they enter the children of a wide node, by their numbers.
    type Four: Copy;

    /// All bits zero.
    const FOUR: Self::Four;

    /// Where they enter one of four children.
    fn of(four: &Self::Four, child: u32) -> Self;
}

impl Enter for f32 {
    const ZERO: Self = 0.0;

    type Four = Vec4;
    const FOUR: Vec4 = Vec4::ZERO;

    #[inline(always)]
    fn of(four: &Vec4, child: u32) -> Self {
        let (low, high) = if child & 2 == 0 {
            (four.x, four.y)
        } else {
            (four.z, four.w)
        };
        if child & 1 == 0 { low } else { high }
    }
}

impl Enter for () {
    const ZERO: Self = ();

    type Four = Vec4;
    const FOUR: Vec4 = Vec4::ZERO;

    #[inline(always)]
    fn of(_: &Vec4, _: u32) -> Self {}
}

/// A stack of its own.
pub trait Empty: Copy {
    /// Nothing waits.
    const EMPTY: Self;
}

/// The traversal stack: nodes not yet visited, and where the rays enter each. Callers reuse it without clearing it.
#[derive(Clone, Copy, Debug)]
pub struct Stack<C: Cursor, E: Enter = f32> {
    cursors: C::Columns,
    enter: Column<E>,
}

impl<C: Cursor, E: Enter> Stack<C, E> {
    /// Nothing waits.
    pub const EMPTY: Self = Self {
        cursors: C::EMPTY,
        enter: [E::ZERO; STACK_SIZE],
    };
}

impl<C: Cursor, E: Enter> Empty for Stack<C, E> {
    const EMPTY: Self = Self::EMPTY;
}

impl<C: Cursor, E: Enter> Rows<C> for Stack<C, E> {
    type Enter = E;

    /// A sound tree has fewer levels than [`STACK_SIZE`]. In another one rows are used again.
    const ROWS: u32 = i32::MAX as u32;

    #[inline(always)]
    fn put(&mut self, row: u32, cursor: C, enter: E) {
        cursor.put(&mut self.cursors, row as usize);
        self.enter[row as usize % STACK_SIZE] = enter;
    }

    #[inline(always)]
    fn cursor(&self, row: u32) -> C {
        C::at(&self.cursors, row as usize)
    }

    #[inline(always)]
    fn enter(&self, row: u32) -> E {
        self.enter[row as usize % STACK_SIZE]
    }
}
