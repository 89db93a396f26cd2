//! Sides that the GPU decides, for frames in which only the GPU knows where the vertices are.

use super::Hierarchies;
use crate::gpu::{
    Answer, Builder, Decided, Decisions, Facing, FacingDownload, Frame, Gpu, GpuError, Measured,
    MeasuresDownload, Mesh,
};
use crate::reduce::explain::{grouped, things};
use crate::reduce::{Aim, Choice, Plan};

/// Which triangles answer for lights.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LightSets {
    /// Those that face the light (L+).
    #[default]
    Facing,
    /// Those that face it or those that face away (L−), whichever are fewer. L− is taken where the eye is outside of all that the
    /// light is outside of; nothing may be transparent.
    Smaller,
}

impl Hierarchies {
    /// Records what [`Self::build`] does, with sides that the GPU decides by where the vertices are at this point of the
    /// frame. The plan says which trees are built, and its sides are of no account: it may be one for other positions.
    /// [`Self::upload`] is not needed. `decisions` must be of the plan's topology.
    ///
    /// # Errors
    /// Those of [`Builder::build`], [`Decisions::measure`] and [`Facing::decide`].
    pub fn build_deciding(
        &mut self,
        frame: &mut Frame,
        builder: &mut Builder,
        mesh: &Mesh,
        plan: &Plan,
        (decisions, lights): (&mut Decisions, LightSets),
    ) -> Result<(), GpuError> {
        self.components = Some(decisions.components().clone());
        self.forget();
        builder.sort(frame, mesh)?;
        decisions.measure(frame, builder, mesh)?;
        let decisions: &Decisions = decisions;
        let recorded = self.build_sorted(frame, builder, mesh, plan, |frame, aim, facing, eye| {
            let answer = match (lights, eye) {
                (LightSets::Smaller, Some(eye)) => Answer::Smaller { eye },
                _ => Answer::Facing,
            };
            facing.decide(frame, decisions, (&aim.target, &aim.frustum), answer)
        });
        // The plan's sides are of no account, so nothing is known of what these sets are.
        self.forget();
        recorded
    }

    /// Copies what was decided by this point of the frame, to tell of it when the frame is done.
    ///
    /// # Errors
    /// If memory is exhausted.
    pub fn read_decisions_later(
        &self,
        frame: &mut Frame,
        plan: &Plan,
        decisions: &Decisions,
    ) -> Result<DecisionsDownload, GpuError> {
        let aims = plan.aims.iter().zip(&self.sets);
        let used = aims.filter(|(aim, _)| aim.choice != Choice::Unused);
        let of_aim = |(aim, (_, facing)): (&Aim, &(_, Facing))| {
            let download = facing.read_later(frame)?;
            Ok((aim.name(), download))
        };
        let aims = used.map(of_aim).collect::<Result<_, GpuError>>()?;
        Ok(DecisionsDownload {
            measures: decisions.read_later(frame)?,
            aims,
        })
    }
}

/// What the GPU decided in a frame, on its way.
#[derive(Debug)]
#[must_use]
pub struct DecisionsDownload {
    measures: MeasuresDownload,
    aims: Vec<(String, FacingDownload)>,
}

impl DecisionsDownload {
    /// Waits for it, and reads it.
    ///
    /// # Errors
    /// If the device was lost.
    pub fn read(self, gpu: &Gpu) -> Result<DecisionsReport, GpuError> {
        let read = |(name, download): (String, FacingDownload)| Ok((name, download.read(gpu)?));
        Ok(DecisionsReport {
            components: self.measures.read(gpu)?,
            aims: self
                .aims
                .into_iter()
                .map(read)
                .collect::<Result<_, GpuError>>()?,
        })
    }
}

/// What the GPU decided in a frame.
#[derive(Clone, Debug)]
pub struct DecisionsReport {
    /// The components that may be reduced.
    pub components: Vec<Measured>,
    /// The camera and each light with rays, by name.
    pub aims: Vec<(String, Decided)>,
}

impl DecisionsReport {
    /// One line a decision: what it is about, and what was decided, with the figures.
    #[must_use]
    pub fn explain(&self) -> Vec<(String, String)> {
        let has = |side: i32| {
            let of_side = |known: &&Measured| known.measure.outer_side() == side;
            self.components.iter().filter(of_side).count()
        };
        let open = |known: &&Measured| known.measure.is_open != 0;
        let torn = self.components.iter().filter(open).count();
        let mut lines = vec![(
            "on the GPU".to_owned(),
            format!(
                "of {}, {} face out and {} are inside out; {torn} are torn open, {} have no certain sign",
                things(self.components.len(), "closed component"),
                has(1),
                has(-1),
                has(0) - torn,
            ),
        )];
        for (name, decided) in &self.aims {
            let count = decided.sides.iter().filter(|side| **side != 0).count();
            let mut text = format!("certainly outside of {}", things(count, "component"));
            if let Some(counts) = decided.counts {
                let taken = if counts.is_minus == 1 { "L−" } else { "L+" };
                text += &format!(
                    "; L+ keeps {}, L− {}: {taken} is taken",
                    things(counts.plus as usize, "triangle"),
                    grouped(counts.minus as usize)
                );
                if counts.barred > 0 {
                    text += ", as the eye may be inside";
                }
            }
            lines.push((name.clone(), text));
        }
        lines
    }
}
