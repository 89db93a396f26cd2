//! Programs: dispatches that are recorded once and encoded into every frame.

use super::buffer::{ALIGNMENT, Range, upload};
use super::work::{Traffic, Work};
use super::{Frame, Gpu, Kernel};
use crate::Stages;
use slimbvh_core::launch::{LANES, dispatch};
use std::sync::{Mutex, PoisonError};

/// The number of workgroups of a dispatch.
#[derive(Clone, Debug)]
pub enum Groups {
    /// Known when recording.
    Direct([u32; 3]),
    /// Three numbers that the GPU stores before.
    Indirect(Range),
}

/// Enough workgroups for a thread an item.
pub fn threads(item_count: u32) -> Groups {
    Groups::Direct(dispatch(item_count.div_ceil(LANES as u32)))
}

/// This many workgroups.
pub fn groups(group_count: u32) -> Groups {
    Groups::Direct(dispatch(group_count))
}

/// A uniform: parameters known when recording, or a kernel's result.
#[derive(Clone, Copy, Debug)]
pub enum Uniform<'a> {
    /// Four numbers.
    Params([u32; 4]),
    /// Sixteen bytes or more of a buffer.
    Stored(&'a Range),
}

enum Bound {
    Params(u64),
    Range(Range),
}

enum Step<D> {
    /// The steps that follow belong to this stage.
    Stage(&'static str),
    Dispatch(D),
    Copy(Range, Range),
    Clear(Range),
    /// Copies parameters, from this offset, to a range.
    Write(u64, Range),
    /// The caller encodes its own commands here; the number identifies them.
    Callback(usize),
}

struct Call {
    kernel: Kernel,
    bindings: Vec<Bound>,
    groups: Groups,
}

struct Dispatch {
    pipeline: wgpu::ComputePipeline,
    bind_group: wgpu::BindGroup,
    groups: Groups,
}

/// An access of a range by a stage.
struct Access {
    stage: usize,
    range: Range,
    is_write: bool,
}

/// Records a [`Program`].
#[derive(Default)]
pub struct Recorder {
    steps: Vec<Step<Call>>,
    params: Vec<u8>,
    work: Vec<Work>,
    accesses: Vec<Access>,
}

impl Recorder {
    /// Begins a stage.
    pub fn stage(&mut self, stage: &'static str) {
        self.steps.push(Step::Stage(stage));
        self.work.push(Work {
            stage,
            ..Work::default()
        });
    }

    /// Records a dispatch with ranges to read and to write. Bindings are numbered in this order.
    pub fn dispatch(
        &mut self,
        kernel: Kernel,
        uniforms: &[Uniform],
        reads: &[&Range],
        writes: &[&Range],
        groups: Groups,
    ) {
        for (ranges, is_write) in [(reads, false), (writes, true)] {
            for range in ranges {
                self.access(range, is_write);
            }
        }
        if let Some(work) = self.work.last_mut() {
            work.dispatch_count += 1;
        }
        let uniforms = uniforms.iter().map(|uniform| match uniform {
            Uniform::Stored(range) => Bound::Range((*range).clone()),
            Uniform::Params(params) => Bound::Params(push_params(&mut self.params, params)),
        });
        let ranges = reads.iter().chain(writes);
        let ranges = ranges.map(|&range| Bound::Range(range.clone()));
        let bindings = uniforms.chain(ranges).collect();
        self.steps.push(Step::Dispatch(Call {
            kernel,
            bindings,
            groups,
        }));
    }

    /// Records a dispatch that also reads the ranges that it writes.
    pub fn update(
        &mut self,
        kernel: Kernel,
        uniforms: &[Uniform],
        reads: &[&Range],
        updates: &[&Range],
        groups: Groups,
    ) {
        for range in updates {
            self.access(range, false);
        }
        self.dispatch(kernel, uniforms, reads, updates, groups);
    }

    /// Notes that the next dispatch also reads this range, which it writes.
    pub fn read(&mut self, range: &Range) {
        self.access(range, false);
    }

