//! For any valid mesh, any ray, any codec and any kind of tree, the tree's answer equals brute force bit for bit, and rays in
//! a packet answer as each alone.

use super::input::{any, drawn};
use crate::oracle::brute::{Answers, Parts};
use crate::parity::same_bits;
use crate::rays::{Aim, Face, Range, RayRecipe, Start, some_rays};
use crate::strategies::any_mesh;
use arbitrary::Arbitrary;
use slimbvh::{
    BuildConfig, Builder, Bvh, CodeBits, Hit, LatticeBits, Mesh, MeshCodec, NodeCodec, Ray,
    TreeKind, WideStore,
};

/// An arbitrary mesh and arbitrary rays, invalid ones included.
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
    let found = match how % 3 {
        0 => raw(rest),
        1 => on_grid(rest),
        _ => as_tests_draw(rest),
    };
    let Some((mut mesh, rays)) = found else {
        return;
    };
    if mesh.validate().is_err() {
        assert!(Builder::new(BuildConfig::default()).build(&mesh).is_err());
        return;
    }
    let code_bits = match how & 0x80 {
        0 => CodeBits::Bits30,
        _ => CodeBits::Bits63,
    };
    let tree = match how & 0x40 {
        0 => TreeKind::Radix,
        _ => TreeKind::Clustered,
    };
    let (nodes, codec) = codecs(codec, mesh.finest_step() + i32::from(coarse % 24));
    if let MeshCodec::Lattice { step_exponent } = codec {
        mesh.snap(step_exponent);
    }
    let build = |config| Builder::new(config).build(&mesh);
    let plain = build(BuildConfig::from(code_bits)).expect("the mesh is sound");
    let coded = build(BuildConfig {
        nodes,
        mesh: codec,
        tree,
        ..BuildConfig::from(code_bits)
    });
    let coded = coded.expect("codecs that go together");

    // The paper10 codec moves vertices leaf by leaf, so brute force runs over the decoded mesh.
    let expected = match codec {
        MeshCodec::Leaf10 => coded.decoded(),
        _ => plain,
    };
    for ray in &rays {
        let (tree, all) = (ask(&coded, ray), Parts::from(&expected).ask_all(ray));
        assert!(tree.same_bits(&all), "{ray:?} {tree:#?} {all:#?}");
    }
    let mut hits = vec![Hit::MISS; rays.len()];
    coded.closest_hits_of_block(&rays, &mut hits);
    let alone = rays.iter().map(|ray| coded.closest_hit(ray));
    assert_eq!(same_bits(&hits, &alone.collect::<Vec<_>>()), Ok(()));
    let mut found = vec![false; rays.len()];
    coded.any_hits_of_block(&rays, &mut found);
    assert!(hits.iter().map(Hit::is_hit).eq(found));
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

/// A mesh with many coplanar, degenerate and equal triangles, and rays from the grid to points, edges and corners of it.
#[derive(Arbitrary, Debug)]
struct OnGrid {
    vertices: Vec<[i8; 3]>,
    indices: Vec<[u8; 3]>,
    exponent: i8,
    rays: Vec<([i8; 3], u8, [u8; 2])>,
}

fn on_grid(data: &[u8]) -> Option<(Mesh, Vec<Ray>)> {
    let grid: OnGrid = any(data)?;
    let unit = 2f32.powi(grid.exponent.into());
    let point = |p: [i8; 3]| p.map(|x| f32::from(x % 5) * unit);
    let count = u8::try_from(grid.vertices.len()).unwrap_or(u8::MAX).max(1);
    let indices = grid.indices.iter().map(|t| t.map(|v| u32::from(v % count)));
    let mut mesh = Mesh {
        vertices: grid.vertices.iter().copied().map(point).collect(),
        indices: indices.collect(),
        ..Mesh::default()
    };
    if mesh.vertices.is_empty() {
        mesh.indices.clear();
    }
    let ray = |&(start, triangle, weights): &([i8; 3], u8, [u8; 2])| {
        let recipe = RayRecipe {
            start: Start::Near(start.map(|x| f32::from(x) / 16.0)),
            aim: Aim::At(Face {
                triangle: triangle.into(),
                weights: weights.map(|weight| f32::from(weight % 9) / 8.0),
            }),
            length: 0,
            range: Range::Whole,
        };
        recipe.cook(&mesh)
    };
    let rays = grid.rays.iter().map(ray).collect();
    Some((mesh, rays))
}

/// A mesh and rays aimed at it, from the strategies of the property tests.
fn as_tests_draw(data: &[u8]) -> Option<(Mesh, Vec<Ray>)> {
    let (mesh, recipes) = drawn((any_mesh(), some_rays(8)), data)?;
    let rays = recipes.iter().map(|recipe| recipe.cook(&mesh)).collect();
    Some((mesh, rays))
}

/// All valid pairs of codecs.
fn codecs(choice: u8, step_exponent: i32) -> (NodeCodec, MeshCodec) {
    let bits = LatticeBits::ALL[usize::from(choice >> 2) % LatticeBits::ALL.len()];
    let on_lattice = MeshCodec::Lattice { step_exponent };
    if choice >= 0xc0 {
        return match choice % 4 {
            0 => (NodeCodec::Wide(WideStore::Full), MeshCodec::F32),
            1 => (NodeCodec::Wide(WideStore::Exact), MeshCodec::F32),
            2 => (NodeCodec::Wide(WideStore::Exact), on_lattice),
            _ => (NodeCodec::Wide(WideStore::Packed), on_lattice),
        };
    }
    match choice % 4 {
        0 => (NodeCodec::Paper10, MeshCodec::F32),
        1 => (NodeCodec::Paper10, MeshCodec::Leaf10),
        2 => (NodeCodec::Lattice(bits), MeshCodec::F32),
        _ => (NodeCodec::Lattice(bits), on_lattice),
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
