//! Uploads of a hierarchy.

use super::{Built, Bvh, Coding, PLACEHOLDER_BYTES, STATE_BYTES, full_triangles};
use crate::BuildConfig;
use crate::gpu::buffer::Range;
use crate::gpu::{Gpu, GpuError, Misfit};
use bytemuck::{bytes_of, cast_slice};
use slimbvh_core::launch::dispatch_each;
use slimbvh_core::{Aabb, LeafTriangle, Node};

/// Advice for a hierarchy that is too large.
const TOO_LARGE: &str = "take a smaller mesh, nodes and triangles of fewer bytes, or the CPU";

impl Bvh {
    /// Copies a hierarchy to the GPU, in full or in its codec. The buffers have exactly its size, and [`Self::download`]
    /// returns the same bytes. All frames submitted later can trace it. A [`crate::gpu::Builder`] can refit it if it is in
    /// full and whole, and can always build it again.
    ///
    /// # Errors
    /// For a codec without GPU kernels, an unbuilt hierarchy, and one above the GPU's limits, before anything is allocated;
    /// if memory is exhausted, or the device was lost.
    pub fn upload(gpu: &Gpu, bvh: &crate::Bvh) -> Result<Self, GpuError> {
        let coding = coding_of(bvh)?;
        let [nodes, triangles] = bvh.stored();
        if nodes.is_empty() {
            return Err(Misfit::NotBuilt.of("the hierarchy"));
        }
        let sizes = [
            ("the nodes of the hierarchy", nodes.len() as u64),
            ("the triangles of the hierarchy", triangles.len() as u64),
        ];
        gpu.check_sizes(&sizes, TOO_LARGE)?;
        gpu.checked(|| {
            let mut uploaded = Self::new();
            uploaded.fill(gpu, bvh, coding);
            Ok(uploaded)
        })
    }

    /// Makes room for a hierarchy, and writes it.
    fn fill(&mut self, gpu: &Gpu, bvh: &crate::Bvh, coding: Option<Coding>) {
        let [nodes, triangles] = bvh.stored();
        let node_bytes = coding.map_or(size_of::<Node>() as u64, Coding::node_bytes);
        // No binding can be empty.
        let each = coding.and_then(|coding| coding.most_triangle_bytes(1));
        let bytes = triangles.len() as u64;
        let triangle_range = match each {
            Some(room) => self.triangles.range(gpu, room.max(bytes)),
            None => {
                let bytes = bytes.max(size_of::<LeafTriangle>() as u64);
                full_triangles(gpu, &mut self.triangles, bytes)
            }
        };
        let node_range = self.nodes.range(gpu, nodes.len() as u64);
        let node_range = node_range.touching_nodes(node_bytes);
        let built = Built {
            nodes: node_range.clone(),
            triangles: triangle_range.clone(),
            codecs: bvh.codecs(),
            coded: coding.map(|coding| self.coded(gpu, coding, [node_range, triangle_range])),
            exponent: self.exponent.range(gpu, STATE_BYTES),
            bounds: self.bounds.range(gpu, 24),
            total: self.total.range(gpu, STATE_BYTES),
            count: self.count.range(gpu, STATE_BYTES),
            placeholder: self.placeholder.range(gpu, PLACEHOLDER_BYTES),
            triangle_count: bvh.mesh_triangle_count() as u32,
            room: bvh.triangle_count() as u32,
            fallback: None,
            is_reduced: bvh.triangle_count() < bvh.mesh_triangle_count(),
            depth_bound: bvh.depth_bound(),
        };
        let write = |to: &Range, bytes: &[u8]| {
            if !bytes.is_empty() {
                gpu.queue().write_buffer(&to.buffer, to.offset, bytes);
            }
        };
        let [node_range, triangle_range] = built.stored();
        write(node_range, nodes);
        write(triangle_range, triangles);
        if let Some(coded) = &built.coded {
            // Nodes in full are decoded without.
            let root = bvh.root_words().unwrap_or_default();
            write(&coded.root, bytes_of(&root));
            let words = if coded.coding.is_mixed() {
                triangles.len() as u32 / 4
            } else {
                0
            };
            let inner = if coded.coding.is_wide() {
                bvh.node_count() as u32 - 1
            } else {
                0
            };
            write(&coded.word_total, bytes_of(&dispatch_each(words + inner)));
            if coded.coding.is_wide() {
                write(&coded.inner_total, bytes_of(&dispatch_each(inner)));
            }
        }
        let bounds = bvh.bounds().unwrap_or(Aabb::EMPTY);
        let corners = [bounds.min, bounds.max].map(|corner| corner.to_array());
        write(&built.bounds, cast_slice(&corners));
        let exponent = [bvh.scene_exponent(), 0, 0, 0];
        write(&built.exponent, bytes_of(&exponent));
        write(
            &built.total,
            bytes_of(&dispatch_each(bvh.node_count() as u32)),
        );
        write(
            &built.count,
            bytes_of(&dispatch_each(bvh.triangle_count() as u32)),
        );
        self.built = Some(built);
    }
}

/// The coding of a hierarchy, if the GPU has kernels for it.
fn coding_of(bvh: &crate::Bvh) -> Result<Option<Coding>, GpuError> {
    let (nodes, mesh) = bvh.codecs();
    Coding::of(&BuildConfig {
        nodes,
        mesh,
        ..BuildConfig::default()
    })
}
