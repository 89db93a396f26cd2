//! Which codecs the GPU has, and how many bytes they take there.

use super::GpuError;
use crate::{BuildConfig, LatticeBits, MeshCodec, NodeCodec, TreeKind};
use slimbvh_core::codec::{LeafWidth, Paper10Node, Paper10Triangle, node_words};

/// How nodes and triangles are stored, where that is not in full.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coding {
    Paper10F32,
    Paper10Leaf10,
    Q10F32,
    Q10Lattice,
    Q21F32,
    Q21Lattice,
}

impl Coding {
    /// What a configuration asks for; none where everything is stored in full.
    ///
    /// # Errors
    /// For codecs and trees that only the CPU has, and for paper10 without the feature `lab-kernels`.
    pub fn of(config: &BuildConfig) -> Result<Option<Self>, GpuError> {
        if config.tree == TreeKind::Clustered {
            return Err(GpuError::Tree);
        }
        if config.nodes == NodeCodec::Paper10 && !cfg!(feature = "lab-kernels") {
            return Err(GpuError::LabKernel {
                what: "nodes of the paper10 codec",
            });
        }
        let is_f32 = config.mesh == MeshCodec::F32;
        Ok(match config.nodes {
            NodeCodec::F32 => None,
            NodeCodec::Paper10 if is_f32 => Some(Self::Paper10F32),
            NodeCodec::Paper10 => Some(Self::Paper10Leaf10),
            NodeCodec::Lattice(LatticeBits::Q10) if is_f32 => Some(Self::Q10F32),
            NodeCodec::Lattice(LatticeBits::Q10) => Some(Self::Q10Lattice),
            NodeCodec::Lattice(LatticeBits::Q21) if is_f32 => Some(Self::Q21F32),
            NodeCodec::Lattice(LatticeBits::Q21) => Some(Self::Q21Lattice),
            NodeCodec::Lattice(bits) => {
                return Err(GpuError::Codec { bits: bits.count() });
            }
        })
    }

    /// Bytes of a node.
    pub const fn node_bytes(self) -> u64 {
        match self {
            Self::Paper10F32 | Self::Paper10Leaf10 => size_of::<Paper10Node>() as u64,
            Self::Q10F32 | Self::Q10Lattice => 4 * node_words(10) as u64,
            Self::Q21F32 | Self::Q21Lattice => 4 * node_words(21) as u64,
        }
    }

    /// The most bytes of a triangle; none where it is stored in full.
    pub const fn most_triangle_bytes(self) -> Option<u64> {
        match self {
            Self::Paper10F32 | Self::Q10F32 | Self::Q21F32 => None,
            Self::Paper10Leaf10 => Some(size_of::<Paper10Triangle>() as u64),
            Self::Q10Lattice | Self::Q21Lattice => Some(4 * LeafWidth::Wide.words() as u64),
        }
    }

    /// Whether nodes are on a lattice.
    pub const fn is_lattice(self) -> bool {
        !matches!(self, Self::Paper10F32 | Self::Paper10Leaf10)
    }

    /// Whether triangles take as many words as their leaf needs.
    pub const fn is_mixed(self) -> bool {
        matches!(self, Self::Q10Lattice | Self::Q21Lattice)
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
        match (Coding::of(&config), cfg!(feature = "lab-kernels")) {
            (Ok(coding), true) => assert_eq!(coding, Some(Coding::Paper10F32)),
            (Err(error), false) => assert!(error.to_string().contains("`lab-kernels`"), "{error}"),
            other => panic!("{other:?}"),
        }
    }
}
