//! Growth of a build's instructions with the mesh.

use super::child;
use super::count;
use super::options::Options;
use anyhow::{Context, Result, ensure};
use rayon::prelude::*;
use slimbvh::{Builder, CodeBits, generate};
use slimbvh_bench::machine;
use slimbvh_lab::measure::exponent::{CELLS, exponent};
use std::fmt::Write;

/// The first argument of a child process that generates a terrain and builds over it.
pub const WORD: &str = "--child-terrain";

/// The largest allowed exponent.
pub const LIMIT: f64 = 1.02;

/// Lengths of codes, in the order of the table.
const CODES: [CodeBits; 2] = [CodeBits::Bits30, CodeBits::Bits63];

/// Counts of builds over one terrain.
struct Row {
    triangles: u64,
    /// Instructions of a build with each of [`CODES`].
    counts: [u64; 2],
}

/// The child: generates a terrain with the given cells a side and, if asked to, builds over it with the codes at the given
/// place in [`CODES`].
pub fn run(arguments: impl Iterator<Item = String>) -> Result<()> {
    let [cells, code] = child::numbers(arguments)?;
    let triangles = slimbvh_bench::pool(1)?.install(|| -> Result<usize> {
        let mesh = generate::terrain(10.0, cells as u32, 1);
        let Some(&code_bits) = CODES.get(code) else {
            return Ok(mesh.indices.len());
        };
        Ok(Builder::new(code_bits.into())
            .build(&mesh)?
            .triangle_count())
    })?;
    println!("{triangles}");
    Ok(())
}

/// Counts all builds. Returns the record, and whether all exponents are within the limit.
pub fn record(options: &Options) -> Result<(String, bool)> {
    let rows: Vec<Row> = CELLS.par_iter().map(measure).collect::<Result<_>>()?;
    report(&rows, options)
}

fn measure(&cells: &u32) -> Result<Row> {
    let triangles = 2 * u64::from(cells) * u64::from(cells);
    let count = |code: usize| {
        let arguments = [WORD.to_owned(), cells.to_string(), code.to_string()];
        let counted = count::instructions(&arguments, &format!("{triangles} triangles"))?;
        let said = &counted.said;
        ensure!(
            *said == triangles.to_string(),
            "{triangles} triangles became {said}"
        );
        Ok(counted.instructions)
    };
    let generating = count(CODES.len())?;
    let counts = [count(0)? - generating, count(1)? - generating];
    eprintln!("{triangles} triangles: {counts:?}");
    Ok(Row { triangles, counts })
}

fn report(rows: &[Row], options: &Options) -> Result<(String, bool)> {
    let mut out = String::new();
    writeln!(out, "# How a build grows\n\n    {}\n", options.command())?;
    writeln!(
        out,
        "Instructions of a build over a generated terrain on the CPU, one thread, into new buffers, checks of the mesh \
         included, without generating it. Counted by Valgrind, {}, on {}.\n",
        env!("BENCH_RUSTC"),
        machine::date()
    )?;
    writeln!(
        out,
        "| triangles | 30-bit codes, M | a triangle | 63-bit codes, M | a triangle |\n|--:|--:|--:|--:|--:|"
    )?;
    for Row { triangles, counts } in rows {
        let [short, long] = counts.map(|count| count as f64 * 1e-6);
        let each = counts.map(|count| count as f64 / *triangles as f64);
        writeln!(
            out,
            "| {triangles} | {short:.2} | {:.0} | {long:.2} | {:.0} |",
            each[0], each[1]
        )?;
    }
    let fitted = exponents(rows)?;
    let [short, long] = fitted;
    writeln!(
        out,
        "\nA build grows as the number of triangles to the power of **{short:.4}** with 30-bit codes and **{long:.4}** with \
         63-bit codes, fitted by least squares to the logarithms. It may be {LIMIT} at most."
    )?;
    Ok((out, fitted.iter().all(|it| *it <= LIMIT)))
}

/// The exponent for each of [`CODES`].
fn exponents(rows: &[Row]) -> Result<[f64; 2]> {
    let of = |code: usize| {
        let pairs = rows
            .iter()
            .map(|row| [row.triangles as f64, row.counts[code] as f64]);
        exponent(pairs).context("one size has no exponent")
    };
    Ok([of(0)?, of(1)?])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(powers: [i32; 2]) -> Vec<Row> {
        let row = |triangles: u64| Row {
            triangles,
            counts: powers.map(|power| 300 * triangles.pow(power as u32)),
        };
        [1_000, 4_000, 9_000].map(row).into()
    }

    #[test]
    fn what_grows_faster_is_found() {
        let options = Options::parse(["--growth".to_owned()].into_iter()).unwrap();
        let (text, is_within) = report(&rows([1, 1]), &options).unwrap();
        assert!(is_within, "{text}");
        assert!(
            text.contains("| 4000 | 1.20 | 300 | 1.20 | 300 |"),
            "{text}"
        );
        assert!(text.contains("**1.0000** with 30-bit"), "{text}");
        let (text, is_within) = report(&rows([1, 2]), &options).unwrap();
        assert!(!is_within, "{text}");
        assert!(text.contains("**2.0000** with 63-bit"), "{text}");
    }
}
