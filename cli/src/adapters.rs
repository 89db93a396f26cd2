//! `slimbvh info --adapters`.

use super::output::{self, bytes};
use anyhow::Result;
use serde::Serialize;
use slimbvh::gpu::{AdapterSummary, adapters};
use std::fmt::Write;
use std::path::Path;

/// Lists all GPUs.
pub fn run(json: Option<&Path>) -> Result<()> {
    let adapters = adapters();
    if !output::is_stdout(json) {
        output::print(&describe(&adapters))?;
    }
    match json {
        Some(path) => output::write_json(path, &summarize(&adapters)),
        None => Ok(()),
    }
}

#[derive(Debug, Serialize)]
struct Summary {
    adapters: Vec<Adapter>,
}

#[derive(Debug, Serialize)]
struct Adapter {
    name: String,
    kind: &'static str,
    api: &'static str,
    driver: String,
    timestamps: bool,
    max_buffer_bytes: u64,
    max_binding_bytes: u64,
    max_storage_buffers: u32,
    max_workgroup_bytes: u32,
    subgroup_size: [u32; 2],
}

fn summarize(adapters: &[AdapterSummary]) -> Summary {
    let adapter = |adapter: &AdapterSummary| Adapter {
        name: adapter.name.clone(),
        kind: adapter.kind,
        api: adapter.api,
        driver: adapter.driver.clone(),
        timestamps: adapter.has_timestamps,
        max_buffer_bytes: adapter.max_buffer_bytes,
        max_binding_bytes: adapter.max_binding_bytes,
        max_storage_buffers: adapter.max_storage_buffers,
        max_workgroup_bytes: adapter.max_workgroup_bytes,
        subgroup_size: adapter.subgroup_size,
    };
    Summary {
        adapters: adapters.iter().map(adapter).collect(),
    }
}

/// The list as text. The adapter that `--backend auto` prefers comes first.
fn describe(adapters: &[AdapterSummary]) -> String {
    let mut text = String::new();
    if adapters.is_empty() {
        return "no GPU: no driver for Vulkan, Metal or Direct3D 12 was found\n".into();
    }
    for adapter in adapters {
        let mut line = |name: &str, value: String| {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{name:<11} {value}");
        };
        let only_named = if adapter.is_software {
            ", used only with --adapter"
        } else {
            ""
        };
        line("adapter", adapter.name.clone());
        line(
            "",
            format!(
                "{}{only_named}, {}, {}",
                adapter.kind, adapter.api, adapter.driver
            ),
        );
        line(
            "limits",
            format!(
                "{} per buffer, {} per binding, {} storage buffers per kernel, {} per workgroup",
                bytes(adapter.max_buffer_bytes),
                bytes(adapter.max_binding_bytes),
                adapter.max_storage_buffers,
                bytes(adapter.max_workgroup_bytes)
            ),
        );
        let timestamps = if adapter.has_timestamps {
            "stages are timed"
        } else {
            "stages are not timed"
        };
        let [least, most] = adapter.subgroup_size;
        let subgroups = if least == most {
            format!("subgroups of {least}")
        } else {
            format!("subgroups of {least} to {most}")
        };
        line("features", format!("{timestamps}, {subgroups}"));
    }
    text
}
