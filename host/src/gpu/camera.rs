//! Stage `camera` on the GPU: rays from samples; pixels and textures from samples.

use super::buffer::Range;
use super::program::{Recorder, Uniform, threads};
use super::render::{PicturePlan, TEXEL_BYTES, Wave};
use super::{Frame, GpuError, Kernel, Misfit, Renderer};
use slimbvh_core::camera::Camera;
use slimbvh_core::launch::row_texels;
use slimbvh_core::shade::Path;
use slimbvh_core::tile::SIDE;
use wgpu::TextureFormat;

impl PicturePlan<'_> {
    /// Records a wave's camera rays.
    pub(super) fn record_rays(&self, recorder: &mut Recorder, wave: &Wave) {
        let all = &self.buffers;
        let path_bytes = u64::from(wave.sample_count) * size_of::<Path>() as u64;
        let paths = &all.paths.part(0, path_bytes);
        let camera = &all.view.part(0, size_of::<Camera>() as u64);
        let exponent = Uniform::Stored(&self.trees.primary.built.exponent);
        recorder.stage("camera");
        recorder.dispatch(
            Kernel::camera_rays,
            &[exponent, Uniform::Params([wave.first_sample, 0, 0, 0])],
            &[camera],
            &[paths],
            threads(wave.sample_count),
        );
    }

    /// Averages samples into pixels. The kernel sees the picture from the band of 8 rows that holds the wave's first pixel to
    /// the one that holds its last.
    pub(super) fn record_resolve(&self, recorder: &mut Recorder, wave: &Wave) {
        let [width, height] = self.settings.size;
        let row_bytes = TEXEL_BYTES * u64::from(row_texels(width));
        let first_row = wave.first_pixel / width / SIDE * SIDE;
        let last_row = (wave.first_pixel + wave.pixel_count - 1) / width;
        let end_row = (last_row / SIDE * SIDE + SIDE).min(height);
        let rows = self.buffers.picture.part(
            u64::from(first_row) * row_bytes,
            u64::from(end_row - first_row) * row_bytes,
        );
        let path_bytes = u64::from(wave.sample_count) * size_of::<Path>() as u64;
        let params = [
            self.settings.sample_count,
            width,
            height - first_row,
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

impl Renderer {
    /// Records a copy of the picture to the upper left of a texture: linear values for `Rgba32Float`, sRGB bytes for
    /// `Rgba8Unorm`, `Bgra8Unorm` and their `Srgb` variants.
    ///
    /// # Errors
    /// If nothing was rendered, and for a texture of another format, without the usage `COPY_DST`, or smaller than the
    /// picture.
    pub fn copy_to_texture(
        &mut self,
        frame: &mut Frame,
        texture: &wgpu::Texture,
    ) -> Result<(), GpuError> {
        let gpu = frame.gpu();
        let [width, height] = self.size;
        let picture = self.picture(gpu)?;
        let unfit = |fault: Misfit| Err(fault.of("the texture"));
        if texture.width() < width || texture.height() < height {
            return unfit(Misfit::TextureTooSmall {
                texture: [texture.width(), texture.height()],
                picture: self.size,
            });
        }
        if !texture.usage().contains(wgpu::TextureUsages::COPY_DST) {
            return unfit(Misfit::MissingUsage { usage: "COPY_DST" });
        }
        let row_bytes = TEXEL_BYTES * u64::from(row_texels(width));
        let order = match texture.format() {
            TextureFormat::Rgba32Float => None,
            TextureFormat::Rgba8Unorm | TextureFormat::Rgba8UnormSrgb => Some(0),
            TextureFormat::Bgra8Unorm | TextureFormat::Bgra8UnormSrgb => Some(1),
            format => return unfit(Misfit::TextureFormat { format }),
        };
        gpu.checked(|| {
            let (source, source_row_bytes) = match order {
                None => (picture, row_bytes),
                Some(order) => {
                    let bytes = picture.size / TEXEL_BYTES * 4;
                    let texels = self.texels.range(gpu, bytes);
                    let mut recorder = Recorder::default();
                    recorder.stage("encode");
                    // As many rows at once as fit into a storage binding.
                    let limit = gpu.limits().max_storage_buffer_binding_size;
                    let most_rows = (limit / row_bytes).max(1) as u32;
                    for first in (0..height).step_by(most_rows as usize) {
                        let rows = most_rows.min(height - first);
                        let part = |row_bytes: u64, range: &Range| {
                            range.part(u64::from(first) * row_bytes, u64::from(rows) * row_bytes)
                        };
                        recorder.dispatch(
                            Kernel::camera_encode,
                            &[Uniform::Params([order, 0, 0, 0])],
                            &[&part(row_bytes, &picture)],
                            &[&part(row_bytes / 4, &texels)],
                            threads(rows * row_texels(width)),
                        );
                    }
                    recorder.finish(gpu)?.encode(frame);
                    (texels, row_bytes / 4)
                }
            };
            frame.encoder().copy_buffer_to_texture(
                wgpu::TexelCopyBufferInfo {
                    buffer: &source.buffer,
                    layout: wgpu::TexelCopyBufferLayout {
                        offset: source.offset,
                        bytes_per_row: Some(source_row_bytes as u32),
                        rows_per_image: Some(height),
                    },
                },
                texture.as_image_copy(),
                wgpu::Extent3d {
                    width,
                    height,
                    depth_or_array_layers: 1,
                },
            );
            Ok(())
        })
    }
}
