//! Faults of a hierarchy and of a refit.

use crate::MeshError;
use thiserror::Error;

/// The faults that [`Bvh::validate`](crate::Bvh::validate) finds.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum TreeError {
    /// The hierarchy has no node.
    #[error("the hierarchy has no root; build it first")]
    NoRoot,
    /// More triangles than node references can index, or than the mesh has.
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
    #[error("the box around the mesh is not a valid box")]
    Bounds,
    /// The exponent does not scale coordinates to magnitude 1.
    #[error("the scene's exponent is {exponent}; by its bounds it must be {expected}")]
    SceneExponent {
        /// The exponent, as stored.
        exponent: i32,
        /// The exponent that follows from the bounds.
        expected: i32,
    },
    /// Paths may exceed the traversal's stack.
    #[error("the depth bound is {bound} nodes; at most {limit} can be traced")]
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
    /// The root's box lies outside the scene, or has more steps than floats can count.
    #[error("no boxes can be decoded from the root's box")]
    RootBox,
    /// More wide nodes than the traversal's stack can name.
    #[error("the hierarchy has {count} wide nodes, of which at most {limit} can be numbered")]
    WideNodeCount {
        /// The number of nodes.
        count: usize,
        /// The largest number.
        limit: usize,
    },
    /// A node's frame is not the one that its children have: an origin off the lattice or outside the parent's box, a shift and an
    /// extent that do not fit, planes of a child that is not there, or padding that is not zero.
    #[error("node {node} has a frame that no children have")]
    BadFrame {
        /// The node.
        node: u32,
    },
    /// A node's links are of an unknown kind, have a child after one that is not there, or a run without children.
    #[error("node {node} has links of an unknown kind, or in the wrong order")]
    BadLinks {
        /// The node.
        node: u32,
    },
    /// A child is out of order. Nodes below the root lie in the order of their triangles, each left child directly before
    /// the right one; wide nodes lie beside those of the same parent. So each node has exactly one parent.
    #[error("node {node} names node {child} as a child, which does not exist or is out of order")]
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
    /// A wide tree is too high for the nodes of two children that it stands for.
    #[error(
        "the hierarchy has paths of {height} nodes of two children; its depth bound is {bound}"
    )]
    TooHigh {
        /// The nodes along the longest path of the lowest binary tree with the same wide nodes.
        height: u32,
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
    /// An inner node has so few triangles that it must be a leaf, or some of a wide node's children have.
    #[error(
        "node {node} has {count} triangles below it; so few, or those of some children, must be a leaf"
    )]
    NodeSize {
        /// The node.
        node: u32,
        /// Triangles below it.
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
    /// A place of a leaf is another leaf's, too.
    #[error("a leaf of node {node} has place {place}, which is another leaf's")]
    TwoLeaves {
        /// The leaf's parent.
        node: u32,
        /// The place.
        place: u32,
    },
    /// A leaf ends beyond the list of triangles, or some triangles are in no leaf.
    #[error("leaves end at place {end}; there are {count}")]
    PlaceCount {
        /// The end of the last leaf checked.
        end: u64,
        /// The number of places.
        count: usize,
    },
    /// The leaves hold a different number of triangles than the hierarchy states.
    #[error("leaves hold {found} triangles, but the hierarchy states {expected}")]
    LeafCount {
        /// Triangles in leaves.
        found: u32,
        /// Triangles of the hierarchy, as stored.
        expected: usize,
    },
    /// A node states a different run of triangles than that of its leaves.
    #[error("node {node} states triangles {first} to {last}, but its leaves hold others")]
    WrongRun {
        /// The node.
        node: u32,
        /// Its first triangle.
        first: u32,
        /// Its last triangle.
        last: u32,
    },
    /// A child's box is inverted, not finite, or larger than the scene can be.
    #[error("a child of node {node} has an invalid box or one outside the scene")]
    BadBox {
        /// The parent.
        node: u32,
    },
    /// A child's box does not contain the triangles below it, so rays would miss them.
    #[error("a child of node {node} has a box that does not contain all triangles below it")]
    BoxTooSmall {
        /// The parent.
        node: u32,
    },
    /// A triangle in a leaf has a corner that is NaN or infinite.
    #[error("the triangle at place {place} has a corner that is not finite")]
    NotFinite {
        /// Its position in leaf order; on the lattice, in words.
        place: u32,
    },
    /// A leaf's triangle is not in the mesh, or occurs twice.
    #[error(
        "the triangle at place {place} is the mesh's number {primitive}, which does not exist or occurs twice"
    )]
    BadPrimitive {
        /// Its position in leaf order; on the lattice, in words.
        place: u32,
        /// Its index in the mesh.
        primitive: u32,
    },
    /// A leaf's shared corners are not numbered as its triangles have them: one is unknown, in no triangle, stored twice, or out of
    /// order.
    #[error(
        "the leaf at place {first} of node {node} numbers its corners otherwise than a build does"
    )]
    BadCorners {
        /// The leaf's parent.
        node: u32,
        /// The leaf's first place.
        first: u32,
    },
    /// The mesh has a different number of triangles than the one of the build.
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
    /// A leaf's triangle has different corners than the mesh's.
    #[error("the triangle at place {place} has other corners than the mesh's number {primitive}")]
    OtherCorners {
        /// Its position in leaf order; on the lattice, in words.
        place: u32,
        /// Its index in the mesh.
        primitive: u32,
    },
}

/// Why a hierarchy cannot be refitted to a mesh.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum RefitError {
    /// The mesh itself is invalid.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The mesh is another one.
    #[error("the mesh has {triangle_count} triangles, the hierarchy {expected}; build a new one")]
    TriangleCount {
        /// Triangles of the mesh.
        triangle_count: usize,
        /// Triangles of the hierarchy.
        expected: usize,
    },
    /// The hierarchy is reduced: it lacks triangles that may be needed now.
    #[error("the hierarchy is reduced; build it again when the triangles have moved")]
    Reduced,
}
