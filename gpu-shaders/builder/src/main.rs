//! Builds the modules under `host/shaders` and the list of kernels there from `gpu-shaders`, and the module of an example;
//! `--check` only says whether they are up to date.
//!
//! `RUST_GPU_TOOLCHAIN` names the toolchain. `RUSTC_CODEGEN_SPIRV` is the path of a ready backend, for a build with
//! `--no-default-features`.

mod callable;
mod kernels;
mod largest;
mod module;
mod source_hash;

use anyhow::{Context, Result, bail};
use module::Module;
use serde_json::{Value, json};
use spirv_builder::{ModuleResult, ShaderPanicStrategy, SpirvBuilder};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// A crate of entry points.
struct ShaderCrate {
    /// Where it is.
    folder: &'static str,
    /// Where its modules go.
    output: &'static str,
    /// The endings of the files made there; others are left alone.
    made: &'static [&'static str],
    /// The features of its parts, which are compiled one after the other; none for a crate without parts.
    parts: &'static [&'static str],
    /// Whether tests/no-panic proves all its entry points unable to panic, so that no panic need be compiled.
    cannot_panic: bool,
}

const CRATES: [ShaderCrate; 2] = [
    ShaderCrate {
        folder: "gpu-shaders",
        output: "host/shaders",
        made: &["spv", "wgsl", "json", "rs"],
        parts: &["plain", "paper10", "wide"],
        cannot_panic: true,
    },
    ShaderCrate {
        folder: "host/examples/own_shader/shader",
        output: "host/examples/own_shader",
        made: &["spv"],
        parts: &[],
        cannot_panic: false,
    },
];

const MANIFEST: &str = "host/shaders/manifest.json";

/// The list of kernels that the library includes.
const KERNELS: &str = "host/shaders/kernels.rs";

/// The toolchain that spirv-builder 0.10.0 belongs to.
const TOOLCHAIN: &str = "nightly-2026-07-03";

/// What is made, by its path from the root.
type Files = BTreeMap<String, Vec<u8>>;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let is_check = match arguments.as_slice() {
        [] => false,
        [argument] if argument == "--check" => true,
        _ => {
            eprintln!("usage: slimbvh-shader-builder [--check]");
            return ExitCode::from(2);
        }
    };
    match run(is_check) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(is_check: bool) -> Result<()> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .canonicalize()?;
    let files = build(&root)?;
    let old = read(&root)?;
    if is_check {
        compare(&files, &old)?;
        println!("all {} files are up to date", files.len());
    } else {
        write(&files, &old, &root)?;
        let bytes: usize = files.values().map(Vec::len).sum();
        println!("made {} files, {bytes} bytes", files.len());
    }
    Ok(())
}

/// Compiles all modules, and makes the manifest.
fn build(root: &Path) -> Result<Files> {
    let mut files = Files::new();
    let mut manifest = Vec::new();
    let mut kernels = BTreeSet::new();
    for shader_crate in &CRATES {
        let ShaderCrate { output, made, .. } = shader_crate;
        let mut called = BTreeMap::new();
        for (name, compiled) in compile(root, shader_crate)? {
            let module = Module::new(&name, &compiled).context(name.clone())?;
            check_paths(&module.spirv, root).context(name.clone())?;
            if callable::is_called(&name) {
                called.insert(name, module.ir);
                continue;
            }
            files.insert(format!("{output}/{name}.spv"), module.spirv);
            if made.contains(&"json") {
                manifest.push(module.manifest);
                kernels.insert(name);
            }
        }
        if !called.is_empty() {
            for (file, text) in callable::texts(&called)? {
                files.insert(format!("{output}/{file}"), text.into_bytes());
            }
        }
    }
    kernels::check_proof(
        &kernels::declared(&root.join("gpu-shaders"))?,
        &kernels,
        &root.join("tests/no-panic/src/entry_points.rs"),
    )?;
    let versions: BTreeMap<_, _> = source_hash::pinned_versions(root)?.into_iter().collect();
    let sources: Vec<&str> = CRATES.iter().map(|c| c.folder).collect();
    let manifest = json!({
        "source_hash": source_hash::source_hash(root, &sources)?,
        "versions": versions,
        "modules": manifest,
    });
    let text = serde_json::to_string_pretty(&manifest)? + "\n";
    files.insert(MANIFEST.to_owned(), text.into_bytes());
    files.insert(KERNELS.to_owned(), kernels::table(&kernels)?.into_bytes());
    Ok(files)
}

/// Compiles a crate. Returns the module of each entry point as it is compiled, by its short name.
fn compile(root: &Path, shader_crate: &ShaderCrate) -> Result<BTreeMap<String, Vec<u8>>> {
    let mut modules = BTreeMap::new();
    if shader_crate.parts.is_empty() {
        compile_part(root, shader_crate, None, &mut modules)?;
    }
    for part in shader_crate.parts {
        compile_part(root, shader_crate, Some(part), &mut modules)?;
    }
    // Releases of rust-gpu have lost entry points without an error.
    let folder = shader_crate.folder;
    let declared = kernels::declared(&root.join(folder))?;
    let found: BTreeSet<String> = modules.keys().cloned().collect();
    if found != declared {
        let missing: Vec<_> = declared.difference(&found).collect();
        let unknown: Vec<_> = found.difference(&declared).collect();
        bail!(
            "entry points of {folder}: declared but not compiled {missing:?}, compiled but not declared {unknown:?}"
        );
    }
    Ok(modules)
}

