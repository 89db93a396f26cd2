//! The measurements of a setup as a row of the table for programs.

use super::measure::{SceneRecord, SetupRecord};
use super::setup::Knob;
use super::times::{Round, Times};
use anyhow::{Context, Result};
use serde::Serialize;

/// Times are in milliseconds: the default's medians, times the median ratio of the same rounds ([`SetupRecord::frame`]), so that a
/// temporary slowdown of the machine cancels out. The spread of a part is that of its own times, the largest minus the smallest over
/// the median, and that of the whole picture [`SetupRecord::spread`]. Lengths are in the scene's unit.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    pub scene: String,
    pub backend: &'static str,
    /// The machine that measured, and the commit of the sources; empty if they are not present any more.
    pub machine: String,
    pub commit: String,
    pub knob: Knob,
    pub setup: String,
    pub reduce: &'static str,
    pub lights: &'static str,
    pub nodes: &'static str,
    pub mesh: String,
    pub code_bits: u32,
    pub tree: &'static str,
    pub update: &'static str,
    pub threads: usize,
    pub rounds: usize,
    pub plan_ms: f64,
    pub plan_spread: f64,
    pub build_ms: f64,
    pub build_spread: f64,
    pub encode_ms: f64,
    pub encode_spread: f64,
    pub primary_ms: f64,
    pub primary_spread: f64,
    pub shadow_ms: f64,
    pub shadow_spread: f64,
    pub reflection_ms: f64,
    pub reflection_spread: f64,
    pub rest_ms: f64,
    pub rest_spread: f64,
    pub frame_ms: f64,
    pub frame_spread: f64,
    /// The ratio to the default's time, median over rounds.
    pub frame_ratio: f64,
    /// Whether that ratio differs from 1 by more than its spread ([`Ratios::is_clear`](super::spread::Ratios::is_clear)).
    pub is_clear: bool,
    pub trees: usize,
    pub tree_triangles: usize,
    pub node_bytes: usize,
    pub triangle_bytes: usize,
    pub resident_bytes: usize,
    pub peak_bytes: usize,
    pub sah_cost: f64,
    pub primary_rays: u64,
    pub shadow_rays: u64,
    pub reflection_rays: u64,
    pub box_tests_per_ray: f64,
    pub triangle_tests_per_ray: f64,
    pub bytes_per_ray: f64,
    pub primary_bytes_per_ray: f64,
    pub shadow_bytes_per_ray: f64,
    pub reflection_bytes_per_ray: f64,
    pub vertex_moved_most: f64,
    pub vertex_moved_rms: f64,
    pub vertex_moved_bound: f64,
    pub distance_error_most: f64,
    pub distance_error_rms: f64,
    pub changed_primitives: f64,
    pub changed_pixels: f64,
    pub image_rmse: f64,
    pub ssim: f64,
    pub on_front: bool,
    /// Whether it is on the front wherever within their spreads the times lie.
    pub front_is_clear: bool,
}

/// Where and from what a row was measured.
pub struct Origin<'a> {
    pub machine: &'a str,
    pub commit: Option<&'a str>,
}

impl Row {
    pub fn new(scene: &SceneRecord, record: &SetupRecord, origin: &Origin) -> Self {
        let (setup, facts, likeness) = (&record.setup, &record.facts, &record.likeness);
        let spread = |part: usize| {
            let of = |round: &Round| round.own.parts()[part];
            match record.rounds.median(of) > 0.0 {
                true => record.rounds.spread(of),
                false => 0.0,
            }
        };
        let [
            plan_ms,
            build_ms,
            encode_ms,
            primary_ms,
            shadow_ms,
            reflection_ms,
            rest_ms,
        ] = record.parts();
        let [
            plan_spread,
            build_spread,
            encode_spread,
            primary_spread,
            shadow_spread,
            reflection_spread,
            rest_spread,
        ] = [0, 1, 2, 3, 4, 5, 6].map(spread);
        let ratios = record.ratios(Times::frame);
        let counts = &facts.counts;
        let all = counts.all();
        Self {
            scene: scene.name.clone(),
            backend: scene.backend,
            machine: origin.machine.into(),
            commit: origin.commit.unwrap_or_default().into(),
            knob: record.knob,
            setup: record.name.clone(),
            reduce: setup.reduce_name(),
            lights: setup.lights_name(),
            nodes: setup.nodes_name(),
            mesh: setup.mesh_name(),
            code_bits: setup.code_bits(),
            tree: setup.tree_name(),
            update: setup.update_name(),
            threads: setup.threads,
            rounds: record.rounds.0.len(),
            plan_ms,
            plan_spread,
            build_ms,
            build_spread,
            encode_ms,
            encode_spread,
            primary_ms,
            primary_spread,
            shadow_ms,
            shadow_spread,
            reflection_ms,
            reflection_spread,
            rest_ms,
            rest_spread,
            frame_ms: record.frame(),
            frame_spread: record.spread(),
            frame_ratio: ratios.median,
            is_clear: ratios.is_clear(),
            trees: facts.trees,
            tree_triangles: facts.tree_triangles,
            node_bytes: facts.node_bytes,
            triangle_bytes: facts.triangle_bytes,
            resident_bytes: facts.resident_bytes(),
            peak_bytes: record.peak_bytes,
            sah_cost: facts.sah_cost,
            primary_rays: counts.eye.rays,
            shadow_rays: counts.shadow.rays,
            reflection_rays: counts.secondary.rays,
            box_tests_per_ray: all.box_tests(),
            triangle_tests_per_ray: all.triangle_tests(),
            bytes_per_ray: all.bytes_read(),
            primary_bytes_per_ray: counts.eye.bytes_read(),
            shadow_bytes_per_ray: counts.shadow.bytes_read(),
            reflection_bytes_per_ray: counts.secondary.bytes_read(),
            vertex_moved_most: facts.moves.most,
            vertex_moved_rms: facts.moves.rms,
            vertex_moved_bound: facts.moves.bound,
            distance_error_most: likeness.distance_most,
            distance_error_rms: likeness.distance_rms,
            changed_primitives: likeness.changed_primitives,
            changed_pixels: likeness.changed_pixels,
            image_rmse: likeness.image_rmse,
            ssim: likeness.ssim,
            on_front: record.on_front,
            front_is_clear: record.front_is_clear,
        }
    }
}

/// The rows as comma-separated values, with the names in the first line (RFC 4180).
pub fn csv(rows: &[Row]) -> Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.serialize(row)?;
    }
    writer
        .into_inner()
        .ok()
        .context("a table cannot be written")
}
