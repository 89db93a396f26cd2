//! The kernels of core and the entry points of gpu-shaders, instantiated in a library without std and allocator, whose panic
//! handler does not link. If the library links, neither crate can panic or needs them.
#![no_std]

mod entry_points;

use core::panic::PanicInfo;
use slimbvh_core::bounds::{reduce_step, run_bounds, scene_exponent};
use slimbvh_core::camera::Camera;
use slimbvh_core::classify::{
    FacingFilter, PackedSides, Sides, VisibleSet, is_in_set, packed_sides, word_of_set,
};
use slimbvh_core::cluster::{
    Active, Merge, Merges, Rotated, Round, merge, merging_pairs, node_at, rotate, triangle_at,
    triangle_box,
};
use slimbvh_core::color::{pack_texel, srgb_bytes};
use slimbvh_core::compact::{is_set, pack_lanes, rank};
use slimbvh_core::decide::{
    Choice, Component, Measure, SetCounts, Span, Surfaces, Unit, count_step, join_step,
    lane_counts, lane_joined, lane_measure, lane_total,
};
use slimbvh_core::encode::{
    EncodedNode, EncodedPaper10, FINEST_STEP, FullWideNode, LatticeCodec, LatticeCursor,
    LatticeNodes, LatticeTriangles, LeafCorner, LeafWidth, Links, MixedWideNode, MixedWideRow,
    PackedWideNode, PackedWideNodes, PackedWideRow, Paper10Box, Paper10Codec, Paper10Node,
    Paper10Nodes, Paper10Triangle, Paper10Triangles, RootWords, RoundedChildren, RoundedNode,
    SharedTriangles, TriangleCorners, WideMixedNodes, WideNode, WideNodes, WideRow, corner_count,
    decode_node, decode_paper10_node, encode_paper10_triangle, encode_triangle, leaf_words,
    links_of, node_bounds, number_corners, scaled_step, store_shared_triangle, with_links,
};
use slimbvh_core::float::{PowerOfTwo, power_of_two};
use slimbvh_core::lanes::Each;
use slimbvh_core::lattice::LatticeBox;
use slimbvh_core::launch::{carries, run_begin, run_length, scan_block_count, scan_run};
use slimbvh_core::morton::{MortonGrid, morton_code_30, morton_code_63};
use slimbvh_core::orientation::{Orientation, Target};
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::refit::{
    Level, PyramidBox, group_bounds, pair_place, pair_step, parent_bounds, pyramid_size, refit_node,
};
use slimbvh_core::sampling::Draw;
use slimbvh_core::scan::{doubling_step, run_scan, run_sum, strided_sum};
use slimbvh_core::shade::{
    Environment, Light, Material, Path, Shadow, ambient_light, direct_light_or_dark, mean_radiance,
};
use slimbvh_core::snap::leaf_triangle;
use slimbvh_core::sort::tile::{
    clear, is_first, lane_scan, lane_sum, of_run, packed, packed_digit, packed_place, put,
    round_digit, take, word,
};
use slimbvh_core::sort::{DigitRun, digit, total_place};
use slimbvh_core::surface::Surface;
use slimbvh_core::topology::{Codes30, Codes63, internal_node, is_kept, kept_nodes};
use slimbvh_core::trace::{
    BruteForce, Children, ClosestHit, EndsFilter, FullWideNodes, FullWideRow, HitFilter, Lane,
    LaneBoxStack, LaneBoxWords, LaneStack, LaneWords, LeafTriangles, NodeRow, NodeRows, NodeSource,
    PacketStacks, PlainNodes, PreparedEnds, PreparedRays, Skip, TrianglePair, TriangleRows, UpTo,
    any_hit, closest_hit, nearest_hits, trace_packet, traverse_with,
};
use slimbvh_core::{
    Aabb, Hit, IndexedTriangles, LeafTriangle, Node, NodeRef, Ray, RayEnd, SurfacePoint,
    SurfaceRay, Triangle, Vec3, view,
};

unsafe extern "C" {
    /// Deliberately undefined: a reachable panic fails to link.
    fn slimbvh_core_can_panic() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    // SAFETY: it is undefined, so a library that links never calls it.
    unsafe { slimbvh_core_can_panic() }
}

