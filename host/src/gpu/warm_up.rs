//! Kernels compiled before the first frame.

use super::buffer::upload;
use super::{
    Answer, Builder, Bvh, Components, Decisions, Frame, Gpu, GpuError, IndexLayout, Mesh, Query,
    Rays, Renderer, Scene, Subset, TargetSides, Tree, Trees, VertexLayout,
};
use crate::backend::SetNeed;
use crate::topology::Topology;
use crate::{BuildConfig, Camera, Light, Material, Projection, RenderSettings, Stages};
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;
use slimbvh_core::{Hit, Ray, RayEnds};
use wgpu::BufferUsages;

/// What a program will ask of the GPU. [`Gpu::warm_up`] compiles the kernels for that.
///
/// ```no_run
/// # use slimbvh::BuildConfig;
/// use slimbvh::gpu::{Gpu, GpuError, Query, WarmUp};
/// # fn run(gpu: &Gpu, config: BuildConfig) -> Result<(), GpuError> {
/// let uses = WarmUp::new(config).with_refits().with_queries(&[Query::Closest, Query::Any]);
/// println!("{}", gpu.warm_up(&uses)?);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
#[must_use]
pub struct WarmUp<'a> {
    build: BuildConfig,
    has_layouts: bool,
    refits: bool,
    sets: Option<Sets>,
    queries: &'a [Query],
    has_ends: bool,
    has_counts: bool,
    picture: Option<RenderSettings>,
}

/// Where the sides of targets come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sets {
    /// From the host.
    Set,
    /// From the GPU's decisions.
    Decided,
}

impl<'a> WarmUp<'a> {
    /// Builds with this configuration.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Gpu, GpuError, WarmUp};
    /// # use slimbvh::{BuildConfig, NodeCodec, WideStore};
    /// # fn run(gpu: &Gpu) -> Result<(), GpuError> {
    /// // Kernels differ by codec.
    /// let nodes = NodeCodec::Wide(WideStore::Full);
    /// gpu.warm_up(&WarmUp::new(BuildConfig { nodes, ..BuildConfig::default() }))?;
    /// # Ok(())
    /// # }
    /// ```
    pub const fn new(build: BuildConfig) -> Self {
        Self {
            build,
            has_layouts: false,
            refits: false,
            sets: None,
            queries: &[],
            has_ends: false,
            has_counts: false,
            picture: None,
        }
    }

    /// Queries of rays whose ends lie on surfaces ([`super::Rays::with_ends`]), too.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Gpu, GpuError, Query, WarmUp};
    /// # fn run(gpu: &Gpu, uses: WarmUp) -> Result<(), GpuError> {
    /// // Shadow rays that leave surfaces.
    /// gpu.warm_up(&uses.with_queries(&[Query::Any]).with_ends())?;
    /// # Ok(())
    /// # }
    /// ```
    pub const fn with_ends(mut self) -> Self {
        self.has_ends = true;
        self
    }

    /// Queries of a number of rays that only the GPU knows ([`super::Rays::counted_by`]), too.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Gpu, GpuError, Query, WarmUp};
    /// # fn run(gpu: &Gpu, uses: WarmUp) -> Result<(), GpuError> {
    /// // Paths, of which fewer go on after each hit.
    /// gpu.warm_up(&uses.with_queries(&[Query::Closest]).with_ends().with_counts())?;
    /// # Ok(())
    /// # }
    /// ```
    pub const fn with_counts(mut self) -> Self {
        self.has_counts = true;
        self
    }

    /// Meshes in the caller's own layout ([`Mesh::from_layout`]), too.
    ///
    /// ```no_run
    /// # use slimbvh::BuildConfig;
    /// # use slimbvh::gpu::{Gpu, GpuError, WarmUp};
    /// # fn run(gpu: &Gpu, config: BuildConfig) -> Result<(), GpuError> {
    /// // Vertices with normals between the positions.
    /// gpu.warm_up(&WarmUp::new(config).with_layouts())?;
    /// # Ok(())
    /// # }
    /// ```
    pub const fn with_layouts(mut self) -> Self {
        self.has_layouts = true;
        self
    }

    /// Refits, too.
    ///
    /// ```no_run
    /// # use slimbvh::BuildConfig;
    /// # use slimbvh::gpu::{Gpu, GpuError, WarmUp};
    /// # fn run(gpu: &Gpu, config: BuildConfig) -> Result<(), GpuError> {
    /// // The second frame refits what the first builds.
    /// gpu.warm_up(&WarmUp::new(config).with_refits())?;
    /// # Ok(())
    /// # }
    /// ```
    pub const fn with_refits(mut self) -> Self {
        self.refits = true;
        self
    }

    /// Builds over sets ([`Subset::Of`]) with the host's sides ([`TargetSides::set`]), and whole trees with a rule, too.
    ///
    /// ```no_run
    /// # use slimbvh::BuildConfig;
    /// # use slimbvh::gpu::{Gpu, GpuError, Query, WarmUp};
    /// # fn run(gpu: &Gpu, config: BuildConfig) -> Result<(), GpuError> {
    /// gpu.warm_up(&WarmUp::new(config).with_sets().with_queries(&[Query::Any]))?;
    /// # Ok(())
    /// # }
    /// ```
    pub const fn with_sets(mut self) -> Self {
        self.sets = Some(Sets::Set);
        self
    }

