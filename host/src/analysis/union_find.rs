//! Disjoint sets.

/// Sets of numbers that can be merged. The smallest member represents its set.
pub(crate) struct UnionFind {
    parents: Vec<u32>,
}

impl UnionFind {
    /// `count` sets of one number each.
    pub(crate) fn new(count: usize) -> Self {
        Self {
            parents: (0..count as u32).collect(),
        }
    }

    /// The smallest member of the set that holds `item`.
    pub(crate) fn find(&mut self, mut item: u32) -> u32 {
        while self.parents[item as usize] != item {
            // Path halving.
            let parent = self.parents[item as usize];
            self.parents[item as usize] = self.parents[parent as usize];
            item = parent;
        }
        item
    }

    /// Merges two sets.
    pub(crate) fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.find(a), self.find(b));
        self.parents[a.max(b) as usize] = a.min(b);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smallest_member_stands_for_its_set() {
        let mut sets = UnionFind::new(6);
        sets.join(5, 3);
        sets.join(1, 5);
        sets.join(4, 2);
        let found: Vec<u32> = (0..6).map(|item| sets.find(item)).collect();
        assert_eq!(found, [0, 1, 2, 1, 2, 1]);
    }
}
