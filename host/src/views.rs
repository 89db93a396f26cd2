//! View sets: what the rays of each target need, built and kept up from frame to frame.

mod config;

pub use config::{FrameConfig, FrameSizes, SetSize};

use crate::animate::{Action, Upkeep};
use crate::backend::{Backend, Change, Load, TreeOf, TreeSize};
#[cfg(feature = "gpu")]
use crate::gpu::{DecisionsDownload, Frame, Geometry, Gpu, GpuError, SetFit};
use crate::reduce::{Hierarchies, Plan, Planner, Survey, ViewTarget, Views, Work};
use crate::{Cpu, CpuError, Mesh, Stages, Stopwatch};
use std::borrow::Cow;
use std::time::Duration;

/// The trees that the rays of a list of [`ViewTarget`]s need. Each update decides what each tree leaves out, builds, refits or
/// keeps it, and reuses all memory. No answer depends on the decisions.
///
/// A target's tree answers the rays of that target only. For the others list [`ViewTarget::other_rays`].
///
/// ```
/// use slimbvh::{Camera, Change, Cpu, FrameConfig, Ray, ViewSets, ViewTarget, generate};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let mesh = generate::torus_knot(&generate::TorusKnot::default());
/// let bounds = mesh.bounds().ok_or("no triangles")?;
/// let (camera, size, lamp) = (Camera::facing(&bounds, 16.0 / 9.0), [1280, 720], [3.0, 9.0, 6.0]);
/// let targets = [
///     ViewTarget::camera(&camera, size)?,
///     ViewTarget::rays_to(lamp, 0.0)?.named("lamp"),
/// ];
///
/// let mut views = ViewSets::new(Cpu, FrameConfig::for_frames(1000));
/// views.update(&mesh, &targets, Change::Scene)?;
/// let [eye, shadow] = views.trees()[..] else { unreachable!("two targets have two trees") };
///
/// let ray = Ray::new(camera.eye, std::array::from_fn(|i| camera.target[i] - camera.eye[i]));
/// assert!(eye.bvh.closest_hit(&ray).is_hit());
/// assert!(shadow.bvh.triangle_count() < mesh.indices.len());
/// println!("{}", views.explain());
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct ViewSets<B: Backend> {
    pub(crate) backend: B,
    config: FrameConfig,
    pub(crate) planner: Planner,
    upkeep: Upkeep,
    pub(crate) held: B::Held,
    pub(crate) builder: B::Builder,
    pub(crate) hierarchies: Hierarchies<B>,
    /// The latest plan; `None` before the first update, and after one that failed.
    plan: Option<Plan>,
    /// The mesh as it was surveyed, if the caller has it on a GPU alone.
    surveyed: Option<Mesh>,
    /// The numbers of triangles and vertices of the geometry; `None` if the next one counts as another.
    counts: Option<[usize; 2]>,
    /// The time of the latest plan.
    planning: Duration,
    sah_cost: Option<f64>,
}

impl<B: Backend> ViewSets<B> {
    /// Empty buffers; the first update builds.
    ///
    /// ```
    /// use slimbvh::{Change, Cpu, FrameConfig, ViewSets, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
    /// let mut views = ViewSets::new(Cpu, FrameConfig::default());
    /// assert!(views.trees().is_empty());
    /// views.update(&mesh, &[ViewTarget::other_rays()], Change::Scene)?;
    /// assert_eq!(views.trees()[0].bvh.triangle_count(), mesh.indices.len());
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn new(backend: B, config: FrameConfig) -> Self {
        Self {
            backend,
            config,
            planner: Planner::new(config.build, config.plan),
            upkeep: Upkeep::new(config.update),
            held: B::Held::default(),
            builder: backend.builder(config.build),
            hierarchies: Hierarchies::default(),
            plan: None,
            surveyed: None,
            counts: None,
            planning: Duration::ZERO,
            sah_cost: None,
        }
    }

    /// Plans, and records or runs what the plan needs.
    fn record(
        &mut self,
        recording: &mut B::Recording,
        geometry: B::Geometry<'_>,
        views: &Views,
        change: Change,
    ) -> Result<(), B::Error> {
        let change = self.seen(geometry, change);
        let plan = self.next_plan(geometry, views, change)?;
        let action = self.record_planned(recording, geometry, &plan, change)?;
        self.measure_cost(recording, &plan, action);
        self.plan = Some(plan);
        Ok(())
    }

