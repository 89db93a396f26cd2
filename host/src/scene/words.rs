//! Lines, words and numbers of text.

use super::LoadError;
use super::error::excerpt;
use super::load::Source;

/// The text in UTF-8 and without a byte order mark; UTF-16 is told by its mark.
pub(super) fn without_mark(bytes: Vec<u8>) -> Vec<u8> {
    let wide = |from: fn([u8; 2]) -> u16| {
        let (units, _) = bytes[2..].as_chunks();
        let units: Vec<u16> = units.iter().map(|unit| from(*unit)).collect();
        String::from_utf16_lossy(&units).into_bytes()
    };
    match &bytes[..] {
        [0xff, 0xfe, ..] => wide(u16::from_le_bytes),
        [0xfe, 0xff, ..] => wide(u16::from_be_bytes),
        [0xef, 0xbb, 0xbf, text @ ..] => text.to_vec(),
        _ => bytes,
    }
}

/// The lines with their numbers, counted from 1. They end with LF, CR LF or CR.
#[derive(Clone)]
pub(super) struct Lines<'a> {
    rest: &'a [u8],
    line: usize,
}

impl<'a> Lines<'a> {
    pub const fn new(text: &'a [u8]) -> Self {
        Self::from(text, 1)
    }

    /// The lines of a text that begins with the given line.
    pub const fn from(text: &'a [u8], line: usize) -> Self {
        Self {
            rest: text,
            line: line - 1,
        }
    }

    /// The unread bytes.
    pub const fn rest(&self) -> &'a [u8] {
        self.rest
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = (usize, &'a [u8]);

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        if self.rest.is_empty() {
            return None;
        }
        let end = memchr::memchr2(b'\n', b'\r', self.rest);
        let (line, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        self.rest = match rest {
            [b'\r', b'\n', rest @ ..] | [_, rest @ ..] => rest,
            [] => rest,
        };
        self.line += 1;
        Some((self.line, line))
    }
}

/// The words of a line up to a comment, which begins with `#`, unless `1.` stands before that.
#[derive(Clone)]
pub(super) struct Words<'a> {
    rest: &'a [u8],
}

impl<'a> Words<'a> {
    pub const fn new(line: &'a [u8]) -> Self {
        Self { rest: line }
    }

    /// Whether no word follows.
    #[inline]
    pub fn is_empty(&self) -> bool {
        let next = self.rest.iter().find(|&&byte| kind(byte) != SPACE);
        next.is_none_or(|byte| *byte == b'#')
    }

    /// The unread text, with comments.
    pub const fn rest(&self) -> &'a [u8] {
        self.rest.trim_ascii()
    }
}

/// What a byte is: a part of a word, a space, or the begin of a comment.
const WORD: u8 = 0;
const SPACE: u8 = 1;
const COMMENT: u8 = 2;

/// For each byte, what it is. Spaces are also tabs, line ends, vertical tabs and form feeds.
const KINDS: [u8; 256] = {
    let mut kinds = [WORD; 256];
    kinds[b' ' as usize] = SPACE;
    let mut byte = b'\t';
    while byte <= b'\r' {
        kinds[byte as usize] = SPACE;
        byte += 1;
    }
    kinds[b'#' as usize] = COMMENT;
    kinds
};

const fn kind(byte: u8) -> u8 {
    KINDS[byte as usize]
}

impl<'a> Words<'a> {
    /// The next word, where a `#` follows.
    #[cold]
    fn before_comment(&mut self, text: &'a [u8], mut end: usize) -> Option<&'a [u8]> {
        self.rest = &[];
        // A number such as `1.#QNAN`.
        if text[..end].ends_with(b"1.") {
            let more = text[end..].iter().position(|&byte| kind(byte) == SPACE);
            end = more.map_or(text.len(), |more| end + more);
            self.rest = &text[end..];
        }
        (end > 0).then(|| &text[..end])
    }
}

impl<'a> Iterator for Words<'a> {
    type Item = &'a [u8];

    #[inline]
    fn next(&mut self) -> Option<&'a [u8]> {
        // Loops, which take fewer instructions than `position`.
        let mut text = self.rest;
        while let [byte, rest @ ..] = text
            && kind(*byte) == SPACE
        {
            text = rest;
        }
        let mut end = 0;
        while end < text.len() && kind(text[end]) == WORD {
            end += 1;
        }
        if text[end..].starts_with(b"#") {
            return self.before_comment(text, end);
        }
        let (word, rest) = text.split_at(end);
        self.rest = rest;
        (!word.is_empty()).then_some(word)
    }
}

