//! Rays of a packet, prepared together: what is ordinary about them at once, each other one alone.

use crate::geometry::float::{exponent, power_of_two};
use crate::geometry::lanes::{Lanes, Wide};
use crate::geometry::planes::{BoxSpan, Planes};
use crate::geometry::ray::{Axis, FARTHEST_ORIGIN, Hit, PreparedRay, Ray, RayLanes, restore};

/// Rays whose origins or directions are farther from the first one's, on any axis, walk alone. In the scene's magnitude, whose largest
/// coordinate is at most 1, and in that of directions, whose largest component is at most 2.
const APART: f32 = 1.0 / 16.0;

/// The same of packets.
const PACKETS_APART: f32 = 1.0 / 4.0;

/// Largest components of directions between these are ordinary, and exponents of scenes.
const SHORTEST: i32 = -60;
const LONGEST: i32 = 60;

/// Ends of ranges that are smaller, before or after they are scaled by a power of two, may lose bits.
const SMALLEST: f32 = power_of_two(-100);

/// Several rays, as the tracer uses them. Each is what [`PreparedRay::new`] makes of it, to the bit.
pub struct PreparedRays<W: Lanes, const LANES: usize> {
    /// The order of axes of those that may walk together.
    pub(super) axes: [u32; 3],
    /// The rays that may walk together.
    pub(super) lanes: RayLanes<BoxSpan<W>>,
    /// A bit for each ray that is to walk along with the others.
    pub(super) members: u32,
    t_max: [f32; LANES],
    t_exponent: [i32; LANES],
    alone: [PreparedRay; LANES],
    /// A bit for each that stands in `alone`.
    ready: u32,
}

impl<W: Wide<LANES>, const LANES: usize> PreparedRays<W, LANES> {
    /// None yet: they hit nothing.
    pub const EMPTY: Self = Self {
        axes: [0, 1, 2],
        lanes: RayLanes {
            origin: [W::ZERO; 3],
            direction: [W::ZERO; 3],
            plane_origins: [BoxSpan {
                low: W::ZERO,
                high: W::ZERO,
            }; 3],
            inverse: [W::ZERO; 3],
            t_min: W::ZERO,
        },
        members: 0,
        t_max: [0.0; LANES],
        t_exponent: [0; LANES],
        alone: [PreparedRay::EMPTY; LANES],
        ready: u32::MAX,
    };

