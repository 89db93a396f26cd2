//! Trees in the laboratory's lattice codec, whose nodes are coded in their parents' frames.

mod mesh;
mod nodes;

use self::mesh::encode_lattice_mesh;
use self::nodes::encode_lattice;
use super::tree::Tree;
use crate::tree::lattice::LatticeMesh;
use crate::tree::parent_frame::LatticeTree;
use crate::tree::{LatticeBits, MeshCodec, StoredTree};
use slimbvh_core::LeafTriangle;
use slimbvh_core::encode::{FINEST_STEP, LeafWidth, scaled_step};
use slimbvh_core::lattice::LatticeBox;

/// Encodes trees. Keeps its buffers.
#[derive(Debug)]
pub(super) struct LatticeEncoder {
    sizes: Vec<u32>,
    /// The common width of all triangles of the last tree, if there was one.
    width: Option<LeafWidth>,
}

impl Default for LatticeEncoder {
    fn default() -> Self {
        Self {
            sizes: Vec::new(),
            width: Some(LeafWidth::Narrow),
        }
    }
}

impl LatticeEncoder {
    /// Codes a tree in a scene with this exponent, in the buffers of a tree to be replaced. Vertices must lie on the mesh's lattice,
    /// if it has one.
    pub(super) fn encode(
        &mut self,
        tree: &Tree,
        (bits, mesh): (LatticeBits, MeshCodec),
        scene_exponent: i32,
        old: StoredTree,
    ) -> Encoded {
        let old = LatticeTree::reuse(old);
        let (mut nodes, mut words) = (old.words, old.triangles.into_words());
        let Some(step_exponent) = mesh.step_exponent() else {
            let root = encode_lattice(tree, bits, &mut nodes);
            return Encoded {
                bits,
                root,
                step_exponent: FINEST_STEP,
                nodes,
                words: None,
            };
        };
        let step_exponent = scaled_step(step_exponent, scene_exponent);
        let to = (&mut nodes, &mut words);
        let scratch = (&mut self.sizes, &mut self.width);
        let root = encode_lattice_mesh(tree, (bits, step_exponent), scratch, to);
        Encoded {
            bits,
            root,
            step_exponent,
            nodes,
            words: Some(words),
        }
    }

    /// Bytes of the buffers kept.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(self.sizes.as_slice())
    }
}

/// A tree without triangles in full.
pub(super) struct Encoded {
    bits: LatticeBits,
    root: LatticeBox,
    step_exponent: i32,
    nodes: Vec<u32>,
    /// Of triangles on the lattice.
    words: Option<Vec<u32>>,
}

impl Encoded {
    /// The tree over these triangles, which a buffer keeps if they are not part of it.
    pub(super) fn over(
        self,
        leaves: Vec<LeafTriangle>,
        kept: &mut Vec<LeafTriangle>,
    ) -> LatticeTree {
        LatticeTree {
            bits: self.bits,
            root: self.root,
            step_exponent: self.step_exponent,
            words: self.nodes,
            triangles: LatticeMesh::over(self.words, leaves, kept),
        }
    }
}
