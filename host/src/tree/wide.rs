//! A tree of nodes with up to four children: boxes in full, or on the lattice in a frame of the node's own.

mod shape;
mod sources;

use super::codec::{MeshCodec, NodeCodec, WideStore};
use super::error::TreeError;
use super::lattice::{LatticeMesh, check_root};
use super::stored::{List, ListReader, Lists, StoredTree};
use super::visitor::TreeVisitor;
use slimbvh_core::LeafTriangle;
use slimbvh_core::encode::{
    FullWideNode, LatticeTriangles, PackedWideNode, PackedWideNodes, RootWords, SharedTriangles,
    WideMixedNodes, WideNode, WideNodes,
};
use slimbvh_core::float::power_of_two;
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::trace::{FullWideNodes, LeafTriangles, MOST_WIDE_NODES};

pub use shape::{WideConnection, WideShape};

/// Nodes, the root's box, and triangles.
#[derive(Clone, Debug)]
pub struct WideTree {
    /// The root's box; that of the origin for nodes in full.
    pub root: LatticeBox,
    /// The step is 2 to this power, at the scene's magnitude; 0 for nodes in full.
    pub step_exponent: i32,
    pub nodes: WideList,
    /// In full, or in the order in which nodes came to be.
    pub triangles: LatticeMesh,
}

/// Nodes, the root first.
#[derive(Clone, Debug)]
pub enum WideList {
    Full(Vec<FullWideNode>),
    Exact(Vec<WideNode>),
    /// Triangles are on the lattice.
    Packed(Vec<PackedWideNode>),
}

impl WideList {
    /// How they are stored.
    pub const fn store(&self) -> WideStore {
        match self {
            Self::Full(_) => WideStore::Full,
            Self::Exact(_) => WideStore::Exact,
            Self::Packed(_) => WideStore::Packed,
        }
    }
}

/// The buffer of a list of nodes of one kind, if it is of that kind.
macro_rules! buffer {
    ($name:ident, $kind:ident, $node:ty) => {
        /// The buffer of nodes of this kind; empty for others.
        pub fn $name(self) -> Vec<$node> {
            match self {
                Self::$kind(nodes) => nodes,
                _ => Vec::new(),
            }
        }
    };
}

impl WideList {
    buffer!(into_full, Full, FullWideNode);
    buffer!(into_exact, Exact, WideNode);
    buffer!(into_packed, Packed, PackedWideNode);
}

impl WideTree {
    /// The buffers of a tree to be replaced, if it is wide.
    pub fn reuse(tree: StoredTree) -> Self {
        match tree {
            StoredTree::Wide(tree) => tree,
            _ => Self {
                root: LatticeBox::ZERO,
                step_exponent: 0,
                nodes: WideList::Full(Vec::new()),
                triangles: LatticeMesh::Full(Vec::new()),
            },
        }
    }

    /// Calls a visitor with the sources.
    #[inline(always)]
    pub fn visit<V: TreeVisitor>(&self, visitor: V) -> V::Output {
        match (&self.nodes, &self.triangles) {
            (WideList::Full(nodes), _) => visit_full(self, nodes, visitor),
            (WideList::Exact(nodes), LatticeMesh::Full(_)) => visit_exact(self, nodes, visitor),
            (WideList::Exact(nodes), LatticeMesh::Lattice { .. }) => {
                visit_mixed(self, nodes, visitor)
            }
            (WideList::Packed(nodes), _) => visit_packed(self, nodes, visitor),
        }
    }

    /// A tree with this root, its lists read by a reader.
    pub fn read<R: ListReader>(
        (store, mesh): (WideStore, MeshCodec),
        root: &RootWords,
        triangle_count: usize,
        reader: &mut R,
    ) -> Result<Self, R::Error> {
        Ok(Self {
            root: root.lattice(),
            step_exponent: root.step_exponent(),
            nodes: match store {
                WideStore::Full => WideList::Full(reader.nodes(1)?),
                WideStore::Exact => WideList::Exact(reader.nodes(1)?),
                WideStore::Packed => WideList::Packed(reader.nodes(1)?),
            },
            triangles: LatticeMesh::read(mesh, triangle_count, reader)?,
        })
    }
}