    /// [`PreparedRay::new`] of each, in the place of those that were here.
    #[inline(always)]
    pub fn prepare(&mut self, rays: &[Ray; LANES], scene_exponent: i32) {
        const { assert!(LANES <= 32, "a mask has 32 bits") };
        let [ox, oy, oz, t_min, dx, dy, dz, t_max] = W::columns(bytemuck::cast(*rays));
        let (origin, direction) = ([ox, oy, oz], [dx, dy, dz]);

        let [dx, dy, dz] = direction.map(W::abs);
        let longest = dx.max(dy).max(dz);
        let is_x = dx.at_least(longest);
        let is_y = dy.at_least(longest) & !is_x;
        let unit = longest.power_below();
        let exponent_in_range = scene_exponent.clamp(SHORTEST, LONGEST);
        let (scale, to_unit) = (
            W::splat(power_of_two(exponent_in_range)),
            W::splat(1.0) / unit,
        );
        let origin = origin.map(|x| x * scale);
        // As numbers are compared that may be none: the largest of them need not tell.
        let [ox, oy, oz] = origin.map(|x| x.abs().at_most(W::splat(FARTHEST_ORIGIN)));
        let [dx, dy, dz] = [dx, dy, dz].map(|x| x.at_most(W::splat(power_of_two(LONGEST))));
        let is_long = longest.at_least(W::splat(power_of_two(SHORTEST)));
        let ([t_min, t_max], is_exact) = scaled_ends([t_min, t_max], scale * unit);
        let ordinary = ox & oy & oz & dx & dy & dz & is_long & is_exact;
        let ordinary = if exponent_in_range == scene_exponent {
            W::bits(ordinary)
        } else {
            0
        };
        let asked = ordinary & W::bits(t_min.at_most(t_max));

        // The first one's axes, and all who share them.
        let first = asked.trailing_zeros() as usize % LANES;
        let (is_x, is_y) = (W::bits(is_x), W::bits(is_y));
        let (last, alike) = if is_x >> first & 1 == 1 {
            (0, is_x)
        } else if is_y >> first & 1 == 1 {
            (1, is_y)
        } else {
            (2, !(is_x | is_y))
        };
        let alike = ordinary & alike;
        let (origin, direction) = (
            turned(origin, last),
            turned(direction.map(|x| x * to_unit), last),
        );
        let near = near(origin, first) & near(direction, first);
        let axis = |i: usize| Axis::new(origin[i], direction[i]);
        let [a, b, c] = [axis(0), axis(1), axis(2)];
        self.axes = turned([0, 1, 2], last);
        self.lanes = RayLanes {
            origin: [a.origin, b.origin, c.origin],
            direction: [a.direction, b.direction, c.direction],
            plane_origins: [a.plane_origins, b.plane_origins, c.plane_origins],
            inverse: [a.inverse, b.inverse, c.inverse],
            t_min,
        };
        self.members = asked & alike & near;
        self.t_max = t_max.to_array();
        let unit = unit.to_array();
        for (to, unit) in self.t_exponent.iter_mut().zip(unit) {
            *to = scene_exponent + exponent(unit);
        }
        self.ready = 0;
        for (i, ray) in rays.iter().enumerate() {
            if alike >> i & 1 == 0 {
                self.prepare_alone(i, ray, scene_exponent);
            }
        }
    }

    /// Which of the first `count` packets may walk together: those of several rays whose axes are in the first one's order, and which begin and go near
    /// to its first ray. None if it were one.
    pub(super) fn side_by_side<const PACKETS: usize>(
        packets: &[Self; PACKETS],
        count: usize,
    ) -> u32 {
        let is_packet = |rays: &&Self| rays.members.count_ones() > 1;
        let packets = || packets.iter().take(count);
        let Some(first) = packets().find(is_packet) else {
            return 0;
        };
        let [origin, direction] = first.first_member();
        let mut joined = 0;
        for (k, rays) in packets().enumerate() {
            let [begin, way] = rays.first_member();
            let off = |a: f32, b: f32| (a - b).abs() <= PACKETS_APART;
            let is_near = (0..3).all(|i| off(begin[i], origin[i]) & off(way[i], direction[i]));
            let is_joined = is_packet(&rays) & (rays.axes == first.axes) & is_near;
            joined |= u32::from(is_joined) << k;
        }
        match joined.count_ones() {
            1 => 0,
            _ => joined,
        }
    }

    /// The origin and the direction of the first ray that walks along.
    fn first_member(&self) -> [[f32; 3]; 2] {
        let i = self.members.trailing_zeros() as usize % LANES;
        let number = |numbers: W| numbers.lane(i);
        [
            self.lanes.origin.map(number),
            self.lanes.direction.map(number),
        ]
    }

    #[inline(never)]
    fn prepare_alone(&mut self, i: usize, ray: &Ray, scene_exponent: i32) {
        let (i, ray) = (i % LANES, PreparedRay::new(ray, scene_exponent));
        self.t_max[i] = ray.t_max;
        self.t_exponent[i] = ray.t_exponent;
        self.alone[i] = ray;
        self.ready |= 1 << i;
    }

    /// [`PreparedRay::t_max`] of each.
    #[inline(always)]
    #[must_use]
    pub fn t_max(&self) -> &[f32; LANES] {
        &self.t_max
    }

