//! Trees deeper than any that the builders make: a chain of nodes, each with one more triangle than the next, which the loader
//! of saved trees accepts. Rays that begin in all boxes let a node wait on every level.

use slimbvh::scene::slim::{Saved, Section, read, write};
use slimbvh::{BuildConfig, Builder, Bvh, CodeBits, MeshCodec, NodeCodec, Scene};
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{ClosestOrAny, Distance, Rows, STACK_SIZE, Skip, Stack, traverse_with};
use slimbvh_core::{Aabb, LeafTriangle, Node, NodeRef, Ray};
use slimbvh_tests::build;
use slimbvh_tests::oracle::brute::Parts;
use slimbvh_tests::random::Random;
use slimbvh_tests::strategies::{Corners, mesh_of};
use slimbvh_tests::validate::validate_shape;
use std::ops::Range;

/// Triangles in the leaf at the end of a chain.
const LAST: u32 = 6;

/// Levels of the chains of the tests.
const LEVELS: u32 = 120;
const _: () = assert!((LEVELS as usize) < STACK_SIZE);

/// Vertices lie on the lattice whose step is two to this power.
const STEP_EXPONENT: i32 = -20;

/// Half the edge of a cube around the origin that the box of every triangle contains.
const INSIDE: f32 = 0.25;

/// Which child of a chain's node is the next node. Of children that a ray enters at the same t, the search for the closest hit
/// goes to the left one first, the search for any hit to the right one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    Left,
    Right,
}

/// A tree in which each of [`LEVELS`] nodes has the next one as a child on this side, and a leaf of one triangle as the other.
/// Every second triangle equals the one before.
pub fn chain(side: Side) -> Bvh {
    saved_chain(side).bvh
}

/// A chain whose nodes and triangles are in codecs.
pub fn coded_chain(side: Side, nodes: NodeCodec, mesh: MeshCodec) -> Bvh {
    let Saved { scene, mut bvh, .. } = saved_chain(side);
    let config = BuildConfig {
        nodes,
        mesh: mesh.with_step(Some(STEP_EXPONENT)),
        ..BuildConfig::default()
    };
    match Builder::new(config).refit(&scene.mesh, &mut bvh) {
        Ok(_) => bvh,
        Err(error) => panic!("{error}"),
    }
}

fn saved_chain(side: Side) -> Saved {
    let count = LEVELS + LAST;
    let mut random = Random::new(4);
    let mut corners: Vec<Corners> = Vec::new();
    for i in 0..count as usize {
        let mut along = |low: f32| [0, 1, 2].map(|_| random.between(low, 2.0));
        let (a, b, c) = (along(INSIDE), along(INSIDE), along(-2.0));
        // One of the four diagonals of a cube.
        let sides = [1.0, [1.0, -1.0][i / 2 % 2], [1.0, -1.0][i / 4 % 2]];
        let turned = |v: [f32; 3], sign: f32| [0, 1, 2].map(|axis| sign * sides[axis] * v[axis]);
        let new = [turned(a, 1.0), turned(b, -1.0), c];
        let last = corners.last().copied();
        corners.push(last.filter(|_| i % 2 == 1).unwrap_or(new));
    }
    let mut scene = Scene {
        mesh: mesh_of(&corners),
        ..Scene::default()
    };
    scene.mesh.snap(STEP_EXPONENT);
    let bvh = build(&scene.mesh, CodeBits::Bits30);
    let mut triangles = bvh.leaf_triangles().to_vec();
    // The last primitives come first in the leaves, so that an earlier primitive at the same t is met later.
    triangles.sort_by_key(|triangle| std::cmp::Reverse(triangle.primitive));
    with_lists(&scene, &bvh, &nodes(side, &triangles), &triangles)
}

