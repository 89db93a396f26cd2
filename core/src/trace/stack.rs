//! Nodes that wait in a traversal.

use crate::build::node::NodeRef;
use crate::build::topology::depth_bound;

/// The stack holds one entry a level below the root. Trees of 63-bit codes have at most 63 + 28 levels
/// ([`crate::build::topology::depth_bound`]), trees of 30-bit codes 30 + 28, clustered ones 126 ([`crate::build::cluster::depth_bound`]).
pub const STACK_SIZE: usize = 128;
const _: () = assert!(STACK_SIZE as u32 > depth_bound(63, crate::MAX_TRIANGLES));
const _: () = assert!(STACK_SIZE as u32 > crate::build::cluster::depth_bound(crate::MAX_TRIANGLES));

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

impl BoxColumns {
    /// All bits zero.
    pub const EMPTY: Self = Self {
        node: NodeRef::EMPTY,
        min_a: [0.0; STACK_SIZE],
        min_b: [0.0; STACK_SIZE],
        min_c: [0.0; STACK_SIZE],
        max_a: [0.0; STACK_SIZE],
        max_b: [0.0; STACK_SIZE],
        max_c: [0.0; STACK_SIZE],
    };

    /// Puts a node and its box in place.
    #[inline(always)]
    pub fn put(&mut self, place: usize, node: NodeRef, min: [f32; 3], max: [f32; 3]) {
        let place = place % STACK_SIZE;
        self.node[place] = node;
        self.min_a[place] = min[0];
        self.min_b[place] = min[1];
        self.min_c[place] = min[2];
        self.max_a[place] = max[0];
        self.max_b[place] = max[1];
        self.max_c[place] = max[2];
    }

    /// The node that was put there.
    #[inline(always)]
    #[must_use]
    pub fn node(&self, place: usize) -> NodeRef {
        self.node[place % STACK_SIZE]
    }

    /// Smallest coordinates of the box that was put there.
    #[inline(always)]
    #[must_use]
    pub fn min(&self, place: usize) -> [f32; 3] {
        let place = place % STACK_SIZE;
        [self.min_a[place], self.min_b[place], self.min_c[place]]
    }

    /// Largest coordinates of the box that was put there.
    #[inline(always)]
    #[must_use]
    pub fn max(&self, place: usize) -> [f32; 3] {
        let place = place % STACK_SIZE;
        [self.max_a[place], self.max_b[place], self.max_c[place]]
    }
}

/// Where the rays of a traversal enter a node: one number, or one a ray.
pub trait Enter: Copy {
    /// All bits zero.
    const ZERO: Self;
}

impl Enter for f32 {
    const ZERO: Self = 0.0;
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

    /// Lets a node wait.
    #[inline(always)]
    pub(super) fn put(&mut self, place: usize, cursor: C, enter: E) {
        cursor.put(&mut self.cursors, place);
        self.enter[place % STACK_SIZE] = enter;
    }

    /// A node that waits.
    #[inline(always)]
    pub(super) fn cursor(&self, place: usize) -> C {
        C::at(&self.cursors, place)
    }

    /// Where the rays enter it.
    #[inline(always)]
    pub(super) fn enter(&self, place: usize) -> E {
        self.enter[place % STACK_SIZE]
    }
}
