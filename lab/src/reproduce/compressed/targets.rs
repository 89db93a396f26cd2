//! The targets, and whether they are met.

use super::bench::TimedOn;
use super::frames::{FrameTimes, Round};
use super::measure::{MethodRecord, SceneRecord};
use super::methods::Method;
use crate::measure::step::Step;
use crate::reproduce::verdicts::{Measured, Verdict};

/// A target.
struct Target {
    what: &'static str,
    /// The maximum.
    bound: f64,
    /// The figure, from the records of a method and of the plain tree.
    of: fn(&MethodRecord, &MethodRecord) -> f64,
    /// Whether the target holds for the smallest scene as well.
    is_for_smallest: bool,
}

const COUNTED: [Target; 4] = [
    Target {
        what: "bytes of tree and triangles / plain",
        bound: 0.6,
        of: bytes,
        is_for_smallest: true,
    },
    Target {
        what: "bytes of tree and triangles / plain, aimed at",
        bound: 0.4,
        of: bytes,
        is_for_smallest: true,
    },
    Target {
        what: "bytes read a ray / plain",
        bound: 0.75,
        of: |own, plain| own.counts.all().bytes_read() / plain.counts.all().bytes_read(),
        is_for_smallest: true,
    },
    Target {
        what: "more box tests a ray, as a share",
        bound: 0.05,
        of: |own, plain| own.counts.all().box_tests() / plain.counts.all().box_tests() - 1.0,
        is_for_smallest: true,
    },
];

/// For the CPU, where encoding also finds the boxes.
const ADDED: Target = Target {
    what: "what encoding adds to construction",
    bound: 0.1,
    of: |own, _| own.rounds.median(Round::added),
    is_for_smallest: true,
};

/// For a GPU, where encoding is a stage by itself.
const ENCODING: Target = Target {
    what: "encoding / construction",
    bound: 0.1,
    of: |own, _| own.rounds.median(Round::encoding_share),
    is_for_smallest: true,
};

/// For a hardware GPU, which is limited by memory.
const FASTER: [Target; 2] = [
    Target {
        what: "rendering / plain, but for the smallest scene",
        bound: 1.0,
        of: |own, _| of_plain(own, |frame| frame.rendering),
        is_for_smallest: false,
    },
    Target {
        what: "a frame / plain, but for the smallest scene",
        bound: 1.0,
        of: |own, _| of_plain(own, FrameTimes::total),
        is_for_smallest: false,
    },
];

/// The targets for a kind of machine.
fn targets(place: TimedOn) -> Vec<&'static Target> {
    let counted = COUNTED.iter();
    match place {
        TimedOn::Cores => counted.chain([&ADDED]).collect(),
        TimedOn::Software => counted.chain([&ENCODING]).collect(),
        TimedOn::Gpu => counted.chain([&ENCODING]).chain(&FASTER).collect(),
    }
}

fn of_plain(own: &MethodRecord, of: fn(&FrameTimes) -> f64) -> f64 {
    own.rounds.median(|round| of(&round.own) / of(&round.plain))
}

fn bytes(own: &MethodRecord, plain: &MethodRecord) -> f64 {
    own.bytes() as f64 / plain.bytes() as f64
}

/// Judges the methods that targets are for.
pub fn verdicts(records: &[SceneRecord], place: TimedOn) -> Vec<Verdict> {
    let judged = [Method::JUDGED, Method::LatticeMesh(Step::Finest)];
    let pairs = judged.into_iter().flat_map(|method| {
        targets(place)
            .into_iter()
            .map(move |target| (method, target))
    });
    let verdicts = pairs.map(|(method, target)| {
        let asked = |record: &&SceneRecord| target.is_for_smallest || !record.is_smallest;
        let measured = records.iter().filter(asked).filter_map(|record| {
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
