//! The codecs that are tried.

use super::Effort;
use crate::oracle::distance::{length, minus};
use crate::{BuildConfig, CodeBits, LatticeBits, Mesh, MeshCodec, NodeCodec};
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

/// How nodes and triangles are stored.
#[derive(Clone, Copy, Debug)]
pub struct Storage {
    nodes: NodeCodec,
    triangles: Triangles,
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
    pub const LATTICE: Self = Self {
        nodes: NodeCodec::Lattice(LatticeBits::Q10),
        triangles: Triangles::Lattice { coarser: 0 },
    };

    const fn nodes(nodes: NodeCodec) -> Self {
        Self {
            nodes,
            triangles: Triangles::Full,
        }
    }

    /// Those that are tried; on a GPU only what it has.
    pub fn all(effort: Effort, on_gpu: bool) -> Vec<Self> {
        let lattice = |coarser: i32, bits: LatticeBits| Self {
            nodes: NodeCodec::Lattice(bits),
            triangles: Triangles::Lattice { coarser },
        };
        let leaf10 = Self {
            nodes: NodeCodec::Printed,
            triangles: Triangles::Leaf10,
        };
        let q10 = NodeCodec::Lattice(LatticeBits::Q10);
        let coarse = lattice(COARSE, LatticeBits::Q10);
        let mut all = vec![Self::PLAIN, Self::nodes(q10), Self::LATTICE, coarse, leaf10];
        if effort == Effort::Full {
            all.push(Self::nodes(NodeCodec::Printed));
            let others = LatticeBits::ALL
                .into_iter()
                .filter(|&bits| bits != LatticeBits::Q10 && (!on_gpu || bits == LatticeBits::Q21));
            all.extend(others.map(|bits| Self::nodes(NodeCodec::Lattice(bits))));
            all.push(lattice(0, LatticeBits::Q21));
        }
        all
    }

    /// In tables: of nodes, then of triangles where these are not in full.
    pub fn name(self) -> String {
        let nodes = match self.nodes {
            NodeCodec::F32 => "f32".into(),
            NodeCodec::Printed => "printed".into(),
            NodeCodec::Lattice(bits) => format!("q{}", bits.count()),
        };
        match self.triangles {
            Triangles::Full => nodes,
            Triangles::Leaf10 => format!("{nodes}+leaf10"),
            Triangles::Lattice { coarser: 0 } => format!("{nodes}+lattice"),
            Triangles::Lattice { coarser } => format!("{nodes}+lattice*2^{coarser}"),
        }
    }

    /// Moves vertices where that must be.
    pub fn prepare(self, mesh: &Mesh, code_bits: CodeBits) -> Prepared<'_> {
        let config = |mesh| BuildConfig {
            nodes: self.nodes,
            mesh,
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
