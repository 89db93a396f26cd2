//! Moving scenes: cameras and lights on a circle, deforming meshes, and the upkeep of trees.
//!
//! An open [`Shutter`] blurs movement: a frame is then the mean of pictures at several times.
//!
//! All motions are periodic: frame `n + frame_count` equals frame `n`, and the last frame leads to the first as any frame
//! leads to the next.
//!
//! ```
//! use slimbvh::animate::{Animation, Deform, Motion};
//! # let mut scene = slimbvh::generate::default_scene();
//! let motion = Motion {
//!     frame_count: 48,
//!     orbit: true,
//!     deform: Some(Deform::Wave),
//!     ..Motion::default()
//! };
//! let animation = Animation::new(&scene, motion);
//! for frame in 0..48 {
//!     let vertices_moved = animation.pose(frame, &mut scene);
//!     assert!(vertices_moved);
//!     // Rebuild or refit, and render.
//! #   break;
//! }
//! ```

mod anchor;
mod deform;
mod motion;
mod shutter;
mod turn;
mod upkeep;

pub use crate::tree::sah_cost;
pub use deform::Deform;
pub use motion::{Animation, Motion};
pub use shutter::Shutter;
pub use upkeep::{Action, MOST_COST, MOST_REFITS, TRIAL_FRAMES, Update, Upkeep};
