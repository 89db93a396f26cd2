//! Tables as text and as Markdown.

use std::fmt::Write;

/// A table, with the notes needed to read it.
pub struct Table {
    pub title: String,
    /// Paragraphs before the table.
    pub notes: Vec<String>,
    /// The number of columns with words, which come first; the others hold figures.
    pub word_columns: usize,
    pub head: Vec<&'static str>,
    pub rows: Vec<Vec<String>>,
}

/// The width of a line of text in characters.
const LINE_WIDTH: usize = 100;

impl Table {
    /// The table as text.
    pub fn text(&self) -> String {
        let mut text = format!("{}\n", self.title);
        for note in &self.notes {
            wrap(&mut text, note, LINE_WIDTH);
        }
        let length = |cell: &str| cell.chars().count();
        let width = |column: usize| {
            let cells = self.rows.iter().filter_map(|row| row.get(column));
            let cells = cells.map(|cell| length(cell));
            cells.chain([length(self.head[column])]).max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..self.head.len()).map(width).collect();
        let mut line = |cells: &[&str]| {
            let mut line = String::new();
            for (column, (cell, &width)) in cells.iter().zip(&widths).enumerate() {
                let gap = if column == 0 { "" } else { "  " };
                let space = " ".repeat(width - length(cell));
                line += &if column < self.word_columns {
                    format!("{gap}{cell}{space}")
                } else {
                    format!("{gap}{space}{cell}")
                };
            }
            // Writing to a string cannot fail.
            let _ = writeln!(text, "  {}", line.trim_end());
        };
        line(&self.head);
        for row in &self.rows {
            line(&row.iter().map(String::as_str).collect::<Vec<_>>());
        }
        text
    }

    /// The table as Markdown.
    pub fn markdown(&self) -> String {
        let mut text = format!("## {}\n\n", self.title);
        for note in &self.notes {
            wrap(&mut text, note, 120);
        }
        if !self.notes.is_empty() {
            text.push('\n');
        }
        let words = "---|".repeat(self.word_columns);
        let figures = "--:|".repeat(self.head.len() - self.word_columns);
        let _ = writeln!(text, "| {} |\n|{words}{figures}", self.head.join(" | "));
        for row in &self.rows {
            let _ = writeln!(text, "| {} |", row.join(" | "));
        }
        text
    }
}

/// Appends a paragraph, broken into lines.
pub fn wrap(text: &mut String, paragraph: &str, width: usize) {
    let mut length = 0;
    for word in paragraph.split_whitespace() {
        let word_length = word.chars().count();
        if length > 0 && length + 1 + word_length > width {
            text.push('\n');
            length = 0;
        } else if length > 0 {
            text.push(' ');
            length += 1;
        }
        text.push_str(word);
        length += word_length;
    }
    text.push('\n');
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table() -> Table {
        Table {
            title: "T".into(),
            notes: vec!["What is what.".into()],
            word_columns: 1,
            head: vec!["scene", "ms"],
            rows: vec![
                vec!["doll".into(), "18.7".into()],
                vec!["ä".into(), "1".into()],
            ],
        }
    }

    #[test]
    fn columns_are_aligned() {
        let expected = "T\nWhat is what.\n  scene    ms\n  doll   18.7\n  ä         1\n";
        assert_eq!(table().text(), expected);
    }

    #[test]
    fn markdown_has_a_rule_below_the_head() {
        let expected =
            "## T\n\nWhat is what.\n\n| scene | ms |\n|---|--:|\n| doll | 18.7 |\n| ä | 1 |\n";
        assert_eq!(table().markdown(), expected);
    }

    #[test]
    fn paragraphs_are_broken_between_words() {
        let mut text = String::new();
        wrap(&mut text, "one two  three four", 9);
        assert_eq!(text, "one two\nthree\nfour\n");
    }
}