/// A word as a number. NaN is also what C libraries write for it, such as `-nan(ind)` and `1.#QNAN`, and an exponent may have a `d`, as in
/// Fortran.
#[inline]
pub(super) fn number(word: &[u8]) -> Option<f64> {
    short_number(word).or_else(|| long_number(word))
}

/// A number of few digits, such as `-0.0312`: a whole number below 2^53 over a power of ten up to 10^15, which are both exact, so the
/// quotient is the nearest number (Clinger 1990, "How to Read Floating Point Numbers Accurately"). `None` for others.
#[inline]
fn short_number(word: &[u8]) -> Option<f64> {
    // Up to 15 digits are below 2^53.
    const MOST_DIGITS: usize = 15;
    const POWERS: [f64; MOST_DIGITS + 1] = [
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
    ];
    let (is_negative, digits) = match word {
        [b'-', digits @ ..] => (true, digits),
        digits => (false, digits),
    };
    if digits.len() > MOST_DIGITS {
        return None;
    }
    let (mut whole, mut point) = (0_u64, None);
    for (i, &byte) in digits.iter().enumerate() {
        if byte.is_ascii_digit() {
            whole = 10 * whole + u64::from(byte - b'0');
        } else if byte == b'.' && point.is_none() {
            point = Some(i + 1);
        } else {
            return None;
        }
    }
    let fraction = digits.len() - point.unwrap_or(digits.len());
    // A point alone is no number, nor is a sign.
    if digits.len() == usize::from(point.is_some()) {
        return None;
    }
    let number = whole as f64 / POWERS[fraction];
    Some(if is_negative { -number } else { number })
}

fn long_number(word: &[u8]) -> Option<f64> {
    let text = std::str::from_utf8(word).ok()?;
    text.parse().ok().or_else(|| odd_number(text))
}

#[cold]
fn odd_number(text: &str) -> Option<f64> {
    let text = text.to_ascii_lowercase();
    let unsigned = text.trim_start_matches(['+', '-']);
    if unsigned.starts_with("nan(") {
        return Some(f64::NAN);
    }
    if let Some(kind) = unsigned.strip_prefix("1.#") {
        return Some(match kind.starts_with("inf") {
            true if text.starts_with('-') => f64::NEG_INFINITY,
            true => f64::INFINITY,
            false => f64::NAN,
        });
    }
    if !unsigned.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
        return None;
    }
    text.replacen('d', "e", 1).parse().ok()
}

/// A whole number.
#[inline]
pub(super) fn whole(word: &[u8]) -> Option<i64> {
    let (is_negative, digits) = match word {
        [b'-', digits @ ..] => (true, digits),
        [b'+', digits @ ..] => (false, digits),
        digits => (false, digits),
    };
    // Up to 18 digits fit.
    if digits.is_empty() || digits.len() > 18 {
        return std::str::from_utf8(word).ok()?.parse().ok();
    }
    let mut number = 0;
    for digit in digits {
        if !digit.is_ascii_digit() {
            return None;
        }
        number = 10 * number + i64::from(digit - b'0');
    }
    Some(if is_negative { -number } else { number })
}

/// The text of a name, trimmed.
pub(super) fn name(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes.trim_ascii()).into_owned()
}

/// What a coordinate must be, for messages.
pub(super) const COORDINATE: &str = "a number up to 3.4e38, the largest of 32 bits";

/// Whether a finite coordinate is none as an `f32`.
#[inline]
pub(super) fn is_too_large(x: f64) -> bool {
    x.is_finite() && (x as f32).is_infinite()
}

/// A word as a coordinate. With lenient options, NaN for one that is none: faces with it are dropped.
#[inline]
pub(super) fn coordinate(source: &Source<'_>, line: usize, word: &[u8]) -> Result<f64, LoadError> {
    match number(word) {
        Some(x) if !is_too_large(x) => Ok(x),
        _ if source.options.lenient => Ok(f64::NAN),
        Some(_) => Err(bad_word(source, line, word, COORDINATE)),
        None => Err(bad_word(source, line, word, "a number")),
    }
}

/// A word as a part of a normal. With lenient options, NaN for one that is none: such a normal is flat shading.
#[inline]
pub(super) fn normal_part(source: &Source<'_>, line: usize, word: &[u8]) -> Result<f64, LoadError> {
    match number(word) {
        Some(x) => Ok(x),
        None if source.options.lenient => Ok(f64::NAN),
        None => Err(bad_word(source, line, word, "a number")),
    }
}

