//! Stage `view` on the GPU: normals, primitives, depth and heatmap.

use super::program::{Program, Recorder, Uniform, groups, threads};
use super::render::{PicturePlan, Wave};
use super::sort::Keys;
use super::{Gpu, GpuError, Kernel, Renderer};
use crate::picture::View;
use slimbvh_core::Hit;
use slimbvh_core::shade::Path;

impl PicturePlan<'_> {
    /// Records the colors of a wave's first hits; the trace counts nodes for the heatmap.
    pub(super) fn record_view(&self, recorder: &mut Recorder, wave: &Wave, view: View) {
        let samples = u64::from(wave.sample_count);
        let all = &self.buffers;
        let paths = &all.paths.part(0, samples * size_of::<Path>() as u64);
        let hits = &all.hits.part(0, samples * size_of::<Hit>() as u64);
        let exponent = Uniform::Stored(&self.trees.primary.built.exponent);
        let each = || threads(wave.sample_count);
        let mesh = &self.scene.mesh;
        match view {
            View::Normals => {
                recorder.stage("shade");
                recorder.update(
                    Kernel::view_normals,
                    &[exponent],
                    &[&mesh.vertices, &mesh.indices, &self.scene.normals, hits],
                    &[paths],
                    each(),
                );
            }
            View::Primitives => {
                recorder.stage("shade");
                recorder.update(Kernel::view_primitives, &[], &[hits], &[paths], each());
            }
            View::Depth => {
                recorder.stage("shade");
                recorder.dispatch(
                    Kernel::view_depth_values,
                    &[],
                    &[hits],
                    &[&all
                        .values
                        .part(4 * u64::from(wave.first_sample), 4 * samples)],
                    each(),
                );
            }
            View::Color | View::Heatmap => {}
        }
    }
}

impl Renderer {
    /// The final program, which needs all samples of the picture.
    pub(super) fn last_program(
        &mut self,
        gpu: &Gpu,
        plan: &PicturePlan,
    ) -> Result<Program, GpuError> {
        let mut recorder = Recorder::default();
        let (find_range, paint) = match plan.settings.view {
            View::Depth => (Kernel::view_depth_range, Kernel::view_depth),
            View::Heatmap => (Kernel::view_heat_range, Kernel::view_heat),
            View::Color | View::Normals | View::Primitives => return recorder.finish(gpu),
        };
        recorder.stage("shade");
        let values = &plan.buffers.values;
        let count = (values.size / 4) as u32;
        let items = &self.items.range(gpu, 8 * u64::from(count));
        recorder.dispatch(Kernel::view_items, &[], &[values], &[items], threads(count));
        self.sort.record(gpu, &mut recorder, Keys::OneWord, items);
        let range = &self.range.range(gpu, 16);
        recorder.dispatch(find_range, &[], &[items], &[range], groups(1));
        let [width, height] = plan.settings.size;
        let params = [plan.settings.sample_count, width, height, 0];
        recorder.dispatch(
            paint,
            &[Uniform::Stored(range), Uniform::Params(params)],
            &[values],
            &[&plan.buffers.picture],
            threads(width * height),
        );
        recorder.finish(gpu)
    }
}
