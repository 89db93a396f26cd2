//! The survey of a mesh's surfaces, on which plans depend.

use super::Seams;
use crate::topology::Topology;
use crate::{BuildConfig, Builder, Bvh, Mesh, MeshError, Stages};
use std::sync::Arc;

/// The surfaces, and the time of the survey.
#[derive(Clone, Debug)]
pub struct Survey {
    /// Components, sides and seams; plans share it.
    pub topology: Arc<Topology>,
    /// Time of each step.
    pub stages: Stages,
}

/// Surveys a mesh. The search for seams builds a whole tree of its own.
///
/// # Errors
/// Those of [`Mesh::validate`].
pub fn survey(mesh: &Mesh, config: BuildConfig, seams: Seams) -> Result<Survey, MeshError> {
    let mut stages = Stages::default();
    mesh.validate()?;
    let mut topology = stages.time("components", || Topology::new(mesh));
    if seams == Seams::Find {
        let mut bvh = Bvh::default();
        // The search for seams needs exact boxes and triangles.
        let mut builder = Builder::new(config.code_bits.into());
        stages.time("whole tree", || builder.build_into(mesh, &mut bvh))?;
        stages.time("seams", || topology.find_seams(mesh, &bvh));
    }
    Ok(Survey {
        topology: Arc::new(topology),
        stages,
    })
}
