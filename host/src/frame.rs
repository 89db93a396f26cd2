//! Frames of a scene: each plans what to leave out, updates the trees, and renders a picture.
//!
//! ```
//! use slimbvh::{Change, Cpu, FrameConfig, Frames, Output, Picture, RenderSettings};
//! # fn main() -> Result<(), slimbvh::CpuError> {
//! # let scene = slimbvh::generate::default_scene();
//! let settings = RenderSettings {
//!     size: [64, 36],
//!     ..RenderSettings::default()
//! };
//! let (mut frames, mut picture) = (Frames::new(Cpu, FrameConfig::default()), Picture::default());
//! let report = frames.render(&scene, &settings, Change::Scene, Output::new(&mut picture))?;
//! println!("build {}, render {}", report.build, report.render.stages);
//! # Ok(())
//! # }
//! ```

use crate::animate::{Action, Update, Upkeep};
use crate::backend::{Backend, Change, Load, Output, Shot, Source, TreeSize, TreesOf};
use crate::reduce::{Hierarchies, Plan, PlanConfig, Planner, Survey, Work};
use crate::{BuildConfig, RenderReport, RenderSettings, Scene, Stages, Stopwatch};
use std::time::Duration;

/// How frames are planned, built and updated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FrameConfig {
    /// How trees are built and stored.
    pub build: BuildConfig,
    /// What the trees leave out.
    pub plan: PlanConfig,
    /// How trees are updated from frame to frame.
    pub update: Update,
    /// Whether each change of the trees is followed by the cost of the tree for all rays, if that needs no wait. Trees
    /// whose cost has grown are rebuilt; without the cost, every eighth update rebuilds.
    pub finds_cost: bool,
}

/// The inputs of a frame whose plan the caller made.
#[derive(Clone, Copy, Debug)]
pub struct FrameRequest<'a> {
    /// The scene in its present state.
    pub scene: &'a Scene,
    /// What the trees leave out.
    pub plan: &'a Plan<'a>,
    /// How the picture is made.
    pub settings: &'a RenderSettings,
    /// What changed since the previous frame.
    pub change: Change,
}

/// The report of a frame.
#[derive(Debug)]
pub struct FrameReport<B: Backend> {
    /// How the trees were updated.
    pub action: Action,
    /// Times of planning and building, deferred trees included.
    pub build: Stages,
    /// Times of rendering, and counts of rays.
    pub render: RenderReport,
    /// Each deferred set that was built: its index among the plan's targets, and its size.
    pub deferred: Vec<(usize, TreeSize)>,
    /// The [cost](crate::Bvh::sah_cost) of the tree for all rays, if known.
    pub sah_cost: Option<f64>,
    /// The backend's own decisions.
    pub decisions: Option<B::Decisions>,
}

/// The sizes of a frame's trees.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FrameSizes {
    /// The sum of all trees that exist at the same time.
    pub total: TreeSize,
    /// The triangle count of each target's set, by the target's name.
    pub sets: Vec<(String, usize)>,
}

/// Renders frames. Keeps all memory from one frame to the next.
#[derive(Debug)]
pub struct Frames<B: Backend> {
    backend: B,
    config: FrameConfig,
    planner: Planner,
    upkeep: Upkeep,
    held: B::Scene,
    builder: B::Builder,
    hierarchies: Hierarchies<B>,
    renderer: B::Renderer,
    /// The deferred sets of the latest frame.
    deferred: Vec<(usize, TreeSize)>,
    sah_cost: Option<f64>,
}

impl<B: Backend> Frames<B> {
    /// Empty buffers; the first frame builds the trees.
    #[must_use]
    pub fn new(backend: B, config: FrameConfig) -> Self {
        Self {
            backend,
            config,
            planner: Planner::new(config.build, config.plan),
            upkeep: Upkeep::new(config.update),
            held: B::Scene::default(),
            builder: backend.builder(config.build),
            hierarchies: Hierarchies::default(),
            renderer: B::Renderer::default(),
            deferred: Vec::new(),
            sah_cost: None,
        }
    }

    /// Surveys a scene before its first frame, if that is likely to pay. [`Self::render`] surveys each new scene itself.
    ///
    /// # Errors
    /// For an invalid mesh, and for cameras and lights that cannot be rendered.
    pub fn survey(
        &mut self,
        scene: &Scene,
        settings: &RenderSettings,
    ) -> Result<Option<&Survey>, B::Error> {
        self.planner.survey(scene, settings)
    }

