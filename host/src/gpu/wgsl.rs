//! The traversal as WGSL text, for the caller's shaders.

use super::GpuError;
use super::coding::{Coding, texts};
use super::misfit::Misfit;
use crate::{BuildConfig, MeshCodec, NodeCodec};

/// Functions that trace rays, to be put before the caller's shader, for any shader stage:
///
/// ```wgsl
/// fn slimbvh_closest_hit(origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> SlimbvhHit
/// fn slimbvh_any_hit(origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> bool
/// struct SlimbvhHit { t: f32, u: f32, v: f32, primitive: u32 }
/// ```
///
/// A miss has the primitive `0xffffffff`. Rays that leave what a ray hit need no small distance:
///
/// ```wgsl
/// fn slimbvh_surface(v0: vec3<f32>, v1: vec3<f32>, v2: vec3<f32>, hit: SlimbvhHit, direction: vec3<f32>) -> SlimbvhSurface
/// struct SlimbvhSurface {
///     position: vec3<f32>, side: f32, error: vec3<f32>, normal: vec3<f32>, leave: vec3<f32>, enter: vec3<f32>
/// }
/// fn slimbvh_closest_hit_from(origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32, skip: u32) -> SlimbvhHit
/// fn slimbvh_any_hit_from(origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32, skip: u32) -> bool
/// ```
///
/// `slimbvh_surface` takes the corners of the triangle that was hit, in the mesh's unit, the hit, and the direction of its ray. It
/// returns the numbers of [`crate::SurfacePoint`]: the position and a bound on its error by axis, the unit normal on the side that the
/// ray came from, and 1 where that is the front, −1 where the back. A shadow or mirror ray begins at `leave`, a refracted one at
/// `enter`; both lie off the triangle's exact plane. The primitive `skip` is no hit for it:
///
/// ```wgsl
/// let hit = slimbvh_closest_hit(eye, 0.0, direction, 1e30);
/// let surface = slimbvh_surface(v0, v1, v2, hit, direction);
/// let is_lit = !slimbvh_any_hit_from(surface.leave, 0.0, lamp - surface.leave, 1.0, hit.primitive);
/// ```
///
/// These functions skip one primitive, and know no errors. Where both ends of a ray lie on surfaces, or at edges of them,
/// [`super::Tree::trace`] with [`super::Rays::with_ends`] gives the answers of the CPU's [`slimbvh_core::SurfaceRay`]s.
///
/// The functions read a hierarchy with nodes and triangles in full, and its rule, from bindings 0 to 4 of this group;
/// [`super::Tree::bindings`] and [`super::Bvh::bindings`] return them. [`wgsl_for`] returns the text of other hierarchies. All names
/// begin with `slimbvh` or `Slimbvh`.
///
/// The stack is private memory, 1 KiB an invocation: compute shaders trace faster with [`wgsl_compute`].
///
/// ```
/// let shader = slimbvh::gpu::wgsl(0) + "
/// @fragment fn shade(@location(0) to: vec3<f32>) -> @location(0) vec4<f32> {
///     let hit = slimbvh_closest_hit(vec3<f32>(0.0, 1.0, 5.0), 0.0, to, 1e30);
///     return vec4<f32>(hit.u, hit.v, 0.0, 1.0);
/// }";
/// # assert!(shader.contains("fn slimbvh_closest_hit("));
/// ```
#[must_use]
pub fn wgsl(group: u32) -> String {
    moved(PLAIN[0], group)
}

/// The text of [`wgsl`] for hierarchies in these codecs: in full, or of wide nodes. The functions are the same, and so are their
/// answers; bindings are those of [`super::Tree::bindings`], six where the nodes are on a lattice.
///
/// ```no_run
/// # use slimbvh::gpu::{Bvh, GpuError, wgsl_for};
/// # fn run(bvh: &Bvh, shader: &str) -> Result<(), GpuError> {
/// // However the hierarchy is stored, the caller's shader is the same.
/// let shader = wgsl_for(bvh.codecs()?, 0)? + shader;
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// For codecs without such a text.
pub fn wgsl_for(codecs: (NodeCodec, MeshCodec), group: u32) -> Result<String, GpuError> {
    Ok(moved(texts(codecs)?[0], group))
}

/// The text of [`wgsl_compute`] for hierarchies in these codecs, as [`wgsl_for`].
///
/// ```no_run
/// # use slimbvh::gpu::{Bvh, Gpu, GpuError, wgpu, wgsl_compute_for};
/// # fn run(gpu: &Gpu, bvh: &Bvh, shader: &str) -> Result<(), GpuError> {
/// let source = wgsl_compute_for(bvh.codecs()?, 0)? + shader;
/// let module = gpu.device().create_shader_module(wgpu::ShaderModuleDescriptor {
///     label: None,
///     source: wgpu::ShaderSource::Wgsl(source.into()),
/// });
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// For codecs without such a text.
pub fn wgsl_compute_for(codecs: (NodeCodec, MeshCodec), group: u32) -> Result<String, GpuError> {
    Ok(wgsl_for(codecs, group)? + "\n" + texts(codecs)?[1])
}

