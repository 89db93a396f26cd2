//! Builds and refits on the CPU.

use super::bounds::scene_bounds;
use super::classify::Division;
use super::cluster::Clustering;
use super::encode::{Encoder, Unstored};
use super::order::Order;
use super::refit::{fill_boxes, fill_pyramid};
use super::snap::gather_again;
use super::sweep::Sweep;
use super::topology::Connections;
use crate::tree::{Bvh, NodeCodec, most_triangles};
use crate::{BuildConfig, CodeBits, Mesh, MeshError, RefitError, Stages, TreeKind};
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::classify::VisibleSet;
use slimbvh_core::cluster;
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::morton::{MortonGrid, morton_code_30, morton_code_63};
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::refit::PyramidBox;
use slimbvh_core::topology::{Codes30, Codes63, depth_bound};
use slimbvh_core::{Aabb, LeafTriangle, Node};

/// The triangles of a hierarchy.
#[derive(Clone, Copy, Debug)]
pub enum Subset<'a> {
    /// All triangles of the mesh.
    All,
    /// Those that rays of one kind may hit. In the mesh's unit.
    Of(VisibleSet<'a>),
}

/// Builds hierarchies. Keeps its buffers from one build to the next.
#[derive(Debug, Default)]
pub struct Builder {
    config: BuildConfig,
    bounds: Option<Aabb>,
    order_30: Order<1>,
    order_63: Order<2>,
    clustering: Clustering,
    sweep: Sweep,
    connections: Connections,
    pyramid: Vec<PyramidBox>,
    encoder: Encoder,
    division: Division,
}

impl Builder {
    /// A builder with empty buffers.
    ///
    /// # Panics
    /// If the codecs of nodes and triangles cannot be combined ([`crate::check_codecs`]).
    #[must_use]
    pub fn new(config: BuildConfig) -> Self {
        if let Err(error) = crate::check_codecs(config.nodes, config.mesh) {
            panic!("{error}");
        }
        Self {
            config,
            ..Self::default()
        }
    }

    /// Builds a new hierarchy over a mesh.
    ///
    /// # Errors
    /// Those of [`Mesh::validate`].
    pub fn build(&mut self, mesh: &Mesh) -> Result<Bvh, MeshError> {
        let mut bvh = Bvh::default();
        self.build_into(mesh, &mut bvh)?;
        Ok(bvh)
    }

    /// Builds a hierarchy over a mesh in the memory of an earlier one. Returns the time of each stage.
    ///
    /// # Errors
    /// Those of [`Mesh::validate`]; then the earlier hierarchy is unchanged.
    pub fn build_into(&mut self, mesh: &Mesh, bvh: &mut Bvh) -> Result<Stages, MeshError> {
        let mut stages = self.sort(mesh)?;
        stages.merge(&self.build_sorted(mesh, Subset::All, bvh));
        Ok(stages)
    }

    /// Sorts a mesh's triangles along the space-filling curve, once for all hierarchies over subsets of them. Returns the
    /// time of each stage.
    ///
    /// # Errors
    /// Those of [`Mesh::validate`].
    pub fn sort(&mut self, mesh: &Mesh) -> Result<Stages, MeshError> {
        self.sort_some(mesh, None)
    }

    /// Checks that the builder can store the mesh.
    fn check(&self, mesh: &Mesh) -> Result<(), MeshError> {
        mesh.validate()?;
        let triangle_count = mesh.indices.len();
        let limit = most_triangles(self.config.nodes, self.config.mesh);
        if triangle_count > limit {
            return Err(MeshError::TooManyTriangles {
                triangle_count,
                limit,
            });
        }
        match self.config.mesh.step_exponent() {
            Some(step_exponent) => mesh.check_lattice(step_exponent),
            None => Ok(()),
        }
    }

    /// Sorts a mesh's triangles, all or those of a set.
    fn sort_some(&mut self, mesh: &Mesh, reach: Option<&VisibleSet>) -> Result<Stages, MeshError> {
        let mut stages = Stages::default();
        stages.time("validate", || self.check(mesh))?;
        let triangles = mesh.triangles();
        let bounds = stages.time("bounds", || scene_bounds(&triangles));
        self.bounds = Some(bounds);
        let scale = PowerOfTwo::new(scene_exponent(&bounds));
        let to = &mut stages;
        match self.config.code_bits {
            CodeBits::Bits30 => {
                let grid = MortonGrid::new(&bounds, 10);
                let code = |bounds: &Aabb| [morton_code_30(bounds, &grid)];
                let order = &mut self.order_30;
                match reach {
                    None => order.sort(to, [30], &triangles, code),
                    Some(reach) => order.sort_set(to, [30], &triangles, (&scale, reach), code),
                }
            }
            CodeBits::Bits63 => {
                let grid = MortonGrid::new(&bounds, 21);
                let code = |bounds: &Aabb| morton_code_63(bounds, &grid);
                let order = &mut self.order_63;
                match reach {
                    None => order.sort(to, [31, 32], &triangles, code),
                    Some(reach) => order.sort_set(to, [31, 32], &triangles, (&scale, reach), code),
                }
            }
        }
        Ok(stages)
    }

