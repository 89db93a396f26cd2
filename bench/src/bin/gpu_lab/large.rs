//! Section `large`: terrains that fit no cache: a build, and rates of rays.

use crate::builds;
use crate::peers;
use crate::rayset::STORED;
use crate::scenes::{large_cells, terrain};
use crate::session::Session;
use crate::traces;
use anyhow::Result;
use slimbvh::CodeBits;
use slimbvh::gpu::{GpuError, Mesh as GpuMesh};

/// Measures both terrains, then peers on the smaller one, whose trees take the CPU longest.
pub fn run(session: &mut Session) -> Result<()> {
    let cells = large_cells(session.is_quick);
    for (cells, seconds) in cells {
        let triangles = format!("terrain with {} triangles", 2 * cells * cells);
        if !session.has(seconds, &triangles)? {
            continue;
        }
        match one(session, cells) {
            Err(error) if is_too_large(&error) => {
                session.note(format!("{triangles}: refused, {error:#}"))?;
            }
            result => result?,
        }
    }
    let (smaller, seconds) = cells[0];
    if session.has(3.0 * seconds, "peers")? {
        let subject = terrain(smaller, session.seed);
        peers::measure(session, &subject)?;
    }
    Ok(())
}

fn one(session: &mut Session, cells: u32) -> Result<()> {
    let subject = terrain(cells, session.seed);
    let uploaded = GpuMesh::upload(&session.gpu, &subject.mesh)?;
    builds::measure(session, &subject, &uploaded, (CodeBits::Bits30, "30 bits"))?;
    // Plain and the shortest codec.
    traces::measure(session, &subject, &uploaded, &STORED[..2])
}

fn is_too_large(error: &anyhow::Error) -> bool {
    matches!(
        error.downcast_ref(),
        Some(GpuError::TooLarge { .. } | GpuError::OutOfMemory { .. })
    )
}