    /// The change that the trees must follow: the first geometry, and one with other counts, is another one whatever the
    /// caller says.
    pub(crate) fn seen(&self, geometry: B::Geometry<'_>, change: Change) -> Change {
        if B::is_held(&self.held, geometry) && self.counts == Some(B::counts(geometry)) {
            change
        } else {
            Change::Scene
        }
    }

    /// The plan for the geometry in its present state. Surveys the surfaces where that is likely to pay and there is no
    /// survey yet.
    pub(crate) fn next_plan(
        &mut self,
        geometry: B::Geometry<'_>,
        views: &Views,
        change: Change,
    ) -> Result<Plan, B::Error> {
        // The survey is the planner's alone, so that it can follow in place.
        self.plan = None;
        let planned = self.try_plan(geometry, views, change);
        if planned.is_err() {
            self.forget();
        }
        planned
    }

    fn try_plan(
        &mut self,
        geometry: B::Geometry<'_>,
        views: &Views,
        change: Change,
    ) -> Result<Plan, B::Error> {
        let [count, _] = B::counts(geometry);
        match change {
            Change::Scene => {
                self.planner.forget();
                self.surveyed = None;
            }
            // A backend that records measures the components itself.
            Change::Vertices if B::RECORDS => self.planner.moved(),
            Change::Vertices => self.planner.follow(&*self.backend.on_host(geometry)?),
            Change::View => {}
        }
        if self.planner.surveyed().is_none() && self.planner.wants_survey(count, views) {
            let mesh = self.backend.on_host(geometry)?;
            self.planner.survey(&mesh, views)?;
            if let Cow::Owned(mesh) = mesh {
                self.surveyed = Some(mesh);
            }
        }
        let begin = Stopwatch::start();
        let plan = match (&self.surveyed, self.planner.surveyed()) {
            (_, None) => self.planner.plain(count, views),
            (Some(mesh), Some(_)) => self.planner.plan(mesh, views),
            (None, Some(_)) => match self.backend.on_host(geometry)? {
                Cow::Borrowed(mesh) => self.planner.plan(mesh, views),
                Cow::Owned(mesh) => {
                    let plan = self.planner.plan(&mesh, views);
                    self.surveyed = Some(mesh);
                    plan
                }
            },
        };
        self.planning = if plan.is_plain() {
            Duration::ZERO
        } else {
            begin.elapsed()
        };
        Ok(plan)
    }

    /// Records or runs what a plan needs. Returns how the trees are updated.
    pub(crate) fn record_planned(
        &mut self,
        recording: &mut B::Recording,
        geometry: B::Geometry<'_>,
        plan: &Plan,
        change: Change,
    ) -> Result<Action, B::Error> {
        let action = self.next_action(self.seen(geometry, change));
        self.counts = None;
        let updated = self.try_record(recording, geometry, plan, (change, action));
        match updated {
            Ok(_) => self.counts = Some(B::counts(geometry)),
            Err(_) => self.forget(),
        }
        updated
    }

    fn try_record(
        &mut self,
        recording: &mut B::Recording,
        geometry: B::Geometry<'_>,
        plan: &Plan,
        (change, action): (Change, Action),
    ) -> Result<Action, B::Error> {
        let load = Load {
            change,
            topology: plan.topology.as_deref(),
            may_turn_away: plan.may_turn_away,
        };
        (self.backend).load(&mut self.held, &self.builder, geometry, &load)?;
        let mut work = Work {
            recording,
            builder: &mut self.builder,
            held: &mut self.held,
            geometry,
            memory: self.config.set_memory,
        };
        self.hierarchies.update(&mut work, plan, action)
    }

    /// Measures the cost of the tree for all rays after a change, if the settings ask for it and it needs no wait.
    pub(crate) fn measure_cost(
        &mut self,
        recording: &mut B::Recording,
        plan: &Plan,
        action: Action,
    ) -> Option<f64> {
        if plan.is_plain() && action != Action::Kept && self.config.finds_cost {
            let whole = self.hierarchies.whole();
            self.sah_cost = whole.and_then(|bvh| B::sah_cost(recording, bvh));
            if let Some(cost) = self.sah_cost {
                self.upkeep.measured(cost);
            }
        }
        self.sah_cost.filter(|_| plan.is_plain())
    }

