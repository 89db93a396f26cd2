//! Vertices on a lattice of the scene.

use super::{Mesh, MeshError};
use slimbvh_core::Aabb;
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::float::scale_by_power_of_two;
use slimbvh_core::lattice::to_lattice;

/// Coordinates are at most this many steps of the lattice: what floats count without gaps.
const MOST_STEPS: i32 = 1 << 24;

impl Mesh {
    /// The finest lattice that vertices can be moved to: its step is 2 to this power, a 2^24th of the scene's size or less.
    /// The mesh must be sound.
    #[must_use]
    pub fn finest_step(&self) -> i32 {
        let bounds = self.bounds().unwrap_or(Aabb::EMPTY);
        -24 - scene_exponent(&bounds)
    }

    /// Moves every vertex to the nearest point of the lattice whose step is 2 to this power, at most half a step along each
    /// axis. Vertices at the same place stay together. Steps finer than [`Self::finest_step`] move nothing. The mesh must be
    /// sound. Returns the largest distance that a vertex moved.
    pub fn snap(&mut self, step_exponent: i32) -> f32 {
        let step_exponent = step_exponent.max(self.finest_step());
        let mut largest = 0.0f32;
        for vertex in &mut self.vertices {
            // Those that no face uses may be anything.
            if !vertex.iter().all(|x| x.is_finite()) {
                continue;
            }
            let moved = vertex.map(|x| snapped(x, step_exponent));
            let offsets = [0, 1, 2].map(|axis| f64::from(moved[axis]) - f64::from(vertex[axis]));
            let distance = offsets.iter().map(|d| d * d).sum::<f64>().sqrt();
            largest = largest.max(distance as f32);
            *vertex = moved;
        }
        largest
    }

    /// Whether all corners lie on the lattice whose step is 2 to this power.
    pub(crate) fn check_lattice(&self, step_exponent: i32) -> Result<(), MeshError> {
        for (face, corners) in self.indices.iter().enumerate() {
            for &corner in corners {
                let vertex = self.vertices[corner as usize];
                if vertex.iter().any(|&x| !is_on_lattice(x, step_exponent)) {
                    let [x, y, z] = vertex;
                    return Err(MeshError::OffLattice {
                        face,
                        vertex: corner,
                        x,
                        y,
                        z,
                        step_exponent,
                    });
                }
            }
        }
        Ok(())
    }
}

fn snapped(x: f32, step_exponent: i32) -> f32 {
    if x.abs() >= scale_by_power_of_two(1.0, step_exponent + 29) {
        return x;
    }
    let steps = to_lattice(x, step_exponent);
    let moved = scale_by_power_of_two(steps as f32, step_exponent);
    if moved.is_finite() {
        moved
    } else {
        scale_by_power_of_two((steps - steps.signum()) as f32, step_exponent)
    }
}

fn is_on_lattice(x: f32, step_exponent: i32) -> bool {
    let is_far = x.abs() > scale_by_power_of_two(MOST_STEPS as f32, step_exponent);
    !is_far && snapped(x, step_exponent) == x
}
