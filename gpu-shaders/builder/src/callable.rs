//! The texts for users' own WGSL: what the entry points `call_trace` and `call_trace_in_group` do, as functions that other WGSL
//! can call. The second text goes behind the first: it has no item that the first one has. Of each kind of tree there are both.

use anyhow::{Context, Result, anyhow, bail};
use naga::back::wgsl::{WriterFlags, write_string};
use naga::front::wgsl::parse_str;
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{AddressSpace, Handle, Module, Type, TypeInner};
use std::collections::{BTreeMap, BTreeSet};

/// A kind of tree that has texts.
struct Kind {
    /// The end of its entry points' names and of its files'.
    suffix: &'static str,
    /// Whether the tree has a root in a binding of its own, after the triangles.
    has_root: bool,
}

const KINDS: [Kind; 5] = [
    Kind {
        suffix: "",
        has_root: false,
    },
    Kind {
        suffix: "_w4_f32",
        has_root: false,
    },
    Kind {
        suffix: "_w4_64_f32",
        has_root: true,
    },
    Kind {
        suffix: "_w4_64_lattice",
        has_root: true,
    },
    Kind {
        suffix: "_w4_48_lattice",
        has_root: true,
    },
];

impl Kind {
    /// What bindings are called, in order, and how many of them stay bindings; the others become private variables, by which callers
    /// hand over rays and take hits.
    fn globals(&self) -> (Vec<&'static str>, u32) {
        let root = if self.has_root {
            &["slimbvh_root"][..]
        } else {
            &[]
        };
        let bindings = [&TREE, root].concat();
        let count = bindings.len() as u32;
        ([&bindings[..], &CALL].concat(), count)
    }
}

/// Bindings that all trees have.
const TREE: [&str; 3] = ["slimbvh_exponent", "slimbvh_nodes", "slimbvh_triangles"];

/// What a call hands over, and takes.
const CALL: [&str; 6] = [
    "slimbvh_origin",
    "slimbvh_direction",
    "slimbvh_any_will_do",
    "slimbvh_hit",
    "slimbvh_lane",
    "slimbvh_overflowed",
];

/// A text.
struct Text {
    /// The entry point that it is made of, but for its end.
    entry_point: &'static str,
    /// Its file, but for its end.
    file: &'static str,
    /// What the entry point's function is called in it.
    function: &'static str,
    head: &'static str,
    /// The functions that callers use.
    wrappers: &'static str,
    /// A text that calls all of them, to be put behind.
    caller: &'static str,
}

