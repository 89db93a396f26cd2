//! Stage `bounds`: the box around all triangles, and the power of two that carries the scene to magnitude 1.

use crate::geometry::aabb::Aabb;
use crate::geometry::float::{exponent, magnitude_bits, order_key};
use crate::geometry::triangle::{IndexedTriangles, Triangle};
use glam::Vec3;

/// One lane per run of triangles. Reads the triangles `first..first + count`. Returns the box around them.
#[inline]
#[must_use]
pub fn run_bounds(first: u32, count: u32, triangles: &IndexedTriangles) -> Aabb {
    let mut bounds = Aabb::EMPTY;
    for i in first..first + count {
        let Triangle { v0, v1, v2 } = triangles.triangle(i);
        let (a, b) = (Aabb { min: v0, max: v0 }, Aabb { min: v1, max: v1 });
        let c = Aabb { min: v2, max: v2 };
        // Each triangle's box first: none has to wait for the one before.
        bounds = unite(bounds, unite(unite(a, b), c));
    }
    Aabb {
        min: positive_zeros(bounds.min),
        max: positive_zeros(bounds.max),
    }
}

/// Replaces −0 by 0, so that the order of unions does not matter.
#[inline]
pub(crate) fn positive_zeros(v: Vec3) -> Vec3 {
    let positive = |x: f32| if magnitude_bits(x) == 0 { 0.0 } else { x };
    Vec3::new(positive(v.x), positive(v.y), positive(v.z))
}

/// [`Aabb::union`] of boxes in the caller's unit, where coordinates may be what some devices take for zero as they compare it.
#[inline(always)]
#[must_use]
pub fn unite(a: Aabb, b: Aabb) -> Aabb {
    if !cfg!(target_arch = "spirv") {
        return a.union(b);
    }
    let min = |x: f32, y: f32| if order_key(x) < order_key(y) { x } else { y };
    let max = |x: f32, y: f32| if order_key(x) > order_key(y) { x } else { y };
    Aabb {
        min: Vec3::new(
            min(a.min.x, b.min.x),
            min(a.min.y, b.min.y),
            min(a.min.z, b.min.z),
        ),
        max: Vec3::new(
            max(a.max.x, b.max.x),
            max(a.max.y, b.max.y),
            max(a.max.z, b.max.z),
        ),
    }
}

/// Workgroup reduction, one lane per box: at each step with `distance` = LANES/2 … 1 every lane below `distance`
/// stores this. Lane 0 ends with the union of all. Returns the lane's new box.
#[inline(always)]
#[must_use]
pub fn reduce_step<const LANES: usize>(lane: u32, distance: u32, boxes: &[Aabb; LANES]) -> Aabb {
    let own = boxes[lane as usize % LANES];
    let other = boxes[(lane + distance) as usize % LANES];
    unite(own, other)
}

/// The exponent e for which the largest magnitude of a coordinate times `2^e` lies in `[1/2, 1)`; 0 where all are zero.
#[inline]
#[must_use]
pub fn scene_exponent(bounds: &Aabb) -> i32 {
    if bounds.is_empty() {
        return 0;
    }
    let largest = axis_magnitude(bounds, 0)
        .max(axis_magnitude(bounds, 1))
        .max(axis_magnitude(bounds, 2));
    if largest > 0 {
        -(exponent(f32::from_bits(largest)) + 1)
    } else {
        0
    }
}

/// The bits of the largest magnitude of a coordinate on one axis.
#[inline]
pub(crate) fn axis_magnitude(bounds: &Aabb, axis: usize) -> u32 {
    let (low, high) = match axis {
        0 => (bounds.min.x, bounds.max.x),
        1 => (bounds.min.y, bounds.max.y),
        _ => (bounds.min.z, bounds.max.z),
    };
    magnitude_bits(low).max(magnitude_bits(high))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn boxed(min: [f32; 3], max: [f32; 3]) -> Aabb {
        Aabb {
            min: Vec3::from_array(min),
            max: Vec3::from_array(max),
        }
    }

    #[test]
    fn scene_is_carried_below_one() {
        assert_eq!(
            scene_exponent(&boxed([-3.0, 0.0, 0.0], [1.0, 2.0, 0.5])),
            -2
        );
        assert_eq!(scene_exponent(&boxed([0.0; 3], [0.75, 0.5, 0.25])), 0);
        assert_eq!(scene_exponent(&boxed([0.0; 3], [1.0, 0.5, 0.25])), -1);
        assert_eq!(scene_exponent(&boxed([0.0; 3], [0.0; 3])), 0);
        assert_eq!(scene_exponent(&Aabb::EMPTY), 0);
    }

    proptest! {
        #[test]
        fn reduction_in_steps_is_the_union(points in proptest::array::uniform8(proptest::array::uniform3(-9.0f32..9.0))) {
            let mut boxes = points.map(|p| boxed(p, p));
            let expected = boxes.iter().fold(Aabb::EMPTY, |a, &b| a.union(b));
            let mut distance = 4;
            while distance > 0 {
                let before = boxes;
                for lane in 0..distance {
                    boxes[lane as usize] = reduce_step(lane, distance, &before);
                }
                distance /= 2;
            }
            prop_assert_eq!(boxes[0], expected);
        }
    }
}
