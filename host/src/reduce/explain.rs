//! A plan in words.

use super::Reduce;
use super::plan::Plan;
use super::{FacingSet, TreeChoice, ViewSet};
use crate::text::{grouped, things};
use crate::topology::{Facts, Topology};

impl Plan {
    /// One line for each decision: its subject, and the decision with reason and figures.
    #[must_use]
    pub fn explain(&self) -> Vec<(String, String)> {
        let mut lines = Vec::new();
        let mut line = |about: &str, text: String| lines.push((about.to_owned(), text));
        match (&self.topology, &self.no_survey) {
            (Some(topology), _) => {
                for (about, text) in surfaces(topology) {
                    line(about, text);
                }
                for view in &self.sets {
                    line(&view.name(), self.view(view));
                }
            }
            (None, Some(reason)) => line("nothing", format!("is left out: {reason}")),
            (None, None) => {}
        }
        if self.defers_lights {
            let text = "sets are built and traced one after the other, in the same memory";
            line("lights", text.to_owned());
        }
        line("whole tree", self.whole());
        lines
    }

    fn view(&self, view: &ViewSet) -> String {
        let kept = format!(
            "about {:.0} % of {}",
            100.0 * view.share,
            things(self.triangle_count, "triangle")
        );
        let own = if view.targets.len() > 1 {
            "one set for all of them"
        } else {
            "a set of its own"
        };
        let saving = if view.saving_ms >= 0.0 {
            format!("saves about {:.1} ms", view.saving_ms)
        } else {
            format!("costs about {:.1} ms more than it saves", -view.saving_ms)
        };
        let text = match view.choice {
            TreeChoice::Unused => return "no rays, no tree".to_owned(),
            TreeChoice::Whole if !view.may_be_set() => {
                "the whole tree: no triangle may be left out".to_owned()
            }
            TreeChoice::Whole if self.reduce == Reduce::Off => {
                format!("the whole tree, because reduction is off; a set would keep {kept}")
            }
            TreeChoice::Whole => format!("the whole tree: a set of {kept} {saving}"),
            TreeChoice::Set => {
                let besides = match (view.saving_ms < 0.0, self.reduce, self.needs_whole) {
                    (true, Reduce::On, _) => ", but reduction is forced on",
                    (true, _, false) => ", but no whole tree is built",
                    _ => "",
                };
                format!("{own}: keeps {kept}, {saving}{besides}")
            }
        };
        let text = match (view.half, view.frustum.is_bounded) {
            (FacingSet::Back, _) => format!("{text}; holds triangles that face away (L−)"),
            (FacingSet::Front, 1) => format!("{text}; leaves out triangles outside the picture"),
            (FacingSet::Front, _) => text,
        };
        let inside = self.inside_count(view);
        if inside > 0 {
            let them = if inside == 1 { "stays" } else { "stay" };
            format!(
                "{text}; possibly inside {}, which {them} whole",
                things(inside, "closed component")
            )
        } else {
            text
        }
    }

    /// The number of reducible components that a target may be inside of.
    fn inside_count(&self, view: &ViewSet) -> usize {
        let facts = self
            .topology
            .as_deref()
            .map(Topology::facts)
            .unwrap_or_default();
        let pairs = facts.iter().zip(&view.sides);
        pairs
            .filter(|(facts, side)| facts.reducible && **side == 0)
            .count()
    }

    fn whole(&self) -> String {
        let used_by = |view: &&ViewSet| view.choice == TreeChoice::Whole;
        let mut users: Vec<String> = self
            .sets
            .iter()
            .filter(used_by)
            .map(ViewSet::name)
            .collect();
        users.extend(self.others.iter().cloned());
        if self.needs_whole {
            format!("is built, for {}", users.join(", "))
        } else {
            "is not built: no rays need it".to_owned()
        }
    }
}

/// The survey's facts about the mesh's surfaces.
fn surfaces(topology: &Topology) -> Vec<(&'static str, String)> {
    let facts = topology.facts();
    let total = |which: &dyn Fn(&Facts) -> bool| {
        let those = || facts.iter().filter(|facts| which(facts));
        let triangles: usize = those().map(|facts| facts.triangle_count).sum();
        (those().count(), triangles)
    };
    let (reducible, triangles) = total(&|facts| facts.reducible);
    let seams = match topology.seam_count() {
        0 => String::new(),
        1 => ", except 1 that rays may hit from behind".to_owned(),
        count => format!(", except {} that rays may hit from behind", grouped(count)),
    };
    let mut lines = vec![(
        "reducible",
        format!(
            "{} of {}, {}{seams}",
            grouped(reducible),
            things(facts.len(), "component"),
            things(triangles, "triangle"),
        ),
    )];
    for (why, which) in [
        (
            "not closed",
            &(|facts: &Facts| !facts.closed) as &dyn Fn(&Facts) -> bool,
        ),
        (
            "closed, but the sign of the volume is uncertain",
            &|facts| facts.closed && !facts.reducible && !facts.search_given_up,
        ),
        (
            "too many of its triangles are near each other to search for seams",
            &|facts| facts.closed && facts.search_given_up,
        ),
    ] {
        let (count, triangles) = total(which);
        if count > 0 {
            let text = format!(
                "{}, {}: {why}",
                things(count, "component"),
                things(triangles, "triangle")
            );
            lines.push(("stay whole", text));
        }
    }
    lines
}
