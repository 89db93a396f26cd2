//! The table of all measurements of a scene, one setup per row.

use super::super::findings::share;
use super::super::report::ms;
use super::super::row::Row;
use super::super::scaling::{COSTS, Exponent, Series};
use super::escaped;
use std::fmt::Write;

/// A column: its name, its description and its cells.
type Column = (&'static str, &'static str, fn(&Row) -> String);

const COLUMNS: [Column; 26] = [
    ("picture ms", "from the mesh to the picture", |r| {
        ms(r.frame_ms)
    }),
    (
        "±",
        "spread of the ratio to the default, as a share of it; of the default, spread of its times",
        |r| share(r.frame_spread),
    ),
    (
        "× default",
        "ratio to the default's time in the same round, median over rounds",
        |r| format!("{:.2}", r.frame_ratio),
    ),
    ("plan", "milliseconds to plan the reduction", |r| {
        part_ms(r.plan_ms)
    }),
    (
        "build",
        "milliseconds of all other stages of the build",
        |r| part_ms(r.build_ms),
    ),
    (
        "encode",
        "milliseconds to encode nodes and triangles",
        |r| part_ms(r.encode_ms),
    ),
    ("primary", "milliseconds for rays from the eye", |r| {
        part_ms(r.primary_ms)
    }),
    ("shadow", "milliseconds for rays to lights", |r| {
        part_ms(r.shadow_ms)
    }),
    (
        "reflection",
        "milliseconds for rays from mirrors and through glass",
        |r| part_ms(r.reflection_ms),
    ),
    ("rest", "milliseconds for shading and pixels", |r| {
        part_ms(r.rest_ms)
    }),
    ("trees", "number of trees", |r| r.trees.to_string()),
    ("node KiB", "of all trees", |r| kib(r.node_bytes)),
    ("triangle KiB", "of all leaves", |r| kib(r.triangle_bytes)),
    (
        "peak KiB",
        "peak memory for the picture, the mesh included",
        |r| kib(r.peak_bytes),
    ),
    (
        "SAH",
        "cost of the tree for rays from the eye by the surface area heuristic",
        |r| format!("{:.1}", r.sah_cost),
    ),
    ("boxes a ray", "box tests, counted", |r| {
        format!("{:.1}", r.box_tests_per_ray)
    }),
    ("triangles a ray", "triangle tests, counted", |r| {
        format!("{:.2}", r.triangle_tests_per_ray)
    }),
    ("bytes a ray", "of nodes and triangles, counted", |r| {
        format!("{:.0}", r.bytes_per_ray)
    }),
    (
        "moved, most",
        "largest move of a vertex, in the scene's unit",
        |r| small(r.vertex_moved_most),
    ),
    ("moved, RMS", "over all vertices", |r| {
        small(r.vertex_moved_rms)
    }),
    ("bound", "largest possible move of a vertex", |r| {
        small(r.vertex_moved_bound)
    }),
    (
        "distance off",
        "largest difference of hit distances, in the scene's unit",
        |r| small(r.distance_error_most),
    ),
    ("other triangle", "samples that see another triangle", |r| {
        share(r.changed_primitives)
    }),
    ("other pixels", "pixels with a differing byte", |r| {
        share(r.changed_pixels)
    }),
    ("RMSE", "of 255", |r| small(r.image_rmse)),
    ("SSIM", "1 for equal pictures", |r| format!("{:.5}", r.ssim)),
];

/// The table in a scrolling box. A dot marks the Pareto front of time, bytes and error, a ring what may be there.
pub fn table<'a>(rows: impl Iterator<Item = &'a Row>) -> String {
    let mut html = String::from("<div class=\"table\"><table><thead><tr><th>setup</th>");
    // Writing to a string cannot fail.
    for (name, sentence, _) in COLUMNS {
        let _ = write!(
            html,
            "<th title=\"{}\">{}</th>",
            escaped(sentence),
            escaped(name)
        );
    }
    html += "</tr></thead><tbody>\n";
    for row in rows {
        let class = match (row.on_front, row.front_is_clear) {
            (true, true) => " class=\"front\"",
            (true, false) => " class=\"maybe\"",
            (false, _) => "",
        };
        let _ = write!(html, "<tr{class}><th>{}</th>", escaped(&row.setup));
        for (_, _, of) in COLUMNS {
            let _ = write!(html, "<td>{}</td>", of(row));
        }
        html += "</tr>\n";
    }
    html += "</tbody></table></div>\n";
    html
}

/// The table of the exponents of growth.
pub fn exponents(all: &[Series]) -> String {
    let mut html = String::from("<div class=\"table\"><table><thead><tr><th>with more</th>");
    for (cost, _) in COSTS {
        let _ = write!(html, "<th>{cost}</th>");
    }
    html += "</tr></thead><tbody>\n";
    for series in all {
        let place = series.backend.to_uppercase();
        let _ = write!(html, "<tr><th>{}, {place}</th>", series.of);
        for (cost, _) in COSTS {
            let fitted = series.exponents.iter().find(|it| it.cost == cost);
            let cell = fitted.map_or(String::new(), Exponent::text);
            let _ = write!(html, "<td>{cell}</td>");
        }
        html += "</tr>\n";
    }
    html += "</tbody></table></div>\n";
    html
}

/// A part of a time; 0 if there is none of it.
fn part_ms(time: f64) -> String {
    match time {
        0.0 => "0".into(),
        time => ms(time),
    }
}

fn kib(bytes: usize) -> String {
    format!("{:.0}", bytes as f64 / 1024.0)
}

/// A value with three digits, also if it is small.
fn small(value: f64) -> String {
    match value {
        0.0 => "0".into(),
        value if value < 0.001 => format!("{value:.2e}"),
        value => format!("{value:.4}"),
    }
}
