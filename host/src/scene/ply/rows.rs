//! The rows of a PLY file, number by number.

use super::super::error::excerpt;
use super::super::words::{self, Lines, Words};
use super::header::{Encoding, Kind, Scalar};

/// The position of the reader.
#[derive(Clone)]
pub(super) struct Rows<'a> {
    form: Form<'a>,
}

/// What separates rows of text.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum RowsIn {
    /// Each row is a line.
    Lines,
    /// A row may take several lines, and a line several rows.
    Words,
    /// Each row is a line, and a broken one can be dropped.
    SoundLines,
}

/// What belongs to no row.
#[derive(Default, PartialEq, Eq)]
pub(super) struct Spare {
    /// The number of rows with further words.
    pub rows: usize,
    /// The number of lines behind the last row.
    pub lines: usize,
    /// The number of bytes behind the last row, where rows are binary.
    pub bytes: usize,
}

impl Spare {
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }
}

#[derive(Clone)]
enum Form<'a> {
    Text(Text<'a>),
    Bytes { rest: &'a [u8], big_endian: bool },
}

#[derive(Clone)]
struct Text<'a> {
    lines: Lines<'a>,
    rows_in: RowsIn,
    /// The current line's number, and the rest of it.
    line: usize,
    words: Words<'a>,
    /// The number of numbers read of the row.
    found: u64,
    /// The number of numbers required, for messages.
    needed: u64,
    /// The number of lines with more words than their row.
    spare_count: usize,
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
    /// The rows behind the header; the first is at the given line.
    pub fn new(rest: &'a [u8], encoding: Encoding, first_line: usize, rows_in: RowsIn) -> Self {
        let form = match encoding {
            Encoding::Text => Form::Text(Text {
                lines: Lines::from(rest, first_line),
                rows_in,
                line: first_line,
                words: Words::new(&[]),
                found: 0,
                needed: 0,
                spare_count: 0,
            }),
            encoding => Form::Bytes {
                rest,
                big_endian: encoding == Encoding::BigEndian,
            },
        };
        Self { form }
    }

    /// The number of bytes left.
    pub const fn byte_count(&self) -> usize {
        match &self.form {
            Form::Text(text) => text.lines.rest().len(),
            Form::Bytes { rest, .. } => rest.len(),
        }
    }

    /// The current line, if rows are text.
    pub const fn line(&self) -> Option<usize> {
        match &self.form {
            Form::Text(text) => Some(text.line),
            Form::Bytes { .. } => None,
        }
    }

    /// Starts a row of at least `needed` numbers.
    #[inline]
    pub fn start(&mut self, needed: usize) -> Result<(), Fault> {
        match &mut self.form {
            Form::Text(text) => text.start(needed),
            Form::Bytes { .. } => Ok(()),
        }
    }

    /// What belongs to no row, once all are read.
    pub fn spare(&self) -> Spare {
        match &self.form {
            Form::Text(text) => {
                let lines = text.lines.clone();
                let is_blank = |line| Words::new(line).is_empty();
                Spare {
                    rows: text.spare_count + usize::from(!text.words.is_empty()),
                    lines: lines.filter(|(_, line)| !is_blank(line)).count(),
                    bytes: 0,
                }
            }
            Form::Bytes { rest, .. } => Spare {
                bytes: rest.len(),
                ..Spare::default()
            },
        }
    }

    /// Drops the rest of a broken row, if that can be told from the next one.
    pub fn drop_row(&mut self, fault: &Fault) -> bool {
        match (&mut self.form, fault) {
            (Form::Text(text), Fault::TooFew { .. } | Fault::Word { .. })
                if text.rows_in == RowsIn::SoundLines =>
            {
                text.words = Words::new(&[]);
                true
            }
            _ => false,
        }
    }

    /// The next number, of the kind that the header declares. Text is read as `f64`, whatever that is.
    #[inline]
    pub fn number(&mut self, kind: Scalar) -> Result<f64, Fault> {
        match &mut self.form {
            Form::Text(text) => text.number(),
            Form::Bytes { rest, big_endian } => binary(rest, kind, *big_endian),
        }
    }

    /// The next number, which must be whole.
    #[inline]
    fn whole(&mut self, kind: Scalar, expected: &'static str) -> Result<i64, Fault> {
        let number = match &mut self.form {
            Form::Text(text) => {
                let word = text.word()?;
                match words::whole(word) {
                    Some(whole) => return Ok(whole),
                    None => words::number(word).ok_or_else(|| text.no_number(word))?,
                }
            }
            Form::Bytes { rest, big_endian } => binary(rest, kind, *big_endian)?,
        };
        match number.fract() == 0.0 {
            true => Ok(number as i64),
            false => Err(self.unexpected(number, expected)),
        }
    }

    /// The next list of indices.
    pub fn indices(
        &mut self,
        count: Scalar,
        item: Scalar,
        indices: &mut Vec<i64>,
    ) -> Result<(), Fault> {
        indices.clear();
        let length = self.list_length(count)?;
        // Most binary files have indices of four bytes: all of a list at once.
        if let Form::Bytes { rest, big_endian } = &mut self.form
            && matches!(item, Scalar::I32 | Scalar::U32)
        {
            let bytes = usize::try_from(length.saturating_mul(4)).unwrap_or(usize::MAX);
            let (list, behind) = rest.split_at_checked(bytes).ok_or(Fault::End)?;
            *rest = behind;
            let read = match *big_endian {
                true => u32::from_be_bytes,
                false => u32::from_le_bytes,
            };
            let words = list.as_chunks().0.iter().map(|&word| read(word));
            match item {
                Scalar::I32 => indices.extend(words.map(|word| i64::from(word as i32))),
                _ => indices.extend(words.map(i64::from)),
            }
            return Ok(());
        }
        for _ in 0..length {
            indices.push(self.whole(item, "an index")?);
        }
        Ok(())
    }

    /// Skips a property.
    pub fn skip(&mut self, kind: Kind) -> Result<(), Fault> {
        match kind {
            Kind::Scalar(scalar) => {
                self.number(scalar)?;
            }
            Kind::List { count, item } => {
                for _ in 0..self.list_length(count)? {
                    self.number(item)?;
                }
            }
        }
        Ok(())
    }

    fn list_length(&mut self, kind: Scalar) -> Result<u64, Fault> {
        let length = self.whole(kind, "a count")?;
        let Ok(length) = u64::try_from(length) else {
            return Err(self.unexpected(length as f64, "a count"));
        };
        if let Form::Text(text) = &mut self.form {
            text.needed = text.needed.saturating_add(length);
        }
        Ok(length)
    }

    pub fn unexpected(&self, value: f64, expected: &'static str) -> Fault {
        match self.line() {
            Some(line) => Fault::Word {
                line,
                text: crate::text::number(value),
                expected,
            },
            None => Fault::Value { value, expected },
        }
    }
}

