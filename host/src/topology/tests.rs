//! Laws of [`Topology`], each with a control that would fail if the law were vacuous.

mod budget;
mod facts;
mod oracle;
mod properties;
mod real;
mod seams;
mod shapes;
mod sides;

use super::shape::Shape;
use super::{Target, Topology};
use crate::{BuildConfig, Builder, Bvh, Mesh};

/// A hierarchy over a sound mesh.
fn build(mesh: &Mesh) -> Bvh {
    let mut builder = Builder::new(BuildConfig::default());
    builder.build(mesh).expect("the mesh is sound")
}

/// A topology after the search for seams.
fn with_seams(mesh: &Mesh) -> Topology {
    let mut topology = Topology::new(mesh);
    topology.find_seams(mesh, &build(mesh));
    topology
}

/// For each triangle, whether it stays in every set.
fn kept(topology: &Topology) -> Vec<bool> {
    let labels = topology.components().iter();
    labels
        .map(|&label| label == topology.component_count())
        .collect()
}
