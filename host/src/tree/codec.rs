//! Codecs of nodes and triangles: names, tags in files, and valid pairs.

#[cfg(feature = "lab")]
use super::parent_frame::LatticeBits;
use slimbvh_core::Node;
use slimbvh_core::encode::frame::PLANE_BITS;
use slimbvh_core::encode::{
    FullWideNode, LeafWidth, MOST_SHARED_BYTES, PackedWideNode, Paper10Node, WideNode,
};
use slimbvh_core::trace::MOST_WIDE_NODES;
use thiserror::Error;

/// How inner nodes are stored. No codec changes an answer: decoded boxes contain the originals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum NodeCodec {
    /// 64 bytes: both children's boxes in full.
    #[default]
    F32,
    /// 24 bytes: 10-bit planes between those of the parent, decoded with floats. From the paper on compressed hierarchies
    /// and meshes.
    Paper10,
    /// 48 to 128 bytes a node of up to four children, of which there are less than half as many as of two.
    Wide(WideStore),
    /// 12 to 28 bytes: integer distances to the parent's planes. For the laboratory, on the CPU only. [`Self::Wide`] on the lattice
    /// is smaller, and its rays are faster; it is encoded more slowly.
    #[cfg(feature = "lab")]
    Lattice(LatticeBits),
}

impl NodeCodec {
    /// The codecs without those of the laboratory.
    const SHIPPED: [Self; 5] = [
        Self::F32,
        Self::Paper10,
        Self::Wide(WideStore::Full),
        Self::Wide(WideStore::Exact),
        Self::Wide(WideStore::Packed),
    ];

    /// All codecs.
    pub fn all() -> impl Iterator<Item = Self> + Clone {
        let all = Self::SHIPPED.into_iter();
        #[cfg(feature = "lab")]
        let all = all.chain(LatticeBits::ALL.map(Self::Lattice));
        all
    }

    /// The name in options and reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::Paper10 => "paper10",
            Self::Wide(store) => store.name(),
            #[cfg(feature = "lab")]
            Self::Lattice(bits) => bits.name(),
        }
    }

    /// The codec with this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::all().find(|codec| codec.name() == name)
    }

    /// Bytes of a node.
    #[must_use]
    pub const fn node_bytes(self) -> usize {
        match self {
            Self::F32 => size_of::<Node>(),
            Self::Paper10 => size_of::<Paper10Node>(),
            Self::Wide(store) => store.node_bytes(),
            #[cfg(feature = "lab")]
            Self::Lattice(bits) => bits.words() * size_of::<u32>(),
        }
    }

    /// Whether nodes are collapsed from those of a binary tree, once these have boxes.
    pub(crate) const fn is_collapsed(self) -> bool {
        matches!(self, Self::Wide(_))
    }

    /// The tag in files, and the bits of a lattice plane.
    const fn tags(self) -> [u32; 2] {
        match self {
            Self::F32 => [0, 0],
            Self::Paper10 => [1, 0],
            Self::Wide(WideStore::Full) => [3, 0],
            Self::Wide(WideStore::Exact) => [4, PLANE_BITS],
            Self::Wide(WideStore::Packed) => [5, PLANE_BITS],
            #[cfg(feature = "lab")]
            Self::Lattice(bits) => [LATTICE_TAG, bits.count()],
        }
    }
}

/// The codecs on a lattice that are there without the laboratory, for messages.
pub(crate) const ON_LATTICE: &str = "w4-64 or w4-48";

/// The tag of [`NodeCodec::Lattice`] in files.
const LATTICE_TAG: u32 = 2;

/// How nodes of up to four children are stored. A node on the lattice has a frame of its own: it is decoded from its own bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WideStore {
    /// 128 bytes: all boxes in full. Requires triangles in full.
    Full,
    /// 64 bytes: 8 bits a plane, the node's own sides exact.
    Exact,
    /// 48 bytes: 8 bits a plane, links packed. Requires triangles on the lattice.
    Packed,
}

impl WideStore {
    /// The name in options and reports.
    const fn name(self) -> &'static str {
        match self {
            Self::Full => "w4",
            Self::Exact => "w4-64",
            Self::Packed => "w4-48",
        }
    }

    /// Bytes of a node.
    const fn node_bytes(self) -> usize {
        match self {
            Self::Full => size_of::<FullWideNode>(),
            Self::Exact => size_of::<WideNode>(),
            Self::Packed => size_of::<PackedWideNode>(),
        }
    }
}

