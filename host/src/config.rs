//! Settings of a build, for either backend: length of the codes, kind of tree, codecs.

use crate::tree::{MeshCodec, NodeCodec};

/// Length of the Morton codes. It limits how finely the curve separates triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CodeBits {
    /// 10 bits an axis: 1024 cells along the longest side.
    #[default]
    Bits30,
    /// 21 bits an axis, for scenes with small details: a teapot in a stadium.
    Bits63,
}

/// How the builder finds a tree over triangles in the order of the space-filling curve.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TreeKind {
    /// One node for each common prefix of codes (Karras 2012). Each node is found independently.
    #[default]
    Radix,
    /// Bottom-up clustering: neighbours with the smallest joint surface area merge first, then rotations. Rays open fewer
    /// nodes, above all where triangle sizes differ much.
    Clustered,
}

/// How to build and store a hierarchy.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BuildConfig {
    /// Length of the Morton codes.
    pub code_bits: CodeBits,
    /// The kind of tree.
    pub tree: TreeKind,
    /// How inner nodes are stored.
    pub nodes: NodeCodec,
    /// How triangles are stored. The pair must pass [`crate::check_codecs`].
    pub mesh: MeshCodec,
}

impl From<CodeBits> for BuildConfig {
    /// This code length, the default tree, and no compression.
    fn from(code_bits: CodeBits) -> Self {
        Self {
            code_bits,
            ..Self::default()
        }
    }
}
