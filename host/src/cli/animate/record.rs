//! What a frame did.

use super::machine::Done;
use slimbvh::animate::Action;
use slimbvh::{RenderReport, Stages};
use std::time::Duration;

/// One frame.
#[derive(Debug)]
pub struct Record {
    pub action: Action,
    /// Camera, lights and vertices were moved.
    pub pose: Duration,
    pub done: Done,
    /// All of the frame by the clock, without writing it.
    pub total: Duration,
    pub write: Duration,
}

/// Times of a frame in milliseconds, as a table shows them.
#[derive(Clone, Copy, Debug)]
pub struct Times {
    pub pose: f64,
    pub build: f64,
    pub trace: f64,
    pub shade: f64,
    pub total: f64,
}

impl Record {
    pub fn times(&self) -> Times {
        let render = &self.done.report.stages;
        let traced = render
            .iter()
            .filter(|(stage, _)| stage.starts_with("trace"));
        let trace: Duration = traced.map(|(_, time)| time).sum();
        Times {
            pose: ms(self.pose),
            build: ms(self.done.build.total()),
            trace: ms(trace),
            shade: ms(render.total().saturating_sub(trace)),
            total: ms(self.total),
        }
    }
}

impl Times {
    /// What `pick` takes from the times of each column.
    pub fn by_column(all: &[Self], pick: impl Fn(&mut [f64]) -> f64) -> Self {
        let column = |of: fn(&Self) -> f64| {
            let mut column: Vec<f64> = all.iter().map(of).collect();
            pick(&mut column)
        };
        Self {
            pose: column(|times| times.pose),
            build: column(|times| times.build),
            trace: column(|times| times.trace),
            shade: column(|times| times.shade),
            total: column(|times| times.total),
        }
    }
}

/// The middle one, the greater of two.
pub fn median(column: &mut [f64]) -> f64 {
    column.sort_unstable_by(f64::total_cmp);
    column.get(column.len() / 2).copied().unwrap_or(0.0)
}

/// The largest one.
pub fn worst(column: &mut [f64]) -> f64 {
    column.iter().copied().fold(0.0, f64::max)
}

/// All frames together.
#[derive(Debug, Default)]
pub struct Sums {
    pub rebuilt: usize,
    pub refitted: usize,
    pub kept: usize,
    pub pose: Duration,
    pub build: Stages,
    pub report: RenderReport,
    pub total: Duration,
    pub write: Duration,
}

impl Sums {
    pub fn of(records: &[Record]) -> Self {
        let mut sums = Self::default();
        for record in records {
            match record.action {
                Action::Rebuilt => sums.rebuilt += 1,
                Action::Refitted => sums.refitted += 1,
                Action::Kept => sums.kept += 1,
            }
            let (sum, report) = (&mut sums.report, &record.done.report);
            sum.stages.merge(&report.stages);
            sum.primary_ray_count += report.primary_ray_count;
            sum.primary_hit_count += report.primary_hit_count;
            sum.shadow_ray_count += report.shadow_ray_count;
            sum.mirror_ray_count += report.mirror_ray_count;
            sums.build.merge(&record.done.build);
            sums.pose += record.pose;
            sums.total += record.total;
            sums.write += record.write;
        }
        sums
    }
}

/// A time in milliseconds.
pub fn ms(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}