/// The nodes of a chain over triangles in leaf order, the root first. Those below a left child stand before it, those below a right
/// child behind it.
fn nodes(side: Side, triangles: &[LeafTriangle]) -> Vec<Node> {
    let bounds = |places: &Range<u32>| {
        let triangles = &triangles[places.start as usize..places.end as usize];
        let mut bounds = triangles
            .iter()
            .map(|triangle| triangle.triangle().bounds());
        let first = bounds.next().expect("no child is empty");
        bounds.fold(first, Aabb::union)
    };
    let mut nodes = vec![Node::default(); LEVELS as usize];
    // Of the node, of those below it, and of the triangles below it.
    let (mut index, mut below, mut places) = (0, 1..LEVELS, 0..triangles.len() as u32);
    let is_left = side == Side::Left;
    for level in 0..LEVELS {
        let Range { start, end } = places;
        let (next, alone) = if is_left {
            (start..end - 1, end - 1..end)
        } else {
            (start + 1..end, start..start + 1)
        };
        let next_index = if is_left {
            below.end.wrapping_sub(1)
        } else {
            below.start
        };
        let next_ref = if level + 1 == LEVELS {
            NodeRef::leaf(next.start, LAST)
        } else {
            NodeRef::inner(next_index)
        };
        let mut children = [
            (next_ref, bounds(&next)),
            (NodeRef::leaf(alone.start, 1), bounds(&alone)),
        ];
        if !is_left {
            children.reverse();
        }
        let [(left, a), (right, b)] = children;
        nodes[index as usize] = Node {
            planes: [0, 1, 2].map(|axis| [a.min[axis], b.min[axis], a.max[axis], b.max[axis]]),
            left,
            right,
            first: start,
            last: end - 1,
        };
        below = if is_left {
            below.start..next_index
        } else {
            next_index + 1..below.end
        };
        (index, places) = (next_index, next);
    }
    nodes
}

/// A saved tree with other nodes and triangles, loaded.
fn with_lists(scene: &Scene, bvh: &Bvh, nodes: &[Node], triangles: &[LeafTriangle]) -> Saved {
    let mut bytes = Vec::new();
    write(scene, bvh, None, &mut bytes).expect("it is sound");
    let record = |section: Section| 64 + 32 * (section as usize - 1);
    let begin = |bytes: &[u8], section| {
        let at = record(section) + 8;
        u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes")) as usize
    };
    let hierarchy = begin(&bytes, Section::Hierarchy);
    bytes[hierarchy + 20..hierarchy + 24].copy_from_slice(&(nodes.len() as u32).to_le_bytes());
    // Both lists are the end of the file.
    bytes.truncate(begin(&bytes, Section::Nodes));
    let lists: [(Section, &[u8]); 2] = [
        (Section::Nodes, bytemuck::cast_slice(nodes)),
        (Section::Triangles, bytemuck::cast_slice(triangles)),
    ];
    for (section, list) in lists {
        bytes.resize(bytes.len().next_multiple_of(256), 0);
        let position = [bytes.len() as u64, list.len() as u64];
        bytes[record(section) + 8..][..16].copy_from_slice(bytemuck::cast_slice(&position));
        bytes.extend(list);
    }
    let length = bytes.len() as u64;
    bytes[24..32].copy_from_slice(&length.to_le_bytes());
    let mut checksum = crc32fast::Hasher::new();
    checksum.update(&bytes[..16]);
    checksum.update(&bytes[20..]);
    bytes[16..20].copy_from_slice(&checksum.finalize().to_le_bytes());
    match read(&bytes) {
        Ok(saved) => saved,
        Err(error) => panic!("{error}"),
    }
}

/// Rays that begin in all boxes of a chain: some hit the closest of many triangles, some end before it or at it.
pub fn rays_inside(bvh: &Bvh, count: usize) -> Vec<Ray> {
    let mut random = Random::new(9);
    let ray = |i: usize| {
        let origin = random.point() * INSIDE;
        let ray = Ray::new(origin.to_array(), random.direction().to_array());
        let t = bvh.closest_hit(ray).t;
        let t_max = [ray.t_max, ray.t_max, 1e-3, t, t.next_down(), 1.5 * t][i % 6];
        Ray { t_max, ..ray }
    };
    (0..count).map(ray).collect()
}

