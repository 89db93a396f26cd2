//! What a surface is made of, and which way a path goes on from it.

use crate::shade::surface::{Surface, normalize};
use bytemuck::{Pod, Zeroable};
use glam::Vec3;

/// How a surface reflects, and what passes through it. 32 bytes.
///
/// A path does one thing at a surface: through glass (`transmission` above 0) it goes on bent by Snell's law, or mirrored
/// inside where that has no answer (total internal reflection); else at a mirror it is mirrored; else it ends. Nothing is
/// drawn at random, and so glass never reflects from outside. The front of a triangle is the outside of the glass.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Material {
    /// Bytes 0–11: linear RGB, each 0 to 1. Of glass, also the share of each channel that passes a surface.
    pub base_color: [f32; 3],
    /// Bytes 12–15: share reflected as by a mirror, 0 to 1. Of glass it does not count.
    pub mirror: f32,
    /// Bytes 16–19: share that passes through, 0 to 1; above 0 for glass.
    pub transmission: f32,
    /// Bytes 20–23: index of refraction behind the front side, as a multiple of that before it. Above 0.
    pub ior: f32,
    /// Bytes 24–31: unused.
    pub padding: [u32; 2],
}

const _: () = assert!(size_of::<Material>() == 32);

/// Where a path goes on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Onward {
    /// Off the surface, on the side that it goes to.
    pub origin: Vec3,
    /// Not of unit length.
    pub direction: Vec3,
}

impl Material {
    /// The share of the light that goes on; what is left is reflected to all sides (Lambert).
    #[inline]
    #[must_use]
    pub fn onward_share(&self) -> f32 {
        if self.is_glass() {
            self.transmission
        } else {
            self.mirror
        }
    }

    /// The share of each channel that goes on.
    #[inline]
    #[must_use]
    pub fn onward_color(&self) -> Vec3 {
        if self.is_glass() {
            Vec3::from_array(self.base_color) * self.transmission
        } else {
            Vec3::splat(self.mirror)
        }
    }

    /// Whether paths pass through.
    #[inline]
    #[must_use]
    pub fn is_glass(&self) -> bool {
        self.transmission > 0.0
    }

    /// Where a path of this direction goes on, if any of it does ([`Self::onward_share`]).
    #[must_use]
    pub fn onward(&self, surface: &Surface, direction: Vec3) -> Onward {
        if self.is_glass() {
            let into = if surface.side > 0.0 {
                1.0 / self.ior
            } else {
                self.ior
            };
            let bent = bent(surface, normalize(direction), into);
            if bent.dot(surface.normal) < 0.0 {
                return Onward {
                    origin: surface.enter(),
                    direction: bent,
                };
            }
        }
        Onward {
            origin: surface.leave(),
            direction: mirrored(surface, direction),
        }
    }
}

/// A reflection. About a smooth normal it may point into the triangle; then it is about the triangle's own.
#[inline]
fn mirrored(surface: &Surface, direction: Vec3) -> Vec3 {
    let mirrored = reflect(direction, surface.shading_normal);
    if mirrored.dot(surface.normal) > 0.0 {
        mirrored
    } else {
        reflect(direction, surface.normal)
    }
}

#[inline]
fn reflect(direction: Vec3, normal: Vec3) -> Vec3 {
    direction - normal * (2.0 * direction.dot(normal))
}

/// Snell's law for a unit vector; `eta` is the index before the surface divided by that behind it. Zero where there is no
/// answer. Bent about a smooth normal it may point out of the triangle; then it is bent about the triangle's own.
#[inline]
fn bent(surface: &Surface, direction: Vec3, eta: f32) -> Vec3 {
    let bent = direction.refract(surface.shading_normal, eta);
    if bent.dot(surface.normal) > 0.0 {
        direction.refract(surface.normal, eta)
    } else {
        bent
    }
}

#[cfg(test)]
mod tests;
