//! A box test for many rays at once: where it fails, each of them misses the box.
//!
//! For an axis let a ray's near plane be that which it meets first, at `(plane − origin)·inverse`. Over rays whose inverses
//! have one sign, the extreme origin makes the difference least (or largest, where inverses are negative), and one of both
//! extreme inverses makes the product least. Rounding is monotone: the rounded difference and the rounded product of
//! extremes bound those of each ray, to the last bit. The same goes for the far plane, and for minimum, maximum and the
//! padding's sum behind them ([`crossings`](crate::geometry::slab)). So no epsilon is needed. An axis on which signs differ rejects
//! nothing.

use super::wide::WideFork;
use crate::geometry::lanes::{Lanes, Wide};
use crate::geometry::planes::BoxSpan;
use crate::geometry::ray::RayLanes;
use crate::geometry::slab::{FourPlanes, SLAB_PADDING};
use core::array::from_fn;
use glam::Vec4;

/// What bounds rays, axis by axis in their order.
#[derive(Clone, Copy, Debug)]
pub(super) struct RayInterval {
    axes: [AxisInterval; 3],
    t_min: f32,
}

#[derive(Clone, Copy, Debug)]
struct AxisInterval {
    /// The extreme origin for the planes that are met first, and for the others.
    origins: [f32; 2],
    /// The smallest inverse and the largest.
    inverse: [f32; 2],
    /// Whether upper planes are met first.
    is_reversed: bool,
    /// Whether signs differ.
    is_mixed: bool,
}

/// Extremes of several rays in lanes, to be joined with those of others.
#[derive(Clone, Copy, Debug)]
pub(super) struct RayExtremes<W> {
    /// Of the origins for lower planes, of those for upper ones, and of inverses: the smallest and the largest.
    axes: [[[W; 2]; 3]; 3],
    t_min: W,
}

/// The numbers of members, and one of theirs in other lanes.
#[inline(always)]
fn of_members<W: Wide<LANES>, const LANES: usize>(numbers: W, members: u32) -> W {
    if members == u32::MAX >> (32 - LANES) {
        return numbers;
    }
    let numbers = numbers.to_array();
    let other = numbers[members.trailing_zeros() as usize % LANES];
    W::from_array(from_fn(|i| match members >> i & 1 {
        1 => numbers[i],
        _ => other,
    }))
}

impl<W: Lanes> RayExtremes<W> {
    /// Of the lanes that are members.
    #[inline(always)]
    pub fn of<const LANES: usize>(rays: &RayLanes<BoxSpan<W>>, members: u32) -> Self
    where
        W: Wide<LANES>,
    {
        let axis = |i: usize| {
            let BoxSpan { low, high } = rays.plane_origins[i];
            let number = |numbers: W| [of_members(numbers, members); 2];
            [number(low), number(high), number(rays.inverse[i])]
        };
        Self {
            axes: [axis(0), axis(1), axis(2)],
            t_min: of_members(rays.t_min, members),
        }
    }

    /// Of both.
    #[inline(always)]
    pub fn with(&self, other: &Self) -> Self {
        let axis = |i: usize| {
            let number = |j: usize| {
                let ([a, b], [c, d]) = (self.axes[i][j], other.axes[i][j]);
                [a.least(c), b.most(d)]
            };
            [number(0), number(1), number(2)]
        };
        Self {
            axes: [axis(0), axis(1), axis(2)],
            t_min: self.t_min.least(other.t_min),
        }
    }

    /// The bounds of all these rays.
    #[inline(always)]
    pub fn interval<const LANES: usize>(&self) -> RayInterval
    where
        W: Wide<LANES>,
    {
        let least = |numbers: W| {
            let numbers = numbers.to_array();
            numbers.iter().fold(f32::MAX, |a, &b| a.min(b))
        };
        let most = |numbers: W| -least(-numbers);
        let axis = |i: usize| {
            let [low, high, inverse] = self.axes[i];
            let inverse = [least(inverse[0]), most(inverse[1])];
            let is_reversed = inverse[1] < 0.0;
            AxisInterval {
                origins: match is_reversed {
                    true => [least(high[0]), most(low[1])],
                    false => [most(low[1]), least(high[0])],
                },
                inverse,
                is_reversed,
                is_mixed: inverse[0] < 0.0 && !is_reversed,
            }
        };
        RayInterval {
            axes: [axis(0), axis(1), axis(2)],
            t_min: least(self.t_min),
        }
    }
}

impl AxisInterval {
    /// No ray passes the near planes earlier than the first, nor the far ones later than the second.
    #[inline(always)]
    fn crossed(&self, low: Vec4, high: Vec4) -> [Vec4; 2] {
        let (near, far) = if self.is_reversed {
            (high, low)
        } else {
            (low, high)
        };
        let [near, far] = [
            near - Vec4::splat(self.origins[0]),
            far - Vec4::splat(self.origins[1]),
        ];
        let [a, b] = self.inverse;
        let (near, far) = ((near * a).min(near * b), (far * a).max(far * b));
        if self.is_mixed {
            [Vec4::splat(f32::MIN), Vec4::splat(f32::MAX)]
        } else {
            [near, far]
        }
    }
}

