//! Faults of a hierarchy.

use crate::MeshError;
use thiserror::Error;

/// The faults that [`Bvh::validate`](crate::Bvh::validate) finds.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum TreeError {
    /// There is no node.
    #[error("the hierarchy has no root; build it first")]
    NoRoot,
    /// More triangles than can be numbered, or than the mesh has.
    #[error(
        "the hierarchy has {triangle_count} triangles of a mesh of {mesh_triangle_count}, of which at most {limit} can be numbered"
    )]
    TriangleCount {
        /// Triangles of the hierarchy.
        triangle_count: usize,
        /// Triangles of the mesh that it was built over, as stored.
        mesh_triangle_count: usize,
        /// The largest number of either.
        limit: usize,
    },
    /// The bounds are not finite, inverted, or missing though there are triangles.
    #[error("the box around the mesh is not one")]
    Bounds,
    /// The exponent does not bring coordinates to magnitude 1.
    #[error("the scene's exponent is {exponent}; by its bounds it must be {expected}")]
    SceneExponent {
        /// The exponent, as stored.
        exponent: i32,
        /// The exponent that follows from the bounds.
        expected: i32,
    },
    /// Paths may be longer than the traversal's stack.
    #[error("paths of up to {bound} nodes are announced; at most {limit} can be traced")]
    DepthBound {
        /// The depth bound, as stored.
        bound: u32,
        /// The largest depth bound.
        limit: u32,
    },
    /// The lattice's step is not a normal float.
    #[error("the lattice has a step of 2^{step_exponent}; floats reach from 2^-126 to 2^127")]
    Step {
        /// The step is 2 to this power, at the scene's magnitude.
        step_exponent: i32,
    },
    /// The root's box is not in the scene, or has more steps than floats can count.
    #[error("the root's box is not one that boxes can be decoded from")]
    RootBox,
    /// A child is out of order. Below the root, nodes lie in the order of their triangles, each left child right before
    /// the right one, so that each node has one parent.
    #[error("node {node} names node {child} as a child, which is not there or has another place")]
    ChildOutOfPlace {
        /// The parent.
        node: u32,
        /// The child's index.
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
        /// The depth bound, as stored.
        bound: u32,
    },
    /// A leaf has too many triangles, or none.
    #[error("a leaf of node {node} has {count} triangles; it must have 1 to {limit}")]
    LeafSize {
        /// The parent.
        node: u32,
        /// Its number of triangles.
        count: u32,
        /// The largest number.
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
        /// Its first place.
        first: u32,
        /// The place after the leaf before it.
        expected: u32,
    },
    /// A leaf ends beyond the list of triangles, or some triangles are in no leaf.
    #[error("leaves end at place {end}; there are {count}")]
    PlaceCount {
        /// The end of the last leaf checked.
        end: u64,
        /// The number of places.
        count: usize,
    },
    /// The leaves hold another number of triangles than the hierarchy stores.
    #[error("there are {found} triangles in leaves, {expected} are announced")]
    LeafCount {
        /// Triangles in leaves.
        found: u32,
        /// Triangles of the hierarchy, as stored.
        expected: usize,
    },
    /// A node stores another run of triangles than that of its leaves.
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
    /// A child's box does not contain the triangles below it: rays would miss them.
    #[error("a child of node {node} has a box that leaves out some of what is below it")]
    BoxTooSmall {
        /// The parent.
        node: u32,
    },
    /// A triangle in a leaf has a corner that is NaN or infinite.
    #[error("the triangle at place {place} has a corner that is not finite")]
    NotFinite {
        /// Its place in leaf order; on the lattice in words.
        place: u32,
    },
    /// A leaf's triangle is not one of the mesh, or occurs twice.
    #[error(
        "the triangle at place {place} is the mesh's number {primitive}, which is not there or there twice"
    )]
    BadPrimitive {
        /// Its place in leaf order; on the lattice in words.
        place: u32,
        /// Its number in the mesh.
        primitive: u32,
    },
    /// The mesh has another number of triangles than that of the build.
    #[error("the mesh has {triangle_count} triangles, the hierarchy was built over {expected}")]
    OtherMesh {
        /// Triangles of the mesh.
        triangle_count: usize,
        /// Triangles that the hierarchy was built over.
        expected: usize,
    },
    /// The mesh has moved since the build.
    #[error("the mesh has other bounds than the hierarchy")]
    OtherBounds,
    /// A leaf's triangle has other corners than the mesh's.
    #[error("the triangle at place {place} has other corners than the mesh's number {primitive}")]
    OtherCorners {
        /// Its place in leaf order; on the lattice in words.
        place: u32,
        /// Its number in the mesh.
        primitive: u32,
    },
}

/// Why a hierarchy cannot be moved to a mesh.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum RefitError {
    /// The mesh itself is unfit.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// It is another mesh.
    #[error("the mesh has {triangle_count} triangles, the hierarchy {expected}; build a new one")]
    TriangleCount {
        /// Triangles of the mesh.
        triangle_count: usize,
        /// Triangles of the hierarchy.
        expected: usize,
    },
    /// It leaves out triangles that may be needed now.
    #[error("the hierarchy is reduced; build it again when the triangles have moved")]
    Reduced,
}
