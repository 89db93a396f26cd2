//! Rays against all triangles, decided exactly: without a tree, without culling, without rounding.
//!
//! Doubles decide where their result is certain. Otherwise the same expressions are computed as [`ExactSum`]s. The boxes of
//! runs of triangles skip only triangles that no exact test could hit.

use super::exact_sum::ExactSum;
use slimbvh_core::Ray;
use std::cmp::Ordering;

/// The number of triangles per box.
const RUN: usize = 32;

/// If doubles do not yield t with this relative precision, it is computed exactly.
const T_SHARE: f64 = 1e-10;

/// A number, and a bound of its error.
#[derive(Clone, Copy, Debug)]
struct Estimate {
    value: f64,
    error: f64,
}

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug)]
pub struct Crossing {
    /// The index of the triangle.
    pub primitive: u32,
    /// In units of the direction, with a relative error of at most 10^-10.
    pub t: f64,
    /// A bound of the error of `t`.
    t_error: f64,
    /// The ray and the triangle that determine t.
    ray: Ray,
    corners: [[f32; 3]; 3],
}

/// All triangles of a scene, by index.
#[derive(Clone, Debug)]
pub struct Unculled {
    triangles: Vec<[[f32; 3]; 3]>,
    /// The minimum and the maximum of each run.
    boxes: Vec<[[f64; 3]; 2]>,
}

impl Unculled {
    /// The triangles must have finite corners.
    #[must_use]
    pub fn new(triangles: Vec<[[f32; 3]; 3]>) -> Self {
        let bounds = |run: &[[[f32; 3]; 3]]| {
            let mut bounds = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
            for corner in run.as_flattened() {
                for axis in 0..3 {
                    let x = f64::from(corner[axis]);
                    bounds[0][axis] = bounds[0][axis].min(x);
                    bounds[1][axis] = bounds[1][axis].max(x);
                }
            }
            bounds
        };
        let boxes = triangles.chunks(RUN).map(bounds).collect();
        Self { triangles, boxes }
    }

    /// The corners of a triangle.
    #[must_use]
    pub fn triangle(&self, primitive: u32) -> [[f32; 3]; 3] {
        self.triangles[primitive as usize]
    }

    /// All triangles.
    #[must_use]
    pub fn triangles(&self) -> &[[[f32; 3]; 3]] {
        &self.triangles
    }

    /// The number of triangles.
    #[must_use]
    pub fn count(&self) -> usize {
        self.triangles.len()
    }

    /// The triangles that a ray meets in its range, except `skip`, in the order of (t, index). Edges and corners belong to a
    /// triangle, and both ends to the range. A ray in the plane of a triangle never meets it. The ray must be finite; a
    /// `t_max` of `f32::MAX` or infinity is no limit.
    #[must_use]
    pub fn crossings(&self, ray: &Ray, skip: u32) -> Vec<Crossing> {
        let mut crossings = Vec::new();
        for (run, bounds) in self.boxes.iter().enumerate() {
            if !may_meet(ray, bounds) {
                continue;
            }
            let first = run * RUN;
            let last = self.triangles.len().min(first + RUN);
            for (corners, primitive) in self.triangles[first..last].iter().zip(first as u32..) {
                if primitive != skip {
                    crossings.extend(cross(ray, corners, primitive));
                }
            }
        }
        crossings.sort_by(Crossing::compare);
        crossings
    }

    /// Whether a ray faces a triangle's front (1) or back (−1), even if it misses; 0 if it is parallel to the triangle.
    #[must_use]
    pub fn facing(&self, ray: &Ray, primitive: u32) -> i32 {
        let [x, y, z] = exact_volumes(ray, &self.triangle(primitive));
        -x.plus(&y).plus(&z).sign()
    }

    /// Whether a ray meets a triangle in its range, as in [`Self::crossings`]: the answer to a shadow ray.
    #[must_use]
    pub fn is_met(&self, ray: &Ray) -> bool {
        !self.crossings(ray, u32::MAX).is_empty()
    }
}

impl Crossing {
    /// Orders by t, then by index.
    #[must_use]
    pub fn compare(&self, other: &Self) -> Ordering {
        self.compare_t(other)
            .then(self.primitive.cmp(&other.primitive))
    }

    /// Orders by t, exactly.
    #[must_use]
    pub fn compare_t(&self, other: &Self) -> Ordering {
        if (self.t - other.t).abs() > 2.0 * (self.t_error + other.t_error) {
            return self.t.total_cmp(&other.t);
        }
        let [a, b] = exact_t(&self.ray, &self.corners);
        let [c, d] = exact_t(&other.ray, &other.corners);
        a.times(&d).compare(&c.times(&b))
    }
}

