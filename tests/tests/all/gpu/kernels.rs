//! Kernels of the build from `topology` to `wide`, each alone: its outputs equal the results of core's function, to the bit.

use super::chain::{Chain, is_short, pyramid};
use bytemuck::{Zeroable, bytes_of, cast_slice};
use proptest::prelude::*;
use slimbvh::CodeBits;
use slimbvh::gpu::{Gpu, Kernel};
use slimbvh_core::encode::number_corners;
use slimbvh_core::node::LEAF_SIZE;
use slimbvh_core::refit::{GROUP_LEVELS, Level, PyramidBox};
use slimbvh_core::topology::{Codes30, internal_node};
use slimbvh_core::wide::{Collapse, collapse, wide_origin};
use slimbvh_core::{LeafTriangle, Node};
use slimbvh_tests::gpu::{Dispatch, answers, done, gpu};
use slimbvh_tests::parity::same_bits;
use slimbvh_tests::random::Random;
use slimbvh_tests::strategies::large_mesh;
use slimbvh_tests::{CODE_BITS, cases};

/// The workgroups for a thread for each item.
pub fn groups(count: usize) -> u32 {
    count.div_ceil(64) as u32
}

fn check_topology(gpu: &Gpu, chain: &Chain, code_bits: CodeBits) -> Result<(), String> {
    let (kept, nodes) = if is_short(code_bits) {
        (Kernel::topology_kept_30, Kernel::topology_nodes_30)
    } else {
        (Kernel::topology_kept_63, Kernel::topology_nodes_63)
    };
    let codes: &[u8] = cast_slice(&chain.codes);
    let words = vec![!0u32; chain.kept.len()];
    let total = [chain.triangles.len() as u32, 0, 0, 0];
    let stored = Dispatch {
        kernel: kept,
        group_count: groups(32 * words.len()),
        uniforms: &[&total],
        reads: &[codes],
        outputs: &[cast_slice(&words), cast_slice(&words)],
    }
    .run(gpu);
    same_bits(&answers::<u32>(&stored[0]), &chain.kept)?;
    same_bits(&answers::<u32>(&stored[1]), &chain.counts)?;

    // The buffer beyond the last node is unchanged.
    let count = chain.triangles.len();
    let mut expected = vec![
        Node {
            first: 7,
            ..Node::EMPTY
        };
        count
    ];
    let mut splits = vec![7u32; count];
    let before = [
        bytes_of(&expected[0]).repeat(count),
        cast_slice(&splits).to_vec(),
    ];
    expected[..chain.bare_nodes.len()].copy_from_slice(&chain.bare_nodes);
    splits[..chain.splits.len()].copy_from_slice(&chain.splits);
    let stored = Dispatch {
        kernel: nodes,
        group_count: groups(count),
        uniforms: &[&total],
        reads: &[codes, cast_slice(&chain.kept), cast_slice(&chain.before)],
        outputs: &[&before[0], &before[1]],
    }
    .run(gpu);
    same_bits(&answers::<Node>(&stored[0]), &expected)?;
    same_bits(&answers::<u32>(&stored[1]), &splits)
}

/// Compares the pyramid over triangles, seven levels a dispatch. A dispatch stores no other level.
fn check_pyramid(
    gpu: &Gpu,
    triangles: &[LeafTriangle],
    expected: &[PyramidBox],
) -> Result<(), String> {
    let mut pyramid = vec![PyramidBox::zeroed(); expected.len()];
    let mut level = Level::lowest(triangles.len() as u32);
    let mut below = None;
    while level.count > 0 {
        let params: [u32; 4] =
            below.map_or([0; 4], |below: Level| [below.begin, below.count, 0, 0]);
        let (uniforms, reads): ([&[u32]; 1], [&[u8]; 1]) = ([&params], [cast_slice(triangles)]);
        let is_lowest = below.is_none();
        let stored = Dispatch {
            kernel: if is_lowest {
                Kernel::refit_groups
            } else {
                Kernel::refit_parents
            },
            group_count: groups(level.count as usize),
            uniforms: if is_lowest { &[] } else { &uniforms },
            reads: if is_lowest { &reads } else { &[] },
            outputs: &[cast_slice(&pyramid)],
        }
        .run(gpu);
        for _ in 0..GROUP_LEVELS {
            (below, level) = (Some(level), level.above());
        }
        pyramid = answers(&stored[0]);
        let made = level.begin as usize;
        same_bits(&pyramid[..made], &expected[..made])?;
        let absent = vec![PyramidBox::zeroed(); expected.len() - made];
        same_bits(&pyramid[made..], &absent)?;
    }
    same_bits(&pyramid, expected)
}

