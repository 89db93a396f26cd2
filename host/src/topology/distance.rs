//! Whether a ball is clear of a triangle.

use crate::analysis::seen_from;

/// Whether every point of the triangle is certainly further from `center` than `radius`. Triangles of zero area are
/// segments or points. May be `false` for a ball that is clear by less than 10^-7 of the triangle's distance and size.
pub(super) fn is_clear(center: [f64; 3], radius: f64, corners: [[f32; 3]; 3]) -> bool {
    let corners = seen_from(center, corners);
    let lengths = corners.map(length);
    let margin = 1e-8 * (lengths[0] + lengths[1] + lengths[2]);
    let needed = radius + margin;

    // Most triangles are far away: no point is nearer than a corner's distance minus the longest side.
    let sides = [0, 1, 2].map(|i| minus(corners[(i + 1) % 3], corners[i]));
    let sizes = sides.map(length);
    let longest = sizes[0].max(sizes[1]).max(sizes[2]);
    if lengths[0] - longest > needed {
        return true;
    }
    let to_border = (0..3)
        .map(|i| distance_to_segment(corners[i], sides[i]))
        .fold(f64::INFINITY, f64::min);
    if to_border <= needed || !to_border.is_finite() {
        return false;
    }

    // A point inside a triangle is at most the triangle's height away from the border.
    let normal = cross(sides[0], sides[1]);
    let area = length(normal);
    let height = area / longest;
    if to_border - height > needed {
        return true;
    }
    if height <= 1e-6 * longest {
        return false;
    }
    let is_beside = (0..3).any(|i| {
        let outward = cross(sides[i], normal);
        dot(outward, corners[i]) < -1e-8 * sizes[i] * area * lengths[i]
    });
    is_beside || dot(normal, corners[0]).abs() / area > needed
}

/// The distance of the origin from a segment.
fn distance_to_segment(start: [f64; 3], side: [f64; 3]) -> f64 {
    let squared = dot(side, side);
    let t = if squared > 0.0 {
        (-dot(start, side) / squared).clamp(0.0, 1.0)
    } else {
        0.0
    };
    length([0, 1, 2].map(|axis| start[axis] + t * side[axis]))
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const TRIANGLE: [[f32; 3]; 3] = [[1.0, 0.0, 0.0], [5.0, 0.0, 0.0], [1.0, 3.0, 0.0]];

    #[test]
    fn known_distances() {
        for (center, distance) in [
            ([2.0, 1.0, 0.5], 0.5),
            ([2.0, 1.0, -7.0], 7.0),
            ([2.0, -2.0, 0.0], 2.0),
            ([-2.0, -4.0, 0.0], 5.0),
            ([8.0, 0.0, 4.0], 5.0),
        ] {
            assert!(is_clear(center, 0.999 * distance, TRIANGLE));
            assert!(!is_clear(center, 1.001 * distance, TRIANGLE));
            assert!(!is_clear(center, distance, TRIANGLE));
        }
        assert!(!is_clear([2.0, 1.0, 0.0], 0.0, TRIANGLE));
    }

    #[test]
    fn segments_and_points_are_kept_clear_of() {
        let segment = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
        assert!(is_clear([2.0, 3.0, 0.0], 2.9, segment));
        assert!(!is_clear([2.0, 3.0, 0.0], 3.1, segment));
        assert!(is_clear([0.0, 3.0, 4.0], 4.9, [[0.0; 3]; 3]));
        assert!(!is_clear([0.0, 3.0, 4.0], 5.1, [[0.0; 3]; 3]));
    }

    proptest! {
        #[test]
        fn no_point_of_a_clear_triangle_is_near(corners in proptest::array::uniform3(proptest::array::uniform3(-4i8..=4)), center in proptest::array::uniform3(-4.0f64..4.0), radius in 0.0f64..4.0, thin in any::<bool>()) {
            let mut corners = corners.map(|p| p.map(f32::from));
            if thin {
                corners[2] = [0, 1, 2].map(|i| 0.75 * corners[0][i] + 0.25 * corners[1][i] + 1e-6 * corners[2][i]);
            }
            // The nearest of many points.
            let steps = 60;
            let mut nearest = f64::INFINITY;
            for i in 0..=steps {
                for j in 0..=steps - i {
                    let weights = [i, j, steps - i - j].map(|w| f64::from(w) / f64::from(steps));
                    let p = [0, 1, 2].map(|axis| (0..3).map(|k| weights[k] * f64::from(corners[k][axis])).sum::<f64>());
                    nearest = nearest.min(length(minus(p, center)));
                }
            }
            if nearest <= radius {
                prop_assert!(!is_clear(center, radius, corners));
            } else if nearest > radius + 0.3 && !thin {
                prop_assert!(is_clear(center, radius, corners));
            }
        }
    }
}
