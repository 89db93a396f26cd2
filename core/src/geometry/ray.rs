//! Rays, hits, and the form in which a ray is traced.

use crate::geometry::float::{
    INFINITY_BITS, PowerOfTwo, abs, exponent, magnitude_bits, max, normal_scaled_to_normal,
    power_of_two, scale_by_power_of_two, scale_to_normal,
};
use crate::geometry::lanes::Lanes;
use crate::geometry::planes::{PlanePair, Planes};
use bytemuck::{Pod, Zeroable};

/// A half line, or a part of one: the points `origin + t · direction` with `t_min <= t <= t_max`. 32 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Ray {
    /// Bytes 0–11: where t is 0.
    pub origin: [f32; 3],
    /// Bytes 12–15: smallest t; below 0 reaches behind the origin. Less than 2^-126 times the scene's size counts as 0.
    pub t_min: f32,
    /// Bytes 16–27: need not have unit length; t is in units of its length.
    pub direction: [f32; 3],
    /// Bytes 28–31: largest t; may be infinite.
    pub t_max: f32,
}

const _: () = assert!(size_of::<Ray>() == 32);

impl Ray {
    /// The half line from a point, t from 0 to infinity.
    #[inline]
    #[must_use]
    pub fn new(origin: [f32; 3], direction: [f32; 3]) -> Self {
        Self {
            origin,
            t_min: 0.0,
            direction,
            t_max: f32::MAX,
        }
    }

    /// The ray with an empty range, which has no hit.
    pub const EMPTY: Self = Self {
        origin: [0.0; 3],
        t_min: 1.0,
        direction: [0.0; 3],
        t_max: 0.0,
    };
}

/// Stands for no primitive: in a miss, and where none is to be excluded.
pub const NO_PRIMITIVE: u32 = u32::MAX;

/// Where a ray meets a triangle: `P = (1-u-v)·v0 + u·v1 + v·v2`. 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Hit {
    /// Bytes 0–3: in units of the direction's length; `f32::MAX` for a miss.
    pub t: f32,
    /// Bytes 4–7: weight of v1.
    pub u: f32,
    /// Bytes 8–11: weight of v2.
    pub v: f32,
    /// Bytes 12–15: the caller's index; [`NO_PRIMITIVE`] for a miss.
    pub primitive: u32,
}

const _: () = assert!(size_of::<Hit>() == 16);

impl Hit {
    /// No hit.
    pub const MISS: Self = Self {
        t: f32::MAX,
        u: 0.0,
        v: 0.0,
        primitive: NO_PRIMITIVE,
    };

    /// Whether something was hit.
    #[inline]
    #[must_use]
    pub const fn is_hit(&self) -> bool {
        self.primitive != NO_PRIMITIVE
    }
}

/// Origins farther from the scene than this many times its size see nothing.
pub const FARTHEST_ORIGIN: f32 = power_of_two(40);

/// Direction components this much smaller than the largest count as zero.
const PARALLEL: f32 = power_of_two(-60);

/// On an axis where the direction is zero, planes' origins move apart by at least this, and distances count this much:
/// the product of both is beyond any t, that of the second and [`FARTHEST_ORIGIN`] still finite.
const PARALLEL_SHIFT: f32 = power_of_two(-43);
const PARALLEL_INVERSE: f32 = power_of_two(85);

/// A ray as the tracer uses it: in the scene's magnitude, axes ordered so that the direction is longest on the last
/// one, where it lies between 1 and 2.
///
/// Two planes' origins differ only on axes where the direction is zero: there they are shifted apart, so that an origin
/// between the planes, or on one of them, is inside for every t without infinities in any product.
#[derive(Clone, Copy, Debug)]
pub struct PreparedRay {
    /// Which of x, y, z comes first, second and last.
    pub axes: [u32; 3],
    /// Origin in that order.
    pub origin: [f32; 3],
    /// Direction in that order.
    pub direction: [f32; 3],
    /// What is subtracted from a pair of boxes' planes ([`crate::geometry::slab`]).
    pub plane_origins: [PlanePair; 3],
    /// Reciprocals of the direction, finite.
    pub inverse: [f32; 3],
    /// Smallest t, in units of the prepared direction.
    pub t_min: f32,
    /// Largest t, in units of the prepared direction; below `t_min` for rays that hit nothing.
    pub t_max: f32,
    /// `t = t_prepared · 2^-t_exponent`.
    pub t_exponent: i32,
}

