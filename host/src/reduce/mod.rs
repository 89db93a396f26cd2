//! The plan of a picture: which triangles its hierarchies leave out, and where that pays.
//!
//! [`Plan::without_survey`] returns a plan if a survey cannot pay. Otherwise [`survey`] examines the mesh's surfaces,
//! [`Plan::new`] decides for the camera and for each light, and [`Hierarchies`] builds the trees. Rays through a whole tree
//! obey the same facing filter as rays through a set. So with a survey the picture does not depend on [`Switches::reduce`],
//! except in the heatmap view.
//!
//! Each of the [`Savings`] can be turned off; the picture stays the same.

mod cost;
mod decide;
mod explain;
mod group;
mod mesh_survey;
mod plan;
mod planner;
mod sample;
mod savings;
mod set;
mod set_memory;
mod survey;
mod target;
mod trees;

pub use cost::Costs;
pub use plan::Plan;
pub use planner::{PlanConfig, Planner, Still};
pub use savings::{Saving, Savings};
pub use set::{FacingSet, TreeChoice, ViewSet};
pub use set_memory::SetMemory;
pub use survey::{Survey, survey};
pub use target::{TargetKind, ViewTarget, Views};
pub use trees::Hierarchies;
pub(crate) use trees::Work;

use crate::{RenderSettings, Scene, ViewError};

/// Whether rays may hit triangles that face away from the camera or the light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Cull {
    /// Not on closed surfaces seen from outside.
    On,
    /// All triangles can be hit.
    Off,
}

/// Whether trees are built without the triangles that rays cannot hit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Reduce {
    /// If the cost model predicts a gain.
    #[default]
    Auto,
    /// If any triangle may be left out.
    On,
    /// Never.
    Off,
}

/// How seam triangles are found. They stay in every set, because even rays from outside may hit them from behind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Seams {
    /// By a search, which needs a whole tree.
    #[default]
    Find,
    /// Not at all: the caller promises that no closed part intersects itself or has an inverted lobe.
    None,
}

/// The caller's settings of a plan.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Switches {
    /// `None`: on if the surfaces are surveyed, else off.
    pub cull: Option<Cull>,
    /// Whether to build reduced trees.
    pub reduce: Reduce,
    /// Whether to search for seams.
    pub seams: Seams,
    /// The savings allowed.
    pub savings: Savings,
}

impl Switches {
    /// Whether the settings contradict each other: reduced trees, but no culling.
    #[must_use]
    pub fn is_contradiction(&self) -> bool {
        (self.cull, self.reduce) == (Some(Cull::Off), Reduce::On)
    }
}

/// The input of a plan.
#[derive(Clone, Debug)]
pub struct PlanRequest {
    /// The number of triangles in the mesh.
    pub triangle_count: usize,
    /// The rays.
    pub views: Views,
    /// The caller's settings.
    pub switches: Switches,
    /// The number of frames that share a survey. Each builds its own trees.
    pub frame_count: u32,
}

impl PlanRequest {
    /// The request of one picture.
    ///
    /// # Errors
    /// For cameras and lights that cannot be rendered.
    pub fn of_picture(
        scene: &Scene,
        settings: &RenderSettings,
        switches: Switches,
    ) -> Result<Self, ViewError> {
        Ok(Self {
            triangle_count: scene.mesh.indices.len(),
            views: Views::of_picture(scene, settings)?,
            switches,
            frame_count: 1,
        })
    }
}
