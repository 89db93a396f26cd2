//! Corners of faces, such as `3`, `3/1`, `3//2` and `3/1/2`.

use super::super::error::Indexed;
use super::super::words::whole;

/// A corner: its vertex and its normal, counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Corner {
    pub vertex: u32,
    /// [`Corner::NONE`] without one.
    pub normal: u32,
}

/// An index as it is written, outside of the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Outside {
    pub list: Indexed,
    pub index: i64,
}

/// How many vertices and normals there are.
#[derive(Clone, Copy)]
pub(super) struct Counts {
    pub vertices: usize,
    pub normals: usize,
}

/// What a word is.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Word {
    Corner(Corner),
    Outside(Outside),
    Unreadable,
}

impl Corner {
    pub const NONE: u32 = u32::MAX;

    /// Reads a word. Indices count from 1; negative ones count back from the last item above. Indices beyond the items above may be of
    /// items that follow. The index of a texture coordinate is not looked up, and normal 0 is none.
    #[inline]
    pub fn read(word: &[u8], above: Counts) -> Word {
        let mut parts = word.split(|&byte| byte == b'/');
        let mut index = || match parts.next() {
            None | Some([]) => Some(0),
            Some(digits) => whole(digits),
        };
        let (Some(vertex), Some(_), Some(normal)) = (index(), index(), index()) else {
            return Word::Unreadable;
        };
        if parts.next().is_some() {
            return Word::Unreadable;
        }
        let outside = |list, index| Word::Outside(Outside { list, index });
        let Some(v) = place(vertex, above.vertices) else {
            return outside(Indexed::Vertices, vertex);
        };
        let n = match normal {
            0 => Self::NONE,
            index => match place(index, above.normals) {
                Some(place) => place,
                None => return outside(Indexed::Normals, index),
            },
        };
        Word::Corner(Self {
            vertex: v,
            normal: n,
        })
    }

    /// Whether all items are among these.
    #[inline]
    pub const fn is_within(self, counts: Counts) -> bool {
        self.outside(counts).is_none()
    }

    /// The first index beyond these.
    pub const fn outside(self, counts: Counts) -> Option<Outside> {
        if self.vertex as usize >= counts.vertices {
            return Some(Outside {
                list: Indexed::Vertices,
                index: self.vertex as i64 + 1,
            });
        }
        if self.normal != Self::NONE && self.normal as usize >= counts.normals {
            return Some(Outside {
                list: Indexed::Normals,
                index: self.normal as i64 + 1,
            });
        }
        None
    }
}

/// The place in a list, counted from 0.
#[inline]
fn place(index: i64, above: usize) -> Option<u32> {
    let place = match index {
        ..0 => index.checked_add_unsigned(above as u64)?,
        _ => index - 1,
    };
    u32::try_from(place).ok().filter(|place| *place < u32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_have_four_forms() {
        let read = |word: &str| {
            let above = Counts {
                vertices: 5,
                normals: 3,
            };
            Corner::read(word.as_bytes(), above)
        };
        let corner = |vertex, normal| Word::Corner(Corner { vertex, normal });
        for word in ["4", "4/", "4//", "4/9", "4/-9", "-2", "4//0", "-2/1/"] {
            assert_eq!(read(word), corner(3, Corner::NONE), "{word}");
        }
        for word in ["4//3", "4/1/3", "-2//-1", "+4//3"] {
            assert_eq!(read(word), corner(3, 2), "{word}");
        }
        assert_eq!(read("9//3"), corner(8, 2));
        let outside = |list, index| Word::Outside(Outside { list, index });
        for (word, index) in [("0", 0), ("-6", -6), ("", 0), ("/1/1", 0)] {
            assert_eq!(read(word), outside(Indexed::Vertices, index), "{word}");
        }
        assert_eq!(
            read("5000000000"),
            outside(Indexed::Vertices, 5_000_000_000)
        );
        assert_eq!(read("1//-4"), outside(Indexed::Normals, -4));
        for word in ["x", "1/x", "1//x", "1/1/1/", "1.0", "1,2", "-"] {
            assert_eq!(read(word), Word::Unreadable, "{word}");
        }
    }
}
