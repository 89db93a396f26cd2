//! Queries of many rays, traced in packets of eight ([`slimbvh_core::trace::trace_packet`]).

use super::bvh::Bvh;
use super::lanes::{LANES, Numbers};
use super::visitor::Together;
use crate::parallel::prelude::*;
use slimbvh_core::classify::{FacingFilter, Sides};
use slimbvh_core::orientation::Target;
use slimbvh_core::ray::{Hit, NO_PRIMITIVE, Ray};
use slimbvh_core::trace::{ClosestOrAny, Lane, PreparedRays, Skip, SkipAnd};

/// The filter of a query's rays. Without a target it accepts all triangles.
pub fn filter_of(target: Option<(Sides, Target)>) -> FacingFilter<Sides> {
    let everything = Sides {
        components: &[],
        sides: &[],
    };
    let (sides, target) = target.unwrap_or((everything, Target::position([0.0; 3])));
    FacingFilter {
        skip: NO_PRIMITIVE,
        sides,
        target,
    }
}

/// The filters and collectors of a packet's rays.
pub type Packet<'a> = [Lane<SkipAnd<'a, FacingFilter<Sides<'a>>>, ClosestOrAny>; LANES];

/// Rays a parallel task.
const BLOCK: usize = 512;

/// The query for each ray: the closest hit, or any.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Question {
    Closest,
    Any,
}

/// What all rays of a query share.
#[derive(Clone, Copy, Debug)]
pub struct PacketQuery<'a> {
    pub question: Question,
    /// Rays are scaled by two to this power: 0 if they are at the scene's magnitude.
    pub exponent: i32,
    /// Triangles that face away from the target are skipped. At the scene's magnitude.
    pub target: Option<(Sides<'a>, Target)>,
}

impl Bvh {
    /// [`Bvh::closest_hit`] of many rays, in parallel. `hits` is resized to the number of rays.
    ///
    /// Neighbouring rays should be adjacent in the list: the rays of a packet share node reads. [`crate::Tiles`]
    /// is such an order of a picture's rays.
    pub fn closest_hits(&self, rays: &[Ray], hits: &mut Vec<Hit>) {
        hits.resize(rays.len(), Hit::MISS);
        let blocks = hits.par_chunks_mut(BLOCK).zip(rays.par_chunks(BLOCK));
        blocks.for_each(|(hits, rays)| self.closest_hits_of_block(rays, hits));
    }

    /// [`Bvh::any_hit`] of many rays, as [`Bvh::closest_hits`].
    pub fn any_hits(&self, rays: &[Ray], found: &mut Vec<bool>) {
        found.resize(rays.len(), false);
        let blocks = found.par_chunks_mut(BLOCK).zip(rays.par_chunks(BLOCK));
        blocks.for_each(|(found, rays)| self.any_hits_of_block(rays, found));
    }

    /// [`Bvh::closest_hits`] on this thread, for callers with their own threads.
    ///
    /// # Panics
    /// If `hits` is shorter than `rays`.
    pub fn closest_hits_of_block(&self, rays: &[Ray], hits: &mut [Hit]) {
        let query = self.query(Question::Closest);
        self.trace_rays(&query, numbered(rays), |i, hit| hits[i] = hit);
    }

    /// [`Bvh::any_hits`] on this thread, as [`Bvh::closest_hits_of_block`].
    ///
    /// # Panics
    /// If `found` is shorter than `rays`.
    pub fn any_hits_of_block(&self, rays: &[Ray], found: &mut [bool]) {
        let query = self.query(Question::Any);
        self.trace_rays(&query, numbered(rays), |i, hit| found[i] = hit.is_hit());
    }

