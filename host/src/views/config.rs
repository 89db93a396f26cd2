//! Settings and sizes of view sets.

use crate::BuildConfig;
use crate::animate::Update;
use crate::backend::TreeSize;
use crate::reduce::{PlanConfig, Still};

/// How frames are planned, built and updated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FrameConfig {
    /// How trees are built and stored.
    pub build: BuildConfig,
    /// What the trees leave out.
    pub plan: PlanConfig,
    /// How trees are updated from frame to frame.
    pub update: Update,
    /// Whether each change of the trees is followed by the cost of the tree for all rays, if that needs no wait. Trees
    /// whose cost has grown are rebuilt; without the cost, every eighth update rebuilds.
    pub finds_cost: bool,
}

impl FrameConfig {
    /// For about this many frames that share a survey of the surfaces. Trees are kept while nothing moves.
    #[must_use]
    pub fn for_frames(frame_count: u32) -> Self {
        let still = Still {
            vertices: true,
            lights: false,
        };
        Self {
            plan: PlanConfig {
                frame_count,
                still: Some(still),
                ..PlanConfig::default()
            },
            finds_cost: true,
            ..Self::default()
        }
    }
}

/// The sizes of a frame's trees.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FrameSizes {
    /// The sum of all trees that exist at the same time.
    pub total: TreeSize,
    /// The triangle count of each set, by the names of its targets.
    pub sets: Vec<(String, usize)>,
}