    /// How the trees are to be updated now.
    fn next_action(&mut self, change: Change) -> Action {
        if change == Change::Scene {
            self.upkeep = Upkeep::new(self.config.update);
        }
        self.upkeep.next(change != Change::View)
    }

    /// Makes the next update take the geometry for another one and build all trees: for a frame that was recorded but is not
    /// submitted.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, ViewSets, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mut mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
    /// # let targets = [ViewTarget::other_rays()];
    /// # let mut views = ViewSets::new(Cpu, FrameConfig::default());
    /// views.update(&mesh, &targets, Change::Scene)?;
    /// mesh.vertices[0] = [0.0, 9.0, 0.0];
    /// views.forget();
    /// // The trees are built anew, whatever the caller says.
    /// views.update(&mesh, &targets, Change::View)?;
    /// assert_eq!(views.trees()[0].bvh.bounds(), mesh.bounds());
    /// # Ok(())
    /// # }
    /// ```
    pub fn forget(&mut self) {
        self.counts = None;
        self.upkeep = Upkeep::new(self.config.update);
    }

    /// The tree of each target, in the order of the list. The tree of [`ViewTarget::other_rays`] holds all triangles. Empty
    /// before the first update.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, Ray, ViewSets, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
    /// # let mut views = ViewSets::new(Cpu, FrameConfig::default());
    /// let (ear, voice) = ([0.0, 0.0, 4.0], [0.5, 0.0, 3.0]);
    /// let targets = [ViewTarget::rays_from(ear, 0.0)?, ViewTarget::rays_to(voice, 0.0)?];
    /// views.update(&mesh, &targets, Change::Scene)?;
    /// let trees = views.trees();
    /// assert!(trees[0].closest_hit(Ray::new(ear, [0.0, 0.0, -1.0])).is_hit());
    /// assert!(!trees[1].any_hit(Ray::between(ear, voice)));
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn trees(&self) -> Vec<TreeOf<'_, B>> {
        let plan = self.plan.as_ref();
        plan.map_or_else(Vec::new, |plan| self.trees_of(plan))
    }

    /// The trees of a plan without deferred ones, once they are built.
    pub(crate) fn trees_of<'a>(&'a self, plan: &'a Plan) -> Vec<TreeOf<'a, B>> {
        self.hierarchies.trees(&self.held, plan)
    }

    /// The latest plan: what each tree leaves out, why, and what that is expected to save. `None` before the first update.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, ViewSets, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
    /// # let mut views = ViewSets::new(Cpu, FrameConfig::default().reducing());
    /// views.update(&mesh, &[ViewTarget::rays_from([0.0, 0.0, 4.0], 0.0)?], Change::Scene)?;
    /// let plan = views.plan().ok_or("no update")?;
    /// for set in &plan.sets {
    ///     println!("{} keeps {:.0} %", set.name(), 100.0 * set.share);
    ///     # assert!(set.share < 1.0);
    /// }
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn plan(&self) -> Option<&Plan> {
        self.plan.as_ref()
    }

    pub(crate) fn keep_plan(&mut self, plan: Plan) {
        self.plan = Some(plan);
    }

    /// The latest plan in words, a decision a line.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, ViewSets, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
    /// # let mut views = ViewSets::new(Cpu, FrameConfig::default().reducing());
    /// let lidar = ViewTarget::rays_from([0.0, 0.0, 4.0], 0.1)?.named("lidar");
    /// views.update(&mesh, &[lidar], Change::Scene)?;
    /// println!("{}", views.explain());
    /// # assert!(views.explain().contains("lidar"));
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn explain(&self) -> String {
        let plan = self.plan.as_ref();
        plan.map_or_else(|| "nothing was built yet".to_owned(), Plan::to_string)
    }

    /// The latest survey of the surfaces; `None` if it was not likely to pay.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, ViewSets, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
    /// # let targets = [ViewTarget::rays_from([0.0, 0.0, 4.0], 0.0)?];
    /// let mut views = ViewSets::new(Cpu, FrameConfig::default().reducing());
    /// views.update(&mesh, &targets, Change::Scene)?;
    /// let survey = views.survey().ok_or("nothing was surveyed")?;
    /// assert_eq!(survey.topology.component_count(), 1);
    /// println!("{}", survey.stages);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn survey(&self) -> Option<&Survey> {
        self.planner.surveyed()
    }

    /// The time of the latest plan; zero if nothing is left out.
    pub(crate) fn planning(&self) -> Duration {
        self.planning
    }

    /// The trees built so far.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, ViewSets, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
    /// # let targets = [ViewTarget::rays_from([0.0, 0.0, 4.0], 0.0)?];
    /// # let mut views = ViewSets::new(Cpu, FrameConfig::default().reducing());
    /// # views.update(&mesh, &targets, Change::Scene)?;
    /// let plan = views.plan().ok_or("no update")?;
    /// for (set, bvh) in views.hierarchies().sets(plan) {
    ///     println!("{}: {} nodes", set.name(), bvh.node_count());
    ///     # assert!(bvh.node_count() > 0);
    /// }
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn hierarchies(&self) -> &Hierarchies<B> {
        &self.hierarchies
    }

    /// The sizes of the trees. Waits for a GPU.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, ViewSets, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
    /// # let mut views = ViewSets::new(Cpu, FrameConfig::default());
    /// views.update(&mesh, &[ViewTarget::other_rays()], Change::Scene)?;
    /// let total = views.sizes()?.total;
    /// assert_eq!(total.triangle_count, mesh.indices.len());
    /// println!("{} bytes", total.node_bytes + total.triangle_bytes);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// If the device was lost.
    pub fn sizes(&self) -> Result<FrameSizes, B::Error> {
        match &self.plan {
            Some(plan) => self.sizes_of(plan),
            None => Ok(FrameSizes::default()),
        }
    }

    /// The sizes of a plan's trees without deferred ones.
    pub(crate) fn sizes_of(&self, plan: &Plan) -> Result<FrameSizes, B::Error> {
        let mut sizes = FrameSizes::default();
        if let Some(whole) = self.hierarchies.whole().filter(|_| plan.needs_whole) {
            sizes.total.add(&self.backend.size(whole)?);
        }
        for (set, bvh) in self.hierarchies.sets(plan) {
            let size: TreeSize = self.backend.size(bvh)?;
            sizes.total.add(&size);
            sizes.sets.push(SetSize::new(set.name(), &size));
        }
        Ok(sizes)
    }

    /// Bytes of memory held for trees.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, ViewSets, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
    /// # let targets = [ViewTarget::other_rays()];
    /// # let mut views = ViewSets::new(Cpu, FrameConfig::default());
    /// views.update(&mesh, &targets, Change::Scene)?;
    /// let held = views.held_bytes();
    /// // The next update reuses that memory.
    /// views.update(&mesh, &targets, Change::Vertices)?;
    /// assert_eq!(views.held_bytes(), held);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn held_bytes(&self) -> usize {
        self.hierarchies.held_bytes()
    }
}