    /// [`PreparedRay::restore`] of a hit of one of them.
    #[inline(always)]
    #[must_use]
    pub fn restore(&self, i: usize, hit: Hit) -> Hit {
        restore(hit, self.t_exponent[i % LANES])
    }

    /// One of them.
    #[inline(always)]
    pub(super) fn alone(&mut self, i: usize) -> &PreparedRay {
        let i = i % LANES;
        if self.ready >> i & 1 == 0 {
            self.ready |= 1 << i;
            self.alone[i] = self.lane(i);
        }
        &self.alone[i]
    }

    #[inline(never)]
    fn lane(&self, i: usize) -> PreparedRay {
        let number = |numbers: W| numbers.to_array()[i % LANES];
        let RayLanes {
            origin,
            direction,
            plane_origins,
            inverse,
            t_min,
        } = self.lanes;
        PreparedRay {
            axes: self.axes,
            origin: origin.map(number),
            direction: direction.map(number),
            plane_origins: plane_origins
                .map(|span| Planes::new(number(span.low), number(span.high))),
            inverse: inverse.map(number),
            t_min: number(t_min),
            t_max: self.t_max[i % LANES],
            t_exponent: self.t_exponent[i % LANES],
        }
    }
}

/// Both ends of ranges times a power of two, the largest number where they are beyond it; and where neither is so small that bits
/// are lost. What is lost as a whole is 0, as it should be.
#[inline(always)]
fn scaled_ends<W: Lanes>([t_min, t_max]: [W; 2], factor: W) -> ([W; 2], W::Mask) {
    let [near_end, far_end] = [t_min * factor, t_max * factor];
    let is_exact = is_zero_or_large(t_min)
        & is_zero_or_large(t_max)
        & is_zero_or_large(near_end)
        & is_zero_or_large(far_end)
        // An infinite one is no beginning.
        & t_min.abs().at_most(W::splat(f32::MAX));
    let ends = [near_end, far_end];
    (
        ends.map(|t| t.max(W::splat(f32::MIN)).min(W::splat(f32::MAX))),
        is_exact,
    )
}

#[inline(always)]
fn is_zero_or_large<W: Lanes>(x: W) -> W::Mask {
    x.abs().at_least(W::splat(SMALLEST)) | x.abs().at_most(W::ZERO)
}

/// Which vectors are so near to the first one, on all axes, that their rays are expected to pass the same nodes.
#[inline(always)]
fn near<W: Wide<LANES>, const LANES: usize>(vectors: [W; 3], first: usize) -> u32 {
    let mut near = u32::MAX;
    for numbers in vectors {
        let off = numbers - W::splat(numbers.to_array()[first % LANES]);
        near &= W::bits(off.abs().at_most(W::splat(APART)));
    }
    near
}

