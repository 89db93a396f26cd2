//! The largest finite f32 in SPIR-V, so that browsers take what naga writes of it. wgpu translates modules to WGSL at run time,
//! where naga writes `f32::MAX` in the fewest digits that denote it, 3.4028235e38, which is above it: WGSL refuses that literal.
//!
//! Such a constant becomes the bits of an integer, cast at the function's entry; so does each composite that holds one. The
//! result keeps its number, so that no use changes.

use crate::module::HEADER_WORDS;
use anyhow::{Context, Result, bail};
use naga::{Expression, Literal};

const OP_TYPE_INT: u32 = 21;
const OP_TYPE_FLOAT: u32 = 22;
const OP_CONSTANT: u32 = 43;
const OP_CONSTANT_COMPOSITE: u32 = 44;
const OP_FUNCTION: u32 = 54;
const OP_VARIABLE: u32 = 59;
const OP_COMPOSITE_CONSTRUCT: u32 = 80;
const OP_BITCAST: u32 = 124;
const OP_LABEL: u32 = 248;

/// The header's word that is the bound of all numbers.
const BOUND: usize = 3;

/// Whether WGSL refuses the shortest decimal that denotes `x`: as a real number it is beyond `f32::MAX`.
fn is_refused(x: f32) -> bool {
    let written: f64 = format!("{x}").parse().unwrap_or(f64::INFINITY);
    written.abs() > f64::from(f32::MAX)
}

/// The instruction's operation.
fn op(instruction: &[u32]) -> u32 {
    instruction[0] & 0xffff
}

/// An instruction of `operation` with the operands of another one.
fn with_op(operation: u32, operands: &[u32]) -> Vec<u32> {
    let mut words = vec![((operands.len() as u32 + 1) << 16) | operation];
    words.extend(operands);
    words
}

/// Moves constants that WGSL would refuse from the module's head into its only function.
///
/// # Errors
/// Where the module has such a constant, but several functions, no u32, or a variable that begins as that constant.
pub fn as_bits(module: &[u32]) -> Result<Vec<u32>> {
    let mut kept = module[..HEADER_WORDS].to_vec();
    let (mut float, mut word) = (0, None);
    // Results that moved, the integers that they are cast from, and their definitions in order.
    let (mut moved, mut bits, mut defined) = (Vec::new(), Vec::new(), Vec::new());
    let (mut functions, mut is_entry) = (0, false);
    let mut rest = &module[HEADER_WORDS..];
    while let Some(&head) = rest.first() {
        let instruction = rest
            .get(..(head >> 16) as usize)
            .filter(|words| !words.is_empty())
            .context("an instruction is cut off")?;
        rest = &rest[instruction.len()..];
        // Definitions stand behind the variables of the function's first block.
        if is_entry && op(instruction) != OP_VARIABLE {
            kept.append(&mut defined);
            is_entry = false;
        }
        match (op(instruction), &instruction[1..]) {
            (OP_TYPE_FLOAT, &[result, 32, ..]) => float = result,
            (OP_TYPE_INT, &[result, 32, 0]) => word = Some(result),
            (OP_CONSTANT, &[ty, result, value])
                if ty == float && is_refused(f32::from_bits(value)) =>
            {
                let number = kept[BOUND];
                kept[BOUND] += 1;
                moved.push(result);
                bits.push([number, value]);
                defined.extend(with_op(OP_BITCAST, &[ty, result, number]));
                continue;
            }
            (OP_CONSTANT_COMPOSITE, operands @ &[_, result, ref parts @ ..])
                if parts.iter().any(|part| moved.contains(part)) =>
            {
                moved.push(result);
                defined.extend(with_op(OP_COMPOSITE_CONSTRUCT, operands));
                continue;
            }
            (OP_FUNCTION, _) => {
                functions += 1;
                for [number, value] in bits.drain(..) {
                    let word = word.context("it has no u32")?;
                    kept.extend(with_op(OP_CONSTANT, &[word, number, value]));
                }
            }
            (OP_LABEL, _) => is_entry = !defined.is_empty(),
            (OP_VARIABLE, &[_, _, _, start]) if moved.contains(&start) => {
                bail!("a variable begins as a number that WGSL cannot write")
            }
            _ => {}
        }
        kept.extend(instruction);
    }
    if !moved.is_empty() && functions != 1 {
        bail!("{functions} functions would share numbers that WGSL cannot write");
    }
    Ok(kept)
}

