//! Section `builds`: times of builds over terrains from 10 thousand triangles up.

use crate::scenes::{Subject, build_cells, terrain};
use crate::session::Session;
use anyhow::Result;
use slimbvh::CodeBits;
use slimbvh::gpu::{Builder, Bvh, Mesh as GpuMesh};
use slimbvh_lab::measure::rounds::median;
use std::time::{Duration, Instant};

/// Builds all terrains.
pub fn run(session: &mut Session) -> Result<()> {
    for &cells in build_cells(session.is_quick) {
        let subject = terrain(cells, session.seed);
        if session.has(2.0, &subject.name)? {
            let uploaded = GpuMesh::upload(&session.gpu, &subject.mesh)?;
            for (bits, name) in [(CodeBits::Bits30, "30 bits"), (CodeBits::Bits63, "63 bits")] {
                measure(session, &subject, &uploaded, (bits, name))?;
            }
        }
    }
    Ok(())
}

/// Builds a scene again and again into the same buffers.
pub fn measure(
    session: &Session,
    subject: &Subject,
    uploaded: &GpuMesh,
    (bits, name): (CodeBits, &str),
) -> Result<()> {
    let (mut builder, mut bvh) = (Builder::new(bits.into()), Bvh::new());
    let mut once = || {
        let begin = Instant::now();
        let mut frame = session.gpu.frame();
        builder.build(&mut frame, uploaded, &mut bvh)?;
        let stages = frame.submit()?.wait()?;
        anyhow::Ok((stages, begin.elapsed()))
    };
    // The first compiles and allocates.
    once()?;
    session.raise_clock(|| once().map(drop))?;
    let (mut totals, mut sorts, mut walls) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..session.rounds() {
        let (stages, wall) = once()?;
        let sort = stages.iter().find(|(stage, _)| *stage == "sort");
        sorts.push(sort.map_or(Duration::ZERO, |(_, time)| time).as_secs_f64());
        totals.push(stages.total().as_secs_f64());
        walls.push(wall.as_secs_f64());
    }
    let dispatches: u32 = builder.work().map(|work| work.dispatch_count).sum();
    let total = median(&mut totals);
    let scene = &subject.name;
    let row = |what: &str, unit, value| session.row(scene, &format!("{name}{what}"), unit, value);
    if total > 0.0 {
        row("", "ms", total * 1e3)?;
        row(", sort", "ms", median(&mut sorts) * 1e3)?;
        row(
            "",
            "Mtri/s",
            subject.mesh.indices.len() as f64 / total / 1e6,
        )?;
    }
    row(", as the host sees it", "ms", median(&mut walls) * 1e3)?;
    row("", "dispatches", dispatches.into())
}
