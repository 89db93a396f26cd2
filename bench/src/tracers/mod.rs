//! The tracers that are compared.

mod binned;
mod clusters;
#[cfg(feature = "embree")]
mod embree;
mod parry;
mod ploc;
mod slim;
#[cfg(feature = "tinybvh")]
mod tiny;
mod wide;

pub use binned::{Binned, Order};
#[cfg(feature = "embree")]
pub use embree::{Embree, Packing, Quality};
pub use parry::Parry;
pub use ploc::Ploc;
pub use slim::Slim;
#[cfg(feature = "tinybvh")]
pub use tiny::Tiny;
pub use wide::Wide;

use crate::rays::BLOCK;
use anyhow::Result;
use glam::Vec3;
use obvhs::BvhBuildParams;
use obvhs::triangle::Triangle;
use rayon::prelude::*;
use slimbvh::{BuildConfig, CodeBits, Mesh, Stages, TreeKind};
use slimbvh_core::{Hit, Ray};
use std::ops::Add;

/// A mesh in the form of each tracer.
pub struct Input<'a> {
    /// Vertices and indices, for slimbvh.
    pub mesh: &'a Mesh,
    /// A list of triangles, for obvhs.
    pub triangles: Vec<Triangle>,
    /// A list of corners, three a triangle, for tinybvh.
    #[cfg(feature = "tinybvh")]
    pub positions: Vec<[f32; 4]>,
    /// The vertices and one more, unused, for Embree.
    #[cfg(feature = "embree")]
    pub padded: Vec<[f32; 3]>,
}

impl<'a> Input<'a> {
    /// Makes the lists. No time of a tracer includes this, though a caller without such a list pays for it.
    #[must_use]
    pub fn new(mesh: &'a Mesh) -> Self {
        Self {
            mesh,
            triangles: triangles(mesh),
            #[cfg(feature = "tinybvh")]
            positions: {
                let corner = |&i: &u32| {
                    let [x, y, z] = mesh.vertices[i as usize];
                    [x, y, z, 0.0]
                };
                let corners = mesh.indices.as_flattened().par_iter();
                corners.map(corner).collect()
            },
            #[cfg(feature = "embree")]
            padded: [&mesh.vertices[..], &[[0.0; 3]]].concat(),
        }
    }
}

/// The list of triangles for obvhs.
#[must_use]
pub fn triangles(mesh: &Mesh) -> Vec<Triangle> {
    let corner = |i: u32| glam::Vec3A::from_array(mesh.vertices[i as usize]);
    let triangle = |&[a, b, c]: &[u32; 3]| Triangle {
        v0: corner(a),
        v1: corner(b),
        v2: corner(c),
    };
    mesh.indices.par_iter().map(triangle).collect()
}

/// The closest hit, if there is one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// Infinite for a miss.
    pub t: f32,
    /// The caller's number of the triangle; `u32::MAX` for a miss.
    pub primitive: u32,
}

impl Answer {
    /// A miss.
    pub const MISS: Self = Self {
        t: f32::INFINITY,
        primitive: u32::MAX,
    };

    /// Whether this is a hit.
    #[must_use]
    pub const fn is_hit(&self) -> bool {
        self.primitive != u32::MAX
    }
}

impl From<&Hit> for Answer {
    fn from(hit: &Hit) -> Self {
        if !hit.is_hit() {
            return Self::MISS;
        }
        Self {
            t: hit.t,
            primitive: hit.primitive,
        }
    }
}

/// The query of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Question {
    /// The closest hit.
    Closest,
    /// Any hit.
    Any,
}

/// Sizes of a tree in bytes, as far as they are known.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bytes {
    /// All nodes.
    pub nodes: Option<usize>,
    /// All nodes, and all triangles with the caller's numbers.
    pub all: Option<usize>,
}

/// The required agreement of a tracer's answers with slimbvh's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Demand {
    /// Equal to the last bit.
    Exact,
    /// The same number of hits, within a tolerance.
    Close,
    /// None: differences are counted.
    Counted,
}

/// Sums of the nodes and triangles that rays touched.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Visits {
    /// Inner nodes opened; each tests two boxes.
    pub nodes: u64,
    /// Triangles tested.
    pub triangles: u64,
}

impl Add for Visits {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            nodes: self.nodes + other.nodes,
            triangles: self.triangles + other.triangles,
        }
    }
}

/// Builds over a mesh and answers rays, in the rayon pool that calls it.
pub trait Tracer: Send + Sync {
    /// The name in tables: the library's name, then the kind of tree.
    fn name(&self) -> &'static str;

    /// The required agreement of its answers.
    fn demand(&self) -> Demand {
        Demand::Counted
    }

    /// Builds all that tracing needs, into the buffers of the build before. Returns the times of its stages, if it reports
    /// them.
    ///
    /// # Errors
    /// For invalid meshes.
    fn build(&mut self) -> Result<Stages>;

    /// Frees the tree and all buffers: the next build allocates anew.
    fn forget(&mut self);

    /// Whether the tracer accepts this ray.
    fn takes(&self, _ray: &Ray) -> bool {
        true
    }

    /// Finds the closest hit of each ray.
    fn closest_hits(&self, rays: &[Ray], answers: &mut [Answer]);

