//! A scene with its exact oracle, and the tracer's answers to its rays under a rule.

use super::close_ups::Sight;
use super::difference::{Difference, Verdict, error_bound, judge};
use super::surroundings::Surroundings;
use super::wave::{Cast, RayKind, cast};
use slimbvh::reduce::{
    Cull, Plan, PlanRequest, Reduce, Saving, Savings, Seams, Switches, TargetKind, survey,
};
use slimbvh::topology::{self, Topology};
use slimbvh::{
    BuildConfig, Builder, Camera, Cpu, FrameConfig, Frames, Picture, RenderSettings, Renderer,
    Scene,
};
use slimbvh_core::float::PowerOfTwo;
use slimbvh_core::orientation::Target;
use slimbvh_core::snap::leaf_triangle;
use slimbvh_lab::oracle::Unculled;
use slimbvh_tests::gpu::done;
use std::sync::Arc;

/// A rule: the triangles that the tracer skips.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// The plan's rule.
    Plan,
    /// Skips triangles that face the eye or the light.
    Turned,
    /// Skips triangles that face the light, for shadow rays: sets L−.
    AwayFromLights,
    /// The plan's rule as if the eye and all lights were outside of all components.
    AsIfOutside,
}

/// The point of a target at which a ray starts or ends.
fn point_of(cast: &Cast, target: &Target) -> Target {
    if target.radius == 0.0 {
        return *target;
    }
    let origin = glam::Vec3::from(cast.ray.origin);
    let end = match cast.kind {
        RayKind::Camera => origin,
        RayKind::Light(_) => origin + glam::Vec3::from(cast.ray.direction),
    };
    Target::position(end.to_array())
}

/// A scene, prepared for comparison.
pub struct Subject {
    pub scene: Scene,
    pub topology: Arc<Topology>,
    unculled: Unculled,
    surroundings: Surroundings,
    exponent: i32,
    /// The largest coordinate, at the scene's magnitude.
    largest: f32,
}

/// The outcome of some rays.
#[derive(Default)]
pub struct Tally {
    pub ray_count: usize,
    pub shadow_ray_count: usize,
    pub tie_count: usize,
    pub neighbor_count: usize,
    pub differences: Vec<Difference>,
}

impl Tally {
    pub fn add(&mut self, other: Self) {
        self.ray_count += other.ray_count;
        self.shadow_ray_count += other.shadow_ray_count;
        self.tie_count += other.tie_count;
        self.neighbor_count += other.neighbor_count;
        self.differences.extend(other.differences);
    }

    pub fn unexplained(&self) -> impl Iterator<Item = &Difference> {
        let differences = self.differences.iter();
        differences.filter(|difference| !difference.is_explained())
    }
}

impl Subject {
    pub fn new(scene: Scene) -> Self {
        let topology = done(survey(&scene.mesh, BuildConfig::default(), Seams::Find)).topology;
        let bvh = done(Builder::new(BuildConfig::default()).build(&scene.mesh));
        let exponent = bvh.scene_exponent();
        let scale = PowerOfTwo::new(exponent);
        let mesh = scene.mesh.triangles();
        let corners = (0..scene.mesh.indices.len() as u32).map(|primitive| {
            let triangle = leaf_triangle(primitive, &mesh, &scale).triangle();
            [triangle.v0, triangle.v1, triangle.v2].map(|corner| corner.to_array())
        });
        let corners: Vec<[[f32; 3]; 3]> = corners.collect();
        let coordinates = corners.as_flattened().as_flattened().iter();
        let largest = coordinates.fold(0.0, |largest: f32, x| largest.max(x.abs()));
        let unculled = Unculled::new(corners);
        Self {
            surroundings: Surroundings::new(&unculled),
            unculled,
            topology,
            scene,
            exponent,
            largest,
        }
    }

    /// Whether the eye and all lights are certainly outside of all closed components.
    pub fn is_all_outside(&self) -> bool {
        let plan = self.plan(&RenderSettings::default(), Reduce::Off, Rule::Plan);
        plan.sets.iter().all(|aim| {
            let center = aim.target.point;
            let target = match (aim.target.is_position, aim.target.radius) {
                (0, _) => topology::Target::Direction(center),
                (_, 0.0) => topology::Target::Point(center),
                (_, radius) => topology::Target::Ball { center, radius },
            };
            self.topology.is_outside_all(&target)
        })
    }

