//! The depth of trees, and the size of the traversal stack.

use slimbvh::Bvh;
use slimbvh_core::Ray;
use slimbvh_core::node::NodeRef;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{
    Children, ClosestHit, Column, Cursor, LeafRun, NodeSource, Order, PlainNodes, Skip, traverse,
};
use std::cell::Cell;

/// The number of nodes on the longest path from the root to a leaf, the leaf included; 0 without a tree.
pub fn depth(bvh: &Bvh) -> u32 {
    if bvh.triangle_count() == 0 {
        return 0;
    }
    let nodes = bvh.nodes();
    let mut deepest = 1;
    let mut waiting = vec![(0, 1)];
    while let Some((index, depth)) = waiting.pop() {
        deepest = deepest.max(depth);
        let Some(node) = nodes.get(index as usize) else {
            continue;
        };
        deepest = deepest.max(depth + 1);
        for child in [node.left, node.right] {
            if !child.is_leaf() {
                waiting.push((child.index(), depth + 1));
            }
        }
    }
    deepest
}

/// The largest stack during the search for a ray's closest hit, in a tree without codecs.
pub fn longest(bvh: &Bvh, ray: &Ray) -> u32 {
    LONGEST.set(0);
    let prepared = PreparedRay::new(ray, bvh.scene_exponent());
    let mut closest = ClosestHit::new(prepared.t_max);
    let (nodes, triangles) = (Noted(bvh.node_source()), bvh.triangle_source());
    traverse(&nodes, &triangles, &prepared, &Skip::NONE, &mut closest);
    LONGEST.get()
}

thread_local! {
    static LONGEST: Cell<u32> = const { Cell::new(0) };
}

/// Nodes whose cursors record their places on the stack.
struct Noted<'a>(PlainNodes<'a>);

#[derive(Clone, Copy)]
struct NotedRef(NodeRef);

impl Cursor for NotedRef {
    type Columns = Column<NodeRef>;
    const EMPTY: Column<NodeRef> = NodeRef::EMPTY;

    fn put(self, columns: &mut Column<NodeRef>, place: usize) {
        LONGEST.set(LONGEST.get().max(place as u32 + 1));
        self.0.put(columns, place);
    }

    fn at(columns: &Column<NodeRef>, place: usize) -> Self {
        Self(NodeRef::at(columns, place))
    }
}

impl NodeSource for Noted<'_> {
    type Cursor = NotedRef;
    type Node = Children<NotedRef>;
    type Bounds = ();

    const NOTHING: NotedRef = NotedRef(NodeRef::EMPTY_LEAF);

    fn root(&self, axes: [u32; 3]) -> NotedRef {
        NotedRef(self.0.root(axes))
    }

    fn is_leaf(&self, cursor: NotedRef) -> bool {
        self.0.is_leaf(cursor.0)
    }

    fn leaf(&self, cursor: NotedRef, axes: [u32; 3]) -> LeafRun<()> {
        self.0.leaf(cursor.0, axes)
    }

    fn resume(&self, waited: NotedRef) -> NotedRef {
        waited
    }

    fn children(&self, cursor: NotedRef, order: Order) -> Children<NotedRef> {
        let children = self.0.children(cursor.0, order);
        Children {
            planes: children.planes,
            left: NotedRef(children.left),
            right: NotedRef(children.right),
        }
    }

    fn step_limit(&self) -> u32 {
        self.0.step_limit()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use slimbvh::generate::soup;
    use slimbvh::{Builder, Mesh};

    #[test]
    fn a_deep_tree_has_a_long_stack() {
        let build = |count: u32| {
            let mesh = if count == 0 {
                Mesh::default()
            } else {
                soup(count, 1)
            };
            Builder::default().build(&mesh).expect("it is sound")
        };
        assert_eq!([0, 1, 4].map(|count| depth(&build(count))), [0, 2, 2]);
        let bvh = build(3000);
        let depth = depth(&bvh);
        assert!((11..=bvh.depth_bound() + 1).contains(&depth), "{depth}");
        let through = Ray::new([0.5, 0.5, -1.0], [1e-3, 2e-3, 1.0]);
        let longest = longest(&bvh, &through);
        assert!(longest >= 3 && longest < depth, "{longest} of {depth}");
    }
}
