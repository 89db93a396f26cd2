//! A picture of what is in a file, where nothing need be built.

use super::job::Outcome;
use super::{RenderArguments, Summary, describe, summarize};
use crate::cli::output;
use crate::cli::reduce;
use anyhow::{Result, bail};
use slimbvh::reduce::Plan;
use slimbvh::{Picture, Renderer, Stages};

/// Refuses what asks for another tree, or for a GPU, before the file is read.
pub fn check(arguments: &RenderArguments) -> Result<()> {
    let name = arguments.scene.name();
    if arguments.backend.needs_gpu() {
        bail!("\"{name}\" is traced on the CPU for now; leave --backend gpu and --adapter out");
    }
    if arguments.picture.codes.is_asked_for() {
        bail!("--codes is for builds; \"{name}\" is built already, leave it out");
    }
    if arguments.reduce.is_asked_for() {
        bail!(
            "\"{name}\" holds one tree for all rays; leave --reduce on and --cull on out, or render the scene that it was built from"
        );
    }
    Ok(())
}

/// Reads and renders.
pub fn render(arguments: &RenderArguments) -> Result<(Summary, String, Picture)> {
    let name = arguments.scene.name();
    let mut load = Stages::default();
    let (mut scene, kept) = load.time("load", || arguments.scene.open())?;
    let Some(kept) = kept else {
        bail!("\"{name}\" holds no hierarchy");
    };
    let bvh = &kept.bvh;
    arguments.storage.check_saved(bvh.codecs(), &name)?;
    if bvh.triangle_count() < bvh.mesh_triangle_count() {
        bail!(
            "\"{name}\" holds a hierarchy without some of the triangles, which no picture can be made with"
        );
    }
    let settings = arguments.picture.settings();
    (arguments.picture.sight).prepare(&mut scene, &name, kept.framing)?;
    let asked = arguments.reduce.asked(&scene, &settings);
    let plan = Plan::plain(&asked, "the file holds one tree for all rays".into())?;

    let progress = output::bar("rendering");
    let mut renderer = Renderer::new();
    let mut picture = Picture::default();
    let show = |share| progress.set(share);
    let report = renderer.render(&scene, bvh, &settings, &mut picture, show)?;
    drop(progress);
    let outcome = Outcome {
        backend: "cpu",
        adapter: None,
        build: load,
        report,
        node_count: bvh.node_count(),
        node_bytes: bvh.node_bytes(),
        triangle_bytes: bvh.triangle_bytes(),
        scratch_bytes: renderer.scratch_bytes(),
        sets: Vec::new(),
    };
    let planned = reduce::summarize(&plan, None, &outcome.sets);
    let summary = summarize(arguments, &scene, &outcome, planned);
    let mut text = describe(&summary, &outcome);
    if arguments.reduce.explain {
        let stages = (&outcome.build, &outcome.report.stages);
        text += &reduce::explain(&plan, None, &outcome.sets, stages);
    }
    Ok((summary, text, picture))
}
