//! The table: one row for each peer and family, with all magnitudes added up.

use slimbvh_lab::stress::{BOUND_ULPS, Row};
use std::fmt::Write;

const HEAD: [&str; 9] = [
    "family", "peer", "scenes", "rays", "missed", "false", "wrong", "adrift", "failures",
];

/// Columns of words come first, then figures.
const WORD_COLUMNS: usize = 2;

/// The sum of a family's rows of one peer.
struct Line<'a> {
    family: &'a str,
    peer: &'a str,
    scenes: usize,
    sum: Row,
    /// Failures by word, each with the magnitudes where it occurred.
    failures: Vec<(&'a str, Vec<&'a str>)>,
}

/// The table as text.
pub fn text(rows: &[Row]) -> String {
    let mut text = format!(
        "Peers on rays that break tracers, against exact answers\n\
         A ray that passes farther than {BOUND_ULPS} ulps of the largest coordinate of its origin and the triangle from every border and\n\
         silhouette must meet what the exact ray meets. Wrong: something behind it is reported. Adrift, no fault: t is off by\n\
         more than the bound. What a peer fails to answer counts as a miss.\n\n"
    );
    let lines = lines(rows);
    let cells: Vec<[String; HEAD.len()]> = lines.iter().map(cells).collect();
    let head = HEAD.map(str::to_owned);
    let all = || std::iter::once(&head).chain(&cells);
    let width = |column: usize| all().map(|row| row[column].chars().count()).max();
    let widths: Vec<usize> = (0..HEAD.len()).filter_map(width).collect();
    for row in all() {
        let mut line = String::new();
        for (column, (cell, width)) in row.iter().zip(&widths).enumerate() {
            line += &if column < WORD_COLUMNS || column + 1 == HEAD.len() {
                format!("  {cell:<width$}")
            } else {
                format!("  {cell:>width$}")
            };
        }
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{}", line.trim_end());
    }
    text
}

fn cells(line: &Line<'_>) -> [String; HEAD.len()] {
    let sum = &line.sum;
    let failure =
        |(word, magnitudes): &(&str, Vec<&str>)| format!("{word} at {}", magnitudes.join(", "));
    let failures: Vec<String> = line.failures.iter().map(failure).collect();
    [
        line.family.to_owned(),
        line.peer.to_owned(),
        line.scenes.to_string(),
        sum.rays.to_string(),
        sum.missed.to_string(),
        sum.false_hits.to_string(),
        sum.wrong_primitive.to_string(),
        sum.adrift.to_string(),
        failures.join("; "),
    ]
}

fn lines(rows: &[Row]) -> Vec<Line<'_>> {
    let mut lines: Vec<Line> = Vec::new();
    for row in rows {
        let is_own = |line: &Line| line.family == row.family && line.peer == row.tracer;
        let place = lines.iter().position(is_own).unwrap_or_else(|| {
            lines.push(Line {
                family: &row.family,
                peer: &row.tracer,
                scenes: 0,
                sum: Row::default(),
                failures: Vec::new(),
            });
            lines.len() - 1
        });
        let line = &mut lines[place];
        line.scenes += 1;
        line.sum.add(row);
        let word = row.codec.as_str();
        if FAILURES.contains(&word) {
            match line.failures.iter_mut().find(|(own, _)| *own == word) {
                Some((_, magnitudes)) => magnitudes.push(&row.magnitude),
                None => line.failures.push((word, vec![&row.magnitude])),
            }
        }
    }
    lines
}

/// The word in place of a tree's name, if the peer failed.
const FAILURES: [&str; 4] = ["refused", "panicked", "hung", "died"];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_added_up_and_failures_are_named() {
        let row = |magnitude: &str, codec: &str| Row {
            tracer: "peer".into(),
            family: "scaled".into(),
            magnitude: magnitude.into(),
            codec: codec.into(),
            rays: 600,
            missed: 7,
            ..Row::default()
        };
        let text = text(&[row("1e3", "tree"), row("1e20", "hung"), row("1e30", "hung")]);
        let last: Vec<&str> = text.lines().last().unwrap().split_whitespace().collect();
        let expected = [
            "scaled", "peer", "3", "1800", "21", "0", "0", "0", "hung", "at", "1e20,", "1e30",
        ];
        assert_eq!(last, expected);
    }
}
