//! The record's tables, in Markdown.

use crate::measure::{MeshRecord, Run, Samples, TracerRecord};
use crate::options::Options;
use crate::summary;
use anyhow::Result;
use slimbvh_bench::Agreement;
use slimbvh_bench::machine;
use slimbvh_bench::tracers::{OURS, PEER, Visits};
use std::fmt::Write;

/// Targets of the ratios.
const BUILD_AIM: Aim = Aim::at_most(1.0, 2.0);
const TRACE_AIM: Aim = Aim::at_least(1.0, 0.8);
const NODE_BYTES_AIM: Aim = Aim::at_most(32.0, 56.0);

/// An aim: a bound to reach, and a bound that must hold.
struct Aim {
    aimed: f64,
    required: f64,
    /// 1 if less is better, -1 if more is.
    sign: f64,
}

impl Aim {
    const fn at_most(aimed: f64, required: f64) -> Self {
        let sign = 1.0;
        Self {
            aimed,
            required,
            sign,
        }
    }

    const fn at_least(aimed: f64, required: f64) -> Self {
        let sign = -1.0;
        Self {
            aimed,
            required,
            sign,
        }
    }

    /// The value, and the stricter of the bounds that it keeps.
    fn judge(&self, value: f64) -> String {
        let keeps = |bound: f64| value * self.sign <= bound * self.sign;
        let word = if keeps(self.aimed) {
            "aim"
        } else if keeps(self.required) {
            "required"
        } else {
            "**missed**"
        };
        format!("{value:.2} {word}")
    }
}

/// The whole record.
pub fn report(records: &[MeshRecord], options: &Options) -> Result<String> {
    let mut out = String::new();
    head(&mut out, records, options)?;
    aims(&mut out, records)?;
    summary::frames(&mut out, records)?;
    summary::traces(&mut out, records)?;
    summary::missed(&mut out, records)?;
    builds(&mut out, records)?;
    stages(&mut out, records)?;
    traces(&mut out, records)?;
    answers(&mut out, records)?;
    Ok(out)
}

/// The record of the tracer with this name.
fn named<'a>(record: &'a MeshRecord, name: &str) -> Option<&'a TracerRecord> {
    record.tracers.iter().find(|tracer| tracer.name == name)
}

fn head(out: &mut String, records: &[MeshRecord], options: &Options) -> Result<()> {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let flags = match env!("BENCH_RUSTFLAGS") {
        "" => "none",
        flags => flags,
    };
    let mut features = Vec::new();
    if cfg!(feature = "parallel") {
        features.push("parallel");
    }
    if cfg!(feature = "small-nodes") {
        features.push("small_bvh2_node");
    }
    if features.is_empty() {
        features.push("none");
    }
    let features = features.join(", ");
    writeln!(out, "# slimbvh and its peers side by side\n")?;
    writeln!(out, "| | |\n|---|---|")?;
    writeln!(out, "| date | {} |", machine::date())?;
    writeln!(
        out,
        "| processor | {}, {threads} threads |",
        machine::processor()
    )?;
    writeln!(out, "| compiler | {} |", env!("BENCH_RUSTC"))?;
    writeln!(out, "| flags | `{flags}` ({}) |", machine::vectors())?;
    writeln!(out, "| obvhs' features | {features} |")?;
    writeln!(out, "| command | `{}` |", options.command())?;
    writeln!(out, "| rounds | {} |", options.rounds)?;
    writeln!(out, "| rays | {} |\n", options.order)?;
    writeln!(
        out,
        "Times are medians in milliseconds, with the smallest and the largest; the tracers took turns at each job. What is measured \
         and how: [README](../README.md).\n"
    )?;
    let has_embree = |record: &MeshRecord| {
        let mut tracers = record.tracers.iter();
        tracers.any(|tracer| tracer.library_and_tree().0 == "embree")
    };
    if records.iter().any(has_embree) {
        return Ok(());
    }
    writeln!(
        out,
        "For scale: Embree's Morton build of the dragon takes 87 ms on one thread (own measurement with Embree 3.13 on \
         the same kind of machine, not part of this run).\n"
    )?;
    Ok(())
}

