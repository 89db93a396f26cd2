//! `slimbvh info`.

use super::SceneArguments;
use super::output::{self, bytes, count, things};
use super::storage;
use super::told::{self, LeftOutSummary};
use anyhow::Result;
use clap::Args;
use serde::Serialize;
use slimbvh::analysis::{Analysis, Component, analyze};
use slimbvh::{Aabb, Bvh, Scene, Up};
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
    single_sided_materials: usize,
    cameras: usize,
    lights: usize,
    left_out: Vec<LeftOutSummary>,
    #[serde(skip_serializing_if = "Option::is_none")]
    origin: Option<[f64; 3]>,
    extent: Option<Extent>,
    /// Whether it is wide and flat as if z pointed up.
    looks_z_up: bool,
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
    min: [f64; 3],
    max: [f64; 3],
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
    output::check_report(arguments.json.as_deref(), arguments.scene.file().as_slice())?;
    #[cfg(feature = "gpu")]
    if arguments.adapters {
        return super::adapters::run(arguments.json.as_deref());
    }
    let (scene, kept) = arguments.scene.open()?;
    let bvh = kept.map(|kept| kept.bvh);
    let progress = output::spinner("analyzing the mesh".into());
    let analysis = analyze(&scene.mesh);
    drop(progress);
    if !output::is_stdout(arguments.json.as_deref()) {
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
    let extent = |bounds: &Aabb| {
        let [min, max] = corners(scene, bounds);
        Extent { min, max }
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
        single_sided_materials: single_sided_count(scene),
        cameras: scene.cameras.len(),
        lights: scene.lights.len(),
        left_out: told::left_out(scene),
        origin: told::origin(scene),
        looks_z_up: looks_z_up(scene, analysis),
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

/// Whether a scene is wide, flat and level as if z pointed up: a map, a plan or a terrain. It is little along z, and most of its area
/// faces along z.
fn looks_z_up(scene: &Scene, analysis: &Analysis) -> bool {
    const FLAT: f32 = 0.25;
    const LEVEL: f64 = 0.6;
    // A card or a wall has few.
    const LEAST_TRIANGLES: usize = 100;
    let Some(bounds) = analysis.bounds.as_ref().filter(|_| scene.up == Up::Y) else {
        return false;
    };
    let [x, y, z] = (bounds.max - bounds.min).to_array();
    if z >= FLAT * x.min(y) || scene.mesh.indices.len() < LEAST_TRIANGLES {
        return false;
    }
    let mesh = &scene.mesh;
    let (mut level, mut all) = (0.0, 0.0);
    for &[a, b, c] in &mesh.indices {
        let [a, b, c] = [a, b, c].map(|vertex| mesh.vertices[vertex as usize].map(f64::from));
        let [u, v] = [b, c].map(|p| [0, 1, 2].map(|i| p[i] - a[i]));
        let normal = [
            u[1] * v[2] - u[2] * v[1],
            u[2] * v[0] - u[0] * v[2],
            u[0] * v[1] - u[1] * v[0],
        ];
        level += normal[2].abs();
        all += normal.iter().map(|x| x * x).sum::<f64>().sqrt();
    }
    level > LEVEL * all
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
            materials(scene),
            things(scene.cameras.len(), "camera"),
            things(scene.lights.len(), "light")
        ),
    );
    if let Some(words) = told::left_out_words(scene) {
        line("left out", words);
    }
    if let Some(words) = told::origin_words(scene) {
        line("origin", format!("{words}, taken off all positions"));
    }
    if let Some(bounds) = &analysis.bounds {
        line("extent", extent(scene, bounds));
    }
    if looks_z_up(scene, analysis) {
        line(
            "hint",
            "wide and flat: if z points up, render it with --up z".into(),
        );
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
        line("", describe_component(scene, component));
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

fn single_sided_count(scene: &Scene) -> usize {
    let materials = scene.materials.iter();
    materials.filter(|material| !material.double_sided).count()
}

/// `3 materials (2 single-sided)`.
fn materials(scene: &Scene) -> String {
    let all = things(scene.materials.len(), "material");
    match single_sided_count(scene) {
        0 => all,
        single => format!("{all} ({single} single-sided)"),
    }
}

fn describe_component(scene: &Scene, component: &Component) -> String {
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
        extent(scene, &component.bounds)
    )
}

/// Formats a box in the file's own coordinates: `1 x 2 x 3 from (0, 0, 0) to (1, 2, 3)`.
fn extent(scene: &Scene, bounds: &Aabb) -> String {
    // Subtract in f64: the difference of two `f32` may overflow `f32`.
    let size = [0, 1, 2].map(|i| f64::from(bounds.max[i]) - f64::from(bounds.min[i]));
    // As many digits as an `f32` has, where it is one.
    let size = size.map(|x| match x as f32 {
        x if x.is_finite() => x.to_string(),
        _ => x.to_string(),
    });
    let [a, b] = corners(scene, bounds);
    format!(
        "{} x {} x {} from ({}, {}, {}) to ({}, {}, {})",
        size[0], size[1], size[2], a[0], a[1], a[2], b[0], b[1], b[2]
    )
}

/// A box's corners in the file's own coordinates, with as many digits as their distance from the origin has in `f32`.
fn corners(scene: &Scene, bounds: &Aabb) -> [[f64; 3]; 2] {
    [bounds.min, bounds.max].map(|corner| [0, 1, 2].map(|i| shortest(corner[i]) + scene.origin[i]))
}

/// The number with the fewest digits that rounds to this one.
fn shortest(x: f32) -> f64 {
    x.to_string().parse().unwrap_or(f64::from(x))
}
