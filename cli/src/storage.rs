//! In how many bytes hierarchies are stored.

use super::output::bytes;
use super::reduce::ReduceArguments;
use crate::options;
use anyhow::{Result, bail};
use clap::{Args, ValueEnum};
use slimbvh::{
    BuildConfig, CodeBits, LatticeBits, Mesh, MeshCodec, NodeCodec, RenderSettings, Scene,
    Tolerance, TreeKind,
};

#[derive(Debug, Args)]
pub struct StorageArguments {
    /// How inner nodes are stored: in full, as in the paper on compressed hierarchies (10 bits a plane), or in 4 to 21 bits on a lattice.
    /// The picture stays the same
    #[arg(long, value_enum, default_value_t = Nodes::Auto)]
    nodes: Nodes,

    /// How triangles are stored: in full, in 10 bits in their leaf's box as in the paper on compressed hierarchies (surfaces crack), or on
    /// a lattice. Without it in full, or on a lattice where there is a --tolerance
    #[arg(long, value_enum)]
    mesh: Option<MeshKind>,

    /// How far vertices may move onto the lattice: a length, or pixels at the scene's nearest point, as in 0.5px. Without it
    /// as little as floats can tell
    #[arg(long, value_name = "LENGTH|Npx", value_parser = options::tolerance)]
    tolerance: Option<Tolerance>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Nodes {
    /// As the triangles need, else in full
    Auto,
    /// 64 bytes
    F32,
    /// 24 bytes
    Paper10,
    /// 12 bytes
    Q4,
    /// 16 bytes
    Q6,
    /// 16 bytes
    Q8,
    /// 16 bytes
    Q10,
    /// 20 bytes
    Q12,
    /// 28 bytes
    Q16,
    /// 28 bytes
    Q21,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum MeshKind {
    /// 40 bytes a triangle
    F32,
    /// 16 bytes a triangle; goes with paper10 nodes
    Leaf10,
    /// 16, 28 or 40 bytes a triangle, as each leaf needs; goes with nodes on a lattice
    Lattice,
}

/// The codecs of a picture's trees.
#[derive(Clone, Copy, Debug)]
pub struct Storage {
    pub nodes: NodeCodec,
    pub mesh: MeshCodec,
}

impl StorageArguments {
    /// Refuses what cannot be had together.
    pub fn check(&self) -> Result<()> {
        self.kinds().map(|_| ())
    }

    /// Refuses reduction where triangles are not those that it was decided for.
    pub fn check_reduction(&self, reduce: &ReduceArguments) -> Result<()> {
        let (_, kind) = self.kinds()?;
        if kind == MeshKind::Leaf10 && reduce.is_asked_for() {
            bail!(
                "--mesh leaf10 moves triangles after it was decided which may be left out; leave --reduce on and --cull on out"
            );
        }
        Ok(())
    }

    /// Refuses to ask for another tree than a file has, whose codecs these are.
    pub fn check_saved(&self, codecs: (NodeCodec, MeshCodec), name: &str) -> Result<()> {
        if self.tolerance.is_some() {
            bail!(
                "--tolerance moves vertices before a build; \"{name}\" is built already, leave it out"
            );
        }
        let [nodes, mesh] = names(codecs);
        if self.nodes.codec().is_some_and(|asked| asked != codecs.0) {
            bail!(
                "\"{name}\" has nodes of {nodes}, --nodes asks for others; leave it out, or build the scene again"
            );
        }
        let asked = self.mesh.map(|kind| match kind {
            MeshKind::F32 => "f32",
            MeshKind::Leaf10 => "leaf10",
            MeshKind::Lattice => "lattice",
        });
        if asked.is_some_and(|asked| asked != mesh) {
            bail!(
                "\"{name}\" has triangles of {mesh}, --mesh asks for others; leave it out, or build the scene again"
            );
        }
        Ok(())
    }

    /// Whether nothing may be left out, nor passed over.
    #[must_use]
    pub fn forbids_reduction(&self) -> bool {
        self.mesh == Some(MeshKind::Leaf10)
    }

    fn kinds(&self) -> Result<(NodeCodec, MeshKind)> {
        let kind = match (self.mesh, self.tolerance) {
            (Some(MeshKind::F32 | MeshKind::Leaf10), Some(_)) => {
                bail!("--tolerance moves vertices onto a lattice; it goes with --mesh lattice")
            }
            (Some(kind), _) => kind,
            (None, Some(_)) => MeshKind::Lattice,
            (None, None) => MeshKind::F32,
        };
        let nodes = match (self.nodes.codec(), kind) {
            (Some(codec), _) => codec,
            (None, MeshKind::F32) => NodeCodec::F32,
            (None, MeshKind::Leaf10) => NodeCodec::Paper10,
            (None, MeshKind::Lattice) => NodeCodec::Lattice(LatticeBits::Q10),
        };
        match kind {
            MeshKind::Leaf10 if nodes != NodeCodec::Paper10 => {
                bail!("--mesh leaf10 goes with --nodes paper10")
            }
            MeshKind::Lattice if !matches!(nodes, NodeCodec::Lattice(_)) => {
                bail!("--mesh lattice goes with --nodes q4 to q21")
            }
            _ => Ok((nodes, kind)),
        }
    }

    /// Decides, and moves the scene's vertices onto the lattice, if there is one.
    pub fn apply(&self, scene: &mut Scene, settings: &RenderSettings) -> Result<Storage> {
        let step_exponent = self.step_exponent(scene, settings);
        let storage = self.on_lattice(step_exponent)?;
        storage.snap(scene);
        Ok(storage)
    }

    /// As [`Self::apply`] for a scene that is posed in turn, whose vertices may move: one lattice for all poses, which each of
    /// them must be moved onto.
    pub fn for_all(
        &self,
        settings: &RenderSettings,
        times: impl Iterator<Item = f64>,
        mut pose: impl FnMut(f64, &mut Scene),
        scene: &mut Scene,
    ) -> Result<Storage> {
        if self.kinds()?.1 != MeshKind::Lattice {
            return self.on_lattice(None);
        }
        let (mut finest, mut wanted) = (i32::MIN, Some(i32::MAX));
        for time in times {
            pose(time, scene);
            finest = finest.max(scene.mesh.finest_step());
            let here = self.step_exponent(scene, settings);
            wanted = here.zip(wanted).map(|(here, wanted)| wanted.min(here));
        }
        self.on_lattice(Some(wanted.map_or(finest, |wanted| wanted.max(finest))))
    }

    /// The lattice's step for the scene as it is; none where it would be finer than floats.
    fn step_exponent(&self, scene: &Scene, settings: &RenderSettings) -> Option<i32> {
        match self.tolerance {
            Some(tolerance) => tolerance.step_exponent(scene, settings),
            None => Some(scene.mesh.finest_step()),
        }
    }

    /// With a lattice of this step; without one nothing moves, and nothing is gained.
    fn on_lattice(&self, step_exponent: Option<i32>) -> Result<Storage> {
        let (nodes, kind) = self.kinds()?;
        let mesh = match (kind, step_exponent) {
            (MeshKind::F32, _) | (MeshKind::Lattice, None) => MeshCodec::F32,
            (MeshKind::Leaf10, _) => MeshCodec::Leaf10,
            (MeshKind::Lattice, Some(step_exponent)) => MeshCodec::Lattice { step_exponent },
        };
        Ok(Storage { nodes, mesh })
    }
}

impl Storage {
    /// Moves a scene's vertices onto the lattice, if there is one.
    pub fn snap(&self, scene: &mut Scene) {
        if let MeshCodec::Lattice { step_exponent } = self.mesh {
            scene.mesh.snap(step_exponent);
        }
    }

    /// How to build.
    #[must_use]
    pub fn config(&self, code_bits: CodeBits, tree: TreeKind) -> BuildConfig {
        BuildConfig {
            code_bits,
            tree,
            nodes: self.nodes,
            mesh: self.mesh,
        }
    }
}

/// How long the lists of a hierarchy and its mesh are.
#[derive(Clone, Copy, Debug)]
pub struct Sizes {
    pub triangle_count: usize,
    pub node_bytes: usize,
    pub triangle_bytes: usize,
    pub mesh_bytes: usize,
    pub scratch_bytes: usize,
}

impl Sizes {
    /// For people.
    #[must_use]
    pub fn describe(&self) -> String {
        let per_triangle = |bytes: usize| bytes as f64 / self.triangle_count.max(1) as f64;
        format!(
            "{} nodes ({:.1} a triangle), {} leaf triangles ({:.1}), {} mesh, {} scratch",
            bytes(self.node_bytes),
            per_triangle(self.node_bytes),
            bytes(self.triangle_bytes),
            per_triangle(self.triangle_bytes),
            bytes(self.mesh_bytes),
            bytes(self.scratch_bytes)
        )
    }
}

/// Bytes of a mesh's lists.
#[must_use]
pub fn mesh_bytes(mesh: &Mesh) -> usize {
    size_of_val(mesh.vertices.as_slice())
        + size_of_val(mesh.indices.as_slice())
        + size_of_val(mesh.normals.as_slice())
        + size_of_val(mesh.materials.as_slice())
}

/// Codecs as the options name them.
#[must_use]
pub fn names((nodes, mesh): (NodeCodec, MeshCodec)) -> [&'static str; 2] {
    let nodes = match nodes {
        NodeCodec::F32 => "f32",
        NodeCodec::Paper10 => "paper10",
        NodeCodec::Lattice(LatticeBits::Q4) => "q4",
        NodeCodec::Lattice(LatticeBits::Q6) => "q6",
        NodeCodec::Lattice(LatticeBits::Q8) => "q8",
        NodeCodec::Lattice(LatticeBits::Q10) => "q10",
        NodeCodec::Lattice(LatticeBits::Q12) => "q12",
        NodeCodec::Lattice(LatticeBits::Q16) => "q16",
        NodeCodec::Lattice(LatticeBits::Q21) => "q21",
    };
    let mesh = match mesh {
        MeshCodec::F32 => "f32",
        MeshCodec::Leaf10 => "leaf10",
        MeshCodec::Lattice { .. } => "lattice",
    };
    [nodes, mesh]
}

/// Codecs for people.
#[must_use]
pub fn describe(codecs: (NodeCodec, MeshCodec)) -> String {
    let [nodes, mesh] = names(codecs);
    let step = match codecs.1 {
        MeshCodec::Lattice { step_exponent } => format!(" of step 2^{step_exponent}"),
        MeshCodec::F32 | MeshCodec::Leaf10 => String::new(),
    };
    format!("nodes {nodes}, triangles {mesh}{step}")
}

impl Nodes {
    fn codec(self) -> Option<NodeCodec> {
        let bits = match self {
            Self::Auto => return None,
            Self::F32 => return Some(NodeCodec::F32),
            Self::Paper10 => return Some(NodeCodec::Paper10),
            Self::Q4 => LatticeBits::Q4,
            Self::Q6 => LatticeBits::Q6,
            Self::Q8 => LatticeBits::Q8,
            Self::Q10 => LatticeBits::Q10,
            Self::Q12 => LatticeBits::Q12,
            Self::Q16 => LatticeBits::Q16,
            Self::Q21 => LatticeBits::Q21,
        };
        Some(NodeCodec::Lattice(bits))
    }
}
