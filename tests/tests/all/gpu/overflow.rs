//! Rays that need more of a stack than a lane has in workgroup memory are answered by the second pass: as the CPU answers them.

use super::codecs::{configs, snapped};
use super::pictures::check_as;
use super::trace::Answers;
use crate::deep_chains::{Side, coded_chain, rays_around, walked};
use crate::deepest_trees::ladder;
use crate::wide::wide_codecs;
use slimbvh::gpu::{self, Gpu};
use slimbvh::{BuildConfig, Bvh, CodeBits, Mesh, RenderSettings, TreeKind, View};
use slimbvh_core::launch::LANES;
use slimbvh_core::ray::PreparedRay;
use slimbvh_core::trace::{
    ClosestOrAny, FullWideNodes, FullWideRow, LANE_ROWS, LaneListStack, LaneStack, LaneWords,
    LeafTriangles, Skip, traverse_with,
};
use slimbvh_core::{LeafTriangle, Ray, Vec3};
use slimbvh_tests::build_as;
use slimbvh_tests::gpu::{done, gpu, is_software};
use slimbvh_tests::random::Random;
use slimbvh_tests::strategies::mesh_of;
use slimbvh_tests::validate::validate_shape;

/// Whether a ray's searches for the closest hit and for any need more rows than a lane has.
pub fn overflows(bvh: &Bvh, ray: &Ray) -> [bool; 2] {
    let mut words: LaneWords = [0; LANE_ROWS * LANES];
    [false, true].map(|is_any| !walked(bvh, ray, is_any, &mut LaneStack::new(&mut words, 7)))
}

/// How many rays do.
fn overflowing(bvh: &Bvh, rays: &[Ray]) -> [usize; 2] {
    let each: Vec<[bool; 2]> = rays.iter().map(|ray| overflows(bvh, ray)).collect();
    [0, 1].map(|search| each.iter().filter(|of| of[search]).count())
}

/// Rays through the corner that all boxes of a ladder reach, and others away from it.
fn rays_at_the_corner(count: usize, size: f32) -> Vec<Ray> {
    let mut random = Random::new(5);
    let ray = |i: usize| {
        let near = [0, 1, 2].map(|_| random.between(0.0, 0.5));
        let from = random.point() * if i.is_multiple_of(3) { 1.0 } else { size };
        let sign = if i % 5 == 4 { -1.0 } else { 1.0 };
        Ray::new(
            from.to_array(),
            [0, 1, 2].map(|axis| sign * (near[axis] - from[axis])),
        )
    };
    (0..count).map(ray).collect()
}

/// The answers of a tree that the CPU built, for rays in one dispatch.
fn check(gpu: &Gpu, bvh: &Bvh, rays: &[Ray]) {
    let uploaded = done(gpu::Bvh::upload(gpu, bvh));
    let answers = Answers::in_frame(gpu.frame(), &uploaded, rays);
    done(answers.compare(&Answers::of_cpu(bvh, rays), is_software(gpu)));
}

/// How many rays' searches for the closest hit need more rows than a lane has, in a tree of wide nodes in full.
fn overflowing_wide(bvh: &Bvh, rays: &[Ray]) -> usize {
    let [nodes, triangles] = bvh.stored();
    let rows: Vec<FullWideRow> = bytemuck::pod_collect_to_vec(nodes);
    let triangles: Vec<LeafTriangle> = bytemuck::pod_collect_to_vec(triangles);
    let (nodes, triangles) = (FullWideNodes(&rows), LeafTriangles(&triangles));
    let mut words: LaneWords = [0; LANE_ROWS * LANES];
    let overflows = |ray: &&Ray| {
        let ray = PreparedRay::new(ray, bvh.scene_exponent());
        let mut search = ClosestOrAny::closest(ray.t_max);
        let stack = &mut LaneListStack::new(&mut words, 7);
        !traverse_with(stack, &nodes, &triangles, &ray, &Skip::NONE, &mut search)
    };
    rays.iter().filter(overflows).count()
}

