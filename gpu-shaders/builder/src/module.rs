//! One compiled module: stripped, checked and described.

use crate::largest;
use anyhow::{Context, Result, anyhow, bail};
use naga::front::spv;
use naga::valid::{Capabilities, ValidationFlags, Validator};
use naga::{AddressSpace, StorageAccess};
use serde_json::{Value, json};

/// What is written for an entry point.
pub struct Module {
    /// SPIR-V.
    pub spirv: Vec<u8>,
    /// As naga sees it.
    pub ir: naga::Module,
    /// Its entry in the manifest.
    pub manifest: Value,
}

impl Module {
    /// Takes what the backend made for the entry point `name`.
    ///
    /// # Errors
    /// Where that is no SPIR-V with this one entry point, or naga refuses it.
    pub fn new(name: &str, compiled: &[u8]) -> Result<Self> {
        let spirv = strip(name, compiled)?;
        let module = spv::parse_u8_slice(&spirv, &spv::Options::default())
            .map_err(|error| anyhow!("naga cannot read it: {error}"))?;
        // Capabilities beyond none would not be there on every device.
        Validator::new(ValidationFlags::all(), Capabilities::empty())
            .validate(&module)
            .map_err(|error| anyhow!("naga refuses it: {}", error.emit_to_string("")))?;
        largest::check(&module)?;
        let manifest = describe(name, &module)?;
        Ok(Self {
            spirv,
            ir: module,
            manifest,
        })
    }
}

pub const HEADER_WORDS: usize = 5;
const OP_ENTRY_POINT: u32 = 15;
/// OpSourceContinued, OpSource, OpSourceExtension, OpName, OpMemberName, OpString, OpLine, OpNoLine, OpModuleProcessed:
/// they change nothing, and hold paths of the machine that compiled.
const DEBUG_OPS: [u32; 9] = [2, 3, 4, 5, 6, 7, 8, 317, 330];

/// Drops all debug instructions, writes numbers so that WGSL has them, and gives the entry point its short name.
fn strip(name: &str, compiled: &[u8]) -> Result<Vec<u8>> {
    let words: Vec<u32> = compiled
        .chunks_exact(4)
        .map(|bytes| u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]))
        .collect();
    if words.len() < HEADER_WORDS || words[0] != 0x0723_0203 {
        bail!("it is no SPIR-V");
    }
    let mut kept = words[..HEADER_WORDS].to_vec();
    let mut at = HEADER_WORDS;
    while at < words.len() {
        // The high half of an instruction's first word is its length, the low half what it is.
        let (length, op) = ((words[at] >> 16) as usize, words[at] & 0xffff);
        let instruction = words
            .get(at..at + length)
            .filter(|words| !words.is_empty())
            .context("an instruction is cut off")?;
        if op == OP_ENTRY_POINT {
            kept.extend(renamed(instruction, name)?);
        } else if !DEBUG_OPS.contains(&op) {
            kept.extend(instruction);
        }
        at += length;
    }
    let kept = largest::as_bits(&kept)?;
    Ok(kept.iter().flat_map(|word| word.to_le_bytes()).collect())
}

/// `OpEntryPoint model function "name" interface…` with another name.
fn renamed(instruction: &[u32], name: &str) -> Result<Vec<u32>> {
    // The word that holds the name's terminating zero is its last.
    let is_last = |word: &u32| word.to_le_bytes().contains(&0);
    let name_words = instruction[3..]
        .iter()
        .position(is_last)
        .context("the entry point's name has no end")?
        + 1;
    let mut bytes = name.as_bytes().to_vec();
    bytes.resize((name.len() / 4 + 1) * 4, 0);
    let mut words = instruction[..3].to_vec();
    words.extend(
        bytes
            .chunks_exact(4)
            .map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])),
    );
    words.extend(&instruction[3 + name_words..]);
    words[0] = ((words.len() as u32) << 16) | OP_ENTRY_POINT;
    Ok(words)
}

/// The entry point, its workgroup size and its bindings, as naga sees them.
fn describe(name: &str, module: &naga::Module) -> Result<Value> {
    let [entry] = module.entry_points.as_slice() else {
        bail!("it has {} entry points", module.entry_points.len());
    };
    if entry.name != name {
        bail!("its entry point is {}", entry.name);
    }
    let layouts = {
        let mut layouter = naga::proc::Layouter::default();
        layouter.update(module.to_ctx()).context("layout")?;
        layouter
    };
    let mut bindings: Vec<(u32, u32, Value)> = Vec::new();
    let mut workgroup_bytes = 0;
    for (_, variable) in module.global_variables.iter() {
        if variable.space == AddressSpace::WorkGroup {
            workgroup_bytes += layouts[variable.ty].size;
        }
        let Some(binding) = &variable.binding else {
            continue;
        };
        let kind = match variable.space {
            AddressSpace::Uniform => "uniform",
            AddressSpace::Storage { access } if access.contains(StorageAccess::STORE) => {
                "read_write"
            }
            AddressSpace::Storage { .. } => "read",
            _ => bail!("binding {} is of another kind", binding.binding),
        };
        // For a runtime array the stride of its elements, else the size of it all.
        let size = layouts[variable.ty].size;
        bindings.push((
            binding.group,
            binding.binding,
            json!({ "binding": binding.binding, "kind": kind, "smallest_size_bytes": size }),
        ));
    }
    bindings.sort_by_key(|&(group, binding, _)| (group, binding));
    for (place, (group, binding, _)) in bindings.iter().enumerate() {
        if *group != 0 || *binding as usize != place {
            bail!("binding {place} of group 0 is missing: the code does not use it");
        }
    }
    let storage = bindings.iter().filter(|b| b.2["kind"] != "uniform").count();
    if storage > 8 || workgroup_bytes > 16384 {
        bail!(
            "{storage} storage buffers and {workgroup_bytes} bytes of workgroup memory are too many"
        );
    }
    Ok(json!({
        "name": name,
        "workgroup_size": entry.workgroup_size,
        "workgroup_bytes": workgroup_bytes,
        "bindings": bindings.into_iter().map(|b| b.2).collect::<Vec<_>>(),
    }))
}
