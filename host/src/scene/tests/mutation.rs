//! Broken copies of every sample: each is loaded or rejected, without a crash and in little time.

use super::*;

/// xorshift64*, by Vigna (2016).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 16
    }

    fn below(&mut self, end: usize) -> usize {
        (self.next() % end.max(1) as u64) as usize
    }
}

/// One of: a truncation, a changed byte, a removed run, a repeated run, enlarged digits.
fn mutate(bytes: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for _ in 0..=random.below(3) {
        let start = random.below(bytes.len());
        let end = start + random.below(bytes.len() - start).min(20);
        match random.below(5) {
            0 => bytes.truncate(start),
            1 if start < bytes.len() => bytes[start] = random.next() as u8,
            2 => drop(bytes.drain(start..end)),
            3 => {
                let run = bytes[start..end].to_vec();
                bytes.splice(start..start, run);
            }
            _ => {
                let digit = bytes.iter().skip(start).position(u8::is_ascii_digit);
                let place = digit.map_or(start, |digit| start + digit);
                let large: [&[u8]; 4] = [b"4294967296", b"-1", b"1e39", b"99999999999999999999"];
                bytes.splice(place..place, large[random.below(4)].iter().copied());
            }
        }
    }
    bytes
}

/// Loads broken copies strictly and leniently. A caught panic of a reader's crate is a rejection too, but is counted here.
fn torture(name: &str, sample: &[u8]) {
    let files = Files::new();
    files.put("box.mtl", "newmtl red\nKd 1 0 0\n");
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let mut panics = Vec::new();
    for _ in 0..300 {
        let broken = mutate(sample, &mut random);
        files.put(name, &broken);
        for options in [LoadOptions::default(), lenient()] {
            match files.load_with(name, &options) {
                Ok(scene) => assert_eq!(scene.mesh.validate(), Ok(())),
                Err(LoadError::Panicked { message, .. }) => panics.push(message),
                Err(error) => {
                    let message = error.to_string();
                    assert!(!message.contains('\n'), "{message}");
                }
            }
        }
    }
    assert!(panics.is_empty(), "{name}: {panics:?}");
}

#[test]
fn broken_off() {
    torture("x.off", off::sample().as_bytes());
}

#[test]
fn broken_ply() {
    for encoding in ["ascii", "binary_little_endian", "binary_big_endian"] {
        torture("x.ply", &ply::sample(encoding));
    }
}

#[test]
fn broken_stl() {
    torture("x.stl", stl::text().as_bytes());
    torture("x.stl", &stl::binary());
}

#[test]
fn broken_obj() {
    torture("x.obj", obj::sample().as_bytes());
}

#[test]
fn broken_gltf() {
    torture("x.gltf", gltf::sample().as_bytes());
    torture("x.glb", &gltf::binary());
    torture("x.gltf", gltf::every_part().as_bytes());
}