fn check_refit(gpu: &Gpu, chain: &Chain) -> Result<(), String> {
    let total = chain.total_uniform();
    let (leaves, splits) = (cast_slice(&chain.triangles), cast_slice(&chain.splits));
    let dispatch = Dispatch {
        kernel: Kernel::refit_nodes,
        group_count: groups(chain.nodes.len()),
        uniforms: &[&total],
        reads: &[leaves, cast_slice(&chain.pyramid), splits],
        outputs: &[cast_slice(&chain.bare_nodes)],
    };
    let stored = dispatch.run(gpu);
    same_bits(&answers::<Node>(&stored[0]), &chain.nodes)?;
    let stored = Dispatch {
        kernel: Kernel::refit_splits,
        reads: &[cast_slice(&chain.nodes)],
        outputs: &[cast_slice(&vec![0u32; chain.splits.len()])],
        ..dispatch
    }
    .run(gpu);
    same_bits(&answers::<u32>(&stored[0]), &chain.splits)
}

/// Compares which nodes wide ones take in, where these come from, and how many inner children they have. Nothing is stored
/// beyond the last node.
fn check_wide(gpu: &Gpu, nodes: &[Node], expected: &[Collapse]) -> Result<(), String> {
    let (total, nothing) = ([nodes.len() as u32, 0, 0, 0], vec![7u32; nodes.len() + 3]);
    let room = [nodes, &[Node::EMPTY; 3]].concat();
    let dispatch = Dispatch {
        kernel: Kernel::wide_collapse,
        group_count: groups(room.len()),
        uniforms: &[&total, &[0; 4]],
        reads: &[cast_slice(&room)],
        outputs: &[cast_slice(&nothing)],
    };
    let with_room = |words: Vec<u32>| [words, vec![7; 3]].concat();
    let collapses = with_room(expected.iter().map(|collapse| collapse.0).collect());
    same_bits(&answers::<u32>(&dispatch.run(gpu)[0]), &collapses)?;

    let origins = (0..nodes.len() as u32).map(|i| wide_origin(i, nodes, &collapses));
    let origins: Vec<_> = origins.collect();
    let stored = Dispatch {
        kernel: Kernel::wide_places,
        uniforms: &[&total],
        reads: &[cast_slice(&room), cast_slice(&collapses)],
        outputs: &[cast_slice(&nothing), cast_slice(&nothing)],
        ..dispatch
    }
    .run(gpu);
    let words = origins.iter().map(|origin| origin.0).collect();
    same_bits(&answers::<u32>(&stored[0]), &with_room(words))?;
    let counts = origins.iter().zip(expected);
    let counts = counts.map(|(origin, collapse)| origin.inner_count(*collapse));
    same_bits(&answers::<u32>(&stored[1]), &with_room(counts.collect()))
}

/// Compares which corners of its leaf each triangle has.
fn check_corners(gpu: &Gpu, nodes: &[Node], triangles: &[LeafTriangle]) -> Result<(), String> {
    let nothing = vec![7u32; triangles.len() + 3];
    let stored = Dispatch {
        kernel: Kernel::wide_corners,
        group_count: groups(nodes.len()),
        uniforms: &[&[nodes.len() as u32, 0, 0, 0]],
        reads: &[cast_slice(nodes), cast_slice(triangles)],
        outputs: &[cast_slice(&nothing)],
    }
    .run(gpu);
    let mut expected = nothing;
    for child in nodes.iter().flat_map(|node| [node.left, node.right]) {
        let count = if child.is_leaf() { child.count() } else { 0 };
        number_corners(child.first(), count, triangles, &mut expected);
    }
    same_bits(&answers::<u32>(&stored[0]), &expected)
}

/// The [`Collapse`] of each node.
fn collapses(nodes: &[Node]) -> Vec<Collapse> {
    nodes.iter().map(|node| collapse(node, nodes, 0)).collect()
}

proptest! {
    #![proptest_config(cases(6))]

    #[test]
    fn topology_refit_and_wide_are_those_of_core(mesh in large_mesh()) {
        let Some(gpu) = gpu() else { return Ok(()) };
        for code_bits in CODE_BITS {
            let Some(chain) = Chain::new(&mesh, code_bits) else { continue };
            prop_assert_eq!(check_topology(gpu, &chain, code_bits), Ok(()));
            let pyramid = check_pyramid(gpu, &chain.triangles, &chain.pyramid);
            prop_assert_eq!(pyramid, Ok(()));
            prop_assert_eq!(check_refit(gpu, &chain), Ok(()));
            let wide = check_wide(gpu, &chain.nodes, &collapses(&chain.nodes));
            prop_assert_eq!(wide, Ok(()));
            let corners = check_corners(gpu, &chain.nodes, &chain.triangles);
            prop_assert_eq!(corners, Ok(()));
        }
    }
}

