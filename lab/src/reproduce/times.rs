//! Times of the parts of a picture, in milliseconds.

use serde::Serialize;
use slimbvh::Stages;

/// The times of building a set.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Build {
    /// Finding the set's triangles.
    pub division: f64,
    /// Sorting, topology and boxes.
    pub construction: f64,
}

/// The steps of the division.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Division {
    /// A bit per triangle, and on the CPU the number of set bits per word.
    pub orientation: f64,
    /// Sums of the numbers of set bits: the paper's reduction and prefix sum.
    pub scan: f64,
    /// The list of the set's triangles.
    pub compaction: f64,
}

/// The times of a picture, including the builds of its trees.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Picture {
    /// Sorting all triangles if trees share the order, and the tree for the camera's rays.
    pub camera_build: Build,
    /// The trees for shadow rays.
    pub shadow_build: Build,
    /// From samples to the camera's rays and their hits.
    pub primary: f64,
    /// Shadow rays.
    pub shadow: f64,
    /// Shading, and resolving samples to pixels.
    pub rest: f64,
}

/// The sum of all stages.
pub fn ms(stages: &Stages) -> f64 {
    stages.total().as_secs_f64() * 1e3
}

impl Build {
    /// Sums the stages of a build by part.
    pub fn of(stages: &Stages) -> Self {
        let division = Division::of(stages).total();
        Self {
            division,
            construction: ms(stages) - division,
        }
    }

    pub fn total(&self) -> f64 {
        self.division + self.construction
    }

    /// The sum of both.
    pub fn plus(self, other: Self) -> Self {
        Self {
            division: self.division + other.division,
            construction: self.construction + other.construction,
        }
    }
}

impl Division {
    /// Sums the stages of the division.
    pub fn of(stages: &Stages) -> Self {
        let mut division = Self::default();
        for (stage, time) in stages.iter() {
            let ms = time.as_secs_f64() * 1e3;
            match stage {
                "classify" => division.orientation += ms,
                "scan" => division.scan += ms,
                "compact" => division.compaction += ms,
                _ => {}
            }
        }
        division
    }

    pub fn total(&self) -> f64 {
        self.orientation + self.scan + self.compaction
    }
}

impl Picture {
    /// Adds the stages of a render. A stage without a part of its own counts as primary.
    pub fn add_render(&mut self, stages: &Stages) {
        for (stage, time) in stages.iter() {
            let ms = time.as_secs_f64() * 1e3;
            match stage {
                "trace shadow" => self.shadow += ms,
                "shade" | "resolve" => self.rest += ms,
                _ => self.primary += ms,
            }
        }
    }

    /// The time up to the hits of the camera's rays.
    pub fn primary_total(&self) -> f64 {
        self.camera_build.total() + self.primary
    }

    /// The time of the whole picture.
    pub fn total(&self) -> f64 {
        self.primary_total() + self.shadow_build.total() + self.shadow + self.rest
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn stages_are_sorted_out() {
        let mut build = Stages::default();
        for (stage, ms) in [
            ("sort", 7),
            ("classify", 1),
            ("scan", 2),
            ("compact", 4),
            ("refit", 30),
        ] {
            build.add(stage, Duration::from_millis(ms));
        }
        let build = Build::of(&build);
        assert!((build.division - 7.0).abs() < 1e-9 && (build.construction - 37.0).abs() < 1e-9);
        let mut render = Stages::default();
        for (stage, ms) in [
            ("camera", 1),
            ("trace primary", 10),
            ("trace shadow", 100),
            ("shade", 1000),
            ("resolve", 2000),
        ] {
            render.add(stage, Duration::from_millis(ms));
        }
        let mut picture = Picture {
            camera_build: build,
            ..Picture::default()
        };
        picture.add_render(&render);
        assert!((picture.primary_total() - 55.0).abs() < 1e-9);
        assert!((picture.total() - 3155.0).abs() < 1e-9);
    }
}
