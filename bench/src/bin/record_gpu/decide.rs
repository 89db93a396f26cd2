//! Measures stage `decide`.

use crate::measure::median;
use slimbvh::gpu::{
    Answer, Builder, Decisions, Frame, Gpu, GpuError, Mesh as GpuMesh, TargetSides, Work,
};
use slimbvh::topology::Topology;
use slimbvh::{BuildConfig, Mesh};
use slimbvh_core::frustum::Frustum;
use slimbvh_core::orientation::Target;
use std::time::Duration;

/// The measurements.
pub struct Deciding {
    /// Triangles of reducible components.
    pub reducible_count: usize,
    /// The steps of the stage.
    pub steps: Vec<Step>,
    /// Bytes of all buffers.
    pub bytes: u64,
}

/// A step of the stage.
pub struct Step {
    /// The name in tables.
    pub name: &'static str,
    /// Its dispatches and bytes.
    pub work: Work,
    /// The median time; zero without timestamps.
    pub time: Duration,
}

/// Measures components, decides the sides for an eye, and chooses the smaller of a sun's sets.
pub fn decide(
    gpu: &Gpu,
    mesh: &Mesh,
    uploaded: &GpuMesh,
    rounds: usize,
) -> Result<Deciding, GpuError> {
    let topology = Topology::new(mesh);
    let facts = topology.facts().into_iter();
    let closed = facts.filter(|facts| facts.closed);
    let mut builder = Builder::new(BuildConfig::default());
    let mut decisions = Decisions::new(gpu, &topology)?;
    let far = mesh.bounds().map_or([1.0; 3], |bounds| {
        (bounds.max + (bounds.max - bounds.min)).to_array()
    });
    let (eye_place, sun) = (Target::position(far), Target::direction([0.3, 1.0, 0.2]));
    let (mut eye, mut light) = (TargetSides::new(), TargetSides::new());
    let mut frame = gpu.frame();
    builder.sort(&mut frame, uploaded)?;
    frame.submit()?.wait()?;

    let timed = |record: &mut dyn FnMut(&mut Frame) -> Result<(), GpuError>| {
        let mut times = Vec::new();
        // The first round compiles and allocates.
        for round in 0..=rounds {
            let mut frame = gpu.frame();
            record(&mut frame)?;
            let stages = frame.submit()?.wait()?;
            if round > 0 {
                times.push(stages.total());
            }
        }
        Ok::<_, GpuError>(median(&times))
    };
    let everywhere = Frustum::EVERYWHERE;
    let measuring = timed(&mut |frame| decisions.measure(frame, &builder, uploaded))?;
    let aiming = timed(&mut |frame| {
        eye.decide(frame, &decisions, (&eye_place, &everywhere), Answer::Facing)
    })?;
    let smaller = Answer::Smaller { eye: &eye };
    let choosing =
        timed(&mut |frame| light.decide(frame, &decisions, (&sun, &everywhere), smaller))?;
    let steps = [
        ("measure components", decisions.work(), measuring),
        ("sides for an eye", eye.work(), aiming),
        ("the smaller set of a light", light.work(), choosing),
    ];
    Ok(Deciding {
        reducible_count: closed.map(|facts| facts.triangle_count).sum(),
        steps: steps
            .into_iter()
            .map(|(name, work, time)| Step {
                name,
                work: work.copied().unwrap_or_default(),
                time,
            })
            .collect(),
        bytes: decisions.bytes(),
    })
}
