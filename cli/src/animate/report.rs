//! The report on an animation, as text and JSON.

use super::AnimateArguments;
use super::record::{Record, Sums, Times, ms, worst};
use crate::median;
use crate::output::{count, things};
use clap::ValueEnum;
use serde::Serialize;
use slimbvh::animate::Action;
use slimbvh::{RenderReport, Scene, Stages};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::time::Duration;

/// The table has one row a frame up to this number of frames; beyond, only the median and the worst.
const MOST_ROWS: usize = 24;

/// A finished animation.
pub struct Run {
    pub backend: &'static str,
    pub adapter: Option<String>,
    pub threads: usize,
    pub records: Vec<Record>,
    /// Time of the survey of surfaces, which is made once.
    pub survey: Duration,
    /// The plan of the first frame, in words.
    pub plan: Vec<(String, String)>,
    /// What the backend decided by itself in the last frame.
    pub decided: Vec<(String, String)>,
}

/// The summary of an animation, for `--json`.
#[derive(Debug, Serialize)]
pub struct Summary {
    scene: String,
    out: Option<String>,
    width: u32,
    height: u32,
    samples_per_pixel: u32,
    backend: &'static str,
    adapter: Option<String>,
    threads: usize,
    triangles: usize,
    dropped_faces: usize,
    orbit: bool,
    orbit_light: bool,
    deform: Option<String>,
    update: String,
    survey_ms: f64,
    plan: Vec<String>,
    shutter: f64,
    shutter_times: u32,
    frames: Vec<FrameSummary>,
    totals: Totals,
}

#[derive(Debug, Serialize)]
struct FrameSummary {
    tree: &'static str,
    sah_cost: Option<f64>,
    pose_ms: f64,
    build_ms: BTreeMap<&'static str, f64>,
    render_ms: BTreeMap<&'static str, f64>,
    total_ms: f64,
    write_ms: f64,
    #[serde(flatten)]
    rays: Rays,
}

#[derive(Debug, Serialize)]
struct Rays {
    primary_rays: u64,
    primary_hits: u64,
    shadow_rays: u64,
    mirror_rays: u64,
}

#[derive(Debug, Serialize)]
struct Totals {
    rebuilt: usize,
    refitted: usize,
    kept: usize,
    pose_ms: f64,
    build_ms: BTreeMap<&'static str, f64>,
    render_ms: BTreeMap<&'static str, f64>,
    total_ms: f64,
    write_ms: f64,
    frames_per_second: f64,
    #[serde(flatten)]
    rays: Rays,
}

pub fn summarize(arguments: &AnimateArguments, scene: &Scene, run: &Run) -> Summary {
    let [width, height] = arguments.picture.sight.size;
    let sums = Sums::of(&run.records);
    let out = arguments.out.as_ref();
    Summary {
        scene: arguments.scene.name(),
        out: out.map(|path| path.display().to_string()),
        width,
        height,
        samples_per_pixel: arguments.picture.spp,
        backend: run.backend,
        adapter: run.adapter.clone(),
        threads: run.threads,
        triangles: scene.mesh.indices.len(),
        dropped_faces: scene.dropped_face_count,
        orbit: arguments.orbit,
        orbit_light: arguments.orbit_light,
        deform: arguments.deform.map(|deform| name(&deform)),
        update: name(&arguments.update),
        survey_ms: ms(run.survey),
        plan: (run.plan.iter().chain(&run.decided))
            .map(|(about, what)| format!("{about}: {what}"))
            .collect(),
        shutter: arguments.shutter,
        shutter_times: arguments.shutter_times,
        frames: run.records.iter().map(frame).collect(),
        totals: Totals {
            rebuilt: sums.actions.rebuilt,
            refitted: sums.actions.refitted,
            kept: sums.actions.kept,
            pose_ms: ms(sums.pose),
            build_ms: by_stage(&sums.build),
            render_ms: by_stage(&sums.report.stages),
            total_ms: ms(sums.total),
            write_ms: ms(sums.write),
            frames_per_second: frames_per_second(run, &sums),
            rays: rays(&sums.report),
        },
    }
}

fn frame(record: &Record) -> FrameSummary {
    FrameSummary {
        tree: done(record.actions.most()),
        sah_cost: record.cost,
        pose_ms: ms(record.pose),
        build_ms: by_stage(&record.build),
        render_ms: by_stage(&record.report.stages),
        total_ms: ms(record.total),
        write_ms: ms(record.write),
        rays: rays(&record.report),
    }
}

fn rays(report: &RenderReport) -> Rays {
    Rays {
        primary_rays: report.primary_ray_count,
        primary_hits: report.primary_hit_count,
        shadow_rays: report.shadow_ray_count,
        mirror_rays: report.mirror_ray_count,
    }
}

fn by_stage(stages: &Stages) -> BTreeMap<&'static str, f64> {
    stages
        .iter()
        .map(|(stage, time)| (stage, ms(time)))
        .collect()
}