    /// The same with the GPU's decisions ([`TargetSides::decide`]).
    ///
    /// ```no_run
    /// # use slimbvh::BuildConfig;
    /// # use slimbvh::gpu::{Gpu, GpuError, WarmUp};
    /// # fn run(gpu: &Gpu, config: BuildConfig) -> Result<(), GpuError> {
    /// // Vertices move on the GPU, which then decides what sets leave out.
    /// gpu.warm_up(&WarmUp::new(config).with_layouts().with_decisions())?;
    /// # Ok(())
    /// # }
    /// ```
    pub const fn with_decisions(mut self) -> Self {
        self.sets = Some(Sets::Decided);
        self
    }

    /// These queries, too.
    ///
    /// ```no_run
    /// # use slimbvh::BuildConfig;
    /// # use slimbvh::gpu::{Gpu, GpuError, Query, WarmUp};
    /// # fn run(gpu: &Gpu, config: BuildConfig) -> Result<(), GpuError> {
    /// gpu.warm_up(&WarmUp::new(config).with_queries(&[Query::Closest, Query::Nearest]))?;
    /// # Ok(())
    /// # }
    /// ```
    pub const fn with_queries(mut self, queries: &'a [Query]) -> Self {
        self.queries = queries;
        self
    }

    /// Pictures with these settings, too, their size and number of samples aside.
    ///
    /// ```no_run
    /// # use slimbvh::gpu::{Gpu, GpuError, WarmUp};
    /// # use slimbvh::{BuildConfig, RenderSettings};
    /// # fn run(gpu: &Gpu, config: BuildConfig) -> Result<(), GpuError> {
    /// gpu.warm_up(&WarmUp::new(config).with_picture(RenderSettings::default()))?;
    /// # Ok(())
    /// # }
    /// ```
    pub const fn with_picture(mut self, settings: RenderSettings) -> Self {
        self.picture = Some(settings);
        self
    }

    /// Records all of it, over a small mesh.
    fn record(&self, frame: &mut Frame) -> Result<(), GpuError> {
        let gpu = frame.gpu();
        let host_mesh = tetrahedra();
        let mut mesh = Mesh::upload(gpu, &host_mesh)?;
        let mut builder = Builder::new(self.build);
        let (mut bvh, mut set) = (Bvh::new(), Bvh::new());
        if self.has_layouts {
            mesh = interleaved(gpu, &host_mesh)?;
        }
        if self.sets.is_some() {
            let sets = &mut [(&mut set, SetNeed::Share(0.1))];
            builder.lay_out(gpu, &mesh, &mut bvh, sets)?;
        }
        builder.build(frame, &mesh, &mut bvh)?;
        if self.refits {
            builder.refit(frame, &mesh, &mut bvh)?;
        }
        let Some(sets) = self.sets else {
            return self.record_rays(frame, &mesh, &[Tree::all(&bvh)]);
        };

        let topology = Topology::new(&host_mesh);
        let target = (&Target::position([0.0; 3]), &Frustum::EVERYWHERE);
        let (mut eye, mut sides) = (TargetSides::new(), TargetSides::new());
        let components = match sets {
            Sets::Set => {
                let all = vec![1; topology.component_count() as usize];
                let components = Components::upload(gpu, topology.components())?;
                sides.set(frame, &components, target, &all)?;
                components
            }
            Sets::Decided => {
                let mut decisions = Decisions::new(gpu, &topology)?;
                decisions.measure(frame, &builder, &mesh)?;
                eye.decide(frame, &decisions, target, Answer::Facing)?;
                let answer = Answer::Smaller { eye: &eye };
                sides.decide(frame, &decisions, target, answer)?;
                decisions.components().clone()
            }
        };
        let subset = Subset::Of {
            components: &components,
            sides: &sides,
        };
        builder.build_sorted(frame, &mesh, subset, &mut set)?;
        let ruled = Tree {
            bvh: &bvh,
            rule: Some((&components, &sides)),
        };
        // The set may not fit: its rays have two dispatches.
        self.record_rays(frame, &mesh, &[Tree::all(&bvh), ruled, Tree::all(&set)])
    }

