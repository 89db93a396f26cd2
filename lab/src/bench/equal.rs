//! Setups that do the very same work as another, and so are not measured twice.

use super::prepared::Prepared;
use super::setup::{Knob, Setup, Update};
use anyhow::Result;
use serde::Serialize;
use slimbvh::BuildConfig;
use slimbvh::reduce::{Plan, Reduce, Savings};

/// A setup that is measured under another's name.
#[derive(Clone, Debug, Serialize)]
pub struct Equal {
    pub scene: String,
    pub backend: &'static str,
    pub knob: Knob,
    pub setup: String,
    /// The name of the setup that does the same work, and was measured.
    pub measured_as: String,
    /// Both setups.
    #[serde(skip)]
    pub setups: [Setup; 2],
}

/// All that the time and the picture of a setup depend on, in one scene.
pub struct Work {
    config: BuildConfig,
    update: Update,
    threads: usize,
    plan: Plan,
}

impl Work {
    pub fn new(prepared: &Prepared) -> Result<Self> {
        Ok(Self {
            config: prepared.config,
            update: prepared.setup.update,
            threads: prepared.setup.threads,
            plan: prepared.plan(Savings::ALL)?,
        })
    }

    /// Whether the other setup builds the same trees in the same way, for the same rays.
    pub fn is_same(&self, other: &Self) -> bool {
        let (own, its) = (&self.plan, &other.plan);
        (self.config, self.update, self.threads) == (other.config, other.update, other.threads)
            && own.topology.is_some() == its.topology.is_some()
            && own.sets == its.sets
            && own.needs_whole == its.needs_whole
            && own.sorts_alone == its.sorts_alone
            && own.defers_lights == its.defers_lights
            // Only with reduction on are deferred sets built that no ray needs.
            && (!own.defers_lights || (own.reduce == Reduce::On) == (its.reduce == Reduce::On))
    }
}

/// Finds the setup that was measured in place of another.
pub fn known_as(all: &[Equal]) -> impl Fn(Setup) -> Setup {
    move |setup| {
        let same = all.iter().find(|it| it.setups[0] == setup);
        same.map_or(setup, |it| it.setups[1])
    }
}