    fn access(&mut self, range: &Range, is_write: bool) {
        if let Some(work) = self.work.last_mut() {
            let traffic = if is_write {
                &mut work.written
            } else {
                &mut work.read
            };
            *traffic += range.traffic;
            self.accesses.push(Access {
                stage: self.work.len() - 1,
                range: range.clone(),
                is_write,
            });
        }
    }

    /// Records a copy.
    pub fn copy(&mut self, from: &Range, to: &Range) {
        self.steps.push(Step::Copy(from.clone(), to.clone()));
    }

    /// Records that a range be zeroed.
    pub fn clear(&mut self, range: &Range) {
        self.steps.push(Step::Clear(range.clone()));
    }

    /// Records a callback: the caller encodes its own commands here.
    pub fn callback(&mut self, id: usize) {
        self.steps.push(Step::Callback(id));
    }

    /// Records a write of words to the beginning of a range.
    pub fn write(&mut self, to: &Range, words: &[u32]) {
        let mut first = 0;
        for words in words.chunks(4) {
            let mut params = [0; 4];
            params[..words.len()].copy_from_slice(words);
            let size = size_of_val(words) as u64;
            let offset = push_params(&mut self.params, &params);
            self.steps.push(Step::Write(offset, to.part(first, size)));
            first += size;
        }
    }

    /// Compiles missing kernels, and creates all bindings.
    pub fn finish(self, gpu: &Gpu) -> Result<Program, super::GpuError> {
        let params = (!self.params.is_empty()).then(|| {
            upload(
                gpu,
                "slimbvh parameters",
                wgpu::BufferUsages::UNIFORM,
                &self.params,
            )
        });
        let mut compiling = Stages::default();
        let mut steps = Vec::with_capacity(self.steps.len());
        for step in self.steps {
            steps.push(match step {
                Step::Stage(stage) => Step::Stage(stage),
                Step::Copy(from, to) => Step::Copy(from, to),
                Step::Clear(range) => Step::Clear(range),
                Step::Write(offset, to) => Step::Write(offset, to),
                Step::Callback(id) => Step::Callback(id),
                Step::Dispatch(call) => {
                    Step::Dispatch(bind(gpu, params.as_ref(), call, &mut compiling)?)
                }
            });
        }
        let mut work = self.work;
        for (stage, work) in work.iter_mut().enumerate() {
            work.least = least(stage, &self.accesses);
        }
        Ok(Program {
            steps,
            params,
            work,
            compiling: Mutex::new(compiling),
        })
    }
}

/// The least traffic of a stage: the ranges that it reads from earlier stages, and those that it leaves for later stages or
/// the caller.
fn least(stage: usize, accesses: &[Access]) -> Traffic {
    let own = |access: &&Access| access.stage == stage;
    let mut inputs: Vec<&Range> = Vec::new();
    let mut outputs: Vec<&Range> = Vec::new();
    for (i, access) in accesses
        .iter()
        .enumerate()
        .filter(|(_, a)| a.stage == stage)
    {
        let is_same = |other: &&Access| other.range.is_same(&access.range);
        if access.is_write {
            let is_read_later = |other: &&Access| !other.is_write && other.stage > stage;
            let for_later = accesses[i..]
                .iter()
                .filter(is_same)
                .any(|a| is_read_later(&a));
            let in_stage = accesses[i..].iter().filter(own).filter(is_same);
            let for_itself = in_stage.into_iter().any(|other| !other.is_write);
            if (for_later || !for_itself)
                && !outputs.iter().any(|other| other.is_same(&access.range))
            {
                outputs.push(&access.range);
            }
        } else {
            let mut before = accesses[..i].iter().filter(own).filter(is_same);
            if !before.any(|other| other.is_write)
                && !inputs.iter().any(|other| other.is_same(&access.range))
            {
                inputs.push(&access.range);
            }
        }
    }
    let mut least = Traffic::default();
    for range in inputs.into_iter().chain(outputs) {
        least += range.whole_traffic();
    }
    least
}

/// Stores parameters at an offset that a uniform may have, and returns the offset.
fn push_params(bytes: &mut Vec<u8>, params: &[u32; 4]) -> u64 {
    let offset = bytes.len().next_multiple_of(ALIGNMENT as usize);
    bytes.resize(offset, 0);
    bytes.extend_from_slice(bytemuck::bytes_of(params));
    offset as u64
}

fn bind(
    gpu: &Gpu,
    params: Option<&wgpu::Buffer>,
    call: Call,
    compiling: &mut Stages,
) -> Result<Dispatch, super::GpuError> {
    let pipeline = gpu.pipeline_in(call.kernel, compiling)?;
    let entries = call
        .bindings
        .iter()
        .zip(0..)
        .filter_map(|(bound, binding)| {
            let buffer = match bound {
                Bound::Range(range) => range.binding(),
                Bound::Params(offset) => wgpu::BufferBinding {
                    buffer: params?,
                    offset: *offset,
                    size: wgpu::BufferSize::new(size_of::<[u32; 4]>() as u64),
                },
            };
            Some(wgpu::BindGroupEntry {
                binding,
                resource: wgpu::BindingResource::Buffer(buffer),
            })
        });
    let entries: Vec<_> = entries.collect();
    let bind_group = gpu.device().create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some(call.kernel.name()),
        layout: &pipeline.get_bind_group_layout(0),
        entries: &entries,
    });
    Ok(Dispatch {
        pipeline,
        bind_group,
        groups: call.groups,
    })
}

