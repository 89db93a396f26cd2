//! Wide nodes as the rest of the tree sees them: opened, and checked.

use super::super::error::TreeError;
use super::super::lanes::{LANES, Numbers};
use super::super::lattice::aabb;
use super::super::packets::Packet;
use super::super::sources::{
    LeafOrder, LeafPlace, NodeOrder, Opened, StoredNodes, StoredTriangles, triangle_in,
};
use super::super::stored::Stacks;
use glam::Vec4;
use slimbvh_core::encode::frame::Frame;
use slimbvh_core::encode::{
    FullWideNode, LatticeTriangles, LeafCorner, LeafFrame, LeafWidth, PackedWideNode,
    PackedWideNodes, SharedTriangles, WideAxis, WideMixedNodes, WideNode, WideNodes, corner_count,
    index_place, leaf_words, number_corners, store_shared_leaf,
};
use slimbvh_core::float::exponent;
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::trace::{
    Bundle, FullWideNodes, LeafSlot, PacketStacks, PreparedRays, trace_bundle,
};
use slimbvh_core::wide::WIDTH;
use slimbvh_core::{Aabb, LeafTriangle, NodeRef};

/// A child on the lattice.
#[derive(Clone, Copy, Debug)]
pub struct LatticeChild {
    /// Its decoded box, up to the sides of its parent's.
    pub bounds: LatticeBox,
    /// The width of its triangles, if it is a leaf with triangles on the lattice.
    pub width: LeafWidth,
    /// The number of its corners, if it is a leaf whose triangles share these.
    pub corner_count: u32,
}

impl LatticeChild {
    const fn root(bounds: LatticeBox) -> Self {
        Self {
            bounds,
            width: LeafWidth::Wide,
            corner_count: 0,
        }
    }

    /// A child's box as it is decoded, in its parent's box: no triangle lies above that one, where the child's own may end.
    fn below(parent: &Self, decoded: LatticeBox, width: LeafWidth) -> Self {
        let mut bounds = decoded;
        for (max, end) in bounds.max.iter_mut().zip(parent.bounds.max) {
            *max = end.min(*max);
        }
        Self {
            bounds,
            width,
            corner_count: 0,
        }
    }
}

/// The steps of an axis, at most: from one side of the scene to the other.
const MOST_EXTENT: u32 = 1 << 25;

/// Extents beyond are even, so that floats hold them.
const MOST_ODD_STEPS: u32 = 1 << 24;

/// The children before the first that is not there.
fn count_of(children: [NodeRef; WIDTH]) -> usize {
    let is_absent = |child: &NodeRef| *child == NodeRef::EMPTY_LEAF;
    children.iter().position(is_absent).unwrap_or(WIDTH)
}

/// Checks that no child follows one that is not there, and that inner ones lie side by side.
fn check_children(node: u32, children: [NodeRef; WIDTH]) -> Result<(), TreeError> {
    let (there, rest) = children.split_at(count_of(children));
    if rest.iter().any(|child| *child != NodeRef::EMPTY_LEAF) {
        return Err(TreeError::BadLinks { node });
    }
    let mut inner = there.iter().filter(|child| !child.is_leaf());
    let Some(first) = inner.next() else {
        return Ok(());
    };
    for (expected, child) in (first.index()..).skip(1).zip(inner) {
        if child.index() != expected {
            let child = child.index();
            return Err(TreeError::ChildOutOfPlace { node, child });
        }
    }
    Ok(())
}

/// Checks a node's frame below its parent's box, in which the first `count` children lie. A function returns whether an axis' scale
/// is one that children have.
fn check_frame(
    node: u32,
    axes: &[WideAxis; 3],
    (parent, count, step): (&LatticeBox, usize, f32),
    (is_scaled, counts_cells): (impl Fn(&WideAxis) -> bool, bool),
) -> Result<(), TreeError> {
    let is_sound = |(axis, least): (&WideAxis, &i32)| {
        let origin = axis.origin_steps(exponent(step));
        let is_on_lattice = (origin as f32 * step).to_bits() == axis.origin.to_bits();
        let mut others = count as u32..WIDTH as u32;
        is_on_lattice
            && origin >= *least
            && is_scaled(axis)
            && others.all(|i| axis.is_absent(i, counts_cells))
    };
    if axes.iter().zip(&parent.min).all(is_sound) {
        Ok(())
    } else {
        Err(TreeError::BadFrame { node })
    }
}

