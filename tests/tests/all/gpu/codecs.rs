//! Hierarchies in codecs: bytes, answers and pictures equal the CPU's.

use super::pictures::{VIEWS, check_as, hall_of_mirrors, settings};
use super::trace::{Answers, rays_at};
use crate::decisions::targets;
use glam::Vec3;
use proptest::prelude::*;
use slimbvh::generate::{default_scene, icosphere, soup};
use slimbvh::gpu::{self, Gpu, GpuError, Subset, TargetSides};
use slimbvh::{
    BuildConfig, CodeBits, LatticeBits, Mesh, MeshCodec, NodeCodec, TreeKind, View, WideStore,
};
use slimbvh_core::classify::{Sides, VisibleSet};
use slimbvh_core::frustum::Frustum;
use slimbvh_tests::gpu::{done, gpu, is_software};
use slimbvh_tests::parity::same_bits;
use slimbvh_tests::rays::some_rays;
use slimbvh_tests::strategies::{any_mesh, large_mesh};
use slimbvh_tests::{CODE_BITS, build_as, cases};

/// All codecs of the GPU, with a lattice of this step.
pub fn configs(code_bits: CodeBits, step_exponent: i32) -> [BuildConfig; 6] {
    let lattice = MeshCodec::Lattice { step_exponent };
    [
        (NodeCodec::Paper10, MeshCodec::F32),
        (NodeCodec::Paper10, MeshCodec::Leaf10),
        (NodeCodec::Wide(WideStore::Full), MeshCodec::F32),
        (NodeCodec::Wide(WideStore::Exact), MeshCodec::F32),
        (NodeCodec::Wide(WideStore::Exact), lattice),
        (NodeCodec::Wide(WideStore::Packed), lattice),
    ]
    .map(|(nodes, mesh)| BuildConfig {
        nodes,
        mesh,
        ..BuildConfig::from(code_bits)
    })
}

/// A mesh on a lattice some steps coarser than the finest, and its step.
pub fn snapped(mesh: &Mesh, coarser: i32) -> (Mesh, i32) {
    let step_exponent = mesh.finest_step() + coarser;
    let mut snapped = mesh.clone();
    snapped.snap(step_exponent);
    (snapped, step_exponent)
}

/// Compares all lists of a hierarchy in a codec.
pub fn same_stored(gpu: &slimbvh::Bvh, cpu: &slimbvh::Bvh) -> Result<(), String> {
    let what = |fault| format!("{:?}: {fault}", cpu.codecs());
    same_bits(gpu.root_words().as_slice(), cpu.root_words().as_slice()).map_err(what)?;
    let [a, b] = [gpu, cpu].map(slimbvh::Bvh::stored);
    same_bits(a[0], b[0]).map_err(|fault| what(format!("nodes: {fault}")))?;
    same_bits(a[1], b[1]).map_err(|fault| what(format!("triangles: {fault}")))?;
    let numbers = |bvh: &slimbvh::Bvh| {
        [
            bvh.scene_exponent(),
            bvh.triangle_count() as i32,
            bvh.mesh_triangle_count() as i32,
        ]
    };
    same_bits(&numbers(gpu), &numbers(cpu)).map_err(what)?;
    if gpu.codecs() != cpu.codecs() {
        return Err(what(format!("{:?}", gpu.codecs())));
    }
    Ok(())
}

/// Builds on the GPU.
fn build_on(gpu: &Gpu, mesh: &Mesh, config: BuildConfig) -> gpu::Bvh {
    let mesh = done(gpu::Mesh::upload(gpu, mesh));
    let mut bvh = gpu::Bvh::new();
    let mut frame = gpu.frame();
    done(gpu::Builder::new(config).build(&mut frame, &mesh, &mut bvh));
    done(frame.submit());
    bvh
}

fn check_bytes(gpu: &Gpu, mesh: &Mesh, config: BuildConfig) -> Result<(), String> {
    let bvh = build_on(gpu, mesh, config);
    let expected = build_as(mesh, config);
    same_stored(&done(bvh.download(gpu)), &expected)?;
    let bytes = [expected.node_bytes(), expected.triangle_bytes()];
    same_bits(&done(bvh.read_bytes(gpu)), &bytes.map(|b| b as u64))
}

