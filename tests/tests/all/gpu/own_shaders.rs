//! The functions for the caller's own shaders answer as the CPU does, whatever the depth of the tree; those with stacks in
//! workgroup memory say which rays overflow them.

use super::filtered::{balls, configs};
use super::overflow::{nested_tree, overflows, rays_along_the_corner};
use super::trace::{Answers, rays_at};
use crate::deep_chains::{Side, chain, most_waiting, rays_around, rays_inside};
use slimbvh::generate::soup;
use slimbvh::gpu::{self, Gpu, Kernel, wgpu};
use slimbvh::{BuildConfig, Builder, Bvh, CodeBits, MeshCodec, NodeCodec, WideStore};
use slimbvh_core::frustum::Frustum;
use slimbvh_core::launch::LANES;
use slimbvh_core::orientation::Target;
use slimbvh_core::{Hit, NO_PRIMITIVE, Ray, RayEnds, SurfaceRay};
use slimbvh_tests::build;
use slimbvh_tests::gpu::{Dispatch, answers, contents, done, gpu, is_software, storage};
use slimbvh_tests::parity::{close_hits, mostly_equal, same_bits};

/// Asks for the closest hit and for any. The calls put the answers into `hit`, `any` and `flags`: bit 0 where the search for the
/// closest hit overflowed, bit 1 where that for any hit did.
const SHADER: &str = "
struct Ray { origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32 }
@group(0) @binding(0) var<storage> rays: array<Ray>;
@group(0) @binding(1) var<storage, read_write> hits: array<vec4<u32>>;
@group(0) @binding(2) var<storage, read_write> found: array<u32>;
@group(0) @binding(3) var<storage, read_write> overflowed: array<u32>;

@compute @workgroup_size(LANES)
fn ask(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    if id.x < arrayLength(&rays) {
        let ray = rays[id.x];
        let skip = found[id.x];
        var hit = SlimbvhHit();
        var any = false;
        var flags = 0u;
        CALLS
        hits[id.x] = vec4(bitcast<vec3<u32>>(vec3(hit.t, hit.u, hit.v)), hit.primitive);
        found[id.x] = u32(any);
        overflowed[id.x] = flags;
    }
}
";

/// The functions for any stage.
pub const ANYWHERE: &str = "
    hit = slimbvh_closest_hit(ray.origin, ray.t_min, ray.direction, ray.t_max);
    any = slimbvh_any_hit(ray.origin, ray.t_min, ray.direction, ray.t_max);
";

/// Those for compute shaders.
pub const IN_GROUP: &str = "
    hit = slimbvh_closest_hit_in_group(lane, ray.origin, ray.t_min, ray.direction, ray.t_max);
    any = slimbvh_any_hit_in_group(lane, ray.origin, ray.t_min, ray.direction, ray.t_max);
";

/// Those that trace nothing again.
const TRY: &str = "
    let tried_hit = slimbvh_try_closest_hit(lane, ray.origin, ray.t_min, ray.direction, ray.t_max);
    let tried_any = slimbvh_try_any_hit(lane, ray.origin, ray.t_min, ray.direction, ray.t_max);
    hit = tried_hit.hit;
    any = tried_any.found;
    flags = u32(tried_hit.overflowed) | 2u * u32(tried_any.overflowed);
";

/// Fills the lane's stack, as another's memory would be found in it.
const FILL: &str = "
    for (var i = lane; i < 2048u; i += 64u) { slimbvh_stacks[i] = 0x9e3779b9u * (i + 1u); }
";

/// What a shader answers, for each ray.
pub struct Replies {
    pub closest: Vec<Hit>,
    pub any: Vec<u32>,
    /// The flags of [`SHADER`].
    overflowed: Vec<u32>,
}

/// Runs [`SHADER`] with these calls behind a text, in workgroups of `lanes`. The tree's bindings are in group 1.
pub fn ask(
    gpu: &Gpu,
    tree: gpu::Tree,
    rays: &[Ray],
    text_and_calls: (&str, &str),
    lanes: u32,
) -> Replies {
    // An answer that is not written stays another than any.
    let skips = vec![0x7777; rays.len()];
    ask_skipping(gpu, tree, (rays, &skips), text_and_calls, lanes)
}

