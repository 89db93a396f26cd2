//! The model of what building and tracing cost.

use super::Seams;
use super::target::TargetKind;

/// Times for each triangle and each ray. Decisions depend on their ratios only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Costs {
    /// Nanoseconds a triangle: stages `validate` to `sort`.
    pub sort: f64,
    /// Nanoseconds a triangle of a tree: stages `snap` to `refit`.
    pub tree: f64,
    /// Nanoseconds a triangle of the mesh: stage `classify`.
    pub classify: f64,
    /// Nanoseconds a triangle: survey of the surfaces.
    pub topology: f64,
    /// Nanoseconds a triangle: search for seams, without the tree that it needs.
    pub seams: f64,
    /// Nanoseconds a triangle: search for seams that spends its whole budget and is given up.
    pub seams_given_up: f64,
    /// Nanoseconds for a camera ray and a level of the tree, which has `log2(triangles)` levels.
    pub primary_level: f64,
    /// The same for a shadow ray.
    pub shadow_level: f64,
    /// Shadow rays for a camera ray and a light.
    pub shadow_rays: f64,
    /// Time of a shadow ray in L−, divided by that in L+. Rays in L− are faster: the surface that a ray leaves is not in
    /// the set.
    pub away: f64,
    /// Increase of that ratio for each unit of the share of triangles that both sets hold; that share grows with the number
    /// of lights.
    pub both: f64,
    /// Time of a ray in a whole tree with the facing filter, divided by that without it.
    pub rule: f64,
}

impl Costs {
    /// Measured on two cores of a shared server with the CPU backend, at 1280x720 with one sample a pixel and one light, in
    /// default views of the Stanford dragon (871,414 triangles) and the armadillo (52,000). Least of five runs of `slimbvh
    /// render FILE --threads 2 --json -` with `--reduce off` and `--reduce on`. Dragon and armadillo, in this order: sort
    /// 25 and 26, tree 61 and 58, classify 8 and 7 (with the order of the mesh, of half the triangles), topology 143 and
    /// 156, seams 600 and 560, primary 2.8 and 1.9, shadow 16 and 14 a level, shadow rays 0.18 and 0.09. A camera ray took
    /// 0.92 of the whole tree's time in a set of half the triangles; one level less predicts 0.95 and 0.94.
    ///
    /// Later changes: sorting takes 0.9 of the time against the tree's; in packets, camera rays take 0.78 and shadow rays
    /// 0.87 (both programs in turn, on one thread, dragon, armadillo and sponza). Leaves of six and packets that stay
    /// together save about a fifth of everything but classifying.
    ///
    /// For shadow rays in L+ and L−, nodes were counted (`slimbvh-lab reproduce reduced`): for doll, toasters, 24-cell and
    /// armadillo a ray opens 0.33, 0.61, 0.57 and 0.32 times as many in L− as in L+. With 39 % of the triangles in both
    /// sets (4 and 9 lights), times were 0.82 and 0.84 of those in the whole tree; with 56 % (16 lights), 2.6 times those
    /// in sets of single lights.
    ///
    /// A search for seams that was given up took 4.3 times as long a triangle as the armadillo's in noise (57,120 triangles
    /// whose corners are scattered in a cube), 3.1 times in a fan of 120,000 slivers.
    ///
    /// The GPU backend uses the same figures. On a GPU everything but the survey is faster, so plans for few frames still
    /// decline it.
    pub const MEASURED: Self = Self {
        sort: 23.0,
        tree: 62.0,
        classify: 7.5,
        topology: 150.0,
        seams: 600.0,
        seams_given_up: 2500.0,
        primary_level: 2.0,
        shadow_level: 13.0,
        shadow_rays: 0.2,
        away: 0.5,
        both: 0.75,
        rule: 1.02,
    };

    /// Milliseconds to build a tree over `count` sorted triangles.
    pub(super) fn tree_ms(&self, count: f64) -> f64 {
        count * self.tree * 1e-6
    }

    /// Milliseconds to build a tree over a set, this share of the triangles.
    pub(super) fn set_ms(&self, count: f64, share: f64) -> f64 {
        count * self.classify * 1e-6 + self.tree_ms(count * share)
    }

    /// Time of a shadow ray in L− divided by that in L+, with this share of all triangles in both sets.
    pub(super) fn away_effort(&self, both: f64) -> f64 {
        (self.away + self.both * both.max(0.0)).min(1.0)
    }

    /// Milliseconds for a survey of sound surfaces.
    pub(super) fn survey_ms(&self, count: f64, seams: Seams) -> f64 {
        self.survey_with(count, seams, self.seams)
    }

    /// Milliseconds for a survey whose search for seams is given up.
    pub(super) fn longest_survey_ms(&self, count: f64, seams: Seams) -> f64 {
        self.survey_with(count, seams, self.seams_given_up)
    }

    fn survey_with(&self, count: f64, seams: Seams, search: f64) -> f64 {
        let seams = match seams {
            Seams::Find => self.sort + self.tree + search,
            Seams::None => 0.0,
        };
        count * (self.topology + seams) * 1e-6
    }

    /// Milliseconds to trace rays from a camera or to a light, in a tree over `count` triangles.
    pub(super) fn trace_ms(&self, kind: TargetKind, ray_count: f64, count: f64) -> f64 {
        let levels = count.max(2.0).log2();
        let ray = match kind {
            TargetKind::From => self.primary_level,
            TargetKind::To | TargetKind::Other => self.shadow_level,
        };
        ray_count * ray * levels * 1e-6
    }
}
