//! Stage `encode` on the CPU: from the root down, as a box is coded in its parent's, once that is decoded.
//!
//! A node's descendants lie together: those of the left child before the right child, those of the right child from there on.
//! So both halves can be filled at once, each in its part of the lists.

mod lattice;
mod lattice_mesh;
mod paper10;
mod tree;

use self::lattice::encode_lattice;
use self::lattice_mesh::encode_lattice_mesh;
use self::paper10::encode_paper10;
use self::tree::Tree;
use super::topology::Connections;
use crate::Bvh;
use crate::codec::{MeshCodec, NodeCodec};
use crate::coded::{Coded, CodedNodes, CodedTriangles};
use slimbvh_core::LeafTriangle;
use slimbvh_core::encode::{LeafWidth, Paper10Triangle, scaled_step};
use slimbvh_core::refit::PyramidBox;

/// Codes hierarchies, and keeps what was plain of them for the next.
#[derive(Debug)]
pub struct Encoder {
    triangles: Vec<LeafTriangle>,
    sizes: Vec<u32>,
    /// How wide all triangles of the last hierarchy were, where they were alike.
    width: Option<LeafWidth>,
}

impl Default for Encoder {
    fn default() -> Self {
        Self {
            triangles: Vec::new(),
            sizes: Vec::new(),
            width: Some(LeafWidth::Narrow),
        }
    }
}

impl Encoder {
    /// Gives a hierarchy room for triangles, where the last one left any.
    pub fn lend(&mut self, bvh: &mut Bvh) {
        if bvh.triangles.capacity() == 0 {
            std::mem::swap(&mut bvh.triangles, &mut self.triangles);
        }
    }

    /// Codes a hierarchy over these nodes, and takes back its triangles where they are coded. Its vertices must lie
    /// on the mesh's lattice.
    pub fn encode(
        &mut self,
        (nodes, mesh): (NodeCodec, MeshCodec),
        bvh: &mut Bvh,
        (connections, pyramid): (&Connections, &[PyramidBox]),
    ) {
        let leaves = bvh.triangles.as_slice();
        let tree = Tree {
            nodes: &connections.nodes,
            splits: &connections.splits,
            leaves,
            pyramid,
        };
        let mut coded = bvh.coded.take().unwrap_or_else(Coded::nothing);
        coded.triangle_count = leaves.len();
        match (nodes, mesh) {
            (NodeCodec::F32, _) => return,
            (NodeCodec::Paper10, _) => {
                let mut nodes = match coded.nodes {
                    CodedNodes::Paper10 { nodes, .. } => nodes,
                    CodedNodes::Lattice { .. } => Vec::new(),
                };
                let mut triangles = match coded.triangles {
                    CodedTriangles::Leaf10(triangles) => triangles,
                    CodedTriangles::F32 | CodedTriangles::Lattice(_) => Vec::new(),
                };
                let is_leaf_10 = mesh == MeshCodec::Leaf10;
                let count = if is_leaf_10 { leaves.len() } else { 0 };
                triangles.resize(count, Paper10Triangle::default());
                let root = encode_paper10(&tree, &mut nodes, &mut triangles);
                coded.nodes = CodedNodes::Paper10 { root, nodes };
                coded.triangles = match mesh {
                    MeshCodec::Leaf10 => CodedTriangles::Leaf10(triangles),
                    MeshCodec::F32 | MeshCodec::Lattice { .. } => CodedTriangles::F32,
                };
            }
            (NodeCodec::Lattice(bits), MeshCodec::Lattice { step_exponent }) => {
                let mut words = match coded.triangles {
                    CodedTriangles::Lattice(words) => words,
                    CodedTriangles::F32 | CodedTriangles::Leaf10(_) => Vec::new(),
                };
                let step_exponent = scaled_step(step_exponent, bvh.scene_exponent);
                let to = (&mut coded.nodes, &mut words);
                let shape = (bits, step_exponent);
                let scratch = (&mut self.sizes, &mut self.width);
                encode_lattice_mesh(&tree, shape, scratch, to);
                coded.triangles = CodedTriangles::Lattice(words);
            }
            (NodeCodec::Lattice(bits), _) => {
                encode_lattice(&tree, bits, &mut coded.nodes);
                coded.triangles = CodedTriangles::F32;
            }
        }
        bvh.nodes = Vec::new();
        if !matches!(coded.triangles, CodedTriangles::F32) {
            self.triangles = std::mem::take(&mut bvh.triangles);
        }
        bvh.coded = Some(coded);
    }

    /// Bytes of what is kept.
    pub fn bytes(&self) -> usize {
        size_of_val(self.triangles.as_slice()) + size_of_val(self.sizes.as_slice())
    }
}
