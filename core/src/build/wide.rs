//! Stage `wide`: nodes of up to four children, collapsed from a binary tree.
//!
//! A wide node begins as the two children of a binary node. Twice, the inner child whose box has the largest surface gives way
//! to its own two children (Wald, Benthin and Boulos 2008, "Getting Rid of Packets", section 3). Leaves stay as they are, and
//! children in the order of their triangles. So each binary node either begins a wide node or is dissolved in one.
//!
//! No order among the nodes, no atomics, no level after the other:
//! 1. [`collapse`]: which nodes a wide one takes in, for each binary node as if one began there;
//! 2. [`wide_origin`]: by a walk from the root, whether one begins there, and as which child of which;
//! 3. an exclusive scan of the numbers of inner children ([`Begins`]): where each wide node comes, the root first;
//! 4. [`wide_children`] and [`placed`]: its children, for an encoder.
#![allow(
    clippy::needless_range_loop,
    reason = "iterator chains do not compile to SPIR-V"
)]

mod children;
mod collapse;
mod origin;

pub use children::{WideChild, WideChildren, placed, wide_children};
pub use collapse::{Collapse, collapse, collapsed};
pub use origin::{Begins, Origin, most_wide_nodes, wide_origin};

/// Children of a wide node, at most.
pub const WIDTH: usize = 4;

#[cfg(test)]
mod tests;
