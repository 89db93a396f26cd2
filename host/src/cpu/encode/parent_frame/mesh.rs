//! Triangles on the lattice, and nodes that link to them.

use super::super::tree::{Part, Tree, both};
use super::nodes::{OnLattice, encode_nodes, linked_to, root_box};
use crate::tree::parent_frame::{LatticeBits, by_bits};
use slimbvh_core::encode::{LeafWidth, decode_node};
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::scan::run_scan;
use slimbvh_core::{Node, NodeRef};
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

/// Codes a tree's nodes and triangles on the lattice with this step. All vertices must lie on it. Returns the root's box.
pub(super) fn encode_lattice_mesh(
    tree: &Tree,
    (bits, step_exponent): (LatticeBits, i32),
    (sizes, width): (&mut Vec<u32>, &mut Option<LeafWidth>),
    (words, triangles): (&mut Vec<u32>, &mut Vec<u32>),
) -> LatticeBox {
    words.resize(tree.nodes.len() * bits.words(), 0);
    let root = root_box(tree, step_exponent);
    let tree = OnLattice {
        tree,
        root,
        step_exponent,
    };
    // Usually all triangles have one width, that of the last time. Then each triangle's place is known and one pass
    // suffices; otherwise a mixed pass follows.
    let is_done = match *width {
        Some(LeafWidth::Narrow) => by_bits!(bits, fill_narrow(&tree, words, triangles)),
        Some(LeafWidth::Middle) => by_bits!(bits, fill_middle(&tree, words, triangles)),
        Some(LeafWidth::Wide) | None => false,
    };
    if !is_done {
        *width = by_bits!(bits, fill_mixed(&tree, words, triangles, sizes));
    }
    root
}

/// [`fill_alike`] for narrow triangles.
fn fill_narrow<const BITS: u32, const WORDS: usize>(
    lattice: &OnLattice,
    words: &mut [u32],
    triangles: &mut Vec<u32>,
) -> bool {
    let put = |leaf: NodeRef, bounds: &LatticeBox, words: &mut [u32]| {
        lattice.leaf(leaf, bounds).put_narrow(words);
    };
    fill_alike::<BITS, WORDS>(lattice, words, triangles, (LeafWidth::Narrow, &put))
}

/// [`fill_alike`] for triangles of middle width.
fn fill_middle<const BITS: u32, const WORDS: usize>(
    lattice: &OnLattice,
    words: &mut [u32],
    triangles: &mut Vec<u32>,
) -> bool {
    let put = |leaf: NodeRef, bounds: &LatticeBox, words: &mut [u32]| {
        lattice.leaf(leaf, bounds).put_middle(words);
    };
    fill_alike::<BITS, WORDS>(lattice, words, triangles, (LeafWidth::Middle, &put))
}

/// Stores triangles of one width. Returns `false` if some have another width; the lists are then invalid.
fn fill_alike<const BITS: u32, const WORDS: usize>(
    lattice: &OnLattice,
    words: &mut [u32],
    triangles: &mut Vec<u32>,
    (width, put): (
        LeafWidth,
        &(impl Fn(NodeRef, &LatticeBox, &mut [u32]) + Sync),
    ),
) -> bool {
    let size = width.words() as usize;
    triangles.resize(size * lattice.tree.leaves.len(), 0);
    let is_other = AtomicBool::new(false);
    let put = |leaf: NodeRef, bounds: &LatticeBox, words: &mut [u32]| {
        if LeafWidth::of(bounds) == width {
            put(leaf, bounds, words);
        } else if leaf.count() > 0 {
            is_other.store(true, Relaxed);
        }
    };
    let link = linked_to::<BITS, WORDS>(|triangle| size as u32 * triangle);
    let part = lattice.part(words, triangles, size);
    encode_nodes::<BITS, WORDS, u32>(lattice, part, &link, &put);
    !is_other.into_inner()
}

/// Stores triangles whose width depends on their leaf's box, so that their places are prefix sums of the sizes. Returns the
/// width if they share one.
fn fill_mixed<const BITS: u32, const WORDS: usize>(
    lattice: &OnLattice,
    words: &mut [u32],
    triangles: &mut Vec<u32>,
    sizes: &mut Vec<u32>,
) -> Option<LeafWidth> {
    let count = lattice.tree.leaves.len();
    sizes.clear();
    sizes.resize(count, 0);
    let size = |_: NodeRef, bounds: &LatticeBox, sizes: &mut [u32]| {
        sizes.fill(LeafWidth::of(bounds).words());
    };
    let unlinked = |_: &Node, words| words;
    let part = lattice.part(words, sizes.as_mut_slice(), 1);
    encode_nodes::<BITS, WORDS, u32>(lattice, part, &unlinked, &size);

    let total = run_scan(sizes, 0, count as u32, 0);
    triangles.resize(total as usize, 0);
    let begins = sizes.as_slice();
    let begin_of = |triangle: u32| begins.get(triangle as usize).map_or(total, |&b| b);
    let part = lattice.part(words, triangles, 1);
    place_triangles::<BITS, WORDS>(lattice, part, &begin_of);

    // The narrowest width with the same total. Mixed widths can have the same total too; then the next fast pass fails and
    // repeats as mixed.
    let widths = [LeafWidth::Narrow, LeafWidth::Middle];
    let takes_as_much = |width: &LeafWidth| width.words() as usize * count == total as usize;
    widths.into_iter().find(takes_as_much)
}

/// Stores triangles at their places, and the links to them in the nodes.
fn place_triangles<const BITS: u32, const WORDS: usize>(
    lattice: &OnLattice,
    part: Part<[u32; WORDS], u32, LatticeBox>,
    begin_of: &(impl Fn(u32) -> u32 + Sync),
) {
    let tree = lattice.tree;
    let node = tree.node(part.node);
    let words = &mut part.nodes[part.node as usize - part.first_node];
    let boxes = decode_node::<BITS, WORDS>(words, &part.bounds);
    *words = linked_to::<BITS, WORDS>(begin_of)(&node, *words);
    let parts = part.split(tree, boxes, |triangle| begin_of(triangle) as usize);
    both(&node, parts, |part| {
        let child = NodeRef(part.node);
        if !child.is_leaf() {
            place_triangles::<BITS, WORDS>(lattice, part, begin_of);
            return;
        }
        lattice.leaf(child, &part.bounds).put(part.triangles);
    });
}
