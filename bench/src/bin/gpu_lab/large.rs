//! Section `large`: terrains that fit no cache: a build, and rates of rays.

use crate::builds;
use crate::peers;
use crate::rayset::STORED;
use crate::scenes::{Subject, large_cells, terrain};
use crate::session::Session;
use crate::traces;
use anyhow::Result;
use slimbvh::CodeBits;
use slimbvh::gpu::{GpuError, Mesh as GpuMesh};

/// Measures both terrains, then peers on the smaller one, whose trees take the CPU longest.
pub fn run(session: &mut Session) -> Result<()> {
    let sizes = large_cells(session.is_quick);
    let mut smaller = None;
    for (cells, seconds) in sizes {
        let triangles = format!("terrain with {} triangles", 2 * cells * cells);
        if !session.has(seconds, &triangles)? {
            continue;
        }
        let subject = terrain(cells, session.seed);
        match one(session, &subject) {
            Ok(()) => {
                smaller.get_or_insert(subject);
            }
            Err(error) if is_too_large(&error) => {
                session.note(format!("{triangles}: refused, {error:#}"))?;
            }
            Err(error) => return Err(error),
        }
    }
    if session.has(3.0 * sizes[0].1, "peers")? {
        match smaller {
            Some(subject) => peers::measure(session, &subject)?,
            None => session.missed("peers: no terrain fits the device")?,
        }
    }
    Ok(())
}

fn one(session: &mut Session, subject: &Subject) -> Result<()> {
    let uploaded = GpuMesh::upload(&session.gpu, &subject.mesh)?;
    builds::measure(session, subject, &uploaded, (CodeBits::Bits30, "30 bits"))?;
    // Plain, and wide nodes on the lattice.
    traces::measure(session, subject, &uploaded, &STORED[..2])
}

fn is_too_large(error: &anyhow::Error) -> bool {
    matches!(
        error.downcast_ref(),
        Some(GpuError::TooLarge { .. } | GpuError::OutOfMemory { .. })
    )
}