/// Where trees are built and traced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Processor {
    /// The CPU.
    Cpu,
    /// A GPU.
    Gpu,
}

/// How the triangles in leaves are stored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MeshCodec {
    /// 40 bytes: nine floats and the index.
    #[default]
    F32,
    /// 16 bytes: 10 bits a coordinate in the leaf's box, from the paper on compressed hierarchies and meshes. Each leaf
    /// moves its vertices independently, so surfaces crack. Requires [`NodeCodec::Paper10`].
    Leaf10,
    /// 16, 28 or 40 bytes, the least that the leaf allows; below nodes of 48 bytes fewer as a rule, as corners that a leaf's triangles
    /// share are stored once (at most 42). Exact if the mesh's vertices lie on a lattice
    /// ([`crate::Mesh::snap`]). Requires nodes on the lattice: [`WideStore::Exact`] or [`WideStore::Packed`].
    Lattice {
        /// The lattice's step is 2 to this power, in the mesh's unit.
        step_exponent: i32,
    },
}

impl MeshCodec {
    /// One codec of each kind. The lattice has step 1; [`Self::with_step`] sets another.
    pub const ALL: [Self; 3] = [Self::F32, Self::Leaf10, Self::Lattice { step_exponent: 0 }];

    /// The name in options and reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::Leaf10 => "leaf10",
            Self::Lattice { .. } => "lattice",
        }
    }

    /// The codec with this name, [one](Self::ALL) of its kind.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|codec| codec.name() == name)
    }

    /// One line: bytes a triangle, and the nodes required.
    #[must_use]
    pub const fn summary(self) -> &'static str {
        match self {
            Self::F32 => "40 bytes a triangle",
            Self::Leaf10 => "16 bytes a triangle; requires paper10 nodes",
            Self::Lattice { .. } => {
                "16, 28 or 40 bytes a triangle, the least that each leaf allows, or shared corners with w4-48; requires nodes on the lattice"
            }
        }
    }

    /// The exponent of the lattice's step, if triangles are on a lattice.
    #[must_use]
    pub const fn step_exponent(self) -> Option<i32> {
        match self {
            Self::F32 | Self::Leaf10 => None,
            Self::Lattice { step_exponent } => Some(step_exponent),
        }
    }

    /// The codec with another lattice step, if triangles are on a lattice. Without a step they are stored in full.
    #[must_use]
    pub fn with_step(self, step_exponent: Option<i32>) -> Self {
        match self {
            Self::F32 | Self::Leaf10 => self,
            Self::Lattice { .. } => {
                step_exponent.map_or(Self::F32, |step_exponent| Self::Lattice { step_exponent })
            }
        }
    }

    /// Triangles on the lattice whose step is 2 to this power.
    #[must_use]
    pub const fn on_lattice(step_exponent: i32) -> Self {
        Self::Lattice { step_exponent }
    }

    /// Whether encoding moves vertices. Then no exact decision about the mesh's triangles holds for the stored ones.
    #[must_use]
    pub const fn moves_vertices(self) -> bool {
        matches!(self, Self::Leaf10)
    }

    /// The nodes to use with these triangles, where nothing else decides: of those on the front of time and bytes, nodes in full where
    /// triangles are, as a picture's build and rays together take least with them; else the fewest bytes on a CPU, and on a GPU the nodes
    /// that are encoded in half the time. The number of triangles, from thousands to millions, makes no difference (docs/measured.md,
    /// "Choice of nodes").
    #[must_use]
    pub const fn nodes_for(self, processor: Processor) -> NodeCodec {
        match (self, processor) {
            (Self::F32, _) => NodeCodec::F32,
            (Self::Leaf10, _) => NodeCodec::Paper10,
            (Self::Lattice { .. }, Processor::Cpu) => NodeCodec::Wide(WideStore::Packed),
            (Self::Lattice { .. }, Processor::Gpu) => NodeCodec::Wide(WideStore::Exact),
        }
    }

    /// All nodes that can be combined with these triangles.
    pub fn nodes(self) -> impl Iterator<Item = NodeCodec> {
        NodeCodec::all().filter(move |nodes| check_codecs(*nodes, self).is_ok())
    }

    /// The tag in files.
    const fn tag(self) -> u32 {
        match self {
            Self::F32 => 0,
            Self::Leaf10 => 1,
            Self::Lattice { .. } => 2,
        }
    }
}

