//! The stages of a build, in order.

use super::super::buffer::Range;
use super::super::bvh::Built;
use super::super::program::{Groups, Recorder, Uniform, threads};
use super::super::sides::{Components, TargetRanges};
use super::super::wide::Topology;
use super::super::{Gpu, Kernel, Mesh};
use super::Builder;
use crate::CodeBits;
use slimbvh_core::aabb::Aabb;
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::encode::FINEST_STEP;
use slimbvh_core::launch::dispatch_each;

impl Builder {
    /// Stages `gather`, `bounds`, `morton` and `sort`.
    pub(super) fn record_sort(&mut self, gpu: &Gpu, recorder: &mut Recorder, mesh: &Mesh) {
        mesh.record_gather(recorder);
        let grid = &self.record_bounds(gpu, recorder, mesh);
        let items = self.record_morton(gpu, recorder, mesh, grid);
        recorder.stage("sort");
        let keys = self.keys();
        self.scratch.sort.record(gpu, recorder, keys, &items);
    }

    pub(super) fn record_build(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        mesh: &Mesh,
        bvh: &Built,
    ) {
        recorder.stage("snap");
        self.copy_state(gpu, recorder, bvh);
        recorder.write(&bvh.count, &dispatch_each(mesh.triangle_count));
        let items = self.items(gpu, mesh);
        self.record_tree(gpu, recorder, mesh, bvh, &items);
    }

    /// Stages `classify`, `scan`, `fit` and `compact`, and the tree over the resulting set.
    pub(super) fn record_build_set(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        mesh: &Mesh,
        bvh: &Built,
        (components, sides): (&Components, &TargetRanges),
    ) {
        let set = &self.record_classify(gpu, recorder, mesh, bvh, (components, sides));
        recorder.stage("snap");
        self.record_tree(gpu, recorder, mesh, bvh, set);
        if let Some(fallback) = &bvh.fallback {
            fallback.record_base(recorder, bvh);
        }
    }

    /// Stages `snap`, `topology` and `refit`, over the first `bvh.count` items.
    fn record_tree(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        mesh: &Mesh,
        bvh: &Built,
        items: &Range,
    ) {
        let codes = &self.record_snap(gpu, recorder, mesh, bvh, items);
        self.record_topology(gpu, recorder, bvh, codes);
        self.record_boxes(gpu, recorder, bvh, false);
        self.record_encode(gpu, recorder, bvh, Topology::New);
    }

    pub(super) fn record_refit(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        mesh: &Mesh,
        bvh: &Built,
    ) {
        mesh.record_gather(recorder);
        self.record_bounds(gpu, recorder, mesh);
        self.record_snap_again(gpu, recorder, mesh, bvh);
        self.record_boxes(gpu, recorder, bvh, true);
        self.record_encode(gpu, recorder, bvh, Topology::Kept);
    }

    /// Stage `encode`, if there is a codec, and `wide` before it.
    fn record_encode(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        bvh: &Built,
        topology: Topology,
    ) {
        let Some(coded) = &bvh.coded else { return };
        let step = self.lattice_step();
        let node_groups = self.scratch.node_groups.range(gpu, 12);
        let each_node = || {
            if bvh.triangle_count == 0 {
                threads(1)
            } else {
                Groups::Indirect(node_groups.clone())
            }
        };
        let encoder = &mut self.scratch.encoder;
        encoder.record(gpu, recorder, (bvh, coded), step, topology, &each_node);
    }

    /// The exponent of the lattice's step, and whether that is in the mesh's unit.
    const fn lattice_step(&self) -> [u32; 4] {
        match self.config.mesh.step_exponent() {
            Some(step_exponent) => [step_exponent as u32, 1, 0, 0],
            None => [FINEST_STEP as u32, 0, 0, 0],
        }
    }

    /// A hierarchy without triangles.
    pub(super) fn record_empty(&mut self, gpu: &Gpu, recorder: &mut Recorder, bvh: &Built) {
        recorder.stage("topology");
        recorder.clear(&bvh.triangles);
        recorder.write(&bvh.count, &[0, 0, 0, 0]);
        let kept = self.scratch.kept.range(gpu, 4);
        let before = self.scratch.kept_before.range(gpu, 4);
        let codes = self.scratch.codes.range(gpu, 8);
        let splits = self.splits(gpu, bvh);
        let total = Uniform::Stored(&bvh.count);
        let kernel = self.of_bits(Kernel::topology_kept_30, Kernel::topology_kept_63);
        recorder.dispatch(kernel, &[total], &[&codes], &[&kept, &before], threads(1));
        self.scratch.scan.record(gpu, recorder, &before, &bvh.total);
        recorder.dispatch(
            self.of_bits(Kernel::topology_nodes_30, Kernel::topology_nodes_63),
            &[total],
            &[&codes, &kept, &before],
            &[&bvh.nodes, &splits],
            threads(1),
        );
        let exponent = scene_exponent(&Aabb::EMPTY) as u32;
        recorder.write(&bvh.exponent, &[exponent, 0, 0, 0]);
        let [min, max] = [Aabb::EMPTY.min, Aabb::EMPTY.max].map(|corner| corner.to_array());
        recorder.write(&bvh.bounds, bytemuck::cast_slice(&[min, max]));
        self.record_encode(gpu, recorder, bvh, Topology::New);
    }

    /// Copies the results of stage `bounds` to the hierarchy.
    pub(in crate::gpu) fn copy_state(&mut self, gpu: &Gpu, recorder: &mut Recorder, bvh: &Built) {
        recorder.copy(&self.scratch.exponent.range(gpu, 16), &bvh.exponent);
        recorder.copy(&self.scratch.bounds.range(gpu, 24), &bvh.bounds);
    }

    /// The range of the sort's items.
    pub(in crate::gpu) fn items(&mut self, gpu: &Gpu, mesh: &Mesh) -> Range {
        let bytes = u64::from(mesh.triangle_count) * self.keys().item_bytes();
        self.scratch.items.range(gpu, bytes)
    }

    pub(in crate::gpu) const fn of_bits(&self, bits_30: Kernel, bits_63: Kernel) -> Kernel {
        match self.config.code_bits {
            CodeBits::Bits30 => bits_30,
            CodeBits::Bits63 => bits_63,
        }
    }
}