/// The unwind tables of the precompiled core library refer to this function, which is never called.
#[unsafe(no_mangle)]
extern "C" fn rust_eh_personality() {}

/// Keeps a result, so that its computation is not optimized away.
type Out<'a, T> = &'a mut T;

#[unsafe(no_mangle)]
pub fn build(
    i: u32,
    triangles: &IndexedTriangles,
    boxes: &[Aabb; 64],
    to: Out<(Aabb, i32, MortonGrid, u32, [u32; 2], LeafTriangle)>,
) {
    let bounds = run_bounds(i, 64, triangles).union(reduce_step(i, 8, boxes));
    let grid = MortonGrid::new(&bounds, 21);
    let exponent = scene_exponent(&bounds);
    let own = triangles.triangle(i).bounds();
    *to = (
        bounds,
        exponent,
        grid,
        morton_code_30(&own, &grid),
        morton_code_63(&own, &grid),
        leaf_triangle(i, triangles, &PowerOfTwo::new(exponent)),
    );
}

#[unsafe(no_mangle)]
pub fn sort_and_scan(
    key: u32,
    lane: u32,
    (from, to, counters): (&mut [u32; 1024], &mut [u32; 1024], &mut [u32; 512]),
    values: &mut [u32],
    sums: &[u32; 64],
) -> u32 {
    let digit = digit::<256>(key, lane);
    let digits = DigitRun::EMPTY.with(digit);
    put(lane, packed(digits.digit, lane), from);
    clear(lane, counters);
    let item = of_run(lane, key, from);
    let rank = take(round_digit(item, key), lane, counters);
    put(rank, item, to);
    let run = scan_run(key);
    let begin = run_begin(lane, run, key);
    let sum = run_sum(values, begin, run_length(begin, run, key));
    let after = run_scan(values, key, lane, sum);
    lane_scan(lane, sum, lane_sum(lane, counters), counters);
    packed_digit(word(key, to))
        ^ packed_place(item)
        ^ doubling_step(lane, key, sums)
        ^ after
        ^ total_place(digit, lane, key)
        ^ u32::from(carries(sum, rank))
        ^ u32::from(is_first(lane, to) && digits.ends_at(digit))
        ^ strided_sum(values, lane, key, 64)
        ^ scan_block_count(key)
}

#[unsafe(no_mangle)]
pub fn connect(
    i: u32,
    codes_30: &[u32],
    codes_63: &[[u32; 2]],
    bits: &[u32],
    before: &[u32],
    to: Out<[(Node, u32); 2]>,
) -> u32 {
    let (short, long) = (Codes30::all(codes_30), Codes63::all(codes_63));
    *to = [
        internal_node(i, &short, bits, before),
        internal_node(i, &long, bits, before),
    ];
    let rank = rank(i, bits, before) ^ u32::from(is_set(i, bits));
    kept_nodes(i, &short) ^ kept_nodes(i, &long) ^ rank ^ u32::from(is_kept(i, &long))
}

#[unsafe(no_mangle)]
pub fn cluster(
    i: u32,
    round: Round,
    active: &Active,
    merges: &Merges,
    triangles: &[LeafTriangle],
    to: Out<(PyramidBox, Merge, Rotated, (Node, u32), u32)>,
) -> u32 {
    let merge = merge(i, round, active, merges, 0);
    *to = (
        triangle_box(i, triangles),
        merge,
        rotate(i, merge.rotation, active, merges),
        node_at(i, merges),
        triangle_at(i, merges),
    );
    merging_pairs(i, round, active.boxes, 0)
}

#[unsafe(no_mangle)]
pub fn refit(
    i: u32,
    triangles: &[LeafTriangle],
    (pyramid, boxes): (&[PyramidBox], &[PyramidBox; 64]),
    to: Out<(PyramidBox, PyramidBox, PyramidBox, Node)>,
) -> u32 {
    *to = (
        group_bounds(i, triangles),
        parent_bounds(i, Level::lowest(i).above(), pyramid),
        pair_step(i, 8, boxes),
        refit_node(
            Node {
                last: i,
                ..Node::EMPTY
            },
            i,
            triangles,
            pyramid,
        ),
    );
    pair_place(i, 8) ^ pyramid_size(i)
}

