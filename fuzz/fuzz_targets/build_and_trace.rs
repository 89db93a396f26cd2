//! Any mesh that the door lets in, any ray at all: the tree answers like brute force, bit for bit.
#![no_main]

use arbitrary::Arbitrary;
use libfuzzer_sys::fuzz_target;
use slimbvh::{BuildConfig, Builder, CodeBits, Mesh};
use slimbvh_core::classify::Except;
use slimbvh_core::trace::{BruteForce, any_hit, closest_hit, nearest_hits};
use slimbvh_core::{Hit, Ray};

#[derive(Arbitrary, Debug)]
struct Input {
    vertices: Vec<[f32; 3]>,
    indices: Vec<[u8; 3]>,
    long_codes: bool,
    rays: Vec<([f32; 3], [f32; 3], f32, f32)>,
}

fn bits(hit: Hit) -> [u32; 4] {
    [
        hit.t.to_bits(),
        hit.u.to_bits(),
        hit.v.to_bits(),
        hit.primitive,
    ]
}

fuzz_target!(|input: Input| {
    let mesh = Mesh {
        vertices: input.vertices,
        indices: input.indices.iter().map(|t| t.map(u32::from)).collect(),
        ..Mesh::default()
    };
    let code_bits = if input.long_codes {
        CodeBits::Bits63
    } else {
        CodeBits::Bits30
    };
    let Ok(bvh) = Builder::new(BuildConfig::from(code_bits)).build(&mesh) else {
        return;
    };
    let brute = BruteForce(mesh.indices.len() as u32);
    let (triangles, exponent) = (bvh.triangle_source(), bvh.scene_exponent());
    for (origin, direction, t_min, t_max) in input.rays {
        let ray = Ray {
            origin,
            t_min,
            direction,
            t_max,
        };
        let expected = closest_hit(&brute, &triangles, &ray, exponent, &Except::NOTHING);
        assert_eq!(bits(bvh.closest_hit(&ray)), bits(expected));
        assert_eq!(
            bvh.any_hit(&ray),
            any_hit(&brute, &triangles, &ray, exponent, &Except::NOTHING)
        );
        let expected = nearest_hits::<3, _, _>(&brute, &triangles, &ray, exponent);
        assert_eq!(bvh.nearest_hits::<3>(&ray).map(bits), expected.map(bits));
    }
});
