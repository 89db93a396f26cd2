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

use crate::animate::Action;
use crate::backend::{Backend, Change, Output, Shot, Source, TreeSize, Trees, TreesOf};
use crate::reduce::{Plan, Views};
use crate::views::{FrameConfig, FrameSizes, SetSize, ViewSets};
use crate::{RenderReport, RenderSettings, Scene, Stages, Stopwatch, ViewError};
use std::time::Duration;

/// The inputs of a frame whose plan the caller made.
///
/// ```
/// # use slimbvh::{Change, Cpu, FrameConfig, FrameRequest, Frames, Output, Picture, RenderSettings};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// # let scene = slimbvh::generate::default_scene();
/// # let settings = RenderSettings { size: [16, 9], ..RenderSettings::default() };
/// # let (mut frames, mut picture) = (Frames::new(Cpu, FrameConfig::default()), Picture::default());
/// # let plan = frames.plan(&scene, &settings, Change::Scene)?;
/// let (scene, settings) = (&scene, &settings);
/// let request = FrameRequest { scene, plan: &plan, settings, change: Change::Scene };
/// frames.render_planned(&request, Output::new(&mut picture))?;
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct FrameRequest<'a> {
    /// The scene in its present state.
    pub scene: &'a Scene,
    /// What the trees leave out.
    pub plan: &'a Plan,
    /// How the picture is made.
    pub settings: &'a RenderSettings,
    /// What changed since the previous frame.
    pub change: Change,
}

/// The report of a frame.
///
/// ```
/// use slimbvh::animate::Action;
/// # use slimbvh::{Change, Cpu, FrameConfig, Frames, Output, Picture, RenderSettings};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// # let scene = slimbvh::generate::default_scene();
/// # let settings = RenderSettings { size: [16, 9], ..RenderSettings::default() };
/// # let (mut frames, mut picture) = (Frames::new(Cpu, FrameConfig::default()), Picture::default());
/// let report = frames.render(&scene, &settings, Change::Scene, Output::new(&mut picture))?;
/// assert_eq!((report.action, report.render.primary_ray_count), (Action::Rebuilt, 16 * 9));
/// println!("build {}, render {}", report.build, report.render.stages);
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct FrameReport<B: Backend> {
    /// How the trees were updated.
    pub action: Action,
    /// Times of planning and building, deferred trees included.
    pub build: Stages,
    /// Times of rendering, and counts of rays.
    pub render: RenderReport,
    /// Each deferred set that was built: its index among the plan's sets, and its size.
    pub deferred: Vec<(usize, TreeSize)>,
    /// The [cost](crate::Bvh::sah_cost) of the tree for all rays, if known.
    pub sah_cost: Option<f64>,
    /// The backend's own decisions.
    pub decisions: Option<B::Decisions>,
}

/// Renders frames. Keeps all memory from one frame to the next.
///
/// ```
/// use slimbvh::{Change, Cpu, FrameConfig, Frames, Output, Picture, RenderSettings};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// # let mut scene = slimbvh::generate::default_scene();
/// # let settings = RenderSettings { size: [16, 9], ..RenderSettings::default() };
/// let (mut frames, mut picture) = (Frames::new(Cpu, FrameConfig::default()), Picture::default());
/// for change in [Change::Scene, Change::View, Change::View] {
///     frames.render(&scene, &settings, change, Output::new(&mut picture))?;
///     scene.cameras[0].eye[0] += 0.1;
/// }
/// # assert_eq!(picture.pixels.len(), 16 * 9);
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Frames<B: Backend> {
    views: ViewSets<B>,
    renderer: B::Renderer,
    /// The deferred sets of the latest frame.
    deferred: Vec<(usize, TreeSize)>,
}

impl<B: Backend> Frames<B> {
    /// Empty buffers; the first frame builds the trees.
    ///
    /// ```
    /// use slimbvh::{Cpu, FrameConfig, Frames};
    /// let frames = Frames::new(Cpu, FrameConfig::for_frames(1000));
    /// assert!(frames.views().trees().is_empty());
    /// ```
    #[must_use]
    pub fn new(backend: B, config: FrameConfig) -> Self {
        Self {
            views: ViewSets::new(backend, config),
            renderer: B::Renderer::default(),
            deferred: Vec::new(),
        }
    }

