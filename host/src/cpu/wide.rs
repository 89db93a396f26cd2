//! Wide trees: collapsed from a binary tree with boxes and encoded, or encoded anew over moved triangles.

mod collapse;
mod place;
mod store;

use self::collapse::Collapsing;
use self::place::{Placing, place_again};
use self::store::{Exact, Full, Mixed, MixedItem, Store};
use super::BLOCK;
use crate::parallel::prelude::*;
use crate::tree::lattice::LatticeMesh;
use crate::tree::wide::{WideConnection, WideList, WideTree};
use crate::tree::{MeshCodec, WideStore};
use slimbvh_core::encode::{
    FINEST_STEP, FullWideNode, LeafWidth, PackedWideNode, RoundedChildren, WideNode,
    number_corners, scaled_step,
};
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::refit::{PyramidBox, range_bounds};
use slimbvh_core::scan::run_scan;
use slimbvh_core::wide::{Collapse, Origin, WIDTH, WideChild, WideChildren, wide_children};
use slimbvh_core::{Aabb, LeafTriangle, Node, NodeRef};

/// Encodes wide trees. Keeps its buffers.
#[derive(Debug)]
pub(super) struct WideEncoder {
    places: Places,
    /// The common width of all triangles on the lattice of the last tree, if there was one.
    width: Option<LeafWidth>,
    full: Vec<FullWideNode>,
    exact: Vec<WideNode>,
    mixed: Vec<MixedItem<WideNode>>,
    packed: Vec<MixedItem<PackedWideNode>>,
}

impl Default for WideEncoder {
    fn default() -> Self {
        Self {
            places: Places::default(),
            width: Some(LeafWidth::Narrow),
            full: Vec::new(),
            exact: Vec::new(),
            mixed: Vec::new(),
            packed: Vec::new(),
        }
    }
}

/// Which binary nodes wide ones take in, and where these and their triangles come.
#[derive(Debug, Default)]
struct Places {
    /// A [`Collapse`] for each binary node, where a wide one begins.
    collapses: Vec<u32>,
    /// An [`Origin`] for each.
    origins: Vec<u32>,
    /// For each binary node, how many inner children the wide one has that begins at it, if one does; then their prefix sums.
    begins: Vec<u32>,
    /// The same of the words of its leaves' triangles; empty for triangles in full.
    words: Vec<u32>,
    /// For each triangle, which corners it has ([`slimbvh_core::encode::TriangleCorners`]); empty if corners are not shared.
    corners: Vec<u32>,
}

impl Places {
    /// No wide node begins at any of so many binary nodes.
    fn clear<S: Store>(&mut self, node_count: usize, triangle_count: usize) {
        let word_count = if S::MIXED { node_count } else { 0 };
        let fill = |list: &mut Vec<u32>, count, number| {
            list.clear();
            list.resize(count, number);
        };
        fill(&mut self.collapses, node_count, Collapse::NONE.0);
        fill(&mut self.origins, node_count, Origin::ABSENT.0);
        fill(&mut self.begins, node_count, 0);
        fill(&mut self.words, word_count, 0);
        self.corners
            .resize(if S::SHARES_CORNERS { triangle_count } else { 0 }, 0);
    }
}

/// A list of triangles, and the step of their lattice: in the scene's magnitude, two to this power.
struct Triangles<'a> {
    leaves: &'a [LeafTriangle],
    step_exponent: i32,
}

impl Triangles<'_> {
    /// A leaf's.
    fn of(&self, leaf: NodeRef) -> &[LeafTriangle] {
        let first = leaf.first() as usize;
        &self.leaves[first..first + leaf.count() as usize]
    }

    /// Numbers the corners of a leaf's triangles, in a list whose first is that of triangle `first`.
    fn number(&self, leaf: NodeRef, first: u32, corners: &mut [u32]) {
        let (at, count) = ((leaf.first() - first) as usize, leaf.count());
        let own = &mut corners[at..at + count as usize];
        number_corners(0, count, self.of(leaf), own);
    }
}

/// The children that are leaves, and there.
fn leaves_of(children: [NodeRef; WIDTH]) -> impl Iterator<Item = NodeRef> {
    let is_leaf = |child: &NodeRef| child.is_leaf() && child.count() > 0;
    children.into_iter().filter(is_leaf)
}

/// Which corners triangles have, from one on; empty if corners are not shared.
#[derive(Clone, Copy)]
struct Corners<'a> {
    first: u32,
    list: &'a [u32],
}

impl<'a> Corners<'a> {
    /// Those of a leaf's triangles.
    fn of(self, leaf: NodeRef) -> &'a [u32] {
        let first = (leaf.first() - self.first) as usize;
        &self.list[first..first + leaf.count() as usize]
    }
}

/// What a wide tree is encoded from.
pub(super) enum Source<'a> {
    /// A binary tree.
    Binary(&'a [Node]),
    /// The nodes of a wide tree, which keep their places, and the boxes of what they hold.
    Wide {
        connections: &'a [WideConnection],
        pyramid: &'a [PyramidBox],
    },
}

