//! The CPU's passes as a [`Backend`].

use super::{Builder, Renderer, Subset};
use crate::backend::{
    Backend, Change, DeferredTrees, Load, Output, Shot, Source, TargetSet, TargetSides, TreeSize,
};
use crate::{
    BuildConfig, Bvh, Mesh, MeshError, RefitError, RenderReport, RenderSettings, Scene, Stages,
    ViewError,
};
use slimbvh_core::classify::{Sides, VisibleSet};
use slimbvh_core::orientation::Target;
use std::borrow::Cow;
use std::convert::Infallible;
use thiserror::Error;

/// This machine's cores: the threads of the current rayon pool, or the calling thread without feature `parallel`.
#[derive(Clone, Copy, Debug, Default)]
pub struct Cpu;

/// Why the CPU cannot make a frame.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum CpuError {
    /// The mesh is unfit.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The trees cannot be moved to this mesh.
    #[error(transparent)]
    Refit(#[from] RefitError),
    /// The camera or a light is unfit.
    #[error(transparent)]
    View(#[from] ViewError),
}

impl TargetSet<'_, '_, Cpu> {
    fn reach(&self) -> VisibleSet<'_> {
        VisibleSet {
            sides: Sides {
                components: self.components,
                sides: &self.sides.sides,
            },
            target: self.sides.target,
            frustum: self.sides.frustum,
        }
    }
}

impl Backend for Cpu {
    const NAME: &'static str = "cpu";
    const SORTS_SETS_ALONE: bool = true;
    const KEEPS_ORDER: bool = true;
    const RECORDS: bool = false;

