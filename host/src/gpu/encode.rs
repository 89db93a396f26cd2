//! Stage `encode`: nodes and triangles in codecs, in one dispatch, or in three around a scan.

use super::buffer::{Range, Slot};
use super::bvh::{Built, Coded};
use super::coding::Encodes;
use super::program::{Groups, Recorder, Uniform, threads};
use super::scan::Scan;
use super::{Gpu, Kernel};
use slimbvh_core::encode::LeafCorner;
use wgpu::BufferUsages;

/// Codes hierarchies, and keeps its buffers and what is plain of them.
#[derive(Debug)]
pub struct Encoder {
    nodes: Slot,
    triangles: Slot,
    corners: Slot,
    sizes: Slot,
    scan: Scan,
}

impl Encoder {
    /// An encoder without buffers yet.
    pub const fn new() -> Self {
        let copied = BufferUsages::STORAGE.union(BufferUsages::COPY_DST);
        Self {
            nodes: Slot::storage("slimbvh plain nodes"),
            triangles: Slot::new("slimbvh plain leaf triangles", copied),
            corners: Slot::storage("slimbvh leaf corners"),
            sizes: Slot::new("slimbvh triangle sizes", copied),
            scan: Scan::new(),
        }
    }

    /// A place for plain nodes, before they are coded.
    pub fn plain_nodes(&mut self, gpu: &Gpu, bytes: u64) -> Range {
        self.nodes.range(gpu, bytes)
    }

    /// A place for plain triangles, before they are coded.
    pub fn plain_triangles(&mut self, gpu: &Gpu, bytes: u64) -> Range {
        self.triangles.range(gpu, bytes)
    }

    /// Records that a plain hierarchy be coded; `each_node` gives every node a thread, `step` is that of the lattice,
    /// as kernels want it.
    pub fn record(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        bvh: &Built,
        coded: &Coded,
        step: [u32; 4],
        each_node: impl Fn() -> Groups,
    ) {
        recorder.stage("encode");
        let total = Uniform::Stored(&bvh.total);
        // What no compiler knows.
        let zero = Uniform::Params([0; 4]);
        let (plain, leaves) = (&bvh.nodes, &bvh.triangles);
        let (nodes, root) = (&coded.nodes, &coded.root);
        let (sizes_kernel, links_kernel) = match coded.coding.encodes() {
            Encodes::Nodes(kernel) => {
                return recorder.dispatch(kernel, &[total], &[plain], &[nodes, root], each_node());
            }
            Encodes::NodesInFloats(kernel) => {
                let to = &[nodes, root];
                return recorder.dispatch(kernel, &[total, zero], &[plain], to, each_node());
            }
            Encodes::AllInFloats(kernel) => {
                let to = &[nodes, &coded.triangles, root];
                let from = &[plain, leaves];
                return recorder.dispatch(kernel, &[total, zero], from, to, each_node());
            }
            Encodes::Mixed { sizes, links } => (sizes, links),
        };

        // How many words each triangle takes follows from its leaf's box; where it begins, from all before it.
        const CORNER_BYTES: u64 = size_of::<LeafCorner>() as u64;
        let count = u64::from(bvh.triangle_count.max(1));
        let corners = &self.corners.range(gpu, CORNER_BYTES * count);
        let sizes = &self.sizes.range(gpu, 4 * count);
        // A reduced hierarchy has no more triangles than that, and a scan sums all there are.
        recorder.clear(sizes);
        recorder.dispatch(
            sizes_kernel,
            &[total, Uniform::Stored(&bvh.exponent), Uniform::Params(step)],
            &[plain],
            &[nodes, corners, sizes, root],
            each_node(),
        );
        self.scan.record(gpu, recorder, sizes, &coded.word_total);
        recorder.read(nodes);
        recorder.dispatch(
            Kernel::encode_triangles,
            &[Uniform::Stored(&bvh.count), Uniform::Stored(root)],
            &[leaves, corners, sizes],
            &[&coded.triangles],
            threads(bvh.triangle_count),
        );
        recorder.update(
            links_kernel,
            &[total],
            &[plain, sizes],
            &[nodes],
            each_node(),
        );
    }

    pub fn bytes(&self) -> u64 {
        let slots = [&self.nodes, &self.triangles, &self.corners, &self.sizes];
        let slots = slots.iter().map(|slot| slot.bytes()).sum::<u64>();
        slots + self.scan.bytes()
    }
}
