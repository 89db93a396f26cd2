//! Scenes that break tracers, and what each tracer makes of them.
//!
//! [`cases`] makes families of scenes at magnitudes from denormal numbers to the largest, [`rays`] rays of every awkward kind
//! for each, and [`run`] lets a [`Tracer`] answer them. Its answers are judged ([`Judge`]) against exact ones
//! ([`crate::oracle`]), over the triangles that it has stored: on closed surfaces, from inside, without any tolerance;
//! elsewhere by a stated bound ([`BOUND_ULPS`]).

mod bound;
mod command;
mod families;
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

/// How much is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// For some seconds.
    Quick,
    /// For some minutes.
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
