//! The reference answers that all others are compared with.

use crate::agreement::{Agreement, TOLERANCE};
use crate::tracers::{Demand, Slim};
use crate::{Answer, RayLists, RayOrder, Tracer, pool};
use anyhow::{Result, ensure};
use slimbvh::{CodeBits, Mesh};

/// The rays, and the answers of slimbvh with 30-bit codes on one thread.
pub struct Reference {
    /// The rays.
    pub rays: RayLists,
    /// Closest hits of the primary rays.
    pub closest: Vec<Answer>,
    /// Whether each shadow ray hits anything.
    pub any: Vec<bool>,
}

impl Reference {
    /// Rays and answers for a mesh.
    ///
    /// # Errors
    /// For meshes that are not valid or have no triangles.
    pub fn new(mesh: &Mesh, order: RayOrder) -> Result<Self> {
        let rays = RayLists::new(mesh, order)?;
        let mut closest = vec![Answer::MISS; rays.primary.len()];
        let mut any = vec![false; rays.shadow.len()];
        pool(1)?.install(|| {
            let mut tracer = Slim::new("slimbvh", CodeBits::Bits30.into(), mesh);
            tracer.build()?;
            tracer.closest_hits(&rays.primary, &mut closest);
            tracer.any_hits(&rays.shadow, &mut any);
            anyhow::Ok(())
        })?;
        Ok(Self { rays, closest, any })
    }

    /// Checks a tracer's answers to the primary rays.
    ///
    /// # Errors
    /// If they differ by more than the tracer's [`Demand`] allows.
    pub fn check_closest(&self, tracer: &dyn Tracer, answers: &[Answer]) -> Result<Agreement> {
        let agreement = Agreement::of_closest(&self.closest, answers);
        let equal = self.closest == answers;
        check(tracer, "primary", agreement, equal)?;
        Ok(agreement)
    }

    /// Checks a tracer's answers to the shadow rays.
    ///
    /// # Errors
    /// As [`Self::check_closest`].
    pub fn check_any(&self, tracer: &dyn Tracer, answers: &[bool]) -> Result<Agreement> {
        let agreement = Agreement::of_any(&self.any, answers);
        check(tracer, "shadow", agreement, self.any == answers)?;
        Ok(agreement)
    }

    /// Traces all rays and checks all answers.
    ///
    /// # Errors
    /// As [`Self::check_closest`].
    pub fn check(&self, tracer: &dyn Tracer) -> Result<()> {
        let mut closest = vec![Answer::MISS; self.rays.primary.len()];
        let mut any = vec![false; self.rays.shadow.len()];
        tracer.closest_hits(&self.rays.primary, &mut closest);
        tracer.any_hits(&self.rays.shadow, &mut any);
        self.check_closest(tracer, &closest)?;
        self.check_any(tracer, &any)?;
        Ok(())
    }
}

fn check(tracer: &dyn Tracer, rays: &str, agreement: Agreement, equal: bool) -> Result<()> {
    let name = tracer.name();
    let demand = tracer.demand();
    ensure!(
        equal || demand != Demand::Exact,
        "{name} gives other answers to {rays} rays than slimbvh on one thread"
    );
    let Agreement {
        expected_hits,
        hits,
        ..
    } = agreement;
    ensure!(
        agreement.is_close() || demand == Demand::Counted,
        "{name} hits with {hits} {rays} rays where slimbvh hits with {expected_hits}: more than {TOLERANCE} apart"
    );
    Ok(())
}