/// Whether an axis has an extent that floats hold, and the shift that follows from it.
fn is_exact_scale(axis: &WideAxis) -> bool {
    let extent = axis.extent();
    let is_held = extent <= MOST_ODD_STEPS || extent <= MOST_EXTENT && extent.is_multiple_of(2);
    is_held && axis.shift() == Frame { extent }.shift()
}

/// Whether no plane of an axis is further from the origin than the scene is wide.
fn is_packed_scale(axis: &WideAxis) -> bool {
    axis.shift()
        <= Frame {
            extent: MOST_EXTENT,
        }
        .shift()
}

impl StoredNodes for FullWideNodes<'_> {
    type Box = Aabb;

    const ORDER: NodeOrder = NodeOrder::Runs;

    #[inline(always)]
    fn stacks(stacks: &mut Stacks) -> &mut PacketStacks<Self::Node, Numbers> {
        &mut stacks.wide
    }

    #[inline(always)]
    fn trace_packets<T: StoredTriangles<Self>>(
        &self,
        triangles: &T,
        stacks: &mut Stacks,
        rays: &mut Bundle<PreparedRays<Numbers, LANES>>,
        packets: (&mut Bundle<Packet>, usize),
    ) {
        let stacks = (&mut stacks.bundle, &mut stacks.wide);
        trace_bundle(stacks, self, triangles, rays, packets);
    }

    fn count(&self) -> usize {
        self.0.len()
    }

    fn root_box(&self) -> Aabb {
        // Children's boxes are stored in full: decoding needs no parent box.
        Aabb::EMPTY
    }

    fn open(&self, node: u32, _: &Aabb) -> Opened<Aabb> {
        let node: &FullWideNode = bytemuck::cast_ref(&self.0[node as usize]);
        let child = |i: usize| (node.children[i], node.child_box(i as u32));
        Opened {
            children: [child(0), child(1), child(2), child(3)],
            count: count_of(node.children),
        }
    }

    fn check(&self, index: u32, _: &Aabb) -> Result<(), TreeError> {
        let node: &FullWideNode = bytemuck::cast_ref(&self.0[index as usize]);
        check_children(index, node.children)?;
        let mut others = count_of(node.children) as u32..WIDTH as u32;
        if others.all(|i| node.is_absent(i)) && node.padding == [0; 2] {
            Ok(())
        } else {
            Err(TreeError::BadFrame { node: index })
        }
    }

    fn run(&self, node: u32) -> Option<[u32; 2]> {
        let node: &FullWideNode = bytemuck::cast_ref(&self.0[node as usize]);
        Some([node.first, node.last])
    }

    fn aabb(&self, bounds: &Aabb) -> Aabb {
        *bounds
    }
}

/// Opens a node of 64 bytes.
fn open_exact(node: &WideNode, parent: &LatticeChild, step: f32) -> Opened<LatticeChild> {
    let child = |i: usize| {
        let decoded = node.child_box(i as u32, exponent(step));
        let child = LatticeChild::below(parent, decoded, LeafWidth::of(&decoded));
        (node.children[i], child)
    };
    Opened {
        children: [child(0), child(1), child(2), child(3)],
        count: count_of(node.children),
    }
}

/// Checks a node of 64 bytes.
fn check_exact(
    index: u32,
    node: &WideNode,
    parent: &LatticeChild,
    step: f32,
) -> Result<(), TreeError> {
    check_children(index, node.children)?;
    let there = (&parent.bounds, count_of(node.children), step);
    check_frame(index, &node.axes, there, (is_exact_scale, false))
}

