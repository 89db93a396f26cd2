//! The sections by name.

use crate::session::Session;
use crate::{builds, large, parity, peers, stages, traces};
use anyhow::Result;

/// A part of the laboratory that can be run alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Section {
    /// Answers against the CPU's.
    Parity,
    /// Rates of rays in scenes that fit a cache.
    Rays,
    /// Times of a picture's stages.
    Stages,
    /// Times of builds.
    Builds,
    /// Rates beside peers.
    Peers,
    /// Scenes that fit no cache.
    Large,
}

impl Section {
    /// All, in the order in which they are run.
    pub const ALL: [Self; 6] = [
        Self::Parity,
        Self::Rays,
        Self::Stages,
        Self::Builds,
        Self::Peers,
        Self::Large,
    ];

    /// The name in options and tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Parity => "parity",
            Self::Rays => "rays",
            Self::Stages => "stages",
            Self::Builds => "builds",
            Self::Peers => "peers",
            Self::Large => "large",
        }
    }

    /// The section with this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|section| section.name() == name)
    }

    /// Measures, and prints rows.
    pub fn run(self, session: &mut Session) -> Result<()> {
        match self {
            Self::Parity => parity::run(session),
            Self::Rays => traces::run(session),
            Self::Stages => stages::run(session),
            Self::Builds => builds::run(session),
            Self::Peers => peers::run(session),
            Self::Large => large::run(session),
        }
    }
}
