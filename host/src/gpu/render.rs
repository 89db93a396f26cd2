//! Pictures on the GPU, in waves of samples.

pub(super) mod counters;
mod download;
mod image;
mod wave;

use super::buffer::{Range, Slot};
use super::program::{Program, Recorder};
use super::sort::Sort;
use super::trace::overflow::{groups_range, groups_slot, list_bytes};
use super::trees::{DeferralRange, Tree, Trees, TreesRanges};
use super::work::Work;
use super::{Bvh, Frame, Gpu, GpuError, Misfit, Scene, Submission};
use crate::backend::DeferredTrees;
use crate::picture::{Picture, RenderReport, RenderSettings, View};
use crate::scene::{Camera, Light, ViewError};
use crate::{Stages, Stopwatch};
pub use counters::Counters;
pub use download::PictureDownload;
use download::PictureDownloads;
pub(super) use image::{Image, check_view};
use slimbvh_core::launch::row_texels;
use slimbvh_core::shade::{Environment, Light as CoreLight, Path};
use slimbvh_core::{Hit, camera::Camera as CoreCamera};
pub(super) use wave::Wave;
use wave::waves;
use wgpu::BufferUsages;

/// Samples in flight.
const WAVE: u32 = 1 << 20;

/// Bytes of a path's shadow record in `shade_light`: the light that its hit may receive.
pub(super) const SHADOW_BYTES: u64 = size_of::<slimbvh_core::shade::Shadow>() as u64;

/// A texel of the picture: linear RGB and 1, in `f32`.
pub(super) const TEXEL_BYTES: u64 = 16;

/// Programs of pictures with more waves are not kept.
const KEPT_WAVES: usize = 4;

/// The step between the parts of the view's buffer. The lights follow, one a step.
pub(super) const VIEW_STEP: u64 = 256;
pub(super) const ENVIRONMENT: u64 = VIEW_STEP;
pub(super) const LIGHTS: u64 = 2 * VIEW_STEP;

/// Renders pictures on the GPU. Keeps its buffers and programs from one picture to the next.
#[derive(Debug)]
pub struct Renderer {
    view: Slot,
    paths: Slot,
    hits: Slot,
    shadows: Slot,
    values: Slot,
    pub(super) items: Slot,
    pub(super) sort: Sort,
    pub(super) range: Slot,
    /// The counters, and the list of rays to trace again.
    counters: Slot,
    groups: Slot,
    picture: Slot,
    pub(super) texels: Slot,
    kept: Option<(Key, Vec<Program>)>,
    pub(super) size: [u32; 2],
    work: Vec<Work>,
}

/// The inputs that programs were recorded for.
#[derive(Clone, Debug, PartialEq)]
struct Key {
    settings: RenderSettings,
    light_count: usize,
    scene: [Range; 5],
    has_mirrors: bool,
    trees: TreesRanges,
    deferrals: Vec<DeferralRange>,
    scratch_bytes: u64,
}

/// The inputs of all waves of one picture.
pub(super) struct PicturePlan<'a> {
    pub(super) scene: &'a Scene,
    pub(super) trees: TreesRanges,
    pub(super) deferrals: Vec<DeferralRange>,
    pub(super) settings: RenderSettings,
    pub(super) mirror_depth: u32,
    pub(super) light_count: usize,
    pub(super) buffers: Buffers,
    pub(super) waves: Vec<Wave>,
}

/// The ranges that a picture uses.
#[derive(Clone, Debug)]
pub(super) struct Buffers {
    pub(super) view: Range,
    pub(super) paths: Range,
    pub(super) hits: Range,
    pub(super) shadows: Range,
    pub(super) values: Range,
    pub(super) counters: Range,
    pub(super) groups: Range,
    pub(super) parts: Range,
    pub(super) picture: Range,
}

impl Default for Renderer {
    fn default() -> Self {
        Self::new()
    }
}

impl Renderer {
    /// A renderer with empty buffers.
    #[must_use]
    pub const fn new() -> Self {
        let copied_to = BufferUsages::STORAGE.union(BufferUsages::COPY_DST);
        Self {
            view: Slot::new("slimbvh view", copied_to.union(BufferUsages::UNIFORM)),
            paths: Slot::storage("slimbvh paths"),
            hits: Slot::storage("slimbvh hits"),
            shadows: Slot::storage("slimbvh shadows"),
            values: Slot::storage("slimbvh values"),
            items: Slot::storage("slimbvh values to sort"),
            sort: Sort::new(),
            range: Slot::new("slimbvh range", copied_to.union(BufferUsages::UNIFORM)),
            counters: Slot::new("slimbvh counters", copied_to),
            groups: groups_slot(),
            picture: Slot::new("slimbvh picture", copied_to),
            texels: Slot::storage("slimbvh texels"),
            kept: None,
            size: [0, 0],
            work: Vec::new(),
        }
    }

