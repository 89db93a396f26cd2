//! A setup on a GPU.

use super::super::prepared::Prepared;
use super::super::times::Times;
use super::Machine;
use anyhow::Result;
use slimbvh::Picture;
use slimbvh::gpu::Gpu;
use slimbvh::reduce::Savings;
use slimbvh::reduce::gpu::ImageRenderer;
use slimbvh_cli::reduce;
use std::time::Instant;

/// What is on the GPU stays there from one picture to the next, but for the scene, which is uploaded without being timed.
pub struct OnGpu<'a> {
    gpu: &'a Gpu,
    prepared: &'a Prepared<'a>,
    renderer: ImageRenderer,
    picture: Picture,
    tree_bytes: u64,
}

impl<'a> OnGpu<'a> {
    pub fn new(gpu: &'a Gpu, prepared: &'a Prepared) -> Self {
        Self {
            gpu,
            prepared,
            renderer: ImageRenderer::new(prepared.config),
            picture: Picture::default(),
            tree_bytes: 0,
        }
    }
}

impl Machine for OnGpu<'_> {
    fn frame(&mut self) -> Result<Times> {
        let begin = Instant::now();
        let mut room = None;
        let asked = self.prepared.asked(Savings::ALL);
        let (plan, _) = reduce::plan(&asked, self.prepared.config, &mut room)?;
        let plan_ms = begin.elapsed().as_secs_f64() * 1e3;
        let what = (&*self.prepared.scene, &plan);
        let (settings, picture) = (&self.prepared.settings, &mut self.picture);
        let rendered = self
            .renderer
            .render(self.gpu, what, settings, picture, |_| {});
        let (build, report) = rendered?;
        let trees = self.renderer.hierarchies.all(&plan);
        self.tree_bytes = trees.map(slimbvh::gpu::Bvh::bytes).sum();
        Ok(Times::new(plan_ms, &build, &report.stages))
    }

    fn picture(&self) -> &Picture {
        &self.picture
    }

    fn peak_bytes(&self) -> usize {
        let scratch =
            self.renderer.builder.scratch_bytes() + self.renderer.renderer.scratch_bytes();
        let mesh = slimbvh_cli::storage::mesh_bytes(&self.prepared.scene.mesh);
        mesh + (self.tree_bytes + scratch) as usize
    }
}
