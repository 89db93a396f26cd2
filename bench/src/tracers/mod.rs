//! What is compared.

mod ploc;
mod slim;

pub use ploc::Ploc;
pub use slim::Slim;

use crate::rays::BLOCK;
use anyhow::Result;
use obvhs::BvhBuildParams;
use obvhs::triangle::Triangle;
use rayon::prelude::*;
use slimbvh::{CodeBits, Mesh, Stages};
use slimbvh_core::Ray;
use std::ops::Add;

/// A mesh as each tracer wants it.
pub struct Input<'a> {
    /// Vertices and indices, for slimbvh.
    pub mesh: &'a Mesh,
    /// A list of triangles, for obvhs.
    pub triangles: Vec<Triangle>,
}

impl<'a> Input<'a> {
    /// Makes the list. A caller of obvhs without one in hand pays for it too; no time measured here includes it.
    #[must_use]
    pub fn new(mesh: &'a Mesh) -> Self {
        let corner = |i: u32| glam::Vec3A::from_array(mesh.vertices[i as usize]);
        let triangle = |&[a, b, c]: &[u32; 3]| Triangle {
            v0: corner(a),
            v1: corner(b),
            v2: corner(c),
        };
        Self {
            mesh,
            triangles: mesh.indices.par_iter().map(triangle).collect(),
        }
    }
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
    /// Nothing was hit.
    pub const MISS: Self = Self {
        t: f32::INFINITY,
        primitive: u32::MAX,
    };

    /// Whether something was hit.
    #[must_use]
    pub const fn is_hit(&self) -> bool {
        self.primitive != u32::MAX
    }
}

/// Which of its two questions a ray asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Question {
    /// What is hit first?
    Closest,
    /// Is anything hit?
    Any,
}

/// Sizes of what tracing reads, in bytes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bytes {
    /// The nodes.
    pub nodes: usize,
    /// The triangles, reordered, with the caller's numbers.
    pub triangles: usize,
}

/// What rays touched, all together.
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
    /// How tables call it.
    fn name(&self) -> &'static str;

    /// Whether its answers have to be slimbvh's to the last bit.
    fn is_exact(&self) -> bool {
        false
    }

    /// Builds all that tracing needs, in place of what was built before; buffers are used again. Returns the times of
    /// its stages, if it tells them.
    ///
    /// # Errors
    /// For meshes that are not valid.
    fn build(&mut self) -> Result<Stages>;

    /// Frees what was built and all buffers: the next build begins from nothing.
    fn forget(&mut self);

    /// Finds the closest hit of each ray.
    fn closest_hits(&self, rays: &[Ray], answers: &mut [Answer]);

    /// Finds whether each ray hits anything.
    fn any_hits(&self, rays: &[Ray], answers: &mut [bool]);

    /// Sizes of what was built.
    fn bytes(&self) -> Bytes;

    /// What these rays touch.
    fn visits(&self, rays: &[Ray], question: Question) -> Visits;
}

/// slimbvh with short codes and what it is held against, obvhs with its fastest preset, then slimbvh with long codes and
/// obvhs with its medium preset.
#[must_use]
pub fn tracers<'a>(input: &'a Input<'a>) -> Vec<Box<dyn Tracer + 'a>> {
    let slim = |name, code_bits| Box::new(Slim::new(name, code_bits, input.mesh));
    let ploc = |name, params| Box::new(Ploc::new(name, params, &input.triangles));
    vec![
        slim("slimbvh 30", CodeBits::Bits30),
        ploc("obvhs fastest", BvhBuildParams::fastest_build()),
        slim("slimbvh 63", CodeBits::Bits63),
        ploc("obvhs medium", BvhBuildParams::medium_build()),
    ]
}

/// Answers rays in the order in which they come, a row of the picture at a time. All tracers go through this.
fn answer_all<A: Send>(rays: &[Ray], answers: &mut [A], answer: impl Fn(&Ray) -> A + Sync) {
    let rows = answers.par_chunks_mut(BLOCK).zip(rays.par_chunks(BLOCK));
    rows.for_each(|(answers, rays)| {
        for (to, ray) in answers.iter_mut().zip(rays) {
            *to = answer(ray);
        }
    });
}