/// Wide corners that no triangles share take more words than triangles that are stored one by one.
#[test]
fn corners_that_are_not_shared_have_room() {
    let Some(gpu) = gpu() else { return };
    let step_exponent = -24;
    let mut mesh = soup(60, 5);
    mesh.snap(step_exponent);
    let config = BuildConfig {
        nodes: NodeCodec::Wide(WideStore::Packed),
        mesh: MeshCodec::Lattice { step_exponent },
        ..BuildConfig::default()
    };
    let bytes = build_as(&mesh, config).triangle_bytes();
    assert!(bytes > 40 * mesh.indices.len(), "{bytes}");
    assert_eq!(check_bytes(gpu, &mesh, config), Ok(()));
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn coded_hierarchies_have_the_bytes_of_the_cpu(mesh in any_mesh(), coarser in 0i32..20) {
        let Some(gpu) = gpu() else { return Ok(()) };
        let (mesh, step_exponent) = snapped(&mesh, coarser);
        for code_bits in CODE_BITS {
            for config in configs(code_bits, step_exponent) {
                prop_assert_eq!(check_bytes(gpu, &mesh, config), Ok(()));
            }
        }
    }

    #[test]
    fn coded_hierarchies_answer_as_on_the_cpu(mesh in any_mesh(), recipes in some_rays(100), coarser in 0i32..20) {
        let Some(gpu) = gpu() else { return Ok(()) };
        let (mesh, step_exponent) = snapped(&mesh, coarser);
        let rays: Vec<_> = recipes.iter().map(|recipe| recipe.cook(&mesh)).collect();
        for config in configs(CodeBits::Bits30, step_exponent) {
            let answers = Answers::of_gpu(gpu, &mesh, config, &rays);
            let expected = Answers::of_cpu(&build_as(&mesh, config), &rays);
            let result = answers.compare(&expected, is_software(gpu));
            prop_assert_eq!(result, Ok(()), "{:?}", config);
        }
    }
}

proptest! {
    #![proptest_config(cases(4))]

    #[test]
    fn large_coded_hierarchies_have_the_bytes_of_the_cpu(mesh in large_mesh(), coarser in 0i32..20) {
        let Some(gpu) = gpu() else { return Ok(()) };
        let (mesh, step_exponent) = snapped(&mesh, coarser);
        for config in configs(CodeBits::Bits30, step_exponent) {
            prop_assert_eq!(check_bytes(gpu, &mesh, config), Ok(()));
        }
    }

    #[test]
    fn refitted_coded_hierarchies_have_the_bytes_of_the_cpu(mesh in large_mesh(), factors in proptest::array::uniform3(-3f32..3.0)) {
        let Some(gpu) = gpu() else { return Ok(()) };
        let mut moved = mesh.clone();
        for (vertex, i) in moved.vertices.iter_mut().zip(0..) {
            *vertex = [0, 1, 2].map(|axis| vertex[axis] * factors[(axis + i) % 3]);
        }
        let step_exponent = mesh.finest_step().max(moved.finest_step()) + 4;
        let mut mesh = mesh;
        mesh.snap(step_exponent);
        moved.snap(step_exponent);
        for config in configs(CodeBits::Bits30, step_exponent) {
            let places = [&mesh, &moved].map(|mesh| done(gpu::Mesh::upload(gpu, mesh)));
            let (mut builder, mut bvh) = (gpu::Builder::new(config), gpu::Bvh::new());
            let mut frame = gpu.frame();
            done(builder.build(&mut frame, &places[0], &mut bvh));
            done(builder.refit(&mut frame, &places[1], &mut bvh));
            done(frame.submit());
            let mut expected = build_as(&mesh, config);
            done(slimbvh::Builder::new(config).refit(&moved, &mut expected));
            prop_assert_eq!(same_stored(&done(bvh.download(gpu)), &expected), Ok(()));
        }
    }
}

