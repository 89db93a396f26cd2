//! The triangles that rays of one target may hit, in the GPU's memory.

use super::buffer::{Range, Slot, upload};
use super::decide::Decider;
use super::program::{Program, Recorder, Uniform, threads};
use super::{Frame, Gpu, GpuError, Kernel, Misfit};
#[cfg(doc)]
use slimbvh_core::classify::PackedSides;
use slimbvh_core::classify::SIDES_PER_WORD;
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;
use wgpu::BufferUsages;

/// The component of each triangle of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Components(pub(super) Range);

impl Components {
    /// Copies the component of each triangle to the GPU.
    ///
    /// # Errors
    /// For more triangles than the GPU's limits allow.
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

/// A target of rays, and the side of each component that faces outward for it. [`Self::set`] fills it, or on the GPU
/// [`Self::decide`], which can fill it again without allocating.
#[derive(Debug)]
pub struct TargetSides {
    target: Slot,
    frustum: Slot,
    needed: Slot,
    sides: Slot,
    packed: Slot,
    /// The sizes of both sets of a light.
    pub(super) counts: Slot,
    pub(super) decider: Option<Decider>,
    /// Packs the sides that the host set.
    packer: Option<(TargetRanges, Program)>,
    pub(super) ranges: Option<TargetRanges>,
}

/// The mark of a set that rays need.
const NEEDED: [u32; 4] = [1, 0, 0, 0];

/// The ranges that kernels read.
#[derive(Clone, Debug, PartialEq)]
pub struct TargetRanges {
    pub target: Range,
    pub frustum: Range,
    /// Whether any ray needs the set: the first word is 0 if none does.
    pub needed: Range,
    /// By component.
    pub sides: Range,
    /// The component of each triangle.
    pub components: Components,
    /// By primitive, packed ([`PackedSides`]): what rays through whole trees ask.
    pub packed: Range,
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

    /// Records that the sides of components are packed by primitive.
    pub fn record_packed(&self, recorder: &mut Recorder) {
        recorder.stage("classify");
        let reads = [&self.components.0, &self.sides];
        let each = threads((self.packed.size / 4) as u32);
        let to = [&self.packed];
        recorder.dispatch(Kernel::classify_sides, &[], &reads, &to, each);
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
            packed: Slot::storage("slimbvh packed sides"),
            counts: Slot::new(
                "slimbvh set counts of a light",
                BufferUsages::STORAGE.union(copied),
            ),
            decider: None,
            packer: None,
            ranges: None,
        }
    }
}

impl TargetSides {
    /// Empty buffers.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Records that later commands of the frame find this target and frustum, in the mesh's unit, and these sides of the components:
    /// 1 if front faces of the component count, −1 if back faces count, 0 if both count. The frustum bounds sets only.
    ///
    /// # Errors
    /// If memory is exhausted.
    pub fn set(
        &mut self,
        frame: &mut Frame,
        components: &Components,
        (target, frustum): (&Target, &Frustum),
        sides: &[i32],
    ) -> Result<(), GpuError> {
        let gpu = frame.gpu();
        let sides: &[i32] = if sides.is_empty() { &[0] } else { sides };
        gpu.checked(|| {
            let ranges = self.reserve(frame, components, sides.len(), frustum);
            Self::put(frame, bytemuck::bytes_of(target), &ranges.target);
            Self::put(frame, bytemuck::cast_slice(sides), &ranges.sides);
            // These sides have no counts.
            self.decider = None;
            self.ranges = None;
            if self.packer.as_ref().is_none_or(|(kept, _)| *kept != ranges) {
                self.packer = None;
                let mut recorder = Recorder::default();
                ranges.record_packed(&mut recorder);
                self.packer = Some((ranges.clone(), recorder.finish(gpu)?));
            }
            if let Some((_, program)) = &self.packer {
                program.encode(frame);
            }
            self.ranges = Some(ranges);
            Ok(())
        })
    }

    /// Makes room for a target and its sides, and records that later commands find this frustum, and the set marked as
    /// needed.
    pub(super) fn reserve(
        &mut self,
        frame: &mut Frame,
        components: &Components,
        side_count: usize,
        frustum: &Frustum,
    ) -> TargetRanges {
        let gpu = frame.gpu();
        let primitive_count = components.0.size / 4;
        let packed_bytes = 4 * primitive_count.div_ceil(SIDES_PER_WORD.into()).max(1);
        let ranges = TargetRanges {
            target: self.target.range(gpu, size_of::<Target>() as u64),
            frustum: self.frustum.range(gpu, size_of::<Frustum>() as u64),
            needed: self.needed.range(gpu, size_of_val(&NEEDED) as u64),
            sides: self.sides.range(gpu, 4 * side_count as u64),
            components: components.clone(),
            packed: self.packed.range(gpu, packed_bytes),
        };
        Self::put(frame, bytemuck::bytes_of(frustum), &ranges.frustum);
        Self::put(frame, bytemuck::bytes_of(&NEEDED), &ranges.needed);
        ranges
    }

    /// Records an upload of bytes to a range.
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

/// The triangles of a hierarchy.
#[derive(Clone, Copy, Debug)]
pub enum Subset<'a> {
    /// All triangles of the mesh.
    All,
    /// Those that rays from or to a target may hit.
    Of {
        /// The component of each triangle.
        components: &'a Components,
        /// The target, and the sides that face outward.
        sides: &'a TargetSides,
    },
}