    /// Records a picture of a scene. The hierarchy over its mesh is built, or is built earlier in this frame. The picture
    /// stays in a buffer, which [`Self::copy_to_texture`] and [`Self::read_later`] copy.
    ///
    /// # Errors
    /// For cameras and lights that cannot be rendered, a mesh with a different number of triangles than the hierarchy's,
    /// and a picture above the GPU's limits, before anything is allocated.
    pub fn render(
        &mut self,
        frame: &mut Frame,
        scene: &Scene,
        bvh: &Bvh,
        camera: &Camera,
        lights: &[Light],
        settings: &RenderSettings,
    ) -> Result<(), GpuError> {
        let trees = Trees::all(bvh, lights.len());
        let view = (camera, lights);
        self.render_with(frame, scene, &trees, view, settings)
    }

    /// [`Self::render`] with one hierarchy for each kind of rays. The view is a camera and lights.
    ///
    /// # Errors
    /// Those of [`Self::render`].
    ///
    /// # Panics
    /// If the number of hierarchies for shadow rays differs from the number of lights.
    pub fn render_with(
        &mut self,
        frame: &mut Frame,
        scene: &Scene,
        trees: &Trees,
        view: (&Camera, &[Light]),
        settings: &RenderSettings,
    ) -> Result<(), GpuError> {
        let plan = self.plan(frame, scene, trees, view, settings)?;
        self.encode(frame, &plan, 0..plan.waves.len(), None)
    }

    /// [`Self::render_with`], with some lights' hierarchies built during the picture: once for each wave of samples and
    /// each mirror along the paths.
    pub(super) fn render_deferred<'g>(
        &mut self,
        frame: &mut Frame<'g>,
        scene: &Scene,
        (trees, deferred): (&Trees, &mut dyn DeferredTrees<&'g Gpu>),
        view: (&Camera, &[Light]),
        settings: &RenderSettings,
    ) -> Result<(), GpuError> {
        let mut plan = self.plan(frame, scene, trees, view, settings)?;
        for light in 0..plan.light_count {
            let (deferral, bvh) = DeferralRange::of(deferred.deferral(light))?;
            plan.deferrals[light] = deferral;
            if let Some(bvh) = bvh {
                plan.trees.lights[light] = Tree::all(bvh).ranges()?;
            }
        }
        self.encode(frame, &plan, 0..plan.waves.len(), Some(deferred))
    }