/// Large, small and empty meshes, built in turn in the same memory.
#[test]
fn what_was_coded_before_changes_no_byte() {
    let Some(gpu) = gpu() else { return };
    let step_exponent = -14;
    for config in configs(CodeBits::Bits30, step_exponent) {
        let (mut builder, mut bvh) = (gpu::Builder::new(config), gpu::Bvh::new());
        for count in [9000, 5, 0, 1, 12_000, 4, 700, 0] {
            let mut mesh = soup(count, u64::from(count));
            mesh.snap(step_exponent);
            let uploaded = done(gpu::Mesh::upload(gpu, &mesh));
            let expected = build_as(&mesh, config);
            for is_refitted in [false, true] {
                let mut frame = gpu.frame();
                done(builder.build(&mut frame, &uploaded, &mut bvh));
                if is_refitted {
                    done(builder.refit(&mut frame, &uploaded, &mut bvh));
                }
                done(frame.submit());
                done(same_stored(&done(bvh.download(gpu)), &expected));
            }
        }
    }
}

/// Compacted hierarchies take only the memory of their contents, answer as before, and can be built again.
#[test]
fn compacted_hierarchies_are_the_same_in_fewer_bytes() {
    let Some(gpu) = gpu() else { return };
    let step_exponent = -14;
    let plain = BuildConfig::default();
    for config in configs(CodeBits::Bits30, step_exponent)
        .into_iter()
        .chain([plain])
    {
        for count in [0, 1, 5, 3000] {
            let mut mesh = soup(count, 7);
            mesh.snap(step_exponent);
            let uploaded = done(gpu::Mesh::upload(gpu, &mesh));
            let (mut builder, mut bvh) = (gpu::Builder::new(config), gpu::Bvh::new());
            let mut frame = gpu.frame();
            done(builder.build(&mut frame, &uploaded, &mut bvh));
            done(frame.submit());
            let (before, expected) = (bvh.bytes(), done(bvh.download(gpu)));
            done(bvh.compact(gpu));
            let compacted = done(bvh.download(gpu));
            done(same_stored(&compacted, &expected));
            let [nodes, triangles] = done(bvh.read_bytes(gpu));
            // Bindings have a least size, and a few numbers are stored beside the lists.
            assert!(bvh.bytes() <= nodes.max(64) + triangles.max(40) + 200);
            assert!(bvh.bytes() <= before);
            assert!(
                count < 3000 || bvh.bytes() * 10 < before * 9,
                "{before} {}",
                bvh.bytes()
            );

            let mut frame = gpu.frame();
            let refitted = builder.refit(&mut frame, &uploaded, &mut bvh);
            assert_eq!(refitted.is_ok(), config == plain, "{refitted:?}");
            if refitted.is_ok() {
                done(frame.submit());
                done(same_stored(&done(bvh.download(gpu)), &expected));
            }
            let mut frame = gpu.frame();
            done(builder.build(&mut frame, &uploaded, &mut bvh));
            done(frame.submit());
            done(same_stored(&done(bvh.download(gpu)), &expected));
        }
    }
}

