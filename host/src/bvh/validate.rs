//! Walks a hierarchy that is not to be trusted, and checks all that tracing, refits and codecs rely on.

use super::error::TreeError;
use super::view::{TreeView, Visit, is_in_scene};
use crate::{Bvh, Mesh};
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::snap::leaf_triangle;
use slimbvh_core::trace::STACK_SIZE;
use slimbvh_core::{Aabb, IndexedTriangles, MAX_TRIANGLES, NodeRef};
use std::ops::Range;

impl Bvh {
    /// Checks that each node and each place has one parent, in the order in which builds put them; that leaves hold triangles
    /// of the mesh, each at most once, with finite corners; that every child's box holds what is below it; and that no path is
    /// longer than the traversal's stack. What passes is traced and refitted without a panic, and no hit is lost in it. Hierarchies
    /// from a [`crate::Builder`] always pass.
    ///
    /// # Errors
    /// The first fault found.
    pub fn validate(&self) -> Result<(), TreeError> {
        self.check_numbers()?;
        self.walk(None)
    }

    /// [`Self::validate`], and that the leaves' triangles are those of a mesh, which must be sound, as the hierarchy stores
    /// them.
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

    /// All that stands beside the nodes.
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
        let mut check = Check {
            bvh: self,
            mesh,
            outcome: Ok(()),
        };
        self.show(&mut check);
        check.outcome
    }
}

/// Walks whatever is shown.
struct Check<'a> {
    bvh: &'a Bvh,
    mesh: Option<IndexedTriangles<'a>>,
    outcome: Result<(), TreeError>,
}

impl Visit for Check<'_> {
    fn visit<V: TreeView>(&mut self, view: &V) {
        let mut walk = Walk {
            view,
            depth_bound: self.bvh.depth_bound,
            mesh: self.mesh,
            scale: PowerOfTwo::new(self.bvh.scene_exponent),
            mesh_triangle_count: self.bvh.mesh_triangle_count,
            is_there: vec![0; self.bvh.mesh_triangle_count.div_ceil(64)],
            found: 0,
            end: 0,
        };
        self.outcome = walk.whole(self.bvh.triangle_count());
    }
}

struct Walk<'a, V> {
    view: &'a V,
    depth_bound: u32,
    mesh: Option<IndexedTriangles<'a>>,
    scale: PowerOfTwo,
    mesh_triangle_count: usize,
    /// A bit for each of the mesh's triangles.
    is_there: Vec<u64>,
    /// Triangles in leaves so far.
    found: u32,
    /// Where the last leaf so far ends.
    end: u32,
}