impl WideEncoder {
    /// Encodes a tree over triangles in the order of leaves, in the memory of the one it replaces. Vertices must lie on the mesh's
    /// lattice, if it has one.
    pub(super) fn encode(
        &mut self,
        (store, mesh): (WideStore, MeshCodec),
        scene_exponent: i32,
        from: &Source,
        leaves: &[LeafTriangle],
        old: WideTree,
    ) -> Encoded {
        let mesh_step = mesh.step_exponent();
        let step_exponent = match (store, mesh_step) {
            (WideStore::Full, _) => 0,
            (_, Some(step_exponent)) => scaled_step(step_exponent, scene_exponent),
            (_, None) => FINEST_STEP,
        };
        let root = match store {
            WideStore::Full => LatticeBox::ZERO,
            _ => root_box(&root_children(from, leaves), step_exponent),
        };
        let triangles = Triangles {
            leaves,
            step_exponent,
        };
        let mut words = Vec::new();
        if mesh_step.is_some() {
            words = old.triangles.into_words();
        }
        let Self {
            places,
            width,
            full,
            exact,
            mixed,
            packed,
        } = self;
        let mut run = Run {
            places,
            width,
            triangles: &triangles,
            words: &mut words,
        };
        let nodes = match store {
            WideStore::Full => {
                let mut nodes = old.nodes.into_full();
                run.fill::<Full>(from, full, &mut nodes);
                WideList::Full(nodes)
            }
            WideStore::Exact => {
                let mut nodes = old.nodes.into_exact();
                if mesh_step.is_some() {
                    run.fill::<Mixed<WideNode>>(from, mixed, &mut nodes);
                } else {
                    run.fill::<Exact>(from, exact, &mut nodes);
                }
                WideList::Exact(nodes)
            }
            WideStore::Packed => {
                let mut nodes = old.nodes.into_packed();
                run.fill::<Mixed<PackedWideNode>>(from, packed, &mut nodes);
                WideList::Packed(nodes)
            }
        };
        Encoded {
            root,
            step_exponent,
            nodes,
            words: mesh_step.map(|_| words),
        }
    }

    /// Bytes of the buffers kept.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(self.places.collapses.as_slice())
            + size_of_val(self.places.origins.as_slice())
            + size_of_val(self.places.begins.as_slice())
            + size_of_val(self.places.words.as_slice())
            + size_of_val(self.places.corners.as_slice())
            + size_of_val(self.full.as_slice())
            + size_of_val(self.exact.as_slice())
            + size_of_val(self.mixed.as_slice())
            + size_of_val(self.packed.as_slice())
    }
}

/// A wide tree without triangles in full.
pub(super) struct Encoded {
    root: LatticeBox,
    step_exponent: i32,
    nodes: WideList,
    /// Of triangles on the lattice.
    words: Option<Vec<u32>>,
}

impl Encoded {
    /// The tree over these triangles, which a buffer keeps if they are not part of it.
    pub(super) fn over(self, leaves: Vec<LeafTriangle>, kept: &mut Vec<LeafTriangle>) -> WideTree {
        WideTree {
            root: self.root,
            step_exponent: self.step_exponent,
            nodes: self.nodes,
            triangles: LatticeMesh::over(self.words, leaves, kept),
        }
    }
}

/// The root's children.
fn root_children(from: &Source, leaves: &[LeafTriangle]) -> WideChildren {
    match from {
        Source::Binary(nodes) => {
            wide_children(nodes.first().unwrap_or(&Node::EMPTY), Collapse::NONE, &[])
        }
        Source::Wide {
            connections,
            pyramid,
        } => children_of(0, connections, leaves, pyramid),
    }
}

/// The smallest box on a lattice that holds all children.
fn root_box(children: &WideChildren, step_exponent: i32) -> LatticeBox {
    let rounded = RoundedChildren::new(children, step_exponent);
    let there = rounded.boxes.into_iter().take(rounded.count as usize);
    let whole = there.reduce(|a, b| a.union(&b));
    whole.unwrap_or(LatticeBox::ZERO)
}

/// The children of a wide node whose boxes have changed.
fn children_of(
    node: u32,
    connections: &[WideConnection],
    leaves: &[LeafTriangle],
    pyramid: &[PyramidBox],
) -> WideChildren {
    const NOTHING: Aabb = Aabb {
        min: glam::Vec3::ZERO,
        max: glam::Vec3::ZERO,
    };
    let WideConnection {
        children, count, ..
    } = connections[node as usize];
    let child = |i: u32| {
        let child = children[i as usize];
        let bounds = if i >= count {
            NOTHING
        } else if child.is_leaf() {
            let (first, count) = (child.first(), child.count());
            range_bounds(first, (first + count).saturating_sub(1), leaves, pyramid)
        } else {
            let WideConnection { first, last, .. } = connections[child.index() as usize];
            range_bounds(first, last, leaves, pyramid)
        };
        WideChild::new(child, bounds)
    };
    WideChildren::new([child(0), child(1), child(2), child(3)], count)
}