/// Compiles a part of a crate, or all of it, and adds its modules.
fn compile_part(
    root: &Path,
    shader_crate: &ShaderCrate,
    part: Option<&str>,
    modules: &mut BTreeMap<String, Vec<u8>>,
) -> Result<()> {
    let target = std::env::var_os("CARGO_TARGET_DIR")
        .map_or_else(|| root.join("gpu-shaders/builder/target"), PathBuf::from);
    let mut builder = SpirvBuilder::new(root.join(shader_crate.folder), "spirv-unknown-vulkan1.2");
    builder.multimodule = true;
    if let Some(part) = part {
        builder.shader_crate_features.default_features = false;
        builder.shader_crate_features.features = vec![part.to_owned()];
    }
    if shader_crate.cannot_panic {
        // Sound as no panic can be reached: what is unreachable is never run.
        builder.shader_panic_strategy =
            ShaderPanicStrategy::UNSOUND_DO_NOT_USE_UndefinedBehaviorViaUnreachable;
    }
    builder.target_dir_path = Some(std::path::absolute(target)?.join("spirv"));
    builder.toolchain_overwrite =
        Some(std::env::var("RUST_GPU_TOOLCHAIN").unwrap_or_else(|_| TOOLCHAIN.to_owned()));
    if let Some(backend) = std::env::var_os("RUSTC_CODEGEN_SPIRV") {
        builder.rustc_codegen_spirv_location = Some(backend.into());
    } else if !cfg!(feature = "build-backend") {
        bail!("RUSTC_CODEGEN_SPIRV must name the backend in a build without `build-backend`");
    }
    let folder = shader_crate.folder;
    let result = builder
        .build()
        .with_context(|| format!("{folder} does not compile"))?;

    let ModuleResult::MultiModule(paths) = result.module else {
        bail!("the backend made one module for all entry points");
    };
    for (entry, path) in paths {
        let module = fs::read(&path).with_context(|| path.display().to_string())?;
        if modules.insert(short(&entry).to_owned(), module).is_some() {
            bail!("{folder} has two entry points {:?}", short(&entry));
        }
    }
    Ok(())
}

/// The function's name, without its module's.
fn short(entry: &str) -> &str {
    entry.rsplit("::").next().unwrap_or(entry)
}

/// Fails if a module holds a path of this machine: committed modules must be the same everywhere.
fn check_paths(spirv: &[u8], root: &Path) -> Result<()> {
    let root = root.to_string_lossy();
    for text in [root.as_ref(), ".rs", "slimbvh_core"] {
        if spirv.windows(text.len()).any(|w| w == text.as_bytes()) {
            bail!("the module still holds {text:?}");
        }
    }
    Ok(())
}

/// What has been made before, also for entry points that are no more.
fn read(root: &Path) -> Result<Files> {
    let mut files = Files::new();
    for ShaderCrate { output, made, .. } in &CRATES {
        let folder = root.join(output);
        if !folder.exists() {
            continue;
        }
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            let ending = path.extension().unwrap_or_default().to_string_lossy();
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            if made.contains(&ending.as_ref()) {
                files.insert(format!("{output}/{name}"), fs::read(&path)?);
            }
        }
    }
    Ok(files)
}

/// Writes what has changed and removes what is left over.
fn write(files: &Files, old: &Files, root: &Path) -> Result<()> {
    for name in old.keys().filter(|name| !files.contains_key(*name)) {
        fs::remove_file(root.join(name))?;
    }
    for shader_crate in &CRATES {
        fs::create_dir_all(root.join(shader_crate.output))?;
    }
    for (name, bytes) in files {
        if old.get(name) != Some(bytes) {
            fs::write(root.join(name), bytes)?;
        }
    }
    Ok(())
}

/// Says what differs.
fn compare(new: &Files, old: &Files) -> Result<()> {
    let names: BTreeSet<&String> = new.keys().chain(old.keys()).collect();
    let changed: Vec<_> = names
        .into_iter()
        .filter(|&name| new.get(name) != old.get(name))
        .map(
            |name| match (new.contains_key(name), old.contains_key(name)) {
                (true, true) => format!("{name} differs"),
                (true, false) => format!("{name} is missing"),
                _ => format!("{name} is left over"),
            },
        )
        .collect();
    if changed.is_empty() {
        return Ok(());
    }
    let (now, then) = (hash_of(new), hash_of(old));
    bail!(
        "shaders are out of date (code {now}, modules made from {then}): {}; run the shader builder",
        changed.join(", ")
    )
}

/// The hash that a manifest names.
fn hash_of(files: &Files) -> String {
    files
        .get(MANIFEST)
        .and_then(|text| serde_json::from_slice::<Value>(text).ok())
        .and_then(|manifest| Some(manifest["source_hash"].as_str()?.to_owned()))
        .unwrap_or_else(|| "nothing".to_owned())
}