impl PreparedRay {
    /// Hits nothing.
    #[cfg(not(target_arch = "spirv"))]
    pub(crate) const EMPTY: Self = Self {
        axes: [0, 1, 2],
        origin: [0.0; 3],
        direction: [0.0; 3],
        plane_origins: [PlanePair::ZERO; 3],
        inverse: [0.0; 3],
        t_min: 1.0,
        t_max: 0.0,
        t_exponent: 0,
    };

    /// Carries a ray to the magnitude of a scene whose coordinates were multiplied by `2^scene_exponent`. By powers of
    /// two only: exact in the normal range. A ray with a NaN or infinite number in it (an infinite `t_max` aside), with a zero direction or an
    /// origin beyond [`FARTHEST_ORIGIN`] hits nothing.
    #[inline(always)]
    #[must_use]
    pub fn new(ray: &Ray, scene_exponent: i32) -> Self {
        let bits = Magnitudes::of(ray);
        let longest = bits.longest();
        let is_sane = bits.are_sane();

        // The longest axis comes last, so that shearing along it is well conditioned.
        let last = if bits.direction[0] == longest {
            0
        } else if bits.direction[1] == longest {
            1
        } else {
            2
        };
        let first = if last == 2 { 0 } else { last + 1 };
        let second = if first == 2 { 0 } else { first + 1 };
        let axes = [first, second, last];
        let turned = |v| [pick(v, first), pick(v, second), pick(v, last)];
        let ray = Ray {
            origin: turned(ray.origin),
            direction: turned(ray.direction),
            ..*ray
        };
        let Scaled {
            origin,
            direction,
            t_min,
            t_max,
            direction_exponent,
        } = if bits.are_ordinary(scene_exponent) {
            Scaled::of_ordinary(&ray, longest, scene_exponent)
        } else {
            Scaled::of_any(
                &ray,
                if is_sane { longest } else { 1.0f32.to_bits() },
                scene_exponent,
            )
        };
        let axis = |axis: usize| Axis::new(origin[axis], direction[axis]);
        let (a, b, c) = (axis(0), axis(1), axis(2));
        let farthest = max(max(abs(a.origin), abs(b.origin)), abs(c.origin));
        let (t_min, t_max) = if is_sane & (farthest <= FARTHEST_ORIGIN) {
            (t_min, t_max)
        } else {
            (1.0, 0.0)
        };
        let t_exponent = scene_exponent + direction_exponent;
        Self {
            axes,
            origin: [a.origin, b.origin, c.origin],
            direction: [a.direction, b.direction, c.direction],
            plane_origins: [a.plane_origins, b.plane_origins, c.plane_origins],
            inverse: [a.inverse, b.inverse, c.inverse],
            t_min,
            t_max,
            t_exponent,
        }
    }

    /// One lane.
    #[inline(always)]
    pub(crate) fn lanes(&self) -> RayLanes<PlanePair> {
        RayLanes {
            origin: self.origin,
            direction: self.direction,
            plane_origins: self.plane_origins,
            inverse: self.inverse,
            t_min: self.t_min,
        }
    }

    /// A hit's t in the caller's unit.
    #[inline]
    #[must_use]
    pub fn restore(&self, hit: Hit) -> Hit {
        restore(hit, self.t_exponent)
    }
}

/// The bits of the magnitudes of a ray's numbers. They compare as the numbers do, infinity above all, NaN above that.
struct Magnitudes {
    origin: [u32; 3],
    t_min: u32,
    direction: [u32; 3],
    t_max: u32,
}