/// Subsets of a mesh with sizes that only the GPU knows.
#[test]
fn reduced_coded_hierarchies_have_the_bytes_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    let mut mesh = icosphere(Vec3::new(0.3, -0.2, 0.1), 1.5, 4);
    let step_exponent = -12;
    mesh.snap(step_exponent);
    let components = vec![0; mesh.indices.len()];
    let targets = targets(&mesh, 6, 3);
    let (mut smallest, mut largest) = (usize::MAX, 0);
    for code_bits in CODE_BITS {
        for config in configs(code_bits, step_exponent) {
            let uploaded = done(gpu::Mesh::upload(gpu, &mesh));
            let on_gpu = done(gpu::Components::upload(gpu, &components));
            let (mut builder, mut cpu) = (gpu::Builder::new(config), slimbvh::Builder::new(config));
            let mut frame = gpu.frame();
            done(builder.sort(&mut frame, &uploaded));
            done(cpu.sort(&mesh));
            let mut sets = Vec::new();
            for target in &targets {
                let (mut facing, mut bvh) = (TargetSides::new(), gpu::Bvh::new());
                done(facing.set(&mut frame, &on_gpu, (target, &Frustum::EVERYWHERE), &[1]));
                let subset = Subset::Of {
                    components: &on_gpu,
                    sides: &facing,
                };
                done(builder.build_sorted(&mut frame, &uploaded, subset, &mut bvh));
                sets.push(bvh);
            }
            // After its parts, the whole tree again.
            let mut whole = gpu::Bvh::new();
            done(builder.build_sorted(&mut frame, &uploaded, Subset::All, &mut whole));
            done(frame.submit());
            done(same_stored(
                &done(whole.download(gpu)),
                &build_as(&mesh, config),
            ));
            for (target, set) in targets.iter().zip(&sets) {
                let reach = VisibleSet {
                    sides: Sides {
                        components: &components,
                        sides: &[1],
                    },
                    target: *target,
                    frustum: Frustum::EVERYWHERE,
                };
                let mut expected = slimbvh::Bvh::default();
                cpu.build_sorted(&mesh, slimbvh::Subset::Of(reach), &mut expected);
                done(same_stored(&done(set.download(gpu)), &expected));
                smallest = smallest.min(expected.triangle_count());
                largest = largest.max(expected.triangle_count());
            }
        }
    }
    assert!(
        smallest < mesh.indices.len() / 2 && largest > 0,
        "{smallest} {largest}"
    );
}

#[test]
fn answers_in_coded_generated_meshes_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    for (name, mesh) in crate::meshes::generated() {
        let (mesh, step_exponent) = snapped(&mesh, 8);
        let rays = rays_at(&mesh, 500, 3);
        for config in configs(CodeBits::Bits63, step_exponent) {
            let answers = Answers::of_gpu(gpu, &mesh, config, &rays);
            let expected = Answers::of_cpu(&build_as(&mesh, config), &rays);
            let result = answers.compare(&expected, is_software(gpu));
            assert_eq!(result, Ok(()), "{name} {config:?}");
        }
    }
}

#[test]
fn pictures_through_coded_hierarchies_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    for (name, scene) in [
        ("default scene", default_scene()),
        ("hall of mirrors", hall_of_mirrors()),
    ] {
        let (mesh, step_exponent) = snapped(&scene.mesh, 6);
        let scene = slimbvh::Scene { mesh, ..scene };
        for config in configs(CodeBits::Bits30, step_exponent) {
            let name = format!("{name}, {:?}, {:?}", config.nodes, config.mesh);
            for view in VIEWS {
                let is_packed = config.nodes == NodeCodec::Wide(WideStore::Packed);
                if view == View::Color || view == View::Heatmap || is_packed {
                    check_as(gpu, &name, &scene, &settings(view), config);
                }
            }
        }
    }
}

/// The negative control: one flipped bit of a node's planes or of a triangle, in a hierarchy over another mesh.
#[test]
fn one_moved_step_of_a_vertex_is_found() {
    let Some(gpu) = gpu() else { return };
    let step_exponent = -10;
    let mut sound = soup(900, 2);
    sound.snap(step_exponent);
    let mut moved = sound.clone();
    moved.vertices[1000][1] += 2f32.powi(step_exponent);
    for config in configs(CodeBits::Bits30, step_exponent) {
        let built = done(build_on(gpu, &moved, config).download(gpu));
        done(same_stored(&built, &build_as(&moved, config)));
        // Boxes of 10 bits or less may hide a step; triangles in full precision and on the lattice do not.
        let is_seen = same_stored(&built, &build_as(&sound, config)).is_err();
        assert!(is_seen || config.mesh == MeshCodec::Leaf10, "{config:?}");
    }
}

/// The comparison notices one flipped bit in each of the lists.
#[test]
fn one_flipped_bit_of_a_node_is_found() {
    let mesh = soup(60, 5);
    let bvh = build_as(&mesh, configs(CodeBits::Bits30, 0)[3]);
    let [nodes, _] = bvh.stored();
    for bit in 0..8 * nodes.len() {
        let mut flipped = nodes.to_vec();
        flipped[bit / 8] ^= 1 << (bit % 8);
        assert!(same_bits(&flipped, nodes).is_err());
    }
}

