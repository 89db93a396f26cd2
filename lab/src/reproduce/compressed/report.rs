//! The report as text, as Markdown and as JSON.

use super::SceneName;
use super::bench::{Agreement, TimedOn};
use super::measure::SceneRecord;
use super::protocol::Protocol;
use super::tables::tables;
use super::targets::verdicts;
use crate::measure::machine::describe;
use crate::reproduce::options::{OWN, Options};
use crate::reproduce::sheet::Sheet;
use crate::reproduce::verdicts::Verdict;
use serde::Serialize;
use slimbvh_cli::backend::Chosen;
use slimbvh_cli::output::{count, things};
use slimbvh_core::node::LEAF_SIZE;

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
    #[serde(skip_serializing_if = "Vec::is_empty")]
    left_out: Vec<LeftOut>,
    verdicts: Vec<Verdict>,
    #[serde(skip)]
    place: TimedOn,
}

/// A scene that was not measured, and why.
#[derive(Serialize)]
pub struct LeftOut {
    pub scene: String,
    pub why: String,
}

const PAPER: &str = "The paper of the codecs NODE and NODE+MESH: compression of BVH and mesh after Karras, on a GTX 970; its authors are not known to us";

impl Report {
    pub fn new(
        options: &Options<SceneName>,
        chosen: &Chosen,
        protocol: Protocol,
        (scenes, left_out): (Vec<SceneRecord>, Vec<LeftOut>),
    ) -> Self {
        let (backend, machine) = describe(chosen);
        let place = TimedOn::of(chosen);
        Self {
            paper: PAPER,
            command: options.command("compressed"),
            quick: options.quick,
            backend,
            machine,
            threads: rayon::current_num_threads(),
            protocol,
            verdicts: verdicts(&scenes, place),
            scenes,
            left_out,
            place,
        }
    }

    /// The report as a sheet.
    pub fn sheet(&self) -> Sheet<'_> {
        Sheet {
            title: "Compressed trees, beside the figures of the paper",
            paper: self.paper,
            head: self.head(),
            scope: if self.place.is_gpu() {
                "for triangles on the lattice, to half a pixel and at the finest step, with nodes of four children"
            } else {
                "for triangles on the lattice, to half a pixel and at the finest step, with nodes of 10 bits and with nodes of four children"
            },
            verdicts: &self.verdicts,
            tables: tables(&self.scenes, self.place),
        }
    }

    /// The facts needed to read the tables.
    fn head(&self) -> Vec<(&str, String)> {
        let Protocol {
            size: [width, height],
            rounds,
            mirror_depth,
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
        head.push((
            "pictures",
            format!("{width}x{height} pixels, one sample each; paths meet up to {mirror_depth} mirrors and glass surfaces"),
        ));
        head.push((
            "times",
            format!(
                "medians of {rounds} rounds, in each of which the method alternates with the plain tree. Spread: slowest minus fastest, \
                 as a share of the median"
            ),
        ));
        head.push((
            "plain",
            format!(
                "nodes of 64 bytes with both children's boxes, leaves of up to {LEAF_SIZE} triangles, 40 bytes a triangle: the reference of \
                 all comparisons"
            ),
        ));
        head.push((
            "NODE",
            "the paper's codec: planes of 10 bits within the decoded parent's box, in floats. +MESH: triangles with 10 bits per \
             coordinate within their leaf's box"
                .into(),
        ));
        if !self.place.is_gpu() {
            head.push((
                "q4 to q21",
                "the laboratory's, on the CPU only: planes of N bits within the decoded parent's box, on one lattice of the scene, in integers"
                    .into(),
            ));
        }
        head.push((
            "w4",
            "ours: nodes of up to four children, collapsed from the plain tree, with planes in full in 128 bytes. w4-64 and w4-48: planes of 8 \
             bits on the lattice in a frame of the node's own, in 64 bytes with the node's sides exact, or in 48 bytes with packed links"
                .into(),
        ));
        head.push((
            "mesh",
            "vertices are moved onto a lattice first, and triangles take 16, 28 or 40 bytes, depending on their leaf; below nodes of w4-48, corners that a leaf's triangles share are stored once".into(),
        ));
        head.push(("printed", self.printed()));
        if self.place.is_gpu() {
            head.push(("counted", self.counted()));
        }
        head.extend(self.scenes.iter().map(|scene| {
            let stand_in = scene
                .stand_in
                .as_ref()
                .map_or(String::new(), |text| format!("; {text}"));
            let unknown = match scene.is_own {
                true => OWN,
                false => "not in the paper",
            };
            let printed = scene.printed.map_or(unknown.into(), |printed| {
                format!("printed: {}", printed.triangles)
            });
            let text = format!(
                "{} ({printed}){stand_in}",
                things(scene.triangles, "triangle")
            );
            (scene.name.as_str(), text)
        }));
        head.extend(self.left_out.iter().map(|left_out| {
            let LeftOut { scene, why } = left_out;
            ("left out", format!("{scene}: {why}"))
        }));
        head
    }

    /// The conditions of the paper's figures and of ours.
    fn printed(&self) -> String {
        let (ours, whose, what) = match self.place {
            TimedOn::Cores => (
                ", which reads from memory what its caches miss; ours are from this machine's cores, which gain little from less traffic and \
                 decode in software",
                "Its",
                "ratios of counts",
            ),
            TimedOn::Software => (
                "; ours are from a CPU that emulates a GPU, which gains little from less traffic and whose times say little: rendering \
                 is not judged",
                "The paper's",
                "ratios of counts",
            ),
            TimedOn::Gpu => ("", "Its", "ratios"),
        };
        format!(
            "figures of the paper, on a GTX 970 of 2014{ours}. {whose} tree has one triangle per leaf, so that it mostly reads nodes; \
             ours has a quarter as many nodes, and reads triangles as well. Compare {what}, not times"
        )
    }

    /// Where counts were taken, and how far CPU and GPU agree.
    fn counted(&self) -> String {
        let methods = self.scenes.iter().flat_map(|scene| &scene.methods);
        let all: Vec<_> = methods.filter_map(|own| own.on_gpu).collect();
        let likeness = all.iter().map(|on_gpu| on_gpu.likeness);
        let sum = |of: fn(&Agreement) -> usize| likeness.clone().map(|it| of(&it)).sum::<usize>();
        format!(
            "on the CPU: tests, bytes read, changed pixels and cracks, which are the same on both. The GPU also counted the nodes and triangles of {} from \
             the eye, of which {} differ. Its trees take as many bytes, and of {} in its pictures {} differ from the CPU's \
             by more than one of 255",
            things(sum(|it| it.rays), "ray"),
            count(sum(|it| it.counted_otherwise)),
            things(sum(|it| it.pixels), "pixel"),
            count(sum(|it| it.pixels_unlike)),
        )
    }
}
