//! Faults of a tree.

use thiserror::Error;

/// A fault that [`super::validate`] finds.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum Fault {
    /// A child's index is out of range.
    #[error("node {node} names child {child}, which is not there")]
    NoSuchNode {
        /// The parent.
        node: u32,
        /// The index.
        child: u32,
    },
    /// A node has two parents, or its parent lies below it.
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
    /// A node's run differs from the one in its parent, or its children do not divide it in two.
    #[error("node {node} does not cover the run of triangles that it should")]
    WrongRun {
        /// The node.
        node: u32,
    },
    /// A leaf has too many triangles or none, or an inner node has so few that it should be a leaf.
    #[error("a child of node {node} covers {count} triangles, wrong for what it is")]
    WrongCount {
        /// The parent.
        node: u32,
        /// The number of triangles.
        count: u32,
    },
    /// A child's box does not hold all triangles below.
    #[error("a child's box in node {node} is too small")]
    BoxTooSmall {
        /// The parent.
        node: u32,
    },
    /// A child's box is larger than the triangles below need.
    #[error("a child's box in node {node} is too large")]
    BoxTooLarge {
        /// The parent.
        node: u32,
    },
    /// A path from the root is too long.
    #[error("a path leads through more than {bound} nodes")]
    TooDeep {
        /// The depth bound.
        bound: u32,
    },
    /// A leaf's triangle is not one of the mesh's, or occurs twice.
    #[error("place {place} holds primitive {primitive}, which is not there or there twice")]
    NotAPermutation {
        /// Its place in leaf order.
        place: u32,
        /// Its primitive.
        primitive: u32,
    },
    /// A leaf's triangle has other corners than the mesh's, at the scene's magnitude.
    #[error("place {place} has other corners than its primitive")]
    WrongCorners {
        /// Its place in leaf order.
        place: u32,
    },
    /// Codes descend, or equal codes are not in the order of their primitives.
    #[error("place {place} is out of order")]
    OutOfOrder {
        /// The second of the pair.
        place: u32,
    },
    /// A node is not divided at the codes' first differing bit.
    #[error("node {node} is divided at the wrong place")]
    WrongSplit {
        /// The node.
        node: u32,
    },
}