#[test]
fn clustered_trees_are_refused() {
    let Some(gpu) = gpu() else { return };
    let mesh = done(gpu::Mesh::upload(gpu, &soup(10, 1)));
    let config = BuildConfig {
        tree: TreeKind::Clustered,
        ..BuildConfig::default()
    };
    let mut bvh = gpu::Bvh::new();
    let built = gpu::Builder::new(config).build(&mut gpu.frame(), &mesh, &mut bvh);
    assert_eq!(built, Err(GpuError::Tree));
    let said = "clustered trees are built on the CPU only; the GPU builds radix trees";
    assert_eq!(GpuError::Tree.to_string(), said);
}

#[test]
fn clustered_trees_are_uploaded_and_traced_as_any() {
    let Some(gpu) = gpu() else { return };
    let mesh = soup(3000, 5);
    let config = BuildConfig {
        tree: TreeKind::Clustered,
        ..BuildConfig::default()
    };
    let tree = build_as(&mesh, config);
    let uploaded = done(gpu::Bvh::upload(gpu, &tree));
    let back = done(uploaded.download(gpu));
    assert!(back.nodes() == tree.nodes() && back.leaf_triangles() == tree.leaf_triangles());
}

#[test]
fn codecs_that_only_the_cpu_has_are_refused() {
    let Some(gpu) = gpu() else { return };
    let mesh = done(gpu::Mesh::upload(gpu, &soup(10, 1)));
    for bits in LatticeBits::ALL {
        let config = BuildConfig {
            nodes: NodeCodec::Lattice(bits),
            ..BuildConfig::default()
        };
        let mut builder = gpu::Builder::new(config);
        let built = builder.build(&mut gpu.frame(), &mesh, &mut gpu::Bvh::new());
        let nodes = config.nodes.name();
        assert_eq!(built, Err(GpuError::Codec { nodes }));
        let said = built.map_or_else(|error| error.to_string(), |()| String::new());
        let expected = format!(
            "{nodes} nodes are for the CPU only; use w4-64 or w4-48 nodes for a lattice on a GPU"
        );
        assert_eq!(said, expected);
    }
}

/// The builder keeps the plain tree of a coded hierarchy until it builds another one.
#[test]
fn only_the_coded_hierarchy_that_was_built_last_is_refitted() {
    let Some(gpu) = gpu() else { return };
    let (mesh, step_exponent) = snapped(&soup(300, 1), 4);
    for config in configs(CodeBits::Bits30, step_exponent) {
        check_refits_in_turn(gpu, &mesh, config);
    }
}

fn check_refits_in_turn(gpu: &Gpu, mesh: &Mesh, config: BuildConfig) {
    let uploaded = done(gpu::Mesh::upload(gpu, mesh));
    let [mut builder, mut other] = [0, 1].map(|_| gpu::Builder::new(config));
    let [mut first, mut second] = [0, 1].map(|_| gpu::Bvh::new());
    let mut frame = gpu.frame();
    done(builder.build(&mut frame, &uploaded, &mut first));
    done(builder.build(&mut frame, &uploaded, &mut second));
    let is_refused = |refitted| matches!(refitted, Err(GpuError::Unfit { .. }));
    assert!(is_refused(builder.refit(&mut frame, &uploaded, &mut first)));
    assert!(is_refused(other.refit(&mut frame, &uploaded, &mut second)));
    done(builder.refit(&mut frame, &uploaded, &mut second));
    // After a build by another builder, the first builder's plain tree is out of date.
    done(other.build(&mut frame, &uploaded, &mut second));
    assert!(is_refused(builder.refit(
        &mut frame,
        &uploaded,
        &mut second
    )));
    // Only wide trees have a WGSL text.
    let is_wide = matches!(config.nodes, NodeCodec::Wide(_));
    assert_eq!(second.bindings().is_ok(), is_wide);
    done(frame.submit());
    let expected = build_as(mesh, config);
    for bvh in [&first, &second] {
        done(same_stored(&done(bvh.download(gpu)), &expected));
    }
}
