//! Exact answers on an integer grid.
//!
//! With coordinates from -7 to 7 and directions whose largest component is 1, 2 or 4, every product and sum of the
//! triangle test is a whole number below 2^24, so that floats compute it exactly. Only the divisions round.

use slimbvh_core::Ray;
use std::cmp::Ordering;

/// Three corners.
pub type GridTriangle = [[i32; 3]; 3];

/// A ray with t from 0 on.
#[derive(Clone, Copy, Debug)]
pub struct GridRay {
    /// The point at t = 0.
    pub origin: [i32; 3],
    /// The direction; its largest component must be 1, 2 or 4.
    pub direction: [i32; 3],
}

impl GridRay {
    /// The same ray in floats.
    #[must_use]
    pub fn ray(&self) -> Ray {
        Ray::new(
            self.origin.map(|x| x as f32),
            self.direction.map(|x| x as f32),
        )
    }
}

/// A fraction; the denominator is above 0.
#[derive(Clone, Copy, Debug)]
pub struct Fraction {
    /// Numerator.
    pub over: i64,
    /// Denominator.
    pub under: i64,
}

impl Fraction {
    /// The fraction as `f64`, off by at most one step.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.over as f64 / self.under as f64
    }

    /// Compares exactly.
    #[must_use]
    pub fn compare(&self, other: &Self) -> Ordering {
        let left = i128::from(self.over) * i128::from(other.under);
        left.cmp(&(i128::from(other.over) * i128::from(self.under)))
    }
}

/// The exact intersection of a ray with a triangle.
#[derive(Clone, Copy, Debug)]
pub struct ExactHit {
    /// In units of the direction.
    pub t: Fraction,
    /// Weight of the second corner.
    pub u: Fraction,
    /// Weight of the third corner.
    pub v: Fraction,
}

/// Intersects a ray with a triangle; `None` for a miss. Edges and corners count as inside. A triangle of zero area, or one
/// whose plane holds the ray, is never hit.
#[must_use]
pub fn intersect(ray: &GridRay, triangle: &GridTriangle) -> Option<ExactHit> {
    let d = ray.direction.map(i64::from);
    let [a, b, c] = triangle
        .map(|corner| [0, 1, 2].map(|axis| i64::from(corner[axis]) - i64::from(ray.origin[axis])));

    // Volumes of the tetrahedra that the direction spans with each edge.
    let volumes = [
        dot(d, cross(b, c)),
        dot(d, cross(c, a)),
        dot(d, cross(a, b)),
    ];
    let sum: i64 = volumes.iter().sum();
    let is_inside = volumes.iter().all(|&e| e >= 0) || volumes.iter().all(|&e| e <= 0);
    if !is_inside || sum == 0 {
        return None;
    }

    // n · a = n · d · t, and n · d is the sum.
    let n = cross(sub(b, a), sub(c, a));
    let t = fraction(dot(n, a), dot(n, d));
    (t.over >= 0).then(|| ExactHit {
        t,
        u: fraction(volumes[1], sum),
        v: fraction(volumes[2], sum),
    })
}

fn fraction(over: i64, under: i64) -> Fraction {
    Fraction {
        over: over * under.signum(),
        under: under.abs(),
    }
}

fn sub(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [i64; 3], b: [i64; 3]) -> i64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: GridTriangle = [[0, 0, 3], [4, 0, 3], [0, 2, 3]];

    fn shoot(origin: [i32; 3], direction: [i32; 3]) -> Option<ExactHit> {
        intersect(&GridRay { origin, direction }, &TRIANGLE)
    }

    #[test]
    fn known_hits_and_misses() {
        let hit = shoot([1, 1, 0], [0, 0, 2]).expect("it passes an inner point");
        assert_eq!(
            (hit.t.value(), hit.u.value(), hit.v.value()),
            (1.5, 0.25, 0.5)
        );
        assert!(shoot([0, 0, 0], [0, 0, 1]).is_some(), "corner");
        assert!(shoot([2, 1, 5], [0, 0, -1]).is_some(), "edge, from behind");
        assert!(shoot([3, 1, 0], [0, 0, 1]).is_none(), "beside");
        assert!(shoot([1, 1, 4], [0, 0, 1]).is_none(), "behind the origin");
        assert!(shoot([-1, 1, 3], [1, 0, 0]).is_none(), "in the plane");
    }
}
