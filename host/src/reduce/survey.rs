//! What a plan must know of the surfaces.

use super::Seams;
use crate::topology::Topology;
use crate::{BuildConfig, Builder, Bvh, Mesh, MeshError, Stages};

/// The surfaces, and what it took to know them.
#[derive(Clone, Debug)]
pub struct Survey {
    /// Components, sides and seams.
    pub topology: Topology,
    /// Time of each step.
    pub stages: Stages,
}

/// Surveys a mesh. Seams are found with a whole tree of its own.
///
/// # Errors
/// Those of [`Mesh::validate`].
pub fn survey(mesh: &Mesh, config: BuildConfig, seams: Seams) -> Result<Survey, MeshError> {
    let mut stages = Stages::default();
    mesh.validate()?;
    let mut topology = stages.time("components", || Topology::new(mesh));
    if seams == Seams::Find {
        let mut bvh = Bvh::default();
        // Seams are looked for in boxes and triangles as they are.
        let mut builder = Builder::new(config.code_bits.into());
        stages.time("whole tree", || builder.build_into(mesh, &mut bvh))?;
        stages.time("seams", || topology.find_seams(mesh, &bvh));
    }
    Ok(Survey { topology, stages })
}
