//! Tables that sum the rows.

use crate::measure::table::Table;
use crate::stress::Row;
use slimbvh_cli::output::count;

/// The number of rows with faults that are listed at most.
const MOST_LISTED: usize = 30;

/// The tables by family, by codec, and of the rows with faults.
pub fn tables(rows: &[Row]) -> Vec<Table> {
    let mut tables = vec![families(rows), codecs(rows)];
    let faulty: Vec<&Row> = rows.iter().filter(|row| row.faults() > 0).collect();
    if !faulty.is_empty() {
        tables.push(faults(&faulty));
    }
    tables
}

/// Sums the rows with the same key, in the order of the first row of each.
fn merged(rows: &[Row], key: impl Fn(&Row) -> [String; 4]) -> Vec<([String; 4], Row, usize)> {
    let mut sums: Vec<([String; 4], Row, usize)> = Vec::new();
    for row in rows {
        let own = key(row);
        let place = sums.iter().position(|(key, ..)| *key == own);
        match place {
            Some(place) => {
                let (_, sum, scenes) = &mut sums[place];
                *scenes += usize::from(sum.magnitude != row.magnitude);
                sum.magnitude.clone_from(&row.magnitude);
                sum.add(row);
            }
            None => sums.push((own, row.clone(), 1)),
        }
    }
    sums
}

fn families(rows: &[Row]) -> Table {
    let by = |row: &Row| [&row.family, &row.tracer, &row.backend, &row.family].map(Clone::clone);
    let line = |([family, tracer, backend, _], sum, scenes): ([String; 4], Row, usize)| {
        let mut cells = vec![family, format!("{tracer} {backend}"), scenes.to_string()];
        cells.extend(figures(&sum));
        cells.extend([
            large(sum.t_error_ulps),
            large(sum.plane_error_ulps),
            known(sum.depth),
            known(sum.stack),
            format!("{:.0}", sum.time_ms),
        ]);
        cells
    };
    // A family's tracers stand together, although the rows of other tracers come after all of ours.
    let mut sums = merged(rows, by);
    let place = |family: &str| rows.iter().position(|row| row.family == family);
    sums.sort_by_key(|([family, ..], ..)| place(family));
    Table {
        title: "By family".into(),
        notes: vec![
            "All codecs, whole and reduced, summed. Adrift: the ray hits its triangle, but t is off by more than the bound, as for a ray that \
             runs almost in the triangle's plane. t, plane: the largest error along the ray and across the triangle, in ulps of the largest \
             coordinate. ms: to build and trace."
                .into(),
        ],
        word_columns: 2,
        head: vec![
            "family", "tracer", "scenes", "rays", "missed", "false", "wrong", "adrift", "t", "plane",
            "depth", "stack", "ms",
        ],
        rows: sums.into_iter().map(line).collect(),
    }
}

fn codecs(rows: &[Row]) -> Table {
    let by = |row: &Row| [&row.codec, &row.reduction, &row.tracer, &row.backend].map(Clone::clone);
    let line = |([codec, reduction, tracer, backend], sum, _): ([String; 4], Row, usize)| {
        let mut cells = vec![codec, reduction, format!("{tracer} {backend}")];
        cells.extend(figures(&sum));
        let share = match (sum.moved, sum.moved_bound) {
            (Some(moved), Some(bound)) if bound > 0.0 => format!("{:.0} %", 100.0 * moved / bound),
            (Some(_), Some(_)) => "0 %".into(),
            _ => "–".into(),
        };
        cells.extend([share, format!("{:.0}", sum.time_ms)]);
        cells
    };
    Table {
        title: "By codec".into(),
        notes: vec![
            "Moved: the largest move of a vertex onto the codec's grid, as a share of its bound; the largest share of all \
             scenes."
                .into(),
        ],
        word_columns: 3,
        head: vec![
            "codec", "tree", "tracer", "rays", "missed", "false", "wrong", "adrift", "moved", "ms",
        ],
        rows: merged(rows, by).into_iter().map(line).collect(),
    }
}

fn faults(rows: &[&Row]) -> Table {
    let line = |row: &&Row| {
        let mut cells = vec![row.family.clone(), row.magnitude.clone()];
        cells.push(format!("{} {}", row.tracer, row.backend));
        cells.push(format!("{} {}", row.codec, row.reduction));
        cells.extend(figures(row));
        cells
    };
    let mut notes = vec!["The JSON has one of the rays of each row, as `example`.".to_owned()];
    if rows.len() > MOST_LISTED {
        notes.push(format!("The first {MOST_LISTED} of {}.", rows.len()));
    }
    let is_cut_short = |row: &&Row| row.backend == "gpu" && row.family == "equal centroids";
    if rows.iter().any(is_cut_short) {
        notes.push(
            "Mesa's llvmpipe, a software adapter, ends a thread's loops after 65,535 iterations, which are too few for so many triangles in one place."
                .into(),
        );
    }
    Table {
        title: "Faults".into(),
        notes,
        word_columns: 4,
        head: vec![
            "family",
            "magnitude",
            "tracer",
            "tree",
            "rays",
            "missed",
            "false",
            "wrong",
            "adrift",
        ],
        rows: rows.iter().take(MOST_LISTED).map(line).collect(),
    }
}

/// The number of rays, and of their faults by kind.
fn figures(row: &Row) -> [String; 5] {
    let figures = [
        row.rays,
        row.missed,
        row.false_hits,
        row.wrong_primitive,
        row.adrift,
    ];
    figures.map(count)
}

fn known(number: Option<u32>) -> String {
    number.map_or("–".into(), |number| number.to_string())
}

/// A number of any size.
fn large(x: f64) -> String {
    if x < 1e5 {
        format!("{x:.1}")
    } else {
        format!("{x:.1e}")
    }
}