    fn query(&self, question: Question) -> PacketQuery<'static> {
        PacketQuery {
            question,
            exponent: self.scene_exponent(),
            target: None,
        }
    }

    /// Traces rays, each with a number and a primitive to skip, and calls back with each ray's number and hit.
    pub(crate) fn trace_rays(
        &self,
        query: &PacketQuery,
        rays: impl Iterator<Item = (usize, Ray, u32)>,
        mut answer: impl FnMut(usize, Hit),
    ) {
        let filter = filter_of(query.target);
        let idle = Lane {
            filter: SkipAnd::new(&filter, NO_PRIMITIVE),
            collector: ClosestOrAny::any(0.0),
        };
        let mut packet = [idle; LANES];
        let mut numbers = [0; LANES];
        let mut prepared = PreparedRays::EMPTY;
        let mut rays = rays.peekable();
        while rays.peek().is_some() {
            let mut asked = [Ray::EMPTY; LANES];
            let mut count = 0;
            for (i, (number, ray, skip)) in rays.by_ref().take(LANES).enumerate() {
                asked[i] = ray;
                packet[i].filter.skip = Skip(skip);
                numbers[i] = number;
                count += 1;
            }
            prepared.prepare(&asked, query.exponent);
            for (lane, t_max) in packet.iter_mut().zip(prepared.t_max()) {
                lane.collector = match query.question {
                    Question::Closest => ClosestOrAny::closest(*t_max),
                    Question::Any => ClosestOrAny::any(*t_max),
                };
            }
            self.trace(&mut prepared, &mut packet);
            for (i, lane) in packet.iter().enumerate().take(count) {
                answer(numbers[i], prepared.restore(i, lane.collector.closest.hit));
            }
        }
    }

    fn trace(&self, rays: &mut PreparedRays<Numbers, LANES>, packet: &mut Packet) {
        self.stored.visit(Together { rays, packet });
    }
}

fn numbered(rays: &[Ray]) -> impl Iterator<Item = (usize, Ray, u32)> {
    let rays = rays.iter().enumerate();
    rays.map(|(i, ray)| (i, *ray, NO_PRIMITIVE))
}

#[cfg(test)]
mod tests {
    use crate::{BuildConfig, Builder, Hit, Mesh, MeshCodec, Ray};
    use proptest::array::uniform3;
    use proptest::collection::vec;
    use proptest::prelude::*;

    fn point() -> impl Strategy<Value = [f32; 3]> {
        uniform3(-1.0f32..1.0)
    }

    proptest! {
        /// Repeated here from tests/ because it needs only the library, which builds quickly for each target CPU.
        #[test]
        fn rays_together_answer_as_each_alone(
            vertices in vec(point(), 3..60),
            indices in vec(uniform3(any::<prop::sample::Index>()), 1..80),
            (origin, spread) in (point(), -8..2i32),
            offsets in vec([point(), point()], 1..40),
        ) {
            let indices: Vec<_> = indices.iter().map(|c| c.map(|i| i.index(vertices.len()) as u32)).collect();
            let mesh = Mesh { vertices, indices, ..Mesh::default() };
            // Roughly parallel rays; each third through a vertex.
            let ray = |(i, [off, way]): (usize, &[[f32; 3]; 2])| {
                let by = |x: f32| x * 2f32.powi(spread);
                let from = [0, 1, 2].map(|axis| 3.0 * origin[axis] + by(off[axis]));
                let to = mesh.vertices[i / 3 % mesh.vertices.len()];
                let to = if i % 3 == 0 { to } else { way.map(by) };
                Ray::new(from, [0, 1, 2].map(|axis| to[axis] - from[axis]))
            };
            let rays: Vec<Ray> = offsets.iter().enumerate().map(ray).collect();
            for nodes in MeshCodec::F32.nodes() {
                let bvh = Builder::new(BuildConfig { nodes, ..BuildConfig::default() }).build(&mesh);
                let bvh = bvh.map_err(|error| TestCaseError::fail(error.to_string()))?;
                let (mut hits, mut found) = (Vec::new(), Vec::new());
                bvh.closest_hits(&rays, &mut hits);
                bvh.any_hits(&rays, &mut found);
                let alone: Vec<Hit> = rays.iter().map(|ray| bvh.closest_hit(ray)).collect();
                prop_assert_eq!(bytemuck::cast_slice::<Hit, u32>(&hits), bytemuck::cast_slice::<Hit, u32>(&alone));
                prop_assert_eq!(found, rays.iter().map(|ray| bvh.any_hit(ray)).collect::<Vec<_>>());
            }
        }
    }
}
