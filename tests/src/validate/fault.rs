//! What can be wrong with a tree.

use thiserror::Error;

/// What [`super::validate`] finds.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum Fault {
    /// A child's index is beyond the nodes.
    #[error("node {node} names child {child}, which is not there")]
    NoSuchNode {
        /// The parent.
        node: u32,
        /// The index.
        child: u32,
    },
    /// A node is the child of two, or of one below it.
    #[error("node {node} has more than one parent")]
    SeveralParents {
        /// The child.
        node: u32,
    },
    /// No path from the root leads to a node.
    #[error("node {node} has no parent")]
    NoParent {
        /// The orphan.
        node: u32,
    },
    /// A node's run is not what its parent says, or its children do not divide it in two.
    #[error("node {node} does not cover the run of triangles that it should")]
    WrongRun {
        /// The node.
        node: u32,
    },
    /// A leaf has too many triangles, or none, or a node so few that they should be a leaf.
    #[error("a child of node {node} covers {count} triangles, wrong for what it is")]
    WrongCount {
        /// The parent.
        node: u32,
        /// How many.
        count: u32,
    },
    /// A child's box leaves out a part of the triangles below.
    #[error("a child's box in node {node} is too small")]
    BoxTooSmall {
        /// The parent.
        node: u32,
    },
    /// A child's box is larger than the triangles below.
    #[error("a child's box in node {node} is too large")]
    BoxTooLarge {
        /// The parent.
        node: u32,
    },
    /// A path from the root is too long.
    #[error("a path leads through more than {bound} nodes")]
    TooDeep {
        /// What was promised.
        bound: u32,
    },
    /// A leaf's triangle is not one of the mesh, or is there twice.
    #[error("place {place} holds primitive {primitive}, which is not there or there twice")]
    NotAPermutation {
        /// Where.
        place: u32,
        /// What.
        primitive: u32,
    },
    /// A leaf's triangle has other corners than the mesh's, at the scene's magnitude.
    #[error("place {place} has other corners than its primitive")]
    WrongCorners {
        /// Where.
        place: u32,
    },
    /// Codes descend, or equal codes are not in the order of their primitives.
    #[error("place {place} is out of order")]
    OutOfOrder {
        /// The second of the pair.
        place: u32,
    },
    /// A node is not divided where the codes' first differing bit changes.
    #[error("node {node} is divided at the wrong place")]
    WrongSplit {
        /// The node.
        node: u32,
    },
}
