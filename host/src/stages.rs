//! The time of each stage of a frame.

use crate::Stopwatch;
use std::fmt;
use std::time::Duration;

/// Times by stage, in the order in which the stages ran. Without a clock ([`Stopwatch`]) only a GPU's stages have times.
#[derive(Clone, Debug, Default)]
pub struct Stages(Vec<(&'static str, Duration)>);

impl Stages {
    /// Runs a stage and adds its time to the stage's entry.
    pub fn time<R>(&mut self, stage: &'static str, run: impl FnOnce() -> R) -> R {
        let begin = Stopwatch::start();
        let result = run();
        self.add(stage, begin.elapsed());
        result
    }

    /// Adds a time to a stage's entry.
    pub fn add(&mut self, stage: &'static str, time: Duration) {
        match self.0.iter_mut().find(|(name, _)| *name == stage) {
            Some((_, sum)) => *sum += time,
            None => self.0.push((stage, time)),
        }
    }

    /// Adds all times of another run.
    pub fn merge(&mut self, other: &Self) {
        for (stage, time) in other.iter() {
            self.add(stage, time);
        }
    }

    /// The stages and their times.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, Duration)> + '_ {
        self.0.iter().copied()
    }

    /// The sum of all times.
    #[must_use]
    pub fn total(&self) -> Duration {
        self.0.iter().map(|&(_, time)| time).sum()
    }
}

impl fmt::Display for Stages {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        for (i, (stage, time)) in self.iter().enumerate() {
            let separator = if i == 0 { "" } else { " · " };
            write!(f, "{separator}{stage}")?;
            if Stopwatch::HAS_CLOCK || !time.is_zero() {
                write!(f, " {:.2} ms", time.as_secs_f64() * 1e3)?;
            }
        }
        Ok(())
    }
}
