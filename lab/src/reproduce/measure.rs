//! All measurements of a scene.

use super::facing_target::FacingTarget;
use super::layout::{Layout, Sorting, take_turns};
use super::lights::{self, Rig};
use super::printed;
use super::protocol::Protocol;
use super::savings::{self, SavingRecord};
use super::scenes::Subject;
use super::steps::Steps;
use super::times::{Build, Division, Picture, ms};
use super::visits::{self, Visits};
use crate::measure::rounds::Rounds;
use anyhow::Result;
use serde::Serialize;
use slimbvh::topology::Topology;
use slimbvh::{Backend, BuildConfig, Cpu, RenderSettings, Scene};
use slimbvh_cli::backend::Chosen;

/// The sets, in the order of all lists here: triangles that face the camera, that face away from it, and both for the light.
pub const SETS: [&str; 4] = ["C+", "C-", "L+", "L-"];

/// Up to this number of samples a pixel, pictures are rendered with both ways to sort sets.
const MOST_SAMPLES_OF_BOTH: u32 = 16;

/// The measurements of one scene.
#[derive(Serialize)]
pub struct SceneRecord {
    pub name: String,
    #[serde(skip)]
    pub printed: Option<printed::Printed>,
    #[serde(skip)]
    pub is_uniform: bool,
    pub stand_in: Option<String>,
    /// Whether it is a mesh of the user's own.
    pub is_own: bool,
    pub triangles: usize,
    /// The number of components, and of those that are closed with an inside and an outside.
    pub components: [usize; 2],
    /// Triangles that stay in every set.
    pub seams: usize,
    /// Triangles of each set.
    pub sizes: [usize; 4],
    /// The set for shadow rays.
    pub light_set: &'static str,
    pub sets: Rounds<SetsRound>,
    pub pictures: Vec<Pictures>,
    pub visits: Visits,
    pub lights: Vec<LightsRecord>,
    pub savings: Vec<SavingRecord>,
}

/// Times of one round: trees over all triangles and over each set, in milliseconds.
#[derive(Clone, Debug, Serialize)]
pub struct SetsRound {
    /// Sorting all triangles.
    pub sort: f64,
    /// Sorting and building the whole tree.
    pub all: f64,
    pub sets: [SetTimes; 4],
}

/// Times of one set.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct SetTimes {
    pub division: Division,
    /// Sorted alone, as in the paper.
    pub alone: Build,
    /// Selected from the order of all triangles; that sort is not included.
    pub shared: Build,
}

/// Pictures with one number of samples a pixel.
#[derive(Clone, Debug, Serialize)]
pub struct Pictures {
    pub samples: u32,
    /// With a whole tree.
    pub default: Rounds<Picture>,
    /// With sets for camera and light.
    pub reduced: Vec<Reduced>,
}

/// Pictures with sets, for one way to sort them.
#[derive(Clone, Debug, Serialize)]
pub struct Reduced {
    pub sorting: Sorting,
    pub rounds: Rounds<Picture>,
}

/// Pictures under lights that are near each other.
#[derive(Clone, Debug, Serialize)]
pub struct LightsRecord {
    pub lights: usize,
    pub spacing: f32,
    /// The share of the triangles that the set shared by all lights keeps.
    pub share: f64,
    /// The plan's choice, in words.
    pub plan: String,
    pub rows: Vec<LightsRow>,
}

/// Pictures with one choice of sets.
#[derive(Clone, Debug, Serialize)]
pub struct LightsRow {
    pub name: &'static str,
    /// Triangles in all trees for shadow rays.
    pub triangles: usize,
    pub rounds: Rounds<Picture>,
}

/// Measures one scene. Groups of lights and, on the CPU, savings are measured on the scene for which the paper prints them, and on
/// meshes of the user's own.
pub fn measure(
    subject: Subject,
    chosen: &Chosen,
    protocol: &Protocol,
    has_lights: bool,
) -> Result<SceneRecord> {
    match chosen {
        Chosen::Cpu => measure_on(Cpu, subject, protocol, has_lights),
        #[cfg(feature = "gpu")]
        Chosen::Gpu(gpu) | Chosen::GpuIfItFits(gpu) => {
            measure_on(gpu, subject, protocol, has_lights)
        }
    }
}

