//! The plan of a picture: what its hierarchies may leave out, and whether that pays.
//!
//! [`Plan::without_survey`] says whether anything can be gained at all. If so, [`survey`] looks at the mesh's surfaces,
//! [`Plan::new`] decides for the camera and for each light, and [`Hierarchies`] builds what was decided. Wherever rays go through a whole tree instead of a set, the same rule applies to what they hit: with a survey,
//! the picture does not depend on [`Switches::reduce`], the heat map aside.
//!
//! What is saved can be had or not, each by itself ([`Savings`]), and the picture stays the same.

mod cost;
mod decide;
mod explain;
mod group;
mod mesh_survey;
mod plan;
mod planner;
mod sample;
mod savings;
mod survey;
mod target;
mod trees;

pub use cost::Costs;
pub use plan::Plan;
pub use planner::{PlanConfig, Planner, Still};
pub use savings::{Saving, Savings};
pub use survey::{Survey, survey};
pub use target::{FacingSet, TargetKind, TreeChoice, ViewTarget};
pub use trees::Hierarchies;
pub(crate) use trees::Work;

use crate::{RenderSettings, Scene};

/// Whether triangles that face away from the eye or a light count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Cull {
    /// On closed surfaces seen from outside they do not.
    On,
    /// All triangles count.
    Off,
}

/// Whether trees are built without the triangles that do not count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Reduce {
    /// Where it saves time.
    #[default]
    Auto,
    /// Wherever anything may be left out.
    On,
    /// Nowhere.
    Off,
}

/// Where the triangles come from that stay in every set, because even rays from outside may meet them from behind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Seams {
    /// They are looked for, which takes a whole tree.
    #[default]
    Find,
    /// The caller promises that there are none: no closed part cuts itself or has an inverted lobe.
    None,
}

/// What the caller wants of the plan.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Switches {
    /// None where the plan decides: on where the surfaces are surveyed, else off.
    pub cull: Option<Cull>,
    /// Whether to build reduced trees.
    pub reduce: Reduce,
    /// Whether to look for seams.
    pub seams: Seams,
    /// What else may be saved.
    pub savings: Savings,
}

impl Switches {
    /// Whether they ask for trees without triangles that all count.
    #[must_use]
    pub fn is_contradiction(&self) -> bool {
        (self.cull, self.reduce) == (Some(Cull::Off), Reduce::On)
    }
}

/// What a plan is for. The scene's first camera is used.
#[derive(Clone, Copy, Debug)]
pub struct PlanRequest<'a> {
    /// Geometry, materials, camera and lights.
    pub scene: &'a Scene,
    /// How pictures are made.
    pub settings: &'a RenderSettings,
    /// What the caller wants.
    pub switches: Switches,
    /// How many frames share a survey. Each builds its own trees.
    pub frame_count: u32,
}
