//! Shapes of code that cost a GPU much are in no module: private arrays, which become memory that each thread clears, and
//! checks that leave a kernel early, which become branches out of all its loops. No GPU or driver is needed to see them.

use naga::{Block, Function, GlobalVariable, Module, Statement, Type, TypeInner, front};
use slimbvh::gpu::Kernel;
use std::collections::BTreeSet;
use std::fmt::{Display, Formatter};

/// The largest private array, in bytes: the eight nearest hits of a ray.
const LARGEST: u32 = 128;

/// The entry points that become functions for users' WGSL, and what those are called.
const CALLED: [(&str, &str); 10] = [
    ("call_trace", "slimbvh_trace"),
    ("call_trace_in_group", "slimbvh_trace_in_group"),
    ("call_trace_w4_f32", "slimbvh_trace"),
    ("call_trace_in_group_w4_f32", "slimbvh_trace_in_group"),
    ("call_trace_w4_64_f32", "slimbvh_trace"),
    ("call_trace_in_group_w4_64_f32", "slimbvh_trace_in_group"),
    ("call_trace_w4_64_lattice", "slimbvh_trace"),
    (
        "call_trace_in_group_w4_64_lattice",
        "slimbvh_trace_in_group",
    ),
    ("call_trace_w4_48_lattice", "slimbvh_trace"),
    (
        "call_trace_in_group_w4_48_lattice",
        "slimbvh_trace_in_group",
    ),
];

/// A shape that costs much.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Shape {
    /// A private array of more than [`LARGEST`] bytes.
    PrivateArray,
    /// A branch that does nothing but leave the loop or the kernel: Rust's check of an index, or what follows one in a loop.
    EarlyExit,
}

impl Display for Shape {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Self::PrivateArray => "private array",
            Self::EarlyExit => "early exit",
        })
    }
}

/// Whether a kernel may keep its stack in private memory: those that trace again what overflowed another stack, those that
/// count as the CPU does, and the functions for any stage of a pipeline.
fn may_have_private_arrays(kernel: &str) -> bool {
    let counts = ["trace_counted", "trace_paths_counted"];
    kernel.ends_with("_overflow")
        || CALLED.contains(&(kernel, "slimbvh_trace"))
        || counts.iter().any(|start| kernel.starts_with(start))
}

/// The shapes in a module, with no regard to what its kernel may have.
fn shapes(module: &Module) -> BTreeSet<Shape> {
    let entry_points = module.entry_points.iter().map(|entry| &entry.function);
    let functions = module.functions.iter().map(|(_, function)| function);
    let functions = functions.chain(entry_points);
    let mut found: BTreeSet<Shape> = functions
        .flat_map(|function| shapes_of(module, function))
        .collect();
    if has_large_private(module) {
        found.insert(Shape::PrivateArray);
    }
    found
}

fn has_large_private(module: &Module) -> bool {
    let is_large = |variable: &GlobalVariable| {
        variable.space == naga::AddressSpace::Private
            && has_large_array(module, &module.types[variable.ty])
    };
    let mut globals = module.global_variables.iter();
    globals.any(|(_, global)| is_large(global))
}

/// The shapes in a function.
fn shapes_of(module: &Module, function: &Function) -> BTreeSet<Shape> {
    let mut found = BTreeSet::new();
    if has_large_local(module, function) {
        found.insert(Shape::PrivateArray);
    }
    if leaves_early(&function.body) {
        found.insert(Shape::EarlyExit);
    }
    found
}

fn has_large_local(module: &Module, function: &Function) -> bool {
    let mut locals = function.local_variables.iter();
    locals.any(|(_, local)| has_large_array(module, &module.types[local.ty]))
}

/// Whether a type is an array of more than [`LARGEST`] bytes, or has one inside.
fn has_large_array(module: &Module, of: &Type) -> bool {
    match of.inner {
        TypeInner::Array { base, .. } => {
            let size = of.inner.try_size(module.to_ctx());
            size.is_none_or(|bytes| bytes > LARGEST) || has_large_array(module, &module.types[base])
        }
        TypeInner::Struct { ref members, .. } => {
            let mut members = members.iter();
            members.any(|member| has_large_array(module, &module.types[member.ty]))
        }
        _ => false,
    }
}

/// Whether a branch in a block, or in one inside, does nothing but leave.
fn leaves_early(block: &Block) -> bool {
    block.iter().any(|statement| match statement {
        Statement::If { accept, reject, .. } => {
            let one = |a: &Block, b: &Block| is_empty(a) && only_leaves(b);
            one(accept, reject)
                || one(reject, accept)
                || leaves_early(accept)
                || leaves_early(reject)
        }
        Statement::Block(block) => leaves_early(block),
        Statement::Loop {
            body, continuing, ..
        } => leaves_early(body) || leaves_early(continuing),
        Statement::Switch { cases, .. } => cases.iter().any(|case| leaves_early(&case.body)),
        _ => false,
    })
}

fn is_empty(block: &Block) -> bool {
    block
        .iter()
        .all(|statement| matches!(statement, Statement::Emit(_)))
}

/// Whether a block ends in a jump, behind nothing but flags and variables that are set.
fn only_leaves(block: &Block) -> bool {
    let Some((last, before)) = block.split_last() else {
        return false;
    };
    let is_set = |one: &Statement| matches!(one, Statement::Emit(_) | Statement::Store { .. });
    matches!(
        last,
        Statement::Break | Statement::Return { .. } | Statement::Kill
    ) && before.iter().all(is_set)
}

fn parsed(text: &str) -> Module {
    match front::wgsl::parse_str(text) {
        Ok(module) => module,
        Err(error) => panic!("{}", error.emit_to_string(text)),
    }
}