fn measure_on<B: Backend>(
    backend: B,
    subject: Subject,
    protocol: &Protocol,
    has_lights: bool,
) -> Result<SceneRecord> {
    let (scene, topology) = (&subject.scene, &subject.topology);
    let camera = FacingTarget::camera(scene, topology)?;
    let light = FacingTarget::light(scene, 0, topology)?;
    let targets = [camera.clone(), camera.back(), light.clone(), light.back()];
    let sizes = targets
        .each_ref()
        .map(|target| target.count(scene, topology));
    let either_will_do = is_seen_from_outside(topology, &camera);
    let (light_set, lit) = match either_will_do {
        true => (SETS[3], &targets[3]),
        false => (SETS[2], &targets[2]),
    };

    let config = BuildConfig::default();
    let mut steps = Steps::new(backend, config, scene, Some(topology))?;
    let sets = sets(&mut steps, &targets, protocol.build_rounds)?;
    let mut all_pictures = Vec::new();
    for &(samples, rounds) in &protocol.pictures {
        // The longest pictures are only compared with printed figures.
        if subject.printed.is_none() && samples > MOST_SAMPLES_OF_BOTH {
            continue;
        }
        let settings = settings(protocol, samples);
        let warm_ups = u32::from(samples == 1);
        let turns = (warm_ups, rounds);
        all_pictures.push(pictures(&mut steps, (&camera, lit), &settings, turns)?);
    }
    drop(steps);
    let mut all_lights = Vec::new();
    if has_lights {
        for &side in &protocol.light_sides {
            all_lights.push(many_lights(backend, &subject, protocol, side)?);
        }
    }
    let savings = if has_lights && !B::RECORDS {
        savings::measure(&subject, protocol)?
    } else {
        Vec::new()
    };
    let facts = topology.facts();
    let reducible = facts.iter().filter(|facts| facts.reducible).count();
    let visits = visits::count(scene, topology, (&camera, &light), protocol.size)?;
    Ok(SceneRecord {
        name: subject.name,
        printed: subject.printed,
        is_uniform: subject.is_uniform,
        stand_in: subject.stand_in,
        is_own: subject.is_own,
        triangles: scene.mesh.indices.len(),
        components: [facts.len(), reducible],
        seams: topology.seam_count(),
        sizes,
        light_set,
        sets,
        pictures: all_pictures,
        visits,
        lights: all_lights,
        savings,
    })
}

/// The settings of a picture with this number of samples a pixel.
pub fn settings(protocol: &Protocol, sample_count: u32) -> RenderSettings {
    RenderSettings {
        size: protocol.size,
        sample_count,
        mirror_depth: 0,
        ..RenderSettings::default()
    }
}

/// Builds over all triangles and over each set, in turn. The first round is not counted.
fn sets<B: Backend>(
    steps: &mut Steps<B>,
    targets: &[FacingTarget; 4],
    rounds: u32,
) -> Result<Rounds<SetsRound>> {
    let mut all = Rounds(Vec::new());
    for round in 0..=rounds {
        let sort = ms(&steps.sort()?);
        let whole = ms(&steps.build(0, None)?);
        let mut sets = [SetTimes::default(); 4];
        for (place, (target, times)) in (1..).zip(targets.iter().zip(&mut sets)) {
            times.shared = Build::of(&steps.build(place, Some(target))?);
        }
        for (place, (target, times)) in (1..).zip(targets.iter().zip(&mut sets)) {
            times.division = Division::of(&steps.divide(target)?);
            times.alone = Build::of(&steps.build_alone(place, target)?);
        }
        if round > 0 {
            all.0.push(SetsRound {
                sort,
                all: sort + whole,
                sets,
            });
        }
    }
    Ok(all)
}