/// The encoding of one tree.
struct Run<'a> {
    places: &'a mut Places,
    width: &'a mut Option<LeafWidth>,
    triangles: &'a Triangles<'a>,
    words: &'a mut Vec<u32>,
}

impl Run<'_> {
    /// Fills the lists of nodes and of words. `unplaced` is a buffer.
    fn fill<S: Store>(
        &mut self,
        from: &Source,
        unplaced: &mut Vec<S::Item>,
        nodes: &mut Vec<S::Node>,
    ) {
        let triangles = self.triangles;
        let step_exponent = triangles.step_exponent;
        match from {
            Source::Binary(binary) => {
                // Usually all corners have one width, that of the last time. Then their words need not be counted by their boxes;
                // otherwise they are counted in a second run.
                let is_done = !S::MIXED || self.width.is_some();
                if !(is_done && self.fill_binary::<S>(binary, *self.width, nodes).is_some()) {
                    let widths = self.fill_binary::<S>(binary, None, nodes);
                    let widths = widths.expect("words were counted by what is stored");
                    let is_one = widths.count_ones() == 1;
                    *self.width = is_one.then(|| LeafWidth::of_number(widths.trailing_zeros()));
                }
            }
            Source::Wide {
                connections,
                pyramid,
            } => {
                let Places { corners, .. } = &mut *self.places;
                if S::SHARES_CORNERS {
                    number_all(connections, triangles, corners);
                }
                let corners = Corners {
                    first: 0,
                    list: corners,
                };
                unplaced.resize(connections.len(), S::Item::default());
                let blocks = unplaced.par_chunks_mut(BLOCK).enumerate();
                blocks.for_each(|(block, items)| {
                    for (item, i) in items.iter_mut().zip((block * BLOCK) as u32..) {
                        let WideConnection { first, last, .. } = connections[i as usize];
                        let children = children_of(i, connections, triangles.leaves, pyramid);
                        *item = S::item(&children, [first, last], corners, step_exponent);
                    }
                });
                nodes.resize(connections.len(), S::Node::default());
                let from = (unplaced.as_slice(), *connections);
                place_again::<S>(from, triangles, corners, (nodes, self.words));
            }
        }
    }

    /// Collapses a binary tree and fills the lists, with corners of a common width, if one is given. Returns the widths of all leaves, a
    /// bit each, unless they are others.
    fn fill_binary<S: Store>(
        &mut self,
        binary: &[Node],
        common: Option<LeafWidth>,
        nodes: &mut Vec<S::Node>,
    ) -> Option<u32> {
        let count = binary.len();
        let mut collapsing = Collapsing {
            nodes: binary,
            places: self.places,
            triangles: self.triangles,
            common,
        };
        let division = collapsing.divide::<S>();
        let mut roots = Vec::with_capacity(division.runs.len());
        let mut rest = division.runs.as_slice();
        let (mut begin, mut inner_count, mut word_count) = (0, 0, 0);
        while begin < count {
            let (runs, next) = rest.split_at(collapsing.group(rest));
            rest = next;
            collapsing.fill::<S>(runs);
            let end = rest.first().map_or(count, |run| run.range.start);
            let (first, length) = (begin as u32, (end - begin) as u32);
            let Places { begins, words, .. } = &mut *collapsing.places;
            inner_count = run_scan(begins, first, length, inner_count);
            word_count = run_scan(words, first, length, word_count);
            begin = end;
            // Lists that are long enough already are not cleared.
            let [node_end, word_end] = [1 + inner_count as usize, word_count as usize];
            nodes.resize(nodes.len().max(node_end), S::Node::default());
            self.words.resize(self.words.len().max(word_end), 0);
            let placing = Placing {
                nodes: collapsing.nodes,
                places: collapsing.places,
                triangles: self.triangles,
            };
            let to = (&mut nodes[..node_end], &mut self.words[..word_end]);
            roots.extend(placing.fill_runs::<S>(runs, end, to));
        }
        nodes.truncate(1 + inner_count as usize);
        self.words.truncate(word_count as usize);
        Placing {
            nodes: binary,
            places: self.places,
            triangles: self.triangles,
        }
        .fill_top::<S>(&division, roots, nodes, self.words)
    }
}

/// Numbers the corners of all leaves' triangles.
fn number_all(connections: &[WideConnection], triangles: &Triangles, corners: &mut Vec<u32>) {
    corners.resize(triangles.leaves.len(), 0);
    let leaves = connections.iter().flat_map(|it| leaves_of(it.children));
    let mut leaves: Vec<NodeRef> = leaves.collect();
    leaves.par_sort_unstable_by_key(|leaf| leaf.first());
    let mut rest = corners.as_mut_slice();
    let own = leaves.iter().map(|&leaf| {
        let (own, after) = std::mem::take(&mut rest).split_at_mut(leaf.count() as usize);
        rest = after;
        (leaf, own)
    });
    let own: Vec<_> = own.collect();
    let own = own.into_par_iter().with_min_len(BLOCK);
    own.for_each(|(leaf, corners)| triangles.number(leaf, leaf.first(), corners));
}
