//! A counting sort by a small key.

/// Values grouped by key, sorted within each group. A counting sort by key and a small sort for each group take a
/// fraction of the time of one large sort.
pub(crate) struct Buckets {
    /// Bucket `key` is `values[starts[key]..starts[key + 1]]`.
    starts: Vec<u32>,
    values: Vec<u64>,
}

impl Buckets {
    /// Groups fewer than 2^32 pairs `(key, value)` with `key < key_count`.
    pub(crate) fn new(key_count: usize, pairs: impl Iterator<Item = (u32, u64)> + Clone) -> Self {
        // Count each key, then sum up: `starts[key]` is the end of the bucket.
        let mut starts = vec![0_u32; key_count + 1];
        for (key, _) in pairs.clone() {
            starts[key as usize] += 1;
        }
        let mut total = 0;
        for start in &mut starts {
            total += *start;
            *start = total;
        }

        // Fill the buckets from their ends: `starts[key]` ends up as the start.
        let mut values = vec![0; total as usize];
        for (key, value) in pairs {
            let start = &mut starts[key as usize];
            *start -= 1;
            values[*start as usize] = value;
        }
        for range in starts.windows(2) {
            values[range[0] as usize..range[1] as usize].sort_unstable();
        }
        Self { starts, values }
    }

    /// Every key with its sorted values, by key. Many keys have none.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (u32, &[u64])> {
        (0_u32..)
            .zip(self.starts.windows(2))
            .map(|(key, range)| (key, &self.values[range[0] as usize..range[1] as usize]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_by_key_and_sorts_values() {
        let pairs = [(2, 9), (0, 5), (2, 7), (3, 1), (2, 8)];
        let buckets = Buckets::new(5, pairs.into_iter());
        let groups: Vec<_> = buckets.iter().collect();
        assert_eq!(
            groups,
            [
                (0, &[5][..]),
                (1, &[]),
                (2, &[7, 8, 9]),
                (3, &[1]),
                (4, &[])
            ]
        );
        assert_eq!(Buckets::new(0, [].into_iter()).iter().count(), 0);
    }
}
