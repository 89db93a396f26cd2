//! Stage `classify` on the GPU, with `scan` and `compact` after it.

use super::buffer::Range;
use super::bvh::Built;
use super::program::{Recorder, Uniform, threads};
use super::sides::{Components, TargetRanges};
use super::{Builder, Gpu, Kernel, Mesh};

impl Builder {
    /// Records which sorted items are in a target's set, and a list of them. Returns the list.
    pub(super) fn record_classify(
        &mut self,
        gpu: &Gpu,
        recorder: &mut Recorder,
        mesh: &Mesh,
        bvh: &Built,
        (components, sides): (&Components, &TargetRanges),
    ) -> Range {
        recorder.stage("classify");
        self.copy_state(gpu, recorder, bvh);
        let items = &self.items(gpu, mesh);
        let word_bytes = 4 * u64::from(mesh.triangle_count.div_ceil(32));
        let bits = &self.scratch.in_set.range(gpu, word_bytes);
        let before = &self.scratch.in_set_before.range(gpu, word_bytes);
        let set = self.scratch.set.range(gpu, items.size);
        let members = &self.scratch.members.range(gpu, word_bytes);
        let each = || threads(mesh.triangle_count);
        let exponent = Uniform::Stored(&bvh.exponent);
        recorder.dispatch(
            Kernel::classify,
            &[exponent, sides.target(), sides.frustum(), sides.needed()],
            &[&mesh.vertices, &mesh.indices, &components.0, &sides.sides],
            &[members],
            each(),
        );
        recorder.dispatch(
            self.of_bits(Kernel::classify_order_30, Kernel::classify_order_63),
            &[],
            &[items, members],
            &[bits, before],
            each(),
        );
        recorder.stage("scan");
        self.scratch.scan.record(gpu, recorder, before, &bvh.count);
        if let Some(fallback) = &bvh.fallback {
            fallback.record_count(recorder, &bvh.count);
        }
        recorder.stage("compact");
        recorder.dispatch(
            self.of_bits(Kernel::classify_compact_30, Kernel::classify_compact_63),
            &[],
            &[items, bits, before],
            &[&set],
            each(),
        );
        set
    }
}
