//! Measures of components whose vertices move on the GPU.

use super::buffer::{Download, Range, Slot, upload};
use super::program::{Program, Recorder, Uniform, groups};
use super::sides::Components;
use super::{Builder, Frame, Gpu, GpuError, Kernel, Mesh, Misfit};
use crate::topology::Topology;
use slimbvh_core::decide::{Component, Measure};
use slimbvh_core::launch::BLOCK;
use wgpu::BufferUsages;

/// Advice for a mesh that is too large.
const TOO_LARGE: &str = "take a smaller mesh, or the CPU";

/// Measures a mesh's components on the GPU, so that the host need not know the vertices: their boxes, which side faces
/// outward, and whether they are still closed. [`super::TargetSides::decide`] then finds for each target which sides face
/// outward, equal to [`crate::Decisions`] to the bit.
#[derive(Debug)]
pub struct Decisions {
    pub(super) triangle_components: Components,
    /// The components that may be reduced.
    pub(super) components: Range,
    pub(super) component_numbers: Vec<u32>,
    /// The number of components in the mesh.
    pub(super) component_count: u32,
    spans: Range,
    span_count: u32,
    faces: Range,
    links: Range,
    span_measures: Range,
    pub(super) measures: Range,
    /// The scene's exponent.
    pub(super) exponent: Range,
    /// A range for counts of sets.
    pub(super) blocks: Range,
    triangle_count: u32,
    vertex_count: usize,
    /// The measured mesh.
    pub(super) mesh: Option<Mesh>,
    /// The measuring program, and the range of the exponent that it reads.
    program: Option<(Range, Program)>,
}

/// The measure of one component.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Its number.
    pub component: u32,
    /// Its box, the sign of its volume, and whether it is closed.
    pub measure: Measure,
}

impl Decisions {
    /// Uploads what does not depend on positions from a topology. If seams matter, the topology must have searched for
    /// them.
    ///
    /// # Errors
    /// For more triangles than the GPU's limits allow.
    pub fn new(gpu: &Gpu, topology: &Topology) -> Result<Self, GpuError> {
        let runs = topology.runs();
        let triangle_count = topology.components().len() as u32;
        gpu.check_sizes(
            &[
                (
                    "the faces by component",
                    size_of_val(runs.faces.as_slice()) as u64,
                ),
                ("the links", size_of_val(runs.links.as_slice()) as u64),
                (
                    "the components",
                    (runs.components.len() * size_of::<Measure>()) as u64,
                ),
            ],
            TOO_LARGE,
        )?;
        let triangle_components = Components::upload(gpu, topology.components())?;
        gpu.checked(|| {
            let usage = BufferUsages::STORAGE;
            let measures = |label, count: usize| {
                let bytes = (count.max(1) * size_of::<Measure>()) as u64;
                Slot::storage(label).range(gpu, bytes)
            };
            let state = BufferUsages::UNIFORM.union(BufferUsages::COPY_DST);
            let block_count = u64::from(triangle_count.div_ceil(BLOCK).max(1));
            let list = upload(gpu, "slimbvh decided components", usage, &runs.components);
            let spans = upload(gpu, "slimbvh spans", usage, &runs.spans);
            let faces = upload(gpu, "slimbvh faces by component", usage, &runs.faces);
            let links = upload(gpu, "slimbvh links", usage, &runs.links);
            Ok(Self {
                triangle_components,
                components: Range::whole(&list),
                component_numbers: runs
                    .components
                    .iter()
                    .map(|c: &Component| c.number)
                    .collect(),
                component_count: topology.component_count(),
                spans: Range::whole(&spans),
                span_count: runs.spans.len() as u32,
                faces: Range::whole(&faces),
                links: Range::whole(&links),
                span_measures: measures("slimbvh span measures", runs.spans.len()),
                measures: measures("slimbvh measures", runs.components.len()),
                exponent: Slot::new("slimbvh decisions' exponent", state).range(gpu, 16),
                blocks: Slot::storage("slimbvh set counts of blocks").range(gpu, 16 * block_count),
                triangle_count,
                vertex_count: topology.vertex_count(),
                mesh: None,
                program: None,
            })
        })
    }