    /// Plans, updates the trees, and renders through the scene's first camera. The first frame builds all trees, whatever
    /// `change` is, after a survey of the surfaces if that is likely to pay.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, Frames, Output, Picture, RenderSettings};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mut scene = slimbvh::generate::default_scene();
    /// # let settings = RenderSettings { size: [16, 9], ..RenderSettings::default() };
    /// # let (mut frames, mut picture) = (Frames::new(Cpu, FrameConfig::default()), Picture::default());
    /// frames.render(&scene, &settings, Change::Scene, Output::new(&mut picture))?;
    /// scene.mesh.vertices[0][1] += 0.5;
    /// let mut progress = |share| println!("{:.0} %", 100.0 * share);
    /// let output = Output { progress: Some(&mut progress), picture: &mut picture };
    /// frames.render(&scene, &settings, Change::Vertices, output)?;
    /// # Ok(())
    /// # }
    /// ```
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
        let change = self.views.seen((&scene.mesh).into(), change);
        let plan = self.plan(scene, settings, change)?;
        let request = FrameRequest {
            scene,
            plan: &plan,
            settings,
            change,
        };
        let mut report = self.render_planned(&request, output)?;
        if !plan.is_plain() {
            report.build.add("plan", self.views.planning());
        }
        self.views.keep_plan(plan);
        Ok(report)
    }

    /// The plan of the next frame, for [`Self::render_planned`]. Surveys the surfaces if that is likely to pay.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, Frames, RenderSettings};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let scene = slimbvh::generate::default_scene();
    /// let mut frames = Frames::new(Cpu, FrameConfig::default().reducing());
    /// let plan = frames.plan(&scene, &RenderSettings::default(), Change::Scene)?;
    /// println!("{plan}");
    /// # assert!(!plan.is_plain());
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// For an invalid mesh, and cameras and lights that cannot be rendered.
    pub fn plan(
        &mut self,
        scene: &Scene,
        settings: &RenderSettings,
        change: Change,
    ) -> Result<Plan, B::Error> {
        let views = Views::of_picture(scene, settings)?;
        let geometry = B::Geometry::from(&scene.mesh);
        let change = self.views.seen(geometry, change);
        self.views.next_plan(geometry, &views, change)
    }

    /// Renders as [`Self::render`] does, with the caller's plan.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, FrameRequest, Frames, Output, Picture, RenderSettings};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let scene = &slimbvh::generate::default_scene();
    /// # let settings = &RenderSettings { size: [16, 9], ..RenderSettings::default() };
    /// # let (mut frames, mut picture) = (Frames::new(Cpu, FrameConfig::default()), Picture::default());
    /// let plan = frames.plan(scene, settings, Change::Scene)?;
    /// println!("{plan}");
    /// let request = FrameRequest { scene, plan: &plan, settings, change: Change::Scene };
    /// let report = frames.render_planned(&request, Output::new(&mut picture))?;
    /// # assert_eq!(report.render.primary_ray_count, 16 * 9);
    /// # Ok(())
    /// # }
    /// ```
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
            self.views.forget();
            self.renderer = B::Renderer::default();
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
        let Self {
            views, renderer, ..
        } = self;
        let backend = views.backend;
        let geometry = B::Geometry::from(&scene.mesh);
        backend.check_picture(scene, settings)?;
        let mut recording = backend.begin();
        let action = views.record_planned(&mut recording, geometry, plan, change)?;
        backend.load_picture(&mut views.held, scene, change)?;
        let sah_cost = views.measure_cost(&mut recording, plan, action);
        let ViewSets {
            held,
            builder,
            hierarchies,
            ..
        } = views;
        let sides = hierarchies.sides(plan);
        let decisions = B::decisions_later(&mut recording, held, &sides)?;
        let source = Source { held, geometry };
        let (trees, mut deferred) = hierarchies.split(builder, source, plan);
        let trees = Trees::of_targets(&trees, plan.light_count()).ok_or(ViewError::NoCamera)?;
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
            sah_cost,
            decisions: decisions.transpose()?,
        })
    }

    /// Builds a plan's trees and renders nothing. Returns the time of each stage.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, Frames, RenderSettings};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let scene = slimbvh::generate::default_scene();
    /// # let mut frames = Frames::new(Cpu, FrameConfig::default());
    /// let plan = frames.plan(&scene, &RenderSettings::default(), Change::Scene)?;
    /// println!("{}", frames.build(&scene, &plan)?);
    /// assert!(frames.sizes(&plan)?.total.triangle_count > 0);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// For an invalid mesh, and sizes above the backend's limits.
    pub fn build(&mut self, scene: &Scene, plan: &Plan) -> Result<Stages, B::Error> {
        self.deferred.clear();
        let views = &mut self.views;
        let mut recording = views.backend.begin();
        let geometry = B::Geometry::from(&scene.mesh);
        let built = views
            .record_planned(&mut recording, geometry, plan, Change::Scene)
            .and_then(|_| views.backend.submit(recording));
        if built.is_err() {
            views.forget();
        }
        built
    }

    /// The view sets that pictures are rendered with.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, Frames, Output, Picture, RenderSettings};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let scene = slimbvh::generate::default_scene();
    /// # let settings = RenderSettings { size: [16, 9], ..RenderSettings::default() };
    /// # let (mut frames, mut picture) = (Frames::new(Cpu, FrameConfig::default()), Picture::default());
    /// frames.render(&scene, &settings, Change::Scene, Output::new(&mut picture))?;
    /// // The tree of the camera's rays: what is in the middle of the picture?
    /// let ray = scene.cameras[0].ray([8, 4], settings.size)?;
    /// let hit = frames.views().trees()[0].closest_hit(ray);
    /// println!("{hit:?}");
    /// # assert!(hit.is_hit());
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn views(&self) -> &ViewSets<B> {
        &self.views
    }

    /// The time of the latest survey.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, Frames, RenderSettings};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let scene = slimbvh::generate::default_scene();
    /// let mut frames = Frames::new(Cpu, FrameConfig::default().reducing());
    /// frames.plan(&scene, &RenderSettings::default(), Change::Scene)?;
    /// println!("surveyed in {:?}", frames.survey_time());
    /// # assert!(!frames.survey_time().is_zero());
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn survey_time(&self) -> Duration {
        let stages = self.views.survey().map(|survey| survey.stages.total());
        stages.unwrap_or_default()
    }

    /// The trees of a picture's plan without deferred ones, once they are built.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, Frames, RenderSettings};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let scene = slimbvh::generate::default_scene();
    /// # let mut frames = Frames::new(Cpu, FrameConfig::default());
    /// let plan = frames.plan(&scene, &RenderSettings::default(), Change::Scene)?;
    /// frames.build(&scene, &plan)?;
    /// let trees = frames.trees(&plan);
    /// assert_eq!(trees.lights.len(), scene.lights.len());
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn trees<'a>(&'a self, plan: &'a Plan) -> TreesOf<'a, B> {
        let trees = self.views.trees_of(plan);
        let trees = Trees::of_targets(&trees, plan.light_count());
        trees.unwrap_or_else(|| Trees::all(self.views.hierarchies.whole_or_empty(), 0))
    }

    /// The sizes of the latest frame's trees. `plan` must be that frame's plan. Waits for a GPU.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, Frames, RenderSettings};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let scene = slimbvh::generate::default_scene();
    /// # let mut frames = Frames::new(Cpu, FrameConfig::default());
    /// # let plan = frames.plan(&scene, &RenderSettings::default(), Change::Scene)?;
    /// frames.build(&scene, &plan)?;
    /// let sizes = frames.sizes(&plan)?;
    /// println!("{} bytes in {} sets", sizes.total.node_bytes, sizes.sets.len());
    /// # assert!(sizes.total.node_bytes > 0);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// If the device was lost.
    pub fn sizes(&self, plan: &Plan) -> Result<FrameSizes, B::Error> {
        let mut sizes = self.views.sizes_of(plan)?;
        // Only one deferred tree exists at a time.
        let largest = self.deferred.iter().map(|(_, size)| *size);
        sizes
            .total
            .add(&largest.fold(TreeSize::default(), TreeSize::larger));
        for (place, size) in &self.deferred {
            let name = plan.sets[*place].name();
            sizes.sets.push(SetSize::new(name, size));
        }
        Ok(sizes)
    }

    /// Bytes of memory that builds and pictures use besides trees. The next frame reuses it.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, Frames, RenderSettings};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let scene = slimbvh::generate::default_scene();
    /// # let mut frames = Frames::new(Cpu, FrameConfig::default());
    /// # let plan = frames.plan(&scene, &RenderSettings::default(), Change::Scene)?;
    /// frames.build(&scene, &plan)?;
    /// println!("{} bytes beside the trees", frames.scratch_bytes());
    /// # assert!(frames.scratch_bytes() > 0);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn scratch_bytes(&self) -> usize {
        B::scratch_bytes(&self.views.builder, &self.renderer)
    }

    /// Bytes of all memory held: trees, builder and renderer.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, Frames, RenderSettings};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let scene = slimbvh::generate::default_scene();
    /// # let mut frames = Frames::new(Cpu, FrameConfig::default());
    /// # let plan = frames.plan(&scene, &RenderSettings::default(), Change::Scene)?;
    /// frames.build(&scene, &plan)?;
    /// let trees = frames.held_bytes() - frames.scratch_bytes();
    /// assert_eq!(trees, frames.views().held_bytes());
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn held_bytes(&self) -> usize {
        self.views.held_bytes() + self.scratch_bytes()
    }
}

#[cfg(all(test, feature = "scenes"))]
mod tests {
    use super::*;
    use crate::animate::{Animation, Deform, Motion, Update};
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
        let plan = frames.plan(&scene, &SETTINGS, Change::View).unwrap();
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
