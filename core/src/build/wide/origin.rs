//! Which binary nodes begin wide ones, and where these come.
//!
//! Each wide node has a run of places for its inner children. An exclusive scan of the numbers of inner children, in the order
//! of the binary nodes, gives each run its beginning, so that a wide node's place follows from its parent and its rank there.

use super::WIDTH;
use super::collapse::Collapse;
use crate::build::node::{LEAF_SIZE, Node, NodeRef};

/// Where the wide node that begins at a binary node comes from, in a word: the binary node at which its parent begins, shifted
/// by two, and its rank among that one's inner children. It need not be found again for boxes that have moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Origin(pub u32);

impl Origin {
    /// No wide node begins here: it was dissolved in one.
    pub const ABSENT: Self = Self(u32::MAX);

    /// The root's.
    pub const ROOT: Self = Self(u32::MAX - 1);

    /// That of the inner child with this rank, 0 to 3, of the wide node that begins at a binary node, below 2^28.
    #[inline(always)]
    #[must_use]
    pub const fn below(parent: u32, rank: u32) -> Self {
        Self(parent << 2 | (rank & 3))
    }

    /// Whether a wide node begins here.
    #[inline(always)]
    #[must_use]
    pub const fn is_there(self) -> bool {
        self.0 != Self::ABSENT.0
    }

    /// How many places the wide node with this collapse needs for its inner children; 0 where none begins.
    #[inline(always)]
    #[must_use]
    pub const fn inner_count(self, collapse: Collapse) -> u32 {
        if self.is_there() {
            collapse.inner_count()
        } else {
            0
        }
    }
}

/// The exclusive prefix sums of [`Origin::inner_count`], by binary node. Where triangles lie on the lattice, the same scan goes on
/// over as many numbers again: the words of the triangles in the leaves of each wide node.
#[derive(Clone, Copy, Debug)]
pub struct Begins<'a>(pub &'a [u32]);

impl Begins<'_> {
    /// The place of the first inner child of the wide node that begins at binary node `i`. The root comes before all.
    #[inline(always)]
    #[must_use]
    pub fn first_child(&self, i: u32) -> u32 {
        crate::load(self.0, i, 0).wrapping_add(1)
    }

    /// Where the words' sums begin in a list of this length that has them.
    #[inline(always)]
    #[must_use]
    pub const fn first_of_words(list_length: u32) -> u32 {
        list_length / 2
    }

    /// Where the words of the triangles begin that are in leaves of the wide node that begins at binary node `i`.
    #[inline(always)]
    #[must_use]
    pub fn first_word(&self, i: u32) -> u32 {
        let first = Self::first_of_words(self.0.len() as u32);
        let sum = crate::load(self.0, first.wrapping_add(i), 0);
        sum.wrapping_sub(crate::load(self.0, first, 0))
    }

    /// The place of the wide node with this origin, from 0 on without gaps. Of one that is absent, `u32::MAX`.
    #[inline(always)]
    #[must_use]
    pub fn place(&self, origin: Origin) -> u32 {
        if !origin.is_there() {
            u32::MAX
        } else if origin.0 == Origin::ROOT.0 {
            0
        } else {
            self.first_child(origin.0 >> 2).wrapping_add(origin.0 & 3)
        }
    }
}

/// The largest number of wide nodes over this many triangles; 1 also over none.
///
/// Of w wide nodes, p have inner children. These have four children each, so 4p − (w − 1) leaves; each of the others has more than
/// [`LEAF_SIZE`] triangles below it. As p < w, the triangles are at least 7(w − p) + 4p − w + 1 ≥ 3w + 4.
#[must_use]
pub const fn most_wide_nodes(triangle_count: u32) -> u32 {
    const { assert!(LEAF_SIZE == 6) };
    if triangle_count < 7 {
        1
    } else {
        (triangle_count - 4) / 3
    }
}

/// One thread per binary node. Reads all of them and their [`Collapse`] words. Returns where the wide node that begins at it
/// comes from.
///
/// The walk from the root compares numbers: below a node come first all nodes on its left, the left child as the last of them,
/// then the right child and all below it. It ends at the node, or above it where that was dissolved.
#[inline]
#[must_use]
pub fn wide_origin(i: u32, nodes: &[Node], collapses: &[u32]) -> Origin {
    if i as usize >= nodes.len() {
        return Origin::ABSENT;
    }
    let mut origin = Origin::ROOT;
    let mut at = 0;
    // No walk is longer than there are nodes.
    for _ in 0..nodes.len() as u32 {
        if at == i || !origin.is_there() {
            break;
        }
        let collapse = Collapse(crate::load(collapses, at, Collapse::NONE.0));
        let (place, child) = child_towards(i, at, collapse, nodes);
        if child.is_leaf() || child.0 == at {
            origin = Origin::ABSENT;
        } else {
            origin = Origin::below(at, collapse.inner_before(place));
            at = child.index();
        }
    }
    if at == i { origin } else { Origin::ABSENT }
}

/// The child of the wide node that begins at `at` which is binary node `i` or above it: its place among the children, and which
/// it is. A leaf where the node was dissolved.
#[inline(always)]
fn child_towards(i: u32, at: u32, collapse: Collapse, nodes: &[Node]) -> (u32, NodeRef) {
    let (mut place, mut child) = half_towards(i, at, nodes);
    for step in 0..WIDTH as u32 - 2 {
        let opened = collapse.place(step);
        if opened > 0 && opened <= place {
            place += 1;
        } else if opened == place + 1 {
            if child.is_leaf() || child.index() == i {
                child = NodeRef::EMPTY_LEAF;
            } else {
                let (second, half) = half_towards(i, child.index(), nodes);
                place += second;
                child = half;
            }
        }
    }
    (place, child)
}

/// The child of a binary node that is node `i` or above it, and whether it is the second.
#[inline(always)]
fn half_towards(i: u32, at: u32, nodes: &[Node]) -> (u32, NodeRef) {
    let Node { left, right, .. } = crate::load(nodes, at, Node::EMPTY);
    if !left.is_leaf() && i <= left.index() {
        (0, left)
    } else {
        (1, right)
    }
}
