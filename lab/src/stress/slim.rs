//! slimbvh on the CPU.

use super::families::Case;
use super::judge::Answer;
use super::moves::{MoveError, moved};
use super::stack::{depth, longest};
use super::storage::{Prepared, Storage};
use super::tracer::{Failure, Outcome, Tracer, Tree};
use super::{BOUND_ULPS, Effort};
use rayon::prelude::*;
use slimbvh::reduce::{Seams, survey};
use slimbvh::topology;
use slimbvh::{Builder, Bvh, Mesh, Ray, Subset};
use slimbvh_core::classify::{Sides, VisibleSet};
use slimbvh_core::float::scale_by_power_of_two;
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;
use std::time::Instant;

/// The CPU backend.
#[derive(Clone, Copy, Debug)]
pub struct Cpu {
    /// The number of codecs.
    pub effort: Effort,
}

/// The name in tables.
pub const NAME: &str = "slimbvh";

impl Tracer for Cpu {
    fn name(&self) -> &str {
        NAME
    }

    fn backend(&self) -> &'static str {
        "cpu"
    }

    fn bound_ulps(&self) -> f64 {
        BOUND_ULPS
    }

    fn trees(&self, case: &Case) -> Vec<Tree> {
        trees(case, self.effort, false)
    }

    fn trace(&mut self, case: &Case, tree: &Tree, rays: &[Ray]) -> Result<Outcome, Failure> {
        let storage = storage(tree, self.effort)?;
        let prepared = storage.prepare(&case.mesh, case.code_bits);
        let facing = Facing::new(case, tree, &prepared.mesh)?;
        let mut builder = Builder::new(prepared.config);
        let mut bvh = Bvh::default();
        let start = Instant::now();
        builder.build_subset(&prepared.mesh, facing.subset(), &mut bvh)?;
        let answers = answers(&bvh, rays);
        let time_ms = start.elapsed().as_secs_f64() * 1e3;
        let facts = facts(&prepared, storage, &bvh)?;
        let stack = rays
            .par_iter()
            .map(|ray| longest(&facts.decoded, ray))
            .max();
        Ok(Outcome {
            answers,
            stack: Some(stack.unwrap_or(0)),
            time_ms,
            ..facts.outcome
        })
    }
}

/// All codecs with whole trees, and some of them with reduced trees if the case has an eye.
pub fn trees(case: &Case, effort: Effort, on_gpu: bool) -> Vec<Tree> {
    let tree = |storage: Storage, is_reduced| Tree {
        codec: storage.name(),
        is_reduced,
    };
    let all = Storage::all(effort, on_gpu);
    let whole = all.into_iter().map(|storage| tree(storage, false));
    let on_cpu = (!on_gpu).then_some(Storage::LATTICE);
    let reduced = [Storage::PLAIN, Storage::WIDE].into_iter().chain(on_cpu);
    let reduced = reduced.map(|storage| tree(storage, true));
    let reduced = reduced.filter(|_| case.eye.is_some());
    whole.chain(reduced).collect()
}

/// The codec of this name.
pub fn storage(tree: &Tree, effort: Effort) -> Result<Storage, Failure> {
    let mut all = Storage::all(effort, false).into_iter();
    let own = all.find(|storage| storage.name() == tree.codec);
    own.ok_or_else(|| format!("there is no codec {:?}", tree.codec).into())
}

/// The triangles that a tree is built over.
pub struct Facing {
    pub components: Vec<u32>,
    pub sides: Vec<i32>,
    pub target: Option<Target>,
}

impl Facing {
    pub fn new(case: &Case, tree: &Tree, mesh: &Mesh) -> Result<Self, Failure> {
        let Some(eye) = case.eye.filter(|_| tree.is_reduced) else {
            return Ok(Self {
                components: Vec::new(),
                sides: Vec::new(),
                target: None,
            });
        };
        let topology = survey(mesh, case.code_bits.into(), Seams::Find)?.topology;
        Ok(Self {
            components: topology.components().to_vec(),
            sides: topology.sides(&topology::Target::Point(eye)),
            target: Some(Target::position(eye)),
        })
    }

    fn subset(&self) -> Subset<'_> {
        let of = |target| {
            Subset::Of(VisibleSet {
                sides: Sides {
                    components: &self.components,
                    sides: &self.sides,
                },
                target,
                frustum: Frustum::EVERYWHERE,
            })
        };
        self.target.map_or(Subset::All, of)
    }
}

fn answers(bvh: &Bvh, rays: &[Ray]) -> Vec<Answer> {
    let answer = |ray: &Ray| Answer {
        closest: bvh.closest_hit(ray),
        any: bvh.any_hit(ray),
    };
    rays.par_iter().map(answer).collect()
}

/// The contents of a tree, and its outcome without answers.
pub struct Facts {
    pub decoded: Bvh,
    pub outcome: Outcome,
}

/// Collects the triangles as the codec stores them. Triangles that a tree leaves out stay as they are.
pub fn facts(prepared: &Prepared, storage: Storage, bvh: &Bvh) -> Result<Facts, Failure> {
    let decoded = bvh.decoded();
    // Use the scene's own magnitude if it is larger, else the tree's: either way the numbers fit into `f32`.
    let exponent = bvh.scene_exponent().max(0);
    let unscale = exponent - bvh.scene_exponent();
    let mesh = &prepared.mesh;
    let scaled = |v: &u32| mesh.vertices[*v as usize].map(|x| scale_by_power_of_two(x, exponent));
    let mut triangles: Vec<[[f32; 3]; 3]> = mesh
        .indices
        .iter()
        .map(|face| face.each_ref().map(scaled))
        .collect();
    for leaf in decoded.leaf_triangles() {
        let corner = |i: usize| {
            [0, 1, 2].map(|axis| scale_by_power_of_two(leaf.vertices[3 * i + axis], unscale))
        };
        if let Some(triangle) = triangles.get_mut(leaf.primitive as usize) {
            *triangle = [0, 1, 2].map(corner);
        }
    }
    let moved = if storage.is_leaf10() {
        let plain = Builder::new(prepared.config.code_bits.into()).build(mesh)?;
        let unit = 2f64.powi(-plain.scene_exponent());
        match moved(&plain, &decoded) {
            Ok(moves) => Some([moves.most, moves.bound]),
            // The row reports it, like all faults.
            Err(MoveError::BeyondBound { distance, bound }) => {
                Some([distance * unit, bound * unit])
            }
            Err(error) => return Err(error.into()),
        }
    } else {
        prepared.moved
    };
    let depth = Some(depth(&decoded));
    Ok(Facts {
        decoded,
        outcome: Outcome {
            triangles,
            exponent,
            moved,
            depth,
            ..Outcome::default()
        },
    })
}
