//! A wide node with its children's planes in full, in 128 bytes.

use crate::build::node::NodeRef;
use crate::build::wide::{WIDTH, WideChildren, placed};
use crate::geometry::aabb::Aabb;
use bytemuck::{Pod, Zeroable};
use glam::Vec3;

/// A node of up to four children, their planes in full. 128 bytes, two cache lines.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct FullWideNode {
    /// Bytes 0–95: for x, y and z the children's four lower planes, then the four upper ones. Those of a child that is not there
    /// are the largest float and its negative: no ray meets them.
    pub planes: [[f32; 2 * WIDTH]; 3],
    /// Bytes 96–111: the children, those that are not there last: leaves without triangles.
    pub children: [NodeRef; WIDTH],
    /// Bytes 112–115: first triangle below this node, in leaf order.
    pub first: u32,
    /// Bytes 116–119: last triangle below this node.
    pub last: u32,
    /// Bytes 120–127: zero.
    pub padding: [u32; 2],
}

const _: () = assert!(size_of::<FullWideNode>() == 128);

/// The box of a child that is not there.
const ABSENT: Aabb = Aabb {
    min: Vec3::MAX,
    max: Vec3::MIN,
};

impl FullWideNode {
    /// One thread per wide node. Takes its children, and the first and the last triangle below it; inner children lie side by side
    /// from a place on, leaves name triangles in full.
    #[inline]
    #[must_use]
    pub fn new(from: &WideChildren, [first, last]: [u32; 2], first_child: u32) -> Self {
        let [a, b, c, d] = from.children();
        let bounds = |i: u32, bounds: Aabb| if i < from.count { bounds } else { ABSENT };
        let a_box = bounds(0, a.bounds());
        let b_box = bounds(1, b.bounds());
        let c_box = bounds(2, c.bounds());
        let d_box = bounds(3, d.bounds());
        let row = |low: [f32; 4], high: [f32; 4]| {
            [
                low[0], low[1], low[2], low[3], high[0], high[1], high[2], high[3],
            ]
        };
        let x = row(
            [a_box.min.x, b_box.min.x, c_box.min.x, d_box.min.x],
            [a_box.max.x, b_box.max.x, c_box.max.x, d_box.max.x],
        );
        let y = row(
            [a_box.min.y, b_box.min.y, c_box.min.y, d_box.min.y],
            [a_box.max.y, b_box.max.y, c_box.max.y, d_box.max.y],
        );
        let z = row(
            [a_box.min.z, b_box.min.z, c_box.min.z, d_box.min.z],
            [a_box.max.z, b_box.max.z, c_box.max.z, d_box.max.z],
        );
        Self {
            planes: [x, y, z],
            children: placed(from.nodes(), from.count, first_child),
            first,
            last,
            padding: [0; 2],
        }
    }

    /// A child's box.
    #[inline]
    #[must_use]
    pub const fn child_box(&self, child: u32) -> Aabb {
        let low = child as usize % WIDTH;
        let high = low + WIDTH;
        let [x, y, z] = &self.planes;
        Aabb {
            min: Vec3::new(x[low], y[low], z[low]),
            max: Vec3::new(x[high], y[high], z[high]),
        }
    }

    /// Whether a child's planes are those of a child that is not there.
    #[must_use]
    pub fn is_absent(&self, child: u32) -> bool {
        self.child_box(child) == ABSENT
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::wide::WideChild;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn children_and_boxes_come_back_as_they_went_in(corners in proptest::array::uniform4([-1.0..1.0f32, -1.0..1.0, -1.0..1.0]), count in 0..=4u32) {
            let nodes = [NodeRef::leaf(4, 6), NodeRef::inner(3), NodeRef::inner(9), NodeRef::leaf(40, 1)];
            let children = core::array::from_fn(|i| {
                let min = Vec3::from_array(corners[i]);
                let bounds = Aabb { min, max: min + Vec3::new(0.1, 0.2, 0.3) };
                WideChild::new(nodes[i], bounds)
            });
            let node = FullWideNode::new(&WideChildren::new(children, count), [4, 40], 100);
            let placed = [NodeRef::leaf(4, 6), NodeRef::inner(100), NodeRef::inner(101), NodeRef::leaf(40, 1)];
            for i in 0..4 {
                let is_there = i < count;
                prop_assert_eq!(node.is_absent(i), !is_there);
                let expected = if is_there { children[i as usize].bounds() } else { ABSENT };
                prop_assert_eq!(node.child_box(i), expected);
                let expected = if is_there { placed[i as usize] } else { NodeRef::EMPTY_LEAF };
                prop_assert_eq!(node.children[i as usize], expected);
            }
            prop_assert_eq!([node.first, node.last], [4, 40]);
        }
    }
}
