//! The list of entry points: as the source text declares it, and as `host/shaders/kernels.rs` lists it for the library.

use crate::source_hash::each_file;
use anyhow::{Context, Result, bail};
use proc_macro2::{TokenStream, TokenTree};
use std::collections::BTreeSet;
use std::path::Path;
use syn::{File, Item, ItemFn};

/// Kernels that only the laboratory asks for, by parts of their names: those of the codec that ours is measured against, and
/// questions about trees in codecs that no picture needs.
const LAB: [&str; 3] = ["_paper10_", "trace_nearest_", "trace_counted_"];

/// The kernels that trace one kind of tree, in the order of a row: what stands before the codec's name, and what stands behind.
const QUESTIONS: [[&str; 2]; 12] = [
    ["trace_closest", ""],
    ["trace_any", ""],
    ["trace_filtered_closest", ""],
    ["trace_filtered_any", ""],
    ["trace_nearest", ""],
    ["trace_rays", "_overflow"],
    ["trace_counted", ""],
    ["trace_paths", ""],
    ["trace_paths", "_overflow"],
    ["trace_paths_counted", ""],
    ["trace_shadows", ""],
    ["trace_shadows", "_overflow"],
];

/// The entry points that the source text of a crate declares.
///
/// # Errors
/// Where a file cannot be read or is no Rust.
pub fn declared(folder: &Path) -> Result<BTreeSet<String>> {
    let mut names = BTreeSet::new();
    let source = folder.join("src");
    each_file(&source, "lib", &source, &mut |file| {
        collect(file, &mut names)
    })?;
    Ok(names)
}

/// Adds the functions of a file that have `#[spirv(compute(…))]`, and those that macro calls name as `pub fn name;`.
fn collect(file: &File, names: &mut BTreeSet<String>) {
    for item in &file.items {
        match item {
            Item::Fn(function) if is_entry_point(function) => {
                names.insert(function.sig.ident.to_string());
            }
            Item::Macro(call) => collect_from_call(call.mac.tokens.clone(), names),
            _ => {}
        }
    }
}

fn is_entry_point(function: &ItemFn) -> bool {
    function.attrs.iter().any(|attribute| {
        attribute.path().is_ident("spirv")
            && attribute.meta.require_list().is_ok_and(|list| {
                let first = list.tokens.clone().into_iter().next();
                matches!(first, Some(TokenTree::Ident(ident)) if ident == "compute")
            })
    })
}

fn collect_from_call(tokens: TokenStream, names: &mut BTreeSet<String>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for window in tokens.windows(3) {
        if let [
            TokenTree::Ident(keyword),
            TokenTree::Ident(name),
            TokenTree::Punct(end),
        ] = window
            && keyword == "fn"
            && end.as_char() == ';'
        {
            names.insert(name.to_string());
        }
    }
}

/// The text of `host/shaders/kernels.rs`: the kernels by name, those of the laboratory apart, and a row of kernels for trees in
/// full and for each codec.
///
/// # Errors
/// Where a codec has no kernel for a question.
pub fn table(names: &BTreeSet<String>) -> Result<String> {
    let is_lab = |name: &&String| LAB.iter().any(|part| name.contains(part));
    let (lab, shipped): (Vec<_>, Vec<_>) = names.iter().partition(is_lab);
    let list = |names: &[&String]| -> String {
        names
            .iter()
            .map(|name| format!("        {name},\n"))
            .collect()
    };
    let mut text = format!(
        "// Written by the shader builder from the entry points of `gpu-shaders`; do not edit.\n\n\
         kernels! {{\n    shipped {{\n{}    }}\n    lab {{\n{}    }}\n}}\n\ntraces! {{\n",
        list(&shipped),
        list(&lab)
    );
    let [[first, _], ..] = QUESTIONS;
    for codec in names.iter().filter_map(|name| name.strip_prefix(first)) {
        let kernels = QUESTIONS.map(|[question, pass]| format!("{question}{codec}{pass}"));
        for name in &kernels {
            names
                .get(name)
                .with_context(|| format!("gpu-shaders has no {name}, but {first}{codec}"))?;
        }
        let pattern = if codec.is_empty() {
            "None".to_owned()
        } else {
            format!("Some(Coding::{})", camel_case(codec))
        };
        text += &format!("    {pattern} => {};\n", kernels.join(", "));
    }
    Ok(text + "}\n")
}

/// `_q10_f32` as the name of a variant: `Q10F32`.
fn camel_case(name: &str) -> String {
    let capitalized = |word: &str| word[..1].to_uppercase() + &word[1..];
    let words = name.split('_').filter(|word| !word.is_empty());
    words.map(capitalized).collect()
}

/// Checks that every entry point is in the proof that none can panic: in the list of kernels, which the proof includes, or in
/// the text of the proof by name.
///
/// # Errors
/// Where an entry point is in neither, or the text cannot be read.
pub fn check_proof(
    declared: &BTreeSet<String>,
    kernels: &BTreeSet<String>,
    proof: &Path,
) -> Result<()> {
    let text = std::fs::read_to_string(proof).with_context(|| proof.display().to_string())?;
    let unproven: Vec<_> = declared
        .difference(kernels)
        .filter(|name| !text.contains(&format!("|| {name} as *const ()")))
        .collect();
    if !unproven.is_empty() {
        bail!("entry points that tests/no-panic does not prove unable to panic: {unproven:?}");
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_entry_point_outside_the_proof_is_named() -> Result<()> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let proof = root.join("tests/no-panic/src/entry_points.rs");
        let mut declared = declared(&root.join("gpu-shaders"))?;
        let mut kernels = declared.clone();
        kernels.retain(|name| !name.starts_with("call_"));
        assert!(kernels.len() < declared.len());
        check_proof(&declared, &kernels, &proof)?;

        // The second is the end of a proven one's name.
        for name in ["trace_unproven", "trace"] {
            declared.insert(name.to_owned());
            let message = check_proof(&declared, &kernels, &proof).unwrap_err();
            let named = format!("[\"{name}\"]");
            assert!(message.to_string().ends_with(&named), "{message}");
            declared.remove(name);
        }
        check_proof(&declared, &declared, &proof)
    }
}