/// One thread's part of stage `encode` on a lattice.
#[inline(always)]
fn encode_on_lattice<const BITS: u32, const WORDS: usize>(
    i: u32,
    nodes: &[RoundedNode],
    node: &Node,
    to: Out<(EncodedNode<WORDS>, [u32; WORDS], [LatticeBox; 2], RootWords)>,
) -> u32 {
    let codec = LatticeCodec::<BITS, WORDS>;
    let step_exponent = scaled_step(FINEST_STEP, i as i32);
    let bounds = node_bounds(i, nodes, &codec);
    let encoded = codec.encode(&bounds, &RoundedNode::new(node, step_exponent));
    let triangle = Links::first_triangle(node.left, node.right);
    let links = Links::new(node.left, node.right, triangle);
    let words = with_links::<BITS, WORDS>(encoded.words, links);
    let root = RootWords::of_lattice(&bounds, step_exponent);
    *to = (
        encoded,
        words,
        decode_node::<BITS, WORDS>(&words, &bounds),
        root,
    );
    let width = LeafWidth::of(&encoded.left).words();
    let [left, right] = links_of::<BITS, WORDS>(&words).children(width);
    left.0 ^ right.0 ^ width
}

#[unsafe(no_mangle)]
pub fn encode_lattice_10(
    i: u32,
    nodes: &[RoundedNode],
    node: &Node,
    to: Out<(EncodedNode<4>, [u32; 4], [LatticeBox; 2], RootWords)>,
) -> u32 {
    encode_on_lattice::<10, 4>(i, nodes, node, to)
}

#[unsafe(no_mangle)]
pub fn encode_lattice_21(
    i: u32,
    nodes: &[RoundedNode],
    node: &Node,
    to: Out<(EncodedNode<7>, [u32; 7], [LatticeBox; 2], RootWords)>,
) -> u32 {
    encode_on_lattice::<21, 7>(i, nodes, node, to)
}

#[unsafe(no_mangle)]
pub fn encode_leaf(
    triangle: &LeafTriangle,
    bounds: &(LatticeBox, Paper10Box),
    opaque_zero: u32,
    to: Out<([u32; 10], Paper10Triangle)>,
) {
    *to = (
        encode_triangle(
            triangle,
            &LeafCorner::of(&bounds.0),
            power_of_two(FINEST_STEP),
        ),
        encode_paper10_triangle(triangle, &bounds.1, opaque_zero),
    );
}

/// A leaf whose triangles share corners is stored, wherever it lies and however many triangles it is said to have.
#[unsafe(no_mangle)]
pub fn encode_shared_leaf(
    (first, count, at): (u32, u32, u32),
    triangles: &[LeafTriangle],
    corner: &LeafCorner,
    corners: &mut [u32],
    words: &mut [u32],
) -> u32 {
    number_corners(first, count, triangles, corners);
    for (i, triangle) in triangles.iter().enumerate() {
        let own = [corners.get(i), corners.get(i + 1)];
        let own = own.map(|word| TriangleCorners(word.copied().unwrap_or(0)));
        store_shared_triangle::<true>(triangle, corner, own, 0.5, at, words);
        store_shared_triangle::<false>(triangle, corner, own, 0.5, at, words);
    }
    corner_count(first, count, corners) ^ leaf_words(count, first, corner.words)
}

/// Wide nodes are encoded, and stored ones decoded: any words, any number of a child.
#[unsafe(no_mangle)]
pub fn encode_wide(
    (from, counts): (&RoundedChildren, &[u32; 4]),
    (full, exact, packed): (&FullWideNode, &WideNode, &PackedWideNode),
    (child, first_child, first_word): (u32, u32, u32),
    to: Out<(
        WideNode,
        PackedWideNode,
        [LatticeBox; 2],
        Aabb,
        [NodeRef; 4],
    )>,
) -> u32 {
    let (node, words) = WideNode::encode(from, *counts);
    let (shared, shared_words) = PackedWideNode::encode(from, *counts);
    let links = packed.links();
    *to = (
        node.placed(from.count, first_child, first_word),
        shared.placed(from.count, first_child, first_word),
        [exact.child_box(child, 3), packed.child_box(child, 3)],
        full.child_box(child),
        links.children(),
    );
    let flags = [
        links.are_canonical(child),
        full.is_absent(child),
        exact.axes[0].is_absent(child, false),
    ];
    let words = [
        words ^ shared_words,
        exact.corner(child, 3).words ^ packed.corner(child, 3).words,
        exact.first_word(child) ^ packed.first_word(child),
        links.corner_count(child) ^ links.inner_count(),
    ];
    let all = words.into_iter().chain(flags.map(u32::from));
    all.fold(0, |all, word| all ^ word)
}