/// Rays of all kinds: those that begin in all boxes, those from outside, to the middle and away from it, and empty ones.
pub fn rays_around(bvh: &Bvh, count: usize) -> Vec<Ray> {
    let mut random = Random::new(10);
    let inside = rays_inside(bvh, count);
    let ray = |(i, inside): (usize, Ray)| {
        let origin = 5.0 * random.direction();
        let direction = random.point() - origin;
        let to_the_middle = Ray::new(origin.to_array(), direction.to_array());
        match i % 8 {
            0..3 => inside,
            3 => Ray {
                t_min: bvh.closest_hit(inside).t.min(inside.t_max),
                ..inside
            },
            4..6 => to_the_middle,
            6 => Ray::new(origin.to_array(), (-direction).to_array()),
            _ => Ray {
                t_min: 1.0,
                t_max: 0.5,
                ..to_the_middle
            },
        }
    };
    inside.into_iter().enumerate().map(ray).collect()
}

/// A stack that knows how many nodes waited in it at once.
struct Measured {
    stack: Stack<NodeRef>,
    most: u32,
}

impl Rows<NodeRef> for Measured {
    type Enter = f32;

    const ROWS: u32 = <Stack<NodeRef> as Rows<NodeRef>>::ROWS;

    fn put(&mut self, row: u32, cursor: NodeRef, enter: f32) {
        self.most = self.most.max(row + 1);
        self.stack.put(row, cursor, enter);
    }

    fn cursor(&self, row: u32) -> NodeRef {
        self.stack.cursor(row)
    }

    fn enter(&self, row: u32) -> f32 {
        self.stack.enter(row)
    }
}

/// Walks for the closest hit or for any with this stack. Returns whether the walk came to an end.
pub fn walked(
    bvh: &Bvh,
    ray: &Ray,
    is_any: bool,
    stack: &mut impl Rows<NodeRef, Enter: Distance>,
) -> bool {
    let (nodes, triangles) = (bvh.node_source(), bvh.triangle_source());
    let ray = PreparedRay::new(ray, bvh.scene_exponent());
    let mut search = if is_any {
        ClosestOrAny::any(ray.t_max)
    } else {
        ClosestOrAny::closest(ray.t_max)
    };
    traverse_with(stack, &nodes, &triangles, &ray, &Skip::NONE, &mut search)
}

/// How many nodes wait at once in a ray's searches for the closest hit and for any.
pub fn most_waiting(bvh: &Bvh, ray: &Ray) -> [u32; 2] {
    [false, true].map(|is_any| {
        let mut stack = Measured {
            stack: Stack::EMPTY,
            most: 0,
        };
        walked(bvh, ray, is_any, &mut stack);
        stack.most
    })
}

#[test]
fn rays_wait_on_every_level_of_a_chain_and_lose_no_hit() {
    for (side, search) in [(Side::Left, 0), (Side::Right, 1)] {
        let bvh = chain(side);
        let shape = validate_shape(bvh.nodes(), bvh.leaf_triangles(), LEVELS);
        assert!(shape.is_ok_and(|shape| shape.depth == LEVELS));
        let inside = rays_inside(&bvh, 300);
        for ray in &inside {
            assert_eq!(most_waiting(&bvh, ray)[search], LEVELS);
        }
        let around = rays_around(&bvh, 600);
        for rays in [inside, around] {
            match Parts::from(&bvh).compare(&rays) {
                Ok(hits) => assert!((100..rays.len() - 50).contains(&hits), "{hits}"),
                Err(disagreement) => panic!("{disagreement:#?}"),
            }
        }
    }
}
