//! Prefix sums and compaction of any size.

use super::SIZES;
use slimbvh::gpu::{Compact, Gpu, Scan};
use slimbvh_core::launch::{GROUPS_PER_ROW, LANES, dispatch, scan_block_count, scan_run};
use slimbvh_tests::gpu::{contents, done, gpu, storage};
use slimbvh_tests::parity::same_bits;
use slimbvh_tests::random::Random;

/// Random words of 32 bits, so that sums wrap.
fn words(count: u32, seed: u64) -> Vec<u32> {
    let mut random = Random::new(seed);
    (0..count).map(|_| random.bits() as u32).collect()
}

/// The sum, and the dispatch of this number of threads.
fn total(sum: u32) -> [u32; 4] {
    let [x, y, z] = dispatch(sum.div_ceil(LANES as u32));
    [sum, x, y, z]
}

fn check_scan(gpu: &Gpu, scan: &mut Scan, values: &[u32]) -> Result<(), String> {
    let (buffer, end) = (storage(gpu, values), storage(gpu, &[0u32; 4]));
    let mut frame = gpu.frame();
    done(scan.encode(&mut frame, buffer.slice(..), end.slice(..)));
    done(frame.submit());
    let mut sum = 0u32;
    let mut expected = Vec::with_capacity(values.len());
    for value in values {
        expected.push(sum);
        sum = sum.wrapping_add(*value);
    }
    same_bits(&contents::<u32>(gpu, &buffer), &expected)?;
    same_bits(&contents::<u32>(gpu, &end), &total(sum))
}

fn check_compact(gpu: &Gpu, compact: &mut Compact, bits: &[u32]) -> Result<(), String> {
    let set: Vec<u32> = (0..32 * bits.len() as u32)
        .filter(|i| bits[*i as usize / 32] >> (i % 32) & 1 == 1)
        .collect();
    // The place after the last result is unchanged.
    let room = vec![7u32; set.len() + 1];
    let (bits, indices) = (storage(gpu, bits), storage(gpu, &room));
    let sum = storage(gpu, &[0u32; 4]);
    let mut frame = gpu.frame();
    let slices = (bits.slice(..), indices.slice(..), sum.slice(..));
    done(compact.encode(&mut frame, slices.0, slices.1, slices.2));
    done(frame.submit());
    let count = set.len() as u32;
    same_bits(&contents::<u32>(gpu, &indices), &[set, vec![7]].concat())?;
    same_bits(&contents::<u32>(gpu, &sum), &total(count))
}

#[test]
fn scans_of_any_size_are_prefix_sums() {
    let Some(gpu) = gpu() else { return };
    let mut scan = Scan::new();
    for count in SIZES {
        for values in [words(count, 5), vec![1; count as usize]] {
            let result = check_scan(gpu, &mut scan, &values);
            assert_eq!(result, Ok(()), "{count} values");
        }
    }
}

/// At the borders of one block, of one block sum a lane, and of as many blocks as there may be.
#[test]
fn scans_at_the_borders_of_their_blocks_are_prefix_sums() {
    let Some(gpu) = gpu() else { return };
    let mut scan = Scan::new();
    let [block, most] = [scan_run(1) * LANES as u32, 1 << 20];
    assert_eq!([block, block + 1].map(scan_block_count), [1, 2]);
    assert_eq!(scan_run(most) + 1, scan_run(most + 1));
    let borders = [block, 65 * block, 66 * block, most, 2 * most];
    for count in borders.into_iter().flat_map(|n| [n - 1, n, n + 1]) {
        let result = check_scan(gpu, &mut scan, &words(count, 6));
        assert_eq!(result, Ok(()), "{count} values");
    }
}

#[test]
fn compactions_of_any_size_list_the_set_bits() {
    let Some(gpu) = gpu() else { return };
    let mut compact = Compact::new();
    for count in SIZES.map(|count| count.min(2500)) {
        let sparse = words(count, 1).into_iter().zip(words(count, 2));
        let sparse = sparse.map(|(a, b)| a & b & a.rotate_left(7)).collect();
        for bits in [
            words(count, 3),
            sparse,
            vec![0; count as usize],
            vec![!0; count as usize],
        ] {
            let result = check_compact(gpu, &mut compact, &bits);
            assert_eq!(result, Ok(()), "{count} words");
        }
    }
}

#[test]
fn dispatches_of_several_rows_reach_every_item() {
    let Some(gpu) = gpu() else { return };
    // More items than threads in a row of workgroups, for kernels with one thread an item.
    let row = GROUPS_PER_ROW * LANES as u32;
    let bits = words(row / 32 + 70, 4);
    assert_eq!(check_compact(gpu, &mut Compact::new(), &bits), Ok(()));
}

#[test]
fn one_flipped_bit_is_found() {
    let Some(gpu) = gpu() else { return };
    let mut bits = words(100, 8);
    done(check_compact(gpu, &mut Compact::new(), &bits));
    let (before, sum) = (storage(gpu, &bits), storage(gpu, &[0u32; 4]));
    let scanned = |buffer| {
        let mut frame = gpu.frame();
        done(Scan::new().encode(&mut frame, buffer, sum.slice(..)));
        done(frame.submit());
    };
    scanned(before.slice(..));
    bits[50] ^= 1 << 31;
    let after = storage(gpu, &bits);
    scanned(after.slice(..));
    let (before, after) = (contents::<u32>(gpu, &before), contents::<u32>(gpu, &after));
    assert!(same_bits(&before, &after).is_err());
    assert!(same_bits(&before[..=50], &after[..=50]).is_ok());
}