#[test]
fn rays_that_overflow_are_answered_in_every_codec() {
    let Some(gpu) = gpu() else { return };
    let (mesh, step_exponent) = snapped(&ladder(21, 1500), 0);
    let rays = rays_at_the_corner(500, (1u32 << 21) as f32);
    let plain = BuildConfig::from(CodeBits::Bits63);
    // Some do, and some do not.
    let [closest, _] = overflowing(&build_as(&mesh, plain), &rays);
    assert!(closest > 10 && closest < rays.len(), "{closest}");
    let coded = configs(CodeBits::Bits63, step_exponent);
    for config in [plain].into_iter().chain(coded) {
        check(gpu, &build_as(&mesh, config), &rays);
    }
}

/// All triangles have the origin as a corner and reach farther than the one before, so each is merged with all that are smaller.
fn nested(count: u32) -> Mesh {
    let corners = |i: u32| {
        let size = 2f32.powf((i as f32 - 170.0) / 3.0);
        [[0.0; 3], [size, 0.0, 0.0], [0.0, size, size]]
    };
    mesh_of(&(0..count).map(corners).collect::<Vec<_>>())
}

/// A tree that its builder made deep.
pub fn nested_tree() -> Bvh {
    let config = BuildConfig {
        tree: TreeKind::Clustered,
        ..BuildConfig::default()
    };
    build_as(&nested(340), config)
}

/// Rays whose searches for the closest hit all overflow in [`nested_tree`]: from just beside the corner, outwards along the face
/// of the boxes that they share.
pub fn rays_along_the_corner() -> Vec<Ray> {
    let ray = |i: u32| {
        let off = i as f32 * 2f32.powi(-80);
        Ray::new([-1.0, -off, -off], [1.0, off, off])
    };
    (0..300).map(ray).collect()
}

#[test]
fn a_deep_tree_is_traced_by_rays_that_all_overflow() {
    let Some(gpu) = gpu() else { return };
    let bvh = nested_tree();
    let shape = validate_shape(bvh.nodes(), bvh.leaf_triangles(), bvh.depth_bound());
    let depth = shape.map_or_else(|fault| panic!("{fault}"), |shape| shape.depth);
    assert!(depth > 2 * LANE_ROWS as u32, "{depth}");
    let rays = rays_along_the_corner();
    let [closest, _] = overflowing(&bvh, &rays);
    assert_eq!(closest, rays.len());
    check(gpu, &bvh, &rays);
}

/// Nodes of four children wait on fewer levels than nodes of two: in the trees above their rays do not overflow.
#[test]
fn deep_wide_trees_are_traced_by_rays_that_overflow() {
    let Some(gpu) = gpu() else { return };
    let mut most = 0;
    for side in [Side::Left, Side::Right] {
        let wide = |(nodes, mesh)| coded_chain(side, nodes, mesh);
        let [full, others @ ..] = wide_codecs(0).map(wide);
        let rays = rays_around(&full, 300);
        most = most.max(overflowing_wide(&full, &rays));
        for bvh in [full].iter().chain(&others) {
            check(gpu, bvh, &rays);
        }
    }
    assert!(most > 50, "{most}");
}

#[test]
fn pictures_count_rays_that_overflow_once() {
    let Some(gpu) = gpu() else { return };
    let mut scene = super::pictures::completed(ladder(10, 3000));
    let eye = Vec3::splat(-300.0);
    for camera in &mut scene.cameras {
        camera.eye = eye.to_array();
        camera.target = [0.2; 3];
    }
    for view in [View::Color, View::Heatmap] {
        let settings = RenderSettings {
            size: [40, 30],
            view,
            ..RenderSettings::default()
        };
        check_as(gpu, "ladder", &scene, &settings, BuildConfig::default());
    }
}