/// Commands with all bindings, ready for any number of frames.
pub struct Program {
    steps: Vec<Step<Dispatch>>,
    params: Option<wgpu::Buffer>,
    work: Vec<Work>,
    /// Stage `compile`, for the first frame.
    compiling: Mutex<Stages>,
}

impl std::fmt::Debug for Program {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.debug_list().entries(&self.work).finish()
    }
}

impl Program {
    /// Encodes all commands into a frame: one pass for each stage.
    pub fn encode(&self, frame: &mut Frame) {
        // Only a callback can fail.
        let _ = self.encode_with(frame, &mut |_, _| Ok(()));
    }

    /// Encodes all commands into a frame, and runs the callback for the caller's own.
    ///
    /// # Errors
    /// Those of the callback.
    pub fn encode_with<'g>(
        &self,
        frame: &mut Frame<'g>,
        callback: &mut dyn FnMut(&mut Frame<'g>, usize) -> Result<(), super::GpuError>,
    ) -> Result<(), super::GpuError> {
        frame.compiled(&self.take_compiling());
        let mut stage = "slimbvh";
        let mut pass: Option<wgpu::ComputePass> = None;
        for step in &self.steps {
            match step {
                Step::Stage(name) => {
                    pass = None;
                    stage = name;
                }
                Step::Dispatch(dispatch) => {
                    let pass = pass.get_or_insert_with(|| frame.pass(stage));
                    pass.set_pipeline(&dispatch.pipeline);
                    pass.set_bind_group(0, &dispatch.bind_group, &[]);
                    match &dispatch.groups {
                        Groups::Direct([x, y, z]) => pass.dispatch_workgroups(*x, *y, *z),
                        Groups::Indirect(range) => {
                            pass.dispatch_workgroups_indirect(&range.buffer, range.offset);
                        }
                    }
                }
                Step::Copy(from, to) => {
                    pass = None;
                    frame.encoder().copy_buffer_to_buffer(
                        &from.buffer,
                        from.offset,
                        &to.buffer,
                        to.offset,
                        from.size,
                    );
                }
                Step::Write(offset, to) => {
                    pass = None;
                    if let Some(params) = &self.params {
                        frame
                            .encoder()
                            .copy_buffer_to_buffer(params, *offset, &to.buffer, to.offset, to.size);
                    }
                }
                Step::Clear(range) => {
                    pass = None;
                    frame
                        .encoder()
                        .clear_buffer(&range.buffer, range.offset, Some(range.size));
                }
                Step::Callback(id) => {
                    drop(pass.take());
                    callback(frame, *id)?;
                }
            }
        }
        Ok(())
    }

    fn take_compiling(&self) -> Stages {
        let mut compiling = self
            .compiling
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        std::mem::take(&mut *compiling)
    }

    /// The work of each stage.
    pub fn work(&self) -> &[Work] {
        &self.work
    }
}
