//! A wave of samples, from camera rays to pixels.

use super::{Buffers, PicturePlan, WAVE, counters};
use crate::gpu::program::{Recorder, Uniform};
use crate::gpu::trace::overflow::{Overflow, list_bytes};
use crate::gpu::trace::paths::{Each, Tally};
use crate::picture::{RenderSettings, View};
use slimbvh_core::Hit;
use slimbvh_core::shade::Path;

/// A run of whole pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wave {
    pub first_pixel: u32,
    pub pixel_count: u32,
    pub first_sample: u32,
    pub sample_count: u32,
}

/// The waves of a picture. Each has at most the number of paths that fit into the limit, but at least one pixel's.
///
/// If samples are stored for the whole picture, waves begin at multiples of 64 samples.
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

impl PicturePlan<'_> {
    /// Records all stages of a wave.
    pub fn record_wave(&self, recorder: &mut Recorder, wave: &Wave) {
        let samples = u64::from(wave.sample_count);
        let all = &self.buffers;
        let paths = &all.paths.part(0, samples * size_of::<Path>() as u64);
        let hits = &all.hits.part(0, samples * size_of::<Hit>() as u64);
        let tree = &self.trees.primary;
        let exponent = Uniform::Stored(&self.trees.primary.built.exponent);

        self.record_rays(recorder, wave);

        recorder.stage("trace primary");
        let values = |first: u32| all.values.part(4 * u64::from(first), 4 * samples);
        if self.settings.view == View::Heatmap {
            let primary = all.counters.part(counters::PRIMARY, counters::SLOT_BYTES);
            let to = [hits, &values(wave.first_sample), &primary];
            tree.record_paths_counted(recorder, paths, to, &self.each(wave));
        } else {
            let tally = self.tally(counters::PRIMARY, wave);
            tree.record_paths(recorder, exponent, [paths, hits], &tally);
        }

        match self.settings.view {
            View::Color => self.record_light(recorder, wave),
            view => self.record_view(recorder, wave, view),
        }
        if !matches!(self.settings.view, View::Depth | View::Heatmap) {
            self.record_resolve(recorder, wave);
        }
    }

    /// The counters of one kind of rays, and the list of a wave's rays.
    pub fn tally(&self, slot: u64, wave: &Wave) -> Tally {
        let Buffers {
            counters, groups, ..
        } = &self.buffers;
        let list_bytes = list_bytes(wave.sample_count.into());
        Tally {
            all: counters.part(slot, counters::BYTES - slot + list_bytes),
            overflow: Overflow {
                list: counters.part(counters::BYTES, list_bytes),
                groups: groups.clone(),
            },
            each: self.each(wave),
        }
    }

    fn each(&self, wave: &Wave) -> Each {
        Each {
            count: wave.sample_count,
            parts: self.buffers.parts.clone(),
        }
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
