//! Comparisons of the GPU's results with the CPU's.

use bytemuck::{NoUninit, bytes_of};
use slimbvh::Picture;
use slimbvh_core::Hit;
use std::fmt::Debug;

/// Checks that all bits are equal.
///
/// # Errors
/// The first difference.
pub fn same_bits<T: NoUninit + Debug>(gpu: &[T], cpu: &[T]) -> Result<(), String> {
    if gpu.len() != cpu.len() {
        return Err(format!("{} instead of {}", gpu.len(), cpu.len()));
    }
    let differs = |(a, b): (&T, &T)| bytes_of(a) != bytes_of(b);
    match gpu.iter().zip(cpu).position(differs) {
        Some(at) => Err(format!(
            "number {at} is {:?} instead of {:?}",
            gpu[at], cpu[at]
        )),
        None => Ok(()),
    }
}

/// Checks that every number differs by at most this share of it, or of `floor` if the number is smaller.
///
/// # Errors
/// The first number with a larger difference.
pub fn close(gpu: &[f32], cpu: &[f32], share: f32, floor: f32) -> Result<(), String> {
    if gpu.len() != cpu.len() {
        return Err(format!("{} instead of {}", gpu.len(), cpu.len()));
    }
    let is_close = |(a, b): (&f32, &f32)| {
        let difference = (f64::from(*a) - f64::from(*b)).abs();
        let bound = f64::from(share) * f64::from(a.abs().max(b.abs()).max(floor));
        // Equal bits are close, NaN included.
        a.to_bits() == b.to_bits() || (difference <= bound && bound.is_finite())
    };
    match gpu.iter().zip(cpu).position(|pair| !is_close(pair)) {
        Some(at) => Err(format!("number {at} is {} instead of {}", gpu[at], cpu[at])),
        None => Ok(()),
    }
}

/// The allowed relative error of a hardware GPU's t: products may be fused and reciprocals have 2.5 ULP, where the CPU
/// rounds each operation.
pub const T_SHARE: f32 = 1e-5;

/// One ray in this number may differ by more: on a grazing ray t is mostly rounding, and between triangles at one t the last
/// bit decides.
pub const GRAZING: usize = 100;

/// Checks for the same primitives at almost the same t, except for grazing rays.
///
/// # Errors
/// The first difference, if there are too many.
pub fn close_hits(gpu: &[Hit], cpu: &[Hit]) -> Result<(), String> {
    same_but_grazing(gpu, cpu, |a, b| {
        let t = close(&[a.t], &[b.t], T_SHARE, f32::MIN_POSITIVE);
        a.primitive != b.primitive || t.is_err()
    })
}

/// Checks for the same numbers, except for grazing rays.
///
/// # Errors
/// The first difference, if there are too many.
pub fn mostly_equal(gpu: &[u32], cpu: &[u32]) -> Result<(), String> {
    same_but_grazing(gpu, cpu, |a, b| a != b)
}

/// Checks that answers are as many, and that no more of them differ than rays may graze.
fn same_but_grazing<T: Debug>(
    gpu: &[T],
    cpu: &[T],
    differ: impl Fn(&T, &T) -> bool,
) -> Result<(), String> {
    if gpu.len() != cpu.len() {
        return Err(format!("{} instead of {}", gpu.len(), cpu.len()));
    }
    let different: Vec<usize> = (0..gpu.len())
        .filter(|&at| differ(&gpu[at], &cpu[at]))
        .collect();
    match different.first() {
        Some(&at) if different.len() * GRAZING > gpu.len() => Err(format!(
            "{} of {} differ, first {:?} instead of {:?}",
            different.len(),
            gpu.len(),
            gpu[at],
            cpu[at]
        )),
        _ => Ok(()),
    }
}

