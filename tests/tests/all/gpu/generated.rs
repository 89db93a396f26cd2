//! Both backends give the same pictures of generated meshes (camera, trace, shade, view and resolve, with thousands of samples a
//! dispatch), and sort, sum and compact random words to the same results.

use super::pictures::{VIEWS, of_cpu, of_gpu};
use proptest::prelude::*;
use slimbvh::gpu::{Compact, Gpu, Keys, Scan, Sort, wgpu};
use slimbvh::{RenderSettings, Scene};
use slimbvh_tests::cases;
use slimbvh_tests::gpu::{done, gpu};
use slimbvh_tests::parity::{alike, same_bits};
use slimbvh_tests::strategies::any_mesh;

/// One sample in a hundred may graze an edge that the other backend misses by its last bits.
const SHARE: f64 = 1e-2;

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn pictures_of_any_mesh_are_those_of_the_cpu(mesh in any_mesh(), view in 0usize..5, spp in 1u32..4) {
        let Some(gpu) = gpu() else { return Ok(()) };
        let settings = RenderSettings {
            size: [64, 48],
            sample_count: spp,
            view: VIEWS[view],
            ..RenderSettings::default()
        };
        let mut scene = Scene { mesh, ..Scene::default() };
        scene.complete(scene.mesh.bounds(), settings.size);
        let ((a, _), (b, _)) = (of_gpu(gpu, &scene, &settings), of_cpu(&scene, &settings));
        let result = alike(&a, &b, SHARE, u8::MAX);
        prop_assert!(result.is_ok(), "{result:?}");
    }

    #[test]
    fn any_words_are_sorted_summed_and_compacted_as_by_the_cpu(words in proptest::collection::vec(prop_oneof![any::<u32>(), 0u32..3], 1..6000)) {
        let Some(gpu) = gpu() else { return Ok(()) };
        // Numbered, so that an unstable sort is noticed.
        let items: Vec<[u32; 2]> = words.iter().copied().zip(0..).map(|(key, i)| [key, i]).collect();
        let mut sorted = items.clone();
        sorted.sort_by_key(|item| item[0]);
        let mut sum = 0u32;
        let sums: Vec<u32> = words.iter().map(|word| { sum = sum.wrapping_add(*word); sum.wrapping_sub(*word) }).collect();
        let set: Vec<u32> = (0..32 * words.len() as u32).filter(|i| words[*i as usize / 32] >> (i % 32) & 1 == 1).collect();

        let buffer = |bytes: &[u8]| filled(gpu, bytes);
        let item_buffer = buffer(bytemuck::cast_slice(&items));
        let (values, bits) = (buffer(bytemuck::cast_slice(&words)), buffer(bytemuck::cast_slice(&words)));
        let indices = buffer(&vec![0; 128 * words.len()]);
        let totals = [buffer(&[0; 16]), buffer(&[0; 16])];
        let mut frame = gpu.frame();
        done(Sort::new().encode(&mut frame, Keys::OneWord, item_buffer.slice(..)));
        done(Scan::new().encode(&mut frame, values.slice(..), totals[0].slice(..)));
        done(Compact::new().encode(&mut frame, bits.slice(..), indices.slice(..), totals[1].slice(..)));
        let reads = [&item_buffer, &values, &indices, &totals[0], &totals[1]].map(|b| done(frame.read_later(b.slice(..))));
        done(frame.submit());
        let [items, values, indices, total, count] = reads.map(|read| done(read.read::<u32>(gpu)));
        prop_assert_eq!(same_bits(&items, bytemuck::cast_slice::<_, u32>(&sorted)), Ok(()));
        prop_assert_eq!(same_bits(&values, &sums), Ok(()));
        prop_assert_eq!(total[0], sum);
        prop_assert_eq!(count[0] as usize, set.len());
        prop_assert_eq!(same_bits(&indices[..set.len()], &set), Ok(()));
        // The negative control: one flipped bit is found.
        let mut other = sums.clone();
        other[0] ^= 1;
        prop_assert!(same_bits(&values, &other).is_err());
    }
}

/// A buffer with this content.
fn filled(gpu: &Gpu, bytes: &[u8]) -> wgpu::Buffer {
    let buffer = gpu.device().create_buffer(&wgpu::BufferDescriptor {
        label: Some("words"),
        size: bytes.len() as u64,
        usage: wgpu::BufferUsages::STORAGE
            | wgpu::BufferUsages::COPY_SRC
            | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    gpu.queue().write_buffer(&buffer, 0, bytes);
    buffer
}
