//! Any mesh that the door lets in, any ray at all, any codec: the tree answers like brute force, bit for bit.

use super::input::{any, drawn};
use crate::oracle::brute::{Answers, Parts};
use crate::rays::some_rays;
use crate::strategies::any_mesh;
use arbitrary::Arbitrary;
use slimbvh::{BuildConfig, Builder, Bvh, CodeBits, LatticeBits, Mesh, MeshCodec, NodeCodec, Ray};

/// A mesh and rays as they come, broken ones too.
#[derive(Arbitrary, Debug)]
struct Raw {
    vertices: Vec<[f32; 3]>,
    indices: Vec<[u8; 3]>,
    rays: Vec<([f32; 3], [f32; 3], f32, f32)>,
}

/// See the module.
///
/// # Panics
/// If an answer differs.
pub fn build_and_trace(data: &[u8]) {
    let Some((&[how, codec, coarse], rest)) = data.split_first_chunk() else {
        return;
    };
    let found = if how & 1 == 0 { raw(rest) } else { sound(rest) };
    let Some((mut mesh, rays)) = found else {
        return;
    };
    if mesh.validate().is_err() {
        assert!(Builder::new(BuildConfig::default()).build(&mesh).is_err());
        return;
    }
    let code_bits = match how & 2 {
        0 => CodeBits::Bits30,
        _ => CodeBits::Bits63,
    };
    let (nodes, codec) = codecs(codec, mesh.finest_step() + i32::from(coarse % 24));
    if let MeshCodec::Lattice { step_exponent } = codec {
        mesh.snap(step_exponent);
    }
    let build = |config| Builder::new(config).build(&mesh);
    let plain = build(BuildConfig::from(code_bits)).expect("the mesh is sound");
    let coded = build(BuildConfig {
        code_bits,
        nodes,
        mesh: codec,
    });
    let coded = coded.expect("codecs that go together");

    // What a leaf of the printed codec moves is another mesh.
    let expected = match codec {
        MeshCodec::Leaf10 => coded.decoded(),
        _ => plain,
    };
    for ray in &rays {
        let (tree, all) = (ask(&coded, ray), Parts::from(&expected).ask_all(ray));
        assert!(tree.same_bits(&all), "{ray:?} {tree:#?} {all:#?}");
    }
    assert_eq!(coded.validate_over(&mesh), Ok(()));
}

fn raw(data: &[u8]) -> Option<(Mesh, Vec<Ray>)> {
    let raw: Raw = any(data)?;
    let ray = |(origin, direction, t_min, t_max)| Ray {
        origin,
        t_min,
        direction,
        t_max,
    };
    let mesh = Mesh {
        vertices: raw.vertices,
        indices: raw.indices.iter().map(|t| t.map(u32::from)).collect(),
        ..Mesh::default()
    };
    Some((mesh, raw.rays.into_iter().map(ray).collect()))
}

/// A mesh and rays that are aimed at it, as the property tests draw them.
fn sound(data: &[u8]) -> Option<(Mesh, Vec<Ray>)> {
    let (mesh, recipes) = drawn((some_rays(8), any_mesh()), data).map(|(a, b)| (b, a))?;
    let rays = recipes.iter().map(|recipe| recipe.cook(&mesh)).collect();
    Some((mesh, rays))
}

/// All codecs that go together.
fn codecs(choice: u8, step_exponent: i32) -> (NodeCodec, MeshCodec) {
    let bits = LatticeBits::ALL[usize::from(choice >> 2) % LatticeBits::ALL.len()];
    match choice % 4 {
        0 => (NodeCodec::Printed, MeshCodec::F32),
        1 => (NodeCodec::Printed, MeshCodec::Leaf10),
        2 => (NodeCodec::Lattice(bits), MeshCodec::F32),
        _ => (
            NodeCodec::Lattice(bits),
            MeshCodec::Lattice { step_exponent },
        ),
    }
}

fn ask(bvh: &Bvh, ray: &Ray) -> Answers {
    Answers {
        closest: bvh.closest_hit(ray),
        any: bvh.any_hit(ray),
        nearest_1: bvh.nearest_hits(ray),
        nearest_4: bvh.nearest_hits(ray),
        nearest_8: bvh.nearest_hits(ray),
    }
}