    /// Builds a hierarchy over a subset of a mesh's triangles, sorting only those. If this is the only hierarchy, it is
    /// less work than [`Self::sort`] and [`Self::build_sorted`], with the same result.
    ///
    /// # Errors
    /// Those of [`Mesh::validate`]; then the earlier hierarchy is unchanged.
    pub fn build_subset(
        &mut self,
        mesh: &Mesh,
        subset: Subset,
        bvh: &mut Bvh,
    ) -> Result<Stages, MeshError> {
        let Subset::Of(reach) = subset else {
            return self.build_into(mesh, bvh);
        };
        let mut stages = self.sort_some(mesh, Some(&reach))?;
        stages.merge(&self.build_sorted(mesh, Subset::All, bvh));
        Ok(stages)
    }

    /// Follows a mesh whose vertices moved a little since it was sorted. Hierarchies built from now on keep the existing
    /// order. They hold the same triangles and give the same answers as with a new order, but their boxes are as loose as a
    /// refit's.
    ///
    /// # Errors
    /// Those of [`Mesh::validate`], and [`RefitError::TriangleCount`] for another mesh than the one sorted.
    pub fn follow(&mut self, mesh: &Mesh) -> Result<Stages, RefitError> {
        let mut stages = Stages::default();
        stages.time("validate", || mesh.validate())?;
        let expected = match self.config.code_bits {
            CodeBits::Bits30 => self.order_30.len(),
            CodeBits::Bits63 => self.order_63.len(),
        };
        let triangle_count = mesh.indices.len();
        if triangle_count != expected {
            return Err(RefitError::TriangleCount {
                triangle_count,
                expected,
            });
        }
        let bounds = stages.time("bounds", || scene_bounds(&mesh.triangles()));
        self.bounds = Some(bounds);
        Ok(stages)
    }

    /// Builds a hierarchy over the mesh that was sorted last, or a subset of it, in the memory of an earlier one. Returns
    /// the time of each stage.
    ///
    /// # Panics
    /// If the mesh is not the one passed to [`Self::sort`].
    pub fn build_sorted(&mut self, mesh: &Mesh, subset: Subset, bvh: &mut Bvh) -> Stages {
        let mut stages = Stages::default();
        let bounds = self.bounds.unwrap_or(Aabb::EMPTY);
        bvh.set_bounds(bounds);
        bvh.mesh_triangle_count = mesh.indices.len();
        let mut leaves = self.encoder.leaves(&mut bvh.stored);
        let scale = PowerOfTwo::new(bvh.scene_exponent);
        let triangles = mesh.triangles();
        let to = &mut stages;
        match self.config.code_bits {
            CodeBits::Bits30 => {
                let order = &mut self.order_30;
                match subset {
                    Subset::All => order.gather(to, &triangles, &scale, &mut leaves),
                    Subset::Of(reach) => {
                        order.gather_set(to, &triangles, (&scale, &reach), &mut leaves);
                    }
                }
            }
            CodeBits::Bits63 => {
                let order = &mut self.order_63;
                match subset {
                    Subset::All => order.gather(to, &triangles, &scale, &mut leaves),
                    Subset::Of(reach) => {
                        order.gather_set(to, &triangles, (&scale, &reach), &mut leaves);
                    }
                }
            }
        }
        let mut nodes = self.encoder.nodes(self.config.nodes, &mut bvh.stored);
        let count = leaves.len() as u32;
        // One leaf needs no merging.
        if self.config.tree == TreeKind::Clustered && count > LEAF_SIZE {
            let clustering = &mut self.clustering;
            stages.time("cluster", || clustering.merge(&leaves));
            stages.time("topology", || {
                clustering.connect(&mut leaves, &mut self.connections);
            });
            stages.time("refit", || self.fit(&leaves, &mut nodes));
        } else {
            // With all boxes.
            stages.time("topology", || match self.config.code_bits {
                CodeBits::Bits30 => {
                    let codes = bytemuck::cast_slice(&self.order_30.codes);
                    (self.sweep).fill(&Codes30 { codes, count }, &leaves, &mut nodes);
                }
                CodeBits::Bits63 => {
                    let codes = &self.order_63.codes;
                    (self.sweep).fill(&Codes63 { codes, count }, &leaves, &mut nodes);
                }
            });
        }
        bvh.depth_bound = match (self.config.tree, self.config.code_bits) {
            (TreeKind::Clustered, _) => cluster::depth_bound(count),
            (TreeKind::Radix, CodeBits::Bits30) => depth_bound(30, count),
            (TreeKind::Radix, CodeBits::Bits63) => depth_bound(63, count),
        };
        self.store(&mut stages, nodes, leaves, bvh);
        stages
    }

