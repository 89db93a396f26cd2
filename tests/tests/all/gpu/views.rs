//! Kernels from samples to pixels, each alone: words equal those of core's function to the bit, colors within a millionth.

use super::kernels::groups;
use super::shading::{Lit, close_words};
use bytemuck::{bytes_of, cast_slice};
use slimbvh::gpu::{Gpu, Kernel};
use slimbvh_core::color::{pack_texel, srgb_bytes};
use slimbvh_core::shade::{Path, mean_radiance};
use slimbvh_core::tile::Tiles;
use slimbvh_core::view::{
    depth_range, depth_value, heat_range, mean_depth_color, mean_heat_color, normal_color,
    primitive_color,
};
use slimbvh_core::{Hit, Vec3};
use slimbvh_tests::gpu::{Dispatch, answers, done, gpu};
use slimbvh_tests::parity::same_bits;
use slimbvh_tests::random::Random;

/// Runs a kernel with one thread for each of `count` items and one output.
fn run(gpu: &Gpu, kernel: Kernel, uniforms: &[&[u32]], reads: &[&[u8]], output: &[u8]) -> Vec<u8> {
    let count = match kernel {
        Kernel::view_depth_range | Kernel::view_heat_range => 1,
        _ => 1 << 16,
    };
    let dispatch = Dispatch {
        kernel,
        group_count: groups(count),
        uniforms,
        reads,
        outputs: &[output],
    };
    dispatch.run(gpu).concat()
}

/// The layout of pictures in memory: rows of 21 pixels in 64 texels, taken in tiles; the first three pixels belong to an
/// earlier wave.
const WIDTH: u32 = 21;
const ROW: u32 = 64;
const FIRST: u32 = 3;

/// The picture's tiles, where this many pixels follow the first three. The last band has as few rows as hold them.
fn tiles(pixel_count: u32) -> Tiles {
    Tiles {
        width: WIDTH,
        height: (FIRST + pixel_count).div_ceil(WIDTH),
    }
}

/// `params` of the kernels that write the picture.
fn params(samples: u32, pixel_count: u32) -> [u32; 4] {
    let Tiles { width, height } = tiles(pixel_count);
    [samples, width, height, FIRST]
}

/// The picture with these pixels written over its earlier content.
fn picture(pixel_count: u32, color: impl Fn(u32) -> Vec3) -> (Vec<[f32; 4]>, Vec<[f32; 4]>) {
    let tiles = tiles(pixel_count);
    let before = vec![[9.0; 4]; (tiles.height * ROW) as usize];
    let mut after = before.clone();
    for pixel in 0..pixel_count {
        let [x, y] = tiles.pixel(FIRST + pixel);
        after[(y * ROW + x) as usize] = color(pixel).extend(1.0).to_array();
    }
    (before, after)
}

#[test]
fn colors_of_normals_and_primitives_are_those_of_core() {
    let Some(gpu) = gpu() else { return };
    for lit in Lit::all() {
        let colored = |color: &dyn Fn(&Path, &Hit) -> Vec3| -> Vec<Path> {
            let paths = lit.paths.iter().zip(&lit.hits);
            let paths = paths.map(|(path, hit)| match hit.is_hit() {
                true => path.with_light(color(path, hit)),
                false => *path,
            });
            paths.collect()
        };
        let normals = colored(&|path, hit| normal_color(lit.surface(path, hit).0.shading_normal));
        let primitives = colored(&|_, hit| primitive_color(hit.primitive));
        let [vertices, indices, mesh_normals] = lit.mesh();
        let (hits, paths) = (cast_slice(&lit.hits), cast_slice(&lit.paths));
        let reads = [vertices, indices, mesh_normals, hits];
        let stored = run(gpu, Kernel::view_normals, &[&lit.exponent()], &reads, paths);
        done(close_words(&stored, &normals));
        assert!(close_words(&stored, &primitives).is_err());
        let stored = run(gpu, Kernel::view_primitives, &[], &[hits], paths);
        done(close_words(&stored, &primitives));
    }
}

#[test]
fn depths_and_their_scale_are_those_of_core() {
    let Some(gpu) = gpu() else { return };
    for lit in Lit::all() {
        let values: Vec<u32> = lit.hits.iter().map(depth_value).collect();
        let nothing = vec![0; 4 * values.len()];
        let hits = cast_slice(&lit.hits);
        let stored = run(gpu, Kernel::view_depth_values, &[], &[hits], &nothing);
        done(same_bits(&answers::<u32>(&stored), &values));
        let mut items: Vec<[u32; 2]> = values
            .iter()
            .copied()
            .zip(0..)
            .map(<[u32; 2]>::from)
            .collect();
        let nothing = vec![0; 8 * values.len()];
        let stored = run(
            gpu,
            Kernel::view_items,
            &[],
            &[cast_slice(&values)],
            &nothing,
        );
        done(same_bits(&answers::<[u32; 2]>(&stored), &items));

        items.sort_unstable();
        let range = depth_range(&items);
        let stored = run(
            gpu,
            Kernel::view_depth_range,
            &[],
            &[cast_slice(&items)],
            &[0; 16],
        );
        done(same_bits(
            &answers::<u32>(&stored),
            &[range[0], range[1], 0, 0],
        ));
        check_means(gpu, Kernel::view_depth, range, &values, |samples, pixel| {
            mean_depth_color(&values, pixel * samples, samples, range)
        });
    }
}