#[unsafe(no_mangle)]
pub fn encode_paper10(
    i: u32,
    nodes: &[Node],
    node: &Node,
    opaque_zero: u32,
    to: Out<(EncodedPaper10, [Paper10Box; 2], RootWords)>,
) {
    let codec = Paper10Codec { opaque_zero };
    let bounds = node_bounds(i, nodes, &codec);
    let encoded = codec.encode(&bounds, node);
    let boxes = decode_paper10_node(&encoded.node, &bounds, opaque_zero);
    *to = (encoded, boxes, RootWords::of_paper10(&bounds));
}

#[unsafe(no_mangle)]
pub fn trace_lattice(
    ray: &Ray,
    narrow: &[[u32; 4]],
    wide: &[[u32; 7]],
    words: &[u32],
    (triangles, root): (&[LeafTriangle], &RootWords),
    to: Out<(Hit, Hit, [Hit; 8])>,
) {
    let step = 0.5;
    let mixed = LatticeNodes::<10, 4, true> {
        nodes: narrow,
        root: root.lattice(),
        step,
    };
    let full = LatticeNodes::<21, 7, false> {
        nodes: wide,
        root: root.lattice(),
        step,
    };
    let (words, triangles) = (LatticeTriangles { words, step }, LeafTriangles(triangles));
    *to = (
        closest_hit(&mixed, &words, ray, 3, &Skip(4)),
        closest_hit(&full, &triangles, ray, 3, &Skip(4)),
        nearest_hits::<8, _, _, _>(&mixed, &words, ray, 3, &Skip::NONE),
    );
}

#[unsafe(no_mangle)]
pub fn trace_paper10(
    ray: &Ray,
    nodes: &[Paper10Node],
    triangles: &[Paper10Triangle],
    root: &RootWords,
    to: Out<(Hit, bool)>,
) {
    let opaque_zero = root.opaque_zero();
    let nodes = Paper10Nodes {
        nodes,
        root: root.paper10(),
        opaque_zero,
    };
    let triangles = Paper10Triangles {
        triangles,
        opaque_zero,
    };
    *to = (
        closest_hit(&nodes, &triangles, ray, root.step_exponent(), &Skip(4)),
        any_hit(&nodes, &triangles, ray, 3, &Skip(4)),
    );
}

#[unsafe(no_mangle)]
pub fn trace_together(
    rays: &[Ray; 8],
    (nodes, narrow): (&[Node], &[[u32; 4]]),
    triangles: &[LeafTriangle],
    root: &RootWords,
    stacks: (
        &mut PacketStacks<Children<NodeRef>, Each<8>>,
        &mut PacketStacks<Children<LatticeCursor>, Each<8>>,
        &mut PreparedRays<Each<8>, 8>,
    ),
    to: Out<[[Lane<Skip, ClosestHit>; 8]; 2]>,
) {
    let triangles = LeafTriangles(triangles);
    let coded = LatticeNodes::<10, 4, false> {
        nodes: narrow,
        root: root.lattice(),
        step: 0.5,
    };
    let (first, second, prepared) = stacks;
    prepared.prepare(rays, 3);
    for packet in to.iter_mut() {
        for (lane, t_max) in packet.iter_mut().zip(prepared.t_max()) {
            *lane = Lane {
                filter: Skip(4),
                collector: ClosestHit::new(*t_max),
            };
        }
    }
    let [plain, other] = to;
    trace_packet(first, &PlainNodes(nodes), &triangles, prepared, plain);
    trace_packet(second, &coded, &triangles, prepared, other);
    for (i, lane) in plain.iter_mut().enumerate() {
        lane.collector.hit = prepared.restore(i, lane.collector.hit);
    }
}