#[inline]
fn binary(rest: &mut &[u8], kind: Scalar, big_endian: bool) -> Result<f64, Fault> {
    Ok(match kind {
        Scalar::I8 => f64::from(i8::from_le_bytes(take(rest, big_endian)?)),
        Scalar::U8 => f64::from(u8::from_le_bytes(take(rest, big_endian)?)),
        Scalar::I16 => f64::from(i16::from_le_bytes(take(rest, big_endian)?)),
        Scalar::U16 => f64::from(u16::from_le_bytes(take(rest, big_endian)?)),
        Scalar::I32 => f64::from(i32::from_le_bytes(take(rest, big_endian)?)),
        Scalar::U32 => f64::from(u32::from_le_bytes(take(rest, big_endian)?)),
        Scalar::I64 => i64::from_le_bytes(take(rest, big_endian)?) as f64,
        Scalar::U64 => u64::from_le_bytes(take(rest, big_endian)?) as f64,
        Scalar::F32 => f64::from(f32::from_le_bytes(take(rest, big_endian)?)),
        Scalar::F64 => f64::from_le_bytes(take(rest, big_endian)?),
    })
}

/// The next bytes, the least significant first.
#[inline]
fn take<const N: usize>(rest: &mut &[u8], big_endian: bool) -> Result<[u8; N], Fault> {
    let (bytes, behind) = rest.split_first_chunk().ok_or(Fault::End)?;
    *rest = behind;
    let mut bytes: [u8; N] = *bytes;
    if big_endian {
        bytes.reverse();
    }
    Ok(bytes)
}

impl<'a> Text<'a> {
    fn start(&mut self, needed: usize) -> Result<(), Fault> {
        (self.found, self.needed) = (0, needed as u64);
        if self.rows_in == RowsIn::Words {
            return Ok(());
        }
        self.spare_count += usize::from(!self.words.is_empty());
        // The next line that is not blank.
        loop {
            let (line, text) = self.lines.next().ok_or(Fault::End)?;
            (self.line, self.words) = (line, Words::new(text));
            if !self.words.is_empty() {
                return Ok(());
            }
        }
    }

    /// The next word, of this line or a later one.
    fn next_word(&mut self) -> Option<&'a [u8]> {
        loop {
            if let Some(word) = self.words.next() {
                return Some(word);
            }
            let (line, text) = self.lines.next()?;
            (self.line, self.words) = (line, Words::new(text));
        }
    }

    #[inline]
    fn number(&mut self) -> Result<f64, Fault> {
        let word = self.word()?;
        words::number(word).ok_or_else(|| self.no_number(word))
    }

    /// The next word of the row.
    #[inline]
    fn word(&mut self) -> Result<&'a [u8], Fault> {
        let word = match self.rows_in {
            RowsIn::Lines | RowsIn::SoundLines => self.words.next().ok_or(Fault::TooFew {
                line: self.line,
                needed: self.needed,
                found: self.found,
            })?,
            RowsIn::Words => self.next_word().ok_or(Fault::End)?,
        };
        self.found += 1;
        Ok(word)
    }

    #[cold]
    fn no_number(&self, word: &[u8]) -> Fault {
        Fault::Word {
            line: self.line,
            text: excerpt(&String::from_utf8_lossy(word)),
            expected: "a number",
        }
    }
}