/// The error for a word in place of something else.
pub(super) fn bad_word(
    source: &Source<'_>,
    line: usize,
    word: &[u8],
    expected: &'static str,
) -> LoadError {
    LoadError::BadNumber {
        file: source.file.clone(),
        line,
        text: excerpt(&String::from_utf8_lossy(word)),
        expected,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_in_three_ways() {
        let lines: Vec<_> = Lines::new(b"a\nb\r\nc\rd\r\r\ne").collect();
        let expected: [(usize, &[u8]); 6] = [
            (1, b"a"),
            (2, b"b"),
            (3, b"c"),
            (4, b"d"),
            (5, b""),
            (6, b"e"),
        ];
        assert_eq!(lines, expected);
    }

    #[test]
    fn comments_end_a_line() {
        let words = |line: &'static str| Words::new(line.as_bytes()).collect::<Vec<_>>();
        assert_eq!(words(" f 1\t2 \x0b3#x 4"), [b"f", b"1", b"2", b"3"]);
        assert_eq!(words("a # b"), [b"a"]);
        let numbers: [&[u8]; 3] = [b"-1.#IND00", b"1.#QNAN", b"2"];
        assert_eq!(words("-1.#IND00 1.#QNAN 2# 3"), numbers);
        assert!(words("#a").is_empty() && words("  ").is_empty());
    }

    #[test]
    fn marks_are_taken_off() {
        let utf_16 = |from: fn(u16) -> [u8; 2]| "\u{feff}v ä".encode_utf16().flat_map(from);
        let text = "v ä".as_bytes();
        assert_eq!(without_mark(utf_16(u16::to_le_bytes).collect()), text);
        assert_eq!(without_mark(utf_16(u16::to_be_bytes).collect()), text);
        assert_eq!(without_mark("\u{feff}v ä".into()), text);
        assert_eq!(without_mark(text.into()), text);
        assert_eq!(without_mark(vec![0xff]), [0xff]);
        assert!(without_mark(vec![0xff, 0xfe]).is_empty());
    }

    #[test]
    fn numbers_of_other_libraries() {
        for text in [
            "nan",
            "-nan",
            "-NaN(ind)",
            "nan(0x8000)",
            "1.#QNAN",
            "-1.#IND000",
        ] {
            assert!(number(text.as_bytes()).is_some_and(f64::is_nan), "{text}");
        }
        assert_eq!(number(b"-1.#INF"), Some(f64::NEG_INFINITY));
        assert_eq!(number(b"1.5D+2"), Some(150.0));
        assert_eq!(number(b".5"), Some(0.5));
        for text in ["", "d", "1,5", "0x1", "1d2d3", "1.5f", "\u{661}"] {
            assert_eq!(number(text.as_bytes()), None, "{text}");
        }
    }

    #[test]
    fn short_numbers_are_those_of_the_standard_library() {
        for text in [
            "0",
            "-0",
            "-0.0",
            ".5",
            "5.",
            "-.25",
            "999999999999999",
            "0.00000000000001",
            "12345678.9012345",
            "0.30000000000000004",
            "9007199254740993",
            "1e3",
            "+1",
        ] {
            let expected: f64 = text.parse().unwrap();
            let found = number(text.as_bytes()).map(f64::to_bits);
            assert_eq!(found, Some(expected.to_bits()), "{text}");
        }
        for text in [".", "-", "-.", "1.2.3", "--1", "1-", "1.-2"] {
            assert_eq!(number(text.as_bytes()), None, "{text}");
        }
        // More digits would be rounded twice.
        assert_eq!(short_number(b"9007199254740993"), None);
    }

    proptest::proptest! {
        #[test]
        fn numbers_are_those_of_the_standard_library(text in "-?[0-9]{0,12}\\.?[0-9]{0,12}(e-?[0-9]{1,2})?") {
            let expected: Option<f64> = text.parse().ok();
            let found = number(text.as_bytes());
            proptest::prop_assert_eq!(found.map(f64::to_bits), expected.map(f64::to_bits));
        }
    }

    #[test]
    fn whole_numbers() {
        for text in [
            "0",
            "-7",
            "+12",
            "999999999999999999",
            "9223372036854775807",
            "-9223372036854775808",
            "9223372036854775808",
            "",
            "-",
            "+-1",
            "1.0",
            "1e3",
            "0000000000000000000000001",
        ] {
            assert_eq!(whole(text.as_bytes()), text.parse().ok(), "{text}");
        }
    }
}