impl StoredNodes for WideNodes<'_> {
    type Box = LatticeChild;

    const ORDER: NodeOrder = NodeOrder::Runs;

    #[inline(always)]
    fn stacks(stacks: &mut Stacks) -> &mut PacketStacks<Self::Node, Numbers> {
        &mut stacks.coded_wide
    }

    #[inline(always)]
    fn trace_packets<T: StoredTriangles<Self>>(
        &self,
        triangles: &T,
        stacks: &mut Stacks,
        rays: &mut Bundle<PreparedRays<Numbers, LANES>>,
        packets: (&mut Bundle<Packet>, usize),
    ) {
        let stacks = (&mut stacks.bundle, &mut stacks.coded_wide);
        trace_bundle(stacks, self, triangles, rays, packets);
    }

    fn count(&self) -> usize {
        self.nodes.len()
    }

    fn root_box(&self) -> LatticeChild {
        LatticeChild::root(self.root)
    }

    fn open(&self, node: u32, bounds: &LatticeChild) -> Opened<LatticeChild> {
        let node = bytemuck::cast(self.nodes[node as usize]);
        open_exact(&node, bounds, self.step)
    }

    fn check(&self, index: u32, bounds: &LatticeChild) -> Result<(), TreeError> {
        let node = bytemuck::cast(self.nodes[index as usize]);
        check_exact(index, &node, bounds, self.step)
    }

    fn aabb(&self, bounds: &LatticeChild) -> Aabb {
        aabb(&bounds.bounds, self.step)
    }
}

impl StoredNodes for WideMixedNodes<'_> {
    type Box = LatticeChild;

    const ORDER: NodeOrder = NodeOrder::Runs;
    const LEAVES: LeafOrder = LeafOrder::Runs;

    #[inline(always)]
    fn stacks(stacks: &mut Stacks) -> &mut PacketStacks<Self::Node, Numbers> {
        &mut stacks.coded_wide
    }

    #[inline(always)]
    fn trace_packets<T: StoredTriangles<Self>>(
        &self,
        triangles: &T,
        stacks: &mut Stacks,
        rays: &mut Bundle<PreparedRays<Numbers, LANES>>,
        packets: (&mut Bundle<Packet>, usize),
    ) {
        let stacks = (&mut stacks.bundle, &mut stacks.coded_wide);
        trace_bundle(stacks, self, triangles, rays, packets);
    }

    fn count(&self) -> usize {
        self.nodes.len()
    }

    fn root_box(&self) -> LatticeChild {
        LatticeChild::root(self.root)
    }

    fn open(&self, node: u32, bounds: &LatticeChild) -> Opened<LatticeChild> {
        let node = bytemuck::cast(self.nodes[node as usize]);
        open_exact(&node, bounds, self.step)
    }

    fn check(&self, index: u32, bounds: &LatticeChild) -> Result<(), TreeError> {
        let node: WideNode = bytemuck::cast(self.nodes[index as usize]);
        check_exact(index, &node, bounds, self.step)?;
        // The words of all leaves lie side by side.
        let mut end = None;
        for (number, child) in (0..).zip(node.children) {
            if !child.is_leaf() || child == NodeRef::EMPTY_LEAF {
                continue;
            }
            let (first, expected) = (child.first(), end.unwrap_or(child.first()));
            if first != expected {
                return Err(TreeError::LeafOutOfPlace {
                    node: index,
                    first,
                    expected,
                });
            }
            let width = node.leaf_width(number, exponent(self.step));
            end = Some(first + child.count() * width.words());
        }
        Ok(())
    }

    fn aabb(&self, bounds: &LatticeChild) -> Aabb {
        aabb(&bounds.bounds, self.step)
    }
}