    /// Checks everything, makes room, and records the upload of the camera and the lights.
    pub(super) fn plan<'a>(
        &mut self,
        frame: &mut Frame,
        scene: &'a Scene,
        trees: &Trees,
        (camera, lights): (&Camera, &[Light]),
        settings: &RenderSettings,
    ) -> Result<PicturePlan<'a>, GpuError> {
        let gpu = frame.gpu();
        assert_eq!(trees.lights.len(), lights.len(), "a tree for each light");
        let trees = trees.ranges()?;
        for built in trees.all() {
            if scene.mesh.triangle_count != built.triangle_count {
                return Err(GpuError::View(ViewError::OtherMesh {
                    triangle_count: scene.mesh.triangle_count as usize,
                    expected: built.triangle_count as usize,
                }));
            }
        }
        let core_camera = camera.to_core(settings.size, settings.sample_count)?;
        let core_lights = lights
            .iter()
            .enumerate()
            .map(|(index, light)| light.to_core(index))
            .collect::<Result<Vec<_>, _>>()?;
        let waves = waves(settings, gpu.limits().max_storage_buffer_binding_size);
        check(gpu, settings, &waves)?;
        let mirror_depth = if scene.has_mirrors && trees.mirrors.is_some() {
            settings.mirror_depth
        } else {
            0
        };
        let planned = gpu.checked(|| {
            let buffers = self.reserve(gpu, settings, core_lights.len(), &waves);
            let environment = crate::Scene::environment(camera.up);
            upload_view(
                frame,
                &buffers.view,
                &core_camera,
                &environment,
                &core_lights,
            );
            frame
                .encoder()
                .clear_buffer(&buffers.counters.buffer, 0, Some(counters::BYTES + 4));
            Ok(PicturePlan {
                scene,
                trees,
                deferrals: vec![DeferralRange::Ready; core_lights.len()],
                settings: *settings,
                mirror_depth,
                light_count: core_lights.len(),
                buffers,
                waves,
            })
        });
        planned.inspect_err(|_| *self = Self::new())
    }

    /// Encodes some of a picture's waves, and after the last wave the final program.
    pub(super) fn encode<'g>(
        &mut self,
        frame: &mut Frame<'g>,
        plan: &PicturePlan,
        which: std::ops::Range<usize>,
        mut deferred: Option<&mut dyn DeferredTrees<&'g Gpu>>,
    ) -> Result<(), GpuError> {
        let mut build = |frame: &mut Frame<'g>, light: usize| match &mut deferred {
            Some(trees) => trees.build(frame, light).map(|_| ()),
            None => Ok(()),
        };
        let gpu = frame.gpu();
        if which.start == 0 {
            self.work.clear();
        }
        let encoded = gpu.checked(|| {
            let last = plan.waves.len();
            if last > KEPT_WAVES {
                self.kept = None;
                for wave in which.clone() {
                    let program = self.wave_program(gpu, plan, wave)?;
                    program.encode_with(frame, &mut build)?;
                }
                if which.end == last {
                    self.last_program(gpu, plan)?.encode(frame);
                }
                return Ok(());
            }
            let key = self.key(plan);
            if self.kept.as_ref().is_none_or(|(other, _)| *other != key) {
                let mut programs = Vec::with_capacity(last + 1);
                for wave in 0..last {
                    programs.push(self.wave_program(gpu, plan, wave)?);
                }
                programs.push(self.last_program(gpu, plan)?);
                // Recording the last program may have replaced buffers.
                let key = self.key(plan);
                self.kept = Some((key, programs));
            }
            if let Some((_, programs)) = &self.kept {
                let end = which.end + usize::from(which.end == last);
                for program in &programs[which.start..end] {
                    program.encode_with(frame, &mut build)?;
                    self.work.extend_from_slice(program.work());
                }
            }
            Ok(())
        });
        // After an error the renderer drops its programs and buffers.
        encoded.inspect_err(|_| *self = Self::new())
    }

    /// Copies the picture, to be read when the frame is done.
    ///
    /// # Errors
    /// If nothing was rendered, or memory is exhausted.
    pub fn read_later(&mut self, frame: &mut Frame) -> Result<PictureDownload, GpuError> {
        let gpu = frame.gpu();
        let [width, height] = self.size;
        let picture = self.picture(gpu)?;
        gpu.checked(|| {
            Ok(PictureDownload {
                size: [width, height],
                texels: frame.download(&picture),
            })
        })
    }

    /// Copies the counts of rays, to be read when the frame is done.
    ///
    /// # Errors
    /// If memory is exhausted.
    pub fn count_later(&mut self, frame: &mut Frame) -> Result<Counters, GpuError> {
        let gpu = frame.gpu();
        gpu.checked(|| {
            let counters = self.counters.range(gpu, counters::BYTES);
            Ok(Counters(frame.download(&counters)))
        })
    }

    /// Submits the frame that ends a picture, waits, and reads the picture. Returns the times of the build and the report
    /// of the render. `stages`, the times of earlier frames, are added. Without timestamps, the only times are those of
    /// compiling and the rest since `begin`.
    ///
    /// # Errors
    /// If nothing was rendered, the device refuses a command, memory is exhausted, or the device was lost.
    pub fn finish(
        &mut self,
        frame: Frame,
        mut stages: Stages,
        begin: Stopwatch,
        picture: &mut Picture,
    ) -> Result<(Stages, RenderReport), GpuError> {
        let gpu = frame.gpu();
        let (submission, downloads) = self.submit(frame)?;
        stages.merge(&submission.wait()?);
        gpu.block_on(downloads.read(gpu, stages, begin, picture))
    }

    /// [`Self::finish`], without blocking.
    ///
    /// # Errors
    /// Those of [`Self::finish`]; in a browser, also those of all earlier calls.
    pub async fn finish_async(
        &mut self,
        frame: Frame<'_>,
        mut stages: Stages,
        begin: Stopwatch,
        picture: &mut Picture,
    ) -> Result<(Stages, RenderReport), GpuError> {
        let gpu = frame.gpu();
        let (submission, downloads) = self.submit(frame)?;
        stages.merge(&submission.wait_async().await?);
        downloads.read(gpu, stages, begin, picture).await
    }

    /// Submits a frame that copies the picture and its counts.
    fn submit<'g>(
        &mut self,
        mut frame: Frame<'g>,
    ) -> Result<(Submission<'g>, PictureDownloads), GpuError> {
        let downloads = PictureDownloads {
            texels: self.read_later(&mut frame)?,
            counters: self.count_later(&mut frame)?,
        };
        Ok((frame.submit()?, downloads))
    }

    /// Bytes of the buffers that the last picture used. The next picture reuses them.
    #[must_use]
    pub fn scratch_bytes(&self) -> u64 {
        let slots = [
            &self.view,
            &self.paths,
            &self.hits,
            &self.shadows,
            &self.values,
            &self.items,
            &self.range,
            &self.counters,
            &self.picture,
            &self.texels,
        ];
        let all = slots.into_iter().chain([&self.groups]);
        all.map(Slot::bytes).sum::<u64>() + self.sort.bytes()
    }

    /// The work of the latest picture, by stage; empty if it had too many waves to be kept.
    #[must_use]
    pub fn work(&self) -> &[Work] {
        &self.work
    }

    /// The picture's range.
    pub(super) fn picture(&mut self, gpu: &Gpu) -> Result<Range, GpuError> {
        if self.size == [0, 0] {
            return Err(Misfit::NotRendered.of("the picture"));
        }
        Ok(self.picture.range(gpu, picture_bytes(self.size)))
    }

    fn key(&self, plan: &PicturePlan) -> Key {
        let scene = plan.scene;
        Key {
            settings: plan.settings,
            light_count: plan.light_count,
            scene: [
                scene.mesh.vertices.clone(),
                scene.mesh.indices.clone(),
                scene.normals.clone(),
                scene.material_indices.clone(),
                scene.materials.clone(),
            ],
            has_mirrors: scene.has_mirrors,
            trees: plan.trees.clone(),
            deferrals: plan.deferrals.clone(),
            scratch_bytes: self.scratch_bytes(),
        }
    }

    fn reserve(
        &mut self,
        gpu: &Gpu,
        settings: &RenderSettings,
        light_count: usize,
        waves: &[Wave],
    ) -> Buffers {
        let most = waves.iter().map(|wave| wave.sample_count).max();
        let most = u64::from(most.unwrap_or(1));
        let needs_values = matches!(settings.view, View::Depth | View::Heatmap);
        let value_count = if needs_values {
            sample_count(settings)
        } else {
            64
        };
        self.size = settings.size;
        Buffers {
            view: self
                .view
                .range(gpu, LIGHTS + VIEW_STEP * light_count.max(1) as u64),
            paths: self.paths.range(gpu, most * size_of::<Path>() as u64),
            hits: self.hits.range(gpu, most * size_of::<Hit>() as u64),
            shadows: self.shadows.range(gpu, most * SHADOW_BYTES),
            values: self.values.range(gpu, 4 * value_count),
            counters: self.counters.range(gpu, counters::BYTES + list_bytes(most)),
            groups: groups_range(gpu, &mut self.groups),
            parts: gpu.ray_groups(),
            picture: self.picture.range(gpu, picture_bytes(settings.size)),
        }
    }

    fn wave_program(
        &self,
        gpu: &Gpu,
        plan: &PicturePlan,
        wave: usize,
    ) -> Result<Program, GpuError> {
        let mut recorder = Recorder::default();
        plan.record_wave(&mut recorder, &plan.waves[wave]);
        recorder.finish(gpu)
    }
}

