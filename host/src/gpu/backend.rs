//! The GPU's passes as a [`Backend`].

use super::bvh::Bvh;
use super::render::{Image, check_view};
use super::{
    Answer, Builder, Components, Decisions, DecisionsDownload, DecisionsReport, Download, Frame,
    Gpu, GpuError, Mesh, Misfit, Renderer, Scene, Subset, TargetSides,
};
use crate::backend::{
    self, Backend, Change, DeferredTrees, Load, Output, SetNeed, Shot, Source, TargetSet, TreeSize,
};
use crate::{BuildConfig, RenderReport, RenderSettings, Stages, ViewError};
use std::borrow::Cow;

/// Which triangles form the sets of lights.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LightSets {
    /// The triangles that face the light (L+).
    #[default]
    Facing,
    /// The smaller of L+ and L−, the triangles that face away. L− requires that the eye is outside of every component that
    /// the light is outside of, and that nothing is transparent.
    Smaller,
}

/// The caller's geometry: a mesh on the host, of which a copy is kept on the GPU, or buffers on the GPU.
#[derive(Clone, Copy, Debug)]
pub enum Geometry<'a> {
    /// On the host.
    Host(&'a crate::Mesh),
    /// On the GPU.
    Buffers {
        /// The buffers.
        mesh: &'a Mesh,
        /// The same triangles on the host, vertices at rest or anywhere, so that a survey of the surfaces need not read the
        /// buffers back.
        rest: Option<&'a crate::Mesh>,
    },
}

impl<'a> From<&'a crate::Mesh> for Geometry<'a> {
    fn from(mesh: &'a crate::Mesh) -> Self {
        Self::Host(mesh)
    }
}

impl<'a> From<&'a Mesh> for Geometry<'a> {
    fn from(mesh: &'a Mesh) -> Self {
        Self::Buffers { mesh, rest: None }
    }
}

impl<'a> From<(&'a Mesh, &'a crate::Mesh)> for Geometry<'a> {
    fn from((mesh, rest): (&'a Mesh, &'a crate::Mesh)) -> Self {
        let rest = Some(rest);
        Self::Buffers { mesh, rest }
    }
}

/// The GPU's copy of geometry and of a picture's scene, kept from frame to frame.
#[derive(Debug, Default)]
pub struct Held {
    mesh: Option<Mesh>,
    /// Whether the mesh is a copy of one on the host.
    is_copy: bool,
    scene: Option<Scene>,
    components: Option<Components>,
    /// Decides sides once vertices have moved.
    decisions: Option<Decisions>,
    lights: LightSets,
}

impl Held {
    /// Whether it is a copy of a mesh with these counts.
    fn is_copy_of(&self, mesh: &crate::Mesh) -> bool {
        let held = self.mesh.as_ref().filter(|_| self.is_copy);
        held.is_some_and(|held| held.check_counts(mesh).is_ok())
    }

    /// The mesh.
    ///
    /// # Errors
    /// Before the first [`Backend::load`].
    pub fn mesh(&self) -> Result<&Mesh, GpuError> {
        let mesh = self.mesh.as_ref();
        mesh.ok_or_else(|| Misfit::NotLoaded.of("the mesh"))
    }

    /// Mesh and materials.
    ///
    /// # Errors
    /// Before the first [`Backend::load_picture`].
    pub fn scene(&self) -> Result<&Scene, GpuError> {
        let scene = self.scene.as_ref();
        scene.ok_or_else(|| Misfit::NotLoaded.of("the scene"))
    }
}

impl TargetSet<'_, '_, &Gpu> {
    const fn subset(&self) -> Subset<'_> {
        Subset::Of {
            components: self.components,
            sides: self.sides,
        }
    }
}

impl<'g> Backend for &'g Gpu {
    const NAME: &'static str = "gpu";
    const SORTS_SETS_ALONE: bool = false;
    const KEEPS_ORDER: bool = false;
    const RECORDS: bool = true;

