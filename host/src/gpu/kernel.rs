//! The compiled entry points of `gpu-shaders`.

use std::collections::HashMap;
use std::sync::{Mutex, MutexGuard, PoisonError};

macro_rules! kernels {
    ($($name:ident),* $(,)?) => {
        /// An entry point of `gpu-shaders`, under its name there. Its documentation there tells what it reads and stores: all
        /// bindings are in group 0, in the order of the arguments, and the length of a bound range is the number of its
        /// elements.
        #[allow(non_camel_case_types, missing_docs, reason = "named as in gpu-shaders")]
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Kernel { $($name),* }

        impl Kernel {
            /// All kernels, in the order of a frame.
            pub const ALL: &'static [Self] = &[$(Self::$name),*];

            /// The entry point's name.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $(Self::$name => stringify!($name)),* }
            }

            /// The SPIR-V module, which holds this entry point alone.
            #[must_use]
            pub const fn spirv(self) -> &'static [u8] {
                match self {
                    $(Self::$name => include_bytes!(concat!("../../shaders/", stringify!($name), ".spv"))),*
                }
            }
        }
    };
}

kernels! {
    bounds, bounds_grid,
    morton_30, morton_63,
    sort_count_30, sort_count_63, sort_scatter_30, sort_scatter_63,
    scan_sums, scan_blocks, scan_apply,
    decide_spans, decide_components, decide_sides, decide_counts, decide_smaller, decide_turn,
    classify, classify_order_30, classify_order_63, classify_compact_30, classify_compact_63,
    compact_counts, compact,
    snap_30, snap_63, snap_again,
    topology_kept_30, topology_kept_63, topology_nodes_30, topology_nodes_63,
    refit_groups, refit_parents, refit_nodes, refit_rounded, refit_splits,
    encode_paper10_f32, encode_paper10_leaf10, encode_q10_f32, encode_q21_f32,
    encode_q10_sizes, encode_q10_links, encode_q21_sizes, encode_q21_links, encode_triangles,
    camera_rays, camera_resolve, camera_encode,
    trace_closest, trace_any, trace_nearest, trace_counted,
    trace_paths, trace_paths_counted, trace_paths_facing, trace_shadows, trace_shadows_facing,
    trace_closest_paper10_f32, trace_any_paper10_f32, trace_nearest_paper10_f32, trace_counted_paper10_f32,
    trace_paths_paper10_f32, trace_paths_counted_paper10_f32, trace_shadows_paper10_f32,
    trace_closest_paper10_leaf10, trace_any_paper10_leaf10, trace_nearest_paper10_leaf10, trace_counted_paper10_leaf10,
    trace_paths_paper10_leaf10, trace_paths_counted_paper10_leaf10, trace_shadows_paper10_leaf10,
    trace_closest_q10_f32, trace_any_q10_f32, trace_nearest_q10_f32, trace_counted_q10_f32,
    trace_paths_q10_f32, trace_paths_counted_q10_f32, trace_shadows_q10_f32,
    trace_closest_q10_lattice, trace_any_q10_lattice, trace_nearest_q10_lattice, trace_counted_q10_lattice,
    trace_paths_q10_lattice, trace_paths_counted_q10_lattice, trace_shadows_q10_lattice,
    trace_closest_q21_f32, trace_any_q21_f32, trace_nearest_q21_f32, trace_counted_q21_f32,
    trace_paths_q21_f32, trace_paths_counted_q21_f32, trace_shadows_q21_f32,
    trace_closest_q21_lattice, trace_any_q21_lattice, trace_nearest_q21_lattice, trace_counted_q21_lattice,
    trace_paths_q21_lattice, trace_paths_counted_q21_lattice, trace_shadows_q21_lattice,
    shade_light, shade_reached, shade_scatter,
    view_normals, view_primitives,
    view_depth_values, view_items, view_depth_range, view_heat_range, view_depth, view_heat,
}

/// Pipelines, compiled when first used.
#[derive(Debug, Default)]
pub struct Pipelines(Mutex<HashMap<Kernel, wgpu::ComputePipeline>>);

impl Pipelines {
    /// The pipeline, if it has been compiled.
    pub fn compiled(&self, kernel: Kernel) -> Option<wgpu::ComputePipeline> {
        self.all().get(&kernel).cloned()
    }

    /// Keeps a pipeline for the next time.
    pub fn keep(&self, kernel: Kernel, pipeline: &wgpu::ComputePipeline) {
        self.all().insert(kernel, pipeline.clone());
    }

    fn all(&self) -> MutexGuard<'_, HashMap<Kernel, wgpu::ComputePipeline>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Compiles a kernel for a device.
pub fn compile(device: &wgpu::Device, kernel: Kernel) -> wgpu::ComputePipeline {
    let label = Some(kernel.name());
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label,
        source: wgpu::util::make_spirv(kernel.spirv()),
    });
    device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label,
        layout: None,
        module: &module,
        entry_point: Some(kernel.name()),
        compilation_options: wgpu::PipelineCompilationOptions {
            // Every kernel writes its workgroup memory before it reads it.
            zero_initialize_workgroup_memory: false,
            ..wgpu::PipelineCompilationOptions::default()
        },
        cache: None,
    })
}