/// [`ask`], with a primitive to leave out for each ray.
fn ask_skipping(
    gpu: &Gpu,
    tree: gpu::Tree,
    (rays, skips): (&[Ray], &[u32]),
    (text, calls): (&str, &str),
    lanes: u32,
) -> Replies {
    let device = gpu.device();
    let shader = SHADER.replace("LANES", &lanes.to_string());
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("ask"),
        source: wgpu::ShaderSource::Wgsl(
            (text.to_owned() + &shader.replace("CALLS", calls)).into(),
        ),
    });
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some("ask"),
        layout: None,
        module: &module,
        entry_point: Some("ask"),
        compilation_options: wgpu::PipelineCompilationOptions {
            zero_initialize_workgroup_memory: false,
            ..wgpu::PipelineCompilationOptions::default()
        },
        cache: None,
    });
    let nothing = vec![0x7777u32; 4 * rays.len()];
    let buffers = [
        storage(gpu, rays),
        storage(gpu, &nothing),
        storage(gpu, skips),
        storage(gpu, &nothing[..rays.len()]),
    ];
    let own = [0, 1, 2, 3].map(|binding| wgpu::BindGroupEntry {
        binding: binding as u32,
        resource: buffers[binding].as_entire_binding(),
    });
    let bind = |group: u32, entries: &[wgpu::BindGroupEntry]| {
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("ask"),
            layout: &pipeline.get_bind_group_layout(group),
            entries,
        })
    };
    let groups = [bind(0, &own), bind(1, &done(tree.bindings()))];
    let mut frame = gpu.frame();
    let mut pass = frame.encoder().begin_compute_pass(&Default::default());
    pass.set_pipeline(&pipeline);
    pass.set_bind_group(0, &groups[0], &[]);
    pass.set_bind_group(1, &groups[1], &[]);
    pass.dispatch_workgroups((rays.len() as u32).div_ceil(lanes), 1, 1);
    drop(pass);
    done(frame.submit());
    Replies {
        closest: contents(gpu, &buffers[1]),
        any: contents(gpu, &buffers[2]),
        overflowed: contents(gpu, &buffers[3]),
    }
}

impl Replies {
    /// Compares with the CPU's answers: to the bit on a software adapter.
    fn compare(&self, bvh: &Bvh, rays: &[Ray], is_software: bool) -> Result<(), String> {
        let closest: Vec<Hit> = rays.iter().map(|ray| bvh.closest_hit(ray)).collect();
        let any: Vec<u32> = rays.iter().map(|ray| bvh.any_hit(ray).into()).collect();
        if is_software {
            same_bits(&self.any, &any)?;
            return same_bits(&self.closest, &closest);
        }
        mostly_equal(&self.any, &any)?;
        close_hits(&self.closest, &closest)
    }

    /// How many rays overflowed a stack, in both searches.
    fn overflow_counts(&self) -> [usize; 2] {
        [1, 2].map(|bit| {
            self.overflowed
                .iter()
                .filter(|&flags| flags & bit != 0)
                .count()
        })
    }
}

