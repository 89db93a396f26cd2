//! Times of the parts of a picture.

use serde::Serialize;
use slimbvh::Stages;

/// Milliseconds of each part.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Times {
    /// Planning the reduction: a survey of the surfaces where it may pay, and the decision.
    pub plan: f64,
    /// All other stages of the build.
    pub build: f64,
    /// Collapsing nodes, and encoding nodes and triangles; on the CPU also the boxes of trees in codecs.
    pub encode: f64,
    /// From samples to the rays from the eye and their hits.
    pub primary: f64,
    pub shadow: f64,
    /// Rays from mirrors and through glass.
    pub reflection: f64,
    /// Shading, and resolving samples to pixels.
    pub rest: f64,
}

/// The times of a picture with the default, and of the same with another setup.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Round {
    pub usual: Times,
    pub own: Times,
}

impl Times {
    /// Names of the parts, in the order of [`Self::parts`].
    pub const PARTS: [&'static str; 7] = [
        "plan",
        "build",
        "encode",
        "primary",
        "shadow",
        "reflection",
        "rest",
    ];

    /// Sums the stages by part. Every stage without a part of its own counts as primary.
    pub fn new(plan: f64, build: &Stages, render: &Stages) -> Self {
        let mut times = Self {
            plan,
            ..Self::default()
        };
        for (stages, is_build) in [(build, true), (render, false)] {
            for (stage, time) in stages.iter() {
                let sum = match (is_build, stage) {
                    (true, "wide" | "encode") => &mut times.encode,
                    (true, _) => &mut times.build,
                    (false, "trace shadow") => &mut times.shadow,
                    (false, "trace mirror") => &mut times.reflection,
                    (false, "shade" | "resolve") => &mut times.rest,
                    (false, _) => &mut times.primary,
                };
                *sum += time.as_secs_f64() * 1e3;
            }
        }
        times
    }

    pub fn parts(&self) -> [f64; 7] {
        [
            self.plan,
            self.build,
            self.encode,
            self.primary,
            self.shadow,
            self.reflection,
            self.rest,
        ]
    }

    /// The whole picture, from the mesh.
    pub fn frame(&self) -> f64 {
        self.parts().iter().sum()
    }

    /// The picture without planning, as for a mesh whose plan is known.
    pub fn planned(&self) -> f64 {
        self.frame() - self.plan
    }

    /// All tracing.
    pub fn trace(&self) -> f64 {
        self.primary + self.shadow + self.reflection
    }
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
    fn stages_are_sorted_out() {
        let build = stages(&[("sort", 2), ("encode", 4), ("refit", 8)]);
        let render = stages(&[
            ("trace primary", 16),
            ("camera", 32),
            ("trace shadow", 64),
            ("trace mirror", 128),
            ("shade", 256),
            ("resolve", 512),
        ]);
        let times = Times::new(1.0, &build, &render);
        let parts = times.parts().map(f64::round);
        assert_eq!(parts, [1.0, 10.0, 4.0, 48.0, 64.0, 128.0, 768.0]);
        let sums = [times.frame(), times.planned(), times.trace()].map(f64::round);
        assert_eq!(sums, [1023.0, 1022.0, 240.0]);
    }
}
