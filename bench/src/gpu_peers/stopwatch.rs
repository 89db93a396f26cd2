//! The time of the peers' passes, by the same timestamps as slimbvh's stages.

use anyhow::{Context, Result};
use slimbvh::gpu::wgpu;
use std::sync::mpsc;
use std::time::Duration;

/// Timestamps at the beginning and the end of passes.
#[derive(Debug)]
pub struct Stopwatch {
    queries: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    readable: wgpu::Buffer,
    pass_count: u32,
}

impl Stopwatch {
    /// For this many passes a frame. `None` if the device has no timestamps.
    #[must_use]
    pub fn new(device: &wgpu::Device, pass_count: u32) -> Option<Self> {
        if !device.features().contains(wgpu::Features::TIMESTAMP_QUERY) {
            return None;
        }
        let buffer = |label, usage| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: u64::from(2 * pass_count) * u64::from(wgpu::QUERY_SIZE),
                usage,
                mapped_at_creation: false,
            })
        };
        Some(Self {
            queries: device.create_query_set(&wgpu::QuerySetDescriptor {
                label: Some("peer timestamps"),
                ty: wgpu::QueryType::Timestamp,
                count: 2 * pass_count,
            }),
            resolved: buffer(
                "peer timestamps",
                wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC,
            ),
            readable: buffer(
                "peer timestamps to read",
                wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            ),
            pass_count,
        })
    }

    /// The timestamps of the pass with this number.
    ///
    /// # Panics
    /// If there are fewer passes.
    #[must_use]
    pub fn pass(&self, number: u32) -> wgpu::ComputePassTimestampWrites<'_> {
        assert!(number < self.pass_count, "there is no pass {number}");
        wgpu::ComputePassTimestampWrites {
            query_set: &self.queries,
            beginning_of_pass_write_index: Some(2 * number),
            end_of_pass_write_index: Some(2 * number + 1),
        }
    }

    /// Records that the times of all passes are made readable.
    pub fn resolve(&self, encoder: &mut wgpu::CommandEncoder) {
        let bytes = self.readable.size();
        encoder.resolve_query_set(&self.queries, 0..2 * self.pass_count, &self.resolved, 0);
        encoder.copy_buffer_to_buffer(&self.resolved, 0, &self.readable, 0, bytes);
    }

    /// The time of each pass, once the frame is done.
    ///
    /// # Errors
    /// If the device was lost.
    pub fn read(&self, device: &wgpu::Device, queue: &wgpu::Queue) -> Result<Vec<Duration>> {
        let (sender, receiver) = mpsc::channel();
        self.readable
            .map_async(wgpu::MapMode::Read, .., move |mapped| {
                // The receiver waits below.
                let _ = sender.send(mapped);
            });
        device.poll(wgpu::PollType::wait_indefinitely())?;
        receiver.recv().context("the driver did not answer")??;
        let period = f64::from(queue.get_timestamp_period());
        let times = {
            let bytes = self.readable.get_mapped_range(..)?;
            let ticks: Vec<u64> = bytemuck::pod_collect_to_vec(&bytes);
            let time = |pass: &[u64]| {
                let nanoseconds = pass[1].saturating_sub(pass[0]) as f64 * period;
                Duration::from_nanos(nanoseconds as u64)
            };
            ticks.chunks_exact(2).map(time).collect()
        };
        self.readable.unmap();
        Ok(times)
    }
}