/// The table of ratios, with the bounds that they keep.
fn aims(out: &mut String, records: &[MeshRecord]) -> Result<()> {
    writeln!(out, "## Aims\n")?;
    writeln!(
        out,
        "slimbvh with 30-bit codes against obvhs' fastest preset. Build and frame: slimbvh's time as a multiple of \
         obvhs', required at most {:.1}, aimed at {:.1}. Rays: slimbvh's rays a second as a multiple of obvhs', required \
         at least {:.1}, aimed at {:.1}. Nodes: bytes a triangle, required at most {}, aimed at {}. A frame is build, \
         primary and shadow rays. Ratios are medians of the rounds' ratios, that of frames is of medians.\n",
        BUILD_AIM.required,
        BUILD_AIM.aimed,
        TRACE_AIM.required,
        TRACE_AIM.aimed,
        NODE_BYTES_AIM.required,
        NODE_BYTES_AIM.aimed,
    )?;
    writeln!(
        out,
        "| mesh | threads | build, buffers kept | build, new buffers | primary | shadow | frame | nodes |\n\
         |---|--:|--:|--:|--:|--:|--:|--:|"
    )?;
    for record in records {
        let (Some(ours), Some(peer)) = (named(record, OURS), named(record, PEER)) else {
            continue;
        };
        let node_bytes = ours.bytes.nodes.unwrap_or(0) as f64 / record.triangle_count as f64;
        for (a, b) in ours.runs.iter().zip(&peer.runs) {
            let speedup = |of: fn(&Run) -> &Samples| of(b).ratio(of(a));
            writeln!(
                out,
                "| {} | {} | {} | {} | {} | {} | {:.2} | {} |",
                record.name,
                a.threads,
                BUILD_AIM.judge(a.build.ratio(&b.build)),
                BUILD_AIM.judge(a.first_build.ratio(&b.first_build)),
                TRACE_AIM.judge(speedup(|run| &run.primary)),
                TRACE_AIM.judge(speedup(|run| &run.shadow)),
                a.frame_ms() / b.frame_ms(),
                NODE_BYTES_AIM.judge(node_bytes),
            )?;
        }
    }
    writeln!(out)?;
    Ok(())
}

fn builds(out: &mut String, records: &[MeshRecord]) -> Result<()> {
    writeln!(out, "## Build\n")?;
    writeln!(
        out,
        "| mesh | triangles | tracer | threads | buffers kept | new buffers | M triangles/s | node bytes/triangle | \
         all bytes/triangle |\n|---|--:|---|--:|--:|--:|--:|--:|--:|"
    )?;
    for record in records {
        let count = record.triangle_count as f64;
        let per_triangle = |bytes: Option<usize>| {
            bytes.map_or("–".into(), |bytes| format!("{:.1}", bytes as f64 / count))
        };
        for (tracer, run) in runs(record) {
            writeln!(
                out,
                "| {} | {} | {} | {} | {} | {} | {:.1} | {} | {} |",
                record.name,
                record.triangle_count,
                tracer.name,
                run.threads,
                spread(&run.build),
                spread(&run.first_build),
                count / run.build.median() / 1e3,
                per_triangle(tracer.bytes.nodes),
                per_triangle(tracer.bytes.all),
            )?;
        }
    }
    let lists = records
        .iter()
        .map(|record| format!("{} {:.1} ms", record.name, record.input_ms));
    let lists: Vec<String> = lists.collect();
    writeln!(
        out,
        "\nobvhs is given its list of triangles ready made. Making it from vertices and indices on one thread, in new \
         memory: {}.\n",
        lists.join(", ")
    )?;
    Ok(())
}