/// Asks by all functions. All answers are those of the CPU, but those of rays that overflowed where nothing is traced again.
/// Returns how many did, in the searches for the closest hit and for any.
fn check(gpu: &Gpu, bvh: &Bvh, rays: &[Ray]) -> [usize; 2] {
    let uploaded = done(gpu::Bvh::upload(gpu, bvh));
    let tree = gpu::Tree::all(&uploaded);
    let software = is_software(gpu);
    let codecs = done(uploaded.codecs());
    let text = done(gpu::wgsl_for(codecs, 1));
    let text_compute = done(gpu::wgsl_compute_for(codecs, 1));
    let lanes = LANES as u32;
    for (text, calls) in [
        (&text, ANYWHERE),
        (&text_compute, ANYWHERE),
        (&text_compute, IN_GROUP),
        (&text_compute, &format!("{FILL}{IN_GROUP}")),
    ] {
        let replies = ask(gpu, tree, rays, (text.as_str(), calls), lanes);
        done(replies.compare(bvh, rays, software));
        assert_eq!(replies.overflow_counts(), [0, 0]);
    }
    let tried = ask(gpu, tree, rays, (&text_compute, TRY), lanes);
    let filled = format!("{FILL}{TRY}");
    let again = ask(gpu, tree, rays, (&text_compute, &filled), lanes);
    assert_eq!(tried.overflowed, again.overflowed);

    // Without those that overflowed, for which the answers are misses.
    let both = |i: &usize| tried.overflowed[*i] == 0;
    let whole: Vec<usize> = (0..rays.len()).filter(both).collect();
    let pick = |replies: &Replies| Replies {
        closest: whole.iter().map(|&i| replies.closest[i]).collect(),
        any: whole.iter().map(|&i| replies.any[i]).collect(),
        overflowed: Vec::new(),
    };
    let whole_rays: Vec<Ray> = whole.iter().map(|&i| rays[i]).collect();
    for replies in [&tried, &again] {
        done(pick(replies).compare(bvh, &whole_rays, software));
        for (i, flags) in replies.overflowed.iter().enumerate() {
            assert!(flags & 1 == 0 || replies.closest[i] == Hit::MISS);
            assert!(flags & 2 == 0 || replies.any[i] == 0);
        }
    }
    if software && !bvh.nodes().is_empty() {
        let flags = |ray: &Ray| {
            let [closest, any] = overflows(bvh, ray);
            u32::from(closest) | u32::from(any) << 1
        };
        let expected: Vec<u32> = rays.iter().map(flags).collect();
        done(same_bits(&tried.overflowed, &expected));
    }

    // Where rays with hits overflowed, a shader that does not trace them again is found out.
    let lost = (0..rays.len()).any(|i| !both(&i) && bvh.any_hit(rays[i]));
    assert_eq!(tried.compare(bvh, rays, software).is_err(), lost);
    tried.overflow_counts()
}

#[test]
fn shaders_of_the_callers_get_the_same_answers() {
    let Some(gpu) = gpu() else { return };
    let mesh = soup(3000, 6);
    let rays = rays_at(&mesh, 2000, 1);
    assert_eq!(check(gpu, &build(&mesh, CodeBits::Bits30), &rays), [0, 0]);
}

#[test]
fn shaders_of_the_callers_trace_wide_trees() {
    let Some(gpu) = gpu() else { return };
    let mut mesh = soup(3000, 6);
    mesh.snap(-12);
    let rays = rays_at(&mesh, 1000, 1);
    let lattice = MeshCodec::Lattice { step_exponent: -12 };
    for (store, triangles) in [
        (WideStore::Full, MeshCodec::F32),
        (WideStore::Exact, MeshCodec::F32),
        (WideStore::Exact, lattice),
        (WideStore::Packed, lattice),
    ] {
        let config = BuildConfig {
            nodes: NodeCodec::Wide(store),
            mesh: triangles,
            ..BuildConfig::default()
        };
        let bvh = done(Builder::new(config).build(&mesh));
        assert_eq!(check(gpu, &bvh, &rays), [0, 0]);
    }
}

#[test]
fn shaders_of_the_callers_trace_trees_over_100_deep() {
    let Some(gpu) = gpu() else { return };
    for (side, search) in [(Side::Left, 0), (Side::Right, 1)] {
        let bvh = chain(side);
        let rays = rays_around(&bvh, 1000);
        let deep = |ray: &&Ray| most_waiting(&bvh, ray)[search] > 100;
        assert!(rays.iter().filter(deep).count() > 300);
        let counts = check(gpu, &bvh, &rays);
        assert!((300..900).contains(&counts[search]), "{counts:?}");

        // The library's own kernels, with their second pass.
        let uploaded = done(gpu::Bvh::upload(gpu, &bvh));
        let answers = Answers::in_frame(gpu.frame(), &uploaded, &rays);
        done(answers.compare(&Answers::of_cpu(&bvh, &rays), is_software(gpu)));
    }
}

