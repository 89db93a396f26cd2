//! The texts for users' own WGSL: what the entry points `call_trace`, `call_surface` and `call_trace_in_group` do, as functions that
//! other WGSL can call. The second text goes behind the first: it has no item that the first one has. Of each kind of tree there are
//! both.

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
    /// What bindings of a tree are called, in order.
    fn bindings(&self) -> Vec<&'static str> {
        let root = if self.has_root {
            &["slimbvh_root"][..]
        } else {
            &[]
        };
        [&TREE, root, &RULE].concat()
    }
}

/// Bindings that all trees have.
const TREE: [&str; 3] = ["slimbvh_exponent", "slimbvh_nodes", "slimbvh_triangles"];

/// Bindings of a tree's rule.
const RULE: [&str; 2] = ["slimbvh_sides", "slimbvh_target"];

/// An entry point that becomes a function of a text.
struct Function {
    /// The entry point, but for its end if it traces a kind of tree.
    entry_point: &'static str,
    /// Whether it traces trees; others read the exponent only.
    is_of_kind: bool,
    /// What it is called in the text.
    name: &'static str,
    /// The bindings behind the tree's, which become private variables: what a call hands over, and takes.
    call: &'static [&'static str],
}

const TRACE: Function = Function {
    entry_point: "call_trace",
    is_of_kind: true,
    name: "slimbvh_trace",
    call: &[
        "slimbvh_origin",
        "slimbvh_direction",
        "slimbvh_question",
        "slimbvh_hit",
    ],
};

const TRACE_IN_GROUP: Function = Function {
    entry_point: "call_trace_in_group",
    is_of_kind: true,
    name: "slimbvh_trace_in_group",
    call: &[
        "slimbvh_origin",
        "slimbvh_direction",
        "slimbvh_question",
        "slimbvh_hit",
        "slimbvh_lane",
        "slimbvh_overflowed",
    ],
};

const SURFACE: Function = Function {
    entry_point: "call_surface",
    is_of_kind: false,
    name: "slimbvh_find_surface",
    call: &[
        "slimbvh_corners",
        "slimbvh_weights",
        "slimbvh_from",
        "slimbvh_point",
    ],
};

impl Function {
    fn entry_point_of(&self, kind: &Kind) -> String {
        let suffix = if self.is_of_kind { kind.suffix } else { "" };
        format!("{}{suffix}", self.entry_point)
    }

    /// What its bindings are called, in order, and how many of them stay bindings.
    fn globals(&self, kind: &Kind) -> (Vec<&'static str>, usize) {
        let bindings = if self.is_of_kind {
            kind.bindings()
        } else {
            TREE[..1].to_vec()
        };
        ([&bindings, self.call].concat(), bindings.len())
    }
}

/// A text.
struct Text {
    /// What it is made of.
    functions: &'static [Function],
    /// Its file, but for its end.
    file: &'static str,
    head: &'static str,
    /// The functions that callers use.
    wrappers: &'static str,
    /// A text that calls all of them, to be put behind.
    caller: &'static str,
}

/// In the order in which they are put one behind the other.
const TEXTS: [Text; 2] = [
    Text {
        functions: &[TRACE, SURFACE],
        file: "slimbvh",
        head: "\
// Made by slimbvh's shader builder from its Rust: rays traced from your own WGSL. Put this text before yours, bind the
// tree's exponent, nodes, triangles, if it has one its root, sides and target to group 0, and call
//
//   slimbvh_closest_hit(origin, t_min, direction, t_max) -> SlimbvhHit
//   slimbvh_any_hit(origin, t_min, direction, t_max) -> bool
//
// from any stage. t is in units of the direction's length; a miss has the primitive 0xffffffff. The stack is private
// memory, up to 1 KiB an invocation: in compute shaders the functions of the text slimbvh_compute are faster.
//
//   slimbvh_surface(v0, v1, v2, hit, direction) -> SlimbvhSurface { position, error, normal, side, leave, enter }
//   slimbvh_closest_hit_from(origin, t_min, direction, t_max, skip) -> SlimbvhHit
//   slimbvh_any_hit_from(origin, t_min, direction, t_max, skip) -> bool
//
// send rays from where one hit: from the corners of the triangle, the hit and its ray's direction to the surface there. A
// shadow or mirror ray begins at leave, a refracted one at enter, and skip is the primitive that was hit.

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
    let corner = vec3<f32>(1.0, 0.0, 0.0);
    let surface = slimbvh_surface(corner, corner.yxz, corner.zyx, hit, vec3<f32>(0.0, 0.0, -1.0));
    let next = slimbvh_closest_hit_from(surface.leave, 0.0, surface.normal, 1e30, hit.primitive);
    if !slimbvh_any_hit_from(surface.enter, 0.0, surface.position + surface.error, surface.side, next.primitive) {
        caller_distances[id.x] = next.t;
    }
}
",
    },
    Text {
        functions: &[TRACE_IN_GROUP],
        file: "slimbvh_compute",
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
//
// Each of the four has a variant for rays that leave a surface, with _from behind hit and a last argument skip, as in the
// first text: slimbvh_closest_hit_from_in_group, slimbvh_try_any_hit_from.

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
    let next = slimbvh_closest_hit_from_in_group(lane, vec3<f32>(), 0.0, vec3<f32>(1.0), 1e30, hit.primitive);
    if !slimbvh_any_hit_from_in_group(lane, vec3<f32>(), 0.0, vec3<f32>(1.0), 1e30, next.primitive) {
        caller_distances[lane] = next.t;
    }
}
",
    },
];

/// What the variable in workgroup memory is called.
const STACKS: &str = "slimbvh_stacks";

/// Whether an entry point becomes a text.
#[must_use]
pub fn is_called(entry_point: &str) -> bool {
    let mut functions = TEXTS.iter().flat_map(|text| text.functions);
    functions.any(|function| {
        let mut kinds = KINDS.iter();
        kinds.any(|kind| function.entry_point_of(kind) == entry_point)
    })
}

/// Turns the modules of the entry points into texts, by their files.
///
/// # Errors
/// Where one is missing, its bindings are not those expected, or the texts cannot be used.
pub fn texts(modules: &BTreeMap<String, Module>) -> Result<Vec<(String, String)>> {
    let mut texts = Vec::new();
    for kind in &KINDS {
        texts.extend(texts_of(kind, modules)?);
    }
    Ok(texts)
}

/// The texts of one kind of tree.
fn texts_of(kind: &Kind, modules: &BTreeMap<String, Module>) -> Result<Vec<(String, String)>> {
    let mut structs = Structs::default();
    let (mut all, mut declared) = (String::new(), BTreeSet::new());
    let mut texts = Vec::new();
    for text in TEXTS {
        let mut new = String::new();
        for function in text.functions {
            let entry_point = function.entry_point_of(kind);
            let module = modules.get(&entry_point).context(entry_point.clone())?;
            let own = translated(function, kind, module.clone(), &mut structs);
            for item in items(&own.context(entry_point)?) {
                if declared.insert(item.to_owned()) {
                    new += &format!("{item}\n\n");
                }
            }
        }
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
    function: &Function,
    kind: &Kind,
    mut module: Module,
    structs: &mut Structs,
) -> Result<String> {
    module.entry_points.clear();
    name_function(&mut module, function.name)?;
    structs.name(&mut module)?;
    name_globals(&mut module, function.globals(kind))?;
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

fn name_globals(
    module: &mut Module,
    (globals, binding_count): (Vec<&'static str>, usize),
) -> Result<()> {
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
        if binding.binding as usize >= binding_count {
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
