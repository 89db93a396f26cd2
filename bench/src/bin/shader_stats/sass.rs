//! nvdisasm's text of a kernel for NVIDIA GPUs: `.L_x_3:` and lines `/*0a10*/ @P0 BRA` with the label in backquotes.

use super::flow::{Instruction, Kind, Program};

/// Reads a disassembly. What only fills up the kernel's end is left out.
pub fn parse(text: &str) -> Program {
    let mut program = Program::default();
    for line in text.lines().map(str::trim) {
        if let Some(label) = line
            .strip_suffix(':')
            .filter(|label| label.starts_with(".L_"))
        {
            let place = program.instructions.len();
            program.labels.insert(label.to_owned(), place);
        } else if let Some(code) = code(line) {
            program.instructions.push(instruction(code));
        }
    }
    // The kernel ends in a jump to itself, aligned by operations that do nothing.
    let used = program.instructions.iter().rposition(|one| {
        let is_padding = one.targets.is_empty() && one.falls_through && one.kind == Kind::Other;
        !is_padding
    });
    program
        .instructions
        .truncate(used.map_or(0, |place| place + 1));
    program
}

/// The code of a line `/*0a10*/ CODE ; /* encoding */`.
fn code(line: &str) -> Option<&str> {
    let (address, rest) = line.strip_prefix("/*")?.split_once("*/")?;
    let is_address = !address.is_empty() && address.bytes().all(|byte| byte.is_ascii_hexdigit());
    let (code, _) = rest.split_once(';')?;
    is_address.then(|| code.trim())
}

fn instruction(code: &str) -> Instruction {
    let mut words = code.split_whitespace().peekable();
    let is_conditional = words.next_if(|word| word.starts_with('@')).is_some();
    let operation = words.next().unwrap_or_default();
    let name = operation.split('.').next().unwrap_or_default();
    let is_jump = ["BRA", "BRX", "BREAK", "CALL", "RET", "JMP", "EXIT"].contains(&name);
    let target = code
        .split_once("`(")
        .and_then(|(_, rest)| rest.split_once(')'));
    let target = target
        .filter(|_| is_jump)
        .map(|(label, _)| label.to_owned());
    // A further operand of a branch is a predicate; a branch of diverging lanes goes on, too.
    let has_operand = words.any(|word| !word.starts_with('`')) && name != "RET";
    let is_certain = name != "CALL" && !is_conditional && !has_operand && operation != "BRA.DIV";
    Instruction {
        kind: kind(name),
        targets: target.into_iter().collect(),
        falls_through: !(is_jump && is_certain),
    }
}

fn kind(name: &str) -> Kind {
    match name {
        "STL" | "STS" => Kind::Stack,
        "STG" | "ATOMG" | "RED" | "REDG" => Kind::Store,
        "FMUL" | "FFMA" => Kind::Multiply,
        _ => Kind::Other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_branches_and_stores() {
        let text = "
.text.trace:
        /*0000*/                   LDC R1, c[0x0][0x28] ;
        /*0010*/              @P0 BRA `(.L_x_1) ;
.L_x_0:
        /*0020*/                   STL.64 [R1], RZ ;
        /*0030*/                   BRA P1, `(.L_x_0) ;
        /*0040*/                   BRA `(.L_x_0) ;
.L_x_1:
        /*0050*/                   STG.E.128 desc[UR4][R2.64], R4 ;
        /*0060*/                   EXIT ;
.L_x_2:
        /*0070*/                   BRA `(.L_x_2);
        /*0080*/                   NOP;
";
        let program = parse(text);
        assert_eq!(program.instructions.len(), 8);
        assert_eq!(program.labels[".L_x_1"], 5);
        assert_eq!(program.instructions[1].targets, [".L_x_1"]);
        assert!(program.instructions[1].falls_through);
        assert_eq!(program.instructions[2].kind, Kind::Stack);
        assert!(program.instructions[3].falls_through);
        assert!(!program.instructions[4].falls_through);
        assert_eq!(program.instructions[5].kind, Kind::Store);
        assert!(!program.instructions[6].falls_through);
    }
}
