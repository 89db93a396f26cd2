//! The rows of a PLY file, number by number.

use super::super::error::excerpt;
use super::{PropertyType, ScalarType};
use ply_rs_bw::ply::Encoding;

/// The position of the reader.
pub(super) struct Rows<'a> {
    /// The unread bytes; for text, those after the current line.
    rest: &'a [u8],
    form: Form<'a>,
}

enum Form<'a> {
    Text(TextRow<'a>),
    Bytes { big_endian: bool },
}

/// The rest of the current line.
struct TextRow<'a> {
    /// Counted from 1.
    line: usize,
    rest: &'a [u8],
    /// The number of numbers read.
    found: u64,
    /// The number of numbers required, for messages.
    needed: u64,
}

/// Why a number cannot be read.
pub(super) enum Fault {
    /// The file ends.
    End,
    /// The line ends.
    TooFew {
        line: usize,
        needed: u64,
        found: u64,
    },
    /// A word in place of the expected number.
    Word {
        line: usize,
        text: String,
        expected: &'static str,
    },
    /// A binary number out of its range.
    Value { value: f64, expected: &'static str },
}

impl<'a> Rows<'a> {
    /// The rows after the header; the first is at the given line.
    pub fn new(rest: &'a [u8], encoding: &Encoding, first_line: usize) -> Self {
        let form = match encoding {
            Encoding::Ascii => Form::Text(TextRow {
                line: first_line.saturating_sub(1),
                rest: &[],
                found: 0,
                needed: 0,
            }),
            Encoding::BinaryBigEndian => Form::Bytes { big_endian: true },
            Encoding::BinaryLittleEndian => Form::Bytes { big_endian: false },
        };
        Self { rest, form }
    }

    /// Whether rows are text.
    pub const fn is_text(&self) -> bool {
        matches!(self.form, Form::Text(_))
    }

    /// The number of bytes left.
    pub fn byte_count(&self) -> usize {
        self.rest.len()
    }

    /// The current row's line, if rows are text.
    pub fn line(&self) -> Option<usize> {
        match &self.form {
            Form::Text(row) => Some(row.line),
            Form::Bytes { .. } => None,
        }
    }

    /// Starts a row of at least `needed` numbers: for text, at the next line that is not blank.
    pub fn start(&mut self, needed: usize) -> Result<(), Fault> {
        let Form::Text(row) = &mut self.form else {
            return Ok(());
        };
        loop {
            if self.rest.is_empty() {
                return Err(Fault::End);
            }
            let end = self.rest.iter().position(|&byte| byte == b'\n');
            let (line, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
            self.rest = rest.get(1..).unwrap_or_default();
            row.line += 1;
            row.rest = line.trim_ascii();
            if !row.rest.is_empty() {
                break;
            }
        }
        (row.found, row.needed) = (0, needed as u64);
        Ok(())
    }

    /// The next number, of the kind that the header declares. Text is read as `f64`, whatever that is.
    #[inline]
    pub fn number(&mut self, kind: &ScalarType) -> Result<f64, Fault> {
        match &mut self.form {
            Form::Text(row) => row.number(),
            Form::Bytes { big_endian } => {
                let big_endian = *big_endian;
                self.binary(kind, big_endian)
            }
        }
    }

    /// The next list of indices.
    pub fn indices(
        &mut self,
        count: &ScalarType,
        kind: &ScalarType,
        indices: &mut Vec<i64>,
    ) -> Result<(), Fault> {
        indices.clear();
        for _ in 0..self.list_length(count)? {
            let index = self.number(kind)?;
            if index.fract() != 0.0 {
                return Err(self.unexpected(index, "an index"));
            }
            indices.push(index as i64);
        }
        Ok(())
    }

    /// Skips a property.
    pub fn skip(&mut self, data_type: &PropertyType) -> Result<(), Fault> {
        match data_type {
            PropertyType::Scalar(kind) => {
                self.number(kind)?;
            }
            PropertyType::List(count, kind) => {
                for _ in 0..self.list_length(count)? {
                    self.number(kind)?;
                }
            }
        }
        Ok(())
    }

    fn list_length(&mut self, kind: &ScalarType) -> Result<u64, Fault> {
        let length = self.number(kind)?;
        if !(length >= 0.0 && length.fract() == 0.0) {
            return Err(self.unexpected(length, "a count"));
        }
        if let Form::Text(row) = &mut self.form {
            row.needed = row.needed.saturating_add(length as u64);
        }
        Ok(length as u64)
    }

    fn unexpected(&self, value: f64, expected: &'static str) -> Fault {
        match self.line() {
            Some(line) => Fault::Word {
                line,
                text: value.to_string(),
                expected,
            },
            None => Fault::Value { value, expected },
        }
    }

    fn binary(&mut self, kind: &ScalarType, big_endian: bool) -> Result<f64, Fault> {
        Ok(match kind {
            ScalarType::Char => f64::from(i8::from_le_bytes(self.take(big_endian)?)),
            ScalarType::UChar => f64::from(u8::from_le_bytes(self.take(big_endian)?)),
            ScalarType::Short => f64::from(i16::from_le_bytes(self.take(big_endian)?)),
            ScalarType::UShort => f64::from(u16::from_le_bytes(self.take(big_endian)?)),
            ScalarType::Int => f64::from(i32::from_le_bytes(self.take(big_endian)?)),
            ScalarType::UInt => f64::from(u32::from_le_bytes(self.take(big_endian)?)),
            ScalarType::Float => f64::from(f32::from_le_bytes(self.take(big_endian)?)),
            ScalarType::Double => f64::from_le_bytes(self.take(big_endian)?),
        })
    }

    /// The next bytes, the least significant first.
    #[inline]
    fn take<const N: usize>(&mut self, big_endian: bool) -> Result<[u8; N], Fault> {
        let (bytes, rest) = self.rest.split_first_chunk().ok_or(Fault::End)?;
        self.rest = rest;
        let mut bytes: [u8; N] = *bytes;
        if big_endian {
            bytes.reverse();
        }
        Ok(bytes)
    }
}

impl TextRow<'_> {
    fn number(&mut self) -> Result<f64, Fault> {
        if self.rest.is_empty() {
            return Err(Fault::TooFew {
                line: self.line,
                needed: self.needed,
                found: self.found,
            });
        }
        let end = self.rest.iter().position(u8::is_ascii_whitespace);
        let (word, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        self.rest = rest.trim_ascii_start();
        self.found += 1;

        let text = std::str::from_utf8(word).ok();
        let number = text.and_then(|text| text.parse().ok());
        number.ok_or_else(|| Fault::Word {
            line: self.line,
            text: excerpt(&String::from_utf8_lossy(word)),
            expected: "a number",
        })
    }
}
