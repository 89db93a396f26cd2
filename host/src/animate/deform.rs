//! Deformations of meshes.

use super::anchor::Anchor;
use super::turn::{Turn, narrow};
use crate::dvec3::{cross, dot, normalized};
use crate::parallel::prelude::*;
use std::f64::consts::TAU;

/// How a mesh deforms. Points on the scene's floor stay in place.
///
/// Both deformations are one-to-one and keep the two sides of a surface apart, so solids stay solid and face outward. Only
/// vertices move; a triangle larger than the scene's objects stays flat.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Deform {
    /// A wave passes through the scene: heights grow and shrink by an eighth.
    Wave,
    /// The scene twists about its vertical, to one side and back to the other.
    Twist,
}

/// The largest change of a height above the floor, as a share of the height.
const SWELL: f64 = 0.125;

/// The wave's direction, in the two level coordinates.
const TRAVEL: [f64; 2] = [0.6, 0.8];

/// The largest twist, in full turns at one size above the floor.
const TWIST: f64 = 0.125;

/// Vertices in a parallel task.
const BLOCK: usize = 4096;

/// A deformation at one moment.
pub trait Bend: Sync {
    /// The deformed position of a point.
    fn point(&self, p: [f64; 3]) -> [f64; 3];

    /// The deformed direction of a normal, of any length: the inverse transpose of the derivative times the normal.
    fn normal(&self, p: [f64; 3], n: [f64; 3]) -> [f64; 3];
}

impl Deform {
    /// The deformation at a moment from 0 to 1.
    pub(super) fn at(self, anchor: Anchor, moment: f64) -> Box<dyn Bend> {
        match self {
            Self::Wave => Box::new(Wave { anchor, moment }),
            Self::Twist => Box::new(Twist {
                anchor,
                most: TWIST * (TAU * moment).sin(),
            }),
        }
    }
}

/// Deforms a rest pose's vertices and normals. Unit normals stay unit, zero normals stay zero.
pub fn bend(bend: &dyn Bend, rest: &Rest, vertices: &mut [[f32; 3]], normals: &mut [[f32; 3]]) {
    let pairs = vertices.par_iter_mut().zip(&rest.vertices);
    pairs.with_min_len(BLOCK).for_each(|(to, from)| {
        *to = bend.point(from.map(f64::from)).map(narrow);
    });
    let places = rest.normals.par_iter().zip(&rest.vertices);
    let pairs = normals.par_iter_mut().zip(places);
    pairs.with_min_len(BLOCK).for_each(|(to, (normal, at))| {
        let normal = bend.normal(at.map(f64::from), normal.map(f64::from));
        *to = normalized(normal).map(narrow);
    });
}

/// Vertices and normals before deformation.
#[derive(Clone, Debug, Default)]
pub struct Rest {
    pub vertices: Vec<[f32; 3]>,
    pub normals: Vec<[f32; 3]>,
}

/// A height h above the floor becomes `h (1 + SWELL sin φ)`, where φ grows by a full turn over each `size` along the wave's
/// direction.
struct Wave {
    anchor: Anchor,
    moment: f64,
}

impl Wave {
    /// Sine and cosine of φ, and its derivatives along the two level coordinates.
    fn phase(&self, p: [f64; 3]) -> (f64, f64, [f64; 2]) {
        let [a, b] = self.anchor.level();
        let number = if self.anchor.size > 0.0 {
            TRAVEL.map(|x| TAU * x / self.anchor.size)
        } else {
            [0.0; 2]
        };
        let arm = |axis: usize| p[axis] - self.anchor.center[axis];
        let phase = number[0] * arm(a) + number[1] * arm(b) - TAU * self.moment;
        let (sin, cos) = phase.sin_cos();
        (sin, cos, number)
    }
}

impl Bend for Wave {
    fn point(&self, mut p: [f64; 3]) -> [f64; 3] {
        let (sin, ..) = self.phase(p);
        let up = self.anchor.vertical;
        p[up] += SWELL * sin * (p[up] - self.anchor.floor);
        p
    }

    /// With the displacement f and its gradient g, the derivative is `I + up gᵀ`; its inverse transpose is
    /// `I - g upᵀ / (1 + g·up)`.
    fn normal(&self, p: [f64; 3], n: [f64; 3]) -> [f64; 3] {
        let (sin, cos, number) = self.phase(p);
        let (up, [a, b]) = (self.anchor.vertical, self.anchor.level());
        let height = p[up] - self.anchor.floor;
        let mut gradient = [0.0; 3];
        gradient[up] = SWELL * sin;
        gradient[a] = SWELL * height * cos * number[0];
        gradient[b] = SWELL * height * cos * number[1];
        let share = n[up] / (1.0 + gradient[up]);
        std::array::from_fn(|axis| n[axis] - gradient[axis] * share)
    }
}

/// Turns a point about the vertical, by `most` turns at one size above the floor and proportionally less below.
struct Twist {
    anchor: Anchor,
    most: f64,
}