/// Checks that two pictures have the same size, and that at most this share of their sRGB bytes differ, each by at most
/// `most`. Returns the number of different bytes.
///
/// # Errors
/// The difference that is too large.
pub fn alike(gpu: &Picture, cpu: &Picture, share: f64, most: u8) -> Result<usize, String> {
    if (gpu.width, gpu.height) != (cpu.width, cpu.height) {
        return Err(format!(
            "{}x{} instead of {}x{}",
            gpu.width, gpu.height, cpu.width, cpu.height
        ));
    }
    let (a, b) = (gpu.to_srgb(), cpu.to_srgb());
    if a.len() != b.len() {
        return Err(format!("{} bytes instead of {}", a.len(), b.len()));
    }
    let different: Vec<usize> = (0..a.len()).filter(|&i| a[i] != b[i]).collect();
    if let Some(&at) = different.iter().find(|&&i| a[i].abs_diff(b[i]) > most) {
        let (x, y) = (at / 3 % gpu.width as usize, at / 3 / gpu.width as usize);
        return Err(format!(
            "pixel ({x}, {y}) is {:?} instead of {:?}; {} bytes differ",
            gpu.pixels[at / 3],
            cpu.pixels[at / 3],
            different.len()
        ));
    }
    if different.len() as f64 > share * a.len() as f64 {
        return Err(format!("{} of {} bytes differ", different.len(), a.len()));
    }
    Ok(different.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_flipped_bit_is_found_wherever_it_is() {
        let sound: Vec<[u32; 3]> = (0..50).map(|i| [i, i * i, 7]).collect();
        assert!(same_bits(&sound, &sound).is_ok());
        assert!(same_bits(&sound[1..], &sound).is_err());
        for place in 0..50 {
            for word in 0..3 {
                for bit in 0..32 {
                    let mut flipped = sound.clone();
                    flipped[place][word] ^= 1 << bit;
                    assert!(same_bits(&flipped, &sound).is_err());
                }
            }
        }
        assert!(same_bits(&[-0.0f32], &[0.0]).is_err());
    }

    #[test]
    fn more_differences_than_grazing_rays_explain_are_found() {
        let sound = vec![1u32; 2 * GRAZING];
        for (wrong, is_fine) in [(0, true), (2, true), (3, false)] {
            let mut other = sound.clone();
            other[7..7 + wrong].fill(0);
            assert_eq!(mostly_equal(&other, &sound).is_ok(), is_fine, "{wrong}");
        }
        assert!(mostly_equal(&sound[1..], &sound).is_err());
    }

    #[test]
    fn a_number_beyond_the_bound_is_found() {
        let sound = [0.0, 1.0, -1e20, 3e-9];
        assert!(close(&sound, &sound, 0.0, 0.0).is_ok());
        for (place, &number) in sound.iter().enumerate() {
            let off = |by: f32| {
                let mut off = sound;
                off[place] += by * number.abs().max(1e-6);
                close(&off, &sound, 1e-6, 1e-6)
            };
            assert!(off(0.5e-6).is_ok() && off(3e-6).is_err() && off(-3e-6).is_err());
            assert!(off(f32::NAN).is_err() && off(f32::INFINITY).is_err());
        }
        assert!(close(&sound[1..], &sound, 1.0, 1.0).is_err());
    }

    #[test]
    fn hits_elsewhere_are_found() {
        let sound = [Hit {
            t: 2.0,
            u: 0.25,
            v: 0.5,
            primitive: 3,
        }; 8];
        assert!(close_hits(&sound, &sound).is_ok());
        for (t, primitive) in [(2.0, 4), (2.0001, 3), (f32::NAN, 3), (f32::MAX, u32::MAX)] {
            let mut off = sound;
            off[5] = Hit {
                t,
                primitive,
                ..off[5]
            };
            assert!(close_hits(&off, &sound).is_err());
        }
        // A grazing ray among many.
        let many = [sound[0]; 200];
        let mut off = many;
        off[17].primitive = 9;
        assert!(close_hits(&off, &many).is_ok());
        off[19].t = 3.0;
        off[18].t = 3.0;
        assert!(close_hits(&off, &many).is_err());
    }

    #[test]
    fn pictures_that_differ_are_told_apart() {
        let sound = Picture {
            width: 20,
            height: 10,
            pixels: vec![[0.5, 0.25, 0.125]; 200],
        };
        assert_eq!(alike(&sound, &sound, 0.0, 0), Ok(0));
        let off = |count: usize, by: f32| {
            let mut off = sound.clone();
            for pixel in &mut off.pixels[..count] {
                pixel[1] += by;
            }
            alike(&off, &sound, 0.01, 1)
        };
        assert_eq!(off(6, 0.004), Ok(6));
        assert!(off(7, 0.004).is_err() && off(1, 0.05).is_err());
        let turned = Picture {
            width: 10,
            height: 20,
            ..sound.clone()
        };
        assert!(alike(&turned, &sound, 1.0, 255).is_err());
    }
}
