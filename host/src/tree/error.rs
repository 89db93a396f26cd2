//! What can be wrong with a hierarchy.

use thiserror::Error;

/// What [`Bvh::validate`](crate::Bvh::validate) finds.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum TreeError {
    /// There is nothing.
    #[error("the hierarchy has no root; build it first")]
    NoRoot,
    /// More triangles than can be numbered, or than the mesh has.
    #[error(
        "the hierarchy has {triangle_count} triangles of a mesh of {mesh_triangle_count}, of which at most {limit} can be numbered"
    )]
    TriangleCount {
        /// Triangles of the hierarchy.
        triangle_count: usize,
        /// Triangles of the mesh that it says it was built over.
        mesh_triangle_count: usize,
        /// The largest number for both.
        limit: usize,
    },
    /// The bounds are not finite, or inverted, or not there though there are triangles.
    #[error("the box around the mesh is not one")]
    Bounds,
    /// Coordinates are not at magnitude 1.
    #[error("the scene's exponent is {exponent}; by its bounds it must be {expected}")]
    SceneExponent {
        /// What is there.
        exponent: i32,
        /// What follows from the bounds.
        expected: i32,
    },
    /// The traversal's stack may be too small.
    #[error("paths of up to {bound} nodes are announced; at most {limit} can be traced")]
    DepthBound {
        /// What is there.
        bound: u32,
        /// The largest.
        limit: u32,
    },
    /// The lattice's step is no number.
    #[error("the lattice has a step of 2^{step_exponent}; floats reach from 2^-126 to 2^127")]
    Step {
        /// The step is 2 to this power, at the scene's magnitude.
        step_exponent: i32,
    },
    /// The box that all others are decoded from is not in the scene, or has more steps than floats can count.
    #[error("the root's box is not one that boxes can be decoded from")]
    RootBox,
    /// A child is not where it must be: below the root, nodes lie in the order of their triangles, each left child right
    /// before the right one. So each node has one parent.
    #[error("node {node} names node {child} as a child, which is not there or has another place")]
    ChildOutOfPlace {
        /// The parent.
        node: u32,
        /// The index.
        child: u32,
    },
    /// No path from the root leads to a node.
    #[error("no path from the root leads to node {node}")]
    NoParent {
        /// The first orphan.
        node: u32,
    },
    /// A path from the root is too long.
    #[error("the path to node {node} leads through more than {bound} nodes")]
    TooDeep {
        /// The node.
        node: u32,
        /// What was promised.
        bound: u32,
    },
    /// A leaf has too many triangles, or none.
    #[error("a leaf of node {node} has {count} triangles; it must have 1 to {limit}")]
    LeafSize {
        /// The parent.
        node: u32,
        /// How many.
        count: u32,
        /// The most.
        limit: u32,
    },
    /// An inner node has so few triangles that they must be a leaf.
    #[error("node {node} has {count} triangles below it; so few are a leaf")]
    NodeSize {
        /// The node.
        node: u32,
        /// How many.
        count: u32,
    },
    /// A leaf does not begin where the one before it ends.
    #[error("a leaf of node {node} begins at place {first}; the one before it ends at {expected}")]
    LeafOutOfPlace {
        /// The parent.
        node: u32,
        /// Where it begins.
        first: u32,
        /// Where it should.
        expected: u32,
    },
    /// A leaf reaches beyond the triangles, or some are in no leaf.
    #[error("leaves end at place {end}; there are {count}")]
    PlaceCount {
        /// Where the last leaf looked at ends.
        end: u64,
        /// How many places there are.
        count: usize,
    },
    /// The leaves have another number of triangles than the hierarchy says.
    #[error("there are {found} triangles in leaves, {expected} are announced")]
    LeafCount {
        /// In leaves.
        found: u32,
        /// Announced.
        expected: usize,
    },
    /// A node does not cover the triangles that its leaves have.
    #[error("node {node} says that it covers triangles {first} to {last}, which it does not")]
    WrongRun {
        /// The node.
        node: u32,
        /// Its first triangle.
        first: u32,
        /// Its last triangle.
        last: u32,
    },
    /// A child's box is inverted, not finite, or larger than the scene can be.
    #[error("a child of node {node} has a box that is not one of the scene")]
    BadBox {
        /// The parent.
        node: u32,
    },
    /// A child's box leaves out a part of the triangles below: rays would miss them.
    #[error("a child of node {node} has a box that leaves out some of what is below it")]
    BoxTooSmall {
        /// The parent.
        node: u32,
    },
    /// A triangle in a leaf has a corner that is NaN or infinite.
    #[error("the triangle at place {place} has a corner that is not finite")]
    NotFinite {
        /// Where, in leaf order; on the lattice in words.
        place: u32,
    },
    /// A leaf's triangle is not one of the mesh, or is there twice.
    #[error(
        "the triangle at place {place} is the mesh's number {primitive}, which is not there or there twice"
    )]
    BadPrimitive {
        /// Where, in leaf order; on the lattice in words.
        place: u32,
        /// Its number in the mesh.
        primitive: u32,
    },
    /// It is a hierarchy over another mesh.
    #[error("the mesh has {triangle_count} triangles, the hierarchy was built over {expected}")]
    OtherMesh {
        /// Triangles of the mesh.
        triangle_count: usize,
        /// Triangles that the hierarchy was built over.
        expected: usize,
    },
    /// The mesh has moved since.
    #[error("the mesh has other bounds than the hierarchy")]
    OtherBounds,
    /// A leaf's triangle is not the mesh's.
    #[error("the triangle at place {place} has other corners than the mesh's number {primitive}")]
    OtherCorners {
        /// Where, in leaf order; on the lattice in words.
        place: u32,
        /// Its number in the mesh.
        primitive: u32,
    },
}
