//! Lines of OBJ, where a backslash at the end continues a line in the next.

use super::super::words;
use std::borrow::Cow;

/// The lines with their numbers; a continued line has that of its first.
pub(super) struct Lines<'a>(words::Lines<'a>);

impl<'a> Lines<'a> {
    pub const fn new(text: &'a [u8]) -> Self {
        Self(words::Lines::new(text))
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = (usize, Cow<'a, [u8]>);

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        let (number, line) = self.0.next()?;
        match continued(line) {
            None => Some((number, Cow::Borrowed(line))),
            Some(begin) => {
                let mut whole = begin.to_vec();
                for (_, line) in self.0.by_ref() {
                    whole.push(b' ');
                    let more = continued(line);
                    whole.extend(more.unwrap_or(line));
                    if more.is_none() {
                        break;
                    }
                }
                Some((number, Cow::Owned(whole)))
            }
        }
    }
}

/// The line without its backslash, if it ends with one outside of a comment. Space may follow.
#[inline]
fn continued(line: &[u8]) -> Option<&[u8]> {
    let begin = line.trim_ascii_end().strip_suffix(b"\\")?;
    (!begin.contains(&b'#')).then_some(begin)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_backslash_joins_lines() {
        let text = b"a\\\nb \\ \r\n c\n# d \\\ne # f \\\ng\\";
        let lines: Vec<_> = Lines::new(text)
            .map(|(line, text)| (line, String::from_utf8(text.into_owned()).expect("ASCII")))
            .collect();
        let expected = [(1, "a b   c"), (4, "# d \\"), (5, "e # f \\"), (6, "g")];
        assert_eq!(
            lines,
            expected.map(|(line, text)| (line, text.to_owned())),
            "{lines:?}"
        );
    }
}