#[test]
fn every_ray_that_overflows_is_reported() {
    let Some(gpu) = gpu() else { return };
    let chains = [Side::Left, Side::Right].map(chain);
    let [left, right] = chains.map(|bvh| (rays_inside(&bvh, 300), bvh));
    let nested = (rays_along_the_corner(), nested_tree());
    for ((rays, bvh), search, kernel) in [
        (left, 0, Kernel::trace_closest),
        (right, 1, Kernel::trace_any),
        (nested, 0, Kernel::trace_closest),
    ] {
        assert_eq!(check(gpu, &bvh, &rays)[search], rays.len());
        let mut listed = listed(gpu, kernel, &bvh, &rays);
        listed.sort_unstable();
        assert!(listed.into_iter().eq(0..rays.len() as u32));
    }
}

/// The rays on a kernel's list.
fn listed(gpu: &Gpu, kernel: Kernel, bvh: &Bvh, rays: &[Ray]) -> Vec<u32> {
    let mut triangles: Vec<u8> = bytemuck::cast_slice(bvh.leaf_triangles()).to_vec();
    // In pairs.
    triangles.resize(triangles.len().next_multiple_of(80), 0);
    let exponent = [bvh.scene_exponent() as u32, 0, 0, 0];
    let outputs = Dispatch {
        kernel,
        group_count: rays.len().div_ceil(LANES) as u32,
        uniforms: &[&exponent, &[rays.len() as u32; 4]],
        reads: &[
            bytemuck::cast_slice(bvh.nodes()),
            &triangles,
            bytemuck::cast_slice(rays),
        ],
        outputs: &[
            &vec![0; rays.len() * size_of::<Hit>()],
            &vec![0; (rays.len() + 1) * size_of::<u32>()],
        ],
    }
    .run(gpu);
    let list: Vec<u32> = answers(&outputs[1]);
    list[1..=list[0] as usize].to_vec()
}

#[test]
fn workgroups_of_any_size_get_the_same_answers() {
    let Some(gpu) = gpu() else { return };
    let mesh = soup(3000, 6);
    let rays = rays_at(&mesh, 500, 2);
    let bvh = build(&mesh, CodeBits::Bits30);
    let uploaded = done(gpu::Bvh::upload(gpu, &bvh));
    let text = gpu::wgsl_compute(1);
    for lanes in [1, 20, 64, 65, 256] {
        let replies = ask(
            gpu,
            gpu::Tree::all(&uploaded),
            &rays,
            (&text, IN_GROUP),
            lanes,
        );
        done(replies.compare(&bvh, &rays, is_software(gpu)));
        // Lanes beyond the last stack are reported as if theirs were full.
        let tried = ask(gpu, gpu::Tree::all(&uploaded), &rays, (&text, TRY), lanes);
        let has_none = |i: usize| i as u32 % lanes >= LANES as u32;
        let expected: Vec<u32> = (0..rays.len())
            .map(|i| 3 * u32::from(has_none(i)))
            .collect();
        done(same_bits(&tried.overflowed, &expected));
    }
    // Lanes that share a stack spoil each other's.
    let shared = IN_GROUP.replace("lane", "lane / 2u");
    let replies = ask(gpu, gpu::Tree::all(&uploaded), &rays, (&text, &shared), 64);
    assert!(replies.compare(&bvh, &rays, is_software(gpu)).is_err());
}

