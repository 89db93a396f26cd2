//! A printable report of the GPU's decisions in a frame.

use super::{
    Decided, Decisions, Frame, Gpu, GpuError, Measured, MeasuresDownload, SidesDownload,
    TargetSides,
};
use crate::text::{grouped, things};

/// The GPU's decisions in a frame, being copied.
#[derive(Debug)]
#[must_use]
pub struct DecisionsDownload {
    measures: MeasuresDownload,
    targets: Vec<(String, SidesDownload)>,
}

impl DecisionsDownload {
    /// Copies the decisions made so far for some targets.
    pub(super) fn record(
        frame: &mut Frame,
        decisions: &Decisions,
        targets: &[(String, &TargetSides)],
    ) -> Result<Self, GpuError> {
        let mut downloads = Vec::with_capacity(targets.len());
        for (name, sides) in targets {
            downloads.push((name.clone(), sides.read_later(frame)?));
        }
        Ok(Self {
            measures: decisions.read_later(frame)?,
            targets: downloads,
        })
    }

    /// Waits for the copy, and reads it.
    ///
    /// # Errors
    /// If the device was lost.
    pub fn read(self, gpu: &Gpu) -> Result<DecisionsReport, GpuError> {
        gpu.block_on(self.read_async(gpu))
    }

    /// [`Self::read`], without blocking.
    ///
    /// # Errors
    /// If the device was lost; in a browser, also the errors of earlier calls.
    pub async fn read_async(self, gpu: &Gpu) -> Result<DecisionsReport, GpuError> {
        let components = self.measures.read_async(gpu).await?;
        let mut targets = Vec::with_capacity(self.targets.len());
        for (name, download) in self.targets {
            targets.push((name, download.read_async(gpu).await?));
        }
        Ok(DecisionsReport {
            components,
            targets,
        })
    }
}

/// The GPU's decisions in a frame.
#[derive(Clone, Debug)]
pub struct DecisionsReport {
    /// The components that may be reduced.
    pub components: Vec<Measured>,
    /// The camera and each light with rays, by name.
    pub targets: Vec<(String, Decided)>,
}

impl DecisionsReport {
    /// One line for each decision: its subject, and the decision with its figures.
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
                "of {}, {} face outward and {} inward; {torn} are no longer closed; the volume of {} has an uncertain sign",
                things(self.components.len(), "closed component"),
                has(1),
                has(-1),
                has(0) - torn,
            ),
        )];
        for (name, decided) in &self.targets {
            let count = decided.sides.iter().filter(|side| **side != 0).count();
            let mut text = format!("certainly outside of {}", things(count, "component"));
            if let Some(counts) = decided.counts {
                let taken = if counts.is_minus == 1 { "L−" } else { "L+" };
                text += &format!(
                    "; L+ keeps {}, L− {}: uses {taken}",
                    things(counts.plus as usize, "triangle"),
                    grouped(counts.minus as usize)
                );
                if counts.barred > 0 {
                    text += ", because the eye may be inside";
                }
            }
            lines.push((name.clone(), text));
        }
        lines
    }
}
