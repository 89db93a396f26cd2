//! The record of shaders, and its comparison with what is compiled now.

use anyhow::{Context, Error, Result, bail};
use std::fmt::{Display, Formatter};
use std::str::FromStr;

/// The largest allowed growth of a module's instructions, as a share.
const SLACK: f64 = 0.01;

/// The second line of a record.
const COLUMNS: &str = "module;instructions;vgprs;scratch_bytes;workgroup_bytes";

/// The counts of a module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// The module's name.
    pub module: String,
    /// Instructions in its code.
    pub instructions: u64,
    /// Vector registers of a thread.
    pub vgprs: u64,
    /// Scratch memory of a thread, in bytes: private arrays and spilled registers.
    pub scratch_bytes: u64,
    /// Workgroup memory, in bytes.
    pub workgroup_bytes: u64,
}

impl Row {
    fn counts(&self) -> [u64; 4] {
        [
            self.instructions,
            self.vgprs,
            self.scratch_bytes,
            self.workgroup_bytes,
        ]
    }
}

impl Display for Row {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{}", self.module)?;
        for count in self.counts() {
            write!(formatter, ";{count}")?;
        }
        Ok(())
    }
}

impl FromStr for Row {
    type Err = Error;

    fn from_str(line: &str) -> Result<Self> {
        let mut words = line.split(';');
        let module = words.next().unwrap_or_default().to_owned();
        let counts: Result<Vec<u64>, _> = words.map(str::parse).collect();
        let counts = counts.with_context(|| format!("numbers are expected in {line:?}"))?;
        let &[instructions, vgprs, scratch_bytes, workgroup_bytes] = counts.as_slice() else {
            bail!("{COLUMNS:?} is expected, not {line:?}");
        };
        Ok(Self {
            module,
            instructions,
            vgprs,
            scratch_bytes,
            workgroup_bytes,
        })
    }
}

/// The counts of all modules.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Record {
    /// The compiler's name and version and the GPU it compiled for.
    pub compiler: String,
    /// Rows in the order of their modules' names.
    pub rows: Vec<Row>,
}

impl Display for Record {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> std::fmt::Result {
        writeln!(formatter, "# {}\n{COLUMNS}", self.compiler)?;
        self.rows
            .iter()
            .try_for_each(|row| writeln!(formatter, "{row}"))
    }
}

impl FromStr for Record {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let mut lines = text.lines();
        let compiler = lines.next().and_then(|line| line.strip_prefix("# "));
        let compiler = compiler.context("the compiler comes first")?.to_owned();
        let columns = lines.next().unwrap_or_default();
        if columns != COLUMNS {
            bail!("{COLUMNS:?} is expected, not {columns:?}");
        }
        let rows = lines.map(str::parse).collect::<Result<_>>()?;
        Ok(Self { compiler, rows })
    }
}

/// A module that is not as the record has it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Difference {
    /// More scratch memory or registers, or over 1 % more instructions.
    Worse(Row, Row),
    /// Any other difference.
    Other(Row, Row),
    /// A module that the record lacks.
    New(Row),
    /// A module that is gone.
    Gone(Row),
}

impl Display for Difference {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::New(row) => write!(formatter, "{}: not on record", row.module),
            Self::Gone(row) => write!(formatter, "{}: on record only", row.module),
            Self::Worse(before, now) | Self::Other(before, now) => {
                write!(formatter, "{}:", before.module)?;
                let names = COLUMNS.split(';').skip(1);
                for ((name, before), now) in names.zip(before.counts()).zip(now.counts()) {
                    if before != now {
                        write!(formatter, " {name} {before} -> {now}")?;
                    }
                }
                let is_worse = matches!(self, Self::Worse(..));
                formatter.write_str(if is_worse { " WORSE" } else { "" })
            }
        }
    }
}

impl Record {
    /// All differences of `now` from this record.
    pub fn compare(&self, now: &Self) -> Vec<Difference> {
        let find = |record: &Self, module: &str| {
            let mut rows = record.rows.iter();
            rows.find(|row| row.module == module).cloned()
        };
        let mut differences = Vec::new();
        for before in &self.rows {
            match find(now, &before.module) {
                None => differences.push(Difference::Gone(before.clone())),
                Some(now) if now == *before => {}
                Some(now) if is_worse(before, &now) => {
                    differences.push(Difference::Worse(before.clone(), now));
                }
                Some(now) => differences.push(Difference::Other(before.clone(), now)),
            }
        }
        let new = now
            .rows
            .iter()
            .filter(|row| find(self, &row.module).is_none());
        differences.extend(new.cloned().map(Difference::New));
        differences
    }
}

