//! The table of the savings.

use super::{ratio, time};
use crate::measure::table::Table;
use crate::reproduce::measure::SceneRecord;
use crate::reproduce::savings::{FrameTimes, SavingRecord};
use slimbvh_cli::output::{bytes, count};

/// One row per saving, if they were measured.
pub fn table(record: &SceneRecord) -> Option<Table> {
    if record.savings.is_empty() {
        return None;
    }
    Some(Table {
        title: format!("Savings, on the {}", record.name),
        notes: vec![
            "The same picture with all savings, and without one of them (`slimbvh render --reduce on --without SAVING`), in a scene in which that saving \
             matters; the last row is without and with `--dark-rays`. Both pictures are equal. Triangles: of all sets that a frame builds. \
             Trees: their memory at its peak. Ms: trees and rays, without the plan itself. Ratio: without / with, above 1 if \
             the saving is faster."
                .into(),
        ],
        word_columns: 2,
        head: vec![
            "saving",
            "scene",
            "triangles",
            "without",
            "trees",
            "without",
            "shadow rays",
            "without",
            "ms",
            "without",
            "ratio",
        ],
        rows: record.savings.iter().map(row).collect(),
    })
}

fn row(record: &SavingRecord) -> Vec<String> {
    let (with, without) = (&record.with, &record.without);
    vec![
        record.saving.clone(),
        record.scene.to_owned(),
        count(with.triangles),
        count(without.triangles),
        bytes(with.tree_bytes),
        bytes(without.tree_bytes),
        count(with.shadow_rays),
        count(without.shadow_rays),
        time(with.rounds.median(FrameTimes::total)),
        time(without.rounds.median(FrameTimes::total)),
        ratio(
            without
                .rounds
                .ratio(FrameTimes::total, &with.rounds, FrameTimes::total),
        ),
    ]
}
