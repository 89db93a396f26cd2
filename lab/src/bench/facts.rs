//! What needs no clock: sizes, and what rays touch.

use super::prepared::Prepared;
use crate::measure::counts::{Counts, count};
use crate::measure::walks::Walks;
use crate::stress::{Moves, moved};
use anyhow::Result;
use slimbvh::reduce::{Saving, Savings};
use slimbvh::{Builder, Bvh, MeshCodec};
use slimbvh_cli::reduce;
use slimbvh_cli::render::job;

/// Of the trees of a picture, the same on every machine.
pub struct Facts {
    /// How many there are.
    pub trees: usize,
    pub mesh_triangles: usize,
    /// Triangles in all of them.
    pub tree_triangles: usize,
    /// Bytes of all nodes.
    pub node_bytes: usize,
    /// Bytes of all triangles in leaves.
    pub triangle_bytes: usize,
    /// Of the tree for rays from the eye: 1 for each node opened and 1 for each triangle tested (`slimbvh::animate::sah_cost`).
    pub sah_cost: f64,
    pub counts: Counts,
    pub moves: Moves,
}

impl Facts {
    /// Builds all trees, none in turn, and follows all rays of the picture.
    pub fn new(prepared: &Prepared) -> Result<Self> {
        let mut cpu = job::Cpu::new(prepared.config);
        let mut room = None;
        let asked = prepared.asked(Savings::ALL.without(Saving::Turns));
        let (plan, _) = reduce::plan(&asked, prepared.config, &mut room)?;
        cpu.build(&prepared.scene.mesh, &plan)?;
        let sum = |of: fn(&Bvh) -> usize| cpu.all(&plan).map(of).sum();
        let trees = cpu.trees(&plan);
        let counts = count(&prepared.scene, &Walks::new(&trees)?, &prepared.settings)?;
        let primary = trees.primary.bvh;
        let moves = match prepared.config.mesh {
            MeshCodec::Leaf10 => {
                let mut builder = Builder::new(prepared.config.code_bits.into());
                let plain = builder.build(&prepared.scene.mesh)?;
                moved(&plain, &primary.decoded())?
            }
            MeshCodec::F32 | MeshCodec::Lattice { .. } => prepared.moves,
        };
        Ok(Self {
            trees: cpu.all(&plan).count(),
            mesh_triangles: prepared.scene.mesh.indices.len(),
            tree_triangles: sum(Bvh::triangle_count),
            node_bytes: sum(Bvh::node_bytes),
            triangle_bytes: sum(Bvh::triangle_bytes),
            sah_cost: primary.sah_cost(),
            counts,
            moves,
        })
    }

    /// Of nodes and leaves, a triangle that is in a tree.
    pub fn bytes_a_triangle(&self) -> f64 {
        self.resident_bytes() as f64 / self.tree_triangles.max(1) as f64
    }

    /// Of all nodes and triangles in leaves.
    pub fn resident_bytes(&self) -> usize {
        self.node_bytes + self.triangle_bytes
    }
}