    /// Finds whether each ray hits anything.
    fn any_hits(&self, rays: &[Ray], answers: &mut [bool]);

    /// Sizes of the tree.
    fn bytes(&self) -> Bytes;

    /// Counts of nodes and triangles that these rays touch, if the tracer can count them.
    fn visits(&self, _rays: &[Ray], _question: Question) -> Option<Visits> {
        None
    }
}

/// The name of the reference: slimbvh with 30-bit codes.
pub const OURS: &str = "slimbvh 30";

/// The name of the first peer to compare [`OURS`] with: obvhs with its fastest preset.
pub const PEER: &str = "obvhs fastest";

/// The name of tinybvh's tree, which depends on AVX2.
pub const TINY: &str = if cfg!(target_feature = "avx2") {
    "tinybvh bvh8"
} else {
    "tinybvh bvh2"
};

/// All tracers, [`OURS`] and [`PEER`] first.
#[must_use]
pub fn tracers<'a>(input: &'a Input<'a>) -> Vec<Box<dyn Tracer + 'a>> {
    let mesh = input.mesh;
    let slim = |name, config| Box::new(Slim::new(name, config, mesh));
    let clustered = BuildConfig {
        tree: TreeKind::Clustered,
        ..BuildConfig::default()
    };
    let ploc = |name, params| Box::new(Ploc::new(name, params, &input.triangles));
    let wide = |name, params| Box::new(Wide::new(name, params, &input.triangles));
    let binned = |name, order| Box::new(Binned::new(name, order, mesh));
    #[cfg_attr(
        not(any(feature = "tinybvh", feature = "embree")),
        expect(unused_mut, reason = "more come with features")
    )]
    let mut tracers: Vec<Box<dyn Tracer + 'a>> = vec![
        slim(OURS, CodeBits::Bits30.into()),
        ploc(PEER, BvhBuildParams::fastest_build()),
        slim("slimbvh 63", CodeBits::Bits63.into()),
        slim("slimbvh clustered", clustered),
        ploc("obvhs medium", BvhBuildParams::medium_build()),
        wide("obvhs cwbvh8 fastest", BvhBuildParams::fastest_build()),
        wide("obvhs cwbvh8 medium", BvhBuildParams::medium_build()),
        binned("bvh nearest", Order::Nearest),
        binned("bvh all", Order::All),
        binned("bvh pruned", Order::Pruned),
        Box::new(Parry::new(mesh)),
    ];
    #[cfg(feature = "tinybvh")]
    tracers.push(Box::new(Tiny::new(&input.positions)));
    #[cfg(feature = "embree")]
    for (name, kind) in [
        ("embree morton", (Quality::Low, Packing::Single)),
        ("embree morton x16", (Quality::Low, Packing::Packets)),
        ("embree sah", (Quality::Medium, Packing::Single)),
        ("embree sah x16", (Quality::Medium, Packing::Packets)),
    ] {
        tracers.push(Box::new(Embree::new(name, kind, &input.padded, mesh)));
    }
    tracers
}

/// Answers rays in their order, with as many as a row of the picture has as a task. All tracers use this loop.
fn answer_rows<A: Send>(rays: &[Ray], answers: &mut [A], answer: impl Fn(&[Ray], &mut [A]) + Sync) {
    let rows = answers.par_chunks_mut(BLOCK).zip(rays.par_chunks(BLOCK));
    rows.for_each(|(answers, rays)| answer(rays, answers));
}

/// As [`answer_rows`], with one ray a call.
fn answer_all<A: Send>(rays: &[Ray], answers: &mut [A], answer: impl Fn(&Ray) -> A + Sync) {
    answer_rows(rays, answers, |rays, answers| {
        for (to, ray) in answers.iter_mut().zip(rays) {
            *to = answer(ray);
        }
    });
}

/// For tracers whose rays start at t = 0: the ray moved to the start of its range, and the shift to add to its t.
#[inline]
fn from_start(ray: &Ray) -> (Ray, f32) {
    if ray.t_min == 0.0 {
        return (*ray, 0.0);
    }
    moved(ray)
}

/// For tracers whose rays cannot start behind their origin: as [`from_start`] if this ray does.
#[inline]
fn not_behind(ray: &Ray) -> (Ray, f32) {
    if ray.t_min >= 0.0 {
        return (*ray, 0.0);
    }
    moved(ray)
}

/// The ray moved to the start of its range, and the shift to add to its t.
#[cold]
fn moved(ray: &Ray) -> (Ray, f32) {
    let along = |axis: usize| {
        let way = f64::from(ray.direction[axis]) * f64::from(ray.t_min);
        (f64::from(ray.origin[axis]) + way) as f32
    };
    let moved = Ray {
        origin: [0, 1, 2].map(along),
        t_min: 0.0,
        direction: ray.direction,
        t_max: ray.t_max - ray.t_min,
    };
    (moved, ray.t_min)
}

/// The length of a direction, for tracers that normalize it. In `f64` if squares leave the range of `f32`.
#[inline]
fn length(direction: Vec3) -> f32 {
    let length = direction.length();
    if (1e-15..1e15).contains(&length) {
        return length;
    }
    direction.as_dvec3().length() as f32
}
