//! The measurements of a frame.

use slimbvh::animate::Action;
use slimbvh::{Backend, FrameReport, RenderReport, Stages};
use std::time::Duration;

/// One frame: sums over the pictures of an open shutter.
#[derive(Debug, Default)]
pub struct Record {
    /// How many trees were rebuilt, refitted and kept.
    pub actions: Actions,
    /// Time to move camera, lights and vertices.
    pub pose: Duration,
    pub build: Stages,
    pub report: RenderReport,
    /// The latest tree's cost by the surface area heuristic, if it is known.
    pub cost: Option<f64>,
    /// Wall-clock time of the frame, without writing it.
    pub total: Duration,
    pub write: Duration,
}

/// The number of rebuilds, of refits, and of pictures whose tree was kept.
#[derive(Clone, Copy, Debug, Default)]
pub struct Actions {
    pub rebuilt: usize,
    pub refitted: usize,
    pub kept: usize,
}

impl Actions {
    /// The most expensive action that occurred.
    pub fn most(&self) -> Action {
        match (self.rebuilt, self.refitted) {
            (0, 0) => Action::Kept,
            (0, _) => Action::Refitted,
            _ => Action::Rebuilt,
        }
    }
}

/// Times of a frame in milliseconds: a row of the table.
#[derive(Clone, Copy, Debug)]
pub struct Times {
    pub pose: f64,
    pub build: f64,
    pub trace: f64,
    pub shade: f64,
    pub total: f64,
}

impl Record {
    /// Adds a picture of the frame.
    pub fn add<B: Backend>(&mut self, pose: Duration, done: &FrameReport<B>) {
        match done.action {
            Action::Rebuilt => self.actions.rebuilt += 1,
            Action::Refitted => self.actions.refitted += 1,
            Action::Kept => self.actions.kept += 1,
        }
        self.pose += pose;
        self.build.merge(&done.build);
        add_report(&mut self.report, &done.render);
        self.cost = done.sah_cost;
    }

    pub fn times(&self) -> Times {
        let render = &self.report.stages;
        let traced = render
            .iter()
            .filter(|(stage, _)| stage.starts_with("trace"));
        let trace: Duration = traced.map(|(_, time)| time).sum();
        Times {
            pose: ms(self.pose),
            build: ms(self.build.total()),
            trace: ms(trace),
            shade: ms(render.total().saturating_sub(trace)),
            total: ms(self.total),
        }
    }
}

impl Times {
    /// Applies `pick` to each column.
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

/// The largest time of a column.
pub fn worst(column: &mut [f64]) -> f64 {
    column.iter().copied().fold(0.0, f64::max)
}

/// Sums over all frames.
#[derive(Debug, Default)]
pub struct Sums {
    pub actions: Actions,
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
            sums.actions.rebuilt += record.actions.rebuilt;
            sums.actions.refitted += record.actions.refitted;
            sums.actions.kept += record.actions.kept;
            add_report(&mut sums.report, &record.report);
            sums.build.merge(&record.build);
            sums.pose += record.pose;
            sums.total += record.total;
            sums.write += record.write;
        }
        sums
    }
}

fn add_report(sum: &mut RenderReport, report: &RenderReport) {
    sum.stages.merge(&report.stages);
    sum.primary_ray_count += report.primary_ray_count;
    sum.primary_hit_count += report.primary_hit_count;
    sum.shadow_ray_count += report.shadow_ray_count;
    sum.mirror_ray_count += report.mirror_ray_count;
}

/// A time in milliseconds.
pub fn ms(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}