    /// Finds a set as [`Division::divide`] does, in reused memory.
    pub(super) fn divide(&mut self, mesh: &Mesh, reach: &VisibleSet) -> Stages {
        self.division.divide(mesh, reach)
    }

    /// Refits a hierarchy's boxes to the present vertices of the mesh that it was built over. Returns the time of each
    /// stage.
    ///
    /// # Errors
    /// Those of [`Mesh::validate`], and a mesh with a different number of triangles; then the hierarchy is unchanged.
    pub fn refit(&mut self, mesh: &Mesh, bvh: &mut Bvh) -> Result<Stages, RefitError> {
        let mut stages = Stages::default();
        stages.time("validate", || self.check(mesh))?;
        if mesh.indices.len() != bvh.mesh_triangle_count {
            return Err(RefitError::TriangleCount {
                triangle_count: mesh.indices.len(),
                expected: bvh.mesh_triangle_count,
            });
        }
        if bvh.triangle_count() != bvh.mesh_triangle_count {
            return Err(RefitError::Reduced);
        }
        let codecs = (self.config.nodes, self.config.mesh);
        if bvh.keeps_shape(codecs) {
            self.refit_wide(&mut stages, mesh, bvh);
            return Ok(stages);
        }
        // A tree in a codec is decoded first; its boxes are replaced.
        let mut decoded = match bvh.stored.as_plain() {
            Some(_) => None,
            None => Some(stages.time("decode", || bvh.stored.decode())),
        };
        let triangles = mesh.triangles();
        let bounds = stages.time("bounds", || scene_bounds(&triangles));
        bvh.set_bounds(bounds);
        let scale = PowerOfTwo::new(bvh.scene_exponent);
        let mut leaves = match &mut decoded {
            Some(plain) => std::mem::take(&mut plain.triangles),
            None => bvh.stored.take_full_triangles(),
        };
        stages.time("snap", || gather_again(&triangles, &scale, &mut leaves));
        let nodes = decoded.as_ref().map_or(bvh.nodes(), |plain| &plain.nodes);
        stages.time("refit", || self.connections.follow(nodes));
        let mut nodes = self.encoder.nodes(self.config.nodes, &mut bvh.stored);
        stages.time("refit", || self.fit(&leaves, &mut nodes));
        self.store(&mut stages, nodes, leaves, bvh);
        Ok(stages)
    }

    /// The refit of a wide tree that stays as it is stored: its nodes keep their children and their places.
    fn refit_wide(&mut self, stages: &mut Stages, mesh: &Mesh, bvh: &mut Bvh) {
        let mut shape = stages.time("decode", || bvh.stored.wide_shape());
        let triangles = mesh.triangles();
        let bounds = stages.time("bounds", || scene_bounds(&triangles));
        bvh.set_bounds(bounds);
        let scale = PowerOfTwo::new(bvh.scene_exponent);
        let leaves = &mut shape.triangles;
        stages.time("snap", || gather_again(&triangles, &scale, leaves));
        stages.time("refit", || fill_pyramid(leaves, &mut self.pyramid));
        let scene = (self.pyramid.as_slice(), bvh.scene_exponent);
        let (encoder, mesh) = (&mut self.encoder, self.config.mesh);
        let stored = &mut bvh.stored;
        stages.time("encode", || encoder.store_again(mesh, shape, scene, stored));
    }

    /// Stage `refit`: all nodes with their boxes.
    fn fit(&mut self, leaves: &[LeafTriangle], nodes: &mut Vec<Node>) {
        fill_pyramid(leaves, &mut self.pyramid);
        fill_boxes(leaves, &self.pyramid, &self.connections, nodes);
    }

    /// Stores a tree: in full, or by stage `encode`.
    fn store(
        &mut self,
        stages: &mut Stages,
        nodes: Vec<Node>,
        leaves: Vec<LeafTriangle>,
        bvh: &mut Bvh,
    ) {
        let codecs = (self.config.nodes, self.config.mesh);
        let tree = Unstored {
            nodes,
            leaves,
            scene_exponent: bvh.scene_exponent,
        };
        let (encoder, stored) = (&mut self.encoder, &mut bvh.stored);
        if self.config.nodes == NodeCodec::default() {
            encoder.store(codecs, tree, stored);
        } else {
            stages.time("encode", || encoder.store(codecs, tree, stored));
        }
    }

    /// Bytes of the buffers that the last build used. The next build reuses them.
    #[must_use]
    pub fn scratch_bytes(&self) -> usize {
        self.order_30.bytes()
            + self.order_63.bytes()
            + self.clustering.bytes()
            + self.sweep.bytes()
            + self.connections.bytes()
            + size_of_val(self.pyramid.as_slice())
            + self.encoder.bytes()
    }
}
