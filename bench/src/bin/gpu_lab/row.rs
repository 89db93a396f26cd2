//! What a section prints: a line for each result.

use anyhow::{Context, Result, bail};
use std::fmt;
use std::str::FromStr;

/// A line of a section's output. Fields are separated by semicolons, which no text contains.
#[derive(Clone, Debug, PartialEq)]
pub enum Line {
    /// A result.
    Row(Row),
    /// A fact of the run: its name, its value.
    Fact(String, String),
    /// A sentence about the results.
    Note(String),
    /// What was not reached.
    Missed(String),
}

/// A result. All but the value name it.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The section.
    pub section: String,
    /// The scene.
    pub scene: String,
    /// What was measured.
    pub what: String,
    /// The value's unit.
    pub unit: String,
    /// The value.
    pub value: f64,
}

impl fmt::Display for Line {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Row(row) => {
                let Row {
                    section,
                    scene,
                    what,
                    unit,
                    value,
                } = row;
                write!(to, "row;{section};{scene};{what};{unit};{value}")
            }
            Self::Fact(name, value) => write!(to, "fact;{name};{value}"),
            Self::Note(text) => write!(to, "note;{text}"),
            Self::Missed(text) => write!(to, "missed;{text}"),
        }
    }
}

impl FromStr for Line {
    type Err = anyhow::Error;

    fn from_str(line: &str) -> Result<Self> {
        let fields: Vec<&str> = line.split(';').collect();
        Ok(match fields[..] {
            ["row", section, scene, what, unit, value] => Self::Row(Row {
                section: section.into(),
                scene: scene.into(),
                what: what.into(),
                unit: unit.into(),
                value: value
                    .parse()
                    .with_context(|| format!("{value:?} is no number"))?,
            }),
            ["fact", name, value] => Self::Fact(name.into(), value.into()),
            ["note", text] => Self::Note(text.into()),
            ["missed", text] => Self::Missed(text.into()),
            _ => bail!("{line:?} is no line of a section"),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_read_as_they_were_written() {
        let row = Row {
            section: "rays".into(),
            scene: "terrain, 871,200 triangles".into(),
            what: "plain, eye".into(),
            unit: "Mrays/s".into(),
            value: 1712.25,
        };
        let lines = [
            Line::Row(row),
            Line::Fact("adapter".into(), "llvmpipe (LLVM 15, 256 bits)".into()),
            Line::Note("all is well".into()),
            Line::Missed("large".into()),
        ];
        for line in lines {
            assert_eq!(line.to_string().parse::<Line>().unwrap(), line);
        }
        assert!("row;rays;terrain;eye;ms".parse::<Line>().is_err());
        assert!("row;rays;terrain;eye;ms;x".parse::<Line>().is_err());
        assert!("".parse::<Line>().is_err());
    }
}