    /// The plan for a scene, from the latest survey.
    ///
    /// # Errors
    /// For cameras and lights that cannot be rendered.
    pub fn plan(&self, scene: &Scene, settings: &RenderSettings) -> Result<Plan<'_>, B::Error> {
        Ok(self.planner.plan(scene, settings)?)
    }

    /// Plans, updates the trees, and renders through the scene's first camera. The first frame builds all trees, whatever
    /// `change` is.
    ///
    /// # Errors
    /// For an invalid mesh, cameras and lights that cannot be rendered, and sizes above the backend's limits.
    pub fn render(
        &mut self,
        scene: &Scene,
        settings: &RenderSettings,
        change: Change,
        output: Output,
    ) -> Result<FrameReport<B>, B::Error> {
        let mut planner = std::mem::take(&mut self.planner);
        let report = self.render_planning(&mut planner, (scene, settings, change), output);
        self.planner = planner;
        report
    }

    fn render_planning(
        &mut self,
        planner: &mut Planner,
        (scene, settings, change): (&Scene, &RenderSettings, Change),
        output: Output,
    ) -> Result<FrameReport<B>, B::Error> {
        if change == Change::Scene {
            planner.survey::<B::Error>(scene, settings)?;
        }
        let begin = Stopwatch::start();
        // A backend that records measures the components itself.
        if change == Change::Vertices && !B::RECORDS {
            planner.follow(&scene.mesh);
        }
        let plan = &planner.plan(scene, settings)?;
        let planning = begin.elapsed();
        let request = FrameRequest {
            scene,
            plan,
            settings,
            change,
        };
        let mut report = self.render_planned(&request, output)?;
        if !plan.is_plain() {
            report.build.add("plan", planning);
        }
        Ok(report)
    }

    /// Renders as [`Self::render`] does, with the caller's plan.
    ///
    /// # Errors
    /// Those of [`Self::render`].
    pub fn render_planned(
        &mut self,
        request: &FrameRequest,
        output: Output,
    ) -> Result<FrameReport<B>, B::Error> {
        let rendered = self.try_render(request, output);
        if rendered.is_err() {
            // The recorded passes did not run, so the next frame rebuilds all trees.
            self.upkeep = Upkeep::new(self.config.update);
        }
        rendered
    }

    fn try_render(
        &mut self,
        request: &FrameRequest,
        output: Output,
    ) -> Result<FrameReport<B>, B::Error> {
        let begin = Stopwatch::start();
        let FrameRequest {
            scene,
            plan,
            settings,
            change,
        } = *request;
        let action = self.next_action(change);
        let mut recording = self.update(scene, plan, (change, action), Some(settings))?;
        let Self {
            backend,
            held,
            builder,
            hierarchies,
            renderer,
            ..
        } = self;
        if plan.is_plain() && action != Action::Kept && self.config.finds_cost {
            let whole = hierarchies.whole();
            self.sah_cost = whole.and_then(|bvh| B::sah_cost(&mut recording, bvh));
            if let Some(cost) = self.sah_cost {
                self.upkeep.measured(cost);
            }
        }
        let sides = hierarchies.sides(plan);
        let decisions = B::decisions_later(&mut recording, held, &sides)?;
        let source = Source {
            held,
            mesh: &scene.mesh,
        };
        let (trees, mut deferred) = hierarchies.split(builder, source, plan);
        let shot = Shot {
            scene,
            held,
            trees: &trees,
            settings,
            begin,
        };
        let deferring = plan.defers_lights.then_some(&mut deferred as _);
        let (build, render) = backend.render(recording, renderer, &shot, deferring, output)?;
        let mut sizes = Vec::new();
        for (place, size) in deferred.sizes() {
            sizes.push((place, backend.pending_size(size)?));
        }
        self.deferred.clone_from(&sizes);
        let decisions = decisions.map(|pending| backend.decisions(pending));
        Ok(FrameReport {
            action,
            build,
            render,
            deferred: sizes,
            sah_cost: self.sah_cost.filter(|_| plan.is_plain()),
            decisions: decisions.transpose()?,
        })
    }

    /// Builds a plan's trees and renders nothing. Returns the time of each stage.
    ///
    /// # Errors
    /// For an invalid mesh, and sizes above the backend's limits.
    pub fn build(&mut self, scene: &Scene, plan: &Plan) -> Result<Stages, B::Error> {
        let action = self.next_action(Change::Scene);
        self.deferred.clear();
        let built = self
            .update(scene, plan, (Change::Scene, action), None)
            .and_then(|recording| self.backend.submit(recording));
        if built.is_err() {
            self.upkeep = Upkeep::new(self.config.update);
        }
        built
    }

    /// How the trees are to be updated now.
    fn next_action(&mut self, change: Change) -> Action {
        if change == Change::Scene {
            self.upkeep = Upkeep::new(self.config.update);
        }
        self.upkeep.next(change != Change::View)
    }

    /// Records the update of the trees.
    fn update(
        &mut self,
        scene: &Scene,
        plan: &Plan,
        (change, action): (Change, Action),
        settings: Option<&RenderSettings>,
    ) -> Result<B::Recording, B::Error> {
        let load = Load {
            scene,
            change,
            settings,
            topology: plan.topology,
            may_turn_away: plan.may_turn_away,
        };
        self.backend.load(&mut self.held, &self.builder, &load)?;
        let mut recording = self.backend.begin();
        let mut work = Work {
            recording: &mut recording,
            builder: &mut self.builder,
            held: &mut self.held,
            mesh: &scene.mesh,
        };
        self.hierarchies.update(&mut work, plan, action)?;
        Ok(recording)
    }

    /// The latest survey.
    #[must_use]
    pub fn surveyed(&self) -> Option<&Survey> {
        self.planner.surveyed()
    }

    /// The time of the latest survey.
    #[must_use]
    pub fn survey_time(&self) -> Duration {
        let stages = self.surveyed().map(|survey| survey.stages.total());
        stages.unwrap_or_default()
    }

    /// The trees of a plan without deferred ones, once they are built.
    #[must_use]
    pub fn trees<'a>(&'a self, plan: &'a Plan) -> TreesOf<'a, B> {
        self.hierarchies.trees(&self.held, plan)
    }

    /// The trees built so far.
    #[must_use]
    pub fn hierarchies(&self) -> &Hierarchies<B> {
        &self.hierarchies
    }

    /// The sizes of the latest frame's trees. `plan` must be that frame's plan. Waits for a GPU.
    ///
    /// # Errors
    /// If the device was lost.
    pub fn sizes(&self, plan: &Plan) -> Result<FrameSizes, B::Error> {
        let mut sizes = FrameSizes::default();
        let total = &mut sizes.total;
        if let Some(whole) = self
            .hierarchies
            .all(plan)
            .next()
            .filter(|_| plan.needs_whole)
        {
            total.add(&self.backend.size(whole)?);
        }
        for (target, bvh) in self.hierarchies.sets(plan) {
            let size = self.backend.size(bvh)?;
            total.add(&size);
            sizes.sets.push((target.name(), size.triangle_count));
        }
        // Only one deferred tree exists at a time.
        let largest = self.deferred.iter().map(|(_, size)| *size);
        total.add(&largest.fold(TreeSize::default(), TreeSize::larger));
        for (place, size) in &self.deferred {
            let name = plan.targets[*place].name();
            sizes.sets.push((name, size.triangle_count));
        }
        Ok(sizes)
    }

    /// Bytes of memory that builds and pictures use besides trees. The next frame reuses it.
    #[must_use]
    pub fn scratch_bytes(&self) -> usize {
        B::scratch_bytes(&self.builder, &self.renderer)
    }

    /// Bytes of all memory held: trees, builder and renderer.
    #[must_use]
    pub fn held_bytes(&self) -> usize {
        self.hierarchies.held_bytes() + self.scratch_bytes()
    }
}

