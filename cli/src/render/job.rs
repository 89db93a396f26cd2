//! A picture by a plan, on either backend.

use crate::output;
use crate::reduce::SetCounts;
use anyhow::Result;
use slimbvh::animate::Action;
use slimbvh::reduce::{Done, Hierarchies, Plan};
use slimbvh::{
    BuildConfig, Builder, Bvh, LeafTriangle, Node, Picture, RenderReport, RenderSettings, Renderer,
    Scene, Stages, Turns,
};

/// What was computed, and what it took.
pub struct Outcome {
    pub backend: &'static str,
    pub adapter: Option<String>,
    pub build: Stages,
    pub report: RenderReport,
    pub node_count: usize,
    pub node_bytes: usize,
    pub triangle_bytes: usize,
    pub scratch_bytes: usize,
    pub sets: SetCounts,
}

/// A picture to be made.
pub struct Job<'a> {
    pub scene: &'a Scene,
    pub plan: &'a Plan<'a>,
    pub config: BuildConfig,
    pub settings: &'a RenderSettings,
}

/// What builds and renders on this machine's cores, with memory that it keeps from one job to the next.
#[derive(Default)]
pub struct Cpu {
    builder: Builder,
    hierarchies: Hierarchies,
    renderer: Renderer,
}

impl Cpu {
    /// Nothing built yet.
    #[must_use]
    pub fn new(config: BuildConfig) -> Self {
        Self {
            builder: Builder::new(config),
            ..Self::default()
        }
    }
}

impl Cpu {
    /// Builds a plan's trees, and renders nothing.
    pub fn build(&mut self, mesh: &slimbvh::Mesh, plan: &Plan) -> Result<Stages> {
        Ok(self.hierarchies.build(&mut self.builder, mesh, plan)?)
    }

    /// The trees of a plan that builds none in turn, after a build with it.
    #[must_use]
    pub fn trees<'a>(&'a self, plan: &'a Plan) -> slimbvh::Trees<'a> {
        self.hierarchies.trees(plan)
    }

    /// All that were built, each once.
    pub fn all<'a>(&'a self, plan: &'a Plan) -> impl Iterator<Item = &'a Bvh> {
        self.hierarchies.all(plan)
    }

    /// Bytes of all memory that is held: trees, and what builds and renders.
    #[must_use]
    pub fn held_bytes(&self) -> usize {
        self.hierarchies.bytes() + self.builder.scratch_bytes() + self.renderer.scratch_bytes()
    }
}

impl Job<'_> {
    /// Builds and renders on this machine's cores.
    pub fn on_cpu(&self, picture: &mut Picture) -> Result<Outcome> {
        let mut cpu = Cpu::new(self.config);
        let progress = output::bar("rendering");
        self.again_on_cpu(&mut cpu, picture, |share| progress.set(share))
    }

    /// [`Self::on_cpu`] in memory that is there, which must be of the same configuration.
    pub fn again_on_cpu(
        &self,
        cpu: &mut Cpu,
        picture: &mut Picture,
        show: impl FnMut(f64),
    ) -> Result<Outcome> {
        self.update_on_cpu(cpu, picture, Action::Rebuilt, show)
    }

    /// [`Self::again_on_cpu`] with trees that are brought up to date, which must be of the same mesh and the same plan.
    pub fn update_on_cpu(
        &self,
        cpu: &mut Cpu,
        picture: &mut Picture,
        action: Action,
        show: impl FnMut(f64),
    ) -> Result<Outcome> {
        let Cpu {
            builder,
            hierarchies,
            renderer,
        } = cpu;
        let (mesh, plan) = (&self.scene.mesh, self.plan);
        let mut build = hierarchies.update(builder, mesh, plan, action)?;
        let mut in_turn = Done::default();
        let report = if plan.in_turn {
            let (trees, mut turns) = hierarchies.split(builder, mesh, plan);
            let both: (_, &mut dyn Turns) = (&trees, &mut turns);
            let report = renderer.render_in_turn(self.scene, both, self.settings, picture, show)?;
            in_turn = turns.done();
            report
        } else {
            let trees = hierarchies.trees(plan);
            renderer.render_with(self.scene, &trees, self.settings, picture, show)?
        };
        build.merge(&in_turn.stages);
        let all = || hierarchies.all(self.plan);
        let sets = hierarchies.sets(self.plan);
        let sets = sets.map(|(aim, set)| (aim.name(), set.triangle_count()));
        let sets_in_turn = in_turn.sets.iter();
        let sets_in_turn =
            sets_in_turn.map(|(place, [_, count])| (plan.aims[*place].name(), *count));
        let turn = |which: usize| in_turn.sets.iter().map(|(_, counts)| counts[which]).max();
        let turn = [turn(0), turn(1)].map(Option::unwrap_or_default);
        Ok(Outcome {
            backend: "cpu",
            adapter: None,
            build,
            report,
            node_count: all().map(Bvh::node_count).sum::<usize>() + turn[0],
            node_bytes: all().map(Bvh::node_bytes).sum::<usize>() + turn[0] * size_of::<Node>(),
            triangle_bytes: all().map(Bvh::triangle_bytes).sum::<usize>()
                + turn[1] * size_of::<LeafTriangle>(),
            scratch_bytes: builder.scratch_bytes() + renderer.scratch_bytes(),
            sets: sets.chain(sets_in_turn).collect(),
        })
    }

    /// Builds and renders on a GPU.
    #[cfg(feature = "gpu")]
    pub fn on_gpu(&self, gpu: &slimbvh::gpu::Gpu, picture: &mut Picture) -> Result<Outcome> {
        use slimbvh::reduce;
        let mut renderer = reduce::gpu::ImageRenderer::new(self.config);
        let progress = output::bar("rendering");
        let (scene, plan, settings) = (self.scene, self.plan, self.settings);
        let (build, report) = renderer.render(gpu, (scene, plan), settings, picture, |share| {
            progress.set(share);
        })?;
        let hierarchies = &renderer.hierarchies;
        let scratch = renderer.builder.scratch_bytes() + renderer.renderer.scratch_bytes();
        let counts = hierarchies.all(plan).map(|bvh| bvh.read_counts(gpu));
        let counts = counts.collect::<Result<Vec<_>, _>>()?;
        let sum = |which: usize| {
            counts
                .iter()
                .map(|count| count[which] as usize)
                .sum::<usize>()
        };
        let bytes = hierarchies.all(plan).map(|bvh| bvh.read_bytes(gpu));
        let bytes = bytes.collect::<Result<Vec<_>, _>>()?;
        let sum_of_bytes = |which: usize| bytes.iter().map(|b| b[which] as usize).sum();
        let set_counts = &counts[usize::from(plan.needs_whole)..];
        let sets = hierarchies.sets(plan).zip(set_counts);
        let in_turn = renderer.built_in_turn.iter();
        let in_turn = in_turn.map(|(place, count)| (plan.aims[*place].name(), *count));
        Ok(Outcome {
            backend: "gpu",
            adapter: Some(gpu.name().into()),
            build,
            report,
            node_count: sum(0),
            node_bytes: sum_of_bytes(0),
            triangle_bytes: sum_of_bytes(1),
            scratch_bytes: scratch as usize,
            sets: sets
                .map(|((aim, _), [_, count])| (aim.name(), *count as usize))
                .chain(in_turn)
                .collect(),
        })
    }
}
