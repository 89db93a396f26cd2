//! Planted faults are found, and right answers are accepted.

use super::*;
use crate::oracle::Crossing;
use glam::Vec3;
use proptest::prelude::*;
use slimbvh::generate::{icosphere, soup};
use slimbvh::{CodeBits, Hit, Mesh, Ray};
use std::sync::OnceLock;

/// A scene with its exact hits, and right answers.
struct Known {
    subject: Subject,
    shots: Vec<Shot>,
    crossings: Vec<Vec<Crossing>>,
    answers: Vec<Answer>,
}

fn case(mesh: Mesh, inside: Option<[f32; 3]>) -> Case {
    Case {
        family: "test".into(),
        magnitude: "1".into(),
        mesh,
        code_bits: CodeBits::Bits30,
        inside,
        eye: inside.map(|_| [3.0, 4.0, 5.0]),
        ray_count: 1200,
    }
}

fn scenes() -> [Case; 2] {
    let sphere = icosphere(Vec3::new(0.1, 0.2, 0.3), 1.0, 2);
    [
        case(sphere, Some([0.2, 0.1, 0.2])),
        case(soup(200, 1), None),
    ]
}

impl Known {
    fn new(case: &Case) -> Self {
        let shots = rays(case).shots;
        let corner = |v: u32| case.mesh.vertices[v as usize];
        let triangles = case.mesh.indices.iter().map(|face| face.map(corner));
        let subject = Subject::new(triangles.collect(), 0);
        let crossings = |shot: &Shot| {
            let line = subject.line(&shot.ray);
            line.map_or_else(Vec::new, |line| {
                subject.scene.crossings(&line.ray, u32::MAX)
            })
        };
        let crossings: Vec<_> = shots.iter().map(crossings).collect();
        let answers = crossings.iter().map(|crossings| exact(crossings.first()));
        Self {
            answers: answers.collect(),
            subject,
            shots,
            crossings,
        }
    }

    fn all() -> &'static [Self; 2] {
        static KNOWN: OnceLock<[Known; 2]> = OnceLock::new();
        KNOWN.get_or_init(|| scenes().each_ref().map(Self::new))
    }

    fn judge(&self, i: usize, answer: &Answer) -> Verdict {
        let judge = Judge {
            subject: &self.subject,
            ulps: BOUND_ULPS,
        };
        judge.judge(&self.shots[i], &self.crossings[i], answer)
    }

    /// The first crossing, if it must be hit and the ray is steep enough.
    fn certain(&self, i: usize) -> Option<(Line, &Crossing)> {
        let line = self.subject.line(&self.shots[i].ray)?;
        let first = self.crossings[i].first()?;
        let corners = self.subject.corners(first.primitive);
        let is_certain = self.subject.must_be_met(&line, first, BOUND_ULPS)
            && steepness(line.unit, &corners) > 0.1
            // The origin is not so far away that everything counts as near.
            && self.subject.slack(&line, first.primitive, BOUND_ULPS)[0] < 1e-5
            && first.t.abs() > 1e-30
            && first.t.abs() < 1e30;
        is_certain.then_some((line, first))
    }
}

/// The answer of a tracer that rounds only to the nearest `f32`.
fn exact(first: Option<&Crossing>) -> Answer {
    Answer {
        closest: first.map_or(Hit::MISS, |first| Hit {
            t: first.t as f32,
            primitive: first.primitive,
            ..Hit::MISS
        }),
        any: first.is_some(),
    }
}

#[test]
fn right_answers_are_right() {
    for known in Known::all() {
        for (i, answer) in known.answers.iter().enumerate() {
            let verdict = known.judge(i, answer);
            assert_eq!(verdict.fault, None, "{:?} {answer:?}", known.shots[i]);
            assert!(verdict.plane_error.is_none_or(|error| error < 2.0));
        }
        let certain = (0..known.shots.len()).filter(|&i| known.certain(i).is_some());
        assert!(certain.count() > 200);
    }
}