/// Packets over wide nodes in all four stores. Those on the lattice are opened as the same type: one stack serves them.
#[unsafe(no_mangle)]
pub fn trace_wide_together(
    rays: &[Ray; 8],
    (full, exact): (&[FullWideRow], &[WideRow]),
    (mixed, packed): (&[MixedWideRow], &[PackedWideRow]),
    (triangles, words, root): (&[LeafTriangle], &[u32], &RootWords),
    stacks: (
        &mut PacketStacks<<FullWideNodes<'static> as NodeSource>::Node, Each<8>>,
        &mut PacketStacks<<WideNodes<'static> as NodeSource>::Node, Each<8>>,
        &mut PreparedRays<Each<8>, 8>,
    ),
    to: Out<[[Lane<Skip, ClosestHit>; 8]; 4]>,
) {
    let (whole, coded, prepared) = stacks;
    prepared.prepare(rays, 3);
    let step = 0.5;
    let root = root.lattice();
    let in_full = LeafTriangles(triangles);
    let [first, second, third, fourth] = to;
    trace_packet(whole, &FullWideNodes(full), &in_full, prepared, first);
    let nodes = exact;
    let nodes = WideNodes { nodes, root, step };
    trace_packet(coded, &nodes, &in_full, prepared, second);
    let nodes = mixed;
    let nodes = WideMixedNodes { nodes, root, step };
    let apart = LatticeTriangles { words, step };
    trace_packet(coded, &nodes, &apart, prepared, third);
    let nodes = packed;
    let nodes = PackedWideNodes { nodes, root, step };
    let shared = SharedTriangles { words, step };
    trace_packet(coded, &nodes, &shared, prepared, fourth);
}

/// The walk with stacks in a workgroup's memory, over rows of 16 bytes and over coded nodes.
#[unsafe(no_mangle)]
pub fn trace_in_lane(
    (ray, lane, hit_count): (&PreparedRay, u32, u32),
    (nodes, narrow): (&[NodeRow], &[[u32; 4]]),
    triangles: &[TrianglePair],
    root: &RootWords,
    sides: (&[u32], Target),
    (words, box_words): (&mut LaneWords, &mut LaneBoxWords),
    to: Out<[UpTo<8>; 2]>,
) -> bool {
    let triangles = TriangleRows(triangles);
    let coded = LatticeNodes::<10, 4, false> {
        nodes: narrow,
        root: root.lattice(),
        step: 0.5,
    };
    let filter = FacingFilter {
        skip: 4,
        sides: PackedSides(sides.0),
        target: sides.1,
    };
    *to = [UpTo::new(hit_count, ray.t_max); 2];
    let [first, second] = to;
    let mut stack = LaneStack::new(words, lane);
    let plain = traverse_with(
        &mut stack,
        &NodeRows(nodes),
        &triangles,
        ray,
        &filter,
        first,
    );
    let mut stack = LaneBoxStack::new(box_words, lane);
    plain & traverse_with(&mut stack, &coded, &triangles, ray, &filter, second)
}

#[unsafe(no_mangle)]
pub fn trace(
    ray: &Ray,
    nodes: &[Node],
    triangles: &[LeafTriangle],
    facing: (&[u32], &[i32], Target),
    to: Out<(Hit, bool, [Hit; 8], Hit)>,
) {
    let (components, sides, target) = facing;
    let rule = FacingFilter {
        skip: 4,
        sides: Sides { components, sides },
        target: target.scaled(&PowerOfTwo::new(3)),
    };
    let (nodes, triangles) = (PlainNodes(nodes), LeafTriangles(triangles));
    *to = (
        closest_hit(&nodes, &triangles, ray, 3, &Skip(4)),
        any_hit(&nodes, &triangles, ray, 3, &rule),
        nearest_hits::<8, _, _, _>(&nodes, &triangles, ray, 3, &Skip::NONE),
        closest_hit(&BruteForce(9), &triangles, ray, 3, &Skip(4)),
    );
}

#[unsafe(no_mangle)]
pub fn classify(
    primitive: u32,
    mesh: &IndexedTriangles,
    reach: &VisibleSet,
    flags: &[u32; 64],
) -> u32 {
    let scale = PowerOfTwo::new(5);
    let reach = reach.scaled(&scale);
    u32::from(is_in_set(primitive, mesh, &scale, &reach))
        ^ word_of_set(primitive, mesh, &scale, &reach)
        ^ packed_sides(primitive, &reach.sides)
        ^ pack_lanes(primitive, flags)
}

