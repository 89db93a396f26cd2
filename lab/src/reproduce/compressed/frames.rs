//! Times of frames, with a method and with the plain tree in turn.

use crate::measure::rounds::Rounds;
use crate::reproduce::steps::Steps;
use anyhow::Result;
use serde::Serialize;
use slimbvh::{Backend, RenderSettings, Stages};
use std::collections::BTreeMap;

/// A frame with the plain tree, and the same frame with a method.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Round {
    pub plain: FrameTimes,
    pub own: FrameTimes,
}

/// Milliseconds of a frame's parts.
#[derive(Clone, Debug, Default, Serialize)]
pub struct FrameTimes {
    /// All other stages of the build.
    pub construction: f64,
    /// Collapsing nodes, and encoding nodes and triangles; on the CPU also the boxes of trees in codecs.
    pub encoding: f64,
    pub rendering: f64,
    /// The same times by stage.
    pub stages: BTreeMap<&'static str, f64>,
}

impl FrameTimes {
    /// Builds a tree and renders a picture.
    fn take<B: Backend>(steps: &mut Steps<B>, settings: &RenderSettings) -> Result<Self> {
        let build = steps.build_all()?;
        let render = steps.render_all(settings)?;
        Ok(Self::new(&build, &render))
    }

    fn new(build: &Stages, render: &Stages) -> Self {
        let mut frame = Self::default();
        for (stages, is_build) in [(build, true), (render, false)] {
            for (stage, time) in stages.iter() {
                let ms = time.as_secs_f64() * 1e3;
                let sum = match (is_build, stage) {
                    (true, "wide" | "encode") => &mut frame.encoding,
                    (true, _) => &mut frame.construction,
                    (false, _) => &mut frame.rendering,
                };
                *sum += ms;
                *frame.stages.entry(stage).or_default() += ms;
            }
        }
        frame
    }

    pub fn total(&self) -> f64 {
        self.construction + self.encoding + self.rendering
    }

    /// The time of a stage; 0 if the frame has no such stage.
    pub fn stage(&self, stage: &str) -> f64 {
        self.stages.get(stage).copied().unwrap_or(0.0)
    }
}

impl Round {
    /// The time that the codec adds to the build, as a share of building the plain tree. On the CPU encoding also finds the
    /// boxes, so that the two cannot be separated.
    pub fn added(&self) -> f64 {
        let built = |frame: &FrameTimes| frame.construction + frame.encoding;
        built(&self.own) / built(&self.plain) - 1.0
    }

    /// The time of encoding, as a share of the rest of the build.
    pub fn encoding_share(&self) -> f64 {
        self.own.encoding / self.own.construction
    }
}

/// Alternates frames of both. One round before the others is not counted.
pub fn take_turns<B: Backend>(
    (plain, own): (&mut Steps<B>, &mut Steps<B>),
    settings: &RenderSettings,
    count: u32,
) -> Result<Rounds<Round>> {
    let mut rounds = Rounds::default();
    for round in 0..=count {
        let times = Round {
            plain: FrameTimes::take(plain, settings)?,
            own: FrameTimes::take(own, settings)?,
        };
        if round > 0 {
            rounds.0.push(times);
        }
    }
    Ok(rounds)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    fn stages(times: &[(&'static str, u64)]) -> Stages {
        let mut stages = Stages::default();
        for &(stage, ms) in times {
            stages.add(stage, Duration::from_millis(ms));
        }
        stages
    }

    #[test]
    fn times_are_those_of_their_stages() {
        let build = stages(&[("sort", 5), ("encode", 2), ("refit", 3)]);
        let own = FrameTimes::new(&build, &stages(&[("trace", 7), ("shade", 4)]));
        assert_eq!(
            (own.construction, own.encoding, own.rendering),
            (8.0, 2.0, 11.0)
        );
        assert_eq!(
            (own.total(), own.stage("shade"), own.stage("scan")),
            (21.0, 4.0, 0.0)
        );
        let plain = FrameTimes::new(
            &stages(&[("sort", 5), ("refit", 3)]),
            &stages(&[("trace", 9)]),
        );
        let round = Round { plain, own };
        assert_eq!((round.added(), round.encoding_share()), (0.25, 0.25));
    }
}
