//! Validation of an untrusted hierarchy: everything that tracing, refits and codecs rely on.

mod marks;

use self::marks::Marks;
use super::bvh::Bvh;
use super::decode::BinarySize;
use super::error::TreeError;
use super::sources::{LeafOrder, LeafPlace, NodeOrder, StoredNodes, StoredTriangles, is_in_scene};
use super::visitor::TreeVisitor;
use crate::Mesh;
use crate::parallel::prelude::*;
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::snap::leaf_triangle;
use slimbvh_core::trace::STACK_SIZE;
use slimbvh_core::wide::WIDTH;
use slimbvh_core::{Aabb, IndexedTriangles, MAX_TRIANGLES, NodeRef};
use std::ops::Range;

impl Bvh {
    /// Checks that each node and each place has one parent, in the order of builds; that leaves hold triangles of the mesh,
    /// each at most once, with finite corners; that every child's box contains everything below it; and that no path
    /// exceeds the traversal's stack. Tracing or refitting a valid hierarchy neither panics nor loses a hit. Hierarchies
    /// from a [`crate::Builder`] are always valid.
    ///
    /// # Errors
    /// The first fault found.
    pub fn validate(&self) -> Result<(), TreeError> {
        self.check_numbers()?;
        self.walk(None)
    }

    /// [`Self::validate`], and checks that leaves store the triangles of a mesh, which must be sound.
    ///
    /// # Errors
    /// The first fault found.
    pub fn validate_over(&self, mesh: &Mesh) -> Result<(), TreeError> {
        self.check_numbers()?;
        if mesh.indices.len() != self.mesh_triangle_count {
            return Err(TreeError::OtherMesh {
                triangle_count: mesh.indices.len(),
                expected: self.mesh_triangle_count,
            });
        }
        let bits = |bounds: Option<Aabb>| {
            bounds.map(|b| [b.min, b.max].map(|v| v.to_array().map(f32::to_bits)))
        };
        if bits(mesh.bounds()) != bits(self.bounds) {
            return Err(TreeError::OtherBounds);
        }
        self.walk(Some(mesh.triangles()))
    }

    /// Checks everything but nodes and triangles.
    fn check_numbers(&self) -> Result<(), TreeError> {
        let limit = MAX_TRIANGLES as usize;
        let (triangle_count, mesh_triangle_count) =
            (self.triangle_count(), self.mesh_triangle_count);
        if triangle_count > mesh_triangle_count || mesh_triangle_count > limit {
            return Err(TreeError::TriangleCount {
                triangle_count,
                mesh_triangle_count,
                limit,
            });
        }
        let is_sound = self.bounds.map_or(mesh_triangle_count == 0, |bounds| {
            bounds.min.is_finite() && bounds.max.is_finite() && bounds.min.cmple(bounds.max).all()
        });
        if !is_sound {
            return Err(TreeError::Bounds);
        }
        let expected = scene_exponent(&self.bounds.unwrap_or(Aabb::EMPTY));
        if self.scene_exponent != expected {
            return Err(TreeError::SceneExponent {
                exponent: self.scene_exponent,
                expected,
            });
        }
        let limit = STACK_SIZE as u32 - 1;
        if self.depth_bound > limit {
            return Err(TreeError::DepthBound {
                bound: self.depth_bound,
                limit,
            });
        }
        Ok(())
    }

    fn walk(&self, mesh: Option<IndexedTriangles>) -> Result<(), TreeError> {
        if self.node_count() == 0 {
            return Err(TreeError::NoRoot);
        }
        self.stored.lists().check_root()?;
        self.stored.visit(Check { bvh: self, mesh })
    }
}

/// The check of all nodes and triangles.
struct Check<'a> {
    bvh: &'a Bvh,
    mesh: Option<IndexedTriangles<'a>>,
}

impl TreeVisitor for Check<'_> {
    type Output = Result<(), TreeError>;

    fn visit<N: StoredNodes, T: StoredTriangles<N>>(
        self,
        nodes: &N,
        triangles: &T,
    ) -> Result<(), TreeError> {
        let none_or = |is_asked: bool, count| Marks::new(if is_asked { count } else { 0 });
        let walk = Walk {
            nodes,
            triangles,
            depth_bound: self.bvh.depth_bound,
            mesh: self.mesh,
            scale: PowerOfTwo::new(self.bvh.scene_exponent),
            mesh_triangle_count: self.bvh.mesh_triangle_count,
            is_there: Marks::new(self.bvh.mesh_triangle_count),
            opened: none_or(N::ORDER == NodeOrder::Runs, nodes.count()),
            places: none_or(N::LEAVES == LeafOrder::Runs, triangles.place_count()),
        };
        walk.whole(self.bvh.triangle_count())
    }
}