fn frames_per_second(run: &Run, sums: &Sums) -> f64 {
    run.records.len() as f64 / sums.total.as_secs_f64()
}

fn done(action: Action) -> &'static str {
    match action {
        Action::Rebuilt => "rebuilt",
        Action::Refitted => "refitted",
        Action::Kept => "kept",
    }
}

/// The name of a value on the command line.
fn name(value: &impl ValueEnum) -> String {
    let value = value.to_possible_value();
    value.map_or_else(String::new, |value| value.get_name().into())
}

/// The summary as text.
pub fn describe(arguments: &AnimateArguments, scene: &Scene, run: &Run) -> String {
    let mut text = String::new();
    head(&mut text, arguments, scene, run);
    table(&mut text, &run.records);
    foot(&mut text, run);
    if arguments.reduce.explain {
        for (about, what) in run.plan.iter().chain(&run.decided) {
            line(&mut text, about, what);
        }
    }
    text
}

fn head(text: &mut String, arguments: &AnimateArguments, scene: &Scene, run: &Run) {
    let triangles = things(scene.mesh.indices.len(), "triangle");
    line(
        text,
        "scene",
        &format!("{}, {triangles}", arguments.scene.name()),
    );
    if scene.dropped_face_count > 0 {
        line(
            text,
            "dropped",
            &things(scene.dropped_face_count, "broken face"),
        );
    }
    let [width, height] = arguments.picture.sight.size;
    let samples = things(arguments.picture.spp, "sample");
    let machine = match &run.adapter {
        Some(adapter) => adapter.clone(),
        None => things(run.threads, "thread"),
    };
    line(
        text,
        "frames",
        &format!(
            "{}, {width}x{height}, {samples} a pixel, {machine}",
            run.records.len()
        ),
    );
    if arguments.shutter > 0.0 || arguments.shutter_times > 1 {
        let times = things(arguments.shutter_times, "time");
        line(
            text,
            "shutter",
            &format!(
                "open for {} of a frame, seen at {times}; figures are sums over them",
                arguments.shutter
            ),
        );
    }
    if let Some(out) = &arguments.out {
        line(text, "out", &out.display().to_string());
    }
}

/// A table with one row a frame, or with the median and the worst of each column.
fn table(text: &mut String, records: &[Record]) {
    let head = "frame   tree       SAH cost   pose ms  build ms  trace ms  shade ms  total ms";
    let _ = writeln!(text, "{head}");
    let mut row = |name: &str, tree: &str, cost: Option<f64>, times: Times| {
        let cost = cost.map_or_else(|| "-".into(), |cost| format!("{cost:.2}"));
        let Times {
            pose,
            build,
            trace,
            shade,
            total,
        } = times;
        let _ = writeln!(
            text,
            "{name:>6}  {tree:<9} {cost:>9} {pose:>9.2} {build:>9.2} {trace:>9.2} {shade:>9.2} {total:>9.2}"
        );
    };
    let times: Vec<Times> = records.iter().map(Record::times).collect();
    if records.len() <= MOST_ROWS {
        for (i, record) in records.iter().enumerate() {
            row(
                &i.to_string(),
                done(record.actions.most()),
                record.cost,
                times[i],
            );
        }
        return;
    }
    let costs: Option<Vec<f64>> = records.iter().map(|record| record.cost).collect();
    let cost = |pick: fn(&mut [f64]) -> f64| costs.clone().map(|mut costs| pick(&mut costs));
    row("median", "", cost(median), Times::by_column(&times, median));
    row("worst", "", cost(worst), Times::by_column(&times, worst));
}

/// Sums over all frames, one line each.
fn foot(text: &mut String, run: &Run) {
    let sums = Sums::of(&run.records);
    line(
        text,
        "tree",
        &format!(
            "{} rebuilt, {} refitted, {} kept",
            sums.actions.rebuilt, sums.actions.refitted, sums.actions.kept
        ),
    );
    let stages = |stages: &Stages| format!("{:.2} ms: {stages}", ms(stages.total()));
    if run.survey > Duration::ZERO {
        line(text, "survey", &format!("{:.2} ms, once", ms(run.survey)));
    }
    line(text, "pose", &format!("{:.2} ms", ms(sums.pose)));
    if sums.build.iter().next().is_some() {
        line(text, "build", &stages(&sums.build));
    }
    line(text, "render", &stages(&sums.report.stages));
    let report = &sums.report;
    line(
        text,
        "rays",
        &format!(
            "{} primary ({} hit), {} shadow, {} mirror",
            count(report.primary_ray_count),
            count(report.primary_hit_count),
            count(report.shadow_ray_count),
            count(report.mirror_ray_count)
        ),
    );
    line(
        text,
        "total",
        &format!(
            "{:.2} ms, {:.2} frames a second; {:.2} ms more to write them",
            ms(sums.total),
            frames_per_second(run, &sums),
            ms(sums.write)
        ),
    );
}

/// Writing to a string cannot fail.
fn line(text: &mut String, name: &str, value: &str) {
    let _ = writeln!(text, "{name:<10} {value}");
}
