//! In how many bytes hierarchies are stored.

use anyhow::{Result, bail};
use clap::{Args, ValueEnum};
use slimbvh::{LatticeBits, MeshCodec, NodeCodec, RenderSettings, Scene, Tolerance};

#[derive(Debug, Args)]
pub struct StorageArguments {
    /// How inner nodes are stored: in full, as printed in the literature (10 bits a plane), or in 4 to 21 bits on a lattice.
    /// The picture stays the same
    #[arg(long, value_enum, default_value_t = Nodes::Auto)]
    nodes: Nodes,

    /// How triangles are stored: in full, in 10 bits in their leaf's box as printed in the literature (surfaces crack), or on
    /// a lattice. Without it in full, or on a lattice where there is a --tolerance
    #[arg(long, value_enum)]
    mesh: Option<MeshKind>,

    /// How far vertices may move onto the lattice: a length, or pixels at the scene's nearest point, as in 0.5px. Without it
    /// as little as floats can tell
    #[arg(long, value_name = "LENGTH|Npx", value_parser = tolerance)]
    tolerance: Option<Tolerance>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Nodes {
    /// As the triangles need, else in full
    Auto,
    /// 64 bytes
    F32,
    /// 24 bytes
    Printed,
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
    /// 16 bytes a triangle; goes with printed nodes
    Leaf10,
    /// 16, 28 or 40 bytes a triangle, as each leaf needs; goes with nodes on a lattice
    Lattice,
}

/// Codecs, and what became of the mesh for them.
#[derive(Clone, Copy, Debug)]
pub struct Storage {
    pub nodes: NodeCodec,
    pub mesh: MeshCodec,
    /// How far a vertex moved at most, and how far it might have.
    pub moved: Option<(f32, f32)>,
}

impl StorageArguments {
    /// Decides, and moves the scene's vertices onto the lattice, if there is one.
    pub fn apply(&self, scene: &mut Scene, settings: &RenderSettings) -> Result<Storage> {
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
            (None, MeshKind::Leaf10) => NodeCodec::Printed,
            (None, MeshKind::Lattice) => NodeCodec::Lattice(LatticeBits::Q10),
        };
        match kind {
            MeshKind::Leaf10 if nodes != NodeCodec::Printed => {
                bail!("--mesh leaf10 goes with --nodes printed")
            }
            MeshKind::Lattice if !matches!(nodes, NodeCodec::Lattice(_)) => {
                bail!("--mesh lattice goes with --nodes q4 to q21")
            }
            _ => {}
        }
        let mut storage = Storage {
            nodes,
            mesh: MeshCodec::F32,
            moved: None,
        };
        match kind {
            MeshKind::F32 => {}
            MeshKind::Leaf10 => storage.mesh = MeshCodec::Leaf10,
            MeshKind::Lattice => {
                let asked = |tolerance: Tolerance| tolerance.step_exponent(scene, settings);
                let step_exponent = match self.tolerance {
                    Some(tolerance) => asked(tolerance),
                    None => Some(scene.mesh.finest_step()),
                };
                // Finer than floats: nothing moves, and nothing is gained.
                if let Some(step_exponent) = step_exponent {
                    let most = 0.866_026 * 2f32.powi(step_exponent);
                    storage.mesh = MeshCodec::Lattice { step_exponent };
                    storage.moved = Some((scene.mesh.snap(step_exponent), most));
                }
            }
        }
        Ok(storage)
    }
}

impl Nodes {
    fn codec(self) -> Option<NodeCodec> {
        let bits = match self {
            Self::Auto => return None,
            Self::F32 => return Some(NodeCodec::F32),
            Self::Printed => return Some(NodeCodec::Printed),
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

fn tolerance(text: &str) -> Result<Tolerance, String> {
    let (number, is_pixels) = match text.strip_suffix("px") {
        Some(number) => (number, true),
        None => (text, false),
    };
    match number.trim().parse::<f32>() {
        Ok(number) if number > 0.0 && number.is_finite() => Ok(if is_pixels {
            Tolerance::Pixels(number)
        } else {
            Tolerance::Length(number)
        }),
        _ => Err("it must be a length above 0, or pixels as in 0.5px".into()),
    }
}