/// Nodes with fewer nodes below them are checked on one thread.
const TASK: u32 = 1024;

/// Nodes that lie in runs are checked on one thread below this depth: how many are below them is not known.
const TASK_DEPTH: u32 = 6;

struct Walk<'a, N, T> {
    nodes: &'a N,
    triangles: &'a T,
    depth_bound: u32,
    mesh: Option<IndexedTriangles<'a>>,
    scale: PowerOfTwo,
    mesh_triangle_count: usize,
    /// The mesh's triangles that are in leaves.
    is_there: Marks,
    /// Nodes that have a parent, and places that belong to a leaf, where that does not follow from their order.
    opened: Marks,
    places: Marks,
}

/// The triangles below a node.
struct Found {
    /// The box around the triangles.
    bounds: Aabb,
    /// Their places.
    places: Range<u32>,
    /// Their number.
    count: u32,
    /// The binary tree that holds them when it is decoded.
    size: BinarySize,
}

/// What is below the children of a node, from the first one on.
#[derive(Default)]
struct Below {
    found: Option<Found>,
    /// What each child becomes.
    sizes: [BinarySize; WIDTH],
    count: usize,
}

impl Below {
    /// Adds the next child. Triangles lie one after the other if they are in the order of leaves.
    fn add<N: StoredNodes>(&mut self, node: u32, next: Found) -> Result<(), TreeError> {
        self.sizes[self.count] = next.size;
        self.count += 1;
        let Some(all) = &mut self.found else {
            self.found = Some(next);
            return Ok(());
        };
        if N::LEAVES == LeafOrder::Leaves && next.places.start != all.places.end {
            return Err(TreeError::LeafOutOfPlace {
                node,
                first: next.places.start,
                expected: all.places.end,
            });
        }
        let (a, b) = (&all.places, &next.places);
        *all = Found {
            bounds: all.bounds.union(next.bounds),
            places: a.start.min(b.start)..a.end.max(b.end),
            count: all.count + next.count,
            ..next
        };
        Ok(())
    }

    /// What is below the node.
    fn found(self, node: u32) -> Result<Found, TreeError> {
        let found = self.found.ok_or(TreeError::NodeSize { node, count: 0 })?;
        let lowest = BinarySize::lowest(&self.sizes[..self.count]);
        let (size, _) = lowest.ok_or(TreeError::NodeSize {
            node,
            count: found.count,
        })?;
        Ok(Found { size, ..found })
    }
}

/// A child to be checked.
struct Child<B> {
    parent: u32,
    child: NodeRef,
    bounds: B,
    /// The nodes that must be below it; for nodes that lie in runs, none.
    below: Range<u32>,
    /// Its parent's depth.
    depth: u32,
}

