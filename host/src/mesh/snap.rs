//! Snapping of vertices to a lattice.

use super::{Mesh, MeshError};
use crate::parallel::prelude::*;
use slimbvh_core::Aabb;
use slimbvh_core::bounds::scene_exponent;
use slimbvh_core::encode::FINEST_STEP;
use slimbvh_core::float::{PowerOfTwo, scale_by_power_of_two};
use slimbvh_core::lattice::to_lattice;
use slimbvh_core::snap::snap;

/// The largest coordinate in steps of the lattice. Floats represent all integers up to it, and differences have the right
/// exponent.
const MOST_STEPS: i32 = (1 << 24) - 1;

impl Mesh {
    /// The exponent of the finest lattice step that vertices can be moved to: at most 2^−24 of the scene's size. The mesh
    /// must be sound.
    #[must_use]
    pub fn finest_step(&self) -> i32 {
        let bounds = self.bounds().unwrap_or(Aabb::EMPTY);
        FINEST_STEP - scene_exponent(&bounds)
    }

    /// Moves every vertex to the nearest lattice point, at most half a step along each axis, and returns the largest
    /// distance moved. The step is 2 to this power; steps finer than [`Self::finest_step`] move nothing. Vertices at the
    /// same position stay together. The mesh must be sound.
    pub fn snap(&mut self, step_exponent: i32) -> f32 {
        let step_exponent = step_exponent.max(self.finest_step());
        let mut largest = 0.0f32;
        for vertex in &mut self.vertices {
            // Unused vertices may have any value.
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

    /// Checks that all corners lie on the lattice whose step is 2 to this power, as they are stored: too small a coordinate is 0
    /// ([`snap`]).
    pub(crate) fn check_lattice(&self, step_exponent: i32) -> Result<(), MeshError> {
        let inverse = 2f64.powi(-step_exponent);
        let is_on = |vertex: &[f32; 3]| vertex.iter().all(|&x| is_on_lattice(x, inverse));
        if self.vertices.par_iter().all(is_on) {
            return Ok(());
        }
        let bounds = self.bounds().unwrap_or(Aabb::EMPTY);
        let scale = PowerOfTwo::new(scene_exponent(&bounds));
        let is_stored_on = |vertex: [f32; 3]| {
            let is_zero = |x: f32| snap(x, &scale) == 0.0;
            let mut all = vertex.into_iter();
            all.all(|x| is_zero(x) || is_on_lattice(x, inverse))
        };
        // Unused vertices may have any value.
        for (face, corners) in self.indices.iter().enumerate() {
            for &corner in corners {
                let vertex = self.vertices[corner as usize];
                if !is_stored_on(vertex) {
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

/// Whether `x` is a whole number of steps, at most [`MOST_STEPS`]. `inverse` is the number of steps in a unit.
fn is_on_lattice(x: f32, inverse: f64) -> bool {
    // Exact: a double holds any float times a power of two.
    let steps = f64::from(x) * inverse;
    let whole = steps as i32;
    f64::from(whole) == steps && whole.unsigned_abs() <= MOST_STEPS.unsigned_abs()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn mesh(vertices: &[[f32; 3]]) -> Mesh {
        Mesh {
            vertices: vertices.to_vec(),
            indices: vec![[0, 1, 2]],
            ..Mesh::default()
        }
    }

    proptest! {
        #[test]
        fn what_snapping_leaves_in_place_is_on_the_lattice(
            x in prop_oneof![any::<f32>(), -20f32..20.0, (-300i32..300).prop_map(|i| i as f32 / 16.0)],
            step_exponent in -6i32..6,
        ) {
            let most = f64::from(MOST_STEPS) * 2f64.powi(step_exponent);
            let expected = f64::from(x.abs()) <= most && snapped(x, step_exponent) == x;
            prop_assert_eq!(is_on_lattice(x, 2f64.powi(-step_exponent)), expected);
        }
    }

    /// A coordinate that is 0 in the tree is on every lattice. Negative control: the next larger one.
    #[test]
    fn what_is_stored_as_zero_is_on_the_lattice() {
        let corners = |x| mesh(&[[x, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        assert_eq!(corners(7.17e-43).check_lattice(-23), Ok(()));
        assert_eq!(corners(-1e-40).check_lattice(0), Ok(()));
        assert!(corners(4.0 * f32::MIN_POSITIVE).check_lattice(-23).is_err());
    }

    /// A magnitude of −2^31 steps does not exist as a signed integer and once passed the bound.
    #[test]
    fn the_smallest_integer_is_too_many_steps() {
        for (x, is_on) in [
            (-2f32.powi(31), false),
            (2f32.powi(31), false),
            (-2f32.powi(20), true),
        ] {
            let corners = [[x, 0.0, 0.0], [0.0; 3], [0.0, 1.0, 0.0]];
            assert_eq!(is_on_lattice(x, 1.0), is_on, "{x}");
            assert_eq!(mesh(&corners).check_lattice(0).is_ok(), is_on, "{x}");
        }
    }

    #[test]
    fn vertices_go_to_the_nearest_point() {
        let mut mesh = mesh(&[
            [0.3, -0.3, 5.0],
            [1.13, 0.12, -2.38],
            [0.0, 0.125, 7.9],
            [f32::NAN; 3],
        ]);
        let moved = mesh.snap(-2);
        assert_eq!(
            mesh.vertices[..3],
            [[0.25, -0.25, 5.0], [1.25, 0.0, -2.5], [0.0, 0.25, 8.0]]
        );
        let largest = (0.125f32.powi(2) + 0.1f32.powi(2)).sqrt();
        assert!((moved - largest.max(0.2088)).abs() < 2e-3, "{moved}");
        assert!(mesh.check_lattice(-2).is_ok() && mesh.check_lattice(-1).is_err());
    }

    #[test]
    fn the_finest_lattice_moves_what_floats_hardly_tell() {
        let corners = [[1.0, 2.0, 3.0], [1.5, 1e-9, 0.1], [3.999, 0.7, 0.3]];
        let mut snapped = mesh(&corners);
        let finest = snapped.finest_step();
        assert_eq!(finest, -22);
        let moved = snapped.snap(-200);
        assert!(moved <= 0.87 * 2f32.powi(-22), "{moved}");
        assert!(snapped.check_lattice(finest).is_ok());
        assert_eq!(snapped.vertices[0], corners[0]);
    }

    #[test]
    fn the_largest_numbers_stay_finite() {
        let mut largest = mesh(&[[f32::MAX, 0.0, 0.0], [0.0, -f32::MAX, 0.0], [0.0; 3]]);
        let step_exponent = largest.finest_step() + 5;
        largest.snap(step_exponent);
        assert!(largest.validate().is_ok());
        assert!(largest.check_lattice(step_exponent).is_ok());
        let mut smallest = mesh(&[
            [f32::from_bits(5), 0.0, 0.0],
            [0.0, f32::from_bits(3), 0.0],
            [0.0; 3],
        ]);
        let finest = smallest.finest_step();
        let before = smallest.clone();
        smallest.snap(finest);
        assert_eq!(smallest, before);
        assert!(smallest.check_lattice(finest).is_ok());
    }
}
