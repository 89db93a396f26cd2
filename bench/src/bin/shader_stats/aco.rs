//! RADV's disassembly of a kernel for RDNA: `BB3:` and lines that begin with a tab.

use super::flow::{Instruction, Kind, Program};

/// Reads a disassembly.
pub fn parse(text: &str) -> Program {
    let mut program = Program::default();
    for line in text.lines() {
        if let Some(label) = line.strip_suffix(':').filter(|label| is_label(label)) {
            let place = program.instructions.len();
            program.labels.insert(label.to_owned(), place);
        } else if let Some(code) = line.strip_prefix('\t') {
            let code = code.split(';').next().unwrap_or_default();
            let mut words = code.split_whitespace();
            let Some(operation) = words.next() else {
                continue;
            };
            let is_branch = operation == "s_branch" || operation.starts_with("s_cbranch");
            let target = words.next_back().filter(|_| is_branch);
            program.instructions.push(Instruction {
                kind: kind(operation),
                targets: target.map(str::to_owned).into_iter().collect(),
                falls_through: operation != "s_branch" && operation != "s_endpgm",
            });
        }
    }
    program
}

fn is_label(word: &str) -> bool {
    let digits = word.strip_prefix("BB").unwrap_or_default();
    !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit())
}

fn kind(operation: &str) -> Kind {
    let starts = |words: &[&str]| words.iter().any(|word| operation.starts_with(word));
    if starts(&["scratch_store", "ds_write", "ds_store"]) {
        Kind::Stack
    } else if starts(&[
        "buffer_store",
        "global_store",
        "buffer_atomic",
        "global_atomic",
    ]) {
        Kind::Store
    } else if starts(&["v_mul_f32", "v_fma", "v_mac_f32", "v_ldexp_f32"]) {
        Kind::Multiply
    } else {
        Kind::Other
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_branches_and_stores() {
        let text = "BB0:\n\tv_mov_b32_e32 v1, 0       ; 7e020280\n\ts_cbranch_execz BB2  ; bf88\nBB1:\n\
                    \tscratch_store_dword off, v1, off ; dc70\n\ts_branch BB1 ; bf82\nBB2:\n\tbuffer_store_dwordx4 v[0:3] ; e0\n\
                    \ts_endpgm ; bf81\n";
        let program = parse(text);
        assert_eq!(program.instructions.len(), 6);
        assert_eq!(program.labels["BB2"], 4);
        assert_eq!(program.instructions[1].targets, ["BB2"]);
        assert!(program.instructions[1].falls_through);
        assert_eq!(program.instructions[2].kind, Kind::Stack);
        assert!(!program.instructions[3].falls_through);
        assert_eq!(program.instructions[4].kind, Kind::Store);
        assert!(!program.instructions[5].falls_through);
    }
}
