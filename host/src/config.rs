//! How a hierarchy is to be built and stored, on either backend.

use crate::tree::{MeshCodec, NodeCodec};

/// How finely triangles are told apart along the space-filling curve.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CodeBits {
    /// 10 bits an axis: 1024 cells along the longest side.
    #[default]
    Bits30,
    /// 21 bits an axis, for scenes with small details: a teapot in a stadium.
    Bits63,
}

/// How a tree is found over triangles in the order of the space-filling curve.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TreeKind {
    /// A node for each common prefix of codes (Karras 2012): every node is found by itself.
    #[default]
    Radix,
    /// From the leaves up, neighbours that suit each other best first, with rotations: fewer nodes to open for a ray, most
    /// of all where triangles differ much in size.
    Clustered,
}

/// How to build.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BuildConfig {
    /// Length of the Morton codes.
    pub code_bits: CodeBits,
    /// How the tree is found.
    pub tree: TreeKind,
    /// How inner nodes are stored.
    pub nodes: NodeCodec,
    /// How triangles are stored. Must go with the nodes ([`crate::check_codecs`]).
    pub mesh: MeshCodec,
}

impl From<CodeBits> for BuildConfig {
    /// Codes of this length, and everything stored in full.
    fn from(code_bits: CodeBits) -> Self {
        Self {
            code_bits,
            ..Self::default()
        }
    }
}
