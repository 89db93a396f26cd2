//! `slimbvh.wgsl`: what the entry point `call_trace` does, as functions that other people's WGSL can call.

use anyhow::{Context, Result, anyhow, bail};
use naga::back::wgsl::{WriterFlags, write_string};
use naga::front::wgsl::parse_str;
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{AddressSpace, Module, TypeInner};

/// The entry point.
pub const ENTRY_POINT: &str = "call_trace";

/// What its bindings are called, in order.
const GLOBALS: [&str; 7] = [
    "slimbvh_exponent",
    "slimbvh_nodes",
    "slimbvh_triangles",
    "slimbvh_origin",
    "slimbvh_direction",
    "slimbvh_any_will_do",
    "slimbvh_hit",
];

/// How many of them stay bindings; the others become private variables, by which callers hand over rays and take hits.
const BINDING_COUNT: u32 = 3;

const HEAD: &str = "\
// Made by slimbvh's shader builder from its Rust: rays traced from your own WGSL. Put this text before yours, bind the
// tree's exponent, nodes and triangles to group 0, and call
//
//   slimbvh_closest_hit(origin, t_min, direction, t_max) -> SlimbvhHit
//   slimbvh_any_hit(origin, t_min, direction, t_max) -> bool
//
// from any stage. t is in units of the direction's length; a miss has the primitive 0xffffffff.

";

/// The functions that callers use.
const WRAPPERS: &str = include_str!("callable.wgsl");

/// A text that calls both, to be put behind.
const CALLER: &str = "
@group(1) @binding(0) var<storage, read_write> caller_distances: array<f32>;

@compute @workgroup_size(64)
fn caller(@builtin(global_invocation_id) id: vec3<u32>) {
    let hit = slimbvh_closest_hit(vec3<f32>(0.0, 1.0, 2.0), 0.0, vec3<f32>(0.0, 0.0, -1.0), 1e30);
    if hit.primitive != 0xffffffffu && !slimbvh_any_hit(vec3<f32>(), 0.0, vec3<f32>(1.0), hit.t) {
        caller_distances[id.x] = hit.t + hit.u + hit.v;
    }
}
";

/// Turns the module of [`ENTRY_POINT`] into the text.
///
/// # Errors
/// Where its bindings are not those expected, or the text cannot be used.
pub fn wgsl(mut module: Module) -> Result<String> {
    module.entry_points.clear();
    name_functions(&mut module)?;
    name_structs(&mut module)?;
    name_globals(&mut module)?;
    let info = validate(&module)?;
    let traced =
        write_string(&module, &info, WriterFlags::empty()).context("naga cannot translate it")?;
    let text = format!("{HEAD}{traced}{WRAPPERS}");
    let called = parse_str(&format!("{text}{CALLER}"))
        .map_err(|error| anyhow!("{}", error.emit_to_string(&text)))?;
    validate(&called)?;
    Ok(text)
}

fn name_functions(module: &mut Module) -> Result<()> {
    let mut functions = module.functions.iter_mut();
    let (Some((_, function)), None) = (functions.next(), functions.next()) else {
        bail!("it is not one function");
    };
    function.name = Some("slimbvh_trace".to_owned());
    Ok(())
}

/// Names end in letters, as naga changes names that end in a digit.
fn name_structs(module: &mut Module) -> Result<()> {
    let structs: Vec<_> = module
        .types
        .iter()
        .filter(|(_, ty)| matches!(ty.inner, TypeInner::Struct { .. }))
        .map(|(handle, ty)| (handle, ty.clone()))
        .collect();
    if structs.len() > 26 {
        bail!("it has {} structs", structs.len());
    }
    for ((handle, mut ty), letter) in structs.into_iter().zip('A'..) {
        ty.name = Some(format!("SlimbvhType{letter}"));
        module.types.replace(handle, ty);
    }
    Ok(())
}

fn name_globals(module: &mut Module) -> Result<()> {
    for (_, global) in module.global_variables.iter_mut() {
        let binding = global.binding.context("a variable without a binding")?;
        let name = GLOBALS
            .get(binding.binding as usize)
            .context("too many bindings")?;
        global.name = Some((*name).to_owned());
        if binding.binding >= BINDING_COUNT {
            global.binding = None;
            global.space = AddressSpace::Private;
        }
    }
    Ok(())
}

fn validate(module: &Module) -> Result<ModuleInfo> {
    Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(module)
        .map_err(|error| anyhow!("naga refuses it: {}", error.emit_to_string("")))
}