#[test]
fn counts_and_their_scale_are_those_of_core() {
    let Some(gpu) = gpu() else { return };
    let mut random = Random::new(3);
    for count in [1, 999, 1000, 5000] {
        let values: Vec<u32> = (0..count).map(|_| random.below(90) as u32).collect();
        let mut items: Vec<[u32; 2]> = values
            .iter()
            .copied()
            .zip(0..)
            .map(<[u32; 2]>::from)
            .collect();
        items.sort_unstable();
        let most = heat_range(&items);
        let stored = run(
            gpu,
            Kernel::view_heat_range,
            &[],
            &[cast_slice(&items)],
            &[0; 16],
        );
        done(same_bits(&answers::<u32>(&stored), &[most, 0, 0, 0]));
        check_means(
            gpu,
            Kernel::view_heat,
            [most, 0],
            &values,
            |samples, pixel| mean_heat_color(&values, pixel * samples, samples, most),
        );
    }
}

/// Paints values for several numbers of samples a pixel; the value depends on the number and the pixel.
fn check_means(
    gpu: &Gpu,
    kernel: Kernel,
    range: [u32; 2],
    values: &[u32],
    color: impl Fn(u32, u32) -> Vec3,
) {
    for samples in [1, 3, 16] {
        let pixels = values.len() as u32 / samples;
        let (before, after) = picture(pixels, |pixel| color(samples, pixel));
        let uniforms: [&[u32]; 2] = [&[range[0], range[1], 0, 0], &params(samples, pixels)];
        let stored = run(
            gpu,
            kernel,
            &uniforms,
            &[cast_slice(values)],
            cast_slice(&before),
        );
        done(close_words(&stored, &after));
        assert!(pixels == 0 || close_words(&stored, &before).is_err());
    }
}

#[test]
fn pixels_are_the_means_of_core() {
    let Some(gpu) = gpu() else { return };
    let mut random = Random::new(9);
    let path = |_| Path {
        radiance: random.point().abs().to_array(),
        ..Path::default()
    };
    let paths: Vec<Path> = (0..6000).map(path).collect();
    for samples in [1, 4, 7, 300] {
        let pixels = paths.len() as u32 / samples;
        let mean = |pixel| mean_radiance(&paths, pixel * samples, samples);
        let (before, after) = picture(pixels, mean);
        let params: &[u32] = &params(samples, pixels);
        let reads = [cast_slice(&paths)];
        let stored = run(
            gpu,
            Kernel::camera_resolve,
            &[params],
            &reads,
            cast_slice(&before),
        );
        done(close_words(&stored, &after));
        let off = picture(pixels, |pixel| mean(pixel) + 1e-5).1;
        assert!(close_words(&stored, &off).is_err());
    }
}

#[test]
fn bytes_of_colors_are_those_of_core_or_next_to_them() {
    let Some(gpu) = gpu() else { return };
    let mut colors: Vec<[f32; 4]> = (0..30_000)
        .map(|i| i as f32 / 29_000.0)
        .map(|x| [x, x * x, 1.0 - x, 1.0])
        .collect();
    colors.extend([
        [-1.0, 1e30, 0.0, 1.0],
        [f32::MAX, -0.0, f32::MIN_POSITIVE, 1.0],
    ]);
    for order in [0u32, 1] {
        let params: &[u32] = &[order, 0, 0, 0];
        let nothing = vec![0; 4 * colors.len()];
        let reads = [cast_slice(&colors)];
        let stored = run(gpu, Kernel::camera_encode, &[params], &reads, &nothing);
        let mut different = 0;
        for (color, texel) in colors.iter().zip(stored.chunks(4)) {
            let [r, g, b] = srgb_bytes(Vec3::new(color[0], color[1], color[2]));
            let expected = if order == 0 { [r, g, b] } else { [b, g, r] };
            let expected = pack_texel(expected).to_le_bytes();
            let off = texel.iter().zip(expected).map(|(a, b)| a.abs_diff(b)).max();
            assert!(
                off.is_some_and(|off| off <= 1),
                "{color:?}: {texel:?} and {expected:?}"
            );
            different += usize::from(texel != expected);
        }
        assert!(different < colors.len() / 100, "{different} texels differ");
        // The other order swaps red and blue.
        let swapped = &stored[4 * 5000..];
        let [r, _, b] = srgb_bytes(Vec3::from_slice(&colors[5000]));
        let first = if order == 0 { r } else { b };
        assert!(u32::from(swapped[0]).abs_diff(first) <= 1 && r.abs_diff(b) > 9);
    }
    assert_eq!(bytes_of(&pack_texel([1, 2, 3])), [1, 2, 3, 255]);
}