#[cfg(all(test, feature = "scenes"))]
mod tests {
    use super::*;
    use crate::animate::{Animation, Deform, Motion};
    use crate::generate::default_scene;
    use crate::{Cpu, CpuError, Picture};

    const SETTINGS: RenderSettings = RenderSettings {
        size: [48, 27],
        sample_count: 1,
        view: crate::View::Color,
        mirror_depth: 1,
        dark_rays: false,
    };

    fn frame(frames: &mut Frames<Cpu>, scene: &Scene, change: Change) -> (Action, Picture) {
        let mut picture = Picture::default();
        let report = frames.render(scene, &SETTINGS, change, Output::new(&mut picture));
        let report = report.unwrap_or_else(|error| panic!("{error}"));
        (report.action, picture)
    }

    #[test]
    fn trees_that_follow_give_the_pictures_of_new_ones() {
        let config = FrameConfig {
            update: Update::Auto,
            finds_cost: true,
            ..FrameConfig::default()
        };
        let mut scene = default_scene();
        let motion = Motion {
            frame_count: 64,
            deform: Some(Deform::Twist),
            ..Motion::default()
        };
        let animation = Animation::new(&scene, motion);
        let mut frames = Frames::new(Cpu, config);
        let mut actions = Vec::new();
        for (time, change) in [
            (0, Change::Scene),
            (0, Change::View),
            (1, Change::Vertices),
            (1, Change::Scene),
        ] {
            animation.pose(time, &mut scene);
            let (action, picture) = frame(&mut frames, &scene, change);
            let (_, expected) = frame(&mut Frames::new(Cpu, config), &scene, Change::Scene);
            assert!(picture == expected, "{change:?}");
            actions.push(action);
        }
        use Action::{Kept, Rebuilt, Refitted};
        assert_eq!(actions, [Rebuilt, Kept, Refitted, Rebuilt]);
    }

    #[test]
    fn after_an_error_the_next_frame_builds_all() {
        let scene = default_scene();
        let mut frames = Frames::new(Cpu, FrameConfig::default());
        frame(&mut frames, &scene, Change::Scene);
        assert_eq!(frame(&mut frames, &scene, Change::View).0, Action::Kept);
        let blind = Scene {
            cameras: Vec::new(),
            ..scene.clone()
        };
        let planner = Planner::default();
        let plan = planner.plan(&scene, &SETTINGS).unwrap();
        let request = FrameRequest {
            scene: &blind,
            plan: &plan,
            settings: &SETTINGS,
            change: Change::View,
        };
        let mut picture = Picture::default();
        let failed = frames.render_planned(&request, Output::new(&mut picture));
        assert!(matches!(failed, Err(CpuError::View(_))));
        assert_eq!(frame(&mut frames, &scene, Change::View).0, Action::Rebuilt);
    }
}
