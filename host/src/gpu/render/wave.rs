//! One wave of samples: from the camera to the pixels.

use super::{
    ENVIRONMENT, LIGHTS, Plan, SHADOW_BYTES, TEXEL_BYTES, VIEW_STEP, WAVE, counters, row_texels,
};
use crate::gpu::Kernel;
use crate::gpu::program::{Recorder, Uniform, threads};
use crate::gpu::trees::DeferralRange;
use crate::picture::{RenderSettings, View};
use slimbvh_core::Hit;
use slimbvh_core::camera::Camera;
use slimbvh_core::shade::{Environment, Light, Path};

/// A run of whole pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wave {
    pub first_pixel: u32,
    pub pixel_count: u32,
    pub first_sample: u32,
    pub sample_count: u32,
}

/// The waves of a picture, none with more paths than the limit has room for, unless that is less than a pixel's.
///
/// Waves begin at multiples of 64 samples wherever samples are stored for all of the picture.
pub fn waves(settings: &RenderSettings, limit_bytes: u64) -> Vec<Wave> {
    const STEP: u32 = 64;
    let [width, height] = settings.size;
    let pixel_count = width * height;
    let most_samples = (limit_bytes / size_of::<Path>() as u64).min(WAVE.into()) as u32;
    let most_pixels = (most_samples / settings.sample_count).max(1);
    let must_align = matches!(settings.view, View::Depth | View::Heatmap);
    let wave_pixels = if most_pixels >= STEP || must_align {
        (most_pixels / STEP).max(1) * STEP
    } else {
        most_pixels
    };
    (0..pixel_count)
        .step_by(wave_pixels as usize)
        .map(|first_pixel| {
            let pixel_count = wave_pixels.min(pixel_count - first_pixel);
            Wave {
                first_pixel,
                pixel_count,
                first_sample: first_pixel * settings.sample_count,
                sample_count: pixel_count * settings.sample_count,
            }
        })
        .collect()
}

impl Plan<'_> {
    /// Records all stages of a wave.
    pub fn record_wave(&self, recorder: &mut Recorder, wave: &Wave) {
        let samples = u64::from(wave.sample_count);
        let all = &self.buffers;
        let paths = &all.paths.part(0, samples * size_of::<Path>() as u64);
        let hits = &all.hits.part(0, samples * size_of::<Hit>() as u64);
        let camera = &all.view.part(0, size_of::<Camera>() as u64);
        let tree = &self.trees.primary;
        let primary = &all.counters.part(counters::PRIMARY, counters::SLOT_BYTES);
        let exponent = Uniform::Stored(&self.trees.primary.built.exponent);
        let each = || threads(wave.sample_count);

        recorder.stage("camera");
        recorder.dispatch(
            Kernel::camera_rays,
            &[exponent, Uniform::Params([wave.first_sample, 0, 0, 0])],
            &[camera],
            &[paths],
            each(),
        );

        recorder.stage("trace primary");
        let values = |first: u32| all.values.part(4 * u64::from(first), 4 * samples);
        if self.settings.view == View::Heatmap {
            let to = [hits, &values(wave.first_sample), primary];
            tree.record_paths_counted(recorder, paths, to, each());
        } else {
            tree.record_paths(recorder, exponent, paths, [hits, primary], each());
        }

        let mesh = &self.scene.mesh;
        match self.settings.view {
            View::Color => self.record_light(recorder, wave),
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
                    &[&values(wave.first_sample)],
                    each(),
                );
            }
            View::Heatmap => {}
        }
        if !matches!(self.settings.view, View::Depth | View::Heatmap) {
            self.record_resolve(recorder, wave);
        }
    }

    /// Gathers light, and follows mirrors and glass.
    fn record_light(&self, recorder: &mut Recorder, wave: &Wave) {
        let samples = u64::from(wave.sample_count);
        let all = &self.buffers;
        let paths = &all.paths.part(0, samples * size_of::<Path>() as u64);
        let hits = &all.hits.part(0, samples * size_of::<Hit>() as u64);
        let shadows = &all.shadows.part(0, samples * SHADOW_BYTES);
        let environment = &all.view.part(ENVIRONMENT, size_of::<Environment>() as u64);
        let counter = |slot| all.counters.part(slot, counters::SLOT_BYTES);
        let (shadow_rays, mirror_rays) = (&counter(counters::SHADOW), &counter(counters::MIRROR));
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
                let to = [paths, shadow_rays];
                tree.record_shadows(recorder, exponent, shadows, to, each());
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
                let to = [hits, mirror_rays];
                tree.record_paths(recorder, exponent, paths, to, each());
            }
        }
    }

    /// From samples to pixels. The kernel sees the rows that the wave touches.
    fn record_resolve(&self, recorder: &mut Recorder, wave: &Wave) {
        let [width, _] = self.settings.size;
        let row_bytes = TEXEL_BYTES * u64::from(row_texels(width));
        let first_row = wave.first_pixel / width;
        let last_row = (wave.first_pixel + wave.pixel_count - 1) / width;
        let rows = self.buffers.picture.part(
            u64::from(first_row) * row_bytes,
            u64::from(last_row - first_row + 1) * row_bytes,
        );
        let path_bytes = u64::from(wave.sample_count) * size_of::<Path>() as u64;
        let params = [
            self.settings.sample_count,
            width,
            row_texels(width),
            wave.first_pixel - first_row * width,
        ];
        recorder.stage("resolve");
        recorder.dispatch(
            Kernel::camera_resolve,
            &[Uniform::Params(params)],
            &[&self.buffers.paths.part(0, path_bytes)],
            &[&rows],
            threads(wave.pixel_count),
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn waves_hold_every_sample_once_and_fit() {
        let limit = 1 << 27;
        for (size, sample_count) in [
            ([1, 1], 1),
            ([1280, 720], 1),
            ([1280, 720], 16),
            ([3, 5], 65536),
            ([1001, 13], 777),
            ([2048, 2048], 1),
        ] {
            for view in [View::Color, View::Heatmap] {
                let settings = RenderSettings {
                    size,
                    sample_count,
                    view,
                    ..RenderSettings::default()
                };
                let mut next = 0;
                for wave in waves(&settings, limit) {
                    assert_eq!(wave.first_sample, next, "{settings:?}");
                    assert_eq!(wave.first_pixel * sample_count, next);
                    next += wave.sample_count;
                    let is_aligned = wave.first_sample.is_multiple_of(64);
                    assert!(is_aligned || view == View::Color);
                    assert!(wave.sample_count <= WAVE || view == View::Heatmap);
                }
                assert_eq!(next, size[0] * size[1] * sample_count);
            }
        }
    }
}