/// Refuses a picture above the GPU's limits.
fn check(gpu: &Gpu, settings: &RenderSettings, waves: &[Wave]) -> Result<(), GpuError> {
    let most = waves.iter().map(|wave| wave.sample_count).max();
    let most = u64::from(most.unwrap_or(1));
    let advice = "take fewer samples a pixel";
    gpu.check_sizes(
        &[("the paths of a wave", most * size_of::<Path>() as u64)],
        advice,
    )?;
    let advice = "take a smaller picture, or the CPU";
    gpu.check_buffer("the picture", picture_bytes(settings.size), advice)?;
    if matches!(settings.view, View::Depth | View::Heatmap) {
        let advice = "take a smaller picture, fewer samples a pixel, or the CPU";
        let values = 8 * sample_count(settings);
        gpu.check_sizes(
            &[
                ("the values of all samples", values),
                ("the picture", picture_bytes(settings.size)),
            ],
            advice,
        )?;
    }
    Ok(())
}

fn sample_count(settings: &RenderSettings) -> u64 {
    let [width, height] = settings.size;
    u64::from(width) * u64::from(height) * u64::from(settings.sample_count)
}

fn picture_bytes([width, height]: [u32; 2]) -> u64 {
    TEXEL_BYTES * u64::from(row_texels(width)) * u64::from(height)
}

/// Records the upload of the camera and the lights at this point of the frame.
fn upload_view(
    frame: &mut Frame,
    view: &Range,
    camera: &CoreCamera,
    environment: &Environment,
    lights: &[CoreLight],
) {
    let mut bytes = vec![0; view.size as usize];
    let mut place = |offset: u64, part: &[u8]| {
        bytes[offset as usize..][..part.len()].copy_from_slice(part);
    };
    place(0, bytemuck::bytes_of(camera));
    place(ENVIRONMENT, bytemuck::bytes_of(environment));
    for (light, i) in lights.iter().zip(0..) {
        place(LIGHTS + VIEW_STEP * i, bytemuck::bytes_of(light));
    }
    let gpu = frame.gpu();
    let usage = BufferUsages::COPY_SRC;
    let from = super::buffer::upload(gpu, "slimbvh view to upload", usage, &bytes);
    frame
        .encoder()
        .copy_buffer_to_buffer(&from, 0, &view.buffer, view.offset, view.size);
}