    /// Records the measurement of all components at the vertices' positions at this point of the frame. The builder, which
    /// supplies the scene's magnitude, must have sorted, built or refitted this mesh with these vertices before, in this
    /// frame or an earlier one.
    ///
    /// # Errors
    /// If the counts show that it is another mesh, and for a builder without a mesh.
    pub fn measure(
        &mut self,
        frame: &mut Frame,
        builder: &Builder,
        mesh: &Mesh,
    ) -> Result<(), GpuError> {
        let gpu = frame.gpu();
        let expected = (self.triangle_count, (self.vertex_count.max(1) * 12) as u64);
        if (mesh.triangle_count, mesh.vertices.size) != expected {
            let fault = Misfit::OtherMesh {
                triangle_count: u64::from(mesh.triangle_count),
                vertex_count: mesh.vertices.size / 12,
                surfaces: [u64::from(self.triangle_count), self.vertex_count as u64],
            };
            return Err(fault.of("the mesh"));
        }
        if self.span_count == 0 {
            self.mesh = Some(mesh.clone());
            return Ok(());
        }
        let from = builder.exponent()?;
        let is_kept = |(other, _): &(Range, Program)| other.is_same(&from);
        if self.mesh.as_ref() != Some(mesh) || !self.program.as_ref().is_some_and(is_kept) {
            self.program = None;
            let program = gpu.checked(|| self.record(gpu, &from, mesh))?;
            self.program = Some((from, program));
            self.mesh = Some(mesh.clone());
        }
        if let Some((_, program)) = &self.program {
            gpu.checked(|| {
                program.encode(frame);
                Ok(())
            })?;
        }
        Ok(())
    }

    fn record(&self, gpu: &Gpu, exponent: &Range, mesh: &Mesh) -> Result<Program, GpuError> {
        let mut recorder = Recorder::default();
        recorder.stage("decide");
        recorder.copy(exponent, &self.exponent);
        recorder.dispatch(
            Kernel::decide_spans,
            &[
                Uniform::Stored(&self.exponent),
                Uniform::Params([0, 0, 0, 0]),
            ],
            &[&mesh.vertices, &self.faces, &self.links, &self.spans],
            &[&self.span_measures],
            groups(self.span_count),
        );
        recorder.dispatch(
            Kernel::decide_components,
            &[],
            &[&self.components, &self.span_measures],
            &[&self.measures],
            groups(self.reducible_count()),
        );
        recorder.finish(gpu)
    }

    /// The component of each triangle.
    #[must_use]
    pub fn components(&self) -> &Components {
        &self.triangle_components
    }

    /// The number of components that may be reduced while they are closed and have an outer side.
    #[must_use]
    pub fn reducible_count(&self) -> u32 {
        self.component_numbers.len() as u32
    }

    /// Bytes of all buffers.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        let ranges = [
            &self.triangle_components.0,
            &self.components,
            &self.spans,
            &self.faces,
            &self.links,
            &self.span_measures,
            &self.measures,
            &self.exponent,
            &self.blocks,
        ];
        ranges.iter().map(|range| range.size).sum()
    }

    /// The work of a measurement.
    #[must_use]
    pub fn work(&self) -> Option<&super::Work> {
        self.program.as_ref()?.1.work().first()
    }

    /// Copies the measures at this point of the frame, to be read when the frame is done. For reports only; no decision
    /// depends on it.
    ///
    /// # Errors
    /// If memory is exhausted.
    pub fn read_later(&self, frame: &mut Frame) -> Result<MeasuresDownload, GpuError> {
        let download = frame.gpu().checked(|| Ok(frame.download(&self.measures)))?;
        Ok(MeasuresDownload {
            numbers: self.component_numbers.clone(),
            download,
        })
    }
}

/// The measures of the components, being copied.
#[derive(Debug)]
#[must_use]
pub struct MeasuresDownload {
    numbers: Vec<u32>,
    download: Download,
}

impl MeasuresDownload {
    /// Waits for the copy, and reads it: one entry for each component that may be reduced.
    ///
    /// # Errors
    /// If the device was lost.
    pub fn read(self, gpu: &Gpu) -> Result<Vec<Measured>, GpuError> {
        gpu.block_on(self.read_async(gpu))
    }

    /// [`Self::read`], without blocking.
    ///
    /// # Errors
    /// If the device was lost; in a browser, also the errors of earlier calls.
    pub async fn read_async(self, gpu: &Gpu) -> Result<Vec<Measured>, GpuError> {
        let measures: Vec<Measure> = self.download.read_async(gpu).await?;
        let measures = self.numbers.into_iter().zip(measures);
        Ok(measures
            .map(|(component, measure)| Measured { component, measure })
            .collect())
    }
}