/// Renders pictures with each layout, in turn. With many samples only one way to sort sets is measured, as sorting hardly
/// matters then.
fn pictures<B: Backend>(
    steps: &mut Steps<B>,
    (camera, light): (&FacingTarget, &FacingTarget),
    settings: &RenderSettings,
    turns: (u32, u32),
) -> Result<Pictures> {
    let is_long = settings.sample_count > MOST_SAMPLES_OF_BOTH;
    let sortings = match (steps.sorts_sets_alone(), is_long) {
        (true, true) => &[Sorting::Each][..],
        (true, false) => &[Sorting::Each, Sorting::Once],
        (false, _) => &[Sorting::Once],
    };
    let lights = std::slice::from_ref(light);
    let reduced = sortings
        .iter()
        .map(|&sorting| Layout::sets(camera, lights, sorting));
    let layouts: Vec<Layout> = [Layout::whole(1)].into_iter().chain(reduced).collect();
    let layouts: Vec<&Layout> = layouts.iter().collect();
    let mut all = take_turns(steps, &layouts, settings, turns)?.into_iter();
    let default = all.next().unwrap_or(Rounds(Vec::new()));
    let reduced = sortings.iter().zip(all);
    Ok(Pictures {
        samples: settings.sample_count,
        default,
        reduced: reduced
            .map(|(&sorting, rounds)| Reduced { sorting, rounds })
            .collect(),
    })
}

/// Renders pictures under `side * side` lights.
fn many_lights<B: Backend>(
    backend: B,
    subject: &Subject,
    protocol: &Protocol,
    side: u32,
) -> Result<LightsRecord> {
    let topology = &subject.topology;
    let count = (side * side) as usize;
    let rig = Rig::new(&subject.scene, topology, side, printed::group_share(count));
    let scene = Scene {
        lights: rig.lights.clone(),
        ..subject.scene.clone()
    };
    let camera = FacingTarget::camera(&scene, topology)?;
    let group = rig.group(topology);
    let alone = (0..count).map(|light| FacingTarget::light(&scene, light, topology));
    let alone: Vec<FacingTarget> = alone.collect::<Result<_>>()?;
    let settings = settings(protocol, 1);
    let (plan, planned) = lights::plan(&scene, topology, &settings)?;
    let mut ways = vec![
        ("default", Layout::whole(count)),
        ("one set for all, L+", grouped(&camera, &group, count)),
        (
            "a set for each, L+",
            Layout::sets(&camera, &alone, Sorting::Once),
        ),
    ];
    if is_seen_from_outside(topology, &camera) {
        let back: Vec<FacingTarget> = alone.iter().map(FacingTarget::back).collect();
        ways.extend([
            (
                "one set for all, L-",
                grouped(&camera, &group.back(), count),
            ),
            (
                "a set for each, L-",
                Layout::sets(&camera, &back, Sorting::Once),
            ),
        ]);
    }
    ways.push(("as the plan chooses", planned));
    let layouts: Vec<&Layout> = ways.iter().map(|(_, layout)| layout).collect();
    let config = BuildConfig::default();
    let mut steps = Steps::new(backend, config, &scene, Some(topology))?;
    let all = take_turns(&mut steps, &layouts, &settings, (1, protocol.light_rounds))?;
    let row = |((name, layout), rounds): ((&'static str, Layout), Rounds<Picture>)| {
        let triangles = |target: &Option<FacingTarget>| match target {
            Some(target) => target.count(&scene, topology),
            None => scene.mesh.indices.len(),
        };
        LightsRow {
            name,
            triangles: layout.shadows.iter().map(triangles).sum(),
            rounds,
        }
    };
    Ok(LightsRecord {
        lights: count,
        spacing: rig.spacing,
        share: rig.share,
        plan,
        rows: ways.into_iter().zip(all).map(row).collect(),
    })
}

/// The layout with a set for the camera and one set for all lights.
fn grouped(camera: &FacingTarget, group: &FacingTarget, count: usize) -> Layout {
    Layout {
        lights: vec![0; count],
        ..Layout::sets(camera, std::slice::from_ref(group), Sorting::Once)
    }
}

/// Whether shadow rays start outside of all closed components. Then the back set, L−, blocks each light as well.
fn is_seen_from_outside(topology: &Topology, camera: &FacingTarget) -> bool {
    let eye = slimbvh::topology::Target::Point(camera.target.point);
    camera.target.is_position == 1 && topology.is_outside_all(&eye)
}
