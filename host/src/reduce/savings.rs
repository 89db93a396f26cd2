//! The savings of a plan, each of which can be turned off.

/// Work that a picture does not need.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Saving {
    /// The camera's set leaves out triangles that are certainly outside the picture.
    Frustum,
    /// A light's set holds the triangles that face away from the light (L−), if these cost less and give the same answers.
    Away,
    /// Nearby lights share a set, if that costs less than two sets.
    Groups,
    /// Sets of lights are built and traced one after the other, in the same memory.
    Turns,
    /// No set is built for a light that reaches no point of the picture.
    Unseen,
    /// If a set is the only tree, its triangles are sorted alone.
    Alone,
}

impl Saving {
    /// All savings.
    pub const ALL: [Self; 6] = [
        Self::Frustum,
        Self::Away,
        Self::Groups,
        Self::Turns,
        Self::Unseen,
        Self::Alone,
    ];
}

/// A set of savings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Savings(u32);

impl Default for Savings {
    fn default() -> Self {
        Self::ALL
    }
}

impl Savings {
    /// All savings.
    pub const ALL: Self = Self(u32::MAX);

    /// All of these except one.
    #[must_use]
    pub const fn without(self, saving: Saving) -> Self {
        Self(self.0 & !(1 << saving as u32))
    }

    /// Whether the set contains this saving.
    #[must_use]
    pub const fn has(self, saving: Saving) -> bool {
        self.0 >> saving as u32 & 1 == 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_is_left_out_alone() {
        for left_out in Saving::ALL {
            let savings = Savings::ALL.without(left_out);
            for saving in Saving::ALL {
                assert_eq!(savings.has(saving), saving != left_out);
            }
        }
    }
}