impl RayInterval {
    /// Tests a wide node's boxes. Returns a bit for each that a ray may meet no later than the limit, and where none enters earlier.
    #[inline(always)]
    pub fn meet<P: FourPlanes>(&self, node: &WideFork<P>, limit: f32) -> (u32, Vec4) {
        let axis = |i: usize| {
            let (low, high) = (node.first[i].planes(), node.second[i].planes());
            self.axes[i].crossed(low, high)
        };
        let [[a, d], [b, e], [c, f]] = [axis(0), axis(1), axis(2)];
        let enter = a.max(b).max(c).max(Vec4::splat(self.t_min));
        let exit = d.min(e).min(f) + f.max(-c) * SLAB_PADDING;
        let met = enter.cmple(exit.min(Vec4::splat(limit)));
        // A lane without a child has its planes exchanged.
        let there = node.first[0].planes().cmple(node.second[0].planes());
        (met.bitmask() & there.bitmask(), enter)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::lanes::Each;
    use crate::geometry::ray::Ray;
    use crate::trace::packet::box_entries;
    use crate::trace::prepare::PreparedRays;
    use proptest::array::{uniform3, uniform4};
    use proptest::prelude::*;

    type Rays = PreparedRays<Each<8>, 8>;

    fn prepared(rays: &[Ray; 8]) -> Rays {
        let mut prepared = Rays::EMPTY;
        prepared.prepare(rays, 0);
        prepared
    }

    fn interval(rays: &Rays, members: u32) -> RayInterval {
        RayExtremes::of(&rays.lanes, members).interval()
    }

    /// A node whose boxes have these corners.
    fn node(boxes: [[[f32; 3]; 2]; 4], axes: [u32; 3]) -> WideFork<Vec4> {
        let side = |pick: fn(f32, f32) -> f32| {
            axes.map(|axis| {
                let axis = axis as usize;
                Vec4::from_array(boxes.map(|[a, b]| pick(a[axis], b[axis])))
            })
        };
        WideFork {
            first: side(f32::min),
            second: side(f32::max),
            node: 0,
            count: 4,
        }
    }

    /// Whether a lane that is a member meets a box, and where.
    fn met_by(rays: &Rays, node: &WideFork<Vec4>, child: usize, limit: f32) -> (u32, [f32; 8]) {
        let of = |planes: [Vec4; 3]| planes.map(|planes| planes.to_array()[child]);
        let limit = Each([limit; 8]);
        let (enter, met) = box_entries(&rays.lanes, limit, of(node.first), of(node.second));
        (met, enter.0)
    }

    /// Rays side by side, some along an axis or against the others.
    fn rays() -> impl Strategy<Value = [Ray; 8]> {
        let number = || prop_oneof![1 => Just(0.0f32), 1 => Just(-0.0), 6 => -1.0f32..1.0];
        let offsets = proptest::collection::vec([uniform3(number()), uniform3(number())], 8);
        let end = prop_oneof![Just(f32::MAX), 0.0f32..4.0];
        (
            uniform3(number()),
            uniform3(number()),
            -24..2i32,
            offsets,
            end,
        )
            .prop_map(|(origin, direction, spread, offsets, t_max)| {
                from_fn(|i| {
                    let by = |base: [f32; 3], off: [f32; 3]| {
                        let scale = crate::geometry::float::power_of_two(spread);
                        [0, 1, 2].map(|axis| base[axis] + off[axis] * scale)
                    };
                    let [from, way] = offsets[i];
                    Ray {
                        t_max,
                        ..Ray::new(by(origin, from), by(direction, way))
                    }
                })
            })
    }

    fn boxes() -> impl Strategy<Value = [[[f32; 3]; 2]; 4]> {
        let number = || prop_oneof![1 => Just(0.0f32), 6 => -1.0f32..1.0];
        uniform4([uniform3(number()), uniform3(number())])
    }

    proptest! {
        /// The law: no ray meets a box that the interval misses, and none enters one earlier than the interval says.
        #[test]
        fn an_interval_misses_only_what_all_rays_miss(rays in rays(), boxes in boxes(), limit in prop_oneof![Just(f32::MAX), -1.0f32..4.0]) {
            let rays = prepared(&rays);
            let node = node(boxes, rays.axes);
            let (met, enters) = interval(&rays, rays.members).meet(&node, limit);
            for child in 0..4 {
                let (who, enter) = met_by(&rays, &node, child, limit);
                let who = who & rays.members;
                prop_assert!(who == 0 || met >> child & 1 == 1, "{child} {who:b}");
                for (i, &enter) in enter.iter().enumerate() {
                    if who >> i & 1 == 1 {
                        prop_assert!(enters.to_array()[child] <= enter);
                    }
                }
            }
        }
    }

    /// The negative control: an interval that leaves a ray out misses what that ray meets.
    #[test]
    fn a_ray_that_is_left_out_is_missed() {
        let ray = |i: usize| Ray::new([i as f32 / 256.0, 0.0, -1.0], [0.0, 0.0, 1.0]);
        let rays = prepared(&from_fn(ray));
        assert_eq!(rays.members, 0xff);
        let [x, y] = [6.5 / 256.0, 7.5 / 256.0];
        let own = [[x, -1.0, 0.0], [y, 1.0, 0.5]];
        let node = node([own; 4], rays.axes);
        assert_eq!(met_by(&rays, &node, 0, 9.0).0, 0x80);
        assert_eq!(interval(&rays, 0xff).meet(&node, 9.0).0, 0xf);
        assert_eq!(interval(&rays, 0x7f).meet(&node, 9.0).0, 0);
        assert_eq!(
            interval(&rays, 0xff).meet(&node, 0.5).0,
            0,
            "beyond the limit"
        );
    }
}