/// The shapes in a function of the texts for users' WGSL, which have no large private variables.
fn shapes_called(name: &str) -> BTreeSet<Shape> {
    let module = parsed(&slimbvh::gpu::wgsl_compute(0));
    assert!(!has_large_private(&module));
    let mut functions = module.functions.iter();
    match functions.find(|(_, function)| function.name.as_deref() == Some(name)) {
        Some((_, function)) => shapes_of(&module, function),
        None => panic!("there is no {name}"),
    }
}

/// The shapes that kernels have and may not have, a line `kernel: shape` each.
fn slow_shapes() -> Vec<String> {
    let mut modules: Vec<(&str, BTreeSet<Shape>)> = Vec::new();
    for kernel in Kernel::ALL {
        let options = front::spv::Options::default();
        match front::spv::parse_u8_slice(kernel.spirv(), &options) {
            Ok(module) => modules.push((kernel.name(), shapes(&module))),
            Err(error) => panic!("{}: {error}", kernel.name()),
        }
    }
    modules.extend(CALLED.map(|(kernel, function)| (kernel, shapes_called(function))));
    let mut lines = Vec::new();
    for (kernel, shapes) in modules {
        for shape in shapes {
            if shape != Shape::PrivateArray || !may_have_private_arrays(kernel) {
                lines.push(format!("{kernel}: {shape}"));
            }
        }
    }
    lines
}

#[test]
fn private_arrays_of_called_functions_are_seen() {
    // That of the function for any stage is its stack; that for workgroups has none.
    let has_one =
        CALLED.map(|(_, function)| shapes_called(function).contains(&Shape::PrivateArray));
    let expected = CALLED.map(|(_, name)| name == "slimbvh_trace");
    assert_eq!(has_one, expected);
}

#[test]
fn no_kernel_has_slow_shapes() {
    let lines = slow_shapes();
    assert!(lines.is_empty(), "{}", lines.join("\n"));
}

/// A kernel with this body.
fn kernel(body: &str) -> Module {
    parsed(&format!(
        "struct Kept {{ count: u32, words: array<u32, 33> }}
         @group(0) @binding(0) var<storage, read_write> words: array<u32>;
         var<workgroup> shared_words: array<u32, 2048>;
         @compute @workgroup_size(64) fn planted(@builtin(global_invocation_id) id: vec3<u32>) {{ {body} }}"
    ))
}

#[test]
fn planted_private_arrays_are_seen() {
    for body in [
        "var kept: array<u32, 33>; words[id.x] = kept[words[0] % 33u];",
        "var kept: array<vec4<f32>, 9>; words[id.x] = u32(kept[words[0] % 9u].x);",
        "var kept: Kept; words[id.x] = kept.words[words[0] % 33u];",
        "if id.x > 3u { var kept: array<array<u32, 17>, 2>; words[id.x] = kept[words[0] % 2u][3]; }",
    ] {
        assert_eq!(
            shapes(&kernel(body)),
            [Shape::PrivateArray].into(),
            "{body}"
        );
    }
    let private =
        parsed("var<private> kept: array<u32, 64>; fn a(i: u32) -> u32 { return kept[i]; }");
    assert_eq!(shapes(&private), [Shape::PrivateArray].into());
    for body in [
        "var kept: array<u32, 32>; words[id.x] = kept[words[0] % 32u];",
        "var kept: array<vec4<f32>, 8>; words[id.x] = u32(kept[words[0] % 8u].x);",
        "shared_words[id.x] = 1u; words[id.x] = shared_words[id.x ^ 1u];",
    ] {
        assert_eq!(shapes(&kernel(body)), [].into(), "{body}");
    }
}

#[test]
fn planted_early_exits_are_seen() {
    for body in [
        // As rust-gpu writes a check of an index: at the top, in a loop, behind a flag; and as an `if` the other way round.
        "switch 0i { default: { if id.x < 9u { } else { break; } words[id.x] = 1u; } }",
        "var i = 0u; var left = false; loop { if i < 9u { } else { left = true; break; } words[i] = 1u;
         continuing { i++; break if i > 20u; } }",
        "var i = 0u; var left = false; loop { words[i] = 1u; i++; if left { break; } continuing { break if i > 20u; } }",
        "if id.x >= 9u { return; } words[id.x] = 1u;",
        "if id.y == 0u { if id.x >= 9u { return; } words[id.x] = 1u; }",
    ] {
        assert_eq!(shapes(&kernel(body)), [Shape::EarlyExit].into(), "{body}");
    }
    for body in [
        "if id.x < 9u { words[id.x] = 1u; }",
        "var i = 0u; loop { if i < 9u { words[i] = 1u; } else { words[i] = 2u; } continuing { i++; break if i > 20u; } }",
        "switch id.x { case 1u: { words[1] = 1u; break; } default: { words[0] = 1u; break; } }",
    ] {
        assert_eq!(shapes(&kernel(body)), [].into(), "{body}");
    }
}

#[test]
fn only_named_kernels_may_have_private_arrays() {
    for kernel in [
        "trace_closest_overflow",
        "trace_paths_facing_overflow",
        "trace_counted",
        "trace_counted_paper10_f32",
        "trace_paths_counted_w4_48_lattice",
        "call_trace",
    ] {
        assert!(may_have_private_arrays(kernel), "{kernel}");
    }
    for kernel in [
        "trace_closest",
        "trace_any_w4_64_f32",
        "trace_paths",
        "sort_count_30",
        "call_trace_in_group",
    ] {
        assert!(!may_have_private_arrays(kernel), "{kernel}");
    }
}
