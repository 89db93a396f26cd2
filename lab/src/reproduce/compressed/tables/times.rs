//! Tables of the times of frames, whole and by stage.

use super::super::bench::TimedOn;
use super::super::frames::{FrameTimes, Round};
use super::super::measure::SceneRecord;
use super::super::methods::Method;
use super::super::printed::Printed;
use super::main_methods;
use crate::measure::table::Table;
use crate::reproduce::tables::{NOTHING, percent, ratio, time};
use std::collections::BTreeSet;

/// The times of frames, with the paper's.
pub fn frames(records: &[SceneRecord], place: TimedOn) -> Table {
    let mut rows = Vec::new();
    for record in records {
        if let Some(printed) = &record.printed {
            rows.extend(printed_times(&record.name, printed));
        }
        for own in main_methods(record) {
            let rounds = &own.rounds;
            let median = |of: fn(&FrameTimes) -> f64| time(rounds.median(|round| of(&round.own)));
            let of_plain = |of: fn(&FrameTimes) -> f64| {
                ratio(rounds.median(|round| of(&round.own) / of(&round.plain)))
            };
            rows.push(vec![
                record.name.to_owned(),
                "ours".into(),
                own.name.clone(),
                median(|frame| frame.construction),
                median(|frame| frame.encoding),
                percent(rounds.median(Round::added)),
                median(|frame| frame.rendering),
                of_plain(|frame| frame.rendering),
                median(FrameTimes::total),
                of_plain(FrameTimes::total),
                percent(rounds.spread(|round| round.own.total())),
            ]);
        }
    }
    let parts = if place.is_gpu() {
        "By the GPU's own clock: construction with all boxes, encoding (stages wide and encode: collapsing nodes, encoding nodes and triangles)"
    } else {
        "Construction, encoding (stage encode: nodes and triangles, and with two children also their boxes, with four the collapse)"
    };
    Table {
        title: "Times, ms".into(),
        notes: vec![format!(
            "{parts}, the time that both add to the construction of the plain tree, rendering, and a whole frame with a full rebuild. Moving the \
             vertices onto the lattice is not included: it happens once, before any build. Ratios are medians over rounds in which \
             the method alternates with the plain tree: below 1, the method is faster."
        )],
        word_columns: 3,
        head: vec![
            "scene",
            "by",
            "method",
            "construction",
            "encode",
            "added",
            "rendering",
            "of plain",
            "frame",
            "of plain",
            "spread",
        ],
        rows,
    }
}

fn printed_times(name: &str, printed: &Printed) -> [Vec<String>; 3] {
    let [nodes, triangles] = printed.compression;
    let compression = [0.0, nodes, nodes + triangles];
    let frames = printed.frames();
    let methods = [Method::Plain, Method::Node, Method::NodeMesh];
    [0, 1, 2].map(|i| {
        vec![
            name.to_owned(),
            "printed".into(),
            methods[i].name(),
            time(printed.creation),
            time(compression[i]),
            percent(compression[i] / printed.creation),
            time(printed.rendering[i]),
            ratio(printed.rendering[i] / printed.rendering[0]),
            time(frames[i]),
            ratio(frames[i] / frames[0]),
            NOTHING.into(),
        ]
    })
}

/// The stages of builds and of pictures, in the order of execution.
const STAGES: [&str; 16] = [
    "validate",
    "bounds",
    "morton",
    "sort",
    "scan",
    "snap",
    "topology",
    "refit",
    "wide",
    "encode",
    "camera",
    "trace primary",
    "shade",
    "trace shadow",
    "trace mirror",
    "resolve",
];

/// The times by stage.
pub fn stages(records: &[SceneRecord]) -> Table {
    let all = || records.iter().flat_map(main_methods);
    let frames = all().flat_map(|own| own.rounds.0.iter().map(|round| &round.own));
    let found: BTreeSet<&'static str> = frames.flat_map(|own| own.stages.keys().copied()).collect();
    let known = STAGES.into_iter().filter(|stage| found.contains(stage));
    let others = found.iter().copied();
    let others = others.filter(|stage| !STAGES.contains(stage));
    let columns: Vec<&'static str> = known.chain(others).collect();
    let mut rows = Vec::new();
    for record in records {
        for own in main_methods(record) {
            let median = |stage: &&str| {
                let has = own
                    .rounds
                    .0
                    .iter()
                    .any(|round| round.own.stages.contains_key(stage));
                match has {
                    true => time(own.rounds.median(|round| round.own.stage(stage))),
                    false => NOTHING.to_owned(),
                }
            };
            let row = [record.name.to_owned(), own.name.clone()].into_iter();
            rows.push(row.chain(columns.iter().map(median)).collect());
        }
    }
    Table {
        title: "Times by stage, ms".into(),
        notes: vec!["Medians over rounds, of builds and then of pictures.".into()],
        word_columns: 2,
        head: ["scene", "method"].into_iter().chain(columns).collect(),
        rows,
    }
}