const PLAIN: [&str; 2] = texts!("");

fn texts((nodes, mesh): (NodeCodec, MeshCodec)) -> Result<[&'static str; 2], GpuError> {
    let config = BuildConfig {
        nodes,
        mesh,
        ..BuildConfig::default()
    };
    match Coding::of(&config)? {
        None => Ok(PLAIN),
        Some(coding) => coding
            .texts()
            .ok_or_else(|| Misfit::InCodec.of("the hierarchy")),
    }
}

/// A text whose bindings are in another group than 0.
fn moved(text: &str, group: u32) -> String {
    text.replace("@group(0)", &format!("@group({group})"))
}

/// The text of [`wgsl`], and functions for compute shaders, whose stacks are in workgroup memory:
///
/// ```wgsl
/// fn slimbvh_closest_hit_in_group(lane: u32, origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> SlimbvhHit
/// fn slimbvh_any_hit_in_group(lane: u32, origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> bool
///
/// fn slimbvh_try_closest_hit(lane: u32, …) -> SlimbvhTriedHit
/// fn slimbvh_try_any_hit(lane: u32, …) -> SlimbvhTriedAny
/// struct SlimbvhTriedHit { hit: SlimbvhHit, overflowed: bool }
/// struct SlimbvhTriedAny { found: bool, overflowed: bool }
/// ```
///
/// Each of the four has a variant with `_from` behind `hit` and a last argument `skip`, as those of [`wgsl`]:
/// `slimbvh_any_hit_from_in_group`, `slimbvh_try_any_hit_from`.
///
/// `lane` is the invocation's `local_invocation_index`. The answers are those of [`wgsl`], to the bit. Calls may stand in
/// branches and loops.
///
/// **Workgroups** have at most 64 invocations. The stacks take 8 KiB of workgroup memory, whatever the size of the workgroup;
/// WebGPU promises 16 KiB. In larger workgroups the lanes from 64 on have no stack: each of their rays overflows. Two
/// invocations that pass the same `lane` overwrite each other's stack, and get wrong answers.
///
/// **Overflow.** A stack holds 32 nodes. A ray that needs more is traced again from the start by the functions `…_in_group`, with
/// a private stack, and is only reported by `slimbvh_try_…`: `hit` is then a miss and `found` false, and mean nothing. A
/// shader that calls `…_in_group` contains both walks at each call: Mesa's compiler for AMD (22.3.6, navi21) gives it 16 vector
/// registers more than with `slimbvh_try_…`, and 1 KiB of scratch memory an invocation, which only rays that overflow touch. So
/// a shader for many rays best lists those that overflow, and traces them in a second dispatch by `slimbvh_closest_hit`.
///
/// **Zeros.** wgpu fills workgroup memory with zeros before the shader begins, as WebGPU demands. The stacks do not need that:
/// no word has a meaning before its own lane has written it. Natively, a pipeline that needs no zeros for the caller's own
/// variables is faster with `zero_initialize_workgroup_memory: false` in its `wgpu::PipelineCompilationOptions`.
///
/// ```
/// let shader = slimbvh::gpu::wgsl_compute(0) + "
/// @group(1) @binding(0) var<storage, read_write> hits: array<SlimbvhHit>;
/// @compute @workgroup_size(64)
/// fn look(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
///     let to = vec3<f32>(f32(group.x) - 640.0, f32(lane) - 32.0, -640.0);
///     hits[64u * group.x + lane] = slimbvh_closest_hit_in_group(lane, vec3<f32>(0.0), 0.0, to, 1e30);
/// }";
/// # assert!(shader.contains("fn slimbvh_closest_hit_in_group("));
/// ```
#[must_use]
pub fn wgsl_compute(group: u32) -> String {
    wgsl(group) + "\n" + PLAIN[1]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::WideStore;

    #[test]
    fn all_bindings_move_to_the_group() {
        for text in [wgsl(3), wgsl_compute(3)] {
            assert_eq!(text.matches("@group(3)").count(), 5);
            assert_eq!(text.matches("@group(").count(), 5);
        }
        let lattice = MeshCodec::Lattice { step_exponent: 0 };
        for (nodes, mesh, count) in [
            (WideStore::Full, MeshCodec::F32, 5),
            (WideStore::Exact, MeshCodec::F32, 6),
            (WideStore::Exact, lattice, 6),
            (WideStore::Packed, lattice, 6),
        ] {
            let codecs = (NodeCodec::Wide(nodes), mesh);
            for text in [wgsl_for(codecs, 3), wgsl_compute_for(codecs, 3)] {
                assert!(
                    text.is_ok_and(|text| text.matches("@group(3)").count() == count
                        && text.matches("@group(").count() == count)
                );
            }
        }
    }

    #[test]
    fn codecs_without_a_text_are_refused() {
        let paper10 = NodeCodec::Paper10;
        assert!(wgsl_for((paper10, MeshCodec::F32), 0).is_err());
        assert_eq!(wgsl_for((NodeCodec::F32, MeshCodec::F32), 5), Ok(wgsl(5)));
    }
}
