//! Checks parents, runs, boxes and depth.

use super::Fault;
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::{Aabb, LeafTriangle, Node, NodeRef};

/// Measures of a sound tree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Shape {
    /// Nodes on the longest path from the root.
    pub depth: u32,
    /// Leaves with triangles.
    pub leaf_count: u32,
}

/// Checks that every node but the root has one parent, that children divide their node's run of triangles in two, down to
/// leaves of the right size, that boxes are tight, and that no path is too long.
///
/// # Errors
/// The first fault found.
pub fn validate_shape(
    nodes: &[Node],
    triangles: &[LeafTriangle],
    depth_bound: u32,
) -> Result<Shape, Fault> {
    let mut walk = Walk {
        nodes,
        triangles,
        depth_bound,
        has_parent: vec![false; nodes.len()],
        shape: Shape::default(),
    };
    let count = triangles.len() as u32;
    let Some(root) = nodes.first() else {
        return Err(Fault::NoSuchNode { node: 0, child: 0 });
    };
    if count <= LEAF_SIZE {
        walk.single_node(root)?;
    } else {
        walk.has_parent[0] = true;
        walk.node(0, 0, count - 1, 1)?;
    }
    match walk.has_parent.iter().skip(1).position(|&has| !has) {
        Some(orphan) => Err(Fault::NoParent {
            node: orphan as u32 + 1,
        }),
        None => Ok(walk.shape),
    }
}

struct Walk<'a> {
    nodes: &'a [Node],
    triangles: &'a [LeafTriangle],
    depth_bound: u32,
    has_parent: Vec<bool>,
    shape: Shape,
}

impl Walk<'_> {
    /// A tree of one leaf: all on the root's left.
    fn single_node(&mut self, root: &Node) -> Result<(), Fault> {
        let count = self.triangles.len() as u32;
        if root.left != NodeRef::leaf(0, count) || root.right.count() != 0 {
            return Err(Fault::WrongCount { node: 0, count });
        }
        if count > 0 {
            self.shape.leaf_count = 1;
            let bounds = self.bounds(0, count - 1);
            check_box(0, &root.left_box(), &bounds)?;
        }
        self.shape.depth = 1;
        Ok(())
    }

    /// Checks a node that should cover a run. Returns the box around it.
    fn node(&mut self, index: u32, first: u32, last: u32, depth: u32) -> Result<Aabb, Fault> {
        if depth > self.depth_bound {
            return Err(Fault::TooDeep {
                bound: self.depth_bound,
            });
        }
        self.shape.depth = self.shape.depth.max(depth);
        let node = self.nodes[index as usize];
        if (node.first, node.last) != (first, last) {
            return Err(Fault::WrongRun { node: index });
        }

        // The left child's own run says where it ends; the right child must start beside it.
        let split = self.last_of(index, node.left)?;
        if split < first || split >= last {
            return Err(Fault::WrongRun { node: index });
        }
        let left = self.child(index, node.left, first, split, depth)?;
        let right = self.child(index, node.right, split + 1, last, depth)?;
        check_box(index, &node.left_box(), &left)?;
        check_box(index, &node.right_box(), &right)?;
        Ok(left.union(right))
    }

    fn last_of(&self, parent: u32, child: NodeRef) -> Result<u32, Fault> {
        if child.is_leaf() {
            Ok((child.first() + child.count()).wrapping_sub(1))
        } else {
            let node = self.nodes.get(child.index() as usize);
            node.map(|node| node.last).ok_or(Fault::NoSuchNode {
                node: parent,
                child: child.index(),
            })
        }
    }

    fn child(
        &mut self,
        parent: u32,
        child: NodeRef,
        first: u32,
        last: u32,
        depth: u32,
    ) -> Result<Aabb, Fault> {
        let count = last - first + 1;
        if child.is_leaf() {
            if (child.first(), child.count()) != (first, count) {
                return Err(Fault::WrongRun { node: parent });
            }
            if count > LEAF_SIZE {
                return Err(Fault::WrongCount {
                    node: parent,
                    count,
                });
            }
            self.shape.leaf_count += 1;
            return Ok(self.bounds(first, last));
        }
        if count <= LEAF_SIZE {
            return Err(Fault::WrongCount {
                node: parent,
                count,
            });
        }
        let index = child.index();
        match self.has_parent.get_mut(index as usize) {
            None => Err(Fault::NoSuchNode {
                node: parent,
                child: index,
            }),
            Some(true) => Err(Fault::SeveralParents { node: index }),
            Some(has_parent) => {
                *has_parent = true;
                self.node(index, first, last, depth + 1)
            }
        }
    }

    /// The box around a run, triangle by triangle.
    fn bounds(&self, first: u32, last: u32) -> Aabb {
        self.triangles[first as usize..=last as usize]
            .iter()
            .fold(Aabb::EMPTY, |bounds, leaf| {
                bounds.union(leaf.triangle().bounds())
            })
    }
}

fn check_box(node: u32, stored: &Aabb, exact: &Aabb) -> Result<(), Fault> {
    if !stored.contains(exact) {
        Err(Fault::BoxTooSmall { node })
    } else if stored != exact {
        Err(Fault::BoxTooLarge { node })
    } else {
        Ok(())
    }
}
