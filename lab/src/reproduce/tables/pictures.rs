//! Tables II, V and VI: pictures.

use super::{NOTHING, nothing, percent, ratio, time};
use crate::measure::rounds::Rounds;
use crate::measure::table::Table;
use crate::reproduce::layout::Sorting;
use crate::reproduce::measure::{LightsRecord, Pictures, SceneRecord};
use crate::reproduce::printed;
use crate::reproduce::times::Picture;
use slimbvh_cli::output::count;

/// The pictures with reduced trees, by way of sorting.
fn ways(pictures: &Pictures) -> Vec<(&'static str, &Rounds<Picture>)> {
    let name = |sorting: Sorting| match sorting {
        Sorting::Once => "ours, sorted once",
        Sorting::Each => "ours, sorted alone",
    };
    let reduced = pictures.reduced.iter();
    reduced
        .map(|reduced| (name(reduced.sorting), &reduced.rounds))
        .collect()
}

pub fn primary_and_one_light(records: &[SceneRecord]) -> Table {
    let mut rows = Vec::new();
    for record in records {
        match &record.printed {
            Some(printed) => {
                let default = [printed.primary[0], printed.pictures[0][0]];
                let reduced = [printed.primary[1], printed.pictures[1][0]];
                rows.push(vec![
                    record.name.to_owned(),
                    "printed".to_owned(),
                    time(default[0]),
                    time(default[1]),
                    time(reduced[0]),
                    time(reduced[1]),
                    ratio(default[0] / reduced[0]),
                    ratio(default[1] / reduced[1]),
                    NOTHING.to_owned(),
                ]);
            }
            None => rows.push(nothing(record, 9)),
        }
        for pictures in record
            .pictures
            .iter()
            .filter(|pictures| pictures.samples == 1)
        {
            let default = &pictures.default;
            for (by, reduced) in ways(pictures) {
                rows.push(vec![
                    record.name.to_owned(),
                    format!("{by}, {}", record.light_set),
                    time(default.median(Picture::primary_total)),
                    time(default.median(Picture::total)),
                    time(reduced.median(Picture::primary_total)),
                    time(reduced.median(Picture::total)),
                    ratio(default.ratio(Picture::primary_total, reduced, Picture::primary_total)),
                    ratio(default.ratio(Picture::total, reduced, Picture::total)),
                    percent(
                        default
                            .spread(Picture::total)
                            .max(reduced.spread(Picture::total)),
                    ),
                ]);
            }
        }
    }
    Table {
        title: "Table II: primary rays, and primary rays with one light, ms".into(),
        notes: vec![
            "Construction included. Default: one tree over everything. Reduced: a set for the camera and one for the light. Ratios are \
             default / reduced, above 1 if reduced is faster. One light: shadow rays and shading as well. The light's set is named: L- if \
             the camera is outside of all closed surfaces, as L- then omits the triangles that rays to the light start on (see What a ray meets); \
             the paper takes the smaller set."
                .into(),
        ],
        word_columns: 2,
        head: vec![
            "scene", "by", "default", "one light", "reduced", "one light", "ratio", "one light", "spread",
        ],
        rows,
    }
}

/// One table per number of lights.
pub fn near_lights(record: &SceneRecord) -> Vec<Table> {
    record
        .lights
        .iter()
        .map(|lights| near_lights_of(record, lights))
        .collect()
}

fn near_lights_of(record: &SceneRecord, lights: &LightsRecord) -> Table {
    let mut rows = Vec::new();
    if let Some([default, grouped]) = printed::lights(lights.lights) {
        let both = default.total / grouped.total;
        for (name, row, gain) in [
            ("default", &default, f64::NAN),
            ("one set for all, L+", &grouped, both),
        ] {
            rows.push(vec![
                "printed".to_owned(),
                name.to_owned(),
                count(row.triangles),
                pair(row.division),
                pair(row.construction),
                time(row.primary),
                time(row.shadow),
                NOTHING.to_owned(),
                time(row.total),
                ratio(gain),
            ]);
        }
    }
    for row in &lights.rows {
        let rounds = &row.rounds;
        let median = |of: fn(&Picture) -> f64| rounds.median(of);
        let gain = match lights.rows.first() {
            Some(default) => default.rounds.ratio(Picture::total, rounds, Picture::total),
            None => f64::NAN,
        };
        rows.push(vec![
            "ours".to_owned(),
            row.name.to_owned(),
            count(row.triangles),
            pair([
                median(|p| p.camera_build.division),
                median(|p| p.shadow_build.division),
            ]),
            pair([
                median(|p| p.camera_build.construction),
                median(|p| p.shadow_build.construction),
            ]),
            time(median(|p| p.primary)),
            time(median(|p| p.shadow)),
            time(median(|p| p.rest)),
            time(median(Picture::total)),
            ratio(gain),
        ]);
    }
    Table {
        title: format!(
            "Table V: {} lights near each other over the {}, ms",
            lights.lights, record.name
        ),
        notes: vec![
            format!(
                "Lights stand in a square above the model, {:.0} units apart. They share a set by the R rule, which keeps triangles that face any point of \
                 the ball around them: {:.1} % of the triangles, as printed. Triangles: of all trees for shadow rays. Division and \
                 construction: camera + lights; all sets come from one order, whose time is the camera's. Ratio: default / this row.",
                lights.spacing,
                100.0 * lights.share
            ),
            format!("The plan chooses {}.", lights.plan),
        ],
        word_columns: 2,
        head: vec![
            "by",
            "sets for lights",
            "triangles",
            "division",
            "construction",
            "primary",
            "shadow",
            "shading",
            "total",
            "ratio",
        ],
        rows,
    }
}

fn pair([camera, lights]: [f64; 2]) -> String {
    if lights == 0.0 {
        time(camera)
    } else {
        format!("{} + {}", time(camera), time(lights))
    }
}

pub fn supersampling(records: &[SceneRecord]) -> Table {
    let grid = |samples: u32| samples.isqrt();
    let mut rows = Vec::new();
    for record in records {
        for pictures in &record.pictures {
            let place = match grid(pictures.samples) {
                1 => Some(0),
                4 => Some(1),
                16 => Some(2),
                _ => None,
            };
            let shown = format!("{0}×{0}", grid(pictures.samples));
            let printed = record.printed.as_ref().zip(place);
            let [default, reduced] = match printed {
                Some((printed, place)) => printed.pictures.map(|times| times[place]),
                None => [f64::NAN; 2],
            };
            rows.push(vec![
                record.name.to_owned(),
                shown.clone(),
                "printed".to_owned(),
                time(default),
                time(reduced),
                ratio(default / reduced),
                NOTHING.to_owned(),
                NOTHING.to_owned(),
            ]);
            for (by, rounds) in ways(pictures) {
                let of = Picture::total;
                rows.push(vec![
                    record.name.to_owned(),
                    shown.clone(),
                    by.to_owned(),
                    time(pictures.default.median(of)),
                    time(rounds.median(of)),
                    ratio(pictures.default.ratio(of, rounds, of)),
                    percent(pictures.default.spread(of).max(rounds.spread(of))),
                    rounds.0.len().to_string(),
                ]);
            }
        }
    }
    Table {
        title: "Table VI: supersampling, primary and shadow rays, ms".into(),
        notes: vec![
            "Construction included, as in Table II. With more rays the construction matters less."
                .into(),
        ],
        word_columns: 3,
        head: vec![
            "scene", "samples", "by", "default", "reduced", "ratio", "spread", "rounds",
        ],
        rows,
    }
}