    /// Records queries of each of these trees, and pictures.
    fn record_rays(&self, frame: &mut Frame, mesh: &Mesh, trees: &[Tree]) -> Result<(), GpuError> {
        let gpu = frame.gpu();
        let rays = gpu.checked(|| {
            let rays = [Ray {
                origin: [0.0; 3],
                t_min: 0.0,
                direction: [0.0, 0.0, 1.0],
                t_max: 1.0,
            }; 64];
            Ok(upload(gpu, "slimbvh no rays", BufferUsages::STORAGE, &rays))
        })?;
        let answers = gpu.checked(|| {
            let answers = [Hit::MISS; 64 * 8];
            let usage = BufferUsages::STORAGE;
            Ok(upload(gpu, "slimbvh no answers", usage, &answers))
        })?;
        let (ends, count) = gpu.checked(|| {
            let ends = upload(
                gpu,
                "slimbvh no ends",
                BufferUsages::STORAGE,
                &[RayEnds::NONE; 64],
            );
            let count = upload(gpu, "slimbvh no count", BufferUsages::STORAGE, &[64u32]);
            Ok((ends, count))
        })?;
        let plain = Rays::new(rays.slice(..));
        for tree in trees {
            for &query in self.queries {
                tree.trace(frame, query, plain, answers.slice(..))?;
                if self.has_ends {
                    let rays = plain.with_ends(ends.slice(..));
                    tree.trace(frame, query, rays, answers.slice(..))?;
                }
                if self.has_counts {
                    let rays = plain.counted_by(count.slice(..));
                    tree.trace(frame, query, rays, answers.slice(..))?;
                }
            }
        }
        let Some(picture) = self.picture else {
            return Ok(());
        };
        let settings = RenderSettings {
            size: [64, 64],
            sample_count: 1,
            ..picture
        };
        let mirror = Material {
            mirror: if picture.mirror_depth > 0 { 0.5 } else { 0.0 },
            ..Material::default()
        };
        let scene = Scene::from_buffers(gpu, mesh.clone(), None, None, &[mirror])?;
        let camera = Camera {
            eye: [0.0, 0.0, 9.0],
            target: [0.0; 3],
            up: [0.0, 1.0, 0.0],
            projection: Projection::Perspective { vertical_fov: 40.0 },
        };
        let lights = [Light::Point {
            position: [0.0, 9.0, 0.0],
            color: [1.0; 3],
            range: f32::INFINITY,
        }];
        for &tree in trees {
            let trees = Trees {
                primary: tree,
                lights: vec![tree],
                mirrors: Some(tree.bvh),
            };
            let view = (&camera, lights.as_slice());
            Renderer::new().render_with(frame, &scene, &trees, view, &settings)?;
        }
        Ok(())
    }
}

impl Gpu {
    /// Compiles the kernels that a program will use, so that its first frame is as fast as the others. Returns the time as stage
    /// `compile`; frames tell the same stage where they still had to compile.
    ///
    /// The kernels are those of a small frame that is recorded here, and not submitted.
    ///
    /// ```no_run
    /// use slimbvh::BuildConfig;
    /// use slimbvh::gpu::{AdapterChoice, Gpu, GpuError, Query, WarmUp};
    /// # fn run() -> Result<(), GpuError> {
    /// let gpu = Gpu::open(&AdapterChoice::Hardware)?;
    /// let uses = WarmUp::new(BuildConfig::default()).with_refits().with_queries(&[Query::Closest]);
    /// println!("{}", gpu.warm_up(&uses)?);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// For a codec without GPU kernels, and those of the driver's compiler.
    pub fn warm_up(&self, uses: &WarmUp) -> Result<Stages, GpuError> {
        let mut frame = self.frame();
        uses.record(&mut frame)?;
        let (_, recorded) = frame.finish()?;
        Ok(recorded.into_compiling())
    }
}

/// Closed components, and triangles enough for every kernel of a build: a pyramid of more than seven levels, a scan of many blocks.
/// 16-bit indices suffice.
fn tetrahedra() -> crate::Mesh {
    let mut mesh = crate::Mesh::default();
    for i in 0..4096 {
        let [x, y] = [i % 64, i / 64].map(|cell: u16| f32::from(cell) - 32.0);
        let first = mesh.vertices.len() as u32;
        mesh.vertices.extend([
            [x, y, 0.0],
            [x + 0.5, y, 0.0],
            [x, y + 0.5, 0.0],
            [x, y, 0.5],
        ]);
        let faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
        mesh.indices
            .extend(faces.map(|face| face.map(|corner| first + corner)));
    }
    mesh
}

/// A mesh in a layout that kernels cannot read in place.
fn interleaved(gpu: &Gpu, mesh: &crate::Mesh) -> Result<Mesh, GpuError> {
    let (vertices, indices) = gpu.checked(|| {
        let usage = BufferUsages::STORAGE;
        let vertices: Vec<[f32; 4]> = mesh
            .vertices
            .iter()
            .map(|&[x, y, z]| [x, y, z, 0.0])
            .collect();
        let indices: Vec<u16> = mesh
            .indices
            .iter()
            .flatten()
            .map(|&corner| corner as u16)
            .collect();
        Ok((
            upload(gpu, "slimbvh interleaved vertices", usage, &vertices),
            upload(gpu, "slimbvh short indices", usage, &indices),
        ))
    })?;
    let vertices = VertexLayout {
        slice: vertices.slice(..),
        stride: 16,
        offset: 0,
    };
    let indices = IndexLayout {
        slice: indices.slice(..),
        format: wgpu::IndexFormat::Uint16,
    };
    Mesh::from_layout(gpu, vertices, indices)
}