/// In the order in which they are put one behind the other.
const TEXTS: [Text; 2] = [
    Text {
        entry_point: "call_trace",
        file: "slimbvh",
        function: "slimbvh_trace",
        head: "\
// Made by slimbvh's shader builder from its Rust: rays traced from your own WGSL. Put this text before yours, bind the
// tree's exponent, nodes, triangles and, if it has one, root to group 0, and call
//
//   slimbvh_closest_hit(origin, t_min, direction, t_max) -> SlimbvhHit
//   slimbvh_any_hit(origin, t_min, direction, t_max) -> bool
//
// from any stage. t is in units of the direction's length; a miss has the primitive 0xffffffff. The stack is private
// memory, up to 1 KiB an invocation: in compute shaders the functions of the text slimbvh_compute are faster.

",
        wrappers: include_str!("callable.wgsl"),
        caller: "
@group(1) @binding(0) var<storage, read_write> caller_distances: array<f32>;

@compute @workgroup_size(64)
fn caller(@builtin(global_invocation_id) id: vec3<u32>) {
    let hit = slimbvh_closest_hit(vec3<f32>(0.0, 1.0, 2.0), 0.0, vec3<f32>(0.0, 0.0, -1.0), 1e30);
    if hit.primitive != 0xffffffffu && !slimbvh_any_hit(vec3<f32>(), 0.0, vec3<f32>(1.0), hit.t) {
        caller_distances[id.x] = hit.t + hit.u + hit.v;
    }
}
",
    },
    Text {
        entry_point: "call_trace_in_group",
        file: "slimbvh_compute",
        function: "slimbvh_trace_in_group",
        head: "\
// Made by slimbvh's shader builder from its Rust: rays traced from your own compute shaders, with the stacks in workgroup
// memory. Put this text behind the text slimbvh of the same kind of tree, and call
//
//   slimbvh_closest_hit_in_group(lane, origin, t_min, direction, t_max) -> SlimbvhHit
//   slimbvh_any_hit_in_group(lane, origin, t_min, direction, t_max) -> bool
//
// lane is the invocation's local_invocation_index. The stacks are 8 KiB for 64 invocations, 32 nodes each, whatever the
// size of the workgroup. A ray that needs more is traced again by the functions of the first text; so is every ray of a lane
// from 64 on, so workgroups should have 64 invocations or fewer. Two invocations with the same lane get wrong answers.
// There is no barrier inside: calls may stand in branches and loops.
//
//   slimbvh_try_closest_hit(lane, origin, t_min, direction, t_max) -> SlimbvhTriedHit { hit, overflowed }
//   slimbvh_try_any_hit(lane, origin, t_min, direction, t_max) -> SlimbvhTriedAny { found, overflowed }
//
// trace nothing again: where overflowed is true, hit is a miss and found is false, and mean nothing. A shader that calls
// only these needs no private stack: it can list the rays that overflowed for a second dispatch.

",
        wrappers: include_str!("callable_compute.wgsl"),
        caller: "
@group(1) @binding(0) var<storage, read_write> caller_distances: array<f32>;

@compute @workgroup_size(64)
fn caller(@builtin(local_invocation_index) lane: u32) {
    let hit = slimbvh_closest_hit_in_group(lane, vec3<f32>(0.0, 1.0, 2.0), 0.0, vec3<f32>(0.0, 0.0, -1.0), 1e30);
    if !slimbvh_any_hit_in_group(lane, vec3<f32>(), 0.0, vec3<f32>(1.0), hit.t) {
        let tried = slimbvh_try_closest_hit(lane, vec3<f32>(), 0.0, vec3<f32>(1.0), hit.t);
        let any = slimbvh_try_any_hit(lane, vec3<f32>(), 0.0, vec3<f32>(1.0), hit.t);
        if !tried.overflowed && tried.hit.primitive != 0xffffffffu && !any.overflowed && !any.found {
            caller_distances[lane] = tried.hit.t;
        }
    }
}
",
    },
];

impl Text {
    fn entry_point_of(&self, kind: &Kind) -> String {
        format!("{}{}", self.entry_point, kind.suffix)
    }
}

/// What the variable in workgroup memory is called.
const STACKS: &str = "slimbvh_stacks";

/// Whether an entry point becomes a text.
#[must_use]
pub fn is_called(entry_point: &str) -> bool {
    let mut texts = TEXTS
        .iter()
        .flat_map(|text| KINDS.iter().map(move |kind| (text, kind)));
    texts.any(|(text, kind)| text.entry_point_of(kind) == entry_point)
}

/// Turns the modules of the entry points into texts, by their files.
///
/// # Errors
/// Where one is missing, its bindings are not those expected, or the texts cannot be used.
pub fn texts(mut modules: BTreeMap<String, Module>) -> Result<Vec<(String, String)>> {
    let mut texts = Vec::new();
    for kind in &KINDS {
        texts.extend(texts_of(kind, &mut modules)?);
    }
    Ok(texts)
}

/// The texts of one kind of tree.
fn texts_of(kind: &Kind, modules: &mut BTreeMap<String, Module>) -> Result<Vec<(String, String)>> {
    let mut structs = Structs::default();
    let (mut all, mut declared) = (String::new(), BTreeSet::new());
    let mut texts = Vec::new();
    for text in TEXTS {
        let entry_point = text.entry_point_of(kind);
        let module = modules.remove(&entry_point).context(entry_point.clone())?;
        let own = translated(&text, kind, module, &mut structs).context(entry_point)?;
        let new = items(&own).filter(|&item| declared.insert(item.to_owned()));
        let new: String = new.map(|item| format!("{item}\n\n")).collect();
        let made = format!("{}{new}{}", text.head, text.wrappers);
        all += &made;
        let called = format!("{all}{}", text.caller);
        let parsed =
            parse_str(&called).map_err(|error| anyhow!("{}", error.emit_to_string(&called)))?;
        validate(&parsed)?;
        texts.push((format!("{}{}.wgsl", text.file, kind.suffix), made));
    }
    Ok(texts)
}