#[test]
fn one_flipped_bit_of_what_a_kernel_reads_is_found() {
    let Some(gpu) = gpu() else { return };
    let chain = |code_bits| Chain::new(&slimbvh::generate::soup(500, 3), code_bits).unwrap();
    for code_bits in CODE_BITS {
        let mut spoilt = chain(code_bits);
        done(check_topology(gpu, &spoilt, code_bits));
        // A key with another highest bit in the first half.
        spoilt.codes[100] ^= 1 << 29;
        assert!(check_topology(gpu, &spoilt, code_bits).is_err());
    }
    let mut spoilt = chain(CodeBits::Bits30);
    done(check_pyramid(gpu, &spoilt.triangles, &spoilt.pyramid));
    // Set the highest bit of an exponent: this box then exceeds all others of its group.
    let x = &mut spoilt.triangles[77].vertices[0];
    *x = f32::from_bits(x.to_bits() ^ 1 << 30);
    assert!(check_pyramid(gpu, &spoilt.triangles, &spoilt.pyramid).is_err());
    let mut spoilt = chain(CodeBits::Bits30);
    done(check_refit(gpu, &spoilt));
    spoilt.splits[20] ^= 1;
    assert!(check_refit(gpu, &spoilt).is_err());
    let Chain { mut nodes, .. } = chain(CodeBits::Bits30);
    let expected = collapses(&nodes);
    done(check_wide(gpu, &nodes, &expected));
    // The child of the root that gives way last does so first, as its box has grown.
    let x = if expected[0].place(0) == 1 { 3 } else { 2 };
    nodes[0].planes[0][x] += 100.0;
    assert!(check_wide(gpu, &nodes, &expected).is_err());
}

/// Counts at and around the borders of groups of triangles, of workgroups and of what one dispatch can take to the top.
#[test]
fn pyramids_of_any_size_are_boxes_of_their_triangles() {
    let Some(gpu) = gpu() else { return };
    let mut random = Random::new(4);
    let mut corner = || random.between(-1.0, 1.0);
    let triangle = |primitive| LeafTriangle {
        vertices: std::array::from_fn(|_| corner()),
        primitive,
    };
    let largest = 8 * 64 * 128 * 2;
    let all: Vec<LeafTriangle> = (0..largest + 1).map(triangle).collect();
    for border in [8, 16, 512, 1024, 4096, 8 * 64 * 64, 8 * 64 * 128, largest] {
        for count in [border - 1, border, border + 1] {
            let triangles = &all[..count as usize];
            let result = check_pyramid(gpu, triangles, &pyramid(triangles));
            assert_eq!(result, Ok(()), "{count} triangles");
        }
    }
    assert_eq!(check_pyramid(gpu, &all[..1], &pyramid(&all[..1])), Ok(()));
}

/// A mesh of one leaf and an empty mesh have a root, too.
#[test]
fn single_nodes_are_those_of_core() {
    let Some(gpu) = gpu() else { return };
    for count in 0..=LEAF_SIZE {
        let codes: [u32; LEAF_SIZE as usize] = std::array::from_fn(|i| 5 + i as u32);
        let total = [count, 0, 0, 0];
        let stored = Dispatch {
            kernel: Kernel::topology_kept_30,
            group_count: 1,
            uniforms: &[&total],
            reads: &[cast_slice(&codes)],
            outputs: &[&[9; 4], &[9; 4]],
        }
        .run(gpu);
        assert_eq!(answers::<u32>(&stored[0]), [1]);
        assert_eq!(answers::<u32>(&stored[1]), [1]);
        let stored = Dispatch {
            kernel: Kernel::topology_nodes_30,
            group_count: 1,
            uniforms: &[&total],
            reads: &[cast_slice(&codes), cast_slice(&[1u32]), cast_slice(&[0u32])],
            outputs: &[&[9; 128], &[9; 8]],
        }
        .run(gpu);
        let codes = Codes30 {
            codes: &codes,
            count,
        };
        let (node, split) = internal_node(0, &codes, &[1], &[0]);
        assert_eq!((node.left.count(), node.right.count()), (count, 0));
        assert_eq!(stored[0], [bytes_of(&node), &[9; 64]].concat());
        assert_eq!(stored[1], [bytes_of(&split), &[9; 4]].concat());
    }
}