/// Fails where naga would write a number that WGSL refuses.
///
/// # Errors
/// Where a literal of the module is one.
pub fn check(module: &naga::Module) -> Result<()> {
    let functions = module.functions.iter().map(|(_, function)| function);
    let entries = module.entry_points.iter().map(|entry| &entry.function);
    let locals = functions.chain(entries).flat_map(|f| f.expressions.iter());
    for (_, expression) in module.global_expressions.iter().chain(locals) {
        if let Expression::Literal(Literal::F32(x)) = *expression
            && is_refused(x)
        {
            bail!("WGSL cannot write {x:e}");
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use naga::back::{spv, wgsl};
    use naga::front::{spv as from_spv, wgsl as from_wgsl};
    use naga::valid::{Capabilities, ValidationFlags, Validator};

    /// What stands for `f32::MAX` in a text: WGSL cannot write that, and this stands nowhere else.
    const MARK: f32 = 1.25e30;

    /// The module of a text, with the largest number in the place of each mark.
    fn planted(text: &str) -> Vec<u32> {
        let module = from_wgsl::parse_str(text).expect("the text is WGSL");
        let info = Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&module);
        let info = info.expect("the text is valid");
        let words = spv::write_vec(&module, &info, &spv::Options::default(), None);
        let mut words = words.expect("naga writes it");
        let mut count = 0;
        for word in &mut words {
            if *word == MARK.to_bits() {
                (*word, count) = (f32::MAX.to_bits(), count + 1);
            }
        }
        assert!(count > 0, "the text has no mark");
        words
    }

    fn read(words: &[u32]) -> naga::Module {
        let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
        let module = from_spv::parse_u8_slice(&bytes, &from_spv::Options::default());
        module.expect("it is SPIR-V")
    }

    /// A kernel with this body.
    fn kernel(body: &str) -> String {
        format!(
            "@group(0) @binding(0) var<storage, read_write> numbers: array<vec4<f32>>;
             @compute @workgroup_size(64) fn kernel(@builtin(global_invocation_id) id: vec3<u32>) {{ {body} }}"
        )
    }

    #[test]
    fn largest_numbers_become_bits() -> Result<()> {
        for (body, count) in [
            ("numbers[id.x].x = min(numbers[id.y].x, 1.25e30);", 1),
            ("numbers[id.x] = min(numbers[id.y], vec4(1.25e30));", 1),
            (
                "if id.y > 3u { numbers[id.x] = max(numbers[id.y], vec4(1.25e30, 1.0, 1.25e30, 2.0)); }",
                2,
            ),
            (
                "numbers[id.x] = select(vec4(1.25e30), numbers[id.y], id.z > 2u);",
                1,
            ),
        ] {
            let before = planted(&kernel(body));
            assert!(check(&read(&before)).is_err(), "the check is blind: {body}");
            let after = read(&as_bits(&before)?);
            check(&after)?;
            let info = Validator::new(ValidationFlags::all(), Capabilities::empty())
                .validate(&after)
                .expect("it is still valid");
            let text = wgsl::write_string(&after, &info, wgsl::WriterFlags::empty())?;
            let found = text.matches("bitcast<f32>(2139095039u)").count();
            assert!(found >= 1 && found <= count, "{found}: {text}");
            from_wgsl::parse_str(&text).expect("naga reads what it wrote");
        }
        Ok(())
    }

    #[test]
    fn modules_without_such_numbers_stay_as_they_are() -> Result<()> {
        let mut words = planted(&kernel("numbers[id.x].x = 1.25e30;"));
        for word in &mut words {
            if *word == f32::MAX.to_bits() {
                *word = MARK.to_bits();
            }
        }
        check(&read(&words))?;
        assert_eq!(as_bits(&words)?, words);
        Ok(())
    }

    #[test]
    fn what_cannot_be_moved_is_refused() {
        let private =
            "var<private> kept: f32 = 1.25e30;\n".to_owned() + &kernel("numbers[id.x].x = kept;");
        let two = "fn second(x: f32) -> f32 { return min(x, 1.25e30); }\n".to_owned()
            + &kernel("numbers[id.x].x = second(numbers[id.x].y);");
        for (text, reason) in [(private, "a variable begins"), (two, "2 functions")] {
            let message = as_bits(&planted(&text)).unwrap_err().to_string();
            assert!(message.starts_with(reason), "{message}");
        }
        let whole = planted(&kernel("numbers[id.x].x = 1.25e30;"));
        assert!(as_bits(&whole[..HEADER_WORDS + 1]).is_err());
    }
}
