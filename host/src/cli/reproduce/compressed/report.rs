//! The whole report: for people, for a file, and as JSON.

use super::CompressedArguments;
use super::measure::SceneRecord;
use super::protocol::Protocol;
use super::tables::tables;
use super::targets::verdicts;
use crate::cli::output::things;
use crate::cli::reproduce::sheet::{Sheet, processor};
use crate::cli::reproduce::verdicts::Verdict;
use serde::Serialize;

/// Everything that was measured.
#[derive(Serialize)]
pub struct Report {
    paper: &'static str,
    /// The command that makes it again.
    command: String,
    quick: bool,
    backend: &'static str,
    machine: String,
    threads: usize,
    protocol: Protocol,
    scenes: Vec<SceneRecord>,
    verdicts: Vec<Verdict>,
}

const PAPER: &str = "A paper on the compression of BVH and mesh on the GPU, after Karras 2012";

impl Report {
    pub fn new(
        arguments: &CompressedArguments,
        protocol: Protocol,
        scenes: Vec<SceneRecord>,
    ) -> Self {
        let threads = rayon::current_num_threads();
        Self {
            paper: PAPER,
            command: arguments.command(),
            quick: arguments.quick,
            backend: "cpu",
            machine: format!("{}, {}", processor(), things(threads, "thread")),
            threads,
            protocol,
            verdicts: verdicts(&scenes),
            scenes,
        }
    }

    /// As it is printed.
    pub fn sheet(&self) -> Sheet<'_> {
        Sheet {
            title: "Compressed trees, beside the figures of the paper",
            paper: self.paper,
            head: self.head(),
            scope: "for nodes of 10 bits with triangles on the lattice, to half a pixel and at the finest step",
            verdicts: &self.verdicts,
            tables: tables(&self.scenes),
        }
    }

    /// What must be known to read the tables.
    fn head(&self) -> Vec<(&'static str, String)> {
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
            format!("{width}x{height} pixels, one sample each; paths meet up to {mirror_depth} mirrors and surfaces of glass"),
        ));
        head.push((
            "times",
            format!(
                "medians of {rounds} rounds; within each the method and the plain tree take turns. Spread: from the fastest to the slowest, \
                 as a share of the median"
            ),
        ));
        head.push((
            "plain",
            "nodes of 64 bytes with both children's boxes, leaves of up to 4 triangles, 40 bytes a triangle: what all else is compared with"
                .into(),
        ));
        head.push((
            "NODE",
            "the printed codec: planes in 10 bits between those of the decoded parent, by floats. +MESH: triangles in 10 bits a \
             coordinate in their leaf's box"
                .into(),
        ));
        head.push((
            "q4 to q21",
            "ours: planes on one lattice of the scene, by integers, in so many bits. With mesh, vertices are moved onto a lattice first, \
             and triangles take 16, 28 or 40 bytes as each leaf needs"
                .into(),
        ));
        head.push((
            "printed",
            "figures of the paper, on a GTX 970 of 2014, which reads what its caches miss; ours are of this machine's cores, which have \
             little to gain from less traffic and decode without help. Its tree has one triangle a leaf, so most of what it reads is nodes; \
             ours has a third as many nodes, and reads triangles as well. Compare ratios of counts, not times"
                .into(),
        ));
        head.extend(self.scenes.iter().map(|scene| {
            let stand_in = scene
                .stand_in
                .as_ref()
                .map_or(String::new(), |text| format!("; {text}"));
            let printed = scene
                .printed
                .map_or("nothing is printed of it".into(), |printed| {
                    format!("printed: {}", printed.triangles)
                });
            let text = format!(
                "{} ({printed}){stand_in}",
                things(scene.triangles, "triangle")
            );
            (scene.name, text)
        }));
        head
    }
}