/// Tags of codecs in files: nodes, bits of a lattice plane, triangles.
pub(crate) const fn tags((nodes, mesh): (NodeCodec, MeshCodec)) -> [u32; 3] {
    let [nodes, bits] = nodes.tags();
    [nodes, bits, mesh.tag()]
}

/// The codecs with these [`tags`] and this lattice step.
///
/// # Errors
/// For unknown tags and invalid pairs, and for nodes that only the laboratory has.
pub(crate) fn tagged(
    [nodes, bits, mesh]: [u32; 3],
    step_exponent: i32,
) -> Result<(NodeCodec, MeshCodec), TagError> {
    let mut all = NodeCodec::all();
    let nodes = match all.find(|codec| codec.tags() == [nodes, bits]) {
        Some(nodes) => nodes,
        None if nodes == LATTICE_TAG && !cfg!(feature = "lab") => {
            return Err(TagError::Laboratory { bits });
        }
        None => return Err(TagError::Unknown),
    };
    let mut all = MeshCodec::ALL.into_iter();
    let mesh = all.find(|codec| codec.tag() == mesh);
    let mesh = mesh.ok_or(TagError::Unknown)?;
    check_codecs(nodes, mesh).map_err(|_| TagError::Unknown)?;
    Ok((nodes, mesh.with_step(Some(step_exponent))))
}

/// Why [`tagged`] returns no codecs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TagError {
    /// No codecs have these tags, or none that go together.
    Unknown,
    /// The nodes' codec is there with the feature `lab` only.
    Laboratory {
        /// Bits of a plane.
        bits: u32,
    },
}

const _: () = assert!(
    3 * MOST_WIDE_NODES as u64 * MOST_SHARED_BYTES as u64 <= 4 * slimbvh_core::MAX_TRIANGLES as u64
);

/// The largest number of triangles. On the lattice, links index words, and a triangle takes up to ten, with shared corners ten and a half. Wide nodes are at most
/// [`MOST_WIDE_NODES`]: one with inner children has four children, one without has more triangles than a leaf holds, so that there
/// are at most a third as many as triangles.
pub(crate) const fn most_triangles(nodes: NodeCodec, mesh: MeshCodec) -> usize {
    const MOST: usize = slimbvh_core::MAX_TRIANGLES as usize;
    match (nodes, mesh) {
        (NodeCodec::Wide(_), _) => 3 * MOST_WIDE_NODES as usize,
        (_, MeshCodec::Lattice { .. }) => MOST / LeafWidth::Wide.words() as usize,
        _ => MOST,
    }
}

/// Codecs that cannot be combined.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum CodecError {
    /// Triangles are coded relative to leaf boxes of the paper10 codec.
    #[error("triangles of 10 bits in their leaf's box require paper10 nodes")]
    Leaf10WithoutPaper10,
    /// Triangles are coded relative to leaf boxes on the lattice.
    #[error("triangles on a lattice require nodes on a lattice")]
    LatticeWithout,
    /// Nodes of 128 bytes hold their children's boxes in full.
    #[error(
        "w4 nodes, of 128 bytes, require triangles in full; w4-64 and w4-48 nodes are for triangles on a lattice"
    )]
    FullWideOnLattice,
    /// Links of nodes of 48 bytes name words of triangles.
    #[error(
        "w4-48 nodes require triangles on a lattice; w4-64 nodes are for triangles in full, too"
    )]
    PackedWideWithout,
}

