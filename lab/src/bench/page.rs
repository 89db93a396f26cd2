//! The report as one self-contained page.

mod plots;
mod table;

use super::findings::{Verdict, percent};
use super::measure::{SceneRecord, SetupRecord};
use super::report::{Report, same_work};
use super::setup::Knob;
use super::times::Times;
use anyhow::Result;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use plots::{Axis, Scale, bars, numbered, scatter};
use slimbvh::Picture;
use slimbvh_cli::output::{count, png_bytes, things};
use std::fmt::Write;

const STYLE: &str = include_str!("page/style.css");

/// The factor by which differences of pictures are enlarged.
const ENLARGED: u8 = 8;

const ERROR: Axis = Axis {
    name: "error of the picture, RMSE of 255",
    of: |record| record.likeness.image_rmse,
    range: None,
    scale: Scale::PowersAndZero,
};

const TIME: Axis = Axis {
    name: "ms a picture",
    of: SetupRecord::frame,
    range: Some(SetupRecord::frame_range),
    scale: Scale::Linear,
};

const BYTES: Axis = Axis {
    name: "bytes a triangle of the mesh",
    of: |record| record.facts.resident_bytes() as f64 / record.facts.mesh_triangles.max(1) as f64,
    range: None,
    scale: Scale::Linear,
};

/// The text with markup escaped.
pub fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for c in text.chars() {
        match c {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '"' => escaped += "&quot;",
            c if c.is_control() => escaped.push(' '),
            c => escaped.push(c),
        }
    }
    escaped
}

/// The whole page. Every element is closed, so that it is XML as well.
pub fn page(report: &Report) -> Result<String> {
    let mut html = format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\
         <title>slimbvh-lab bench</title><style>\n{STYLE}</style></head><body>\n"
    );
    html += "<h1>slimbvh-lab bench</h1>\n";
    if !report.records.is_empty() {
        html += "<p class=\"soft\">One knob at a time around the default, then promising combinations.</p>\n";
    }
    html += "<dl>";
    // Writing to a string cannot fail.
    for (name, value) in report.head() {
        let _ = write!(html, "<dt>{name}</dt><dd>{}</dd>", escaped(&value));
    }
    html += "</dl>\n";
    for scene in &report.records {
        section(&mut html, report, scene)?;
    }
    if !report.scaling.is_empty() {
        growth(&mut html, report)?;
    }
    html += "</body></html>\n";
    Ok(html)
}

fn section(html: &mut String, report: &Report, scene: &SceneRecord) -> Result<()> {
    let SceneRecord { name, backend, .. } = scene;
    let _ = write!(
        html,
        "<h2>{} <span class=\"soft\">on the {}</span></h2>\n<p class=\"soft\">{}, {}, {}. Its diagonal is {}.</p>\n",
        escaped(name),
        backend.to_uppercase(),
        things(scene.triangles, "triangle"),
        count(scene.vertices).to_string() + " vertices",
        things(scene.lights, "light"),
        scene.diagonal
    );
    sentences(html, report, scene);

    *html += "<h3>Pareto fronts</h3>\n<div class=\"cards\">";
    let usual = scene.setups.first().map(|record| record.setup);
    let comparable = scene
        .setups
        .iter()
        .filter(|record| usual.is_some_and(|usual| record.setup.is_comparable(&usual)));
    let comparable: Vec<&SetupRecord> = comparable.collect();
    for (title, axes) in [
        ("Time against error", [ERROR, TIME]),
        ("Bytes against error", [ERROR, BYTES]),
        ("Time against bytes", [BYTES, TIME]),
    ] {
        let svg = scatter(&comparable, axes)?;
        let _ = write!(
            html,
            "<figure><figcaption><b>{title}</b></figcaption>{svg}<ol>"
        );
        for (record, is_clear) in numbered(&comparable, axes) {
            let within = match is_clear {
                true => "",
                false => " <span class=\"soft\">(within the spread)</span>",
            };
            let _ = write!(html, "<li>{}{within}</li>", escaped(&record.name));
        }
        *html += "</ol></figure>\n";
    }
    *html += "</div>\n<h3>Where the time goes</h3>\n<div class=\"legend\">";
    for (part, name) in Times::PARTS.iter().enumerate() {
        let _ = write!(
            html,
            "<span><i style=\"background:var(--part{part})\"></i>{name}</span>"
        );
    }
    let single = scene.setups.iter().filter(|it| it.knob != Knob::Crossed);
    let svg = bars(&single.collect::<Vec<_>>())?;
    let _ = write!(
        html,
        "</div>\n<figure class=\"wide\"><figcaption>Milliseconds, corrected by the default's time in the same rounds</figcaption>{svg}</figure>\n"
    );
    pictures(html, scene)?;
    *html += "<h3>All figures</h3>\n<p class=\"soft\">● marks the Pareto front of time, bytes and error among the setups that rebuild with \
              as many threads as the default; ○ what is there by less than the spread of these runs.</p>\n";
    if let Some(text) = same_work(scene) {
        let _ = writeln!(html, "<p class=\"soft\">{}</p>", escaped(&text));
    }
    *html += &table::table(report.rows_of(scene));
    Ok(())
}

