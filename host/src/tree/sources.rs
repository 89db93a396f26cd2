//! Traits of stored nodes and triangles, for the traversal and for walks over the whole tree.

use super::error::TreeError;
use super::lanes::{LANES, Numbers};
use super::packets::Packet;
use super::stored::Stacks;
use slimbvh_core::trace::{
    Bundle, LeafSlot, LeafTriangles, NodeSource, PacketStacks, PlainNodes, PreparedRays,
    TriangleSource, trace_packet,
};
use slimbvh_core::wide::WIDTH;
use slimbvh_core::{Aabb, LeafTriangle, NodeRef, Vec3};

/// A node, opened: its children and their boxes.
#[derive(Clone, Copy, Debug)]
pub struct Opened<B> {
    /// The first `count` are there.
    pub children: [(NodeRef, B); WIDTH],
    /// The number of children: two in a binary tree, where one that is not there is a leaf without triangles; up to four in a wide
    /// one.
    pub count: usize,
}

impl<B: Copy> Opened<B> {
    /// Two children.
    pub const fn pair([left, right]: [NodeRef; 2], [a, b]: [B; 2]) -> Self {
        Self {
            children: [(left, a), (right, b), (right, b), (right, b)],
            count: 2,
        }
    }

    /// The children that are there.
    pub fn children(&self) -> &[(NodeRef, B)] {
        &self.children[..self.count]
    }
}

/// In which order nodes lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NodeOrder {
    /// In the order of their triangles: below a node all those on its left come first, the left child as the last of them, then the
    /// right child and all below it.
    Triangles,
    /// A node's inner children lie side by side; else in any order.
    Runs,
}

/// In which order the places of triangles lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeafOrder {
    /// In the order of leaves.
    Leaves,
    /// Those of a node's leaves lie side by side; else in any order.
    Runs,
}

/// Nodes as they are stored. With indices in range, no method panics, whatever the bytes are.
pub trait StoredNodes: NodeSource + Sync {
    /// A decoded box.
    type Box: Copy + Send;

    /// In which order nodes lie.
    const ORDER: NodeOrder = NodeOrder::Triangles;

    /// In which order triangles lie.
    const LEAVES: LeafOrder = LeafOrder::Leaves;

    /// The stacks for these nodes' cursors.
    fn stacks(stacks: &mut Stacks) -> &mut PacketStacks<Self::Node, Numbers>;

    /// Traces the first `count` packets of a bundle: over wide nodes together.
    #[inline(always)]
    fn trace_packets<T: StoredTriangles<Self>>(
        &self,
        triangles: &T,
        stacks: &mut Stacks,
        rays: &mut Bundle<PreparedRays<Numbers, LANES>>,
        (packets, count): (&mut Bundle<Packet>, usize),
    ) where
        Self: Sized,
    {
        let stacks = Self::stacks(stacks);
        for (rays, packet) in rays.iter_mut().zip(packets).take(count) {
            trace_packet(stacks, self, triangles, rays, packet);
        }
    }

    /// The number of nodes.
    fn count(&self) -> usize;

    /// The root's box.
    fn root_box(&self) -> Self::Box;

    /// A node's children and their boxes.
    fn open(&self, node: u32, bounds: &Self::Box) -> Opened<Self::Box>;

    /// Checks what a node stores beyond its children, and that nothing else would be decoded to the same; but corners of nodes of 48
    /// bytes may be wider than they need be.
    ///
    /// # Errors
    /// The first fault found.
    fn check(&self, _node: u32, _bounds: &Self::Box) -> Result<(), TreeError> {
        Ok(())
    }

    /// The first and last triangle below a node, if nodes store them.
    fn run(&self, _node: u32) -> Option<[u32; 2]> {
        None
    }

    /// The box at the scene's magnitude.
    fn aabb(&self, bounds: &Self::Box) -> Aabb;
}

/// A triangle of a leaf, by its number there.
#[derive(Clone, Copy, Debug)]
pub struct LeafPlace {
    pub leaf: NodeRef,
    pub number: u32,
}

