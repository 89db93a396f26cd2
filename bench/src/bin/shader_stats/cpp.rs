//! A kernel in NVIDIA's C++: naga's Metal text, which is C++ but for address spaces and the kernel's parameters.

use super::translate::{Kernel, checks};
use anyhow::{Context, Result, bail};
use naga::back::msl;

/// What the text needs before it.
const PRELUDE: &str = include_str!("prelude.h");

/// Translates a kernel, with the checks that wgpu adds for Vulkan: see [`Kernel::for_vulkan`].
pub fn translate(kernel: &Kernel) -> Result<String> {
    let options = msl::Options {
        lang_version: (2, 4),
        fake_missing_bindings: true,
        bounds_check_policies: checks(),
        zero_initialize_workgroup_memory: false,
        force_loop_bounding: true,
        emit_int_div_checks: true,
        ..msl::Options::default()
    };
    let pipeline = msl::PipelineOptions::default();
    let written = msl::write_string(&kernel.module, &kernel.info, &options, &pipeline);
    let (text, _) = written.context("naga cannot write it")?;
    let (before, entry) = text
        .split_once("[[max_total")
        .context("there is no kernel")?;
    let before: String = before
        .lines()
        .filter(|line| !line.starts_with("#include") && !line.starts_with("using "))
        .flat_map(|line| [line, "\n"])
        .collect();
    let lanes = kernel.module.entry_points[0].workgroup_size;
    let text = format!("{before}{}", entry_point(entry, kernel.name(), lanes)?);
    let text = continued(&text);
    // Bounds of loops are written without their namespace; CUDA has a `uint2` of its own.
    let text = text.replace(" uint2", " metal::uint2");
    Ok(format!("{PRELUDE}{}", single(&text)))
}

/// Rewrites the kernel itself: resources become pointers that do not alias, builtins are computed.
fn entry_point(text: &str, name: &str, lanes: [u32; 3]) -> Result<String> {
    let (_, rest) = text.split_once("(\n").context("there are no parameters")?;
    let (parameters, body) = rest.split_once(") {\n").context("there is no body")?;
    let mut head = Vec::new();
    let mut begin = String::new();
    for line in parameters.lines() {
        let line = line.trim_start_matches([',', ' ']);
        let (declared, attribute) = line.split_once(" [[").unwrap_or((line, ""));
        let (typed, variable) = declared
            .rsplit_once(' ')
            .context("a parameter has a name")?;
        match typed.split_once(' ') {
            Some(("threadgroup", of)) => {
                let of = of.trim_end_matches('&');
                begin += &format!("    __shared__ {of} {variable};\n");
            }
            Some(("constant", of)) => {
                head.push(format!("const {} {variable}", of.trim_end_matches('&')));
            }
            Some(("device", of)) => {
                let of = of.trim_end_matches('&');
                head.push(format!("{of}* __restrict__ {variable}_at"));
                begin += &format!("    {of}& {variable} = *{variable}_at;\n");
            }
            _ => {
                let value = builtin(attribute.trim_end_matches("]]"), lanes)?;
                begin += &format!("    {typed} {variable} = {value};\n");
            }
        }
    }
    let threads: u32 = lanes.iter().product();
    Ok(format!(
        "extern \"C\" __global__ void __launch_bounds__({threads}) {name}({}) {{\n{begin}{body}",
        head.join(", ")
    ))
}

/// The value of a Metal attribute of a parameter.
fn builtin(attribute: &str, [x, y, z]: [u32; 3]) -> Result<String> {
    let group = "blockIdx.x, blockIdx.y, blockIdx.z";
    let lane = "threadIdx.x, threadIdx.y, threadIdx.z";
    Ok(match attribute {
        "thread_position_in_grid" => format!(
            "metal::uint3(blockIdx.x * {x} + threadIdx.x, blockIdx.y * {y} + threadIdx.y, \
             blockIdx.z * {z} + threadIdx.z)"
        ),
        "threadgroup_position_in_grid" => format!("metal::uint3({group})"),
        "thread_position_in_threadgroup" => format!("metal::uint3({lane})"),
        "threadgroups_per_grid" => "metal::uint3(gridDim.x, gridDim.y, gridDim.z)".into(),
        "thread_index_in_threadgroup" => {
            format!("threadIdx.x + {x} * (threadIdx.y + {y} * threadIdx.z)")
        }
        other => bail!("a kernel's parameter has the unknown attribute {other:?}"),
    })
}

