//! Builds and refits on the CPU.

use super::order::{gather, gather_again, order, scene_bounds};
use super::refit::{fill_boxes, fill_pyramid};
use super::sort::Sorter;
use super::topology::Connections;
use crate::{Bvh, Mesh, MeshError, Stages};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::morton::{Frame, morton_code_30, morton_code_63};
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::refit::{PyramidBox, split_of};
use slimbvh_core::topology::{Codes30, Codes63, depth_bound, single_node};
use slimbvh_core::{Aabb, NodeRef};
use thiserror::Error;

/// How finely triangles are told apart along the space-filling curve.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CodeBits {
    /// 10 bits an axis: 1024 cells along the longest side.
    #[default]
    Bits30,
    /// 21 bits an axis, for scenes with small details: a teapot in a stadium.
    Bits63,
}

/// How to build.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BuildConfig {
    /// Length of the Morton codes.
    pub code_bits: CodeBits,
}

/// Why a hierarchy cannot be moved to a mesh.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum RefitError {
    /// The mesh itself is unfit.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// It is another mesh.
    #[error("the mesh has {triangle_count} triangles, the hierarchy {expected}; build a new one")]
    TriangleCount {
        /// Triangles of the mesh.
        triangle_count: usize,
        /// Triangles of the hierarchy.
        expected: usize,
    },
}

/// Builds hierarchies, and keeps its buffers from one to the next.
#[derive(Debug, Default)]
pub struct Builder {
    config: BuildConfig,
    sorter_30: Sorter<1>,
    sorter_63: Sorter<2>,
    codes_30: Vec<[u32; 1]>,
    codes_63: Vec<[u32; 2]>,
    connections: Connections,
    pyramid: Vec<PyramidBox>,
}

impl Builder {
    /// A builder without buffers yet.
    #[must_use]
    pub fn new(config: BuildConfig) -> Self {
        Self {
            config,
            ..Self::default()
        }
    }

    /// Builds a hierarchy over a mesh in a new place.
    ///
    /// # Errors
    /// Those of [`Mesh::validate`].
    pub fn build(&mut self, mesh: &Mesh) -> Result<Bvh, MeshError> {
        let mut bvh = Bvh::default();
        self.build_into(mesh, &mut bvh)?;
        Ok(bvh)
    }

    /// Builds a hierarchy over a mesh in place of an earlier one, whose memory is used again. Returns the time of each
    /// stage.
    ///
    /// # Errors
    /// Those of [`Mesh::validate`]; the earlier hierarchy stays as it was.
    pub fn build_into(&mut self, mesh: &Mesh, bvh: &mut Bvh) -> Result<Stages, MeshError> {
        let mut stages = Stages::default();
        stages.time("validate", || mesh.validate())?;
        let triangles = mesh.triangles();
        let count = mesh.indices.len() as u32;
        let bounds = stages.time("bounds", || scene_bounds(&triangles));
        bvh.set_bounds(bounds);
        let scale = PowerOfTwo::new(bvh.scene_exponent);
        match self.config.code_bits {
            CodeBits::Bits30 => {
                let frame = Frame::new(&bounds, 10);
                let code = |bounds: &Aabb| [morton_code_30(bounds, &frame)];
                order(&mut stages, &mut self.sorter_30, [30], &triangles, code);
                stages.time("snap", || {
                    let codes = &mut self.codes_30;
                    gather(
                        &mut self.sorter_30,
                        &triangles,
                        &scale,
                        &mut bvh.triangles,
                        codes,
                    );
                });
            }
            CodeBits::Bits63 => {
                let frame = Frame::new(&bounds, 21);
                let code = |bounds: &Aabb| morton_code_63(bounds, &frame);
                order(&mut stages, &mut self.sorter_63, [31, 32], &triangles, code);
                stages.time("snap", || {
                    let codes = &mut self.codes_63;
                    gather(
                        &mut self.sorter_63,
                        &triangles,
                        &scale,
                        &mut bvh.triangles,
                        codes,
                    );
                });
            }
        }
        stages.time("topology", || {
            if count <= LEAF_SIZE {
                bvh.nodes.clear();
                bvh.nodes.push(single_node(count));
                self.connections.splits.clear();
                self.connections.splits.push(split_of(&bvh.nodes[0], 0));
                return;
            }
            let (connections, nodes) = (&mut self.connections, &mut bvh.nodes);
            match self.config.code_bits {
                CodeBits::Bits30 => {
                    connections.connect(&Codes30(bytemuck::cast_slice(&self.codes_30)), nodes);
                }
                CodeBits::Bits63 => connections.connect(&Codes63(&self.codes_63), nodes),
            }
        });
        bvh.depth_bound = match self.config.code_bits {
            CodeBits::Bits30 => depth_bound(30, count),
            CodeBits::Bits63 => depth_bound(63, count),
        };
        stages.time("refit", || self.fit(bvh));
        Ok(stages)
    }

    /// Moves a hierarchy's boxes to where the mesh's vertices are now; the triangles must be those that it was built over.
    /// Returns the time of each stage.
    ///
    /// # Errors
    /// Those of [`Mesh::validate`], and a mesh with another number of triangles; the hierarchy stays as it was.
    pub fn refit(&mut self, mesh: &Mesh, bvh: &mut Bvh) -> Result<Stages, RefitError> {
        let mut stages = Stages::default();
        stages.time("validate", || mesh.validate())?;
        if mesh.indices.len() != bvh.triangles.len() {
            return Err(RefitError::TriangleCount {
                triangle_count: mesh.indices.len(),
                expected: bvh.triangles.len(),
            });
        }
        let triangles = mesh.triangles();
        let bounds = stages.time("bounds", || scene_bounds(&triangles));
        bvh.set_bounds(bounds);
        let scale = PowerOfTwo::new(bvh.scene_exponent);
        stages.time("snap", || {
            gather_again(&triangles, &scale, &mut bvh.triangles);
        });
        stages.time("refit", || {
            let last_of =
                |child: NodeRef| bvh.nodes.get(child.index() as usize).map_or(0, |n| n.last);
            self.connections.splits.clear();
            self.connections.splits.extend(
                bvh.nodes
                    .iter()
                    .map(|node| split_of(node, last_of(node.left))),
            );
            self.fit(bvh);
        });
        Ok(stages)
    }

    /// Stage `refit`: all boxes.
    fn fit(&mut self, bvh: &mut Bvh) {
        fill_pyramid(&bvh.triangles, &mut self.pyramid);
        if !bvh.triangles.is_empty() {
            fill_boxes(
                &bvh.triangles,
                &self.pyramid,
                &self.connections.splits,
                &mut bvh.nodes,
            );
        }
    }

    /// Bytes of the buffers that the last build used; they are kept for the next.
    #[must_use]
    pub fn scratch_bytes(&self) -> usize {
        self.sorter_30.bytes()
            + self.sorter_63.bytes()
            + size_of_val(self.codes_30.as_slice())
            + size_of_val(self.codes_63.as_slice())
            + self.connections.bytes()
            + size_of_val(self.pyramid.as_slice())
    }
}