/// The table of stages, as shares of slimbvh's build.
fn stages(out: &mut String, records: &[MeshRecord]) -> Result<()> {
    writeln!(out, "## Stages of slimbvh's build\n")?;
    let names: Vec<&str> = records[0].tracers[0].runs[0]
        .stages
        .iter()
        .map(|(name, _)| name)
        .collect();
    writeln!(out, "| mesh | tracer | threads | {} |", names.join(" | "))?;
    writeln!(out, "|---|---|--:|{}", "--:|".repeat(names.len()))?;
    for record in records {
        for (tracer, run) in runs(record) {
            let total = run.stages.total().as_secs_f64();
            if total == 0.0 {
                continue;
            }
            let shares = run
                .stages
                .iter()
                .map(|(_, time)| format!("{:.0} %", 100.0 * time.as_secs_f64() / total));
            let shares: Vec<String> = shares.collect();
            let (name, threads) = (record.name, run.threads);
            let shares = shares.join(" | ");
            writeln!(out, "| {name} | {} | {threads} | {shares} |", tracer.name)?;
        }
    }
    writeln!(out)?;
    Ok(())
}

fn traces(out: &mut String, records: &[MeshRecord]) -> Result<()> {
    writeln!(out, "## Trace\n")?;
    writeln!(
        out,
        "| mesh | tracer | threads | primary | M rays/s | shadow | M rays/s | frame |\n\
         |---|---|--:|--:|--:|--:|--:|--:|"
    )?;
    for record in records {
        for (tracer, run) in runs(record) {
            writeln!(
                out,
                "| {} | {} | {} | {} | {:.2} | {} | {:.2} | {:.1} |",
                record.name,
                tracer.name,
                run.threads,
                spread(&run.primary),
                record.primary_count as f64 / run.primary.median() / 1e3,
                spread(&run.shadow),
                record.shadow_count as f64 / run.shadow.median() / 1e3,
                run.frame_ms(),
            )?;
        }
    }
    writeln!(out)?;
    Ok(())
}

fn answers(out: &mut String, records: &[MeshRecord]) -> Result<()> {
    writeln!(out, "## Work and answers\n")?;
    writeln!(
        out,
        "Inner nodes opened (two boxes each) and triangles tested per ray; hits; and against slimbvh's 30-bit \
         tree on one thread: rays that hit for it only (missed), rays that do not hit for it (extra), and rays whose \
         distances differ by more than 0.1 % (elsewhere). Both of slimbvh's trees must give the same answers to the last \
         bit, and obvhs' binary trees nearly as many hits.\n"
    )?;
    writeln!(
        out,
        "| mesh | tracer | rays | nodes/ray | triangles/ray | hits | missed | extra | elsewhere |\n\
         |---|---|--:|--:|--:|--:|--:|--:|--:|"
    )?;
    for record in records {
        for tracer in &record.tracers {
            let mut row = |kind: &str, count: usize, visits: Option<Visits>, seen: &Agreement| {
                let per_ray = |sum: fn(Visits) -> u64| {
                    let mean = |visits| sum(visits) as f64 / count.max(1) as f64;
                    visits.map_or("–".into(), |visits| format!("{:.1}", mean(visits)))
                };
                writeln!(
                    out,
                    "| {} | {} | {count} {kind} | {} | {} | {} | {} | {} | {} |",
                    record.name,
                    tracer.name,
                    per_ray(|visits| visits.nodes),
                    per_ray(|visits| visits.triangles),
                    seen.hits,
                    seen.missed,
                    seen.extra,
                    seen.distance,
                )
            };
            let (primary, shadow) = (tracer.primary_visits, tracer.shadow_visits);
            row("primary", record.primary_count, primary, &tracer.primary)?;
            row("shadow", record.shadow_count, shadow, &tracer.shadow)?;
        }
    }
    Ok(())
}

/// The table of all runs, by number of threads.
fn runs(record: &MeshRecord) -> impl Iterator<Item = (&TracerRecord, &Run)> {
    let run_count = record.tracers.first().map_or(0, |first| first.runs.len());
    (0..run_count).flat_map(|run| {
        let tracers = record.tracers.iter();
        tracers.map(move |tracer| (tracer, &tracer.runs[run]))
    })
}

/// The median, the smallest and the largest.
fn spread(samples: &Samples) -> String {
    let (median, min, max) = (samples.median(), samples.min(), samples.max());
    format!("{median:.1} ({min:.1}–{max:.1})")
}