/// Intersects a ray with one triangle.
fn cross(ray: &Ray, corners: &[[f32; 3]; 3], primitive: u32) -> Option<Crossing> {
    let origin = ray.origin.map(f64::from);
    let direction = ray.direction.map(f64::from);
    let [a, b, c] = corners.map(|p| [0, 1, 2].map(|axis| f64::from(p[axis]) - origin[axis]));

    // Volumes of the tetrahedra that the direction spans with each edge.
    let volumes = [
        volume(direction, b, c),
        volume(direction, c, a),
        volume(direction, a, b),
    ];
    let is_front = volumes.iter().any(|volume| volume.value > volume.error);
    let is_back = volumes.iter().any(|volume| volume.value < -volume.error);
    if is_front && is_back {
        return None;
    }
    let hit = |t, t_error| Crossing {
        primitive,
        t,
        t_error,
        ray: *ray,
        corners: *corners,
    };

    // t = n · a / n · d, with the normal from the sides: the error does not grow with the distance of the origin.
    let [e, f] = [1, 2]
        .map(|i| [0, 1, 2].map(|axis| f64::from(corners[i][axis]) - f64::from(corners[0][axis])));
    let (over, under) = (volume(a, e, f), volume(direction, e, f));
    let is_certain = |volume: &Estimate| volume.value.abs() > volume.error;
    if volumes.iter().all(is_certain) && under.error < 0.5 * under.value.abs() {
        let t = over.value / under.value;
        let t_error = (over.error + t.abs() * under.error) / (under.value.abs() - under.error)
            + 4.0 * f64::EPSILON * t.abs();
        let [low, high] = limits(ray);
        if t < low - t_error || t > high + t_error {
            return None;
        } else if t > low + t_error && t < high - t_error && t_error <= T_SHARE * t.abs() {
            return Some(hit(t, t_error));
        }
    }

    let signs = exact_volumes(ray, corners).map(|volume| volume.sign());
    let is_inside = signs.iter().all(|&sign| sign >= 0) || signs.iter().all(|&sign| sign <= 0);
    if !is_inside || signs == [0; 3] {
        return None;
    }
    let [over, under] = exact_t(ray, corners);
    let [low, high] = limits(ray);
    let is_within = |limit: f64, side: Ordering| {
        let at_limit = under.times(&ExactSum::difference(limit, 0.0));
        limit.is_infinite() || over.compare(&at_limit) != side
    };
    if !is_within(low, Ordering::Less) || !is_within(high, Ordering::Greater) {
        return None;
    }
    let t = over.value() / under.value();
    Some(hit(t, 4.0 * f64::EPSILON * t.abs()))
}

/// The minimum and the maximum of t.
fn limits(ray: &Ray) -> [f64; 2] {
    let is_limit = ray.t_max < f32::MAX;
    let high = if is_limit {
        ray.t_max.into()
    } else {
        f64::INFINITY
    };
    [ray.t_min.into(), high]
}

/// `u · (v × w)`, with at most ten roundings in sequence, differences included.
fn volume(u: [f64; 3], v: [f64; 3], w: [f64; 3]) -> Estimate {
    let (mut value, mut magnitude) = (0.0, 0.0);
    for (x, y, z) in AXES {
        let (positive, negative) = (v[y] * w[z], v[z] * w[y]);
        value += u[x] * (positive - negative);
        magnitude += u[x].abs() * (positive.abs() + negative.abs());
    }
    Estimate {
        value,
        error: 8.0 * f64::EPSILON * magnitude,
    }
}

const AXES: [(usize, usize, usize); 3] = [(0, 1, 2), (1, 2, 0), (2, 0, 1)];

type ExactVector = [ExactSum; 3];

fn exact_corners(ray: &Ray, corners: &[[f32; 3]; 3]) -> [ExactVector; 3] {
    corners.map(|p| {
        [0, 1, 2].map(|axis| ExactSum::difference(f64::from(p[axis]), f64::from(ray.origin[axis])))
    })
}

/// [`volume`] without rounding.
fn exact_volume(u: &ExactVector, v: &ExactVector, w: &ExactVector) -> ExactSum {
    let parts = AXES.map(|(x, y, z)| u[x].times(&v[y].times(&w[z]).minus(&v[z].times(&w[y]))));
    let [x, y, z] = parts;
    x.plus(&y).plus(&z)
}

/// The volumes that the direction spans with each edge, without rounding.
fn exact_volumes(ray: &Ray, corners: &[[f32; 3]; 3]) -> [ExactSum; 3] {
    let [a, b, c] = exact_corners(ray, corners);
    let direction = ray
        .direction
        .map(|x| ExactSum::difference(f64::from(x), 0.0));
    [(&b, &c), (&c, &a), (&a, &b)].map(|(v, w)| exact_volume(&direction, v, w))
}

/// t as a fraction with a positive denominator. The ray must meet the triangle's plane in a point.
fn exact_t(ray: &Ray, corners: &[[f32; 3]; 3]) -> [ExactSum; 2] {
    let [a, b, c] = exact_corners(ray, corners);
    let over = exact_volume(&a, &b, &c);
    let [x, y, z] = exact_volumes(ray, corners);
    let under = x.plus(&y).plus(&z);
    if under.sign() < 0 {
        let nothing = ExactSum::default();
        [nothing.clone().minus(&over), nothing.minus(&under)]
    } else {
        [over, under]
    }
}

/// False only if the ray certainly misses the box. The slack is a thousand times the error of a few roundings.
fn may_meet(ray: &Ray, [low, high]: &[[f64; 3]; 2]) -> bool {
    const SLACK: f64 = 1e-12;
    let [mut enter, mut exit] = limits(ray);
    enter -= SLACK * enter.abs();
    exit += SLACK * exit.abs();
    for axis in 0..3 {
        let (origin, direction) = (f64::from(ray.origin[axis]), f64::from(ray.direction[axis]));
        if direction == 0.0 {
            if origin < low[axis] || origin > high[axis] {
                return false;
            }
            continue;
        }
        let (a, b) = (
            (low[axis] - origin) / direction,
            (high[axis] - origin) / direction,
        );
        let slack = SLACK * (a.abs() + b.abs());
        enter = enter.max(a.min(b) - slack);
        exit = exit.min(a.max(b) + slack);
    }
    enter <= exit
}

#[cfg(test)]
mod tests;
