//! Timestamps at the beginning and the end of each pass, if the adapter has them.

use super::buffer::Mapped;
use super::{Gpu, GpuError};
use crate::Stages;
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

/// The number of passes that are timed in a frame; later ones are not.
const PASSES: u32 = 1024;
const QUERIES: u32 = 2 * PASSES;

/// The queries of a frame.
#[derive(Debug)]
pub struct Timer {
    queries: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    readable: wgpu::Buffer,
    stages: Vec<&'static str>,
}

/// Idle timers. `None` if the device has no timestamps.
#[derive(Debug)]
pub struct TimerPool {
    has_timestamps: bool,
    free: Mutex<Vec<Timer>>,
}

impl TimerPool {
    pub fn new(device: &wgpu::Device) -> Self {
        Self {
            has_timestamps: device.features().contains(wgpu::Features::TIMESTAMP_QUERY),
            free: Mutex::default(),
        }
    }

    pub fn take(&self, device: &wgpu::Device) -> Option<Timer> {
        if !self.has_timestamps {
            return None;
        }
        let free = self.free().pop();
        Some(free.unwrap_or_else(|| Timer::new(device)))
    }

    /// Returns a timer to the pool.
    pub fn give_back(&self, mut timer: Timer) {
        timer.stages.clear();
        self.free().push(timer);
    }

    fn free(&self) -> std::sync::MutexGuard<'_, Vec<Timer>> {
        self.free.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Timer {
    fn new(device: &wgpu::Device) -> Self {
        let buffer = |label, usage| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: u64::from(QUERIES) * u64::from(wgpu::QUERY_SIZE),
                usage,
                mapped_at_creation: false,
            })
        };
        Self {
            queries: device.create_query_set(&wgpu::QuerySetDescriptor {
                label: Some("slimbvh timestamps"),
                ty: wgpu::QueryType::Timestamp,
                count: QUERIES,
            }),
            resolved: buffer(
                "slimbvh timestamps",
                wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC,
            ),
            readable: buffer(
                "slimbvh timestamps to read",
                wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            ),
            stages: Vec::new(),
        }
    }

    /// The queries of one more pass.
    pub fn pass(&mut self, stage: &'static str) -> Option<wgpu::ComputePassTimestampWrites<'_>> {
        let first = 2 * self.stages.len() as u32;
        if first >= QUERIES {
            return None;
        }
        self.stages.push(stage);
        Some(wgpu::ComputePassTimestampWrites {
            query_set: &self.queries,
            beginning_of_pass_write_index: Some(first),
            end_of_pass_write_index: Some(first + 1),
        })
    }

    /// Records that the times are made readable.
    pub fn resolve(&self, encoder: &mut wgpu::CommandEncoder) {
        let count = 2 * self.stages.len() as u32;
        if count > 0 {
            encoder.resolve_query_set(&self.queries, 0..count, &self.resolved, 0);
            let bytes = u64::from(count) * u64::from(wgpu::QUERY_SIZE);
            encoder.copy_buffer_to_buffer(&self.resolved, 0, &self.readable, 0, bytes);
        }
    }

    /// The times of a finished frame. Returns the timer to its pool.
    pub async fn read(self, gpu: &Gpu) -> Result<Stages, GpuError> {
        let mut stages = Stages::default();
        if !self.stages.is_empty() {
            let ticks: Vec<u64> = Mapped::new(gpu, self.readable.clone()).await?.read()?;
            let period = f64::from(gpu.queue().get_timestamp_period());
            for (&stage, pass) in self.stages.iter().zip(ticks.chunks_exact(2)) {
                let nanoseconds = pass[1].saturating_sub(pass[0]) as f64 * period;
                stages.add(stage, Duration::from_nanos(nanoseconds as u64));
            }
        }
        gpu.timers.give_back(self);
        Ok(stages)
    }
}
