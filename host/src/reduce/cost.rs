//! What building and tracing take.

use super::Seams;
use super::target::TargetKind;

/// Times by triangle and by ray. Only their ratios decide anything.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Costs {
    /// Nanoseconds a triangle: stages `validate` to `sort`.
    pub sort: f64,
    /// Nanoseconds a triangle of a tree: stages `snap` to `refit`.
    pub tree: f64,
    /// Nanoseconds a triangle of the mesh: stage `classify`.
    pub classify: f64,
    /// Nanoseconds a triangle: taking stock of the surfaces.
    pub topology: f64,
    /// Nanoseconds a triangle: finding seams, without the tree for it.
    pub seams: f64,
    /// Nanoseconds a ray from the camera and a level of the tree, of which there are `log2(triangles)`.
    pub primary_level: f64,
    /// The same for a shadow ray.
    pub shadow_level: f64,
    /// Shadow rays a ray from the camera and a light.
    pub shadow_rays: f64,
    /// How long a shadow ray takes in a set of what faces away from the light, against one of what faces it: the surface that
    /// it leaves is not in there.
    pub away: f64,
    /// How much more of that for each share of all triangles that is in both sets, as it is for many lights.
    pub both: f64,
    /// How much longer a ray takes in a whole tree when triangles that face away are passed over by rule.
    pub rule: f64,
}

impl Costs {
    /// Measured on two cores of a shared server with the CPU backend, at 1280x720 and one sample a pixel, in default views
    /// of the Stanford dragon (871,414 triangles) and the armadillo (52,000), with one light; least of five runs (`slimbvh
    /// render FILE --threads 2 --json -`, with `--reduce off` and `--reduce on`). Dragon and armadillo in this order: sort 25
    /// and 26, tree 61 and 58, classify 8 and 7 (with the order of the mesh, of half the triangles), topology 143 and 156,
    /// seams 600 and 560, primary 2.8 and 1.9, shadow 16 and 14 a level, shadow rays 0.18 and 0.09. A set of half the
    /// triangles took 0.92 of the whole tree's time a ray from the camera; one level less makes it 0.95 and 0.94.
    ///
    /// Since then sorting takes 0.9 of the time against the tree's, and in packets rays from the camera 0.78, shadow rays 0.87 (both
    /// programs in turn, on one thread, dragon, armadillo and sponza). Leaves of six and packets that stay together save about a fifth of
    /// everything but classifying.
    ///
    /// For shadow rays in sets of either half, nodes were counted (`slimbvh-lab reproduce reduced`): of doll, toasters, 24-cell and
    /// armadillo a ray opens 0.33, 0.61, 0.57 and 0.32 times as many in L− as in L+. With 39 % of the triangles in both sets, of
    /// 4 and 9 lights, times were 0.82 and 0.84 of those in the whole tree, and with 56 %, of 16 lights, 2.6 times those in
    /// sets of single lights.
    ///
    /// The GPU backend goes by them as well: there all but the survey is faster, so plans for few frames still decline.
    pub const MEASURED: Self = Self {
        sort: 23.0,
        tree: 62.0,
        classify: 7.5,
        topology: 150.0,
        seams: 600.0,
        primary_level: 2.0,
        shadow_level: 13.0,
        shadow_rays: 0.2,
        away: 0.5,
        both: 0.75,
        rule: 1.02,
    };

    /// Milliseconds for a tree over so many triangles that are sorted already.
    pub(super) fn tree_ms(&self, count: f64) -> f64 {
        count * self.tree * 1e-6
    }

    /// Milliseconds for a tree over a set, this share of the triangles.
    pub(super) fn set_ms(&self, count: f64, share: f64) -> f64 {
        count * self.classify * 1e-6 + self.tree_ms(count * share)
    }

    /// How long a ray takes in what faces away, with this share of all triangles in both sets.
    pub(super) fn away_effort(&self, both: f64) -> f64 {
        (self.away + self.both * both.max(0.0)).min(1.0)
    }

    /// Milliseconds for a survey.
    pub(super) fn survey_ms(&self, count: f64, seams: Seams) -> f64 {
        let seams = match seams {
            Seams::Find => self.sort + self.tree + self.seams,
            Seams::None => 0.0,
        };
        count * (self.topology + seams) * 1e-6
    }

    /// Milliseconds for the rays from the eye or to a light, in a tree over so many triangles.
    pub(super) fn trace_ms(&self, kind: TargetKind, primary_rays: f64, count: f64) -> f64 {
        let levels = count.max(2.0).log2();
        let ray = match kind {
            TargetKind::Camera => self.primary_level,
            TargetKind::Lights => self.shadow_level * self.shadow_rays,
        };
        primary_rays * ray * levels * 1e-6
    }
}
