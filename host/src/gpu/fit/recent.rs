//! The counts of a set's triangles in the last frames.

use crate::gpu::buffer::Range;
use crate::gpu::{Frame, Gpu, GpuError};
use slimbvh_core::fit::Fit;
use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use wgpu::BufferUsages;

/// Counts that are remembered.
const KEPT: usize = 8;

/// The least memory of a set, in triangles.
const LEAST: u32 = 1024;

/// Counts in a row that show that most memory is idle, before it shrinks: some seconds.
const IDLE: u32 = 256;

/// The counts of a set's triangles, read back without waiting: they arrive a few frames later.
#[derive(Debug, Default)]
pub struct Recent {
    /// Whether anybody asks for counts.
    is_followed: bool,
    /// Each with the number of triangles in the mesh.
    counts: VecDeque<(Fit, u32)>,
    /// Copies of counts, once the host can read them.
    arrived: Arc<Mutex<Vec<Copied>>>,
    /// Counts in a row that need less than half the memory.
    idle: u32,
}

/// The copy of a count.
#[derive(Debug)]
struct Copied {
    buffer: wgpu::Buffer,
    /// Triangles of the mesh.
    most: u32,
    /// The limit, where the count is not that of a [`Fit`].
    limit: Option<u32>,
}

impl Recent {
    /// Records that the count arrives here when the frame is done, if anybody asks for it: that of a [`Fit`], or the first word of a set
    /// with memory for all triangles. The mesh has `most`.
    pub fn read_later(&self, frame: &mut Frame, from: &Range, most: u32, limit: Option<u32>) {
        if !self.is_followed {
            return;
        }
        let size = size_of::<Fit>() as u64;
        let buffer = frame.gpu().device().create_buffer(&wgpu::BufferDescriptor {
            label: Some("slimbvh set count"),
            size,
            usage: BufferUsages::COPY_DST | BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let encoder = frame.encoder();
        encoder.copy_buffer_to_buffer(&from.buffer, from.offset, &buffer, 0, size);
        let arrived = Arc::clone(&self.arrived);
        let copied = Copied {
            buffer: buffer.clone(),
            most,
            limit,
        };
        encoder.map_buffer_on_submit(&buffer, wgpu::MapMode::Read, .., move |result| {
            if result.is_ok() {
                lock(&arrived).push(copied);
            }
        });
    }

    /// Whether counts are asked for.
    pub const fn is_followed(&self) -> bool {
        self.is_followed
    }

    /// Whether counts are on their way, or not read yet.
    pub fn is_waiting(&self) -> bool {
        Arc::strong_count(&self.arrived) > 1 || !lock(&self.arrived).is_empty()
    }

    /// Reads the counts that have arrived. From now on more are asked for, or not.
    pub fn update(&mut self, gpu: &Gpu, is_followed: bool) -> Result<(), GpuError> {
        self.is_followed = is_followed;
        let arrived = std::mem::take(&mut *lock(&self.arrived));
        for copied in arrived {
            let view = copied.buffer.get_mapped_range(..);
            let view = view.map_err(|error| gpu.lost(&error.to_string()))?;
            let fits: Vec<Fit> = bytemuck::pod_collect_to_vec(&view);
            drop(view);
            copied.buffer.unmap();
            for fit in fits {
                let limit = copied.limit.unwrap_or(fit.limit);
                self.add(Fit::new(fit.count, limit), copied.most);
            }
        }
        Ok(())
    }

    fn add(&mut self, fit: Fit, most: u32) {
        self.counts.push_back((fit, most));
        let too_many = self.counts.len().saturating_sub(KEPT);
        self.counts.drain(..too_many);
        let wanted = self.wanted(most).unwrap_or(most);
        let is_idle = u64::from(fit.limit) > 2 * u64::from(wanted);
        self.idle = if is_idle {
            self.idle.saturating_add(1)
        } else {
            0
        };
    }

    /// The latest count, and the limit that it had.
    pub fn latest(&self) -> Option<&Fit> {
        self.counts.back().map(|(fit, _)| fit)
    }

    /// Triangles of the mesh's `most` to have memory for, where there is memory for `present`. Before any count is known, it is half as
    /// much again as the expected share.
    pub fn limit(&self, most: u32, share: f64, present: Option<u32>) -> u32 {
        let wanted = self.wanted(most);
        let (Some(wanted), Some(present)) = (wanted, present) else {
            let expected = with_reserve(share * f64::from(most), most);
            return present.or(wanted).unwrap_or(expected);
        };
        // It changes seldom, as all trees are then built anew: before it is full, and if most of it was idle for long.
        let largest = self.largest(most).unwrap_or(0.0);
        let is_full = 1.125 * largest > f64::from(present) && present < most;
        if is_full || self.idle >= IDLE {
            wanted
        } else {
            present
        }
    }

    /// The memory that the remembered counts ask for.
    fn wanted(&self, most: u32) -> Option<u32> {
        let largest = self.largest(most)?;
        Some(with_reserve(largest, most))
    }

    /// The largest remembered count, as the same share of `most` triangles.
    fn largest(&self, most: u32) -> Option<f64> {
        let scaled = |(fit, of): &(Fit, u32)| {
            f64::from(fit.count) / f64::from((*of).max(1)) * f64::from(most)
        };
        self.counts.iter().map(scaled).reduce(f64::max)
    }
}

/// Half as much again, at most all.
fn with_reserve(count: f64, most: u32) -> u32 {
    let wanted = (1.5 * count).ceil().min(f64::from(most)) as u32;
    wanted.max(LEAST).min(most)
}

fn lock<T>(shared: &Mutex<T>) -> MutexGuard<'_, T> {
    shared.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOST: u32 = 100_000;

    fn after(counts: &[u32], limit: u32) -> Recent {
        let mut recent = Recent::default();
        for &count in counts {
            recent.add(Fit::new(count, limit), MOST);
        }
        recent
    }

    #[test]
    fn the_expected_share_counts_until_a_count_is_known() {
        let none = Recent::default();
        assert_eq!(none.limit(MOST, 0.3, None), 45_000);
        assert_eq!(none.limit(MOST, 0.3, Some(50_000)), 50_000);
        assert_eq!(none.limit(MOST, 0.9, None), MOST);
        assert_eq!(none.limit(MOST, 0.0, None), LEAST);
        assert_eq!(none.limit(7, 0.5, None), 7);
    }

    #[test]
    fn memory_grows_before_it_is_full_and_shrinks_when_it_was_idle_for_long() {
        let limit = |counts: &[u32]| after(counts, 20_000).limit(MOST, 0.5, Some(20_000));
        assert_eq!(limit(&[17_000]), 20_000);
        assert_eq!(limit(&[18_000]), 27_000);
        assert_eq!(limit(&[30_000]), 45_000);
        assert_eq!(limit(&[90_000]), MOST);
        // The largest of all that are remembered counts.
        assert_eq!(limit(&[30_000, 10_000]), 45_000);
        let idle = IDLE as usize;
        assert_eq!(limit(&vec![4_000; idle - 1]), 20_000);
        assert_eq!(limit(&vec![4_000; idle]), 6_000);
        assert_eq!(limit(&vec![7_000; 2 * idle]), 20_000);
        let mut looked_back = vec![4_000; idle - 1];
        looked_back.extend([7_000, 4_000, 4_000]);
        assert_eq!(limit(&looked_back), 20_000);
    }

    #[test]
    fn memory_for_all_is_no_state_for_ever() {
        let all = |counts: &[u32]| after(counts, MOST).limit(MOST, 0.5, Some(MOST));
        assert_eq!(all(&[MOST]), MOST);
        assert_eq!(all(&[10_000]), MOST);
        assert_eq!(all(&vec![10_000; IDLE as usize]), 15_000);
    }

    #[test]
    fn counts_of_another_mesh_count_as_shares() {
        let recent = after(&[10_000], 15_000);
        assert_eq!(recent.limit(10 * MOST, 0.5, None), 150_000);
        assert_eq!(recent.limit(MOST / 10, 0.5, None), 1500);
    }
}
