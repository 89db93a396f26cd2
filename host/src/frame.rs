//! Frames of a scene: what may be left out is planned, trees are brought up to date, and a picture is rendered.
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
use crate::{BuildConfig, RenderReport, RenderSettings, Scene, Stages};
use std::time::{Duration, Instant};

/// How frames are made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FrameConfig {
    /// How trees are built and stored.
    pub build: BuildConfig,
    /// What they leave out.
    pub plan: PlanConfig,
    /// What is done to trees from frame to frame.
    pub update: Update,
    /// Whether the cost of a tree for all rays is found after each change, where that takes no wait. By it worn trees are
    /// rebuilt; without it, every eighth is.
    pub finds_cost: bool,
}

/// A frame whose plan is given.
#[derive(Clone, Copy, Debug)]
pub struct FrameRequest<'a> {
    /// As it is now.
    pub scene: &'a Scene,
    /// What trees leave out.
    pub plan: &'a Plan<'a>,
    /// How the picture is made.
    pub settings: &'a RenderSettings,
    /// What changed since the frame before.
    pub change: Change,
}

/// What a frame did.
#[derive(Debug)]
pub struct FrameReport<B: Backend> {
    /// What was done to the trees.
    pub action: Action,
    /// Times of planning and building, of deferred trees as well.
    pub build: Stages,
    /// Times of rendering, and counts of rays.
    pub render: RenderReport,
    /// The place among the plan's targets of each deferred set that was built, and its size.
    pub deferred: Vec<(usize, TreeSize)>,
    /// The [cost](crate::Bvh::sah_cost) of the tree for all rays, where it is known.
    pub sah_cost: Option<f64>,
    /// What the backend decided by itself.
    pub decisions: Option<B::Decisions>,
}

/// How large the trees of a frame are.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FrameSizes {
    /// All trees together that are there at once.
    pub total: TreeSize,
    /// How many triangles are in the set of each target that has one, by name.
    pub sets: Vec<(String, usize)>,
}

/// Makes frames, and keeps all memory from one to the next.
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
    /// Those of the latest frame.
    deferred: Vec<(usize, TreeSize)>,
    sah_cost: Option<f64>,
}

impl<B: Backend> Frames<B> {
    /// Nothing is built yet.
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

    /// Surveys a scene before its first frame, where that is likely to pay; [`Self::render`] does it for a new scene.
    ///
    /// # Errors
    /// For an unfit mesh, and for cameras and lights that make no picture.
    pub fn survey(
        &mut self,
        scene: &Scene,
        settings: &RenderSettings,
    ) -> Result<Option<&Survey>, B::Error> {
        self.planner.survey(scene, settings)
    }

    /// The plan for a scene by the latest survey.
    ///
    /// # Errors
    /// For cameras and lights that make no picture.
    pub fn plan(&self, scene: &Scene, settings: &RenderSettings) -> Result<Plan<'_>, B::Error> {
        Ok(self.planner.plan(scene, settings)?)
    }

    /// Plans, brings the trees up to date, and renders through the scene's first camera. The first frame builds all there is,
    /// whatever changed.
    ///
    /// # Errors
    /// For an unfit mesh, for cameras and lights that make no picture, and for what is larger than the backend takes.
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
        let begin = Instant::now();
        // A backend that decides by itself needs no positions of the host's.
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

    /// [`Self::render`] by a plan of the caller's.
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
            // What was recorded was not run: the next frame builds all there is.
            self.upkeep = Upkeep::new(self.config.update);
        }
        rendered
    }

    fn try_render(
        &mut self,
        request: &FrameRequest,
        output: Output,
    ) -> Result<FrameReport<B>, B::Error> {
        let begin = Instant::now();
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

    /// Builds a plan's trees anew and renders nothing. Returns the time of each stage.
    ///
    /// # Errors
    /// For an unfit mesh, and one that is larger than the backend takes.
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

    /// What is to be done to the trees now.
    fn next_action(&mut self, change: Change) -> Action {
        if change == Change::Scene {
            self.upkeep = Upkeep::new(self.config.update);
        }
        self.upkeep.next(change != Change::View)
    }

    /// Records that the trees be brought up to date.
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

    /// What the survey took.
    #[must_use]
    pub fn survey_time(&self) -> Duration {
        let stages = self.surveyed().map(|survey| survey.stages.total());
        stages.unwrap_or_default()
    }

    /// The trees of a plan that defers none, once they are built.
    #[must_use]
    pub fn trees<'a>(&'a self, plan: &'a Plan) -> TreesOf<'a, B> {
        self.hierarchies.trees(&self.held, plan)
    }

    /// The trees that are there.
    #[must_use]
    pub fn hierarchies(&self) -> &Hierarchies<B> {
        &self.hierarchies
    }

    /// How large the trees of the latest frame are, which was by this plan. A GPU is waited for.
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
        // Of deferred trees there is one at a time.
        let largest = self.deferred.iter().map(|(_, size)| *size);
        total.add(&largest.fold(TreeSize::default(), TreeSize::larger));
        for (place, size) in &self.deferred {
            let name = plan.targets[*place].name();
            sizes.sets.push((name, size.triangle_count));
        }
        Ok(sizes)
    }

    /// Bytes of the memory that builds and pictures need besides trees; it is kept for the next frame.
    #[must_use]
    pub fn scratch_bytes(&self) -> usize {
        B::scratch_bytes(&self.builder, &self.renderer)
    }

    /// Bytes of all memory that is held: trees, and what builds and renders.
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