/// Checks that nodes and triangles can be combined.
///
/// # Errors
/// If the triangles' codec requires other nodes.
pub const fn check_codecs(nodes: NodeCodec, mesh: MeshCodec) -> Result<(), CodecError> {
    match (nodes, mesh) {
        (NodeCodec::Wide(WideStore::Packed), MeshCodec::F32) => Err(CodecError::PackedWideWithout),
        (NodeCodec::Wide(WideStore::Full), MeshCodec::Lattice { .. }) => {
            Err(CodecError::FullWideOnLattice)
        }
        (_, MeshCodec::F32)
        | (NodeCodec::Paper10, MeshCodec::Leaf10)
        | (NodeCodec::Wide(WideStore::Exact | WideStore::Packed), MeshCodec::Lattice { .. }) => {
            Ok(())
        }
        #[cfg(feature = "lab")]
        (NodeCodec::Lattice(_), MeshCodec::Lattice { .. }) => Ok(()),
        (_, MeshCodec::Leaf10) => Err(CodecError::Leaf10WithoutPaper10),
        (_, MeshCodec::Lattice { .. }) => Err(CodecError::LatticeWithout),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_tags_are_those_of_one_codec() {
        for nodes in NodeCodec::all() {
            assert_eq!(NodeCodec::named(nodes.name()), Some(nodes));
            for mesh in MeshCodec::ALL {
                assert_eq!(MeshCodec::named(mesh.name()), Some(mesh));
                let (mesh, fits) = (mesh.with_step(Some(-7)), check_codecs(nodes, mesh).is_ok());
                let expected = if fits {
                    Ok((nodes, mesh))
                } else {
                    Err(TagError::Unknown)
                };
                assert_eq!(tagged(tags((nodes, mesh)), -7), expected);
                assert_eq!(mesh.nodes().any(|it| it == nodes), fits);
                for processor in [Processor::Cpu, Processor::Gpu] {
                    let chosen = mesh.nodes_for(processor);
                    assert!(mesh.nodes().any(|nodes| nodes == chosen));
                }
            }
        }
        assert_eq!(NodeCodec::named("printed"), None);
        for unknown in [[6, 0, 0], [3, 8, 0], [0, 1, 0], [0, 0, 3]] {
            assert_eq!(tagged(unknown, 0), Err(TagError::Unknown));
        }
    }

    #[test]
    fn codecs_of_the_laboratory_are_named_where_they_are_not_there() {
        let q10 = NodeCodec::named("q10");
        assert_eq!(q10.is_some(), cfg!(feature = "lab"));
        for (bits, mesh) in [
            (10, MeshCodec::F32),
            (4, MeshCodec::Lattice { step_exponent: 3 }),
        ] {
            let read = tagged([LATTICE_TAG, bits, mesh.tag()], 3);
            match q10 {
                Some(_) => assert_eq!(
                    read.map(|(nodes, mesh)| (nodes.tags()[1], mesh)),
                    Ok((bits, mesh))
                ),
                None => assert_eq!(read, Err(TagError::Laboratory { bits })),
            }
        }
    }

    #[test]
    fn pairs_that_do_not_go_together_are_refused() {
        let lattice = MeshCodec::Lattice { step_exponent: -9 };
        let fits_q10 =
            |mesh| NodeCodec::named("q10").is_none_or(|q10| check_codecs(q10, mesh).is_ok());
        assert!(fits_q10(MeshCodec::F32) && fits_q10(lattice));
        assert!(!cfg!(feature = "lab") || !fits_q10(MeshCodec::Leaf10));
        for (nodes, mesh, fits) in [
            (NodeCodec::F32, MeshCodec::F32, true),
            (NodeCodec::Paper10, MeshCodec::Leaf10, true),
            (NodeCodec::F32, lattice, false),
            (NodeCodec::Paper10, lattice, false),
            (NodeCodec::F32, MeshCodec::Leaf10, false),
            (NodeCodec::Wide(WideStore::Full), MeshCodec::F32, true),
            (NodeCodec::Wide(WideStore::Full), lattice, false),
            (NodeCodec::Wide(WideStore::Exact), MeshCodec::F32, true),
            (NodeCodec::Wide(WideStore::Exact), lattice, true),
            (NodeCodec::Wide(WideStore::Exact), MeshCodec::Leaf10, false),
            (NodeCodec::Wide(WideStore::Packed), MeshCodec::F32, false),
            (NodeCodec::Wide(WideStore::Packed), lattice, true),
        ] {
            assert_eq!(
                check_codecs(nodes, mesh).is_ok(),
                fits,
                "{nodes:?} {mesh:?}"
            );
        }
    }
}
