//! The stored tree: an enum of the ways to store it, and the traversal's stacks for each.

use super::codec::{MeshCodec, NodeCodec};
use super::error::TreeError;
use super::lanes::Numbers;
use super::paper10::Paper10Tree;
#[cfg(feature = "lab")]
use super::parent_frame::LatticeTree;
use super::plain::PlainTree;
use super::visitor::TreeVisitor;
use super::wide::WideTree;
use bytemuck::Pod;
use glam::Vec4;
#[cfg(feature = "lab")]
use slimbvh_core::encode::LatticeCursor;
use slimbvh_core::encode::{Paper10Cursor, RootWords};
use slimbvh_core::slab::CodedPlanes;
use slimbvh_core::trace::{BundleStack, Children, PacketStacks, WideFork};
use slimbvh_core::{LeafTriangle, NodeRef};
use std::cell::RefCell;

/// A tree's nodes and triangles, as they are stored.
#[derive(Clone, Debug)]
pub enum StoredTree {
    /// In full.
    Plain(PlainTree),
    /// Nodes, and optionally triangles, in 10 bits, as in the paper.
    Paper10(Paper10Tree),
    /// Nodes of up to four children.
    Wide(WideTree),
    /// Nodes in their parents' frames, and optionally triangles, on a lattice.
    #[cfg(feature = "lab")]
    Lattice(LatticeTree),
}

impl From<PlainTree> for StoredTree {
    fn from(tree: PlainTree) -> Self {
        Self::Plain(tree)
    }
}

impl Default for StoredTree {
    fn default() -> Self {
        Self::Plain(PlainTree::default())
    }
}

impl StoredTree {
    /// Calls a visitor with the concrete sources of nodes and triangles.
    #[inline(always)]
    pub fn visit<V: TreeVisitor>(&self, visitor: V) -> V::Output {
        match self {
            Self::Plain(tree) => tree.visit(visitor),
            Self::Paper10(tree) => tree.visit(visitor),
            Self::Wide(tree) => tree.visit(visitor),
            #[cfg(feature = "lab")]
            Self::Lattice(tree) => tree.visit(visitor),
        }
    }

    /// The tree's lists.
    pub fn lists(&self) -> &dyn Lists {
        match self {
            Self::Plain(tree) => tree,
            Self::Paper10(tree) => tree,
            Self::Wide(tree) => tree,
            #[cfg(feature = "lab")]
            Self::Lattice(tree) => tree,
        }
    }

    fn lists_mut(&mut self) -> &mut dyn Lists {
        match self {
            Self::Plain(tree) => tree,
            Self::Paper10(tree) => tree,
            Self::Wide(tree) => tree,
            #[cfg(feature = "lab")]
            Self::Lattice(tree) => tree,
        }
    }

    /// The tree with nodes and triangles in full, if it is stored so.
    #[inline(always)]
    pub fn as_plain(&self) -> Option<&PlainTree> {
        match self {
            Self::Plain(tree) => Some(tree),
            _ => None,
        }
    }

    /// Takes the triangles out, if they are stored in full.
    pub fn take_full_triangles(&mut self) -> Vec<LeafTriangle> {
        let triangles = self.lists_mut().full_triangles_mut();
        triangles.map(std::mem::take).unwrap_or_default()
    }

    /// A tree in these codecs, with this root and triangle count, its lists read by a reader.
    ///
    /// # Errors
    /// Those of the reader.
    pub fn read<R: ListReader>(
        (nodes, mesh): (NodeCodec, MeshCodec),
        root: &RootWords,
        triangle_count: usize,
        reader: &mut R,
    ) -> Result<Self, R::Error> {
        Ok(match nodes {
            NodeCodec::F32 => Self::Plain(PlainTree::read(reader)?),
            NodeCodec::Paper10 => Self::Paper10(Paper10Tree::read(mesh, root, reader)?),
            NodeCodec::Wide(store) => {
                let codecs = (store, mesh);
                Self::Wide(WideTree::read(codecs, root, triangle_count, reader)?)
            }
            #[cfg(feature = "lab")]
            NodeCodec::Lattice(bits) => {
                let codecs = (bits, mesh);
                Self::Lattice(LatticeTree::read(codecs, root, triangle_count, reader)?)
            }
        })
    }
}

/// Stacks for each kind of nodes.
pub struct Stacks {
    pub plain: PacketStacks<Children<NodeRef>, Numbers>,
    pub paper10: PacketStacks<Children<Paper10Cursor>, Numbers>,
    #[cfg(feature = "lab")]
    pub lattice: PacketStacks<Children<LatticeCursor>, Numbers>,
    /// Of wide nodes in full.
    pub wide: PacketStacks<WideFork<Vec4>, Numbers>,
    /// Of wide nodes on the lattice.
    pub coded_wide: PacketStacks<WideFork<CodedPlanes>, Numbers>,
    /// Of packets over wide nodes.
    pub bundle: BundleStack,
}

impl Stacks {
    /// All empty.
    pub const EMPTY: Self = Self {
        plain: PacketStacks::EMPTY,
        paper10: PacketStacks::EMPTY,
        #[cfg(feature = "lab")]
        lattice: PacketStacks::EMPTY,
        wide: PacketStacks::EMPTY,
        coded_wide: PacketStacks::EMPTY,
        bundle: BundleStack::EMPTY,
    };
}

thread_local! {
    static STACKS: RefCell<Stacks> = const { RefCell::new(Stacks::EMPTY) };
}

/// Calls a function with the thread's own stacks.
pub fn with_stacks<R>(run: impl FnOnce(&mut Stacks) -> R) -> R {
    STACKS.with_borrow_mut(run)
}

/// The two lists of a stored tree.
pub trait Lists {
    /// The codecs. The scene's exponent scales the lattice's step.
    fn codecs(&self, scene_exponent: i32) -> (NodeCodec, MeshCodec);

    /// The number of triangles.
    fn triangle_count(&self) -> usize;

    /// The nodes and the triangles.
    fn lists(&self) -> [List<'_>; 2];

    /// Bytes of memory held.
    fn held_bytes(&self) -> usize;

    /// The root's box and the lattice's step, if boxes are decoded from them.
    fn root_words(&self) -> Option<RootWords>;

    /// Checks that everything below the root can be decoded.
    fn check_root(&self) -> Result<(), TreeError>;

    /// The triangles, if they are stored in full.
    fn full_triangles(&self) -> Option<&Vec<LeafTriangle>>;

    /// The triangles, if they are stored in full.
    fn full_triangles_mut(&mut self) -> Option<&mut Vec<LeafTriangle>>;
}

/// A stored list.
#[derive(Clone, Copy, Debug)]
pub struct List<'a> {
    /// Bytes of an item.
    pub item_bytes: usize,
    /// All items.
    pub words: &'a [u32],
}

impl<'a> List<'a> {
    /// A list of items of whole words.
    pub fn of<T: Pod>(items: &'a [T]) -> Self {
        Self {
            item_bytes: size_of::<T>(),
            words: bytemuck::cast_slice(items),
        }
    }

    /// The number of items.
    pub fn count(&self) -> usize {
        size_of_val(self.words) / self.item_bytes
    }
}

/// Reads the lists of a stored tree, from a file or from the memory of a GPU.
pub trait ListReader {
    /// Why a list cannot be read.
    type Error;

    /// The nodes, each of `per_node` elements.
    fn nodes<T: Pod>(&mut self, per_node: usize) -> Result<Vec<T>, Self::Error>;

    /// The triangles.
    fn triangles<T: Pod>(&mut self) -> Result<Vec<T>, Self::Error>;
}
