//! Settings and sizes of view sets.

use crate::BuildConfig;
use crate::animate::Update;
use crate::backend::TreeSize;
use crate::reduce::{PlanConfig, Reduce, Seams, SetMemory, Still};

/// How frames are planned, built and updated.
///
/// ```
/// use slimbvh::{BuildConfig, FrameConfig, NodeCodec, WideStore};
/// // Small trees for a thousand frames.
/// let build = BuildConfig { nodes: NodeCodec::Wide(WideStore::Exact), ..BuildConfig::default() };
/// let config = FrameConfig { build, ..FrameConfig::for_frames(1000) };
/// # assert_eq!(config.build.nodes, NodeCodec::Wide(WideStore::Exact));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FrameConfig {
    /// How trees are built and stored.
    pub build: BuildConfig,
    /// What the trees leave out.
    pub plan: PlanConfig,
    /// How trees are updated from frame to frame.
    pub update: Update,
    /// How much memory sets have on a GPU.
    pub set_memory: SetMemory,
    /// Whether each change of the trees is followed by the cost of the tree for all rays, if that needs no wait. Trees
    /// whose cost has grown are rebuilt; without the cost, every eighth update rebuilds.
    pub finds_cost: bool,
}

impl FrameConfig {
    /// For about this many frames that share a survey of the surfaces. Trees are kept while nothing moves.
    ///
    /// ```
    /// use slimbvh::{Cpu, FrameConfig, ViewSets};
    /// let config = FrameConfig::for_frames(1000).promising_solids();
    /// let views = ViewSets::new(Cpu, config);
    /// # assert!(views.trees().is_empty());
    /// ```
    #[must_use]
    pub fn for_frames(frame_count: u32) -> Self {
        let still = Still {
            vertices: true,
            lights: false,
        };
        Self {
            plan: PlanConfig {
                frame_count,
                still: Some(still),
                ..PlanConfig::default()
            },
            finds_cost: true,
            ..Self::default()
        }
    }

    /// The same with the caller's promise that no closed part of the mesh intersects itself or is inside out in places, now or
    /// when vertices move. Then no search for such places is made, and sets are kept up while vertices move; without it, nothing
    /// is left out once vertices have moved.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, ViewSets, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mut mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
    /// # let targets = [ViewTarget::rays_from([0.0, 0.0, 4.0], 0.0)?];
    /// let config = FrameConfig::for_frames(1000).promising_solids().reducing();
    /// let mut views = ViewSets::new(Cpu, config);
    /// views.update(&mesh, &targets, Change::Scene)?;
    /// mesh.vertices[0][1] *= 1.5;
    /// views.update(&mesh, &targets, Change::Vertices)?;
    /// // The far side is still left out.
    /// assert!(views.trees()[0].bvh.triangle_count() < mesh.indices.len());
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn promising_solids(mut self) -> Self {
        self.plan.switches.seams = Seams::None;
        self
    }

    /// What view sets with these settings ask of a GPU, for [`crate::gpu::Gpu::warm_up`]: builds and refits of meshes in any layout, sets,
    /// and the GPU's decisions. Queries are added to it.
    ///
    /// ```no_run
    /// use slimbvh::FrameConfig;
    /// use slimbvh::gpu::{Gpu, GpuError, Query};
    /// # fn run(gpu: &Gpu, config: &FrameConfig) -> Result<(), GpuError> {
    /// gpu.warm_up(&config.warm_up().with_queries(&[Query::Closest, Query::Any]).with_ends())?;
    /// # Ok(())
    /// # }
    /// ```
    #[cfg(feature = "gpu")]
    pub const fn warm_up(&self) -> crate::gpu::WarmUp<'static> {
        let uses = crate::gpu::WarmUp::new(self.build);
        let uses = uses.with_layouts().with_refits();
        match self.plan.switches.reduce {
            Reduce::Off => uses,
            Reduce::Auto | Reduce::On => uses.with_decisions(),
        }
    }

    /// The same with sets for all targets that allow one, even where none pays.
    ///
    /// ```
    /// # use slimbvh::{Change, Cpu, FrameConfig, ViewSets, ViewTarget};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
    /// # let targets = [ViewTarget::rays_from([0.0, 0.0, 4.0], 0.0)?];
    /// // A sphere so small that its set would not pay.
    /// let mut views = ViewSets::new(Cpu, FrameConfig::default().reducing());
    /// views.update(&mesh, &targets, Change::Scene)?;
    /// assert!(views.trees()[0].bvh.triangle_count() < mesh.indices.len());
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn reducing(mut self) -> Self {
        self.plan.switches.reduce = Reduce::On;
        self
    }
}

/// The sizes of a frame's trees.
///
/// ```
/// # use slimbvh::{Change, Cpu, FrameConfig, ViewSets, ViewTarget};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// # let mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
/// # let mut views = ViewSets::new(Cpu, FrameConfig::default().reducing());
/// let targets = [ViewTarget::rays_from([0.0, 0.0, 4.0], 0.0)?, ViewTarget::other_rays()];
/// views.update(&mesh, &targets, Change::Scene)?;
/// let sizes = views.sizes()?;
/// // The whole tree and a set exist at the same time.
/// assert_eq!(sizes.total.triangle_count, mesh.indices.len() + sizes.sets[0].triangle_count);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FrameSizes {
    /// The sum of all trees that exist at the same time.
    pub total: TreeSize,
    /// Each set.
    pub sets: Vec<SetSize>,
}

/// The size of a set.
///
/// ```
/// # use slimbvh::{Change, Cpu, FrameConfig, ViewSets, ViewTarget};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// # let mesh = slimbvh::generate::icosphere(slimbvh_core::Vec3::ZERO, 1.0, 2);
/// # let mut views = ViewSets::new(Cpu, FrameConfig::default().reducing());
/// # views.update(&mesh, &[ViewTarget::rays_from([0.0, 0.0, 4.0], 0.0)?], Change::Scene)?;
/// for set in views.sizes()?.sets {
///     println!("{}: {} of {} triangles", set.name, set.triangle_count, mesh.indices.len());
///     # assert!(set.fits);
/// }
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SetSize {
    /// The names of its targets.
    pub name: String,
    /// Its triangles.
    pub triangle_count: usize,
    /// Whether it fitted into its memory ([`SetMemory`]). Else its rays went through the whole tree.
    pub fits: bool,
}

impl SetSize {
    pub(crate) fn new(name: String, size: &TreeSize) -> Self {
        Self {
            name,
            triangle_count: size.triangle_count.max(size.unfit_count),
            fits: size.unfit_count == 0,
        }
    }
}
