//! What needs no clock: sizes, and what rays touch.

use super::prepared::Prepared;
use crate::measure::counts::{Counts, count};
use crate::measure::walks::Walks;
use crate::stress::{Moves, moved};
use anyhow::Result;
use slimbvh::reduce::{Planner, Saving, Savings};
use slimbvh::{Builder, Bvh, Cpu, CpuError, FrameConfig, Frames};

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
    /// Of the tree for rays from the eye: 1 for each node opened and 1 for each triangle tested (`slimbvh::sah_cost`).
    pub sah_cost: f64,
    pub counts: Counts,
    pub moves: Moves,
}

impl Facts {
    /// Builds all trees, none in turn, and follows all rays of the picture.
    pub fn new(prepared: &Prepared) -> Result<Self> {
        let (scene, settings) = (&prepared.scene, &prepared.settings);
        let savings = Savings::ALL.without(Saving::Turns);
        let mut planner = Planner::new(prepared.config, prepared.plan_config(savings));
        planner.survey::<CpuError>(scene, settings)?;
        let plan = planner.plan(scene, settings)?;
        let config = FrameConfig {
            build: prepared.config,
            ..FrameConfig::default()
        };
        let mut frames = Frames::new(Cpu, config);
        frames.build(scene, &plan)?;
        let all = || frames.hierarchies().all(&plan);
        let sum = |of: fn(&Bvh) -> usize| all().map(of).sum();
        let trees = frames.trees(&plan);
        let counts = count(&prepared.scene, &Walks::new(&trees)?, &prepared.settings)?;
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

    /// Of nodes and leaves, a triangle that is in a tree.
    pub fn bytes_a_triangle(&self) -> f64 {
        self.resident_bytes() as f64 / self.tree_triangles.max(1) as f64
    }

    /// Of all nodes and triangles in leaves.
    pub fn resident_bytes(&self) -> usize {
        self.node_bytes + self.triangle_bytes
    }
}
