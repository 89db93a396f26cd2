//! The largest finite f32 in SPIR-V, so that browsers take what naga writes of it. wgpu translates modules to WGSL at run time,
//! where naga writes `f32::MAX` in the fewest digits that denote it, 3.4028235e38, which is above it: WGSL refuses that literal.
//!
//! Such a constant becomes the bits of an integer, cast at the function's entry; so does each composite that holds one. The
//! result keeps its number, so that no use changes.

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

/// Words of the header; one of them is the bound of all numbers.
const HEADER_WORDS: usize = 5;
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
