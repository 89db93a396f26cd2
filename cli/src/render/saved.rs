//! Renders a saved hierarchy, without a build.

use super::{Outcome, RenderArguments, Summary, tell};
use crate::Kept;
use crate::backend::Chosen;
use crate::output;
use crate::told;
use anyhow::{Result, bail};
use slimbvh::backend::TreeSize;
use slimbvh::reduce::{Plan, PlanRequest};
use slimbvh::{Bvh, FrameSizes, Picture, RenderSettings, Renderer, Scene, Stages};

/// Rejects options that would need another tree, before the file is read.
pub fn check(arguments: &RenderArguments) -> Result<()> {
    let name = arguments.scene.name();
    if let Some(asked) = arguments.picture.codes.asked_for() {
        bail!("{asked} is an option of builds; \"{name}\" is built already, leave it out");
    }
    if arguments.reduce.is_asked_for() {
        bail!(
            "\"{name}\" holds one tree for all rays; leave --reduce on and --cull on out, or render the scene that it was built from"
        );
    }
    Ok(())
}

/// The contents of a file, and the times of loading.
pub struct Opened {
    scene: Scene,
    kept: Kept,
    load: Stages,
}

/// Reads the file, and checks that it can be rendered.
pub fn open(arguments: &RenderArguments) -> Result<Opened> {
    let name = arguments.scene.name();
    let mut load = Stages::default();
    let (scene, kept) = load.time("load", || arguments.scene.open())?;
    told::note(&scene);
    let Some(kept) = kept else {
        bail!("\"{name}\" holds no hierarchy");
    };
    let bvh = &kept.bvh;
    arguments.storage.check_saved(bvh.codecs(), &name)?;
    if bvh.triangle_count() < bvh.mesh_triangle_count() {
        bail!(
            "\"{name}\" holds a hierarchy over a part of its triangles, which cannot be rendered"
        );
    }
    Ok(Opened { scene, kept, load })
}

/// Renders the scene of a file.
pub fn render(
    arguments: &RenderArguments,
    opened: Opened,
    chosen: &Chosen,
) -> Result<(Summary, String, Picture)> {
    let name = arguments.scene.name();
    let Opened {
        mut scene,
        kept,
        load,
    } = opened;
    let settings = arguments.picture.settings();
    (arguments.picture.sight).prepare(&mut scene, &name, kept.framing)?;
    let switches = arguments.reduce.config().switches;
    let request = PlanRequest::of_picture(&scene, &settings, switches)?;
    let plan = Plan::plain(&request, "the file holds one tree for all rays".into());

    let saved = Saved {
        scene: &scene,
        bvh: &kept.bvh,
        load,
        plan,
        settings: &settings,
    };
    let mut picture = Picture::default();
    let outcome = match chosen {
        Chosen::Cpu => saved.on_cpu(&mut picture)?,
        #[cfg(feature = "gpu")]
        Chosen::Gpu(gpu) => {
            let outcome = saved.on_gpu(gpu, &mut picture);
            outcome.map_err(|error| advise(error, &name))?
        }
        #[cfg(feature = "gpu")]
        Chosen::GpuIfItFits(gpu) => match saved.on_gpu(gpu, &mut picture) {
            Err(error) if crate::backend::is_the_gpus_fault(&error) => {
                output::warn(&format!(
                    "{}; using the CPU instead",
                    output::sentence(&error)
                ));
                saved.on_cpu(&mut picture)?
            }
            outcome => outcome?,
        },
    };
    Ok(tell(arguments, &scene, outcome, picture))
}

/// The contents of a file, and how to render them.
struct Saved<'a> {
    scene: &'a Scene,
    bvh: &'a Bvh,
    /// Times of loading.
    load: Stages,
    /// One tree for all rays.
    plan: Plan,
    settings: &'a RenderSettings,
}

impl Saved<'_> {
    /// Renders on the CPU.
    fn on_cpu(&self, picture: &mut Picture) -> Result<Outcome> {
        let mut renderer = Renderer::new();
        let progress = output::bar("rendering");
        let show = |share| progress.set(share);
        let report = renderer.render(self.scene, self.bvh, self.settings, picture, show)?;
        Ok(Outcome {
            backend: "cpu",
            adapter: None,
            report,
            scratch_bytes: renderer.scratch_bytes(),
            ..self.outcome()
        })
    }

    /// Uploads the hierarchy to a GPU and renders there.
    #[cfg(feature = "gpu")]
    fn on_gpu(&self, gpu: &slimbvh::gpu::Gpu, picture: &mut Picture) -> Result<Outcome> {
        use slimbvh::gpu;
        let mut outcome = self.outcome();
        let upload = || -> Result<gpu::Bvh, gpu::GpuError> {
            let bvh = gpu::Bvh::upload(gpu, self.bvh)?;
            // Wait here, so that the picture's time does not include the upload.
            gpu.frame().submit()?.wait()?;
            Ok(bvh)
        };
        let bvh = outcome.build.time("upload", upload)?;
        let mut renderer = gpu::Renderer::new();
        let progress = output::bar("rendering");
        let both = (self.scene, &bvh);
        let show = |share| progress.set(share);
        let report = renderer.render_image(gpu, both, self.settings, picture, show)?;
        Ok(Outcome {
            backend: "gpu",
            adapter: Some(gpu.name().into()),
            report,
            scratch_bytes: renderer.scratch_bytes() as usize,
            ..outcome
        })
    }

    /// The outcome before rendering: the renderer's fields are empty.
    fn outcome(&self) -> Outcome {
        Outcome {
            backend: "cpu",
            adapter: None,
            build: self.load.clone(),
            report: slimbvh::RenderReport::default(),
            sizes: FrameSizes {
                total: TreeSize {
                    node_count: self.bvh.node_count(),
                    triangle_count: self.bvh.triangle_count(),
                    node_bytes: self.bvh.node_bytes(),
                    triangle_bytes: self.bvh.triangle_bytes(),
                    unfit_count: 0,
                },
                sets: Vec::new(),
            },
            scratch_bytes: 0,
            plan: self.plan.clone(),
            survey: None,
        }
    }
}

/// Adds advice to an error if the GPU lacks kernels for the file's codecs.
#[cfg(feature = "gpu")]
fn advise(error: anyhow::Error, name: &str) -> anyhow::Error {
    match error.downcast_ref() {
        Some(slimbvh::gpu::GpuError::Codec { .. } | slimbvh::gpu::GpuError::LabKernel { .. }) => {
            error.context(format!(
                "use --backend cpu for \"{name}\", or build it again with other --nodes"
            ))
        }
        _ => error,
    }
}
