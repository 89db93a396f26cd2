//! Pictures being copied from the GPU.

use super::Counters;
use crate::gpu::buffer::Download;
use crate::gpu::frame::COMPILE;
use crate::gpu::{Builder, Gpu, GpuError};
use crate::picture::{Picture, RenderReport};
use crate::{Stages, Stopwatch};
use slimbvh_core::launch::row_texels;

/// A picture being copied from the GPU.
#[derive(Debug)]
#[must_use]
pub struct PictureDownload {
    pub(super) size: [u32; 2],
    pub(super) texels: Download,
}

impl PictureDownload {
    /// Waits for the picture, and reads it.
    ///
    /// # Errors
    /// If the device was lost.
    pub fn read(self, gpu: &Gpu, picture: &mut Picture) -> Result<(), GpuError> {
        gpu.block_on(self.read_async(gpu, picture))
    }

    /// [`Self::read`], without blocking.
    ///
    /// # Errors
    /// If the device was lost; in a browser, also the errors of earlier calls.
    pub async fn read_async(self, gpu: &Gpu, picture: &mut Picture) -> Result<(), GpuError> {
        let [width, height] = self.size;
        let texels: Vec<[f32; 4]> = self.texels.read_async(gpu).await?;
        picture.width = width;
        picture.height = height;
        picture.pixels.clear();
        for row in texels.chunks(row_texels(width) as usize) {
            let row = row.iter().take(width as usize);
            picture.pixels.extend(row.map(|&[r, g, b, _]| [r, g, b]));
        }
        Ok(())
    }
}

/// A picture and its counts, being copied.
pub struct PictureDownloads {
    pub texels: PictureDownload,
    pub counters: Counters,
}

impl PictureDownloads {
    /// Reads both when the frame is done, and divides the times of its stages.
    pub async fn read(
        self,
        gpu: &Gpu,
        mut stages: Stages,
        begin: Stopwatch,
        picture: &mut Picture,
    ) -> Result<(Stages, RenderReport), GpuError> {
        self.texels.read_async(gpu, picture).await?;
        let mut report = self.counters.read_async(gpu).await?;
        if stages.iter().all(|(stage, _)| stage == COMPILE) {
            stages.add("all", begin.elapsed().saturating_sub(stages.total()));
        }
        let mut build = Stages::default();
        for (stage, time) in stages.iter() {
            let part = if Builder::STAGES.contains(&stage) {
                &mut build
            } else {
                &mut report.stages
            };
            part.add(stage, time);
        }
        Ok((build, report))
    }
}
