//! Stage `encode` on the CPU, from the root down: a child's box is coded relative to its parent's decoded box.
//!
//! A node's descendants are contiguous: those of the left child, then those of the right child. So both halves can be
//! filled in parallel, each in its part of the lists.

mod leaf_words;
mod paper10;
#[cfg(feature = "lab")]
mod parent_frame;
mod tree;

use self::paper10::encode_paper10;
#[cfg(feature = "lab")]
use self::parent_frame::LatticeEncoder;
use super::wide::{Source, WideEncoder};

pub(super) use self::leaf_words::Leaf;
pub(super) use self::tree::{TASK, Tree};
use crate::tree::paper10::{Paper10Mesh, Paper10Tree};
use crate::tree::plain::PlainTree;
use crate::tree::wide::{WideShape, WideTree};
use crate::tree::{MeshCodec, NodeCodec, StoredTree};
use slimbvh_core::refit::PyramidBox;
use slimbvh_core::{LeafTriangle, Node};

/// Stores hierarchies, in full or in a codec. Keeps buffers from one to the next.
#[derive(Debug, Default)]
pub struct Encoder {
    nodes: Vec<Node>,
    triangles: Vec<LeafTriangle>,
    wide: WideEncoder,
    #[cfg(feature = "lab")]
    lattice: LatticeEncoder,
}

/// A tree to be stored, in a scene with this exponent.
pub struct Unstored {
    pub nodes: Vec<Node>,
    pub leaves: Vec<LeafTriangle>,
    pub scene_exponent: i32,
}

impl Encoder {
    /// A buffer for triangles in full: that of the tree to be replaced, or the one kept from the last encoding.
    pub fn leaves(&mut self, replaced: &mut StoredTree) -> Vec<LeafTriangle> {
        let mut leaves = replaced.take_full_triangles();
        if leaves.capacity() == 0 {
            std::mem::swap(&mut leaves, &mut self.triangles);
        }
        leaves
    }

    /// A buffer for nodes in full, to be stored in a codec: that of the tree to be replaced, or the one kept from the last encoding.
    pub fn nodes(&mut self, codec: NodeCodec, replaced: &mut StoredTree) -> Vec<Node> {
        match (codec, replaced) {
            (NodeCodec::F32, StoredTree::Plain(tree)) => std::mem::take(&mut tree.nodes),
            (NodeCodec::F32, _) => Vec::new(),
            _ => std::mem::take(&mut self.nodes),
        }
    }

    /// Stores a wide tree over moved triangles, in the memory of that one. Its nodes stay where they are.
    pub fn store_again(
        &mut self,
        mesh: MeshCodec,
        shape: WideShape,
        (pyramid, scene_exponent): (&[PyramidBox], i32),
        stored: &mut StoredTree,
    ) {
        let old = WideTree::reuse(std::mem::take(stored));
        let codecs = (old.nodes.store(), mesh);
        let from = Source::Wide {
            connections: &shape.nodes,
            pyramid,
        };
        let leaves = shape.triangles;
        let encoded = (self.wide).encode(codecs, scene_exponent, &from, &leaves, old);
        *stored = StoredTree::Wide(encoded.over(leaves, &mut self.triangles));
    }

    /// Stores a tree over these triangles, reusing the buffers of the tree that it replaces. Keeps the buffer of triangles
    /// if they are coded. Vertices must lie on the mesh's lattice, if it has one.
    pub fn store(
        &mut self,
        (nodes, mesh): (NodeCodec, MeshCodec),
        from: Unstored,
        stored: &mut StoredTree,
    ) {
        let old = std::mem::take(stored);
        let Unstored {
            nodes: binary,
            leaves,
            scene_exponent: exponent,
        } = from;
        let tree = Tree {
            nodes: &binary,
            leaves: &leaves,
        };
        *stored = match nodes {
            NodeCodec::F32 => {
                *stored = StoredTree::Plain(PlainTree {
                    nodes: binary,
                    triangles: leaves,
                });
                return;
            }
            NodeCodec::Paper10 => {
                let old = Paper10Tree::reuse(old);
                let (mut nodes, mut triangles) = (old.nodes, old.triangles.into_coded());
                let is_leaf_10 = mesh == MeshCodec::Leaf10;
                let count = if is_leaf_10 { leaves.len() } else { 0 };
                triangles.resize(count, Default::default());
                let root = encode_paper10(&tree, &mut nodes, &mut triangles);
                let triangles = if is_leaf_10 {
                    self.triangles = leaves;
                    Paper10Mesh::Leaf10(triangles)
                } else {
                    Paper10Mesh::Full(leaves)
                };
                StoredTree::Paper10(Paper10Tree {
                    root,
                    nodes,
                    triangles,
                })
            }
            NodeCodec::Wide(store) => {
                let old = WideTree::reuse(old);
                let from = Source::Binary(&binary);
                let encoded = (self.wide).encode((store, mesh), exponent, &from, &leaves, old);
                StoredTree::Wide(encoded.over(leaves, &mut self.triangles))
            }
            #[cfg(feature = "lab")]
            NodeCodec::Lattice(bits) => {
                let encoded = self.lattice.encode(&tree, (bits, mesh), exponent, old);
                StoredTree::Lattice(encoded.over(leaves, &mut self.triangles))
            }
        };
        self.nodes = binary;
    }

    /// Bytes of the buffers kept.
    pub fn bytes(&self) -> usize {
        let parts = [
            size_of_val(self.nodes.as_slice()),
            size_of_val(self.triangles.as_slice()),
            self.wide.bytes(),
            #[cfg(feature = "lab")]
            self.lattice.bytes(),
        ];
        parts.iter().sum()
    }
}