proptest! {
    /// Where a hit is certain, a planted fault is found and named.
    #[test]
    fn a_spoilt_answer_is_found(scene in 0usize..2, pick in any::<prop::sample::Index>(), other in any::<prop::sample::Index>(), away in prop_oneof![-1.0f64..-1e-3, 1e-3f64..1.0]) {
        let known = &Known::all()[scene];
        let certain: Vec<usize> = (0..known.shots.len()).filter(|&i| known.certain(i).is_some()).collect();
        let i = certain[pick.index(certain.len())];
        let (line, first) = known.certain(i).expect("it is certain");
        let right = known.answers[i];
        let fault = |closest: Hit, any: bool| known.judge(i, &Answer { closest, any }).fault;

        prop_assert_eq!(fault(Hit::MISS, false), Some(Fault::Missed));
        prop_assert_eq!(fault(Hit::MISS, true), Some(Fault::Missed));
        prop_assert_eq!(fault(right.closest, false), Some(Fault::Missed));
        let t = (first.t + away / line.length) as f32;
        prop_assert_eq!(fault(Hit { t, ..right.closest }, true), Some(Fault::False));
        for t in [f32::NAN, f32::INFINITY] {
            prop_assert_eq!(fault(Hit { t, ..right.closest }, true), Some(Fault::False));
        }
        // Another triangle at the same place, unless the ray hits it too, or is so slanted that t may be off by as much.
        let primitive = other.index(known.subject.scene.count()) as u32;
        let corners = known.subject.corners(primitive);
        let distance = crate::oracle::distance::to_triangle(line.at(first.t), corners);
        let [reach, along] = known.subject.slack(&line, primitive, BOUND_ULPS);
        if distance > 1e-3 + reach + along {
            prop_assert_eq!(fault(Hit { primitive, ..right.closest }, true), Some(Fault::False));
        }
        // A hit behind the certain one.
        if let Some(last) = known.crossings[i].last() && (last.t - first.t) * line.length > 0.1 {
            let behind = exact(Some(last)).closest;
            let found = fault(behind, true);
            prop_assert!(matches!(found, Some(Fault::WrongPrimitive)), "{:?}", found);
        }
    }

    /// Scaling a scene and its rays by a power of two causes no fault.
    #[test]
    fn magnitude_does_not_matter(exponent in -120i32..=120, pick in any::<prop::sample::Index>()) {
        let known = &Known::all()[1];
        let certain: Vec<usize> = (0..known.shots.len()).filter(|&i| known.certain(i).is_some()).collect();
        let i = certain[pick.index(certain.len())];
        let scaled = |x: f32| (f64::from(x) * 2f64.powi(exponent)) as f32;
        let ray = known.shots[i].ray;
        let ray = Ray { origin: ray.origin.map(scaled), direction: [0, 1, 2].map(|k| scaled((f64::from(ray.direction[k])) as f32)), ..ray };
        let is_exact = |a: f32| (f64::from(scaled(a)) * 2f64.powi(-exponent)) as f32 == a;
        let old = known.shots[i].ray;
        prop_assume!(old.origin.iter().chain(&old.direction).all(|&x| is_exact(x)));
        let triangles = known.subject.scene.triangles().iter().map(|triangle| triangle.map(|p| p.map(scaled)));
        let subject = Subject::new(triangles.collect(), 0);
        let line = subject.line(&ray).expect("it is a ray");
        let crossings = subject.scene.crossings(&line.ray, u32::MAX);
        let judge = Judge { subject: &subject, ulps: BOUND_ULPS };
        let shot = Shot { ray, is_inside: false };
        prop_assert_eq!(judge.judge(&shot, &crossings, &known.answers[i]).fault, None);
        let miss = Answer { closest: Hit::MISS, any: false };
        prop_assert_eq!(judge.judge(&shot, &crossings, &miss).fault, Some(Fault::Missed));
    }
}

/// From inside a closed surface no miss is excused, and an invalid ray must not hit.
#[test]
fn there_is_no_tolerance_inside_and_none_for_what_is_no_ray() {
    let known = &Known::all()[0];
    let miss = Answer {
        closest: Hit::MISS,
        any: false,
    };
    let (mut inside, mut none) = (0, 0);
    for (i, shot) in known.shots.iter().enumerate() {
        if shot.is_inside {
            assert_eq!(known.judge(i, &miss).fault, Some(Fault::Missed));
            inside += 1;
        }
        if known.subject.line(&shot.ray).is_none() {
            let hit = known.answers.iter().find(|answer| answer.any);
            let fault = known.judge(i, hit.expect("some hit")).fault;
            assert_eq!(fault, Some(Fault::False));
            assert_eq!(known.judge(i, &miss).fault, None);
            none += 1;
        }
    }
    assert!(inside >= 300 && none >= 20, "{inside} {none}");
}

/// A tracer that loses one hit in a hundred.
struct Forgetful(Cpu);

impl Tracer for Forgetful {
    fn name(&self) -> &str {
        "forgetful"
    }

    fn backend(&self) -> &'static str {
        self.0.backend()
    }

    fn bound_ulps(&self) -> f64 {
        self.0.bound_ulps()
    }

    fn trees(&self, case: &Case) -> Vec<Tree> {
        self.0.trees(case)
    }

    fn trace(&mut self, case: &Case, tree: &Tree, rays: &[Ray]) -> Result<Outcome, Failure> {
        let mut outcome = self.0.trace(case, tree, rays)?;
        for answer in outcome.answers.iter_mut().step_by(100) {
            answer.closest = Hit::MISS;
        }
        Ok(outcome)
    }
}

#[test]
fn every_tree_is_judged() {
    for case in scenes() {
        let mut cpu = Cpu {
            effort: Effort::Quick,
        };
        let rows = run(&mut cpu, &case).expect("it is sound");
        let trees = if case.eye.is_some() { 11 } else { 8 };
        assert_eq!(rows.len(), trees);
        for row in &rows {
            assert!(row.faults() == 0 && row.keeps_its_bound(), "{row:?}");
            assert!(row.depth > Some(4) && row.stack > Some(2) && row.rays >= 300);
            assert_eq!(row.moved.is_some(), row.codec.contains('+'));
        }
        let rows = run(&mut Forgetful(cpu), &case).expect("it is sound");
        assert!(
            rows.iter()
                .all(|row| row.missed > 0 && row.example.is_some())
        );
    }
}
