//! `gpu-lab table`: the rows of several builds side by side.

use crate::row::{Line, Row};
use anyhow::{Context, Result, ensure};
use slimbvh_lab::measure::rounds::median;
use std::fmt::Write;
use std::path::PathBuf;

/// What to put side by side.
#[derive(Debug, Default)]
pub struct TableTask {
    /// The folder to write to.
    pub folder: Option<PathBuf>,
    /// Lines above the table.
    pub facts: Vec<(String, String)>,
    /// What was not reached.
    pub missed: Vec<String>,
    /// Names of builds, with the files of their rows.
    pub inputs: Vec<(String, String)>,
}

impl TableTask {
    /// Prints the table, and writes it.
    pub fn run(&self) -> Result<()> {
        let mut columns = Vec::new();
        for (name, file) in &self.inputs {
            let text =
                std::fs::read_to_string(file).with_context(|| format!("cannot read {file:?}"))?;
            let lines = text.lines().map(str::parse);
            let lines: Vec<Line> = lines.collect::<Result<_>>().with_context(|| file.clone())?;
            columns.push((name.as_str(), lines));
        }
        let (text, adapter) = self.text(&columns)?;
        print!("{text}");
        if let Some(folder) = &self.folder {
            let path = folder.join(format!("gpu-lab-{}.md", slug(&adapter)));
            std::fs::write(&path, &text).with_context(|| format!("cannot write {path:?}"))?;
            eprintln!("written: {}", path.display());
        }
        Ok(())
    }

    /// The text, and the adapter's name.
    fn text(&self, columns: &[(&str, Vec<Line>)]) -> Result<(String, String)> {
        let lines = || columns.iter().flat_map(|(_, lines)| lines);
        let mut facts: Vec<(&str, &str)> = Vec::new();
        let own = self.facts.iter().map(|(name, value)| (&**name, &**value));
        let found = lines().filter_map(|line| match line {
            Line::Fact(name, value) => Some((&**name, &**value)),
            _ => None,
        });
        for fact in found.chain(own) {
            if !facts.contains(&fact) {
                facts.push(fact);
            }
        }
        let adapters = || facts.iter().filter(|(name, _)| *name == "adapter");
        ensure!(adapters().count() <= 1, "the rows are of several adapters");
        let adapter = adapters().next().map_or("none", |(_, value)| value);

        let mut out = String::new();
        writeln!(out, "# The laboratory on {adapter}\n")?;
        writeln!(out, "Made by `gpu-lab.sh` (see `bench/README.md`).\n")?;
        writeln!(out, "| | |\n|---|---|")?;
        for (name, value) in &facts {
            writeln!(out, "| {name} | {value} |")?;
        }
        let mut missed = self.missed.clone();
        let mut notes = Vec::new();
        for (name, lines) in columns {
            let of_step = |text: &str| match columns.len() {
                1 => text.to_owned(),
                _ => format!("{name}, {text}"),
            };
            for line in lines {
                match line {
                    Line::Missed(text) => missed.push(of_step(text)),
                    Line::Note(text) => notes.push(of_step(text)),
                    Line::Row(_) | Line::Fact(..) => {}
                }
            }
        }
        list(&mut out, "Not reached", &missed)?;
        list(&mut out, "Notes", &notes)?;
        rows(&mut out, columns)?;
        Ok((out, adapter.to_owned()))
    }
}

fn list(out: &mut String, title: &str, texts: &[String]) -> Result<()> {
    if !texts.is_empty() {
        writeln!(out, "\n{title}:\n")?;
    }
    for text in texts {
        writeln!(out, "- {text}")?;
    }
    Ok(())
}

