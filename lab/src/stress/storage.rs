//! The codecs that are tried, and the kinds of trees.

use super::Effort;
use crate::oracle::distance::{length, minus};
use slimbvh::{BuildConfig, CodeBits, LatticeBits, Mesh, MeshCodec, NodeCodec, TreeKind};
use std::borrow::Cow;

/// How triangles are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Triangles {
    Full,
    Leaf10,
    /// On a lattice, so many times coarser than the finest, as a power of two.
    Lattice {
        coarser: i32,
    },
}

/// How nodes and triangles are stored, and how the tree over them is found.
#[derive(Clone, Copy, Debug)]
pub struct Storage {
    nodes: NodeCodec,
    triangles: Triangles,
    tree: TreeKind,
}

/// A mesh made ready for a codec.
pub struct Prepared<'a> {
    /// Moved onto the lattice, where there is one.
    pub mesh: Cow<'a, Mesh>,
    pub config: BuildConfig,
    /// How far a vertex moved onto a lattice, and how far it might have.
    pub moved: Option<[f64; 2]>,
}

/// A lattice of 4096 points along the scene.
const COARSE: i32 = 12;

impl Storage {
    pub const PLAIN: Self = Self::nodes(NodeCodec::F32);
    pub const LATTICE: Self = Self::lattice(LatticeBits::Q10, 0);

    const fn nodes(nodes: NodeCodec) -> Self {
        Self {
            nodes,
            triangles: Triangles::Full,
            tree: TreeKind::Radix,
        }
    }

    const fn lattice(bits: LatticeBits, coarser: i32) -> Self {
        Self {
            triangles: Triangles::Lattice { coarser },
            ..Self::nodes(NodeCodec::Lattice(bits))
        }
    }

    const fn clustered(self) -> Self {
        Self {
            tree: TreeKind::Clustered,
            ..self
        }
    }

    /// Those that are tried; on a GPU only what it has.
    pub fn all(effort: Effort, on_gpu: bool) -> Vec<Self> {
        let leaf10 = Self {
            triangles: Triangles::Leaf10,
            ..Self::nodes(NodeCodec::Paper10)
        };
        let q10 = NodeCodec::Lattice(LatticeBits::Q10);
        let coarse = Self::lattice(LatticeBits::Q10, COARSE);
        let mut all = vec![Self::PLAIN, Self::nodes(q10), Self::LATTICE, coarse, leaf10];
        if !on_gpu {
            all.push(Self::PLAIN.clustered());
        }
        if effort == Effort::Full {
            all.push(Self::nodes(NodeCodec::Paper10));
            let others = LatticeBits::ALL
                .into_iter()
                .filter(|&bits| bits != LatticeBits::Q10 && (!on_gpu || bits == LatticeBits::Q21));
            all.extend(others.map(|bits| Self::nodes(NodeCodec::Lattice(bits))));
            all.push(Self::lattice(LatticeBits::Q21, 0));
            if !on_gpu {
                all.push(Self::LATTICE.clustered());
            }
        }
        all
    }

    /// In tables: of nodes, then of triangles where these are not in full, then of trees other than radix.
    pub fn name(self) -> String {
        let nodes = self.nodes.name();
        let codec = match self.triangles {
            Triangles::Full => nodes.into(),
            Triangles::Leaf10 => format!("{nodes}+leaf10"),
            Triangles::Lattice { coarser: 0 } => format!("{nodes}+lattice"),
            Triangles::Lattice { coarser } => format!("{nodes}+lattice*2^{coarser}"),
        };
        match self.tree {
            TreeKind::Radix => codec,
            TreeKind::Clustered => format!("{codec} clustered"),
        }
    }

    /// Moves vertices where that must be.
    pub fn prepare(self, mesh: &Mesh, code_bits: CodeBits) -> Prepared<'_> {
        let config = |mesh| BuildConfig {
            nodes: self.nodes,
            mesh,
            tree: self.tree,
            ..BuildConfig::from(code_bits)
        };
        let Triangles::Lattice { coarser } = self.triangles else {
            let codec = match self.triangles {
                Triangles::Leaf10 => MeshCodec::Leaf10,
                _ => MeshCodec::F32,
            };
            return Prepared {
                mesh: Cow::Borrowed(mesh),
                config: config(codec),
                moved: None,
            };
        };
        let step_exponent = mesh.finest_step() + coarser;
        let mut snapped = mesh.clone();
        snapped.snap(step_exponent);
        let pairs = mesh.vertices.iter().zip(&snapped.vertices);
        let moved = pairs.map(|(a, b)| length(minus(a.map(f64::from), b.map(f64::from))));
        let moved = moved.fold(0.0, f64::max);
        // Half a step on each axis; the sum of squares is rounded.
        let bound = 0.75f64.sqrt() * 2f64.powi(step_exponent) * (1.0 + 4.0 * f64::EPSILON);
        Prepared {
            mesh: Cow::Owned(snapped),
            config: config(MeshCodec::Lattice { step_exponent }),
            moved: Some([moved, bound]),
        }
    }

    /// Whether the codec moves vertices by itself.
    pub fn is_leaf10(self) -> bool {
        self.triangles == Triangles::Leaf10
    }
}