/// The module in WGSL, all names its own.
fn translated(
    text: &Text,
    kind: &Kind,
    mut module: Module,
    structs: &mut Structs,
) -> Result<String> {
    module.entry_points.clear();
    name_function(&mut module, text.function)?;
    structs.name(&mut module)?;
    name_globals(&mut module, kind)?;
    let info = validate(&module)?;
    write_string(&module, &info, WriterFlags::empty()).context("naga cannot translate it")
}

/// The declarations of a text as naga writes it: each ends in a closing bracket or a semicolon at the margin.
fn items(text: &str) -> impl Iterator<Item = &str> {
    let is_end = |line: &str| line == "}" || (line.ends_with(';') && !line.starts_with(' '));
    let mut rest = text;
    std::iter::from_fn(move || {
        rest = rest.trim_start();
        let mut end = 0;
        for line in rest.split_inclusive('\n') {
            end += line.len();
            if is_end(line.trim_end_matches('\n')) {
                break;
            }
        }
        let (item, behind) = rest.split_at(end);
        rest = behind;
        (!item.is_empty()).then(|| item.trim_end())
    })
}

fn name_function(module: &mut Module, name: &str) -> Result<()> {
    let mut functions = module.functions.iter_mut();
    let (Some((_, function)), None) = (functions.next(), functions.next()) else {
        bail!("it is not one function");
    };
    function.name = Some(name.to_owned());
    Ok(())
}

/// Structs by their shapes, named in the order in which they were met: equal ones have the same name in all texts.
#[derive(Default)]
struct Structs(Vec<String>);

impl Structs {
    /// Names end in letters, as naga changes names that end in a digit.
    fn name(&mut self, module: &mut Module) -> Result<()> {
        let structs: Vec<_> = module
            .types
            .iter()
            .filter(|(_, ty)| matches!(ty.inner, TypeInner::Struct { .. }))
            .map(|(handle, ty)| (handle, ty.clone(), shape(module, handle)))
            .collect();
        for (handle, mut ty, shape) in structs {
            let known = self.0.iter().position(|known| *known == shape);
            let number = known.unwrap_or(self.0.len());
            if known.is_none() {
                self.0.push(shape);
            }
            let letter = ('A'..='Z').nth(number).context("it has many structs")?;
            ty.name = Some(format!("SlimbvhType{letter}"));
            module.types.replace(handle, ty);
        }
        Ok(())
    }
}

/// A type that may be a struct's member, without regard to names: the same text for equal types of two modules.
fn shape(module: &Module, ty: Handle<Type>) -> String {
    match &module.types[ty].inner {
        TypeInner::Struct { members, span } => {
            let members = members.iter();
            let members = members.map(|m| format!("{}: {}", m.offset, shape(module, m.ty)));
            format!("{span} {:?}", members.collect::<Vec<_>>())
        }
        TypeInner::Array { base, size, stride } => {
            format!("{size:?} {stride} of {}", shape(module, *base))
        }
        other => format!("{other:?}"),
    }
}

fn name_globals(module: &mut Module, kind: &Kind) -> Result<()> {
    let (globals, binding_count) = kind.globals();
    let mut has_stacks = false;
    for (_, global) in module.global_variables.iter_mut() {
        let Some(binding) = global.binding else {
            if global.space != AddressSpace::WorkGroup || has_stacks {
                bail!("a variable without a binding");
            }
            has_stacks = true;
            global.name = Some(STACKS.to_owned());
            continue;
        };
        let name = globals
            .get(binding.binding as usize)
            .context("too many bindings")?;
        global.name = Some((*name).to_owned());
        if binding.binding >= binding_count {
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