    /// The plan of a whole tree with a rule, or of sets.
    pub fn plan(&self, settings: &RenderSettings, reduce: Reduce, rule: Rule) -> Plan {
        // A target for each light, and all trees at once. A rule that negates sides starts from L+.
        let mut savings = Savings::ALL.without(Saving::Groups).without(Saving::Turns);
        if rule != Rule::Plan {
            savings = savings.without(Saving::Away);
        }
        let switches = Switches {
            cull: Some(Cull::On),
            reduce,
            seams: Seams::Find,
            savings,
        };
        let asked = done(PlanRequest::of_picture(&self.scene, settings, switches));
        let mut plan = Plan::new(&self.topology, &self.scene.mesh, &asked);
        let outer = self
            .topology
            .sides(&topology::Target::Direction([0.0, 0.0, 1.0]));
        for aim in &mut plan.sets {
            let turned = |sides: &[i32]| sides.iter().map(|side| -side).collect();
            match rule {
                Rule::Plan => {}
                Rule::Turned => aim.sides = turned(&aim.sides),
                Rule::AwayFromLights if aim.kind == TargetKind::From => {}
                Rule::AwayFromLights => aim.sides = turned(&aim.sides),
                Rule::AsIfOutside => aim.sides.clone_from(&outer),
            }
        }
        plan
    }

    /// The rays of a picture, checked against the renderer's picture.
    pub fn cast(&self, settings: &RenderSettings, plan: &Plan) -> Vec<Cast> {
        let mut frames = Frames::new(Cpu, FrameConfig::default());
        done(frames.build(&self.scene, plan));
        let trees = frames.trees(plan);
        let (casts, picture) = cast(&self.scene, &trees, settings);
        let mut expected = Picture::default();
        done(Renderer::new().render_with(&self.scene, &trees, settings, &mut expected, |_| {}));
        assert!(picture == expected, "these are not the renderer's rays");
        casts
    }

    /// Compares a picture's rays with the oracle.
    pub fn compare(&self, settings: &RenderSettings, rule: Rule) -> Tally {
        let plan = self.plan(settings, Reduce::Off, rule);
        let casts = self.cast(settings, &plan);
        let targets = self.targets(&plan);
        let mut tally = Tally {
            ray_count: casts.len(),
            shadow_ray_count: casts
                .iter()
                .filter(|cast| cast.kind != RayKind::Camera)
                .count(),
            ..Tally::default()
        };
        for cast in &casts {
            let crossings = self.unculled.crossings(&cast.ray, cast.skip);
            let d = error_bound(cast, self.largest);
            match judge(cast, &crossings, d, &self.surroundings) {
                Verdict::Same => {}
                Verdict::Tie => tally.tie_count += 1,
                Verdict::Neighbor => tally.neighbor_count += 1,
                Verdict::Different => {
                    let target = match cast.kind {
                        RayKind::Camera => &targets[0],
                        RayKind::Light(index) => &targets[1 + index],
                    };
                    let target = &point_of(cast, target);
                    let exact = crossings.first().copied();
                    let difference = Difference::new(cast, exact, d, &self.surroundings, target);
                    tally.differences.push(difference);
                }
            }
        }
        tally
    }

    /// [`Self::compare`] for each of these cameras.
    pub fn compare_all(
        &mut self,
        cameras: &[Camera],
        settings: &RenderSettings,
        rule: Rule,
    ) -> Tally {
        let mut tally = Tally::default();
        let kept = self.scene.cameras[0];
        for camera in cameras {
            self.scene.cameras[0] = *camera;
            tally.add(self.compare(settings, rule));
        }
        self.scene.cameras[0] = kept;
        tally
    }

    /// Close-ups of places where rounding decides.
    pub fn close_ups(&self, settings: &RenderSettings, count: usize) -> Vec<Camera> {
        let plan = self.plan(settings, Reduce::Off, Rule::Plan);
        let targets = self.targets(&plan);
        let eye = targets[0]
            .point
            .iter()
            .fold(self.largest, |most, x| most.max(x.abs()));
        let sight = Sight {
            unculled: &self.unculled,
            surroundings: &self.surroundings,
            exponent: self.exponent,
            d: super::difference::ERROR_BOUND * f64::from(eye),
        };
        sight.close_ups(&self.scene.cameras[0], &targets, count)
    }

    /// The targets: the eye, then each light, at the scene's magnitude.
    fn targets(&self, plan: &Plan) -> Vec<Target> {
        let scale = PowerOfTwo::new(self.exponent);
        plan.sets
            .iter()
            .map(|aim| aim.target.scaled(&scale))
            .collect()
    }
}
