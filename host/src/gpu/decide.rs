//! Stage `decide`: the GPU finds which sides face outward for a target.

use super::buffer::{Download, Range};
use super::decisions::Decisions;
use super::program::{Program, Recorder, Uniform, groups, threads};
use super::sides::{TargetRanges, TargetSides};
use super::{Frame, Gpu, GpuError, Kernel, Mesh, Misfit};
use slimbvh_core::decide::SetCounts;
use slimbvh_core::frustum::Frustum;
use slimbvh_core::launch::BLOCK;
use slimbvh_core::orientation::Target;

/// Which triangles form the set of a target, in components that the target is outside of.
#[derive(Clone, Copy, Debug)]
pub enum Answer<'a> {
    /// Those that face the target (L+).
    Facing,
    /// For a light: the smaller of L+ and L−, the triangles that face away. L− requires that the eye is outside of every
    /// component that the light is outside of. The caller guarantees that every shadow ray then starts outside, so nothing
    /// may be transparent.
    Smaller {
        /// The eye's sides, set or decided earlier in this frame.
        eye: &'a TargetSides,
    },
}

/// The inputs that a program was recorded for.
#[derive(Debug, PartialEq)]
struct Key {
    ranges: TargetRanges,
    measures: Range,
    mesh: Mesh,
    eye_sides: Option<Range>,
}

/// Finds a target's sides.
#[derive(Debug)]
pub struct Decider {
    key: Key,
    program: Program,
    counts: Option<Range>,
}

impl TargetSides {
    /// Records that later commands of the frame find this target and frustum, in the mesh's unit, and the sides that face
    /// outward for the target by the latest measurement: see [`Decisions::measure`].
    ///
    /// # Errors
    /// If no mesh was measured, for an eye without sides or with other components, and if memory is exhausted.
    pub fn decide(
        &mut self,
        frame: &mut Frame,
        decisions: &Decisions,
        (target, frustum): (&Target, &Frustum),
        answer: Answer,
    ) -> Result<(), GpuError> {
        let gpu = frame.gpu();
        let mesh = decisions.mesh.as_ref();
        let mesh = mesh.ok_or_else(|| Misfit::NotMeasured.of("the decisions"))?;
        let side_count = decisions.component_count + 1;
        let eye_sides = match answer {
            Answer::Facing => None,
            Answer::Smaller { eye } => Some(eye_sides(eye, side_count)?),
        };
        gpu.checked(|| {
            let components = decisions.components();
            let ranges = self.reserve(frame, components, side_count as usize, frustum);
            Self::put(frame, bytemuck::bytes_of(target), &ranges.target);
            let key = Key {
                ranges: ranges.clone(),
                measures: decisions.measures.clone(),
                mesh: mesh.clone(),
                eye_sides,
            };
            if self.decider.as_ref().is_none_or(|kept| kept.key != key) {
                self.decider = None;
                let counts = key.eye_sides.as_ref().map(|_| self.counts.range(gpu, 16));
                let program = record(gpu, decisions, &key, counts.as_ref())?;
                self.decider = Some(Decider {
                    key,
                    program,
                    counts,
                });
            }
            if let Some(decider) = &self.decider {
                decider.program.encode(frame);
            }
            self.ranges = Some(ranges);
            Ok(())
        })
    }

    /// Copies the decisions made so far, to be read when the frame is done. For reports only; no decision depends on it.
    ///
    /// # Errors
    /// If nothing was set or decided, or memory is exhausted.
    pub fn read_later(&self, frame: &mut Frame) -> Result<SidesDownload, GpuError> {
        let sides = &self.ranges()?.sides;
        let counts = self.decider.as_ref().and_then(|kept| kept.counts.as_ref());
        frame.gpu().checked(|| {
            Ok(SidesDownload {
                sides: frame.download(sides),
                counts: counts.map(|counts| frame.download(counts)),
            })
        })
    }

    /// The work of the decision.
    #[must_use]
    pub fn work(&self) -> Option<&super::Work> {
        self.decider.as_ref()?.program.work().first()
    }
}

/// The sides of the eye.
fn eye_sides(eye: &TargetSides, side_count: u32) -> Result<Range, GpuError> {
    let sides = &eye.ranges()?.sides;
    if sides.size == 4 * u64::from(side_count) {
        return Ok(sides.clone());
    }
    let fault = Misfit::OtherComponents {
        has: sides.size / 4,
        needs: u64::from(side_count),
    };
    Err(fault.of("the eye"))
}

fn record(
    gpu: &Gpu,
    decisions: &Decisions,
    key: &Key,
    counts: Option<&Range>,
) -> Result<Program, GpuError> {
    let mut recorder = Recorder::default();
    recorder.stage("decide");
    let TargetRanges { sides, .. } = &key.ranges;
    let target = key.ranges.target();
    let (components, count) = (&decisions.components, decisions.reducible_count());
    // All other components stay whole.
    recorder.clear(sides);
    if count > 0 {
        recorder.dispatch(
            Kernel::decide_sides,
            &[target],
            &[components, &decisions.measures],
            &[sides],
            threads(count),
        );
    }
    if let (Some(eye_sides), Some(counts)) = (&key.eye_sides, counts) {
        let mesh = &key.mesh;
        if count == 0 {
            let all = mesh.triangle_count;
            recorder.write(counts, &[all, all, 0, 0]);
            key.ranges.record_packed(&mut recorder);
            return recorder.finish(gpu);
        }
        let blocks = &decisions.blocks;
        recorder.dispatch(
            Kernel::decide_counts,
            &[Uniform::Stored(&decisions.exponent), target],
            &[
                &mesh.vertices,
                &mesh.indices,
                &decisions.triangle_components.0,
                sides,
                eye_sides,
            ],
            &[blocks],
            groups(mesh.triangle_count.div_ceil(BLOCK)),
        );
        recorder.dispatch(Kernel::decide_smaller, &[], &[blocks], &[counts], groups(1));
        recorder.update(
            Kernel::decide_negate,
            &[],
            &[counts, components],
            &[sides],
            threads(count),
        );
    }
    key.ranges.record_packed(&mut recorder);
    recorder.finish(gpu)
}

/// A target's decisions, being copied.
#[derive(Debug)]
#[must_use]
pub struct SidesDownload {
    sides: Download,
    counts: Option<Download>,
}

/// A target's decisions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decided {
    /// The side of each component that rays may hit: the outer one, or the inner one for L−; 0 for both. The entry at the
    /// number of components is 0.
    pub sides: Vec<i32>,
    /// The sizes of both sets, if the smaller one was requested.
    pub counts: Option<SetCounts>,
}

impl SidesDownload {
    /// Waits for the copy, and reads it.
    ///
    /// # Errors
    /// If the device was lost.
    pub fn read(self, gpu: &Gpu) -> Result<Decided, GpuError> {
        gpu.block_on(self.read_async(gpu))
    }

    /// [`Self::read`], without blocking.
    ///
    /// # Errors
    /// If the device was lost; in a browser, also the errors of earlier calls.
    pub async fn read_async(self, gpu: &Gpu) -> Result<Decided, GpuError> {
        let sides = self.sides.read_async(gpu).await?;
        let counts: Vec<SetCounts> = match self.counts {
            Some(counts) => counts.read_async(gpu).await?,
            None => Vec::new(),
        };
        let counts = counts.first().copied();
        Ok(Decided { sides, counts })
    }
}
