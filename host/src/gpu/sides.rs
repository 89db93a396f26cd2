//! What rays of one origin may hit, in buffers.

use super::buffer::{Range, Slot, upload};
use super::decide::Decider;
use super::program::Uniform;
use super::{Frame, Gpu, GpuError, Misfit};
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;
use wgpu::BufferUsages;

/// Which component each triangle of a mesh belongs to.
#[derive(Clone, Debug, PartialEq)]
pub struct Components(pub(super) Range);

impl Components {
    /// Copies the component of each triangle to the GPU.
    ///
    /// # Errors
    /// For more triangles than the GPU takes.
    pub fn upload(gpu: &Gpu, components: &[u32]) -> Result<Self, GpuError> {
        let bytes = size_of_val(components) as u64;
        gpu.check_sizes(
            &[("the components", bytes)],
            "take a smaller mesh, or the CPU",
        )?;
        gpu.checked(|| {
            let usage = BufferUsages::STORAGE;
            let buffer = upload(gpu, "slimbvh components", usage, components);
            Ok(Self(Range::whole(&buffer)))
        })
    }
}

/// A target of rays, and the outer side of each component as it matters to that. Filled by [`Self::set`], or on the GPU by
/// [`Self::decide`], which can fill it again without allocating.
#[derive(Debug)]
pub struct TargetSides {
    target: Slot,
    frustum: Slot,
    needed: Slot,
    sides: Slot,
    /// How large both sets are that answer for a light.
    pub(super) counts: Slot,
    pub(super) decider: Option<Decider>,
    pub(super) ranges: Option<TargetRanges>,
}

/// That something needs the set.
const NEEDED: [u32; 4] = [1, 0, 0, 0];

/// Where the kernels find it.
#[derive(Clone, Debug, PartialEq)]
pub struct TargetRanges {
    pub target: Range,
    pub frustum: Range,
    /// Whether anything needs the set: its first word is 0 where nothing does.
    pub needed: Range,
    pub sides: Range,
}

impl TargetRanges {
    pub const fn target(&self) -> Uniform<'_> {
        Uniform::Stored(&self.target)
    }

    pub const fn needed(&self) -> Uniform<'_> {
        Uniform::Stored(&self.needed)
    }

    pub const fn frustum(&self) -> Uniform<'_> {
        Uniform::Stored(&self.frustum)
    }
}

impl Default for TargetSides {
    fn default() -> Self {
        let copied = BufferUsages::COPY_DST;
        Self {
            target: Slot::new("slimbvh target", BufferUsages::UNIFORM.union(copied)),
            frustum: Slot::new("slimbvh frustum", BufferUsages::UNIFORM.union(copied)),
            needed: Slot::new(
                "slimbvh needed",
                BufferUsages::UNIFORM
                    .union(BufferUsages::STORAGE)
                    .union(copied),
            ),
            sides: Slot::new("slimbvh sides", BufferUsages::STORAGE.union(copied)),
            counts: Slot::new(
                "slimbvh set counts of a light",
                BufferUsages::STORAGE.union(copied),
            ),
            decider: None,
            ranges: None,
        }
    }
}

impl TargetSides {
    /// Nothing yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Records that later commands of the frame find this target and frustum, in the mesh's unit, and these sides of the
    /// components: 1 where the front counts, −1 where the back does, 0 where all of a component counts. The frustum bounds
    /// sets only.
    ///
    /// # Errors
    /// If memory is exhausted.
    pub fn set(
        &mut self,
        frame: &mut Frame,
        target: &Target,
        frustum: &Frustum,
        sides: &[i32],
    ) -> Result<(), GpuError> {
        let gpu = frame.gpu();
        let sides: &[i32] = if sides.is_empty() { &[0] } else { sides };
        gpu.checked(|| {
            let ranges = self.reserve(frame, sides.len(), frustum);
            Self::put(frame, bytemuck::bytes_of(target), &ranges.target);
            Self::put(frame, bytemuck::cast_slice(sides), &ranges.sides);
            // Nothing was counted for these.
            self.decider = None;
            self.ranges = Some(ranges);
            Ok(())
        })
    }

    /// Makes room for a target and its sides, and records that later commands find this frustum and the set needed.
    pub(super) fn reserve(
        &mut self,
        frame: &mut Frame,
        side_count: usize,
        frustum: &Frustum,
    ) -> TargetRanges {
        let gpu = frame.gpu();
        let ranges = TargetRanges {
            target: self.target.range(gpu, size_of::<Target>() as u64),
            frustum: self.frustum.range(gpu, size_of::<Frustum>() as u64),
            needed: self.needed.range(gpu, size_of_val(&NEEDED) as u64),
            sides: self.sides.range(gpu, 4 * side_count as u64),
        };
        Self::put(frame, bytemuck::bytes_of(frustum), &ranges.frustum);
        Self::put(frame, bytemuck::bytes_of(&NEEDED), &ranges.needed);
        ranges
    }

    /// Records that bytes be put into a range.
    pub(super) fn put(frame: &mut Frame, bytes: &[u8], to: &Range) {
        let usage = BufferUsages::COPY_SRC;
        let from = upload(frame.gpu(), "slimbvh sides to upload", usage, bytes);
        let encoder = frame.encoder();
        encoder.copy_buffer_to_buffer(&from, 0, &to.buffer, to.offset, to.size);
    }

    pub(super) fn ranges(&self) -> Result<&TargetRanges, GpuError> {
        let ranges = self.ranges.as_ref();
        ranges.ok_or_else(|| Misfit::NotDecided.of("the target"))
    }
}

/// Which triangles a hierarchy is built over.
#[derive(Clone, Copy, Debug)]
pub enum Subset<'a> {
    /// All of the mesh.
    All,
    /// Those that rays from or to a target may hit.
    Of {
        /// The component of each triangle.
        components: &'a Components,
        /// The target, and which sides of which components face out.
        sides: &'a TargetSides,
    },
}
