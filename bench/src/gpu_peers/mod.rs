//! Peers on the GPU: walks of our own over obvhs' trees, after the papers that describe them, with stacks in workgroup memory.
//!
//! They take slimbvh's rays, write slimbvh's hits, are recorded into the same frames, and are compiled with the same checks. The
//! triangle test is not watertight.

mod aila_laine;
mod cwbvh;
mod stopwatch;
mod tracer;
mod woop;

pub use stopwatch::Stopwatch;
pub use tracer::GpuPeer;

use crate::tracers::{Ploc, Tracer, Wide};
use anyhow::Result;
use glam::Vec4;
use obvhs::BvhBuildParams;
use obvhs::triangle::Triangle;
use slimbvh_core::launch::{GROUPS_PER_ROW, LANES};
use std::fmt;

/// The preset of both trees: obvhs' best that does not split triangles.
const PRESET: BvhBuildParams = BvhBuildParams::medium_build();

/// How a tree is walked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Walk {
    /// While-while over binary nodes of 64 bytes (Aila and Laine 2009).
    AilaLaine,
    /// Compressed nodes of eight children in 80 bytes (Ylitie, Karras and Laine 2017).
    Cwbvh,
}

impl fmt::Display for Walk {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        to.write_str(match self {
            Self::AilaLaine => "aila-laine",
            Self::Cwbvh => "cwbvh",
        })
    }
}

impl Walk {
    /// Both.
    pub const ALL: [Self; 2] = [Self::AilaLaine, Self::Cwbvh];

    /// The kernels `closest` and `any`, for a stack of this many rows.
    #[must_use]
    pub fn wgsl(self, stack_rows: u32) -> String {
        let walk = match self {
            Self::AilaLaine => include_str!("aila_laine.wgsl"),
            Self::Cwbvh => include_str!("cwbvh.wgsl"),
        };
        let frame = include_str!("frame.wgsl");
        let counts = format!(
            "const LANES = {LANES}u;\nconst GROUPS_PER_ROW = {GROUPS_PER_ROW}u;\nconst STACK_ROWS = {stack_rows}u;"
        );
        format!("{counts}\n{frame}\n{walk}")
    }

    /// Bytes of workgroup memory that a row of the stack takes: an entry for each lane.
    const fn row_bytes(self) -> u32 {
        let entry_bytes = match self {
            Self::AilaLaine => 4,
            Self::Cwbvh => 8,
        };
        entry_bytes * LANES as u32
    }
}

/// A tree as a walk reads it.
#[derive(Clone, Debug)]
pub struct PeerTree {
    /// The walk that reads it.
    pub walk: Walk,
    /// Rows of all nodes.
    pub nodes: Vec<[u32; 4]>,
    /// Three rows a triangle, in leaf order.
    pub triangles: Vec<Vec4>,
    /// The caller's number of each triangle in leaf order.
    pub numbers: Vec<u32>,
    /// Entries of the stack that no ray exceeds.
    pub stack_rows: u32,
}

impl PeerTree {
    /// Builds obvhs' tree with the preset `medium` in the rayon pool that calls it, and converts it.
    ///
    /// # Errors
    /// If there are no triangles, or too many for the walk.
    pub fn build(walk: Walk, triangles: &[Triangle]) -> Result<Self> {
        match walk {
            Walk::AilaLaine => {
                let mut tracer = Ploc::new("obvhs medium", PRESET, triangles);
                tracer.build()?;
                let (bvh, leaf_triangles) = tracer.tree();
                aila_laine::convert(bvh, leaf_triangles)
            }
            Walk::Cwbvh => {
                let mut tracer = Wide::new("obvhs cwbvh8 medium", PRESET, triangles);
                tracer.build()?;
                let (bvh, leaf_triangles) = tracer.tree();
                cwbvh::convert(bvh, leaf_triangles)
            }
        }
    }
}

/// The share of the Aila–Laine walk's rate on coherent rays from which the walk over compressed nodes counts as a peer.
pub const PEER_SHARE: f64 = 0.9;
