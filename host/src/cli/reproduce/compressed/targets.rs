//! Which targets are met.

use super::measure::{MethodRecord, SceneRecord};
use super::methods::{Method, Step};
use crate::cli::reproduce::verdicts::{Measured, Verdict};

/// A target.
struct Target {
    what: &'static str,
    /// At most.
    bound: f64,
    /// Of a method, beside the plain tree.
    of: fn(&MethodRecord, &MethodRecord) -> f64,
}

const TARGETS: [Target; 5] = [
    Target {
        what: "bytes of tree and triangles / plain",
        bound: 0.6,
        of: bytes,
    },
    Target {
        what: "bytes of tree and triangles / plain, aimed at",
        bound: 0.4,
        of: bytes,
    },
    Target {
        what: "bytes read a ray / plain",
        bound: 0.75,
        of: |own, plain| own.counts.all().bytes_read() / plain.counts.all().bytes_read(),
    },
    Target {
        what: "more box tests a ray, as a share",
        bound: 0.05,
        of: |own, plain| own.counts.all().box_tests() / plain.counts.all().box_tests() - 1.0,
    },
    Target {
        what: "what encoding adds to construction",
        bound: 0.1,
        of: |own, _| own.rounds.median(super::measure::Round::added),
    },
];

fn bytes(own: &MethodRecord, plain: &MethodRecord) -> f64 {
    own.bytes() as f64 / plain.bytes() as f64
}

/// Judges the methods that targets are for.
pub fn verdicts(records: &[SceneRecord]) -> Vec<Verdict> {
    let judged = [Method::JUDGED, Method::LatticeMesh(Step::Finest)];
    let pairs = judged
        .into_iter()
        .flat_map(|method| TARGETS.iter().map(move |target| (method, target)));
    let verdicts = pairs.map(|(method, target)| {
        let measured = records.iter().filter_map(|record| {
            Some(Measured {
                scene: record.name,
                value: (target.of)(record.of(method)?, record.plain()),
            })
        });
        Verdict {
            what: format!("{}: {}", method.name(), target.what),
            bound: target.bound,
            is_at_most: true,
            measured: measured.collect(),
        }
    });
    verdicts
        .filter(|verdict| !verdict.measured.is_empty())
        .collect()
}