fn is_worse(before: &Row, now: &Row) -> bool {
    let grows = now.instructions as f64 > before.instructions as f64 * (1.0 + SLACK);
    grows || now.vgprs > before.vgprs || now.scratch_bytes > before.scratch_bytes
}

/// What the differences mean, if there are any.
pub fn verdict(differences: &[Difference]) -> Option<&'static str> {
    if differences.is_empty() {
        None
    } else if differences
        .iter()
        .any(|difference| matches!(difference, Difference::Worse(..)))
    {
        Some("WORSE: more scratch memory or registers, or over 1 % more instructions")
    } else {
        Some("the record is out of date: where this is meant, --write renews it")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(module: &str, counts: [u64; 4]) -> Row {
        let [instructions, vgprs, scratch_bytes, workgroup_bytes] = counts;
        Row {
            module: module.to_owned(),
            instructions,
            vgprs,
            scratch_bytes,
            workgroup_bytes,
        }
    }

    /// The differences of a module with these counts from one of 1000 instructions, 24 registers, 8 bytes of scratch and 512
    /// bytes of workgroup memory.
    fn differences(counts: [u64; 4]) -> Vec<Difference> {
        let record = |row| Record {
            compiler: "radv".into(),
            rows: vec![row],
        };
        record(row("a", [1000, 24, 8, 512])).compare(&record(row("a", counts)))
    }

    #[test]
    fn the_same_counts_are_no_difference() {
        assert_eq!(differences([1000, 24, 8, 512]), []);
        assert_eq!(verdict(&[]), None);
    }

    #[test]
    fn more_than_allowed_is_worse() {
        for counts in [
            [1011, 24, 8, 512],
            [1000, 32, 8, 512],
            [1000, 24, 12, 512],
            [500, 32, 0, 512],
            [500, 16, 12, 0],
        ] {
            let found = differences(counts);
            assert!(matches!(found[..], [Difference::Worse(..)]), "{counts:?}");
            assert!(found[0].to_string().ends_with("WORSE"), "{counts:?}");
            assert!(verdict(&found).is_some_and(|text| text.starts_with("WORSE")));
        }
    }

    #[test]
    fn anything_else_asks_for_a_new_record() {
        for counts in [
            [1010, 24, 8, 512],
            [999, 24, 8, 512],
            [1000, 16, 8, 512],
            [1000, 24, 0, 512],
            [1000, 24, 8, 1024],
        ] {
            let found = differences(counts);
            assert!(matches!(found[..], [Difference::Other(..)]), "{counts:?}");
            assert!(verdict(&found).is_some_and(|text| text.contains("--write")));
        }
        let found = differences([999, 16, 8, 512]);
        assert_eq!(
            found[0].to_string(),
            "a: instructions 1000 -> 999 vgprs 24 -> 16"
        );
    }

    #[test]
    fn new_and_removed_modules_ask_for_a_new_record() {
        let record = |module| Record {
            compiler: "radv".into(),
            rows: vec![row(module, [1, 2, 3, 4])],
        };
        let found = record("a").compare(&record("b"));
        assert!(matches!(
            found[..],
            [Difference::Gone(_), Difference::New(_)]
        ));
        assert!(verdict(&found).is_some_and(|text| text.contains("--write")));
    }

    #[test]
    fn a_record_is_read_as_it_was_written() {
        let record = Record {
            compiler: "radv, Mesa 1.2".into(),
            rows: vec![row("a", [1, 2, 3, 4]), row("b", [5, 6, 7, 8])],
        };
        let text = record.to_string();
        assert_eq!(text.parse::<Record>().expect("a record"), record);
        for wrong in [
            text.replace("# ", ""),
            text.replace("vgprs", "sgprs"),
            text.replace("a;1;2;3;4", "a;1;2;3"),
            text.replace("a;1;2;3;4", "a;1;2;3;x"),
        ] {
            assert!(wrong.parse::<Record>().is_err(), "{wrong}");
        }
    }
}