    type Error = GpuError;
    type Recording = Frame<'g>;
    type Geometry<'a> = Geometry<'a>;
    type Held = Held;
    type Bvh = Bvh;
    type Builder = Builder;
    type Renderer = Renderer;
    type TargetSides = TargetSides;
    type Components<'a> = &'a Components;
    type Rule<'a> = (&'a Components, &'a TargetSides);
    type PendingSize = Download;
    type PendingDecisions = DecisionsDownload;
    type Decisions = DecisionsReport;

    fn adapter(self) -> Option<String> {
        Some(self.name().to_owned())
    }

    fn builder(self, config: BuildConfig) -> Builder {
        Builder::new(config)
    }

    fn begin(self) -> Frame<'g> {
        self.frame()
    }

    fn submit(self, frame: Frame<'g>) -> Result<Stages, GpuError> {
        frame.submit()?.wait()
    }

    fn counts(geometry: Geometry) -> [usize; 2] {
        match geometry {
            Geometry::Host(mesh) => [mesh.indices.len(), mesh.vertices.len()],
            Geometry::Buffers { mesh, .. } => mesh.counts().map(|count| count as usize),
        }
    }

    fn is_held(held: &Held, geometry: Geometry) -> bool {
        match geometry {
            Geometry::Host(mesh) => held.is_copy_of(mesh),
            Geometry::Buffers { mesh, .. } => !held.is_copy && held.mesh.as_ref() == Some(mesh),
        }
    }

    fn on_host<'a>(self, geometry: Self::Geometry<'a>) -> Result<Cow<'a, crate::Mesh>, GpuError> {
        match geometry {
            Geometry::Host(mesh) => Ok(Cow::Borrowed(mesh)),
            Geometry::Buffers { mesh, rest: None } => Ok(Cow::Owned(mesh.download(self)?)),
            Geometry::Buffers {
                mesh,
                rest: Some(rest),
            } => {
                mesh.check_counts(rest)?;
                Ok(Cow::Borrowed(rest))
            }
        }
    }

    fn load(
        self,
        held: &mut Held,
        builder: &Builder,
        geometry: Geometry,
        load: &Load,
    ) -> Result<(), GpuError> {
        let is_other = load.change == Change::Scene || !Self::is_held(held, geometry);
        match geometry {
            Geometry::Host(mesh) if is_other => {
                *held = Held::default();
                builder.check_mesh(mesh)?;
                builder.check(self, mesh.indices.len() as u32)?;
                held.mesh = Some(Mesh::upload(self, mesh)?);
                held.is_copy = true;
            }
            Geometry::Host(mesh) if load.change == Change::Vertices => {
                builder.check_mesh(mesh)?;
                self.checked(|| {
                    held.mesh()?.move_vertices(self, mesh);
                    Ok(())
                })?;
            }
            Geometry::Buffers { mesh, .. } if is_other => {
                *held = Held::default();
                builder.check(self, mesh.triangle_count())?;
                held.mesh = Some(mesh.clone());
            }
            Geometry::Host(_) | Geometry::Buffers { .. } => {}
        }
        held.lights = if load.may_turn_away {
            LightSets::Smaller
        } else {
            LightSets::Facing
        };
        let Some(topology) = load.topology else {
            return Ok(());
        };
        // Only the GPU knows where the vertices in buffers are.
        let has_moved = load.change == Change::Vertices || !held.is_copy;
        if has_moved && held.decisions.is_none() {
            let decisions = Decisions::new(self, topology)?;
            held.components = Some(decisions.components().clone());
            held.decisions = Some(decisions);
        }
        if held.components.is_none() {
            held.components = Some(Components::upload(self, topology.components())?);
        }
        Ok(())
    }

    fn check_picture(
        self,
        scene: &crate::Scene,
        settings: &RenderSettings,
    ) -> Result<(), GpuError> {
        check_view(self, scene, settings).map(|_| ())
    }

    fn load_picture(
        self,
        held: &mut Held,
        scene: &crate::Scene,
        change: Change,
    ) -> Result<(), GpuError> {
        match (&held.scene, change) {
            (None, _) | (_, Change::Scene) => {
                held.scene = Some(Scene::over(self, held.mesh()?.clone(), scene)?);
            }
            (Some(uploaded), Change::Vertices) => uploaded.move_normals(self, &scene.mesh),
            (Some(_), Change::View) => {}
        }
        Ok(())
    }

    fn components<'a>(held: &'a Held, host: Option<&'a [u32]>) -> Option<&'a Components> {
        host.and(held.components.as_ref())
    }

    fn sort(
        frame: &mut Frame<'g>,
        builder: &mut Builder,
        source: Source<Self>,
    ) -> Result<(), GpuError> {
        builder.sort(frame, source.held.mesh()?)
    }

    fn follow(
        frame: &mut Frame<'g>,
        builder: &mut Builder,
        source: Source<Self>,
    ) -> Result<(), GpuError> {
        Self::sort(frame, builder, source)
    }

    fn refit(
        frame: &mut Frame<'g>,
        builder: &mut Builder,
        source: Source<Self>,
        bvh: &mut Bvh,
    ) -> Result<(), GpuError> {
        builder.refit(frame, source.held.mesh()?, bvh)
    }

    fn lay_out(
        frame: &mut Frame<'g>,
        builder: &mut Builder,
        source: Source<Self>,
        whole: &mut Bvh,
        sets: &mut [(&mut Bvh, SetNeed)],
    ) -> Result<bool, GpuError> {
        builder.lay_out(frame.gpu(), source.held.mesh()?, whole, sets)
    }

    fn can_refit(builder: &Builder, bvh: &Bvh) -> bool {
        builder.can_refit(bvh)
    }

    fn build_sorted(
        frame: &mut Frame<'g>,
        builder: &mut Builder,
        source: Source<Self>,
        set: Option<&TargetSet<Self>>,
        bvh: &mut Bvh,
    ) -> Result<(), GpuError> {
        let subset = set.map_or(Subset::All, TargetSet::subset);
        builder.build_sorted(frame, source.held.mesh()?, subset, bvh)
    }

    fn build_alone(
        frame: &mut Frame<'g>,
        builder: &mut Builder,
        source: Source<Self>,
        set: &TargetSet<Self>,
        bvh: &mut Bvh,
    ) -> Result<(), GpuError> {
        Self::sort(frame, builder, source)?;
        Self::build_sorted(frame, builder, source, Some(set), bvh)
    }

    fn reserve(
        frame: &mut Frame<'g>,
        builder: &mut Builder,
        source: Source<Self>,
        bvh: &mut Bvh,
    ) -> Result<(), GpuError> {
        builder.reserve(frame.gpu(), source.held.mesh()?, bvh)
    }

    fn build_deferred(
        frame: &mut Frame<'g>,
        builder: &mut Builder,
        source: Source<Self>,
        set: &TargetSet<Self>,
        bvh: &mut Bvh,
    ) -> Result<(), GpuError> {
        builder.build_reserved(frame, source.held.mesh()?, set.subset(), bvh)
    }

    fn divide(
        frame: &mut Frame<'g>,
        builder: &mut Builder,
        source: Source<Self>,
        set: &TargetSet<Self>,
        spare: &mut Bvh,
    ) -> Result<(), GpuError> {
        Self::build_alone(frame, builder, source, set, spare)
    }

    fn decides(held: &Held) -> bool {
        held.decisions.is_some()
    }

    fn must_measure(held: &Held) -> bool {
        let decisions = held.decisions.as_ref();
        decisions.is_some_and(|decisions| decisions.mesh.is_none())
    }

    fn measure(frame: &mut Frame<'g>, builder: &Builder, held: &mut Held) -> Result<(), GpuError> {
        match (&held.mesh, &mut held.decisions) {
            (Some(mesh), Some(decisions)) => decisions.measure(frame, builder, mesh),
            _ => Ok(()),
        }
    }

    fn set_sides(
        frame: &mut Frame<'g>,
        held: &Held,
        host: &backend::TargetSides,
        eye: Option<&TargetSides>,
        to: &mut TargetSides,
    ) -> Result<(), GpuError> {
        let Some(decisions) = &held.decisions else {
            let components = held.components.as_ref();
            let components = components.ok_or_else(|| Misfit::NotLoaded.of("the scene"))?;
            let target = (&host.target, &host.frustum);
            return to.set(frame, components, target, &host.sides);
        };
        let answer = match (held.lights, eye) {
            (LightSets::Smaller, Some(eye)) => Answer::Smaller { eye },
            _ => Answer::Facing,
        };
        to.decide(frame, decisions, (&host.target, &host.frustum), answer)
    }

    fn decisions_later(
        frame: &mut Frame<'g>,
        held: &Held,
        targets: &[(String, &TargetSides)],
    ) -> Result<Option<DecisionsDownload>, GpuError> {
        let Some(decisions) = &held.decisions else {
            return Ok(None);
        };
        DecisionsDownload::record(frame, decisions, targets).map(Some)
    }

    fn decisions(self, pending: DecisionsDownload) -> Result<DecisionsReport, GpuError> {
        pending.read(self)
    }

    fn explain(decisions: &DecisionsReport) -> Vec<(String, String)> {
        decisions.explain()
    }

    fn rule<'a>(
        components: &'a Components,
        sides: &'a TargetSides,
    ) -> (&'a Components, &'a TargetSides) {
        (components, sides)
    }

    /// With a progress callback, each wave of samples is its own submission, and the call waits for it. Otherwise the frame
    /// is one submission; so it always is with deferred trees.
    fn render(
        self,
        mut frame: Frame<'g>,
        renderer: &mut Renderer,
        shot: &Shot<Self>,
        deferred: Option<&mut dyn DeferredTrees<Self>>,
        output: Output,
    ) -> Result<(Stages, RenderReport), GpuError> {
        let camera = shot.scene.cameras.first().ok_or(ViewError::NoCamera)?;
        let view = (camera, shot.scene.lights.as_slice());
        let scene = shot.held.scene()?;
        let Output { picture, progress } = output;
        match (deferred, progress) {
            (None, Some(progress)) => {
                let image = Image {
                    uploaded: scene,
                    trees: shot.trees,
                    view,
                    settings: shot.settings,
                    begin: shot.begin,
                };
                image.render(renderer, frame, picture, progress)
            }
            (deferred, progress) => {
                match deferred {
                    None => {
                        renderer.render_with(&mut frame, scene, shot.trees, view, shot.settings)?;
                    }
                    Some(deferred) => {
                        let trees = (shot.trees, deferred);
                        renderer.render_deferred(&mut frame, scene, trees, view, shot.settings)?;
                    }
                }
                let times = renderer.finish(frame, Stages::default(), shot.begin, picture)?;
                if let Some(progress) = progress {
                    progress(1.0);
                }
                Ok(times)
            }
        }
    }

    fn sah_cost(_: &mut Frame<'g>, _: &Bvh) -> Option<f64> {
        None
    }

    fn size_later(frame: &mut Frame<'g>, bvh: &Bvh) -> Result<Download, GpuError> {
        bvh.count_later(frame)
    }

    fn pending_size(self, pending: Download) -> Result<TreeSize, GpuError> {
        let words: Vec<u32> = pending.read(self)?;
        Ok(TreeSize {
            triangle_count: words.first().copied().unwrap_or(0) as usize,
            ..TreeSize::default()
        })
    }

    fn size(self, bvh: &Bvh) -> Result<TreeSize, GpuError> {
        let (counts, bytes) = match bvh.read_size(self) {
            Ok(size) => size,
            Err(GpuError::Unfit {
                fault: Misfit::DoesNotFit { count, .. },
                ..
            }) => {
                return Ok(TreeSize {
                    unfit_count: count as usize,
                    ..TreeSize::default()
                });
            }
            Err(error) => return Err(error),
        };
        let [node_bytes, triangle_bytes] = bytes.map(|bytes| bytes as usize);
        Ok(TreeSize {
            node_count: counts.nodes as usize,
            triangle_count: counts.triangles as usize,
            node_bytes,
            triangle_bytes,
            unfit_count: 0,
        })
    }

    fn held_bytes(bvh: &Bvh) -> usize {
        bvh.bytes() as usize
    }

    fn scratch_bytes(builder: &Builder, renderer: &Renderer) -> usize {
        (builder.scratch_bytes() + renderer.scratch_bytes()) as usize
    }
}