impl Magnitudes {
    #[inline(always)]
    const fn of(ray: &Ray) -> Self {
        let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin, ray.direction);
        Self {
            origin: [magnitude_bits(ox), magnitude_bits(oy), magnitude_bits(oz)],
            t_min: magnitude_bits(ray.t_min),
            direction: [magnitude_bits(dx), magnitude_bits(dy), magnitude_bits(dz)],
            t_max: magnitude_bits(ray.t_max),
        }
    }

    /// The direction's largest.
    #[inline(always)]
    fn longest(&self) -> u32 {
        let [x, y, z] = self.direction;
        x.max(y).max(z)
    }

    /// Whether there is a direction, and no number is infinite or NaN, an infinite `t_max` aside.
    #[inline(always)]
    fn are_sane(&self) -> bool {
        let [x, y, z] = self.origin;
        let largest = self.longest().max(x).max(y).max(z).max(self.t_min);
        (largest < INFINITY_BITS) & (self.t_max <= INFINITY_BITS) & (self.longest() > 0)
    }

    /// Whether [`Scaled::of_ordinary`] holds: no number is denormal, and one factor each scales the origin and the direction.
    #[inline(always)]
    fn are_ordinary(&self, scene_exponent: i32) -> bool {
        // Zero comes out as the largest.
        let key = |bits: u32| bits.wrapping_sub(1);
        let least = |[x, y, z]: [u32; 3]| key(x).min(key(y)).min(key(z));
        let ends = key(self.t_min).min(key(self.t_max));
        let smallest = least(self.origin).min(least(self.direction)).min(ends);
        (smallest >= key(f32::MIN_POSITIVE.to_bits()))
            & (self.longest() < power_of_two(127).to_bits())
            // From −126 to 127.
            & (scene_exponent.wrapping_add(126) as u32 <= 253)
    }
}

/// A ray's numbers in the scene's magnitude, and in that of directions.
#[derive(Clone, Copy, Debug)]
struct Scaled {
    origin: [f32; 3],
    direction: [f32; 3],
    t_min: f32,
    t_max: f32,
    direction_exponent: i32,
}

impl Scaled {
    /// Of any ray. `longest` is the direction's largest magnitude, finite.
    #[inline(always)]
    fn of_any(ray: &Ray, longest: u32, scene_exponent: i32) -> Self {
        let direction_exponent = exponent(f32::from_bits(longest));
        let t_exponent = scene_exponent + direction_exponent;
        Self {
            origin: PowerOfTwo::new(scene_exponent).times_each(ray.origin),
            direction: PowerOfTwo::new(-direction_exponent).times_each(ray.direction),
            t_min: scale_to_normal(ray.t_min, t_exponent),
            t_max: scale_to_normal(ray.t_max, t_exponent),
            direction_exponent,
        }
    }

    /// [`Self::of_any`] where [`Magnitudes::are_ordinary`], on a straight way.
    #[inline(always)]
    fn of_ordinary(ray: &Ray, longest: u32, scene_exponent: i32) -> Self {
        let direction_exponent = (longest >> 23) as i32 - 127;
        let t_exponent = scene_exponent + direction_exponent;
        let (to_scene, to_unit) = (
            power_of_two(scene_exponent),
            power_of_two(-direction_exponent),
        );
        let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin, ray.direction);
        Self {
            origin: [ox * to_scene, oy * to_scene, oz * to_scene],
            direction: [dx * to_unit, dy * to_unit, dz * to_unit],
            t_min: normal_scaled_to_normal(ray.t_min, t_exponent),
            t_max: normal_scaled_to_normal(ray.t_max, t_exponent),
            direction_exponent,
        }
    }
}

/// A hit's t in the caller's unit: `t = t_prepared · 2^-t_exponent`.
#[inline(always)]
pub(crate) fn restore(hit: Hit, t_exponent: i32) -> Hit {
    if hit.is_hit() {
        Hit {
            t: clamp_t(scale_by_power_of_two(hit.t, -t_exponent)),
            ..hit
        }
    } else {
        Hit::MISS
    }
}

/// What the tests of boxes and triangles need of a prepared ray, or of several whose axes have the same order.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RayLanes<P: Planes> {
    pub origin: [P::Numbers; 3],
    pub direction: [P::Numbers; 3],
    pub plane_origins: [P; 3],
    pub inverse: [P::Numbers; 3],
    pub t_min: P::Numbers,
}

/// Keeps overflowed parameters finite, by their bits: what is no normal number stays what it is.
#[inline(always)]
fn clamp_t(t: f32) -> f32 {
    if magnitude_bits(t) >= INFINITY_BITS {
        f32::from_bits((t.to_bits() & 0x8000_0000) | f32::MAX.to_bits())
    } else {
        t
    }
}

/// One axis of prepared rays.
pub(crate) struct Axis<P: Planes> {
    pub origin: P::Numbers,
    pub direction: P::Numbers,
    pub plane_origins: P,
    pub inverse: P::Numbers,
}

