//! The codecs and the kinds of trees to test.

use super::Effort;
use crate::oracle::distance::{length, minus};
use slimbvh::{
    BuildConfig, CodeBits, LatticeBits, Mesh, MeshCodec, NodeCodec, TreeKind, WideStore,
};
use std::borrow::Cow;

/// The storage of triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Triangles {
    Full,
    Leaf10,
    /// On a lattice whose step is 2^`coarser` times the finest.
    Lattice {
        coarser: i32,
    },
}

/// The storage of nodes and triangles, and the kind of tree over them.
#[derive(Clone, Copy, Debug)]
pub struct Storage {
    nodes: NodeCodec,
    triangles: Triangles,
    tree: TreeKind,
}

/// A mesh that is ready for a codec.
pub struct Prepared<'a> {
    /// The mesh, moved onto the lattice if there is one.
    pub mesh: Cow<'a, Mesh>,
    pub config: BuildConfig,
    /// The largest move of a vertex onto the lattice, and its bound.
    pub moved: Option<[f64; 2]>,
}

/// The finest lattice.
const FINEST: Triangles = Triangles::Lattice { coarser: 0 };

/// A lattice of 4096 points along the scene.
const COARSE: i32 = 12;

impl Storage {
    pub const PLAIN: Self = Self::nodes(NodeCodec::F32);
    pub const LATTICE: Self = Self::lattice(LatticeBits::Q10, 0);
    pub const WIDE: Self = Self::wide(WideStore::Packed, FINEST);

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

    const fn wide(store: WideStore, triangles: Triangles) -> Self {
        Self {
            triangles,
            ..Self::nodes(NodeCodec::Wide(store))
        }
    }

    const fn clustered(self) -> Self {
        Self {
            tree: TreeKind::Clustered,
            ..self
        }
    }

    /// The storages to test; on a GPU only those that it supports.
    pub fn all(effort: Effort, on_gpu: bool) -> Vec<Self> {
        let leaf10 = Self {
            triangles: Triangles::Leaf10,
            ..Self::nodes(NodeCodec::Paper10)
        };
        let coarse = Triangles::Lattice { coarser: COARSE };
        let mut all = vec![Self::PLAIN, leaf10];
        if !on_gpu {
            let q10 = NodeCodec::Lattice(LatticeBits::Q10);
            all.extend([Self::nodes(q10), Self::LATTICE, Self::PLAIN.clustered()]);
        }
        all.push(Self::wide(WideStore::Exact, Triangles::Full));
        all.push(Self::WIDE);
        all.push(Self::wide(WideStore::Packed, coarse));
        if effort == Effort::Full {
            all.push(Self::nodes(NodeCodec::Paper10));
            all.push(Self::wide(WideStore::Full, Triangles::Full));
            all.push(Self::wide(WideStore::Exact, FINEST));
            if !on_gpu {
                let others = LatticeBits::ALL.into_iter();
                let others = others.filter(|&bits| bits != LatticeBits::Q10);
                all.extend(others.map(|bits| Self::nodes(NodeCodec::Lattice(bits))));
                all.push(Self::lattice(LatticeBits::Q21, 0));
                all.push(Self::lattice(LatticeBits::Q10, COARSE));
                all.push(Self::LATTICE.clustered());
                all.push(Self::WIDE.clustered());
            }
        }
        all
    }

    /// The name in tables: the nodes, then the triangles unless in full precision, then the kind of tree unless radix.
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

    /// Prepares a mesh. Moves its vertices if the codec needs that.
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
        // Half a step on each axis, plus the rounding of the sum of squares.
        let bound = 0.75f64.sqrt() * 2f64.powi(step_exponent) * (1.0 + 4.0 * f64::EPSILON);
        Prepared {
            mesh: Cow::Owned(snapped),
            config: config(MeshCodec::Lattice { step_exponent }),
            moved: Some([moved, bound]),
        }
    }

    /// Whether the codec itself moves vertices.
    pub fn is_leaf10(self) -> bool {
        self.triangles == Triangles::Leaf10
    }
}
