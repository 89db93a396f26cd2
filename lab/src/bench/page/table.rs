//! All figures of a scene, a setup a line.

use super::super::findings::share;
use super::super::row::Row;
use super::super::scaling::{COSTS, Exponent, Series};
use super::escaped;
use std::fmt::Write;

/// What a column is of, in a word and in a sentence.
type Column = (&'static str, &'static str, fn(&Row) -> String);

const COLUMNS: [Column; 26] = [
    ("picture ms", "from the mesh to the picture, median", |r| {
        format!("{:.2}", r.frame_ms)
    }),
    (
        "±",
        "from the fastest to the slowest, as a share of the median",
        |r| share(r.frame_spread),
    ),
    (
        "× default",
        "median over rounds of how many times the default's time of the same round",
        |r| format!("{:.2}", r.frame_ratio),
    ),
    (
        "plan",
        "milliseconds to find out what may be left out",
        |r| ms(r.plan_ms),
    ),
    (
        "build",
        "milliseconds of all other stages of the build",
        |r| ms(r.build_ms),
    ),
    ("encode", "milliseconds for codecs", |r| ms(r.encode_ms)),
    ("primary", "milliseconds for rays from the eye", |r| {
        ms(r.primary_ms)
    }),
    ("shadow", "milliseconds for rays to lights", |r| {
        ms(r.shadow_ms)
    }),
    (
        "reflection",
        "milliseconds for rays from mirrors and through glass",
        |r| ms(r.reflection_ms),
    ),
    ("rest", "milliseconds for shading and pixels", |r| {
        ms(r.rest_ms)
    }),
    ("trees", "how many", |r| r.trees.to_string()),
    ("node KiB", "of all trees", |r| kib(r.node_bytes)),
    ("triangle KiB", "of all leaves", |r| kib(r.triangle_bytes)),
    (
        "peak KiB",
        "all memory that was needed for the picture, the mesh included",
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
        "how far a vertex moved, in the scene's unit",
        |r| small(r.vertex_moved_most),
    ),
    ("moved, RMS", "over all vertices", |r| {
        small(r.vertex_moved_rms)
    }),
    ("bound", "how far a vertex may move", |r| {
        small(r.vertex_moved_bound)
    }),
    (
        "distance off",
        "the most that a hit is nearer or farther, in the scene's unit",
        |r| small(r.distance_error_most),
    ),
    ("other triangle", "samples that see another triangle", |r| {
        share(r.changed_primitives)
    }),
    ("other pixels", "pixels of which any byte differs", |r| {
        share(r.changed_pixels)
    }),
    ("RMSE", "of 255", |r| small(r.image_rmse)),
    ("SSIM", "1 for equal pictures", |r| format!("{:.5}", r.ssim)),
];

/// The table in a box that scrolls. A dot marks what nothing is better than in time, bytes and error.
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
        let class = if row.on_front { " class=\"front\"" } else { "" };
        let _ = write!(html, "<tr{class}><th>{}</th>", escaped(&row.setup));
        for (_, _, of) in COLUMNS {
            let _ = write!(html, "<td>{}</td>", of(row));
        }
        html += "</tr>\n";
    }
    html += "</tbody></table></div>\n";
    html
}

/// The powers that costs grow by.
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

fn ms(ms: f64) -> String {
    match ms {
        0.0 => "0".into(),
        ms => format!("{ms:.2}"),
    }
}

fn kib(bytes: usize) -> String {
    format!("{:.0}", bytes as f64 / 1024.0)
}

/// Three digits of what may be small.
fn small(value: f64) -> String {
    match value {
        0.0 => "0".into(),
        value if value < 0.001 => format!("{value:.2e}"),
        value => format!("{value:.4}"),
    }
}