/// The table: a row a result, a column a build. With several builds the last column has the last one's value in shares of the
/// first one's.
fn rows(out: &mut String, columns: &[(&str, Vec<Line>)]) -> Result<()> {
    let results = |lines: &[Line]| -> Vec<Row> {
        let rows = lines.iter().filter_map(|line| match line {
            Line::Row(row) => Some(row.clone()),
            _ => None,
        });
        rows.collect()
    };
    let results: Vec<Vec<Row>> = columns.iter().map(|(_, lines)| results(lines)).collect();
    let mut keys: Vec<[&str; 4]> = Vec::new();
    for row in results.iter().flatten() {
        if !keys.contains(&key(row)) {
            keys.push(key(row));
        }
    }
    let names: Vec<&str> = columns.iter().map(|(name, _)| *name).collect();
    let compared = names.len() > 1;
    write!(
        out,
        "\n| section | scene | what | unit | {} |",
        names.join(" | ")
    )?;
    let (first, last) = (names.first().unwrap_or(&""), names.last().unwrap_or(&""));
    writeln!(
        out,
        "{}",
        if compared {
            format!(" {last}/{first} |")
        } else {
            String::new()
        }
    )?;
    let numbers = names.len() + usize::from(compared);
    writeln!(out, "|---|---|---|---|{}", "--:|".repeat(numbers))?;
    let mut before = ["", ""];
    for key_of_row in keys {
        let [section, scene, what, unit] = key_of_row;
        let values = results.iter().map(|rows| {
            let same = rows.iter().filter(|row| key(row) == key_of_row);
            let mut values: Vec<f64> = same.map(|row| row.value).collect();
            (!values.is_empty()).then(|| median(&mut values))
        });
        let values: Vec<Option<f64>> = values.collect();
        // A section and a scene are named once.
        let shown = [
            if section == before[0] { "" } else { section },
            if [section, scene] == before {
                ""
            } else {
                scene
            },
        ];
        before = [section, scene];
        let mut cells: Vec<String> = values.iter().map(|value| cell(*value)).collect();
        if compared {
            let ratio = match (values[0], values[values.len() - 1]) {
                (Some(first), Some(last)) if first != 0.0 => format!("{:.2}", last / first),
                _ => "–".into(),
            };
            cells.push(ratio);
        }
        let [section, scene] = shown;
        writeln!(
            out,
            "| {section} | {scene} | {what} | {unit} | {} |",
            cells.join(" | ")
        )?;
    }
    Ok(())
}

/// What names a result.
fn key(row: &Row) -> [&str; 4] {
    [&row.section, &row.scene, &row.what, &row.unit].map(String::as_str)
}

/// A value with about four digits.
fn cell(value: Option<f64>) -> String {
    match value {
        None => "–".into(),
        Some(value) if value == value.trunc() && value.abs() < 1e6 => format!("{value}"),
        Some(value) if value.abs() >= 100.0 => format!("{value:.0}"),
        Some(value) if value.abs() >= 10.0 => format!("{value:.1}"),
        Some(value) if value.abs() >= 1.0 => format!("{value:.2}"),
        Some(value) => format!("{value:.4}"),
    }
}

/// An adapter's name as part of a file's name.
fn slug(adapter: &str) -> String {
    let mut slug = String::new();
    for c in adapter.to_lowercase().chars() {
        if c.is_ascii_alphanumeric() {
            slug.push(c);
        } else if !slug.ends_with('-') && !slug.is_empty() {
            slug.push('-');
        }
    }
    slug.trim_end_matches('-').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(text: &str) -> Vec<Line> {
        text.lines().map(|line| line.parse().unwrap()).collect()
    }

    #[test]
    fn builds_stand_side_by_side() {
        let base = "fact;adapter;A 1\nrow;rays;hills;eye;Mrays/s;100\nrow;rays;hills;eye;Mrays/s;300\nrow;rays;hills;eye;Mrays/s;200";
        let next = "fact;adapter;A 1\nrow;rays;hills;eye;Mrays/s;500\nrow;rays;hills;bounce;Mrays/s;7.125\nmissed;large: hills\nnote;all is well";
        let columns = [("base", lines(base)), ("next", lines(next))];
        let task = TableTask {
            missed: vec!["stress".into()],
            ..TableTask::default()
        };
        let (text, adapter) = task.text(&columns).unwrap();
        assert_eq!(adapter, "A 1");
        for part in [
            "| section | scene | what | unit | base | next | next/base |",
            "| rays | hills | eye | Mrays/s | 200 | 500 | 2.50 |",
            "|  |  | bounce | Mrays/s | – | 7.12 | – |",
            "- stress\n- next, large: hills",
            "- next, all is well",
        ] {
            assert!(text.contains(part), "{part} is not in\n{text}");
        }
        let other = [
            ("base", lines("fact;adapter;A 1")),
            ("next", lines("fact;adapter;B")),
        ];
        assert!(task.text(&other).is_err());
    }

    #[test]
    fn names_of_files() {
        assert_eq!(
            slug("llvmpipe (LLVM 15.0.6, 256 bits)"),
            "llvmpipe-llvm-15-0-6-256-bits"
        );
        assert_eq!(slug("NVIDIA H200"), "nvidia-h200");
    }
}