/// Leaves out a primitive, by all functions.
const SKIPS: [&str; 3] = [
    "
    hit = slimbvh_closest_hit_from(ray.origin, ray.t_min, ray.direction, ray.t_max, skip);
    any = slimbvh_any_hit_from(ray.origin, ray.t_min, ray.direction, ray.t_max, skip);
",
    "
    hit = slimbvh_closest_hit_from_in_group(lane, ray.origin, ray.t_min, ray.direction, ray.t_max, skip);
    any = slimbvh_any_hit_from_in_group(lane, ray.origin, ray.t_min, ray.direction, ray.t_max, skip);
",
    "
    hit = slimbvh_try_closest_hit_from(lane, ray.origin, ray.t_min, ray.direction, ray.t_max, skip).hit;
    any = slimbvh_try_any_hit_from(lane, ray.origin, ray.t_min, ray.direction, ray.t_max, skip).found;
",
];

/// One shader serves a whole tree without a rule and with one, and may leave out a primitive.
#[test]
fn shaders_of_the_callers_leave_out_what_a_rule_rejects_and_a_primitive() {
    let Some(gpu) = gpu() else { return };
    let (mesh, components) = balls();
    let target = Target::position([0.3, 2.0, -1.0]);
    for config in [configs()[0], configs()[4]] {
        let bvh = done(Builder::new(config).build(&mesh));
        let rays = rays_at(&mesh, 400, 5);
        let uploaded = done(gpu::Bvh::upload(gpu, &bvh));
        let on_gpu = done(gpu::Components::upload(gpu, &components));
        let mut facing = gpu::TargetSides::new();
        let mut frame = gpu.frame();
        let place = (&target, &Frustum::EVERYWHERE);
        done(facing.set(&mut frame, &on_gpu, place, &[1, -1]));
        done(frame.submit());
        let all = gpu::Tree::all(&uploaded);
        let ruled = gpu::Tree {
            bvh: &uploaded,
            rule: Some((&on_gpu, &facing)),
        };
        // The first hits are left out: the library's own traces of the same tree give the answers.
        let first = storage(gpu, &rays);
        let found = |tree: gpu::Tree, skips: &[u32]| {
            let ends: Vec<RayEnds> = skips.iter().map(|&skip| RayEnds::skipping(skip)).collect();
            let (ends, hits) = (
                storage(gpu, &ends),
                storage(gpu, &vec![Hit::MISS; rays.len()]),
            );
            let rays = gpu::Rays::new(first.slice(..)).with_ends(ends.slice(..));
            let mut frame = gpu.frame();
            done(tree.trace(&mut frame, gpu::Query::Closest, rays, hits.slice(..)));
            done(frame.submit());
            contents::<Hit>(gpu, &hits)
        };
        let text = done(gpu::wgsl_compute_for(done(uploaded.codecs()), 1));
        for tree in [all, ruled] {
            let none = found(tree, &vec![NO_PRIMITIVE; rays.len()]);
            let skips: Vec<u32> = none.iter().map(|hit| hit.primitive).collect();
            let expected = found(tree, &skips);
            assert!(same_bits(&expected, &none).is_err());
            for calls in SKIPS {
                let given = (rays.as_slice(), skips.as_slice());
                let replies = ask_skipping(gpu, tree, given, (&text, calls), LANES as u32);
                done(close_hits(&replies.closest, &expected));
                if is_software(gpu) {
                    done(same_bits(&replies.closest, &expected));
                    let any = expected.iter().map(|hit| u32::from(hit.is_hit()));
                    done(same_bits(&replies.any, &any.collect::<Vec<_>>()));
                }
            }
        }
        // The negative control: the rule rejects hits.
        let [with, without] = [ruled, all].map(|tree| ask(gpu, tree, &rays, (&text, IN_GROUP), 64));
        assert!(same_bits(&with.closest, &without.closest).is_err());
    }
}

/// Stores what `slimbvh_surface` returns for each hit.
const SURFACES: &str = "
struct Ray { origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32 }
@group(0) @binding(0) var<storage> rays: array<Ray>;
@group(0) @binding(1) var<storage> vertices: array<f32>;
@group(0) @binding(2) var<storage> indices: array<u32>;
@group(0) @binding(3) var<storage, read_write> points: array<f32>;

fn corner(primitive: u32, i: u32) -> vec3<f32> {
    let at = 3u * indices[3u * primitive + i];
    return vec3<f32>(vertices[at], vertices[at + 1u], vertices[at + 2u]);
}

