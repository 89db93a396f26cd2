//! What makes a frame.

use anyhow::Result;
use slimbvh::animate::Action;
use slimbvh::reduce::{Hierarchies, Plan};
use slimbvh::{
    BuildConfig, Builder, Bvh, Picture, RenderReport, RenderSettings, Renderer, Scene, Stages,
    Turns,
};

#[cfg(feature = "gpu")]
mod on_gpu;
#[cfg(feature = "gpu")]
pub use on_gpu::OnGpu;

/// The CPU or a GPU, with a tree that it keeps from frame to frame.
pub trait Machine {
    /// The backend, and the GPU's name.
    fn name(&self) -> (&'static str, Option<String>);

    /// Whether the host must know where vertices are that have moved.
    fn follows_on_host(&self) -> bool {
        true
    }

    /// What the machine decided by itself in the latest frame, in words.
    fn decided(&self) -> Result<Vec<(String, String)>> {
        Ok(Vec::new())
    }

    /// Brings the trees up to date and renders the scene as it is now.
    fn frame(
        &mut self,
        scene: &Scene,
        update: &Update,
        settings: &RenderSettings,
        picture: &mut Picture,
    ) -> Result<Done>;
}

/// What is new in a frame.
pub struct Update<'a> {
    pub plan: &'a Plan<'a>,
    #[cfg_attr(
        not(feature = "gpu"),
        expect(dead_code, reason = "only a GPU has a copy that must follow")
    )]
    pub vertices_moved: bool,
    pub action: Action,
}

/// What a frame took.
#[derive(Debug)]
pub struct Done {
    pub build: Stages,
    pub report: RenderReport,
    /// The tree's cost, where it is known.
    pub cost: Option<f64>,
}

/// This machine's cores.
pub struct Cpu {
    builder: Builder,
    bvh: Bvh,
    hierarchies: Hierarchies,
    renderer: Renderer,
    cost: Option<f64>,
}

impl Cpu {
    pub fn new(config: BuildConfig) -> Self {
        Self {
            builder: Builder::new(config),
            bvh: Bvh::default(),
            hierarchies: Hierarchies::new(),
            renderer: Renderer::new(),
            cost: None,
        }
    }
}

impl Machine for Cpu {
    fn name(&self) -> (&'static str, Option<String>) {
        ("cpu", None)
    }

    fn frame(
        &mut self,
        scene: &Scene,
        update: &Update,
        settings: &RenderSettings,
        picture: &mut Picture,
    ) -> Result<Done> {
        let action = update.action;
        if !update.plan.is_plain() {
            return self.planned(scene, update, settings, picture);
        }
        let bvh = &mut self.bvh;
        let mut build = match action {
            Action::Rebuilt => self.builder.build_into(&scene.mesh, bvh)?,
            Action::Refitted => self.builder.refit(&scene.mesh, bvh)?,
            Action::Kept => Stages::default(),
        };
        if action != Action::Kept {
            self.cost = Some(build.time("quality", || bvh.sah_cost()));
        }
        let report = self
            .renderer
            .render(scene, bvh, settings, picture, |_| ())?;
        Ok(Done {
            build,
            report,
            cost: self.cost,
        })
    }
}

impl Cpu {
    /// A frame with a tree for each kind of rays.
    fn planned(
        &mut self,
        scene: &Scene,
        update: &Update,
        settings: &RenderSettings,
        picture: &mut Picture,
    ) -> Result<Done> {
        let (plan, mesh, builder) = (update.plan, &scene.mesh, &mut self.builder);
        let hierarchies = &mut self.hierarchies;
        let mut build = hierarchies.update(builder, mesh, plan, update.action)?;
        let report = if plan.in_turn {
            let (trees, mut turns) = hierarchies.split(builder, mesh, plan);
            let both: (_, &mut dyn Turns) = (&trees, &mut turns);
            let renderer = &mut self.renderer;
            let report = renderer.render_in_turn(scene, both, settings, picture, |_| ())?;
            build.merge(&turns.done().stages);
            report
        } else {
            let trees = hierarchies.trees(plan);
            let renderer = &mut self.renderer;
            renderer.render_with(scene, &trees, settings, picture, |_| ())?
        };
        Ok(Done {
            build,
            report,
            cost: None,
        })
    }
}
