//! How much memory the sets of a GPU have.

/// How much memory sets have on a GPU, which reserves it before it counts their triangles. On the CPU a set has what it needs.
///
/// Where the whole tree is built, too, the memory of sets can follow the counts of recent frames, which are read back without waiting. A
/// set that does not fit is not built in that frame: its rays go through the whole tree, with the same answers, and its memory grows.
///
/// ```
/// use slimbvh::FrameConfig;
/// use slimbvh::reduce::SetMemory;
/// // No frame may send a set's rays through the whole tree.
/// let config = FrameConfig { set_memory: SetMemory::All, ..FrameConfig::for_frames(1000) };
/// # assert_ne!(config, FrameConfig::for_frames(1000));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SetMemory {
    /// [`Self::Recent`] for meshes of 65,536 triangles or more.
    #[default]
    Auto,
    /// Half as much again as the largest of the last eight counts needs, or at first the plan's estimate. To change it, all trees are
    /// built anew: it grows when it is nearly full, and shrinks when less than half was needed for 256 builds. All trees share two
    /// buffers; a set that does not fit into the adapter's largest beside the others has memory for all triangles.
    Recent,
    /// As much as all triangles need.
    All,
}

/// Sets of smaller meshes have memory for all triangles under [`SetMemory::Auto`]: at most 7 MiB each.
const LEAST_TRIANGLES: usize = 1 << 16;

impl SetMemory {
    /// Whether memory follows counts.
    pub(super) const fn is_recent(self, triangle_count: usize) -> bool {
        match self {
            Self::Auto => triangle_count >= LEAST_TRIANGLES,
            Self::Recent => true,
            Self::All => false,
        }
    }
}
