//! The counts of a set's triangles in the last frames.

use crate::gpu::buffer::Range;
use crate::gpu::{Frame, Gpu, GpuError};
use slimbvh_core::fit::Fit;
use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};
use wgpu::BufferUsages;

/// Counts that are remembered.
const KEPT: usize = 8;

/// The least memory of a set, in triangles.
const LEAST: u32 = 1024;

/// Copies of counts, once the host can read them.
type Arrived = Arc<Mutex<Vec<wgpu::Buffer>>>;

/// The counts of a set's triangles, read back without waiting: they arrive a few frames later.
#[derive(Debug, Default)]
pub struct Recent {
    counts: VecDeque<Fit>,
    /// Triangles of the mesh that they are of.
    most: u32,
    arrived: Arrived,
}

impl Recent {
    /// Records that the count arrives here when the frame is done.
    pub fn read_later(&self, frame: &mut Frame, fit: &Range) {
        let copy = frame.gpu().device().create_buffer(&wgpu::BufferDescriptor {
            label: Some("slimbvh set count"),
            size: fit.size,
            usage: BufferUsages::COPY_DST | BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let encoder = frame.encoder();
        encoder.copy_buffer_to_buffer(&fit.buffer, fit.offset, &copy, 0, fit.size);
        let (arrived, mapped) = (Arc::clone(&self.arrived), copy.clone());
        encoder.map_buffer_on_submit(&copy, wgpu::MapMode::Read, .., move |result| {
            if result.is_ok() {
                let mut arrived = arrived.lock().unwrap_or_else(PoisonError::into_inner);
                arrived.push(mapped);
            }
        });
    }

    /// Whether counts are on their way, or not read yet.
    pub fn is_waiting(&self) -> bool {
        let is_read = self.arrived.lock().unwrap_or_else(PoisonError::into_inner);
        Arc::strong_count(&self.arrived) > 1 || !is_read.is_empty()
    }

    /// Reads the counts that have arrived. Forgets all before, if they are those of a mesh of another size.
    pub fn update(&mut self, gpu: &Gpu, most: u32) -> Result<(), GpuError> {
        if self.most != most {
            *self = Self {
                most,
                ..Self::default()
            };
        }
        let arrived = {
            let mut arrived = self.arrived.lock().unwrap_or_else(PoisonError::into_inner);
            std::mem::take(&mut *arrived)
        };
        for copy in arrived {
            let view = copy.get_mapped_range(..);
            let view = view.map_err(|error| gpu.lost(&error.to_string()))?;
            let fits: Vec<Fit> = bytemuck::pod_collect_to_vec(&view);
            drop(view);
            copy.unmap();
            self.counts.extend(fits);
        }
        let too_many = self.counts.len().saturating_sub(KEPT);
        self.counts.drain(..too_many);
        Ok(())
    }

    /// The latest count, and whether the set fitted.
    pub fn latest(&self) -> Option<&Fit> {
        self.counts.back()
    }

    /// Triangles of the mesh's `most` to have memory for. Before any count is known, it is half as much again as the expected share.
    pub fn limit(&self, most: u32, share: f64, present: Option<u32>) -> u32 {
        let with_reserve = |count: f64| (1.5 * count).ceil().min(f64::from(most)) as u32;
        let within = |limit: u32| limit.max(LEAST).min(most);
        let largest = self.counts.iter().map(|fit| fit.count).max();
        match (largest, present) {
            (None, None) => within(with_reserve(share * f64::from(most))),
            (None, Some(present)) => within(present),
            (Some(largest), present) => {
                let wanted = within(with_reserve(largest.into()));
                // It changes seldom, as all trees are then built anew: before it is full, and if most of it is not needed.
                let is_full = |present: u32| largest.saturating_add(largest / 8) > present;
                let is_idle = |present: u32| {
                    self.counts.len() == KEPT && u64::from(present) > 2 * u64::from(wanted)
                };
                let kept = present.filter(|&present| !is_full(present) && !is_idle(present));
                kept.map_or(wanted, within)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn after(counts: &[u32]) -> Recent {
        Recent {
            counts: counts.iter().map(|&count| Fit::new(count, 0)).collect(),
            ..Recent::default()
        }
    }

    #[test]
    fn the_expected_share_counts_until_a_count_is_known() {
        let none = after(&[]);
        assert_eq!(none.limit(100_000, 0.3, None), 45_000);
        assert_eq!(none.limit(100_000, 0.3, Some(50_000)), 50_000);
        assert_eq!(none.limit(100_000, 0.9, None), 100_000);
        assert_eq!(none.limit(100_000, 0.0, None), LEAST);
        assert_eq!(none.limit(7, 0.5, None), 7);
    }

    #[test]
    fn memory_grows_before_it_is_full_and_shrinks_when_most_of_it_is_idle() {
        let limit = |counts: &[u32]| after(counts).limit(100_000, 0.5, Some(20_000));
        assert_eq!(limit(&[17_000]), 20_000);
        assert_eq!(limit(&[18_000]), 27_000);
        assert_eq!(limit(&[30_000]), 45_000);
        assert_eq!(limit(&[90_000]), 100_000);
        // The largest of all that are remembered counts.
        assert_eq!(limit(&[30_000, 10_000]), 45_000);
        assert_eq!(limit(&[4_000; KEPT - 1]), 20_000);
        assert_eq!(limit(&[4_000; KEPT]), 6_000);
        assert_eq!(limit(&[7_000; KEPT]), 20_000);
    }
}
