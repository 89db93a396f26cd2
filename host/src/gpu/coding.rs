//! The codecs with GPU kernels, and their sizes.

use super::{GpuError, Kernel};
use crate::{BuildConfig, MeshCodec, NodeCodec, TreeKind, WideStore};
use slimbvh_core::codec::{
    FullWideNode, LeafWidth, MOST_SHARED_BYTES, PackedWideNode, Paper10Node, Paper10Triangle,
    WideNode,
};

/// The WGSL text for any stage, and that for compute shaders to be put behind it.
macro_rules! texts {
    ($kind:literal) => {
        [
            include_str!(concat!("../../shaders/slimbvh", $kind, ".wgsl")),
            include_str!(concat!("../../shaders/slimbvh_compute", $kind, ".wgsl")),
        ]
    };
}
pub(super) use texts;

/// How nodes and triangles are stored, if not in full.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coding {
    Paper10F32,
    Paper10Leaf10,
    W4F32,
    W464F32,
    W464Lattice,
    W448Lattice,
}

impl Coding {
    /// The coding of a configuration; `None` if everything is stored in full.
    ///
    /// # Errors
    /// For codecs and trees without GPU kernels, and for paper10 without the feature `lab`.
    pub fn of(config: &BuildConfig) -> Result<Option<Self>, GpuError> {
        if config.tree == TreeKind::Clustered {
            return Err(GpuError::Tree);
        }
        if config.nodes == NodeCodec::Paper10 && !cfg!(feature = "lab") {
            return Err(GpuError::LabKernel {
                what: "nodes of the paper10 codec",
            });
        }
        let is_f32 = config.mesh == MeshCodec::F32;
        Ok(match config.nodes {
            NodeCodec::F32 => None,
            NodeCodec::Paper10 if is_f32 => Some(Self::Paper10F32),
            NodeCodec::Paper10 => Some(Self::Paper10Leaf10),
            NodeCodec::Wide(WideStore::Full) => Some(Self::W4F32),
            NodeCodec::Wide(WideStore::Exact) if is_f32 => Some(Self::W464F32),
            NodeCodec::Wide(WideStore::Exact) => Some(Self::W464Lattice),
            NodeCodec::Wide(WideStore::Packed) => Some(Self::W448Lattice),
            #[cfg(feature = "lab")]
            other => {
                return Err(GpuError::Codec {
                    nodes: other.name(),
                });
            }
        })
    }

    /// Bytes of a node.
    pub const fn node_bytes(self) -> u64 {
        match self {
            Self::Paper10F32 | Self::Paper10Leaf10 => size_of::<Paper10Node>() as u64,
            Self::W4F32 => size_of::<FullWideNode>() as u64,
            Self::W464F32 | Self::W464Lattice => size_of::<WideNode>() as u64,
            Self::W448Lattice => size_of::<PackedWideNode>() as u64,
        }
    }

    /// The most bytes of so many triangles, a multiple of 4; `None` if triangles are in full.
    pub const fn most_triangle_bytes(self, count: u64) -> Option<u64> {
        let each = match self {
            Self::Paper10F32 | Self::W4F32 | Self::W464F32 => return None,
            Self::Paper10Leaf10 => size_of::<Paper10Triangle>() as u64,
            Self::W464Lattice => 4 * LeafWidth::Wide.words() as u64,
            Self::W448Lattice => MOST_SHARED_BYTES as u64,
        };
        Some((count * each).next_multiple_of(4))
    }

    /// Whether triangles are in full.
    pub const fn has_full_triangles(self) -> bool {
        self.most_triangle_bytes(0).is_none()
    }

    /// Whether the size of a triangle depends on its leaf.
    pub const fn is_mixed(self) -> bool {
        matches!(self.encodes(), Encodes::MixedWide { .. })
    }

    /// The WGSL texts that trace hierarchies of this coding, if there are any.
    pub const fn texts(self) -> Option<[&'static str; 2]> {
        match self {
            Self::W4F32 => Some(texts!("_w4_f32")),
            Self::W464F32 => Some(texts!("_w4_64_f32")),
            Self::W464Lattice => Some(texts!("_w4_64_lattice")),
            Self::W448Lattice => Some(texts!("_w4_48_lattice")),
            _ => None,
        }
    }

    /// Whether nodes have up to four children.
    pub const fn is_wide(self) -> bool {
        matches!(
            self.encodes(),
            Encodes::Wide(_) | Encodes::WideInFull(_) | Encodes::MixedWide { .. }
        )
    }

    /// Whether kernels read the root's box from a uniform.
    pub const fn has_root(self) -> bool {
        !matches!(self.encodes(), Encodes::WideInFull(_))
    }
}

/// The kernels that encode hierarchies of one coding.
#[derive(Clone, Copy, Debug)]
pub enum Encodes {
    /// One kernel encodes nodes; triangles stay in full. It reads an `opaque_zero`, as products of floats must not be fused.
    NodesInFloats(Kernel),
    /// One kernel encodes nodes and triangles, with an `opaque_zero` as [`Self::NodesInFloats`].
    AllInFloats(Kernel),
    /// One kernel encodes wide nodes, whose places are known before; triangles stay in full.
    Wide(Kernel),
    /// The same without a root's box.
    WideInFull(Kernel),
    /// Triangles vary in size: one kernel counts their words, another encodes wide nodes.
    MixedWide {
        words: Kernel,
        nodes: Kernel,
        /// Whether corners that a leaf's triangles share are stored once, so that they are numbered before.
        shares_corners: bool,
    },
}

impl Coding {
    /// The encoding kernels.
    pub const fn encodes(self) -> Encodes {
        match self {
            Self::Paper10F32 => Encodes::NodesInFloats(Kernel::encode_paper10_f32),
            Self::Paper10Leaf10 => Encodes::AllInFloats(Kernel::encode_paper10_leaf10),
            Self::W4F32 => Encodes::WideInFull(Kernel::encode_w4),
            Self::W464F32 => Encodes::Wide(Kernel::encode_w4_64_f32),
            Self::W464Lattice => Encodes::MixedWide {
                words: Kernel::wide_words_64,
                nodes: Kernel::encode_w4_64_lattice,
                shares_corners: false,
            },
            Self::W448Lattice => Encodes::MixedWide {
                words: Kernel::wide_words_48,
                nodes: Kernel::encode_w4_48_lattice,
                shares_corners: true,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The error names the feature.
    #[test]
    fn the_paper10_codec_needs_the_kernels_of_the_laboratory() {
        let config = BuildConfig {
            nodes: NodeCodec::Paper10,
            ..BuildConfig::default()
        };
        match (Coding::of(&config), cfg!(feature = "lab")) {
            (Ok(coding), true) => assert_eq!(coding, Some(Coding::Paper10F32)),
            (Err(error), false) => assert!(error.to_string().contains("`lab`"), "{error}"),
            other => panic!("{other:?}"),
        }
    }
}