/// Metal has no place for what a loop does before it begins again: naga writes it at the loop's beginning, skipped the first
/// time by a flag, which costs instructions that SPIR-V has not. It is moved to the loop's end; `continue` jumps there.
fn continued(text: &str) -> String {
    struct Open {
        indentation: usize,
        /// The flag's name and the lines that are moved, where there are any.
        moved: Option<(String, String)>,
    }
    let mut open: Vec<Open> = Vec::new();
    let mut out = String::with_capacity(text.len());
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        let code = line.trim_start();
        let indentation = line.len() - code.len();
        let closes = |one: &Open| code == "}" && one.indentation == indentation;
        if code == "while(true) {" {
            open.push(Open {
                indentation,
                moved: None,
            });
        } else if code.starts_with("bool loop_init") {
            continue;
        } else if let Some(flag) = code.strip_prefix("if (!loop_init") {
            let flag = flag.trim_end_matches(") {").to_owned();
            let end = format!("{}}}", " ".repeat(indentation));
            let part = lines.by_ref().take_while(|&line| line != end);
            let part = part.flat_map(|line| [line, "\n"]).collect();
            if let Some(one) = open.last_mut() {
                one.moved = Some((flag, part));
            }
            continue;
        } else if code.starts_with("loop_init") {
            out += "{\n";
            continue;
        } else if let Some(Open {
            moved: Some((flag, _)),
            ..
        }) = open.last().filter(|_| code == "continue;")
        {
            out += &format!("goto continuing{flag};\n");
            continue;
        } else if open.last().is_some_and(closes)
            && let Some(Open {
                moved: Some((flag, part)),
                ..
            }) = open.pop()
        {
            out += &format!("}}\ncontinuing{flag}: ;\n{part}");
        }
        out += line;
        out.push('\n');
    }
    out
}

/// Literals with a point are of single precision in Metal, of double precision in C++: an `f` is appended.
fn single(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 1024);
    let mut rest = text;
    while let Some(place) = rest.find(|c: char| c.is_ascii_alphanumeric() || c == '_') {
        out += &rest[..place];
        rest = &rest[place..];
        let is_number = rest.starts_with(|c: char| c.is_ascii_digit());
        let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_' || (is_number && c == '.');
        let mut end = rest.find(|c| !is_word(c)).unwrap_or(rest.len());
        // The sign of an exponent.
        if is_number && rest[..end].ends_with('e') && rest[end..].starts_with(['-', '+']) {
            let tail = &rest[end + 1..];
            end += 1 + tail
                .find(|c: char| !c.is_ascii_digit())
                .unwrap_or(tail.len());
        }
        let word = &rest[..end];
        out += word;
        let is_hexadecimal = word.starts_with("0x");
        let is_single = is_number && !is_hexadecimal && !word.ends_with(['f', 'h', 'u']);
        if is_single && word.contains(['.', 'e']) {
            out.push('f');
        }
        rest = &rest[end..];
    }
    out + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn literals_become_single() {
        let text = "a = 1.0 * b2.x + 2.5e-7 - 1e9 + 3u + 4 + 0x1e2 + 1.5f + _e12.member;";
        let expected = "a = 1.0f * b2.x + 2.5e-7f - 1e9f + 3u + 4 + 0x1e2 + 1.5f + _e12.member;";
        assert_eq!(single(text), expected);
    }

    #[test]
    fn what_a_loop_does_before_it_begins_again_is_at_its_end() {
        let text = "bool loop_init_1 = true;\nwhile(true) {\n    bound();\n    if (!loop_init_1) {\n        i = j;\n        \
                    if (!(k)) {\n            break;\n        }\n    }\n    loop_init_1 = false;\n    if (a) {\n        \
                    continue;\n    }\n    while(true) {\n        continue;\n    }\n}\n";
        let expected = "while(true) {\n    bound();\n{\n    if (a) {\ngoto continuing_1;\n    }\n    while(true) {\n        \
                        continue;\n    }\n}\ncontinuing_1: ;\n        i = j;\n        if (!(k)) {\n            break;\n        \
                        }\n}\n";
        assert_eq!(continued(text), expected);
    }

    #[test]
    fn parameters_become_pointers() {
        let text = "(64)]] kernel void k_(\n  metal::uint3 param [[threadgroup_position_in_grid]]\n\
                    , device T const& a [[user(fake0)]]\n, device U& b [[user(fake0)]]\n\
                    , threadgroup W& c\n) {\n    f(a, b, c);\n}\n";
        let entry = entry_point(text, "k", [64, 1, 1]).expect("a kernel");
        assert!(
            entry.contains("k(T const* __restrict__ a_at, U* __restrict__ b_at) {"),
            "{entry}"
        );
        assert!(entry.contains("U& b = *b_at;"), "{entry}");
        assert!(entry.contains("__shared__ W c;"), "{entry}");
        assert!(
            entry.contains("param = metal::uint3(blockIdx.x,"),
            "{entry}"
        );
    }
}