/// The growth of costs, with exponents.
fn growth(html: &mut String, report: &Report) -> Result<()> {
    *html += "<h2>How costs grow</h2>\n<p class=\"soft\">One whole tree over a terrain, without codecs. The table has the exponents of growth, \
              fitted by least squares to the logarithms; with threads, -1 is ideal.</p>\n<div class=\"legend\">";
    for (part, name) in plots::GROWING {
        let _ = write!(
            html,
            "<span><i style=\"background:var(--part{part})\"></i>{name}, ms</span>"
        );
    }
    *html += "</div>\n<div class=\"cards\">";
    for series in &report.scaling {
        let (of, place) = (series.of, series.backend.to_uppercase());
        let svg = plots::growth(series)?;
        let left_out = series.left_out.as_deref().map(escaped);
        let left_out = left_out.map_or(String::new(), |why| format!("<br/>{why}"));
        let _ = writeln!(
            html,
            "<figure><figcaption><b>{of}</b> on the {place}{left_out}</figcaption>{svg}</figure>"
        );
    }
    *html += "</div>\n<h3>Exponents</h3>\n";
    *html += &table::exponents(&report.scaling);
    Ok(())
}

/// The findings, grouped by verdict.
fn sentences(html: &mut String, report: &Report, scene: &SceneRecord) {
    for (title, class, verdict) in [
        ("Properties that fail", "loses", Verdict::Fails),
        ("Where slimbvh wins", "wins", Verdict::Wins),
        ("Where slimbvh does not", "loses", Verdict::Loses),
        ("What the spread of these runs hides", "open", Verdict::Open),
        ("Properties that hold", "holds", Verdict::Holds),
    ] {
        let findings = report.findings_of(scene);
        let mut texts = findings.filter(|it| it.verdict == verdict).peekable();
        if texts.peek().is_none() {
            continue;
        }
        let _ = writeln!(html, "<h3>{title}</h3>\n<ul class=\"found {class}\">");
        for finding in texts {
            let _ = writeln!(html, "<li>{}</li>", escaped(&finding.text));
        }
        *html += "</ul>\n";
    }
}

/// The plain tree's picture, and the differences of the others from it.
fn pictures(html: &mut String, scene: &SceneRecord) -> Result<()> {
    let plain = scene.picture.to_srgb();
    let size = [scene.picture.width, scene.picture.height];
    *html += "<h3>Pictures</h3>\n<div class=\"cards\">";
    let title = "the plain tree's picture";
    figure(
        html,
        title,
        "the reference of all comparisons",
        &data_uri(size, &plain)?,
    );
    let single = scene.setups.iter().filter(|it| it.knob != Knob::Crossed);
    for record in single {
        let Some(picture) = &record.picture else {
            continue;
        };
        let likeness = &record.likeness;
        let text = format!(
            "difference, {ENLARGED} times: {} of pixels, RMSE {:.3}, SSIM {:.5}",
            super::findings::share(likeness.changed_pixels),
            likeness.image_rmse,
            likeness.ssim
        );
        let uri = data_uri(size, &difference(picture, &plain))?;
        figure(html, &record.name, &text, &uri);
    }
    let same = scene
        .setups
        .iter()
        .filter(|it| it.picture.is_none())
        .count();
    let _ = writeln!(
        html,
        "</div>\n<p class=\"soft\">{} of {} setups make the same picture, byte for byte ({}).</p>",
        same,
        scene.setups.len(),
        percent(same as f64 / scene.setups.len().max(1) as f64)
    );
    Ok(())
}

fn figure(html: &mut String, title: &str, text: &str, uri: &str) {
    let title = escaped(title);
    let _ = writeln!(
        html,
        "<figure><figcaption><b>{title}</b><br/>{}</figcaption><img alt=\"{title}\" src=\"{uri}\"/></figure>",
        escaped(text)
    );
}

/// The difference of each byte, enlarged.
fn difference(picture: &Picture, plain: &[u8]) -> Vec<u8> {
    let own = picture.to_srgb();
    let pairs = own.iter().zip(plain);
    pairs
        .map(|(a, b)| a.abs_diff(*b).saturating_mul(ENLARGED))
        .collect()
}

fn data_uri(size: [u32; 2], pixels: &[u8]) -> Result<String> {
    let png = png_bytes(size, pixels)?;
    Ok(format!(
        "data:image/png;base64,{}",
        BASE64_STANDARD.encode(png)
    ))
}