impl<P: Planes<Numbers = L>, L: Lanes> Axis<P> {
    /// In the scene's magnitude, and in that of directions.
    #[inline(always)]
    pub fn new(origin: L, direction: L) -> Self {
        let is_slanted = direction.abs().at_least(L::splat(PARALLEL));
        // At least one step of the float grid to both sides.
        let step = origin.abs() * L::splat(power_of_two(-23));
        let shift = L::select(is_slanted, L::ZERO, step.max(L::splat(PARALLEL_SHIFT)));
        Self {
            origin,
            direction: L::select(is_slanted, direction, L::ZERO),
            plane_origins: P::new(origin + shift, origin - shift),
            inverse: L::select(
                is_slanted,
                L::splat(1.0) / direction,
                L::splat(PARALLEL_INVERSE),
            ),
        }
    }
}

/// A component by number, without a dynamic index or a branch.
#[inline(always)]
const fn pick(v: [f32; 3], axis: u32) -> f32 {
    let xy = if axis == 0 { v[0] } else { v[1] };
    if axis == 2 { v[2] } else { xy }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::array::uniform3;
    use proptest::prelude::*;

    /// Zeros, denormal and other small numbers, large ones, and those between; where a ray is ordinary, none is denormal.
    fn number() -> impl Strategy<Value = f32> {
        let bits = prop_oneof![
            1 => Just(0),
            1 => 1u32..0x0080_0000,
            4 => 0x0080_0000u32..0x0100_0000,
            24 => 0x0100_0000u32..0x7f00_0000,
            4 => 0x7f00_0000u32..INFINITY_BITS,
        ];
        (bits, any::<bool>()).prop_map(|(bits, sign)| f32::from_bits(bits | u32::from(sign) << 31))
    }

    fn ray() -> impl Strategy<Value = Ray> {
        let end = || prop_oneof![4 => number(), 1 => Just(f32::INFINITY)];
        (uniform3(number()), number(), uniform3(number()), end()).prop_map(
            |(origin, t_min, direction, t_max)| Ray {
                origin,
                t_min,
                direction,
                t_max,
            },
        )
    }

    fn bits(scaled: &Scaled) -> ([u32; 8], i32) {
        let ([ox, oy, oz], [dx, dy, dz]) = (scaled.origin, scaled.direction);
        let numbers = [ox, oy, oz, dx, dy, dz, scaled.t_min, scaled.t_max];
        (numbers.map(f32::to_bits), scaled.direction_exponent)
    }

    /// Both ways of a sane ray, where both hold.
    fn both(ray: &Ray, scene_exponent: i32) -> Option<[([u32; 8], i32); 2]> {
        let magnitudes = Magnitudes::of(ray);
        let longest = magnitudes.longest();
        let ways = [
            Scaled::of_ordinary(ray, longest, scene_exponent.clamp(-126, 127)),
            Scaled::of_any(ray, longest, scene_exponent),
        ];
        let is_ordinary = magnitudes.are_sane() && magnitudes.are_ordinary(scene_exponent);
        is_ordinary.then(|| ways.map(|scaled| bits(&scaled)))
    }

    proptest! {
        #[test]
        fn ordinary_rays_are_scaled_as_any(ray in ray(), scene_exponent in -150..=150i32) {
            if let Some([straight, general]) = both(&ray, scene_exponent) {
                prop_assert_eq!(straight, general);
            }
        }

        #[test]
        fn nothing_denormal_is_ordinary(ray in ray(), place in 0..8usize, denormal in 1u32..0x0080_0000) {
            let mut numbers: [f32; 8] = bytemuck::cast(ray);
            numbers[place] = f32::from_bits(denormal);
            prop_assert!(!Magnitudes::of(&bytemuck::cast(numbers)).are_ordinary(0));
        }
    }

    #[test]
    fn what_most_rays_are_is_ordinary() {
        let ray = Ray::new([0.0, -3.0, 1e-20], [0.0, 1.0, -0.5]);
        let unbounded = Ray {
            t_max: f32::INFINITY,
            ..ray
        };
        for ray in [ray, unbounded] {
            let [straight, general] = both(&ray, -3).expect("it is ordinary");
            assert_eq!(straight, general);
        }
        // Each is where the straight way would go wrong.
        for (ray, scene_exponent) in [
            (Ray::new([0.0; 3], [f32::MAX, 0.0, 0.0]), 0),
            (ray, 128),
            (ray, -127),
        ] {
            assert!(both(&ray, scene_exponent).is_none());
        }
    }
}
