//! The targets, and whether they are met.

use super::bench::TimedOn;
use super::frames::{FrameTimes, Round};
use super::measure::{MethodRecord, SceneRecord};
use super::methods::{JUDGED_STEP, Method};
use crate::measure::step::Step;
use crate::reproduce::verdicts::{Measured, Verdict};
use slimbvh::WideStore;

/// A target.
struct Target {
    what: &'static str,
    /// The maximum.
    bound: f64,
    /// The figure, from the records of a method and of what it is compared with.
    of: fn(&MethodRecord, &MethodRecord) -> f64,
    beside: Method,
    /// Whether the target holds for the smallest scene as well.
    is_for_smallest: bool,
}

impl Target {
    /// A target beside the plain tree, for all scenes.
    const fn new(
        what: &'static str,
        bound: f64,
        of: fn(&MethodRecord, &MethodRecord) -> f64,
    ) -> Self {
        Self {
            what,
            bound,
            of,
            beside: Method::Plain,
            is_for_smallest: true,
        }
    }

    /// The same beside another method.
    const fn beside(self, beside: Method) -> Self {
        Self { beside, ..self }
    }

    /// The same for all scenes but the smallest.
    const fn but_for_smallest(self) -> Self {
        Self {
            is_for_smallest: false,
            ..self
        }
    }
}

/// The stores on the lattice, in the order of [`COUNTED_WIDE`].
const WIDE_STORES: [WideStore; 2] = [WideStore::Packed, WideStore::Exact];

const BYTES: &str = "bytes of tree and triangles / plain";

const READ: Target = Target::new("bytes read a ray / plain", 0.75, |own, plain| {
    own.counts.all().bytes_read() / plain.counts.all().bytes_read()
});

/// For nodes of two children.
const COUNTED: [Target; 4] = [
    Target::new(BYTES, 0.6, bytes),
    Target::new("bytes of tree and triangles / plain, aimed at", 0.4, bytes),
    READ,
    Target::new("more box tests a ray, as a share", 0.05, more_boxes),
];

/// For nodes of four children in 48 bytes, and in 64.
const COUNTED_WIDE: [[Target; 2]; 2] = [
    [Target::new(BYTES, 0.39, bytes).but_for_smallest(), READ],
    [Target::new(BYTES, 0.42, bytes).but_for_smallest(), READ],
];

/// For nodes of four children over vertices that hardly move: beside planes in full.
const TESTS_WIDE: [Target; 2] = [
    Target::new("more box tests a ray than w4, as a share", 0.03, more_boxes).beside(Method::WIDE),
    Target::new(
        "more triangle tests a ray than w4, as a share",
        0.03,
        |own, full| own.counts.all().triangle_tests() / full.counts.all().triangle_tests() - 1.0,
    )
    .beside(Method::WIDE),
];

/// For the CPU, where encoding also finds the boxes.
const ADDED: Target = Target::new("what encoding adds to construction", 0.1, added);

/// For the CPU and nodes of four children.
const ADDED_WIDE: Target = Target::new(
    "what collapse and encoding add to construction",
    0.25,
    added,
);

/// For a GPU, where encoding is a stage by itself.
const ENCODING: Target = Target::new("encoding / construction", 0.1, |own, _| {
    own.rounds.median(Round::encoding_share)
});

/// For a hardware GPU, which is limited by memory.
const FASTER: [Target; 2] = [
    Target::new(
        "rendering / plain, but for the smallest scene",
        1.0,
        |own, _| of_plain(own, |frame| frame.rendering),
    )
    .but_for_smallest(),
    Target::new(
        "a frame / plain, but for the smallest scene",
        1.0,
        |own, _| of_plain(own, FrameTimes::total),
    )
    .but_for_smallest(),
];

/// The targets of counts, and that of what the CPU adds to construction, for a kind of machine.
fn targets(
    counted: &'static [Target],
    added: &'static Target,
    place: TimedOn,
) -> Vec<&'static Target> {
    let counted = counted.iter();
    match place {
        TimedOn::Cores => counted.chain([added]).collect(),
        TimedOn::Software => counted.chain([&ENCODING]).collect(),
        TimedOn::Gpu => counted.chain([&ENCODING]).chain(&FASTER).collect(),
    }
}

fn added(own: &MethodRecord, _: &MethodRecord) -> f64 {
    own.rounds.median(Round::added)
}

fn more_boxes(own: &MethodRecord, other: &MethodRecord) -> f64 {
    own.counts.all().box_tests() / other.counts.all().box_tests() - 1.0
}

fn of_plain(own: &MethodRecord, of: fn(&FrameTimes) -> f64) -> f64 {
    own.rounds.median(|round| of(&round.own) / of(&round.plain))
}

fn bytes(own: &MethodRecord, plain: &MethodRecord) -> f64 {
    own.bytes() as f64 / plain.bytes() as f64
}

/// Judges the methods that targets are for.
pub fn verdicts(records: &[SceneRecord], place: TimedOn) -> Vec<Verdict> {
    let of_two = [Method::JUDGED, Method::LatticeMesh(Step::Finest)];
    let of_two = of_two.map(|method| (method, targets(&COUNTED, &ADDED, place)));
    let of_four = WIDE_STORES.into_iter().zip(&COUNTED_WIDE);
    let of_four = of_four.flat_map(|(store, counted)| {
        let method = |step| Method::WideMesh(store, step);
        [
            (method(JUDGED_STEP), targets(counted, &ADDED_WIDE, place)),
            (method(Step::Finest), TESTS_WIDE.iter().collect()),
        ]
    });
    let pairs = of_two.into_iter().chain(of_four);
    let pairs = pairs.flat_map(|(method, targets)| targets.into_iter().map(move |it| (method, it)));
    let verdicts = pairs.map(|(method, target)| {
        let asked = |record: &&SceneRecord| {
            !record.is_own && (target.is_for_smallest || !record.is_smallest)
        };
        let measured = records.iter().filter(asked).filter_map(|record| {
            Some(Measured {
                scene: record.name.clone(),
                value: (target.of)(record.of(method)?, record.of(target.beside)?),
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
