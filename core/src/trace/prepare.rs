//! Rays of a packet, prepared together: what is ordinary about them at once, each other one alone.

use crate::float::{exponent, power_of_two};
use crate::lanes::{Lanes, Wide};
use crate::ray::{Axis, FARTHEST_ORIGIN, Hit, PreparedRay, Ray, RayLanes, restore};
use crate::slab::{BoxSpan, Planes};

/// Rays whose origins or directions are farther from the first one's, on any axis, walk alone. In the scene's magnitude, whose largest
/// coordinate is at most 1, and in that of directions, whose largest component is at most 2.
const APART: f32 = 1.0 / 16.0;

/// Numbers between these, and zero, are scaled by powers of two between them without loss: an ordinary ray has no others.
const SMALLEST: f32 = power_of_two(-60);
const LARGEST: f32 = power_of_two(60);

/// Smaller numbers may be none of full precision by the next scaling.
const SMALLEST_SCALED: f32 = power_of_two(-100);

/// Several rays, as the tracer uses them. Each is what [`PreparedRay::new`] makes of it, to the bit.
#[derive(Clone, Copy)]
pub struct PreparedRays<W: Lanes, const LANES: usize> {
    /// The order of axes of those that may walk together.
    pub(super) axes: [u32; 3],
    /// Of those that may walk together.
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
    /// None yet.
    pub const NOTHING: Self = Self {
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
        alone: [PreparedRay::NOTHING; LANES],
        ready: 0,
    };

    /// [`PreparedRay::new`] of each, in the place of those that were here.
    #[inline(always)]
    pub fn prepare(&mut self, rays: &[Ray; LANES], scene_exponent: i32) {
        const { assert!(LANES <= 32, "a mask has 32 bits") };
        let [ox, oy, oz, t_min, dx, dy, dz, t_max] = W::columns(rays.map(bytemuck::cast));
        let (origin, direction) = ([ox, oy, oz], [dx, dy, dz]);

        let [dx, dy, dz] = direction.map(W::abs);
        let longest = dx.max(dy).max(dz);
        let is_x = dx.at_least(longest);
        let is_y = dy.at_least(longest) & !is_x;
        let unit = longest.power_below();
        let exponent_in_range = scene_exponent.clamp(-60, 60);
        let scale = W::splat(power_of_two(exponent_in_range));
        let [near_end, far_end] = [t_min, t_max].map(|t| scaled_end(t, scale * unit));
        let origin = origin.map(|x| (x * scale, is_ordinary(x)));
        let to_unit = W::splat(1.0) / unit;
        let direction = direction.map(|x| (x * to_unit, is_ordinary(x)));
        let is_sane = |[x, y, z]: [(W, W::Mask); 3]| x.1 & y.1 & z.1;
        let [ox, oy, oz] = origin.map(|x| x.0.abs());
        let farthest = ox.max(oy).max(oz);
        let ordinary = is_sane(origin)
            & is_sane(direction)
            & longest.at_least(W::splat(SMALLEST))
            & farthest.at_most(W::splat(FARTHEST_ORIGIN))
            & is_ordinary(t_min)
            & t_max.at_least(W::splat(0.0))
            & near_end.1
            & far_end.1;
        let ordinary = if exponent_in_range == scene_exponent {
            W::bits(ordinary)
        } else {
            0
        };

        // The first one's axes, and all who share them.
        let first = ordinary.trailing_zeros() as usize % LANES;
        let (is_x, is_y) = (W::bits(is_x), W::bits(is_y));
        let (last, alike) = if is_x >> first & 1 == 1 {
            (0, is_x)
        } else if is_y >> first & 1 == 1 {
            (1, is_y)
        } else {
            (2, !(is_x | is_y))
        };
        let alike = ordinary & alike;
        let (origin, direction) = (turned(origin, last), turned(direction, last));
        let near = near(origin.map(|x| x.0), first) & near(direction.map(|x| x.0), first);
        let axis = |i: usize| Axis::new(origin[i].0, direction[i].0);
        let [a, b, c] = [axis(0), axis(1), axis(2)];
        let (t_min, t_max) = (near_end.0, far_end.0);
        self.axes = turned([0, 1, 2], last);
        self.lanes = RayLanes {
            origin: [a.origin, b.origin, c.origin],
            direction: [a.direction, b.direction, c.direction],
            plane_origins: [a.plane_origins, b.plane_origins, c.plane_origins],
            inverse: [a.inverse, b.inverse, c.inverse],
            t_min,
        };
        self.members = alike & near & W::bits(t_min.at_most(t_max));
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

/// Whether a number of a ray is zero or neither very large nor very small.
#[inline(always)]
fn is_ordinary<W: Lanes>(x: W) -> W::Mask {
    let x = x.abs();
    x.at_most(W::splat(LARGEST)) & is_large(x, SMALLEST)
}

/// Whether a magnitude is zero or at least so large.
#[inline(always)]
fn is_large<W: Lanes>(x: W, than: f32) -> W::Mask {
    x.at_least(W::splat(than)) | x.at_most(W::splat(0.0))
}

/// An end of a ray's range times a power of two, the largest number if beyond; and whether it is exact.
#[inline(always)]
fn scaled_end<W: Lanes>(t: W, factor: W) -> (W, W::Mask) {
    let scaled = t * factor;
    let exact = is_large(t.abs(), SMALLEST) & is_large(scaled.abs(), SMALLEST_SCALED);
    let scaled = scaled.max(W::splat(f32::MIN)).min(W::splat(f32::MAX));
    (scaled, exact)
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