impl Twist {
    /// Turns for each unit of height.
    fn rate(&self) -> f64 {
        if self.anchor.size > 0.0 {
            self.most / self.anchor.size
        } else {
            0.0
        }
    }

    /// The turn at a point's height.
    fn turn(&self, p: [f64; 3]) -> Turn {
        let height = p[self.anchor.vertical] - self.anchor.floor;
        Turn::new(self.anchor, self.rate() * height)
    }

    fn arm(&self, p: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|axis| p[axis] - self.anchor.center[axis])
    }
}

impl Bend for Twist {
    fn point(&self, p: [f64; 3]) -> [f64; 3] {
        let arm = self.turn(p).turned(self.arm(p));
        std::array::from_fn(|axis| self.anchor.center[axis] + arm[axis])
    }

    /// With the turn R, the derivative is `R (I + w upᵀ)`, where w is a point's movement for each unit of height; `w·up` is
    /// 0, so its inverse transpose is `R (I - up wᵀ)`.
    fn normal(&self, p: [f64; 3], n: [f64; 3]) -> [f64; 3] {
        let mut up = [0.0; 3];
        up[self.anchor.vertical] = TAU * self.rate();
        let w = cross(up, self.arm(p));
        let mut n_before = n;
        n_before[self.anchor.vertical] -= dot(w, n);
        self.turn(p).turned(n_before)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ANCHOR: Anchor = Anchor {
        center: [1.0, 4.0, -2.0],
        vertical: 1,
        floor: 1.5,
        size: 3.0,
    };

    fn all(anchor: Anchor) -> impl Iterator<Item = (Deform, Box<dyn Bend>)> {
        [Deform::Wave, Deform::Twist]
            .into_iter()
            .flat_map(move |deform| {
                [0.0, 0.125, 0.3, 0.75].map(|moment| (deform, deform.at(anchor, moment)))
            })
    }

    /// Deformed tangents, by differences, are perpendicular to the deformed normal.
    #[test]
    fn normals_stay_across_their_surface() {
        let anchors = [0, 1, 2].map(|vertical| Anchor { vertical, ..ANCHOR });
        for (deform, bend) in anchors.into_iter().flat_map(all) {
            for p in [[2.0, 3.0, -1.0], [-4.0, 5.0, 0.25], [1.5, 1.5, 1.5]] {
                let n = [0.36, -0.48, 0.8];
                let first = normalized(cross(n, [0.0, 1.0, 0.3]));
                let second = cross(n, first);
                let moved = |tangent: [f64; 3]| -> [f64; 3] {
                    let step = |h: f64| std::array::from_fn(|i| p[i] + h * tangent[i]);
                    let (a, b) = (bend.point(step(-1e-5)), bend.point(step(1e-5)));
                    std::array::from_fn(|i| (b[i] - a[i]) / 2e-5)
                };
                let normal = normalized(bend.normal(p, n));
                let across = cross(moved(first), moved(second));
                let away = cross(first, second);
                // The orientation before and after.
                let side = dot(n, away).signum();
                let cosine = side * dot(normal, normalized(across));
                assert!(cosine > 1.0 - 1e-7, "{deform:?} at {p:?}: {cosine}");
            }
        }
    }

    #[test]
    fn the_floor_stays() {
        for (deform, bend) in all(ANCHOR) {
            let p = [7.0, 1.5, -5.0];
            let moved = bend.point(p);
            assert!(
                (0..3).all(|i| (moved[i] - p[i]).abs() < 1e-12),
                "{deform:?}"
            );
        }
        // One size from the middle along the wave, which is a full turn.
        let crest = Deform::Wave.at(ANCHOR, 0.75).point([7.0, 4.5, -5.0]);
        assert!((crest[1] - (1.5 + 3.0 * 1.125)).abs() < 1e-12, "{crest:?}");
        let valley = Deform::Wave.at(ANCHOR, 0.25).point([7.0, 4.5, -5.0]);
        assert!((valley[1] - (1.5 + 3.0 * 0.875)).abs() < 1e-12);
        let quarter = Deform::Twist.at(ANCHOR, 0.25).point([1.0, 4.5, 0.0]);
        let half = 0.5_f64.sqrt();
        assert!(
            (quarter[0] - (1.0 + 2.0 * half)).abs() < 1e-12,
            "{quarter:?}"
        );
        assert!(
            (quarter[2] - (-2.0 + 2.0 * half)).abs() < 1e-12,
            "{quarter:?}"
        );
    }

    /// A scene of size 0, in one point or in one plane, stays in place or at least finite.
    #[test]
    fn no_size_is_no_trouble() {
        let anchor = Anchor {
            size: 0.0,
            ..ANCHOR
        };
        for (_, bend) in all(anchor) {
            assert!(bend.point([1.0, 2.0, 3.0]).iter().all(|x| x.is_finite()));
            let normal = bend.normal([1.0, 2.0, 3.0], [0.0, 1.0, 0.0]);
            assert!(normal.iter().all(|x| x.is_finite()));
        }
    }
}
