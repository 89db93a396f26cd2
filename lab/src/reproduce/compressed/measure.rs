//! Measurements of a scene.

use super::bench::{self, GpuRecord, Timed, TimedOn};
use super::cracks::{Cracks, aim};
use super::frames::Round;
use super::methods::{Method, Prepared};
use super::printed::Printed;
use super::protocol::Protocol;
use super::scenes::Subject;
use crate::measure::counts::{Counts, count};
use crate::measure::paths::Seen;
use crate::measure::pictures::changed;
use crate::measure::rounds::Rounds;
use crate::measure::step::PIXELS;
use crate::measure::walks::Walks;
use crate::reproduce::steps::Steps;
use crate::stress::moved;
use anyhow::Result;
use serde::Serialize;
use slimbvh::{Cpu, RenderSettings, Trees};
use slimbvh_cli::backend::Chosen;

/// The measurements of one scene.
#[derive(Serialize)]
pub struct SceneRecord {
    pub name: String,
    #[serde(skip)]
    pub printed: Option<Printed>,
    pub stand_in: Option<String>,
    /// Whether it is a mesh of the user's own.
    pub is_own: bool,
    /// Whether this is the smallest scene, where a codec has little to gain.
    #[serde(skip)]
    pub is_smallest: bool,
    pub triangles: usize,
    /// The diagonal of the scene's bounding box.
    pub diagonal: f32,
    /// The plain tree comes first.
    pub methods: Vec<MethodRecord>,
}

/// The measurements of one method.
#[derive(Serialize)]
pub struct MethodRecord {
    #[serde(skip)]
    pub method: Method,
    pub name: String,
    /// Bytes of the nodes, and of the triangles in the leaves.
    pub node_bytes: usize,
    pub triangle_bytes: usize,
    pub counts: Counts,
    /// The differences from the plain tree's picture.
    pub differences: Differences,
    /// The largest move of a vertex and its bound, in the scene's unit.
    pub moved: Option<[f32; 2]>,
    /// Only for closed scenes.
    pub cracks: Option<Cracks>,
    pub rounds: Rounds<Round>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub on_gpu: Option<GpuRecord>,
}

/// Numbers of pixels that differ between two pictures.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Differences {
    /// Pixels that miss where the plain tree's picture hits.
    pub lost: usize,
    /// Pixels that hit where the plain tree's picture misses.
    pub gained: usize,
    pub changed: usize,
    /// Pixels that differ by more than [`STRONG`] of 255.
    pub strongly: usize,
}

/// A difference above this may be visible.
pub const STRONG: u8 = 16;

impl SceneRecord {
    pub fn plain(&self) -> &MethodRecord {
        &self.methods[0]
    }

    /// The record of a method.
    pub fn of(&self, method: Method) -> Option<&MethodRecord> {
        self.methods.iter().find(|record| record.method == method)
    }
}

impl MethodRecord {
    /// Bytes of nodes and triangles.
    pub fn bytes(&self) -> usize {
        self.node_bytes + self.triangle_bytes
    }
}

/// Measures one scene with each method. Timed frames alternate with the plain tree; counts come from the CPU.
pub fn measure(subject: Subject, chosen: &Chosen, protocol: &Protocol) -> Result<SceneRecord> {
    let scene = &subject.scene;
    let settings = RenderSettings {
        size: protocol.size,
        mirror_depth: protocol.mirror_depth,
        ..RenderSettings::default()
    };
    let plain = Method::Plain.prepare(scene, &PIXELS);
    let mut bench = bench::open(chosen, &plain)?;
    let mut reference = Steps::new(Cpu, plain.config, &plain.scene, None)?;
    let aimed_rays = subject.is_closed.then_some(protocol.aimed_rays);
    reference.build_all()?;
    reference.render_all(&settings)?;
    let facts =
        |own: &Steps<Cpu>, prepared: &Prepared, reference: &Steps<Cpu>, seen: Option<&[Seen]>| {
            facts(prepared, (own, reference), (&settings, aimed_rays), seen)
        };
    let mut first = facts(&reference, &plain, &reference, None)?;
    first.on_gpu = bench.plain(&reference, &settings)?;
    let seen = first.counts.seen.clone();
    let mut methods = vec![first];
    for method in Method::all(TimedOn::of(chosen)) {
        let prepared = method.prepare(scene, &PIXELS);
        let mut own = Steps::new(Cpu, prepared.config, &prepared.scene, None)?;
        own.build_all()?;
        own.render_all(&settings)?;
        let mut record = facts(&own, &prepared, &reference, Some(&seen))?;
        let both = (&mut reference, &mut own);
        let Timed { rounds, on_gpu } = bench.time(both, &prepared, &settings, protocol.rounds)?;
        (record.rounds, record.on_gpu) = (rounds, on_gpu);
        methods.push(record);
    }
    // The plain tree's rounds are those beside all methods.
    let all = methods.iter().flat_map(|record| &record.rounds.0);
    let all = all.map(|round| Round {
        plain: round.plain.clone(),
        own: round.plain.clone(),
    });
    let all = all.collect();
    methods[0].rounds = Rounds(all);
    let bounds = scene.mesh.bounds();
    Ok(SceneRecord {
        name: subject.name,
        printed: subject.printed,
        triangles: scene.mesh.indices.len(),
        diagonal: bounds.map_or(0.0, |bounds| (bounds.max - bounds.min).length()),
        stand_in: subject.stand_in,
        is_own: subject.is_own,
        is_smallest: subject.is_smallest,
        methods,
    })
}

/// Measures a built tree and its picture, except for times. `seen` are the first hits of the reference.
fn facts(
    prepared: &Prepared,
    (own, reference): (&Steps<Cpu>, &Steps<Cpu>),
    (settings, aimed_rays): (&RenderSettings, Option<usize>),
    seen: Option<&[Seen]>,
) -> Result<MethodRecord> {
    let bvh = own.tree(0);
    let trees = Trees::all(bvh, prepared.scene.lights.len());
    let counts = count(&prepared.scene, &Walks::new(&trees), settings)?;
    let moved = if prepared.config.mesh.moves_vertices() {
        let moves = moved(reference.tree(0), &bvh.decoded())?;
        Some([moves.most, moves.bound].map(|distance| distance as f32))
    } else {
        prepared.moved
    };
    let cracks = aimed_rays.map(|count| aim(&prepared.scene, bvh, count));
    let differences = Differences {
        lost: differ(seen, &counts.seen, true),
        gained: differ(seen, &counts.seen, false),
        changed: changed(&own.picture, &reference.picture, 0),
        strongly: changed(&own.picture, &reference.picture, STRONG),
    };
    Ok(MethodRecord {
        method: prepared.method,
        name: prepared.method.name(),
        node_bytes: bvh.node_bytes(),
        triangle_bytes: bvh.triangle_bytes(),
        counts,
        differences,
        moved,
        cracks: cracks.transpose()?,
        rounds: Rounds::default(),
        on_gpu: None,
    })
}

/// The number of samples whose hit (`were`) or miss became the opposite.
fn differ(before: Option<&[Seen]>, after: &[Seen], were: bool) -> usize {
    let pairs = before.unwrap_or(after).iter().zip(after);
    pairs
        .map(|(before, after)| [before, after].map(Seen::is_anything))
        .filter(|[before, after]| *before == were && *after != were)
        .count()
}