// Separate functions: one for all stores would be too large to optimise well.

#[inline(never)]
fn visit_full<V: TreeVisitor>(tree: &WideTree, nodes: &[FullWideNode], visitor: V) -> V::Output {
    let nodes = FullWideNodes(bytemuck::cast_slice(nodes));
    visitor.visit(&nodes, &LeafTriangles(tree.triangles.full()))
}

#[inline(never)]
fn visit_exact<V: TreeVisitor>(tree: &WideTree, nodes: &[WideNode], visitor: V) -> V::Output {
    let (nodes, root) = (bytemuck::cast_slice(nodes), tree.root);
    let step = power_of_two(tree.step_exponent);
    let nodes = WideNodes { nodes, root, step };
    visitor.visit(&nodes, &LeafTriangles(tree.triangles.full()))
}

#[inline(never)]
fn visit_mixed<V: TreeVisitor>(tree: &WideTree, nodes: &[WideNode], visitor: V) -> V::Output {
    let (nodes, root) = (bytemuck::cast_slice(nodes), tree.root);
    let (words, step) = (tree.triangles.words(), power_of_two(tree.step_exponent));
    let nodes = WideMixedNodes { nodes, root, step };
    visitor.visit(&nodes, &LatticeTriangles { words, step })
}

#[inline(never)]
fn visit_packed<V: TreeVisitor>(
    tree: &WideTree,
    nodes: &[PackedWideNode],
    visitor: V,
) -> V::Output {
    let (nodes, root) = (bytemuck::cast_slice(nodes), tree.root);
    let (words, step) = (tree.triangles.words(), power_of_two(tree.step_exponent));
    let nodes = PackedWideNodes { nodes, root, step };
    visitor.visit(&nodes, &SharedTriangles { words, step })
}

impl Lists for WideTree {
    fn codecs(&self, scene_exponent: i32) -> (NodeCodec, MeshCodec) {
        let mesh = self.triangles.codec(self.step_exponent, scene_exponent);
        (NodeCodec::Wide(self.nodes.store()), mesh)
    }

    fn triangle_count(&self) -> usize {
        self.triangles.count()
    }

    fn lists(&self) -> [List<'_>; 2] {
        let nodes = match &self.nodes {
            WideList::Full(nodes) => List::of(nodes),
            WideList::Exact(nodes) => List::of(nodes),
            WideList::Packed(nodes) => List::of(nodes),
        };
        [nodes, self.triangles.list()]
    }

    fn held_bytes(&self) -> usize {
        let nodes = match &self.nodes {
            WideList::Full(nodes) => nodes.capacity() * size_of::<FullWideNode>(),
            WideList::Exact(nodes) => nodes.capacity() * size_of::<WideNode>(),
            WideList::Packed(nodes) => nodes.capacity() * size_of::<PackedWideNode>(),
        };
        nodes + self.triangles.held_bytes()
    }

    fn root_words(&self) -> Option<RootWords> {
        match self.nodes {
            WideList::Full(_) => None,
            _ => Some(RootWords::of_lattice(&self.root, self.step_exponent)),
        }
    }

    fn check_root(&self) -> Result<(), TreeError> {
        let (count, limit) = (self.lists()[0].count(), MOST_WIDE_NODES as usize);
        if count > limit {
            return Err(TreeError::WideNodeCount { count, limit });
        }
        match self.nodes {
            WideList::Full(_) => Ok(()),
            _ => check_root(&self.root, self.step_exponent),
        }
    }

    fn full_triangles(&self) -> Option<&Vec<LeafTriangle>> {
        self.triangles.as_full()
    }

    fn full_triangles_mut(&mut self) -> Option<&mut Vec<LeafTriangle>> {
        self.triangles.as_full_mut()
    }
}
