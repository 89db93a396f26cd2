//! Stage `shade` on the GPU: light, shadow rays, mirrors and glass.

use super::Kernel;
use super::program::{Recorder, Uniform, threads};
use super::render::{ENVIRONMENT, LIGHTS, PicturePlan, SHADOW_BYTES, VIEW_STEP, Wave, counters};
use super::trees::DeferralRange;
use slimbvh_core::Hit;
use slimbvh_core::shade::{Environment, Light, Path};

impl PicturePlan<'_> {
    /// Adds light, and follows paths through mirrors and glass.
    pub(super) fn record_light(&self, recorder: &mut Recorder, wave: &Wave) {
        let samples = u64::from(wave.sample_count);
        let all = &self.buffers;
        let paths = &all.paths.part(0, samples * size_of::<Path>() as u64);
        let hits = &all.hits.part(0, samples * size_of::<Hit>() as u64);
        let shadows = &all.shadows.part(0, samples * SHADOW_BYTES);
        let environment = &all.view.part(ENVIRONMENT, size_of::<Environment>() as u64);
        let shadow_rays = self.tally(counters::SHADOW, wave);
        let mirror_rays = self.tally(counters::MIRROR, wave);
        let scene = self.scene;
        let exponent = Uniform::Stored(&self.trees.primary.built.exponent);
        let each = || threads(wave.sample_count);
        for depth in 0..=self.mirror_depth {
            let dark_rays = u32::from(self.settings.dark_rays);
            let draw = [self.settings.sample_count, depth, dark_rays, 0];
            for i in 0..self.light_count as u64 {
                let light = all
                    .view
                    .part(LIGHTS + VIEW_STEP * i, size_of::<Light>() as u64);
                recorder.stage("shade");
                recorder.dispatch(
                    Kernel::shade_light,
                    &[exponent, Uniform::Stored(&light), Uniform::Params(draw)],
                    &[
                        &scene.mesh.vertices,
                        &scene.mesh.indices,
                        &scene.normals,
                        &scene.material_indices,
                        &scene.materials,
                        hits,
                        paths,
                    ],
                    &[shadows],
                    each(),
                );
                match &self.deferrals[i as usize] {
                    DeferralRange::Ready => {}
                    DeferralRange::Always => recorder.callback(i as usize),
                    DeferralRange::IfReached(needed) => {
                        recorder.clear(needed);
                        let to = &[needed];
                        recorder.update(Kernel::shade_reached, &[], &[shadows], to, each());
                        recorder.callback(i as usize);
                    }
                }
                recorder.stage("trace shadow");
                let tree = &self.trees.lights[i as usize];
                let rays = [shadows, paths];
                tree.record_shadows(recorder, exponent, rays, &shadow_rays);
            }
            recorder.stage("shade");
            recorder.update(
                Kernel::shade_scatter,
                &[exponent],
                &[
                    &scene.mesh.vertices,
                    &scene.mesh.indices,
                    &scene.normals,
                    &scene.material_indices,
                    &scene.materials,
                    environment,
                    hits,
                ],
                &[paths],
                each(),
            );
            let mirrors = self.trees.mirrors.as_ref();
            if let Some(tree) = mirrors.filter(|_| depth < self.mirror_depth) {
                recorder.stage("trace mirror");
                tree.record_paths(recorder, exponent, [paths, hits], &mirror_rays);
            }
        }
    }
}
