//! Scenes and rays that are hard for tracers, and judgement of the tracers' answers.
//!
//! [`cases`] makes families of scenes at magnitudes from denormal numbers to the largest, [`rays`] makes awkward rays of
//! every kind for each, and [`run`] has a [`Tracer`] answer them. A [`Judge`] compares the answers with exact ones
//! ([`crate::oracle`]) over the triangles that the tracer stores: without tolerance from inside closed surfaces, and
//! elsewhere by a stated bound ([`BOUND_ULPS`]).

mod bound;
mod command;
mod families;
mod files;
mod judge;
mod moves;
mod rays;
mod recipe;
mod row;
mod run;
mod shapes;
mod slim;
#[cfg(feature = "gpu")]
mod slim_gpu;
mod stack;
mod storage;
mod subject;
mod surface;
#[cfg(test)]
mod tests;
mod tracer;

pub(crate) use command::{StressArguments, run as judge_all};

pub use bound::{BOUND_ULPS, LEAST_SHARE, ULP, bound, steepness};
pub use families::{Case, cases};
pub use judge::{Answer, Fault, Judge, Shot, Verdict};
pub use moves::{MoveError, Moves, moved, snapped};
pub use rays::{Rays, rays};
pub use recipe::{Aim, Face, Range, RayRecipe, Start};
pub use row::Row;
pub use run::run;
pub use slim::Cpu;
#[cfg(feature = "gpu")]
pub use slim_gpu::Gpu;
pub use subject::{Line, Subject};
pub use surface::Surface;
pub use tracer::{Failure, Outcome, Tracer, Tree};

/// The number of scenes, rays and codecs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// Takes some seconds.
    Quick,
    /// Takes some minutes.
    Full,
}

impl Effort {
    fn pick(self, quick: u32, full: u32) -> u32 {
        match self {
            Self::Quick => quick,
            Self::Full => full,
        }
    }
}