    type Error = CpuError;
    type Recording = Stages;
    type Geometry<'a> = &'a Mesh;
    type Held = ();
    type Bvh = Bvh;
    type Builder = Builder;
    type Renderer = Renderer;
    type TargetSides = TargetSides;
    type Components<'a> = &'a [u32];
    type Rule<'a> = (Sides<'a>, Target);
    type PendingSize = TreeSize;
    type PendingDecisions = Infallible;
    type Decisions = Infallible;

    fn adapter(self) -> Option<String> {
        None
    }

    fn builder(self, config: BuildConfig) -> Builder {
        Builder::new(config)
    }

    fn begin(self) -> Stages {
        Stages::default()
    }

    fn submit(self, stages: Stages) -> Result<Stages, CpuError> {
        Ok(stages)
    }

    fn counts(mesh: &Mesh) -> [usize; 2] {
        [mesh.indices.len(), mesh.vertices.len()]
    }

    fn is_held((): &(), _: &Mesh) -> bool {
        true
    }

    fn on_host<'a>(self, mesh: Self::Geometry<'a>) -> Result<Cow<'a, Mesh>, CpuError> {
        Ok(Cow::Borrowed(mesh))
    }

    fn load(self, (): &mut (), _: &Builder, _: &Mesh, _: &Load) -> Result<(), CpuError> {
        Ok(())
    }

    fn check_picture(self, _: &Scene, _: &RenderSettings) -> Result<(), CpuError> {
        Ok(())
    }

    fn load_picture(self, (): &mut (), _: &Scene, _: Change) -> Result<(), CpuError> {
        Ok(())
    }

    fn components<'a>((): &'a (), host: Option<&'a [u32]>) -> Option<&'a [u32]> {
        host
    }

    fn sort(
        stages: &mut Stages,
        builder: &mut Builder,
        source: Source<Self>,
    ) -> Result<(), CpuError> {
        stages.merge(&builder.sort(source.geometry)?);
        Ok(())
    }

    fn follow(
        stages: &mut Stages,
        builder: &mut Builder,
        source: Source<Self>,
    ) -> Result<(), CpuError> {
        stages.merge(&builder.follow(source.geometry)?);
        Ok(())
    }

    fn refit(
        stages: &mut Stages,
        builder: &mut Builder,
        source: Source<Self>,
        bvh: &mut Bvh,
    ) -> Result<(), CpuError> {
        stages.merge(&builder.refit(source.geometry, bvh)?);
        Ok(())
    }

    fn can_refit(_: &Builder, _: &Bvh) -> bool {
        true
    }

    fn build_sorted(
        stages: &mut Stages,
        builder: &mut Builder,
        source: Source<Self>,
        set: Option<&TargetSet<Self>>,
        bvh: &mut Bvh,
    ) -> Result<(), CpuError> {
        let subset = set.map_or(Subset::All, |set| Subset::Of(set.reach()));
        stages.merge(&builder.build_sorted(source.geometry, subset, bvh));
        Ok(())
    }

    fn build_alone(
        stages: &mut Stages,
        builder: &mut Builder,
        source: Source<Self>,
        set: &TargetSet<Self>,
        bvh: &mut Bvh,
    ) -> Result<(), CpuError> {
        let subset = Subset::Of(set.reach());
        stages.merge(&builder.build_subset(source.geometry, subset, bvh)?);
        Ok(())
    }

    fn reserve(
        _: &mut Stages,
        _: &mut Builder,
        _: Source<Self>,
        _: &mut Bvh,
    ) -> Result<(), CpuError> {
        Ok(())
    }

    fn build_deferred(
        stages: &mut Stages,
        builder: &mut Builder,
        source: Source<Self>,
        set: &TargetSet<Self>,
        bvh: &mut Bvh,
    ) -> Result<(), CpuError> {
        Self::build_sorted(stages, builder, source, Some(set), bvh)
    }

    fn divide(
        stages: &mut Stages,
        builder: &mut Builder,
        source: Source<Self>,
        set: &TargetSet<Self>,
        _: &mut Bvh,
    ) -> Result<(), CpuError> {
        stages.merge(&builder.divide(source.geometry, &set.reach()));
        Ok(())
    }

    fn decides((): &()) -> bool {
        false
    }

    fn must_measure((): &()) -> bool {
        false
    }

    fn measure(_: &mut Stages, _: &Builder, (): &mut ()) -> Result<(), CpuError> {
        Ok(())
    }

    fn set_sides(
        _: &mut Stages,
        (): &(),
        host: &TargetSides,
        _: Option<&TargetSides>,
        to: &mut TargetSides,
    ) -> Result<(), CpuError> {
        to.clone_from(host);
        Ok(())
    }

    fn decisions_later(
        _: &mut Stages,
        (): &(),
        _: &[(String, &TargetSides)],
    ) -> Result<Option<Infallible>, CpuError> {
        Ok(None)
    }

    fn decisions(self, pending: Infallible) -> Result<Infallible, CpuError> {
        Ok(pending)
    }

    fn explain(decisions: &Infallible) -> Vec<(String, String)> {
        match *decisions {}
    }

    fn rule<'a>(components: &'a [u32], sides: &'a TargetSides) -> (Sides<'a>, Target) {
        let rule = Sides {
            components,
            sides: &sides.sides,
        };
        (rule, sides.target)
    }

    fn render(
        self,
        mut stages: Stages,
        renderer: &mut Renderer,
        shot: &Shot<Self>,
        deferred: Option<&mut dyn DeferredTrees<Self>>,
        output: Output,
    ) -> Result<(Stages, RenderReport), CpuError> {
        let report = match deferred {
            Some(trees) => renderer.render_shot(shot, Some((trees, &mut stages)), output)?,
            None => renderer.render_shot(shot, None, output)?,
        };
        Ok((stages, report))
    }

    fn sah_cost(stages: &mut Stages, bvh: &Bvh) -> Option<f64> {
        Some(stages.time("quality", || bvh.sah_cost()))
    }

    fn size_later(_: &mut Stages, bvh: &Bvh) -> Result<TreeSize, CpuError> {
        Self.size(bvh)
    }

    fn pending_size(self, pending: TreeSize) -> Result<TreeSize, CpuError> {
        Ok(pending)
    }

    fn size(self, bvh: &Bvh) -> Result<TreeSize, CpuError> {
        Ok(TreeSize {
            unfit_count: 0,
            node_count: bvh.node_count(),
            triangle_count: bvh.triangle_count(),
            node_bytes: bvh.node_bytes(),
            triangle_bytes: bvh.triangle_bytes(),
        })
    }

    fn held_bytes(bvh: &Bvh) -> usize {
        bvh.held_bytes()
    }

    fn scratch_bytes(builder: &Builder, renderer: &Renderer) -> usize {
        builder.scratch_bytes() + renderer.scratch_bytes()
    }
}
