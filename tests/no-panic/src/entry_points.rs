//! Every entry point of gpu-shaders. Its address is taken, so that it is compiled for any arguments: slices of any length,
//! any numbers. The list is the shader builder's, which fails where it differs from what the source text declares.

use slimbvh_shaders::{
    bounds::*, camera::*, classify::*, compact::*, decide::*, encode::wide::*, encode::*, fit::*,
    gather::*, morton::*, refit::*, scan::*, shade::*, snap::*, sort::*, topology::*,
    trace::called::*, trace::overflow::*, trace::paper10::*, trace::plain::*, trace::wide::*,
    view::*, wide::*,
};

macro_rules! kernels {
    (shipped { $($shipped:ident,)* } lab { $($lab:ident,)* }) => {
        /// Their addresses; those of the walks for users' WGSL, which are no kernels, are the last.
        const ADDRESSES: &[fn() -> *const ()] = &[
            $(|| $shipped as *const (),)*
            $(|| $lab as *const (),)*
            || call_surface as *const (),
            || call_trace as *const (),
            || call_trace_in_group as *const (),
            || call_trace_w4_f32 as *const (),
            || call_trace_in_group_w4_f32 as *const (),
            || call_trace_w4_64_f32 as *const (),
            || call_trace_in_group_w4_64_f32 as *const (),
            || call_trace_w4_64_lattice as *const (),
            || call_trace_in_group_w4_64_lattice as *const (),
            || call_trace_w4_48_lattice as *const (),
            || call_trace_in_group_w4_48_lattice as *const (),
        ];
    };
}

/// The rows of the list are made of the same kernels.
macro_rules! traces {
    ($($row:tt)*) => {};
}

include!("../../../host/shaders/kernels.rs");

/// Keeps all of them: the caller may ask for any.
#[unsafe(no_mangle)]
pub fn entry_point(i: usize) -> *const () {
    match ADDRESSES.get(i) {
        Some(address) => address(),
        None => core::ptr::null(),
    }
}
