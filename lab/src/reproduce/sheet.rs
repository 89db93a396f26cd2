//! The layout of a report as text and as Markdown.

use super::verdicts::Verdict;
use crate::measure::table::{Table, wrap};
use std::fmt::Write;

/// The contents of a report.
pub struct Sheet<'a> {
    pub title: &'static str,
    pub paper: &'static str,
    /// The facts needed to read the tables, by name.
    pub head: Vec<(&'a str, String)>,
    /// The scope of the targets.
    pub scope: &'static str,
    pub verdicts: &'a [Verdict],
    pub tables: Vec<Table>,
}

impl Sheet<'_> {
    /// The report as text.
    pub fn text(&self) -> String {
        let mut text = format!("{}\n{}\n", self.title, self.paper);
        for (name, value) in &self.head {
            let mut value_text = String::new();
            wrap(&mut value_text, value, 88);
            for (i, line) in value_text.lines().enumerate() {
                let name = if i == 0 { name } else { "" };
                let _ = writeln!(text, "{name:<10} {line}");
            }
        }
        for table in &self.tables {
            let _ = write!(text, "\n{}", table.text());
        }
        let _ = writeln!(text, "\nTargets, {}", self.scope);
        for verdict in self.verdicts {
            let _ = writeln!(text, "  {}", verdict.line());
        }
        text
    }

    /// The report as Markdown.
    pub fn markdown(&self) -> String {
        let Self { title, paper, .. } = self;
        let mut text = format!("# {title}\n\n{paper}.\n\n| | |\n|---|---|\n");
        for (name, value) in &self.head {
            let _ = writeln!(text, "| {name} | {value} |");
        }
        let mut scope = self.scope.to_owned();
        if let Some(first) = scope.get_mut(..1) {
            first.make_ascii_uppercase();
        }
        let _ = writeln!(text, "\n## Targets\n\n{scope}.\n");
        for verdict in self.verdicts {
            let _ = writeln!(text, "- {}", verdict.line());
        }
        for table in &self.tables {
            let _ = write!(text, "\n{}", table.markdown());
        }
        text
    }
}
