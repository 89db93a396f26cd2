//! Vectors in f64, so that closed forms share no arithmetic with the library.

use std::ops::{Add, Mul, Neg, Sub};

/// A vector or a color.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wide {
    pub x: f64,
    pub y: f64,
    pub z: f64,
}

/// The vector with these components.
pub const fn wide(x: f64, y: f64, z: f64) -> Wide {
    Wide { x, y, z }
}

impl From<[f32; 3]> for Wide {
    fn from(v: [f32; 3]) -> Self {
        let [x, y, z] = v.map(f64::from);
        wide(x, y, z)
    }
}

impl Wide {
    pub const ZERO: Self = wide(0.0, 0.0, 0.0);

    pub fn narrow(self) -> [f32; 3] {
        [self.x, self.y, self.z].map(|x| x as f32)
    }

    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    pub fn cross(self, other: Self) -> Self {
        wide(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    pub fn length(self) -> f64 {
        self.dot(self).sqrt()
    }

    pub fn normalize(self) -> Self {
        self * (1.0 / self.length())
    }

    /// The largest difference of a component.
    pub fn farthest(self, other: Self) -> f64 {
        let d = self - other;
        d.x.abs().max(d.y.abs()).max(d.z.abs())
    }
}

impl Add for Wide {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        wide(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl Sub for Wide {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Wide {
    type Output = Self;
    fn neg(self) -> Self {
        self * -1.0
    }
}

impl Mul<f64> for Wide {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        wide(self.x * factor, self.y * factor, self.z * factor)
    }
}

impl Mul for Wide {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        wide(self.x * other.x, self.y * other.y, self.z * other.z)
    }
}