impl StoredNodes for PackedWideNodes<'_> {
    type Box = LatticeChild;

    const ORDER: NodeOrder = NodeOrder::Runs;
    const LEAVES: LeafOrder = LeafOrder::Runs;

    #[inline(always)]
    fn stacks(stacks: &mut Stacks) -> &mut PacketStacks<Self::Node, Numbers> {
        &mut stacks.coded_wide
    }

    #[inline(always)]
    fn trace_packets<T: StoredTriangles<Self>>(
        &self,
        triangles: &T,
        stacks: &mut Stacks,
        rays: &mut Bundle<PreparedRays<Numbers, LANES>>,
        packets: (&mut Bundle<Packet>, usize),
    ) {
        let stacks = (&mut stacks.bundle, &mut stacks.coded_wide);
        trace_bundle(stacks, self, triangles, rays, packets);
    }

    fn count(&self) -> usize {
        self.nodes.len()
    }

    fn root_box(&self) -> LatticeChild {
        LatticeChild::root(self.root)
    }

    fn open(&self, node: u32, bounds: &LatticeChild) -> Opened<LatticeChild> {
        let node: PackedWideNode = bytemuck::cast(self.nodes[node as usize]);
        let links = node.links();
        let child = |i: u32| {
            let decoded = node.child_box(i, exponent(self.step));
            let child = LatticeChild {
                corner_count: links.corner_count(i),
                ..LatticeChild::below(bounds, decoded, links.width())
            };
            (links.child(i), child)
        };
        Opened {
            children: [child(0), child(1), child(2), child(3)],
            count: count_of(links.children()),
        }
    }

    fn check(&self, index: u32, bounds: &LatticeChild) -> Result<(), TreeError> {
        let node: PackedWideNode = bytemuck::cast(self.nodes[index as usize]);
        let links = node.links();
        let count = count_of(links.children());
        if !links.are_canonical(count as u32) {
            return Err(TreeError::BadLinks { node: index });
        }
        let there = (&bounds.bounds, count, self.step);
        check_frame(index, &node.axes, there, (is_packed_scale, true))
    }

    fn aabb(&self, bounds: &LatticeChild) -> Aabb {
        aabb(&bounds.bounds, self.step)
    }
}

/// A leaf's frame, its axes in order.
fn frame_of(leaf: &LatticeChild, step: f32) -> LeafFrame {
    let [x, y, z] = leaf.bounds.min.map(|x| x as f32 * step);
    LeafFrame {
        min: Vec4::new(x, y, z, 0.0),
        width: leaf.width,
    }
}

impl StoredTriangles<WideMixedNodes<'_>> for LatticeTriangles<'_> {
    fn place_count(&self) -> usize {
        self.words.len()
    }

    fn places(&self, count: u32, leaf: &LatticeChild) -> u32 {
        count * leaf.width.words()
    }

    fn place(&self, at: LeafPlace, leaf: &LatticeChild) -> u32 {
        at.leaf.first() + at.number * leaf.width.words()
    }

    fn bytes(&self, slot: &LeafSlot<LeafFrame>) -> usize {
        size_of::<u32>() * slot.bounds.width.words() as usize
    }

    fn triangle(&self, at: LeafPlace, leaf: &LatticeChild) -> LeafTriangle {
        triangle_in(self, at, frame_of(leaf, self.step))
    }
}

impl StoredTriangles<PackedWideNodes<'_>> for SharedTriangles<'_> {
    fn place_count(&self) -> usize {
        self.words.len()
    }

    fn places(&self, count: u32, leaf: &LatticeChild) -> u32 {
        leaf_words(count, leaf.corner_count, leaf.width.vertex_words())
    }

    fn place(&self, LeafPlace { leaf, number }: LeafPlace, _: &LatticeChild) -> u32 {
        index_place(leaf.first(), leaf.count(), number)
    }

    /// Its corners, its index, and half a word that says which corners they are: a word, where it has no other half; the first triangle
    /// needs none.
    fn bytes(&self, slot: &LeafSlot<LeafFrame>) -> usize {
        let is_alone = slot.number % 2 == 1 && slot.number + 1 == slot.count;
        let half = match slot.number {
            0 => 0,
            _ if is_alone => 4,
            _ => 2,
        };
        size_of::<u32>() * slot.bounds.width.words() as usize + half
    }

    fn triangle(&self, at: LeafPlace, leaf: &LatticeChild) -> LeafTriangle {
        triangle_in(self, at, frame_of(leaf, self.step))
    }

    fn are_canonical(&self, leaf: NodeRef, child: &LatticeChild) -> bool {
        let triangles: Vec<LeafTriangle> = LeafPlace::all(leaf)
            .map(|at| self.triangle(at, child))
            .collect();
        let mut corners = vec![0; triangles.len()];
        number_corners(0, leaf.count(), &triangles, &mut corners);
        if corner_count(0, leaf.count(), &corners) != child.corner_count {
            return false;
        }
        let corner = LeafCorner {
            min: child.bounds.min,
            words: child.width.words(),
        };
        let mut words = vec![0; self.places(leaf.count(), child) as usize];
        store_shared_leaf(&triangles, &corners, &corner, self.step, 0, &mut words);
        let stored = self.words.get(leaf.first() as usize..);
        stored.is_some_and(|stored| stored.starts_with(&words))
    }
}
