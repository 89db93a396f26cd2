//! The measurements of a setup as a row of the table for programs.

use super::measure::{SceneRecord, SetupRecord};
use super::setup::Knob;
use super::times::Times;
use anyhow::{Context, Result};
use serde::Serialize;

/// Times are medians in milliseconds. Spreads are maximum minus minimum over the median. Lengths are in the scene's unit.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    pub scene: String,
    pub backend: &'static str,
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
}

impl Row {
    pub fn new(scene: &SceneRecord, record: &SetupRecord) -> Self {
        let (setup, facts, likeness) = (&record.setup, &record.facts, &record.likeness);
        let part = |of: fn(&Times) -> f64| {
            let of = |round: &super::times::Round| of(&round.own);
            let median = record.rounds.median(of);
            let spread = match median > 0.0 {
                true => record.rounds.spread(of),
                false => 0.0,
            };
            (median, spread)
        };
        let (plan_ms, plan_spread) = part(|times| times.plan);
        let (build_ms, build_spread) = part(|times| times.build);
        let (encode_ms, encode_spread) = part(|times| times.encode);
        let (primary_ms, primary_spread) = part(|times| times.primary);
        let (shadow_ms, shadow_spread) = part(|times| times.shadow);
        let (reflection_ms, reflection_spread) = part(|times| times.reflection);
        let (rest_ms, rest_spread) = part(|times| times.rest);
        let (frame_ms, frame_spread) = part(Times::frame);
        let counts = &facts.counts;
        let all = counts.all();
        Self {
            scene: scene.name.clone(),
            backend: scene.backend,
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
            frame_ms,
            frame_spread,
            frame_ratio: record.ratio(Times::frame),
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
