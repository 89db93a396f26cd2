//! Tables III and IV, and the gain of sorting once.

use super::{NOTHING, nothing, percent, ratio, time};
use crate::measure::table::Table;
use crate::reproduce::measure::{SETS, SceneRecord};
use crate::reproduce::printed::Printed;
use crate::reproduce::times::Division;

pub fn construction(records: &[SceneRecord]) -> Table {
    let mut rows = Vec::new();
    for record in records {
        let row = |by: &str, cells: Vec<String>| {
            let mut row = vec![record.name.to_owned(), by.to_owned()];
            row.extend(cells);
            row
        };
        rows.push(match &record.printed {
            Some(printed) => row("printed", printed_cells(printed)),
            None => nothing(record, 10),
        });
        let rounds = &record.sets;
        let all = rounds.median(|round| round.all);
        let division = rounds.median(|round| round.sets[0].division.total());
        let spread = percent(rounds.spread(|round| round.all));
        let alone = |set: usize| rounds.median(move |round| round.sets[set].alone.construction);
        let shared = |set: usize| rounds.median(move |round| round.sets[set].shared.construction);
        let ours = |sort: String, of: &dyn Fn(usize) -> f64, of_all: f64| {
            let mut cells = vec![sort, time(all), time(division)];
            cells.extend((0..4).map(|set| time(of(set))));
            cells.extend([ratio(of_all), spread.clone()]);
            cells
        };
        let alone_ratio = rounds.ratio(
            |round| round.sets[0].alone.construction,
            rounds,
            |round| round.all,
        );
        rows.push(row(
            "ours, sorted alone",
            ours(NOTHING.into(), &alone, alone_ratio),
        ));
        let sort = rounds.median(|round| round.sort);
        let tree_ratio = rounds.ratio(
            |round| round.sets[0].shared.construction,
            rounds,
            |round| round.all - round.sort,
        );
        rows.push(row(
            "ours, sorted once",
            ours(time(sort), &shared, tree_ratio),
        ));
    }
    Table {
        title: "Table III: construction, ms".into(),
        notes: vec![
            "Sorted alone, as in the paper: each set's triangles are sorted by themselves. Sorted once: all triangles are sorted (column \
             sort), and each set's tree is built from that order; the last ratio then compares the trees without the sort. The division, of \
             C+, is not included in the sets. Spread: slowest minus fastest construction over all, as a share of the median."
                .into(),
        ],
        word_columns: 2,
        head: vec!["scene", "by", "sort", "all", "division", "C+", "C-", "L+", "L-", "C+/all", "spread"],
        rows,
    }
}

fn printed_cells(printed: &Printed) -> Vec<String> {
    let mut cells = vec![
        NOTHING.to_owned(),
        time(printed.all),
        time(printed.division),
    ];
    cells.extend(printed.sets.map(|ms| time(ms.unwrap_or(f64::NAN))));
    let share = printed.sets[0].map_or(f64::NAN, |ms| ms / printed.all);
    cells.extend([ratio(share), NOTHING.to_owned()]);
    cells
}

pub fn division(records: &[SceneRecord]) -> Table {
    let us = |x: f64| format!("{x:.0}");
    let mut rows = Vec::new();
    for record in records {
        let name = || record.name.to_owned();
        for steps in record.printed.iter().flat_map(|printed| printed.steps) {
            let construction = match (&record.printed, steps.sets.starts_with("C+")) {
                (Some(printed), true) => printed.sets[0],
                (Some(printed), false) => printed.sets[1],
                (None, _) => None,
            };
            rows.push(vec![
                name(),
                "printed".into(),
                steps.sets.into(),
                us(steps.orientation),
                us(steps.reduction + steps.prefix_sum),
                us(steps.compaction),
                us(steps.total),
                construction.map_or(NOTHING.into(), |ms| {
                    format!("{:.1} %", 0.1 * steps.total / ms)
                }),
            ]);
        }
        for (set, shown) in SETS.iter().enumerate() {
            let rounds = &record.sets;
            let of = |step: fn(&Division) -> f64| {
                us(1e3 * rounds.median(|round| step(&round.sets[set].division)))
            };
            let share = rounds.ratio(
                |round| round.sets[set].division.total(),
                rounds,
                |round| round.sets[set].alone.construction,
            );
            rows.push(vec![
                name(),
                "ours".into(),
                (*shown).into(),
                of(|steps| steps.orientation),
                of(|steps| steps.scan),
                of(|steps| steps.compaction),
                of(Division::total),
                format!("{:.1} %", 100.0 * share),
            ]);
        }
    }
    Table {
        title: "Table IV: division, µs".into(),
        notes: vec![
            "Orientation: the side that each triangle faces, and on the CPU also the number kept of each 32. Sums: the paper's reduction and \
             prefix sum together. Compaction: the list of kept triangles. The last column is the division as a share of the construction \
             over the set, sorted alone. Two printed totals differ from their parts by 10 µs."
                .into(),
        ],
        word_columns: 3,
        head: vec!["scene", "by", "sets", "orientation", "sums", "compaction", "total", "of construction"],
        rows,
    }
}

/// Sorting once for all sets, compared with sorting each set.
pub fn once_or_each(records: &[SceneRecord]) -> Table {
    let mut rows = Vec::new();
    for record in records {
        let rounds = &record.sets;
        for (shown, sets) in [
            ("C+", &[0][..]),
            ("C+ and L+", &[0, 2]),
            ("all four", &[0, 1, 2, 3]),
        ] {
            let once = |round: &crate::reproduce::measure::SetsRound| {
                let sets = sets.iter().map(|&set| round.sets[set].shared.total());
                round.sort + sets.sum::<f64>()
            };
            let each = |round: &crate::reproduce::measure::SetsRound| {
                let sets = sets.iter().map(|&set| {
                    let times = &round.sets[set];
                    // The GPU gets finished sets, while the CPU divides as it builds.
                    let division = if times.alone.division > 0.0 {
                        0.0
                    } else {
                        times.division.total()
                    };
                    times.alone.total() + division
                });
                sets.sum::<f64>()
            };
            rows.push(vec![
                record.name.to_owned(),
                shown.to_owned(),
                time(rounds.median(once)),
                time(rounds.median(each)),
                ratio(rounds.ratio(once, rounds, each)),
                time(rounds.median(|round| round.all)),
            ]);
        }
    }
    Table {
        title: "Sort once, or sort each set, ms".into(),
        notes: vec![
            "Division and construction of several sets: one order of all triangles with a compaction per set, against one order per set. \
             A ratio below 1 favours sorting once. The last column is the one whole tree that the default builds instead. Not in the \
             paper, which sorts each set."
                .into(),
        ],
        word_columns: 2,
        head: vec!["scene", "sets", "sorted once", "sorted each", "once/each", "whole tree"],
        rows,
    }
}
