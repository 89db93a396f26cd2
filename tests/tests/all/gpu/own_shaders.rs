//! The functions for the caller's own shaders answer as the CPU does, whatever the depth of the tree; those with stacks in
//! workgroup memory say which rays overflow them.

use super::overflow::{nested_tree, overflows, rays_along_the_corner};
use super::trace::{Answers, rays_at};
use crate::deep_chains::{Side, chain, most_waiting, rays_around, rays_inside};
use slimbvh::generate::soup;
use slimbvh::gpu::{self, Gpu, Kernel, wgpu};
use slimbvh::{BuildConfig, Builder, Bvh, CodeBits, MeshCodec, NodeCodec, WideStore};
use slimbvh_core::launch::LANES;
use slimbvh_core::{Hit, Ray};
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
const ANYWHERE: &str = "
    hit = slimbvh_closest_hit(ray.origin, ray.t_min, ray.direction, ray.t_max);
    any = slimbvh_any_hit(ray.origin, ray.t_min, ray.direction, ray.t_max);
";

/// Those for compute shaders.
const IN_GROUP: &str = "
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
struct Replies {
    closest: Vec<Hit>,
    any: Vec<u32>,
    /// The flags of [`SHADER`].
    overflowed: Vec<u32>,
}

/// Runs [`SHADER`] with these calls behind a text, in workgroups of `lanes`. The tree's bindings are in group 1.
fn ask(
    gpu: &Gpu,
    bvh: &gpu::Bvh,
    rays: &[Ray],
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
    // An answer that is not written stays another than any.
    let nothing = vec![0x7777u32; 4 * rays.len()];
    let buffers = [
        storage(gpu, rays),
        storage(gpu, &nothing),
        storage(gpu, &nothing[..rays.len()]),
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
    let groups = [bind(0, &own), bind(1, &done(bvh.bindings()))];
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
        let replies = ask(gpu, &uploaded, rays, (text.as_str(), calls), lanes);
        done(replies.compare(bvh, rays, software));
        assert_eq!(replies.overflow_counts(), [0, 0]);
    }
    let tried = ask(gpu, &uploaded, rays, (&text_compute, TRY), lanes);
    let filled = format!("{FILL}{TRY}");
    let again = ask(gpu, &uploaded, rays, (&text_compute, &filled), lanes);
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
        let replies = ask(gpu, &uploaded, &rays, (&text, IN_GROUP), lanes);
        done(replies.compare(&bvh, &rays, is_software(gpu)));
        // Lanes beyond the last stack are reported as if theirs were full.
        let tried = ask(gpu, &uploaded, &rays, (&text, TRY), lanes);
        let has_none = |i: usize| i as u32 % lanes >= LANES as u32;
        let expected: Vec<u32> = (0..rays.len())
            .map(|i| 3 * u32::from(has_none(i)))
            .collect();
        done(same_bits(&tried.overflowed, &expected));
    }
    // Lanes that share a stack spoil each other's.
    let shared = IN_GROUP.replace("lane", "lane / 2u");
    let replies = ask(gpu, &uploaded, &rays, (&text, &shared), 64);
    assert!(replies.compare(&bvh, &rays, is_software(gpu)).is_err());
}