impl<V: TreeView> Walk<'_, V> {
    fn whole(&mut self, triangle_count: usize) -> Result<(), TreeError> {
        let node_count = self.view.node_count();
        if node_count == 0 {
            return Err(TreeError::NoRoot);
        }
        // Indices of nodes have 31 bits.
        let node_count = node_count.min(1 << 31) as u32;
        self.view.check_root()?;
        let root = self.view.root();
        if triangle_count <= LEAF_SIZE as usize {
            self.single(&root, triangle_count as u32, node_count)?;
        } else {
            self.node(0, &root, 1..node_count, 1)?;
        }
        if self.end as usize != self.view.place_count() {
            return Err(self.place_count(self.end.into()));
        }
        if self.found as usize != triangle_count {
            return Err(TreeError::LeafCount {
                found: self.found,
                expected: triangle_count,
            });
        }
        Ok(())
    }

    /// A tree of one leaf: all on the root's left.
    fn single(&mut self, root: &V::Box, count: u32, node_count: u32) -> Result<(), TreeError> {
        if node_count > 1 {
            return Err(TreeError::NoParent { node: 1 });
        }
        let ([left, right], [left_box, _]) = self.view.open(0, root);
        if left != NodeRef::leaf(0, count) || right != NodeRef::NOTHING {
            let count = left.count();
            return Err(TreeError::LeafSize {
                node: 0,
                count,
                limit: LEAF_SIZE,
            });
        }
        if count > 0 {
            self.child(0, left, &left_box, 0..0, 1)?;
        }
        self.check_run(0, 0)
    }

    /// Checks a node whose descendants must be these nodes. Returns the box around the triangles below.
    fn node(
        &mut self,
        node: u32,
        bounds: &V::Box,
        below: Range<u32>,
        depth: u32,
    ) -> Result<Aabb, TreeError> {
        if depth > self.depth_bound {
            return Err(TreeError::TooDeep {
                node,
                bound: self.depth_bound,
            });
        }
        let first = self.found;
        let ([left, right], [left_box, right_box]) = self.view.open(node, bounds);
        let [left_below, right_below] = places(node, [left, right], below)?;
        let left = self.child(node, left, &left_box, left_below, depth)?;
        let right = self.child(node, right, &right_box, right_below, depth)?;
        let count = self.found - first;
        if count <= LEAF_SIZE {
            return Err(TreeError::NodeSize { node, count });
        }
        self.check_run(node, first)?;
        Ok(left.union(right))
    }

    /// What a node says of its triangles, where it does.
    fn check_run(&self, node: u32, expected: u32) -> Result<(), TreeError> {
        match self.view.run(node) {
            Some([first, last]) if first != expected || last != self.found.saturating_sub(1) => {
                Err(TreeError::WrongRun { node, first, last })
            }
            _ => Ok(()),
        }
    }

    /// Checks a child that is there, and that its box holds what is below it.
    fn child(
        &mut self,
        parent: u32,
        child: NodeRef,
        bounds: &V::Box,
        below: Range<u32>,
        depth: u32,
    ) -> Result<Aabb, TreeError> {
        let stored = self.view.aabb(bounds);
        if !is_in_scene(&stored) {
            return Err(TreeError::BadBox { node: parent });
        }
        let exact = if child.is_leaf() {
            self.leaf(parent, child, bounds)?
        } else {
            self.node(child.index(), bounds, below, depth + 1)?
        };
        if stored.contains(&exact) {
            Ok(exact)
        } else {
            Err(TreeError::BoxTooSmall { node: parent })
        }
    }

    /// Checks a leaf. Returns the box around its triangles.
    fn leaf(&mut self, node: u32, leaf: NodeRef, bounds: &V::Box) -> Result<Aabb, TreeError> {
        let (first, count) = (leaf.first(), leaf.count());
        if !(1..=LEAF_SIZE).contains(&count) {
            return Err(TreeError::LeafSize {
                node,
                count,
                limit: LEAF_SIZE,
            });
        }
        if first != self.end {
            return Err(TreeError::LeafOutOfPlace {
                node,
                first,
                expected: self.end,
            });
        }
        let end = u64::from(first) + u64::from(count) * u64::from(self.view.stride(bounds));
        if end > self.view.place_count() as u64 {
            return Err(self.place_count(end));
        }
        let mut exact = Aabb::EMPTY;
        for number in 0..count {
            exact = exact.union(self.triangle((first, number), bounds)?);
        }
        self.end = end as u32;
        Ok(exact)
    }

    /// Checks a leaf's triangle. Returns the box around it.
    fn triangle(&mut self, place: (u32, u32), bounds: &V::Box) -> Result<Aabb, TreeError> {
        let triangle = self.found;
        let stored = self.view.triangle(place, bounds);
        if !stored.vertices.iter().all(|x| x.is_finite()) {
            return Err(TreeError::NotFinite { triangle });
        }
        let primitive = stored.primitive;
        let (word, bit) = (primitive as usize / 64, 1 << (primitive % 64));
        match self.is_there.get_mut(word) {
            Some(bits) if *bits & bit == 0 && (primitive as usize) < self.mesh_triangle_count => {
                *bits |= bit;
            }
            _ => {
                return Err(TreeError::BadPrimitive {
                    triangle,
                    primitive,
                });
            }
        }
        if let Some(mesh) = &self.mesh {
            let exact = leaf_triangle(primitive, mesh, &self.scale);
            if !self.view.stores(place, bounds, &exact) {
                return Err(TreeError::OtherCorners {
                    triangle,
                    primitive,
                });
            }
        }
        self.found += 1;
        Ok(stored.triangle().bounds())
    }

    fn place_count(&self, end: u64) -> TreeError {
        TreeError::PlaceCount {
            end,
            count: self.view.place_count(),
        }
    }
}

/// Which nodes lie below each child, of those below their parent: first all on the left, the left child as the last of them,
/// then the right child and all below it.
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