#[unsafe(no_mangle)]
pub fn decide(
    lane: u32,
    parts: &(Span, Component, Surfaces, Choice, Target),
    measures: &[Measure; 64],
    counts: &[SetCounts; 64],
    to: Out<(Measure, Measure, Measure, SetCounts, SetCounts)>,
) -> i32 {
    let (span, component, surfaces, choice, target) = parts;
    let unit = Unit {
        scale: PowerOfTwo::new(5),
        opaque_zero: 0,
    };
    *to = (
        lane_measure(lane, span, surfaces, &unit),
        lane_joined(lane, component, measures),
        join_step(lane, lane, measures),
        lane_counts(lane, lane, choice).plus(count_step(lane, lane, counts)),
        lane_total(lane, counts).decided(),
    );
    to.0.side(target)
}

#[unsafe(no_mangle)]
pub fn shade(
    camera: &Camera,
    triangle: &Triangle,
    hit: &Hit,
    scene: &(Light, Material, Environment, Target),
    to: Out<(Path, Path, Shadow, Orientation, Vec3)>,
) {
    let (light, material, environment, target) = scene;
    let scale = PowerOfTwo::new(9);
    let sample = camera.sample_of_thread(hit.primitive);
    let path = Path::new(camera.scaled(&scale).ray(sample), sample);
    let draw = Draw {
        sample: hit.primitive,
        sample_count: camera.sample_count,
        bounce: 1,
    };
    let normal = triangle.normal();
    let surface = Surface::new(*triangle, hit, normal, [normal; 3]);
    *to = (
        path.with_light(ambient_light(material, environment))
            .scattered(&surface, material, hit.primitive),
        path.escaped(environment),
        direct_light_or_dark(
            &surface,
            hit.primitive,
            material,
            &light.scaled(&scale).sampled(&draw),
        ),
        Orientation::new(triangle, target),
        mean_radiance(&[path], hit.primitive, 2),
    );
}

#[unsafe(no_mangle)]
pub fn leave(
    (triangle, hit, direction): (&Triangle, &Hit, &Vec3),
    ray: &PreparedRay,
    other: &RayEnd,
    to: Out<(SurfacePoint, SurfaceRay, SurfaceRay, [[f32; 3]; 2], bool)>,
) {
    let surface = Surface::new(*triangle, hit, *direction, [*direction; 3]);
    let point = SurfacePoint::new(&surface, hit.primitive, ray.t_exponent);
    let between = Ray::between(&point, *other);
    let filter = EndsFilter(PreparedEnds {
        ray,
        ends: &between.ends,
        scene_exponent: ray.t_exponent,
    });
    let corners = [triangle.v0, triangle.v1, triangle.v2].map(|v| v.to_array());
    *to = (
        point,
        between,
        point.ray(direction.to_array()),
        [point.leave(), point.enter()],
        filter.accepts(hit.primitive, &corners, ray.axes),
    );
}

#[unsafe(no_mangle)]
pub fn show(
    hit: &Hit,
    normal: &Vec3,
    items: &[[u32; 2]],
    values: &[u32],
    to: Out<[Vec3; 6]>,
) -> u32 {
    let i = view::depth_value(hit);
    *to = [
        view::normal_color(*normal),
        view::primitive_color(hit.primitive),
        view::depth_color(hit.t, hit.u, hit.v),
        view::heat_color(hit.primitive, 9),
        view::mean_depth_color(values, i, 4, view::depth_range(items)),
        view::mean_heat_color(values, i, 4, view::heat_range(items)),
    ];
    pack_texel(srgb_bytes(*normal))
}

#[cfg(feature = "plant-panic")]
#[unsafe(no_mangle)]
pub fn planted_panic(i: usize, slice: &[u32]) -> u32 {
    slice[i]
}

#[cfg(feature = "plant-alloc")]
extern crate alloc;

#[cfg(feature = "plant-alloc")]
#[unsafe(no_mangle)]
pub fn planted_alloc(n: u32) -> *mut u32 {
    alloc::boxed::Box::into_raw(alloc::boxed::Box::new(n))
}
