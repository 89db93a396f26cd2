//! The paper's tables, with our rows below the printed ones.

mod builds;
mod pictures;
mod savings;

use super::measure::SceneRecord;
use crate::measure::table::Table;
use slimbvh_cli::output::count;

/// All tables: the paper's in its order, then those that explain them.
pub fn tables(records: &[SceneRecord]) -> Vec<Table> {
    let mut tables = vec![
        sizes(records),
        pictures::primary_and_one_light(records),
        builds::construction(records),
        builds::division(records),
    ];
    tables.extend(records.iter().flat_map(pictures::near_lights));
    tables.push(pictures::supersampling(records));
    tables.push(visits(records));
    tables.extend(records.iter().filter_map(savings::table));
    tables.push(builds::once_or_each(records));
    tables
}

/// The cell of a figure that was not printed or not measured.
pub const NOTHING: &str = "–";

fn sizes(records: &[SceneRecord]) -> Table {
    let mut rows = Vec::new();
    for record in records {
        let share = |part: usize, all: usize| format!("{:.3}", part as f64 / all as f64);
        let row = |by: &str, all: usize, [c, c_away, l, l_away]: [usize; 4]| {
            let both = |a: usize, b: usize| count((a + b).saturating_sub(all));
            vec![
                record.name.to_owned(),
                by.to_owned(),
                count(all),
                count(c),
                count(c_away),
                both(c, c_away),
                count(l),
                count(l_away),
                both(l, l_away),
                share(c, all),
                share(l, all),
            ]
        };
        match &record.printed {
            Some(printed) => rows.push(row("printed", printed.triangles, printed.sizes)),
            None => rows.push(nothing(record, 11)),
        }
        rows.push(row("ours", record.triangles, record.sizes));
    }
    Table {
        title: "Table I: how many triangles are in each set".into(),
        notes: vec![
            "C+ faces the camera, C- faces away from it; L+ and L- are the same for the light. Triangles whose side is uncertain under rounding, \
             and those that even rays from outside may hit from behind, are in both."
                .into(),
        ],
        word_columns: 2,
        head: vec!["scene", "by", "triangles", "C+", "C-", "in both", "L+", "L-", "in both", "C+/all", "L+/all"],
        rows,
    }
}

fn visits(records: &[SceneRecord]) -> Table {
    let mut rows = Vec::new();
    for record in records {
        let visits = &record.visits;
        let whole = [visits.primary_whole, visits.shadow_whole];
        for (kind, set, rays, whole, reduced) in [
            (
                "primary",
                "C+",
                visits.primary_rays,
                whole[0],
                visits.primary_reduced,
            ),
            (
                "shadow",
                "L+",
                visits.shadow_rays,
                whole[1],
                visits.shadow_reduced,
            ),
            (
                "shadow",
                "L-",
                visits.shadow_rays,
                whole[1],
                visits.shadow_away,
            ),
        ] {
            let mean = |x: f64| format!("{x:.2}");
            let ratio = |whole: f64, reduced: f64| format!("{:.2}", whole / reduced);
            rows.push(vec![
                record.name.to_owned(),
                format!("{} {kind}", count(rays)),
                set.to_owned(),
                mean(whole.nodes),
                mean(reduced.nodes),
                ratio(whole.nodes, reduced.nodes),
                mean(whole.triangles),
                mean(reduced.triangles),
                ratio(whole.triangles, reduced.triangles),
            ]);
        }
    }
    Table {
        title: "What a ray meets".into(),
        notes: vec![
            "Means per ray, including rays that miss: inner nodes opened (two boxes each) and triangles tested, in the whole tree and in \
             the set's. Not in the paper; it shows how much of a ratio of times is due to less work. The same on every machine."
                .into(),
        ],
        word_columns: 3,
        head: vec!["scene", "rays", "set", "nodes, whole", "set", "ratio", "triangles, whole", "set", "ratio"],
        rows,
    }
}

/// The printed row of a scene that the paper does not have.
fn nothing(record: &SceneRecord, columns: usize) -> Vec<String> {
    let mut row = vec![record.name.to_owned(), "printed".to_owned()];
    row.resize(columns, NOTHING.to_owned());
    row
}

/// A time of any length, in milliseconds.
pub fn time(ms: f64) -> String {
    match ms {
        ms if ms.is_nan() => NOTHING.to_owned(),
        ms if ms >= 1000.0 => format!("{ms:.0}"),
        ms if ms >= 10.0 => format!("{ms:.1}"),
        ms => format!("{ms:.2}"),
    }
}

pub fn ratio(value: f64) -> String {
    if value.is_nan() {
        NOTHING.to_owned()
    } else {
        format!("{value:.2}")
    }
}

pub fn percent(share: f64) -> String {
    format!("{:.0} %", 100.0 * share)
}