/// x, y and z in an order in which this one comes last.
#[inline(always)]
fn turned<T>([x, y, z]: [T; 3], last: u32) -> [T; 3] {
    match last {
        0 => [y, z, x],
        1 => [z, x, y],
        _ => [x, y, z],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::lanes::Each;
    use proptest::array::uniform3;
    use proptest::prelude::*;

    fn any_number() -> impl Strategy<Value = f32> {
        any::<u32>().prop_map(f32::from_bits)
    }

    /// Numbers about this large, or zero.
    fn number_near(exponent: i32) -> impl Strategy<Value = f32> {
        let near = (-1.0f32..1.0, -30..2i32);
        prop_oneof![
            1 => prop_oneof![Just(0.0f32), Just(-0.0)],
            8 => near.prop_map(move |(x, e)| x * power_of_two(exponent + e)),
        ]
    }

    /// What scaling by a power of two makes small, or large, or anything.
    fn end(scaled_by: i32) -> impl Strategy<Value = f32> {
        let small = -155..-90i32;
        let any = -155..140i32;
        let number = (0.5f32..1.0, prop_oneof![small, any]);
        prop_oneof![
            1 => prop_oneof![Just(0.0), Just(f32::MAX), Just(f32::INFINITY), any_number()],
            2 => number.prop_map(move |(x, e)| x * power_of_two((e - scaled_by).clamp(-126, 127))),
        ]
    }

    /// Some rays of the same magnitudes, and some of any; and a scene's exponent.
    fn any_rays() -> impl Strategy<Value = ([Ray; 8], i32)> {
        let ray = |(origin, direction, t_min, t_max)| Ray {
            origin,
            t_min,
            direction,
            t_max,
        };
        let exponent = prop_oneof![3 => -60..=60i32, 1 => -127..=150i32];
        (-70..70i32, -70..70i32, exponent).prop_flat_map(move |(size, length, exponent)| {
            let (place, way) = (uniform3(number_near(size)), uniform3(number_near(length)));
            let ends = || end(length + exponent);
            let usual = (place, way, ends(), ends());
            let any = || uniform3(any_number());
            let unusual = (any(), any(), any_number(), any_number());
            let ray = prop_oneof![9 => usual.prop_map(ray), 1 => unusual.prop_map(ray)];
            let rays = proptest::collection::vec(ray.boxed(), 8);
            (
                rays.prop_map(|rays| core::array::from_fn(|i| rays[i])),
                Just(exponent),
            )
        })
    }

    fn bits(ray: &PreparedRay) -> impl PartialEq + core::fmt::Debug + use<> {
        let PreparedRay {
            axes,
            origin,
            direction,
            plane_origins: [a, b, c],
            inverse,
            t_min,
            t_max,
            t_exponent,
        } = *ray;
        let vectors = [origin, direction, inverse].map(|v| v.map(f32::to_bits));
        let planes = [a, b, c].map(|p| p.to_array().map(f32::to_bits));
        let ends = [t_min, t_max].map(f32::to_bits);
        (axes, t_exponent, (vectors, planes, ends))
    }

    fn prepared(rays: &[Ray; 8], exponent: i32) -> PreparedRays<Each<8>, 8> {
        // Whatever was there before.
        let mut prepared = PreparedRays::EMPTY;
        prepared.prepare(&[Ray::new([1.0, 2.0, 3.0], [4.0, 5.0, 6.0]); 8], 3);
        for i in 0..8 {
            prepared.alone(i);
        }
        prepared.prepare(rays, exponent);
        prepared
    }

    proptest! {
        #[test]
        fn each_is_prepared_as_alone((rays, exponent) in any_rays()) {
            let mut prepared = prepared(&rays, exponent);
            for (i, ray) in rays.iter().enumerate() {
                let alone = PreparedRay::new(ray, exponent);
                let (t_max, t_exponent) = (prepared.t_max()[i], prepared.t_exponent[i]);
                prop_assert_eq!(t_max.to_bits(), alone.t_max.to_bits());
                prop_assert_eq!(t_exponent, alone.t_exponent);
                let is_member = prepared.members >> i & 1 == 1;
                prop_assert_eq!(bits(prepared.alone(i)), bits(&alone));
                if is_member {
                    // As the walk sees it.
                    prop_assert_eq!(bits(&prepared.lane(i)), bits(&alone));
                    prop_assert!(alone.t_min <= alone.t_max);
                    prop_assert_eq!(prepared.axes, alone.axes);
                }
            }
        }

        #[test]
        fn rays_side_by_side_walk_together(size in -50..50i32, length in -50..50i32, x in -1.0f32..1.0, y in -1.0f32..1.0) {
            let rays: [Ray; 8] = core::array::from_fn(|i| {
                let off = i as f32 / 256.0;
                let (origin, direction) = ([x, off, 0.5], [y + off, y, 1.5]);
                Ray::new(origin.map(|x| x * power_of_two(size)), direction.map(|x| x * power_of_two(length)))
            });
            prop_assert_eq!(prepared(&rays, -size).members, 0xff);
        }
    }
}
