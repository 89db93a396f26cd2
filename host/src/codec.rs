//! In how many bytes hierarchies are stored.

use slimbvh_core::encode::LeafWidth;
use thiserror::Error;

/// How inner nodes are stored. None changes an answer: boxes only grow.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum NodeCodec {
    /// 64 bytes: both children's boxes in full.
    #[default]
    F32,
    /// 24 bytes: planes in 10 bits between those of the parent, by floats, as in the paper on compressed hierarchies.
    Paper10,
    /// 12 to 28 bytes: planes counted from those of the parent, by integers.
    Lattice(LatticeBits),
}

/// Bits of a plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LatticeBits {
    /// 4 bits, 12 bytes a node.
    Q4,
    /// 6 bits, 16 bytes a node.
    Q6,
    /// 8 bits, 16 bytes a node.
    Q8,
    /// 10 bits, 16 bytes a node.
    Q10,
    /// 12 bits, 20 bytes a node.
    Q12,
    /// 16 bits, 28 bytes a node.
    Q16,
    /// 21 bits, 28 bytes a node.
    Q21,
}

/// Calls a function of bits and words of a node.
macro_rules! by_bits {
    ($bits:expr, $function:ident($($argument:expr),* $(,)?)) => {
        match $bits {
            $crate::codec::LatticeBits::Q4 => $function::<4, 3>($($argument),*),
            $crate::codec::LatticeBits::Q6 => $function::<6, 4>($($argument),*),
            $crate::codec::LatticeBits::Q8 => $function::<8, 4>($($argument),*),
            $crate::codec::LatticeBits::Q10 => $function::<10, 4>($($argument),*),
            $crate::codec::LatticeBits::Q12 => $function::<12, 5>($($argument),*),
            $crate::codec::LatticeBits::Q16 => $function::<16, 7>($($argument),*),
            $crate::codec::LatticeBits::Q21 => $function::<21, 7>($($argument),*),
        }
    };
}
pub(crate) use by_bits;

impl LatticeBits {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::Q4,
        Self::Q6,
        Self::Q8,
        Self::Q10,
        Self::Q12,
        Self::Q16,
        Self::Q21,
    ];

    /// The number of bits.
    #[must_use]
    pub const fn count(self) -> u32 {
        match self {
            Self::Q4 => 4,
            Self::Q6 => 6,
            Self::Q8 => 8,
            Self::Q10 => 10,
            Self::Q12 => 12,
            Self::Q16 => 16,
            Self::Q21 => 21,
        }
    }

    /// Words of a node.
    pub(crate) const fn words(self) -> usize {
        slimbvh_core::encode::node_words(self.count())
    }
}

/// How the triangles in leaves are stored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MeshCodec {
    /// 40 bytes: as they are, with their index.
    #[default]
    F32,
    /// 16 bytes: 10 bits a coordinate in the leaf's box, as in the paper on compressed hierarchies. Vertices move, each leaf's by itself:
    /// surfaces crack. Goes with [`NodeCodec::Paper10`].
    Leaf10,
    /// 16, 28 or 40 bytes, as a leaf needs: exact, over a mesh whose vertices lie on a lattice ([`crate::Mesh::snap`]). Goes
    /// with [`NodeCodec::Lattice`].
    Lattice {
        /// The lattice's step is 2 to this power, in the mesh's unit.
        step_exponent: i32,
    },
}

/// The most triangles that can be stored so: links name a word among those of all, each of which may take ten.
pub(crate) const fn most_triangles(mesh: MeshCodec) -> usize {
    const MOST: usize = slimbvh_core::MAX_TRIANGLES as usize;
    match mesh {
        MeshCodec::F32 | MeshCodec::Leaf10 => MOST,
        MeshCodec::Lattice { .. } => MOST / LeafWidth::Wide.words() as usize,
    }
}

/// Codecs that do not go together.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum CodecError {
    /// Leaves are coded in boxes that other nodes do not have.
    #[error("triangles of 10 bits in their leaf's box go with paper10 nodes only")]
    Leaf10WithoutPaper10,
    /// The same.
    #[error("triangles on a lattice go with nodes on a lattice only")]
    LatticeWithout,
}

/// Whether both can be had together.
///
/// # Errors
/// Says which cannot.
pub const fn check_codecs(nodes: NodeCodec, mesh: MeshCodec) -> Result<(), CodecError> {
    match (nodes, mesh) {
        (_, MeshCodec::F32)
        | (NodeCodec::Paper10, MeshCodec::Leaf10)
        | (NodeCodec::Lattice(_), MeshCodec::Lattice { .. }) => Ok(()),
        (_, MeshCodec::Leaf10) => Err(CodecError::Leaf10WithoutPaper10),
        (_, MeshCodec::Lattice { .. }) => Err(CodecError::LatticeWithout),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_are_those_of_the_nodes() {
        fn sizes<const BITS: u32, const WORDS: usize>() -> (u32, usize) {
            assert_eq!(WORDS, slimbvh_core::encode::node_words(BITS));
            (BITS, WORDS)
        }
        for bits in LatticeBits::ALL {
            let (count, _) = by_bits!(bits, sizes());
            assert_eq!(count, bits.count());
        }
    }

    #[test]
    fn what_does_not_go_together_is_told() {
        let lattice = MeshCodec::Lattice { step_exponent: -9 };
        let q10 = NodeCodec::Lattice(LatticeBits::Q10);
        for (nodes, mesh, fits) in [
            (NodeCodec::F32, MeshCodec::F32, true),
            (q10, MeshCodec::F32, true),
            (NodeCodec::Paper10, MeshCodec::Leaf10, true),
            (q10, lattice, true),
            (NodeCodec::F32, lattice, false),
            (NodeCodec::Paper10, lattice, false),
            (q10, MeshCodec::Leaf10, false),
            (NodeCodec::F32, MeshCodec::Leaf10, false),
        ] {
            assert_eq!(
                check_codecs(nodes, mesh).is_ok(),
                fits,
                "{nodes:?} {mesh:?}"
            );
        }
    }
}
