//! Validation of an untrusted hierarchy: everything that tracing, refits and codecs rely on.

use super::bvh::Bvh;
use super::error::TreeError;
use super::sources::{StoredNodes, StoredTriangles, is_in_scene};
use super::visitor::TreeVisitor;
use crate::Mesh;
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::snap::leaf_triangle;
use slimbvh_core::trace::STACK_SIZE;
use slimbvh_core::{Aabb, IndexedTriangles, MAX_TRIANGLES, NodeRef};
use std::ops::Range;
use std::sync::atomic::AtomicU64;
use std::sync::atomic::Ordering::Relaxed;

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
        let word_count = self.bvh.mesh_triangle_count.div_ceil(64);
        let walk = Walk {
            nodes,
            triangles,
            depth_bound: self.bvh.depth_bound,
            mesh: self.mesh,
            scale: PowerOfTwo::new(self.bvh.scene_exponent),
            mesh_triangle_count: self.bvh.mesh_triangle_count,
            is_there: (0..word_count).map(|_| AtomicU64::new(0)).collect(),
        };
        walk.whole(self.bvh.triangle_count())
    }
}

/// Nodes with fewer nodes below them are checked on one thread.
const TASK: u32 = 1024;

struct Walk<'a, N, T> {
    nodes: &'a N,
    triangles: &'a T,
    depth_bound: u32,
    mesh: Option<IndexedTriangles<'a>>,
    scale: PowerOfTwo,
    mesh_triangle_count: usize,
    /// A bit for each of the mesh's triangles.
    is_there: Vec<AtomicU64>,
}

/// The triangles below a node.
struct Found {
    /// The box around the triangles.
    bounds: Aabb,
    /// Their places.
    places: Range<u32>,
    /// Their number.
    count: u32,
}

/// A child to be checked.
struct Child<B> {
    parent: u32,
    child: NodeRef,
    bounds: B,
    /// The nodes that must be below it.
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

    /// A tree of one leaf, on the root's left.
    fn single(&self, root: &N::Box, count: u32, node_count: u32) -> Result<Found, TreeError> {
        if node_count > 1 {
            return Err(TreeError::NoParent { node: 1 });
        }
        let ([left, right], [left_box, _]) = self.nodes.open(0, root);
        if left != NodeRef::leaf(0, count) || right != NodeRef::EMPTY_LEAF {
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
        let is_task = below.end - below.start >= TASK;
        let ([left, right], [left_box, right_box]) = self.nodes.open(node, bounds);
        let [left_below, right_below] = places(node, [left, right], below)?;
        let child = |child, bounds, below| Child {
            parent: node,
            child,
            bounds,
            below,
            depth,
        };
        let left = child(left, left_box, left_below);
        let right = child(right, right_box, right_below);
        let (left, right) = if is_task {
            let (left, right) = rayon::join(|| self.child(left), || self.child(right));
            (left?, right?)
        } else {
            (self.child(left)?, self.child(right)?)
        };
        if right.places.start != left.places.end {
            return Err(TreeError::LeafOutOfPlace {
                node,
                first: right.places.start,
                expected: left.places.end,
            });
        }
        let found = Found {
            bounds: left.bounds.union(right.bounds),
            places: left.places.start..right.places.end,
            count: left.count + right.count,
        };
        if found.count <= LEAF_SIZE {
            return Err(TreeError::NodeSize {
                node,
                count: found.count,
            });
        }
        self.check_run(node, &found)?;
        Ok(found)
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
        let end = u64::from(first) + u64::from(count) * u64::from(self.triangles.stride(bounds));
        if end > self.triangles.place_count() as u64 {
            return Err(self.place_count(end));
        }
        let mut exact = Aabb::EMPTY;
        for number in 0..count {
            exact = exact.union(self.triangle((first, number), bounds)?);
        }
        Ok(Found {
            bounds: exact,
            places: first..end as u32,
            count,
        })
    }

    /// Checks a leaf's triangle. Returns its box.
    fn triangle(&self, place: (u32, u32), bounds: &N::Box) -> Result<Aabb, TreeError> {
        let at = || place.0 + place.1 * self.triangles.stride(bounds);
        let stored = self.triangles.triangle(place, bounds);
        if !stored.vertices.iter().all(|x| x.is_finite()) {
            return Err(TreeError::NotFinite { place: at() });
        }
        let primitive = stored.primitive;
        let (word, bit) = (primitive as usize / 64, 1 << (primitive % 64));
        let is_new = (primitive as usize) < self.mesh_triangle_count
            && self.is_there[word].fetch_or(bit, Relaxed) & bit == 0;
        if !is_new {
            let place = at();
            return Err(TreeError::BadPrimitive { place, primitive });
        }
        if let Some(mesh) = &self.mesh {
            let exact = leaf_triangle(primitive, mesh, &self.scale);
            if !self.triangles.stores(place, bounds, &exact) {
                let place = at();
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
