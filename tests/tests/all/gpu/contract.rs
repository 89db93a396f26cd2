//! The compiled modules match the host's bindings and dispatches, are valid on any device, and are up to date with the code.

use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{AddressSpace, Module, StorageAccess, back, front};
use serde_json::Value;
use slimbvh::gpu::{Kernel, wgsl as wgsl_for_users, wgsl_compute};
use slimbvh_core::launch::LANES;
use slimbvh_core::trace::LaneWords;
use std::collections::BTreeSet;
use std::path::Path;

/// The builder's source file, included here as the builder is not a library.
#[path = "../../../../gpu-shaders/builder/src/source_hash.rs"]
pub mod source_hash;

/// Kernels with one result for all items.
const SINGLE_THREADS: [Kernel; 2] = [Kernel::view_depth_range, Kernel::view_heat_range];

/// The workspace.
fn root() -> &'static Path {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR"));
    tests.parent().unwrap_or(tests)
}

fn manifest() -> Value {
    let text = std::fs::read_to_string(root().join("host/shaders/manifest.json"));
    match text.map(|text| serde_json::from_str(&text)) {
        Ok(Ok(manifest)) => manifest,
        other => panic!("{other:?}"),
    }
}

/// The interface of a module: entry points with workgroup sizes, and bindings in order.
#[derive(Debug, PartialEq)]
struct Interface {
    entry_points: Vec<(String, [u32; 3])>,
    bindings: Vec<(u32, u32, &'static str)>,
}

/// Validates a module for a device without optional capabilities.
fn validated(what: &str, module: &Module) -> ModuleInfo {
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
    match validator.validate(module) {
        Ok(info) => info,
        Err(error) => panic!("{what}: {}", error.emit_to_string("")),
    }
}

/// The interface of a module, which must be valid.
fn interface(what: &str, module: &Module) -> Interface {
    validated(what, module);
    let entry_points = module.entry_points.iter();
    let globals = module.global_variables.iter();
    let mut bindings: Vec<_> = globals
        .filter_map(|(_, global)| Some((global.binding?, global.space)))
        .map(|(binding, space)| {
            let kind = match space {
                AddressSpace::Uniform => "uniform",
                AddressSpace::Storage { access } if access.contains(StorageAccess::STORE) => {
                    "read_write"
                }
                AddressSpace::Storage { .. } => "read",
                other => panic!("{what}: a binding in {other:?}"),
            };
            (binding.group, binding.binding, kind)
        })
        .collect();
    bindings.sort_unstable();
    Interface {
        entry_points: entry_points
            .map(|entry| (entry.name.clone(), entry.workgroup_size))
            .collect(),
        bindings,
    }
}

/// The kernel's module.
fn parsed(kernel: Kernel) -> Module {
    match front::spv::parse_u8_slice(kernel.spirv(), &front::spv::Options::default()) {
        Ok(module) => module,
        Err(error) => panic!("{}: {error}", kernel.name()),
    }
}

fn of_spirv(kernel: Kernel) -> Interface {
    interface(kernel.name(), &parsed(kernel))
}

/// The kernel's module, translated to WGSL as wgpu translates it for browsers.
pub(super) fn wgsl(kernel: Kernel) -> String {
    let module = parsed(kernel);
    let info = validated(kernel.name(), &module);
    match back::wgsl::write_string(&module, &info, back::wgsl::WriterFlags::empty()) {
        Ok(text) => text,
        Err(error) => panic!("{}: {error}", kernel.name()),
    }
}

/// The manifest's content.
fn of_manifest(module: &Value) -> Interface {
    let number = |value: &Value| value.as_u64().unwrap_or(u64::MAX) as u32;
    let kinds = ["uniform", "read", "read_write"];
    let binding = |binding: &Value| {
        let kind = kinds.into_iter().find(|kind| binding["kind"] == *kind);
        (0, number(&binding["binding"]), kind.unwrap_or("unknown"))
    };
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    let size = &module["workgroup_size"];
    Interface {
        entry_points: vec![(
            module["name"].as_str().unwrap_or_default().to_owned(),
            [0, 1, 2].map(|axis| number(&size[axis])),
        )],
        bindings: list(&module["bindings"]).iter().map(binding).collect(),
    }
}

#[test]
fn every_module_is_one_kernel_as_the_manifest_describes_it() {
    let manifest = manifest();
    let modules = manifest["modules"].as_array().unwrap();
    for &kernel in Kernel::ALL {
        let name = kernel.name();
        let of_name = modules.iter().filter(|module| module["name"] == name);
        let [described] = of_name.collect::<Vec<_>>()[..] else {
            panic!("the manifest does not have {name} once");
        };
        let found = of_spirv(kernel);
        assert_eq!(found, of_manifest(described), "{name}");

        let lanes = if SINGLE_THREADS.contains(&kernel) {
            1
        } else {
            LANES as u32
        };
        assert_eq!(found.entry_points, [(name.to_owned(), [lanes, 1, 1])]);
        for (binding, place) in found.bindings.iter().zip(0..) {
            assert_eq!((binding.0, binding.1), (0, place), "{name} leaves a gap");
        }
        // Uniforms come first, written buffers last.
        let order = |kind: &str| {
            ["uniform", "read", "read_write"]
                .iter()
                .position(|k| *k == kind)
        };
        assert!(
            found.bindings.is_sorted_by_key(|binding| order(binding.2)),
            "{name}"
        );
        let storage = found
            .bindings
            .iter()
            .filter(|binding| binding.2 != "uniform");
        // Devices may allow eight. Paths and shadow rays leave room for what scenes will bind beside their trees.
        let is_of_pictures = ["trace_paths", "trace_shadows"]
            .iter()
            .any(|start| name.starts_with(start));
        let most = if is_of_pictures { 6 } else { 8 };
        assert!(
            storage.count() <= most,
            "{name} has too many storage buffers"
        );
    }
}

#[test]
fn kernels_and_modules_are_the_same_list() {
    let manifest = manifest();
    let described = manifest["modules"].as_array().unwrap().iter();
    let described: BTreeSet<_> = described
        .filter_map(|module| module["name"].as_str())
        .collect();
    let kernels: BTreeSet<_> = Kernel::ALL.iter().map(|kernel| kernel.name()).collect();
    assert_eq!(kernels, described);
    assert_eq!(kernels.len(), Kernel::ALL.len());
}

#[test]
fn translations_have_the_interface_of_the_module() {
    for &kernel in Kernel::ALL {
        let name = kernel.name();
        let text = wgsl(kernel);
        let mut translated = match front::wgsl::parse_str(&text) {
            Ok(module) => interface(name, &module),
            Err(error) => panic!("{name}: {}", error.emit_to_string(&text)),
        };
        // naga appends an underscore to names that end in a digit.
        for (name, _) in &mut translated.entry_points {
            if let Some(short) = name.strip_suffix('_') {
                assert!(short.ends_with(|last: char| last.is_ascii_digit()));
                *name = short.to_owned();
            }
        }
        assert_eq!(translated, of_spirv(kernel));
    }
}

#[test]
fn texts_for_users_bind_the_tree_and_nothing_else() {
    let stack_bytes = size_of::<LaneWords>() as u32;
    for (what, text, bytes) in [
        ("slimbvh.wgsl", wgsl_for_users(2), None),
        ("slimbvh_compute.wgsl", wgsl_compute(2), Some(stack_bytes)),
    ] {
        let module = match front::wgsl::parse_str(&text) {
            Ok(module) => module,
            Err(error) => panic!("{what}: {}", error.emit_to_string(&text)),
        };
        let expected = Interface {
            entry_points: Vec::new(),
            bindings: vec![
                (2, 0, "uniform"),
                (2, 1, "read"),
                (2, 2, "read"),
                (2, 3, "read"),
                (2, 4, "uniform"),
            ],
        };
        assert_eq!(interface(what, &module), expected);

        let globals = module.global_variables.iter().map(|(_, global)| global);
        let of_group = globals.filter(|global| global.space == AddressSpace::WorkGroup);
        let sizes: Vec<_> = of_group
            .map(|global| module.types[global.ty].inner.size(module.to_ctx()))
            .collect();
        assert_eq!(sizes, bytes.into_iter().collect::<Vec<_>>(), "{what}");
        for name in names(&module) {
            let is_ours = name.starts_with("slimbvh_") || name.starts_with("Slimbvh");
            assert!(is_ours, "{what}: {name}");
        }
    }
}

/// What a module declares.
fn names(module: &Module) -> Vec<&str> {
    let functions = module.functions.iter().map(|(_, function)| &function.name);
    let globals = module.global_variables.iter();
    let globals = globals.map(|(_, global)| &global.name);
    let types = module.types.iter().map(|(_, ty)| &ty.name);
    let constants = module.constants.iter().map(|(_, constant)| &constant.name);
    let all = functions.chain(globals).chain(types).chain(constants);
    all.flatten().map(String::as_str).collect()
}

/// Opcodes of instructions with a text from the compiler.
const TEXT_INSTRUCTIONS: [u32; 8] = [2, 3, 4, 5, 6, 7, 8, 330];

/// The text instructions of a module that name paths of the build machine.
fn paths_in(spirv: &[u8]) -> Vec<String> {
    let words: Vec<u32> = bytemuck::pod_collect_to_vec(spirv);
    let mut paths = Vec::new();
    let mut at = 5;
    while let Some(&head) = words.get(at) {
        let length = (head >> 16).max(1) as usize;
        let operands = words.get(at + 1..at + length).unwrap_or_default();
        let text = String::from_utf8_lossy(bytemuck::cast_slice(operands)).into_owned();
        if TEXT_INSTRUCTIONS.contains(&(head & 0xffff)) && text.contains(['/', '\\']) {
            paths.push(text);
        }
        at += length;
    }
    paths
}

#[test]
fn modules_do_not_tell_where_they_were_made() {
    for &kernel in Kernel::ALL {
        assert_eq!(paths_in(kernel.spirv()), [""; 0], "{}", kernel.name());
    }
    // OpString, result 1, "/src".
    let mut spoilt = Kernel::scan_sums.spirv().to_vec();
    spoilt.extend(bytemuck::bytes_of(&[
        4u32 << 16 | 7,
        1,
        u32::from_le_bytes(*b"/src"),
        0,
    ]));
    assert_eq!(paths_in(&spoilt).len(), 1);
}

#[test]
fn modules_are_made_from_the_code_as_it_is() {
    // The crates of the builder's `CRATES`, in their order.
    let crates = ["gpu-shaders", "host/examples/own_shader/shader"];
    let manifest = manifest();
    match source_hash::source_hash(root(), &crates) {
        Ok(hash) => assert_eq!(
            manifest["source_hash"], *hash,
            "core, the shaders or their builder have changed: run the builder"
        ),
        Err(error) => panic!("{error:#}"),
    }
    for (package, version) in source_hash::pinned_versions(root()).unwrap() {
        assert_eq!(
            manifest["versions"][package.as_str()],
            *version,
            "{package}"
        );
    }
    // The hash covers these crates in this order.
    let others = source_hash::source_hash(root(), &crates[..1]);
    assert!(others.is_ok_and(|hash| manifest["source_hash"] != *hash));
}
