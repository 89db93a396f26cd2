//! `slimbvh info`.

use super::SceneArguments;
use super::output::{self, bytes, count, things};
use super::storage;
use anyhow::Result;
use clap::Args;
use serde::Serialize;
use slimbvh::analysis::{Analysis, Component, analyze};
use slimbvh::{Aabb, Bvh, Scene};
use std::fmt::Write;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct InfoArguments {
    #[command(flatten)]
    scene: SceneArguments,

    /// List the usable GPUs and their limits instead
    #[cfg(feature = "gpu")]
    #[arg(long, conflicts_with_all = ["scene", "format", "lenient", "all"])]
    adapters: bool,

    /// List all connected components, not only the largest
    #[arg(long)]
    all: bool,

    /// Write the report as JSON; "-" is standard output
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// Components listed without `--all`.
const LISTED: usize = 10;

#[derive(Debug, Serialize)]
struct Summary {
    scene: String,
    triangles: usize,
    degenerate_triangles: usize,
    duplicate_triangles: usize,
    dropped_faces: usize,
    vertices: usize,
    welded_vertices: usize,
    materials: usize,
    cameras: usize,
    lights: usize,
    extent: Option<Extent>,
    components: Vec<ComponentSummary>,
    /// Present only if the file holds a hierarchy.
    #[serde(skip_serializing_if = "Option::is_none")]
    hierarchy: Option<HierarchySummary>,
}

#[derive(Debug, Serialize)]
struct HierarchySummary {
    nodes: usize,
    node_codec: &'static str,
    node_bytes: usize,
    triangles: usize,
    triangle_codec: &'static str,
    triangle_bytes: usize,
    depth_bound: u32,
}

#[derive(Debug, Serialize)]
struct Extent {
    min: [f32; 3],
    max: [f32; 3],
}

#[derive(Debug, Serialize)]
struct ComponentSummary {
    triangles: usize,
    closed: bool,
    consistently_wound: bool,
    outward: Option<bool>,
    volume: f64,
    extent: Extent,
}

pub fn run(arguments: &InfoArguments) -> Result<()> {
    let json_on_stdout = output::is_stdout(arguments.json.as_deref());
    if let Some(json) = arguments.json.as_deref().filter(|_| !json_on_stdout) {
        output::check_place(json, arguments.scene.file().as_slice())?;
    }
    #[cfg(feature = "gpu")]
    if arguments.adapters {
        return super::adapters::run(arguments.json.as_deref());
    }
    let (scene, kept) = arguments.scene.open()?;
    let bvh = kept.map(|kept| kept.bvh);
    let progress = output::spinner("analyzing the mesh".into());
    let analysis = analyze(&scene.mesh);
    drop(progress);
    if !json_on_stdout {
        let listed = if arguments.all { usize::MAX } else { LISTED };
        output::print(&describe(
            &arguments.scene.name(),
            &scene,
            &analysis,
            bvh.as_ref(),
            listed,
        ))?;
    }
    if let Some(path) = &arguments.json {
        output::write_json(
            path,
            &summarize(&arguments.scene.name(), &scene, &analysis, bvh.as_ref()),
        )?;
    }
    Ok(())
}

fn summarize(name: &str, scene: &Scene, analysis: &Analysis, bvh: Option<&Bvh>) -> Summary {
    let extent = |bounds: &Aabb| Extent {
        min: bounds.min.to_array(),
        max: bounds.max.to_array(),
    };
    let component = |component: &Component| ComponentSummary {
        triangles: component.triangle_count,
        closed: component.closed,
        consistently_wound: component.consistently_wound,
        outward: component.outward,
        volume: component.signed_volume,
        extent: extent(&component.bounds),
    };
    Summary {
        scene: name.into(),
        triangles: analysis.triangle_count,
        degenerate_triangles: analysis.degenerate_triangle_count,
        duplicate_triangles: analysis.duplicate_triangle_count,
        dropped_faces: scene.dropped_face_count,
        vertices: analysis.vertex_count,
        welded_vertices: analysis.welded_vertex_count,
        materials: scene.materials.len(),
        cameras: scene.cameras.len(),
        lights: scene.lights.len(),
        extent: analysis.bounds.as_ref().map(extent),
        components: analysis.components.iter().map(component).collect(),
        hierarchy: bvh.map(|bvh| {
            let (nodes, triangles) = bvh.codecs();
            HierarchySummary {
                nodes: bvh.node_count(),
                node_codec: nodes.name(),
                node_bytes: bvh.node_bytes(),
                triangles: bvh.triangle_count(),
                triangle_codec: triangles.name(),
                triangle_bytes: bvh.triangle_bytes(),
                depth_bound: bvh.depth_bound(),
            }
        }),
    }
}

/// The report as text.
fn describe(
    name: &str,
    scene: &Scene,
    analysis: &Analysis,
    bvh: Option<&Bvh>,
    listed: usize,
) -> String {
    let mut text = String::new();
    let mut line = |name: &str, value: String| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{name:<11} {value}");
    };
    line("scene", name.into());
    line(
        "triangles",
        format!(
            "{}, of which {} degenerate, {} duplicate",
            count(analysis.triangle_count),
            count(analysis.degenerate_triangle_count),
            count(analysis.duplicate_triangle_count)
        ),
    );
    if scene.dropped_face_count > 0 {
        line("dropped", things(scene.dropped_face_count, "broken face"));
    }
    line(
        "vertices",
        format!(
            "{}, {} after welding",
            count(analysis.vertex_count),
            count(analysis.welded_vertex_count)
        ),
    );
    line(
        "also",
        format!(
            "{}, {}, {}",
            things(scene.materials.len(), "material"),
            things(scene.cameras.len(), "camera"),
            things(scene.lights.len(), "light")
        ),
    );
    if let Some(bounds) = &analysis.bounds {
        line("extent", extent(bounds));
    }
    if let Some(bvh) = bvh {
        line(
            "hierarchy",
            format!(
                "{} of {}, {}; {} of nodes and {} of triangles",
                things(bvh.node_count(), "node"),
                things(bvh.triangle_count(), "triangle"),
                storage::describe(bvh.codecs()),
                bytes(bvh.node_bytes()),
                bytes(bvh.triangle_bytes())
            ),
        );
    }
    let closed = analysis
        .components
        .iter()
        .filter(|component| component.closed)
        .count();
    line(
        "components",
        format!(
            "{}, of which {} closed",
            count(analysis.components.len()),
            count(closed)
        ),
    );
    for component in analysis.components.iter().take(listed) {
        line("", describe_component(component));
    }
    if analysis.components.len() > listed {
        let rest = analysis.components.len() - listed;
        line(
            "",
            format!("and {} smaller ones (--all lists them)", count(rest)),
        );
    }
    text
}

fn describe_component(component: &Component) -> String {
    let closed = if component.closed { "closed" } else { "open" };
    let wound = if component.consistently_wound {
        "consistently wound"
    } else {
        "inconsistently wound"
    };
    let outward = match component.outward {
        Some(true) => ", outward",
        Some(false) => ", inward",
        None => "",
    };
    format!(
        "{}: {closed}, {wound}{outward}; {}",
        things(component.triangle_count, "triangle"),
        extent(&component.bounds)
    )
}

/// Formats a box: `1 x 2 x 3 from (0, 0, 0) to (1, 2, 3)`.
fn extent(bounds: &Aabb) -> String {
    let [a, b] = [bounds.min, bounds.max];
    // Subtract in f64: the difference of two `f32` may overflow `f32`.
    let size: [f64; 3] = std::array::from_fn(|i| f64::from(b[i]) - f64::from(a[i]));
    // As many digits as an `f32` has, where it is one.
    let size = size.map(|x| match x as f32 {
        x if x.is_finite() => x.to_string(),
        _ => x.to_string(),
    });
    format!(
        "{} x {} x {} from ({}, {}, {}) to ({}, {}, {})",
        size[0], size[1], size[2], a[0], a[1], a[2], b[0], b[1], b[2]
    )
}
