//! Queries of many rays, traced in packets of eight ([`slimbvh_core::trace::trace_packet`]).

use super::bvh::Bvh;
use super::lanes::LANES;
use super::query::Query;
use super::ray_filter::{RayFilter, SharedFilter, are_more_than_skip};
use super::visitor::Together;
use crate::parallel::prelude::*;
use slimbvh_core::classify::{FacingFilter, Sides};
use slimbvh_core::orientation::Target;
use slimbvh_core::ray::{Hit, NO_PRIMITIVE, Ray};
use slimbvh_core::trace::{ClosestOrAny, Lane, PACKETS, PreparedRays};
use slimbvh_core::{RayEnds, SurfaceRay};

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

/// The filter and the collector of one ray.
pub type RayLane<'a> = Lane<RayFilter<'a>, ClosestOrAny>;

/// The filters and collectors of a packet's rays.
pub type Packet<'a> = [RayLane<'a>; LANES];

/// Takes the place of a ray that is not there.
const IDLE: SurfaceRay = SurfaceRay {
    ray: Ray::EMPTY,
    ends: RayEnds::NONE,
};

/// Rays a parallel task.
const BLOCK: usize = 512;

/// The query for each ray: the closest hit, or any.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Question {
    Closest,
    Any,
}

impl Question {
    /// The collector of a ray that ends here.
    #[inline(always)]
    pub fn collector(self, t_max: f32) -> ClosestOrAny {
        match self {
            Self::Closest => ClosestOrAny::closest(t_max),
            Self::Any => ClosestOrAny::any(t_max),
        }
    }
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

impl Query<'_> {
    pub fn closest_hits<R: Sync>(&self, rays: &[R], hits: &mut Vec<Hit>)
    where
        for<'r> &'r R: Into<SurfaceRay>,
    {
        hits.resize(rays.len(), Hit::MISS);
        let blocks = hits.par_chunks_mut(BLOCK).zip(rays.par_chunks(BLOCK));
        blocks.for_each(|(hits, rays)| self.closest_hits_of_block(rays, hits));
    }

    pub fn any_hits<R: Sync>(&self, rays: &[R], found: &mut Vec<bool>)
    where
        for<'r> &'r R: Into<SurfaceRay>,
    {
        found.resize(rays.len(), false);
        let blocks = found.par_chunks_mut(BLOCK).zip(rays.par_chunks(BLOCK));
        blocks.for_each(|(found, rays)| self.any_hits_of_block(rays, found));
    }

    pub fn closest_hits_of_block<R>(&self, rays: &[R], hits: &mut [Hit])
    where
        for<'r> &'r R: Into<SurfaceRay>,
    {
        let query = self.of_packets(Question::Closest);
        let rays = rays.iter().map(Into::into).enumerate();
        self.bvh.trace_rays(&query, rays, |i, hit| hits[i] = hit);
    }

    pub fn any_hits_of_block<R>(&self, rays: &[R], found: &mut [bool])
    where
        for<'r> &'r R: Into<SurfaceRay>,
    {
        let query = self.of_packets(Question::Any);
        let rays = rays.iter().map(Into::into).enumerate();
        let answer = |i: usize, hit: Hit| found[i] = hit.is_hit();
        self.bvh.trace_rays(&query, rays, answer);
    }

    fn of_packets(&self, question: Question) -> PacketQuery<'_> {
        PacketQuery {
            question,
            exponent: self.bvh.scene_exponent(),
            target: self.rule,
        }
    }
}

impl Bvh {
    /// Traces rays, each with a number, and calls back with each ray's number and hit.
    pub(crate) fn trace_rays(
        &self,
        query: &PacketQuery,
        mut rays: impl Iterator<Item = (usize, SurfaceRay)>,
        mut answer: impl FnMut(usize, Hit),
    ) {
        let facing = filter_of(query.target);
        let mut numbers = [0; RAYS];
        let mut given = [IDLE; RAYS];
        let mut prepared = [const { PreparedRays::EMPTY }; PACKETS];
        loop {
            let mut skips = [NO_PRIMITIVE; RAYS];
            let (mut ray_count, mut packet_count, mut with_ends) = (0, 0, 0);
            for (k, prepared) in prepared.iter_mut().enumerate() {
                let first = k * LANES;
                let mut asked = [Ray::EMPTY; LANES];
                for (i, to) in asked.iter_mut().enumerate() {
                    let Some((number, ray)) = rays.next() else {
                        break;
                    };
                    let place = first + i;
                    *to = ray.ray;
                    (numbers[place], skips[place]) = (number, ray.ends.skip[0]);
                    if are_more_than_skip(&ray.ends) {
                        given[place] = ray;
                        with_ends |= 1_u64 << place;
                    }
                    ray_count = place + 1;
                }
                if ray_count <= first {
                    break;
                }
                prepared.prepare(&asked, query.exponent);
                packet_count = k + 1;
            }
            if ray_count == 0 {
                return;
            }
            let shared = SharedFilter {
                facing: &facing,
                rays: &given,
                with_ends,
                scene_exponent: query.exponent,
            };
            let idle = Lane {
                filter: RayFilter {
                    skip: NO_PRIMITIVE,
                    number: 0,
                    shared: &shared,
                },
                collector: query.question.collector(0.0),
            };
            let mut packets = [[idle; LANES]; PACKETS];
            for (k, prepared) in prepared.iter().enumerate().take(packet_count) {
                let t_max = prepared.t_max();
                for (i, lane) in packets[k].iter_mut().enumerate() {
                    let place = k * LANES + i;
                    lane.filter.number = place as u32;
                    lane.filter.skip = skips[place];
                    lane.collector = query.question.collector(t_max[i]);
                }
            }
            self.stored.visit(Together {
                rays: &mut prepared,
                packets: (&mut packets, packet_count),
            });
            let lanes = packets.as_flattened().iter().zip(&numbers);
            for (place, (lane, &number)) in lanes.enumerate().take(ray_count) {
                let hit = lane.collector.closest.hit;
                let hit = prepared[place / LANES].restore(place % LANES, hit);
                answer(number, hit);
            }
        }
    }
}

/// Rays in a bundle.
const RAYS: usize = PACKETS * LANES;

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
            offsets in vec([point(), point()], 1..200),
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