impl ViewSets<Cpu> {
    /// Updates the trees to a mesh and targets. `change` says what changed since the update before; the first builds all.
    /// Returns the time of each stage.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, ViewSets, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mut mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
    /// # let targets = [ViewTarget::rays_from([0.0, 0.0, 4.0], 0.0)?];
    /// # let mut views = ViewSets::new(Cpu, FrameConfig::for_frames(1000));
    /// views.update(&mesh, &targets, Change::Scene)?;
    /// mesh.vertices.iter_mut().for_each(|vertex| vertex[1] += 0.5);
    /// let stages = views.update(&mesh, &targets, Change::Vertices)?;
    /// println!("{stages}");
    /// # assert_eq!(views.trees()[0].bvh.bounds(), mesh.bounds());
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// For an invalid mesh.
    pub fn update(
        &mut self,
        mesh: &Mesh,
        targets: &[ViewTarget],
        change: Change,
    ) -> Result<Stages, CpuError> {
        let mut stages = Stages::default();
        self.record(&mut stages, mesh, &targets.into(), change)?;
        if !self.planning.is_zero() {
            stages.add("plan", self.planning);
        }
        Ok(stages)
    }
}

#[cfg(feature = "gpu")]
impl<'g> ViewSets<&'g Gpu> {
    /// Records that the trees are updated to a mesh and targets: a [`crate::Mesh`] on the host, of which a copy is kept on the
    /// GPU, or a [`crate::gpu::Mesh`] over the caller's buffers, alone or with the same mesh on the host. `change` says what
    /// changed since the update before; the first builds all.
    ///
    /// Nothing waits for the GPU, with one exception: if a survey is likely to pay, buffers without a mesh on the host are read
    /// back once. The device may be polled, so that callbacks of the caller's may run.
    ///
    /// Take the trees and their bindings anew after each update: their buffers may be others.
    ///
    /// ```no_run
    /// use slimbvh::gpu::{self, Gpu, GpuError, Query, wgpu};
    /// use slimbvh::{Change, ViewSets, ViewTarget};
    /// # fn run<'g>(
    /// #     gpu: &'g Gpu, views: &mut ViewSets<&'g Gpu>, mesh: &gpu::Mesh, targets: &[ViewTarget], rays: &wgpu::Buffer,
    /// #     hits: &wgpu::Buffer,
    /// # ) -> Result<(), GpuError> {
    /// let mut frame = gpu.frame();
    /// // The caller's own commands move the vertices.
    /// views.update(&mut frame, mesh, targets, Change::Vertices)?;
    /// views.trees()[0].trace(&mut frame, Query::Closest, rays.slice(..), hits.slice(..))?;
    /// frame.submit()?;
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// If the frame is not submitted, call [`Self::forget`].
    ///
    /// # Errors
    /// For an invalid mesh, sizes above the GPU's limits, and a device that was lost.
    pub fn update<'a>(
        &mut self,
        frame: &mut Frame<'g>,
        geometry: impl Into<Geometry<'a>>,
        targets: &[ViewTarget],
        change: Change,
    ) -> Result<(), GpuError> {
        self.record(frame, geometry.into(), &targets.into(), change)
    }

    /// How the sets fitted into their memory ([`SetMemory`](crate::reduce::SetMemory)) in the latest frame that is known of, some frames
    /// before the present one, as nothing waits. Sets with memory for all triangles are not listed.
    ///
    /// ```no_run
    /// # use slimbvh::{ViewSets, gpu::Gpu};
    /// # fn run(views: &ViewSets<&Gpu>) {
    /// for fit in views.fits().iter().filter(|fit| !fit.fits()) {
    ///     println!("{}: {} triangles, memory for {}", fit.name, fit.triangle_count, fit.limit);
    /// }
    /// # }
    /// ```
    #[must_use]
    pub fn fits(&self) -> Vec<SetFit> {
        let Some(plan) = &self.plan else {
            return Vec::new();
        };
        let fits = self.hierarchies.sets(plan).filter_map(|(set, bvh)| {
            let fit = bvh.latest_fit()?;
            Some(SetFit {
                name: set.name(),
                triangle_count: fit.count,
                limit: fit.limit,
            })
        });
        fits.collect()
    }

    /// Copies the decisions that the GPU made for the latest update, to be read when the frame is done: which components are
    /// closed, and which of their sides face outward for each target. `None` where the host made them: for a mesh on the host
    /// whose vertices did not move.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{self, Gpu, GpuError};
    /// # use slimbvh::{Change, ViewSets, ViewTarget};
    /// # fn run<'g>(
    /// #     gpu: &'g Gpu, views: &mut ViewSets<&'g Gpu>, mesh: &gpu::Mesh, targets: &[ViewTarget],
    /// # ) -> Result<(), GpuError> {
    /// # let mut frame = gpu.frame();
    /// views.update(&mut frame, mesh, targets, Change::Vertices)?;
    /// let decisions = views.decisions_later(&mut frame)?;
    /// frame.submit()?;
    /// if let Some(decisions) = decisions {
    ///     for (about, text) in decisions.read(gpu)?.explain() {
    ///         println!("{about}: {text}");
    ///     }
    /// }
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// If memory is exhausted.
    pub fn decisions_later(
        &self,
        frame: &mut Frame<'g>,
    ) -> Result<Option<DecisionsDownload>, GpuError> {
        let Some(plan) = &self.plan else {
            return Ok(None);
        };
        let sides = self.hierarchies.sides(plan);
        <&Gpu as Backend>::decisions_later(frame, &self.held, &sides)
    }
}
