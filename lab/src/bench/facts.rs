//! Results without times: sizes of trees, and counts of tests by rays.

use super::prepared::Prepared;
use crate::measure::counts::{Counts, count};
use crate::measure::walks::Walks;
use crate::stress::{Moves, moved};
use anyhow::Result;
use slimbvh::reduce::{Saving, Savings};
use slimbvh::{Builder, Bvh, Cpu, FrameConfig, Frames};

/// Sizes and counts of a picture's trees, the same on every machine.
pub struct Facts {
    /// The number of trees.
    pub trees: usize,
    pub mesh_triangles: usize,
    /// Triangles in all trees.
    pub tree_triangles: usize,
    /// Bytes of all nodes.
    pub node_bytes: usize,
    /// Bytes of all triangles in leaves.
    pub triangle_bytes: usize,
    /// The cost of the camera's tree by the surface area heuristic: 1 a node opened, 1 a triangle tested (`slimbvh::sah_cost`).
    pub sah_cost: f64,
    pub counts: Counts,
    pub moves: Moves,
}

impl Facts {
    /// Builds all trees at once, without [`Saving::Turns`], and traces all rays of the picture.
    pub fn new(prepared: &Prepared) -> Result<Self> {
        let plan = prepared.plan(Savings::ALL.without(Saving::Turns))?;
        let config = FrameConfig {
            build: prepared.config,
            ..FrameConfig::default()
        };
        let mut frames = Frames::new(Cpu, config);
        frames.build(&prepared.scene, &plan)?;
        let all = || frames.views().hierarchies().all(&plan);
        let sum = |of: fn(&Bvh) -> usize| all().map(of).sum();
        let trees = frames.trees(&plan);
        let counts = count(&prepared.scene, &Walks::new(&trees), &prepared.settings)?;
        let primary = trees.primary.bvh;
        let moves = if prepared.config.mesh.moves_vertices() {
            let mut builder = Builder::new(prepared.config.code_bits.into());
            let plain = builder.build(&prepared.scene.mesh)?;
            moved(&plain, &primary.decoded())?
        } else {
            prepared.moves
        };
        Ok(Self {
            trees: all().count(),
            mesh_triangles: prepared.scene.mesh.indices.len(),
            tree_triangles: sum(Bvh::triangle_count),
            node_bytes: sum(Bvh::node_bytes),
            triangle_bytes: sum(Bvh::triangle_bytes),
            sah_cost: primary.sah_cost(),
            counts,
            moves,
        })
    }

    /// [`Self::resident_bytes`] for each triangle in a tree.
    pub fn bytes_a_triangle(&self) -> f64 {
        self.resident_bytes() as f64 / self.tree_triangles.max(1) as f64
    }

    /// Bytes of all nodes and of all triangles in leaves.
    pub fn resident_bytes(&self) -> usize {
        self.node_bytes + self.triangle_bytes
    }
}
