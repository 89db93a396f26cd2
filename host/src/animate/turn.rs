//! Turns about the vertical.

use super::anchor::Anchor;
use crate::{Camera, Light};
use std::f64::consts::TAU;

/// A turn about the vertical through a scene's middle.
#[derive(Clone, Copy, Debug)]
pub struct Turn {
    anchor: Anchor,
    sin: f64,
    cos: f64,
}

impl Turn {
    /// A counter-clockwise turn, seen from above, by a share of the full circle.
    pub fn new(anchor: Anchor, share: f64) -> Self {
        let (sin, cos) = (TAU * share).sin_cos();
        Self { anchor, sin, cos }
    }

    /// The camera after the turn.
    pub fn camera(&self, camera: &Camera) -> Camera {
        Camera {
            eye: self.point(camera.eye),
            target: self.point(camera.target),
            up: self.direction(camera.up),
            projection: camera.projection,
        }
    }

    /// The light after the turn.
    pub fn light(&self, light: &Light) -> Light {
        match *light {
            Light::Directional { direction, color } => Light::Directional {
                direction: self.direction(direction),
                color,
            },
            Light::Point {
                position,
                color,
                range,
            } => Light::Point {
                position: self.point(position),
                color,
                range,
            },
            Light::Area {
                center,
                half_edges,
                shape,
                color,
                range,
            } => Light::Area {
                center: self.point(center),
                half_edges: half_edges.map(|edge| self.direction(edge)),
                shape,
                color,
                range,
            },
        }
    }

    fn point(&self, point: [f32; 3]) -> [f32; 3] {
        let center = self.anchor.center;
        let arm = std::array::from_fn(|axis| f64::from(point[axis]) - center[axis]);
        let arm = self.turned(arm);
        std::array::from_fn(|axis| narrow(center[axis] + arm[axis]))
    }

    fn direction(&self, direction: [f32; 3]) -> [f32; 3] {
        self.turned(direction.map(f64::from)).map(narrow)
    }

    /// Turns a vector; its height stays.
    pub fn turned(&self, v: [f64; 3]) -> [f64; 3] {
        let [a, b] = self.anchor.level();
        let mut turned = v;
        turned[a] = self.cos * v[a] - self.sin * v[b];
        turned[b] = self.sin * v[a] + self.cos * v[b];
        turned
    }
}

/// The nearest `f32`; the largest one for numbers out of range.
pub fn narrow(x: f64) -> f32 {
    (x as f32).clamp(-f32::MAX, f32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    const ANCHOR: Anchor = Anchor {
        center: [1.0, 2.0, 3.0],
        vertical: 1,
        floor: 0.0,
        size: 1.0,
    };

    fn near(a: [f32; 3], b: [f32; 3]) -> bool {
        (0..3).all(|axis| (a[axis] - b[axis]).abs() < 1e-6)
    }

    #[test]
    fn a_quarter_turn_goes_from_z_to_x() {
        let turn = Turn::new(ANCHOR, 0.25);
        assert!(near(turn.point([1.0, 5.0, 7.0]), [5.0, 5.0, 3.0]));
        assert!(near(turn.direction([0.0, 5.0, 4.0]), [4.0, 5.0, 0.0]));
        let z_up = Anchor {
            vertical: 2,
            ..ANCHOR
        };
        let turn = Turn::new(z_up, 0.25);
        assert!(near(turn.point([3.0, 2.0, 7.0]), [1.0, 4.0, 7.0]));
    }

    #[test]
    fn no_turn_changes_nothing() {
        let turn = Turn::new(ANCHOR, 0.0);
        for point in [
            [0.1, 0.2, 0.3],
            [-7.7, 1e30, f32::MAX],
            [f32::MIN_POSITIVE, 0.0, -1e-30],
        ] {
            assert_eq!(turn.direction(point), point);
        }
        assert_eq!(turn.point([0.15, 2.9, 8.4]), [0.15, 2.9, 8.4]);
    }
}
