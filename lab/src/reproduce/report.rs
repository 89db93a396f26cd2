//! The report as text, as Markdown and as JSON.

use super::SceneName;
use super::measure::SceneRecord;
use super::options::{OWN, Options};
use super::protocol::Protocol;
use super::sheet::Sheet;
use super::tables::tables;
use super::verdicts::{Verdict, verdicts};
use crate::measure::machine::describe;
use serde::Serialize;
use slimbvh_cli::backend::Chosen;
use slimbvh_cli::output::{count, things};

/// All measurements, and the facts needed to read them.
#[derive(Serialize)]
pub struct Report {
    paper: &'static str,
    /// The command that reproduces the report.
    command: String,
    quick: bool,
    backend: &'static str,
    machine: String,
    threads: usize,
    protocol: Protocol,
    scenes: Vec<SceneRecord>,
    verdicts: Vec<Verdict>,
}

const PAPER: &str = "Wong, Cheng, Lii: Reduced BVHs for GPU Ray Tracing, CGIV 2012";

impl Report {
    pub fn new(
        options: &Options<SceneName>,
        chosen: &Chosen,
        protocol: Protocol,
        scenes: Vec<SceneRecord>,
    ) -> Self {
        let (backend, machine) = describe(chosen);
        Self {
            paper: PAPER,
            command: options.command("reduced"),
            quick: options.quick,
            backend,
            machine,
            threads: rayon::current_num_threads(),
            protocol,
            verdicts: verdicts(&scenes, backend == "gpu"),
            scenes,
        }
    }

    /// The report as a sheet.
    pub fn sheet(&self) -> Sheet<'_> {
        Sheet {
            title: "Reduced trees, beside the figures of the paper",
            paper: self.paper,
            head: self.head(),
            scope: "for scenes whose triangles are spread evenly over closed surfaces",
            verdicts: &self.verdicts,
            tables: tables(&self.scenes),
        }
    }

    /// The facts needed to read the tables.
    fn head(&self) -> Vec<(&str, String)> {
        let Protocol {
            size: [width, height],
            pictures,
            build_rounds,
            light_rounds,
            saving_rounds,
            ..
        } = &self.protocol;
        let mut head = vec![
            ("command", format!("`{}`", self.command)),
            ("machine", self.machine.clone()),
        ];
        if self.quick {
            let text = "small pictures and few repeats: for a first look, not for a record";
            head.push(("quick", text.into()));
        }
        let samples = pictures
            .iter()
            .map(|(samples, rounds)| format!("{rounds} of {samples}"));
        head.push((
            "pictures",
            format!(
                "{width}x{height} pixels; rounds of samples per pixel: {}",
                list(samples)
            ),
        ));
        head.push((
            "times",
            format!(
                "medians of those rounds, of {build_rounds} for trees, {light_rounds} for many lights and {saving_rounds} for savings; within each round all variants alternate, \
                 and ratios are medians of the rounds' ratios. Spread: slowest minus fastest round, as a share of the median"
            ),
        ));
        head.push((
            "printed",
            "figures of the paper, on a GTX 480 of 2010. Its scenes are not available: ours resemble them and have the same numbers of triangles. \
             Compare ratios, not times"
                .into(),
        ));
        head.push((
            "not timed",
            "reading scenes, and finding the closed surfaces once per scene (`slimbvh render --reduce on --explain` shows that time)"
                .into(),
        ));
        for scene in &self.scenes {
            let [components, reducible] = scene.components;
            let seams = match scene.seams {
                0 => String::new(),
                seams => format!("; {} stay in every set", things(seams, "triangle")),
            };
            let stand_in = scene
                .stand_in
                .as_ref()
                .map_or(String::new(), |text| format!("; {text}"));
            let own = match scene.is_own {
                true => format!("; {OWN}"),
                false => String::new(),
            };
            let closed = format!(
                "{} of {} closed",
                count(reducible),
                things(components, "part")
            );
            head.push((
                &scene.name,
                format!(
                    "{}, {closed}{seams}{stand_in}{own}",
                    things(scene.triangles, "triangle")
                ),
            ));
        }
        head
    }
}

fn list(parts: impl Iterator<Item = String>) -> String {
    parts.collect::<Vec<_>>().join(", ")
}
