//! Hills.

use super::ground::height_field;
use super::random::mix;
use super::smooth_normals;
use crate::Mesh;

/// An open height field of `size` a side around the origin: `2 * cells * cells` triangles that face up, smooth normals,
/// heights from 0 to `size / 5`. Six octaves of value noise.
#[must_use]
pub fn terrain(size: f32, cells: u32, seed: u64) -> Mesh {
    let mut mesh = height_field(size, cells, |x, z| {
        0.2 * size * fractal_noise(x / size + 0.5, z / size + 0.5, seed)
    });
    smooth_normals(&mut mesh);
    mesh
}

/// Noise from 0 to 1 over the unit square: each octave has half the wavelength and half the height of the one before.
fn fractal_noise(x: f32, z: f32, seed: u64) -> f32 {
    let (mut sum, mut total) = (0.0, 0.0);
    for octave in 0..6 {
        let (frequency, weight) = ((4 << octave) as f32, 0.5_f32.powi(octave));
        sum += weight * value_noise(frequency * x, frequency * z, mix(seed ^ octave as u64));
        total += weight;
    }
    sum / total
}

/// Random values from 0 to 1 at integer coordinates, interpolated smoothly.
fn value_noise(x: f32, z: f32, seed: u64) -> f32 {
    let value = |x: f32, z: f32| {
        let cell = (x as u64) << 32 | z as u64;
        (mix(seed ^ mix(cell)) >> 40) as f32 / (1 << 24) as f32
    };
    let fade = |t: f32| t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    let mix = |a: f32, b: f32, t: f32| a + t * (b - a);
    let (left, back) = (x.floor(), z.floor());
    let (u, v) = (fade(x - left), fade(z - back));
    mix(
        mix(value(left, back), value(left + 1.0, back), u),
        mix(value(left, back + 1.0), value(left + 1.0, back + 1.0), u),
        v,
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::analyze;
    use crate::generate::checks::assert_unit_normals;

    #[test]
    fn open_hills_that_face_up() {
        let mesh = terrain(10.0, 32, 7);
        assert_eq!(mesh.validate(), Ok(()));
        assert_unit_normals(&mesh);
        assert!(mesh.normals.iter().all(|normal| normal[1] > 0.0));
        let analysis = analyze(&mesh);
        assert_eq!(analysis.components.len(), 1);
        let component = &analysis.components[0];
        assert_eq!(component.triangle_count, 2 * 32 * 32);
        assert!(!component.closed && component.consistently_wound);
        let (min, max) = (component.bounds.min[1], component.bounds.max[1]);
        assert!(0.0 <= min && min + 0.5 < max && max <= 2.0);
    }

    #[test]
    fn a_seed_gives_one_terrain() {
        assert_eq!(terrain(10.0, 8, 7), terrain(10.0, 8, 7));
        assert_ne!(terrain(10.0, 8, 7), terrain(10.0, 8, 8));
    }

    #[test]
    fn refining_the_grid_keeps_the_hills() {
        let (coarse, fine) = (terrain(10.0, 4, 7), terrain(10.0, 8, 7));
        assert_eq!(coarse.vertices[2 * 5 + 1], fine.vertices[4 * 9 + 2]);
    }
}