fn put(at: u32, v: vec3<f32>) {
    points[at] = v.x;
    points[at + 1u] = v.y;
    points[at + 2u] = v.z;
}

@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x < arrayLength(&rays) {
        let ray = rays[id.x];
        let hit = slimbvh_closest_hit(ray.origin, ray.t_min, ray.direction, ray.t_max);
        if hit.primitive != 0xffffffffu {
            let i = hit.primitive;
            let found = slimbvh_surface(corner(i, 0u), corner(i, 1u), corner(i, 2u), hit, ray.direction);
            let at = 16u * id.x;
            put(at, found.position);
            put(at + 3u, found.error);
            put(at + 6u, found.normal);
            put(at + 9u, found.leave);
            put(at + 12u, found.enter);
            points[at + 15u] = found.side;
        }
    }
}
";

/// At several magnitudes. A point off by one bit is found.
#[test]
fn surfaces_in_wgsl_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    for scale in [1.0, 1e-20, 3e15] {
        let (mut mesh, _) = balls();
        for vertex in &mut mesh.vertices {
            *vertex = vertex.map(|x| x * scale);
        }
        let bvh = build(&mesh, CodeBits::Bits30);
        let rays = rays_at(&mesh, 500, 3);
        let uploaded = done(gpu::Bvh::upload(gpu, &bvh));
        let device = gpu.device();
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("ask"),
            source: wgpu::ShaderSource::Wgsl((gpu::wgsl(1) + SURFACES).into()),
        });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some("ask"),
            layout: None,
            module: &module,
            entry_point: Some("ask"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            cache: None,
        });
        let buffers = [
            storage(gpu, &rays),
            storage(gpu, &mesh.vertices),
            storage(gpu, bytemuck::cast_slice::<_, u32>(&mesh.indices)),
            storage(gpu, &vec![0.0f32; 16 * rays.len()]),
        ];
        let own = [0, 1, 2, 3].map(|binding| wgpu::BindGroupEntry {
            binding: binding as u32,
            resource: buffers[binding].as_entire_binding(),
        });
        let bind = |group: u32, entries: &[wgpu::BindGroupEntry]| {
            device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("ask"),
                layout: &pipeline.get_bind_group_layout(group),
                entries,
            })
        };
        let groups = [bind(0, &own), bind(1, &done(uploaded.bindings()))];
        let mut frame = gpu.frame();
        let mut pass = frame.encoder().begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &groups[0], &[]);
        pass.set_bind_group(1, &groups[1], &[]);
        pass.dispatch_workgroups((rays.len() as u32).div_ceil(64), 1, 1);
        drop(pass);
        done(frame.submit());
        let found: Vec<[f32; 16]> = contents(gpu, &buffers[3]);

        let expected: Vec<[f32; 16]> = rays
            .iter()
            .map(|ray| {
                let point = bvh.surface(&mesh, SurfaceRay::from(ray), &bvh.closest_hit(ray));
                let mut numbers = [0.0; 16];
                if let Some(point) = point {
                    let parts = [
                        point.position,
                        point.error,
                        point.normal,
                        point.leave(),
                        point.enter(),
                    ];
                    numbers[..15].copy_from_slice(parts.as_flattened());
                    numbers[15] = point.side;
                }
                numbers
            })
            .collect();
        assert!(expected.iter().filter(|point| point[15] != 0.0).count() > 100);
        if is_software(gpu) {
            done(same_bits(found.as_flattened(), expected.as_flattened()));
        }
        for (found, expected) in found.iter().zip(&expected) {
            assert_eq!(found[15], expected[15]);
            for (a, b) in found[..3].iter().zip(&expected[..3]) {
                assert!((a - b).abs() <= 1e-4 * scale, "{a} {b}");
            }
        }
        let mut off = expected.clone();
        off[0][15] = f32::from_bits(off[0][15].to_bits() ^ 1);
        assert!(same_bits(off.as_flattened(), expected.as_flattened()).is_err());
    }
}
