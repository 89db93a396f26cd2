//! The record as Markdown.

use crate::decide::Deciding;
use crate::measure::{Build, Measured, MeshRecord};
use anyhow::Result;
use slimbvh::gpu::{Gpu, adapters};
use slimbvh_bench::{RayOrder, machine};
use std::fmt::Write;

/// The whole record.
pub fn report(
    gpu: &Gpu,
    records: &[MeshRecord],
    (rounds, order): (usize, RayOrder),
    names: &[String],
) -> Result<String> {
    let mut out = String::new();
    writeln!(out, "# The GPU backend on {}\n", gpu.name())?;
    writeln!(
        out,
        "Made by `record-gpu` (see `bench/README.md`): {}.\n",
        names.join(", ")
    )?;
    writeln!(out, "| | |\n|---|---|")?;
    writeln!(out, "| date | {} |", machine::date())?;
    writeln!(out, "| adapter | {} |", gpu.name())?;
    let adapters = adapters();
    if let Some(adapter) = adapters.iter().find(|adapter| adapter.name == gpu.name()) {
        writeln!(
            out,
            "| kind | {}, {}, {} |",
            adapter.kind, adapter.api, adapter.driver
        )?;
        if adapter.is_software {
            writeln!(out, "| host | {} |", machine::processor())?;
            writeln!(
                out,
                "| times | of a software adapter: they say nothing about a GPU |"
            )?;
        }
    }
    writeln!(out, "| rounds | {rounds}, after one to warm up; medians |")?;
    writeln!(out, "| rays | {order} |")?;
    for record in records {
        writeln!(
            out,
            "\n## {}, {} triangles\n",
            record.name, record.triangle_count
        )?;
        match &record.outcome {
            Ok(measured) => describe(&mut out, record, measured)?,
            Err(refusal) => writeln!(out, "Refused: {refusal}.")?,
        }
    }
    Ok(out)
}

fn describe(out: &mut String, record: &MeshRecord, measured: &Measured) -> Result<()> {
    for build in &measured.builds {
        describe_build(out, record, build, measured.node_count)?;
    }
    describe_deciding(out, record, measured)?;
    writeln!(out, "| rays | count | ms | Mrays/s | bytes a ray | GB/s |")?;
    writeln!(out, "|---|--:|--:|--:|--:|--:|")?;
    for trace in &measured.traces {
        let seconds = trace.time.as_secs_f64();
        let rays = trace.ray_count as f64;
        let touched = trace.touched_bytes.map(|bytes| bytes as f64);
        let shown = |x: Option<f64>| x.map_or("–".into(), |x| format!("{x:.0}"));
        writeln!(
            out,
            "| {} | {} | {:.2} | {:.2} | {} | {} |",
            trace.name,
            trace.ray_count,
            seconds * 1e3,
            rays / seconds / 1e6,
            shown(touched.map(|bytes| bytes / rays)),
            shown(touched.map(|bytes| bytes / seconds / 1e9)),
        )?;
    }
    writeln!(
        out,
        "\nBytes of a ray: 64 for each node that it opens, 40 for each triangle that it meets. {} answers differ from the \
         CPU's.\n",
        record.wrong_answers
    )?;
    let per_triangle = |bytes: u64| bytes as f64 / record.triangle_count.max(1) as f64;
    writeln!(
        out,
        "Memory: hierarchy {:.1} bytes a triangle, of which {:.1} are nodes that there are; between the stages {:.1}.",
        per_triangle(measured.bvh_bytes),
        per_triangle(measured.node_count * size_of::<slimbvh::Node>() as u64),
        per_triangle(measured.scratch_bytes)
    )?;
    Ok(())
}

fn describe_deciding(out: &mut String, record: &MeshRecord, measured: &Measured) -> Result<()> {
    let Deciding {
        reducible_count,
        steps,
        bytes,
    } = &measured.deciding;
    let triangles = record.triangle_count as f64;
    writeln!(
        out,
        "Stage `decide`, bytes a triangle; {reducible_count} triangles belong to closed components:\n"
    )?;
    writeln!(
        out,
        "| step | dispatches | read | written | ms | of the build's bytes | of its time |"
    )?;
    writeln!(out, "|---|--:|--:|--:|--:|--:|--:|")?;
    let build = measured.builds.iter().find(|build| build.code_bits == 30);
    let (mut build_bytes, mut build_seconds) = (0, 0.0);
    if let Some(build) = build {
        let moved = |work: &slimbvh::gpu::Work| {
            work.read.total(measured.node_count) + work.written.total(measured.node_count)
        };
        build_bytes = build.work.iter().map(moved).sum();
        build_seconds = build
            .times
            .iter()
            .map(std::time::Duration::as_secs_f64)
            .sum();
    }
    for step in steps {
        let [read, written] = [step.work.read, step.work.written].map(|traffic| traffic.bytes);
        writeln!(
            out,
            "| {} | {} | {:.1} | {:.1} | {:.3} | {:.1} % | {:.1} % |",
            step.name,
            step.work.dispatch_count,
            read as f64 / triangles,
            written as f64 / triangles,
            step.time.as_secs_f64() * 1e3,
            100.0 * (read + written) as f64 / build_bytes.max(1) as f64,
            100.0 * step.time.as_secs_f64() / f64::max(build_seconds, 1e-9),
        )?;
    }
    writeln!(
        out,
        "\nThe build is that of 30-bit codes. Memory: {:.1} bytes a triangle.\n",
        *bytes as f64 / triangles
    )?;
    Ok(())
}

fn describe_build(
    out: &mut String,
    record: &MeshRecord,
    build: &Build,
    node_count: u64,
) -> Result<()> {
    let triangles = record.triangle_count as f64;
    writeln!(
        out,
        "Build with {}-bit codes, bytes a triangle:\n",
        build.code_bits
    )?;
    writeln!(
        out,
        "| stage | dispatches | read | written | least | moved / least | ms |"
    )?;
    writeln!(out, "|---|--:|--:|--:|--:|--:|--:|")?;
    let mut row = |name: &str, dispatches: u32, [read, written, least]: [u64; 3], ms: f64| {
        writeln!(
            out,
            "| {name} | {dispatches} | {:.1} | {:.1} | {:.1} | {:.1} | {ms:.3} |",
            read as f64 / triangles,
            written as f64 / triangles,
            least as f64 / triangles,
            (read + written) as f64 / least as f64,
        )
    };
    let mut total = (0, [0; 3], 0.0);
    for (work, time) in build.work.iter().zip(&build.times) {
        let traffic = [work.read, work.written, work.least];
        let bytes = traffic.map(|traffic| traffic.total(node_count));
        let ms = time.as_secs_f64() * 1e3;
        row(work.stage, work.dispatch_count, bytes, ms)?;
        total.0 += work.dispatch_count;
        for (sum, bytes) in total.1.iter_mut().zip(bytes) {
            *sum += bytes;
        }
        total.2 += ms;
    }
    row("all", total.0, total.1, total.2)?;
    let sort = build
        .work
        .iter()
        .zip(&build.times)
        .find(|(work, _)| work.stage == "sort");
    if let Some((_, time)) = sort.filter(|(_, time)| !time.is_zero()) {
        writeln!(
            out,
            "\nSort: {:.1} Mkeys/s. Build: {:.1} Mtri/s; {:.2} ms as the host sees it.\n",
            triangles / time.as_secs_f64() / 1e6,
            triangles / total.2 / 1e3,
            build.wall.as_secs_f64() * 1e3
        )?;
    }
    Ok(())
}