impl LeafPlace {
    /// All triangles of a leaf.
    pub fn all(leaf: NodeRef) -> impl Iterator<Item = Self> {
        (0..leaf.count()).map(move |number| Self { leaf, number })
    }
}

/// Triangles as they are stored, in leaves of nodes of one kind. No method panics, whatever the bytes are.
pub trait StoredTriangles<N: StoredNodes>: TriangleSource<N::Bounds> + Sync {
    /// The number of places that all triangles occupy.
    fn place_count(&self) -> usize;

    /// The number of places that a leaf with so many triangles and this box occupies.
    fn places(&self, count: u32, _bounds: &N::Box) -> u32 {
        count
    }

    /// The place of a triangle, for messages: of its index, if it has several places.
    fn place(&self, at: LeafPlace, _bounds: &N::Box) -> u32 {
        at.leaf.first() + at.number
    }

    /// Bytes of a triangle in a leaf that is walked to.
    fn bytes(&self, _slot: &LeafSlot<N::Bounds>) -> usize {
        size_of::<LeafTriangle>()
    }

    /// A triangle.
    fn triangle(&self, at: LeafPlace, bounds: &N::Box) -> LeafTriangle;

    /// Whether this triangle is what the place stores.
    fn stores(&self, at: LeafPlace, bounds: &N::Box, triangle: &LeafTriangle) -> bool {
        let stored = self.triangle(at, bounds);
        bytemuck::bytes_of(&stored) == bytemuck::bytes_of(triangle)
    }

    /// Whether the places of a leaf hold what encoding its triangles gives, where other numbers would be decoded to the same.
    fn are_canonical(&self, _leaf: NodeRef, _bounds: &N::Box) -> bool {
        true
    }
}

/// Triangles in full can be combined with nodes of any kind.
impl<N: StoredNodes> StoredTriangles<N> for LeafTriangles<'_> {
    fn place_count(&self) -> usize {
        self.0.len()
    }

    fn triangle(&self, at: LeafPlace, _: &N::Box) -> LeafTriangle {
        let triangle = self.0.get((at.leaf.first() + at.number) as usize);
        triangle.copied().unwrap_or_default()
    }
}

impl StoredNodes for PlainNodes<'_> {
    type Box = Aabb;

    #[inline(always)]
    fn stacks(stacks: &mut Stacks) -> &mut PacketStacks<Self::Node, Numbers> {
        &mut stacks.plain
    }

    fn count(&self) -> usize {
        self.0.len()
    }

    fn root_box(&self) -> Aabb {
        // Children's boxes are stored in full: decoding needs no parent box.
        Aabb::EMPTY
    }

    fn open(&self, node: u32, _: &Aabb) -> Opened<Aabb> {
        let node = &self.0[node as usize];
        let boxes = [node.left_box(), node.right_box()];
        Opened::pair([node.left, node.right], boxes)
    }

    fn run(&self, node: u32) -> Option<[u32; 2]> {
        let node = &self.0[node as usize];
        Some([node.first, node.last])
    }

    fn aabb(&self, bounds: &Aabb) -> Aabb {
        *bounds
    }
}

/// A triangle as the traversal reads it, in a leaf with this decoded box.
pub fn triangle_in<F: Copy>(
    source: &impl TriangleSource<F>,
    LeafPlace { leaf, number }: LeafPlace,
    bounds: F,
) -> LeafTriangle {
    let slot = LeafSlot {
        first: leaf.first(),
        number,
        count: leaf.count(),
        bounds,
    };
    let corners = source.corners(&slot, [0, 1, 2]);
    let mut vertices = [0.0; 9];
    vertices.copy_from_slice(corners.as_flattened());
    LeafTriangle {
        vertices,
        primitive: source.primitive(&slot),
    }
}

/// Whether a box lies in the scene, whose coordinates have magnitude 1 at most, and is neither inverted nor NaN.
pub fn is_in_scene(bounds: &Aabb) -> bool {
    let (low, high) = (bounds.min, bounds.max);
    low.cmpge(Vec3::NEG_ONE).all() && high.cmple(Vec3::ONE).all() && low.cmple(high).all()
}