impl<N: StoredNodes, T: StoredTriangles<N>> Walk<'_, N, T> {
    fn whole(&self, triangle_count: usize) -> Result<(), TreeError> {
        // Node indices have 31 bits.
        let node_count = self.nodes.count().min(1 << 31) as u32;
        let root = self.nodes.root_box();
        let found = if triangle_count <= LEAF_SIZE as usize {
            self.single(&root, triangle_count as u32, node_count)?
        } else {
            self.node(0, &root, 1..node_count, 1)?
        };
        self.check_marks(node_count)?;
        let (height, bound) = (found.size.height, self.depth_bound);
        if height > bound {
            return Err(TreeError::TooHigh { height, bound });
        }
        if found.places.start != 0 {
            return Err(TreeError::LeafOutOfPlace {
                node: 0,
                first: found.places.start,
                expected: 0,
            });
        }
        if found.places.end as usize != self.triangles.place_count() {
            return Err(self.place_count(found.places.end.into()));
        }
        if found.count as usize != triangle_count {
            return Err(TreeError::LeafCount {
                found: found.count,
                expected: triangle_count,
            });
        }
        Ok(())
    }

    /// Checks that all nodes have a parent, and all places a leaf, where that does not follow from their order.
    fn check_marks(&self, node_count: u32) -> Result<(), TreeError> {
        if N::ORDER == NodeOrder::Runs {
            self.opened.mark(0);
            if let Some(node) = (0..node_count).find(|&node| !self.opened.is_marked(node)) {
                return Err(TreeError::NoParent { node });
            }
        }
        let place_count = self.triangles.place_count();
        let is_free = |place: &usize| !self.places.is_marked(*place as u32);
        if N::LEAVES == LeafOrder::Runs
            && let Some(place) = (0..place_count).find(is_free)
        {
            return Err(self.place_count(place as u64));
        }
        Ok(())
    }

    /// A tree of one leaf, on the root's left.
    fn single(&self, root: &N::Box, count: u32, node_count: u32) -> Result<Found, TreeError> {
        if node_count > 1 {
            return Err(TreeError::NoParent { node: 1 });
        }
        self.nodes.check(0, root)?;
        let opened = self.nodes.open(0, root);
        let (left, left_box) = opened.children[0];
        let rest = &opened.children[1..opened.count.max(1)];
        if left != NodeRef::leaf(0, count)
            || rest.iter().any(|(child, _)| *child != NodeRef::EMPTY_LEAF)
        {
            return Err(TreeError::LeafSize {
                node: 0,
                count: left.count(),
                limit: LEAF_SIZE,
            });
        }
        let found = if count == 0 {
            Found {
                bounds: Aabb::EMPTY,
                places: 0..0,
                count,
                size: BinarySize::default(),
            }
        } else {
            self.child(Child {
                parent: 0,
                child: left,
                bounds: left_box,
                below: 0..0,
                depth: 1,
            })?
        };
        self.check_run(0, &found)?;
        Ok(found)
    }

    /// Checks a node; `below` are the nodes that must be its descendants.
    fn node(
        &self,
        node: u32,
        bounds: &N::Box,
        below: Range<u32>,
        depth: u32,
    ) -> Result<Found, TreeError> {
        if depth > self.depth_bound {
            return Err(TreeError::TooDeep {
                node,
                bound: self.depth_bound,
            });
        }
        self.nodes.check(node, bounds)?;
        let opened = self.nodes.open(node, bounds);
        let (is_task, parts) = match (N::ORDER, opened.children()) {
            (NodeOrder::Triangles, [(left, _), (right, _)]) => {
                let is_task = below.end - below.start >= TASK;
                let [left, right] = places(node, [*left, *right], below)?;
                (is_task, [left, right, 0..0, 0..0])
            }
            (NodeOrder::Runs, [_, _, ..]) => {
                self.open_run(node, opened.children())?;
                (depth <= TASK_DEPTH, [0..0, 0..0, 0..0, 0..0])
            }
            _ => return Err(TreeError::NodeSize { node, count: 0 }),
        };
        let children = opened.children().iter().zip(parts);
        let child = |(&(child, bounds), below)| Child {
            parent: node,
            child,
            bounds,
            below,
            depth,
        };
        let mut all = Below::default();
        if is_task {
            let children: Vec<_> = children.map(child).collect();
            let found = children.into_par_iter().map(|child| self.child(child));
            let found: Vec<Found> = found.collect::<Result<_, _>>()?;
            for next in found {
                all.add::<N>(node, next)?;
            }
        } else {
            for child in children.map(child) {
                all.add::<N>(node, self.child(child)?)?;
            }
        }
        let found = all.found(node)?;
        self.check_run(node, &found)?;
        Ok(found)
    }

    /// Checks that a node's inner children exist and have no other parent.
    fn open_run(&self, node: u32, children: &[(NodeRef, N::Box)]) -> Result<(), TreeError> {
        let inner = children.iter().filter(|(child, _)| !child.is_leaf());
        for (child, _) in inner {
            let child = child.index();
            // The root is no child.
            if child == 0 || child as usize >= self.nodes.count() || !self.opened.mark(child) {
                return Err(TreeError::ChildOutOfPlace { node, child });
            }
        }
        Ok(())
    }

    /// Checks the run of triangles that a node stores, if any.
    fn check_run(&self, node: u32, found: &Found) -> Result<(), TreeError> {
        let expected = [found.places.start, found.places.end.saturating_sub(1)];
        match self.nodes.run(node) {
            Some(run) if run != expected => Err(TreeError::WrongRun {
                node,
                first: run[0],
                last: run[1],
            }),
            _ => Ok(()),
        }
    }

    /// Checks a child, and that its box contains everything below it.
    fn child(&self, it: Child<N::Box>) -> Result<Found, TreeError> {
        let node = it.parent;
        let stored = self.nodes.aabb(&it.bounds);
        if !is_in_scene(&stored) {
            return Err(TreeError::BadBox { node });
        }
        let found = if it.child.is_leaf() {
            self.leaf(node, it.child, &it.bounds)?
        } else {
            self.node(it.child.index(), &it.bounds, it.below, it.depth + 1)?
        };
        if stored.contains(&found.bounds) {
            Ok(found)
        } else {
            Err(TreeError::BoxTooSmall { node })
        }
    }

    fn leaf(&self, node: u32, leaf: NodeRef, bounds: &N::Box) -> Result<Found, TreeError> {
        let (first, count) = (leaf.first(), leaf.count());
        if !(1..=LEAF_SIZE).contains(&count) {
            return Err(TreeError::LeafSize {
                node,
                count,
                limit: LEAF_SIZE,
            });
        }
        let end = u64::from(first) + u64::from(self.triangles.places(count, bounds));
        if end > self.triangles.place_count() as u64 {
            return Err(self.place_count(end));
        }
        if N::LEAVES == LeafOrder::Runs
            && let Some(place) = (first..end as u32).find(|&place| !self.places.mark(place))
        {
            return Err(TreeError::TwoLeaves { node, place });
        }
        let mut exact = Aabb::EMPTY;
        for at in LeafPlace::all(leaf) {
            exact = exact.union(self.triangle(at, bounds)?);
        }
        if !self.triangles.are_canonical(leaf, bounds) {
            return Err(TreeError::BadCorners { node, first });
        }
        Ok(Found {
            bounds: exact,
            places: first..end as u32,
            count,
            size: BinarySize::leaf(count),
        })
    }

    /// Checks a leaf's triangle. Returns its box.
    fn triangle(&self, at: LeafPlace, bounds: &N::Box) -> Result<Aabb, TreeError> {
        let place = self.triangles.place(at, bounds);
        let stored = self.triangles.triangle(at, bounds);
        if !stored.vertices.iter().all(|x| x.is_finite()) {
            return Err(TreeError::NotFinite { place });
        }
        let primitive = stored.primitive;
        let is_new =
            (primitive as usize) < self.mesh_triangle_count && self.is_there.mark(primitive);
        if !is_new {
            return Err(TreeError::BadPrimitive { place, primitive });
        }
        if let Some(mesh) = &self.mesh {
            let exact = leaf_triangle(primitive, mesh, &self.scale);
            if !self.triangles.stores(at, bounds, &exact) {
                return Err(TreeError::OtherCorners { place, primitive });
            }
        }
        Ok(stored.triangle().bounds())
    }

    fn place_count(&self, end: u64) -> TreeError {
        TreeError::PlaceCount {
            end,
            count: self.triangles.place_count(),
        }
    }
}

/// The nodes below each child. A node's descendants lie in this order: the left child's, the left child, the right child,
/// the right child's.
fn places(
    node: u32,
    [left, right]: [NodeRef; 2],
    below: Range<u32>,
) -> Result<[Range<u32>; 2], TreeError> {
    let misplaced = |child: NodeRef| TreeError::ChildOutOfPlace {
        node,
        child: child.index(),
    };
    let (low, high) = (below.start, below.end);
    match (left.is_leaf(), right.is_leaf()) {
        (true, true) if low < high => Err(TreeError::NoParent { node: low }),
        (true, true) => Ok([low..low, low..low]),
        (false, true) if low < high && left.index() == high - 1 => Ok([low..high - 1, high..high]),
        (true, false) if low < high && right.index() == low => Ok([low..low, low + 1..high]),
        (false, false) => {
            let (a, b) = (left.index(), right.index());
            if a < low || a >= high {
                Err(misplaced(left))
            } else if b != a + 1 || b >= high {
                Err(misplaced(right))
            } else {
                Ok([low..a, b + 1..high])
            }
        }
        (false, true) => Err(misplaced(left)),
        (true, false) => Err(misplaced(right)),
    }
}

#[cfg(all(test, feature = "scenes"))]
mod tests;
