//! Everything that is measured of a scene.

use super::aim::Aim;
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

/// Sets in the order of all lists here: what faces the camera, what faces away, and both for the light.
pub const SETS: [&str; 4] = ["C+", "C-", "L+", "L-"];

/// Samples a pixel up to which sets are sorted both ways.
const MOST_SAMPLES_OF_BOTH: u32 = 16;

/// What was measured of one scene.
#[derive(Serialize)]
pub struct SceneRecord {
    pub name: &'static str,
    #[serde(skip)]
    pub printed: Option<printed::Printed>,
    #[serde(skip)]
    pub is_uniform: bool,
    pub stand_in: Option<String>,
    pub triangles: usize,
    /// Components, and how many of them are closed with an inside and an outside.
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

/// Trees over all triangles and over each set.
#[derive(Clone, Debug, Serialize)]
pub struct SetsRound {
    /// Order of all triangles.
    pub sort: f64,
    /// Order and tree.
    pub all: f64,
    pub sets: [SetTimes; 4],
}

/// One set.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct SetTimes {
    pub division: Division,
    /// Its triangles put in order by themselves.
    pub alone: Build,
    /// Its triangles taken from the order of all, which is not included.
    pub shared: Build,
}

/// Pictures of so many samples a pixel.
#[derive(Clone, Debug, Serialize)]
pub struct Pictures {
    pub samples: u32,
    /// With a whole tree.
    pub default: Rounds<Picture>,
    /// With sets for camera and light.
    pub reduced: Vec<Reduced>,
}

/// Pictures with sets.
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
    /// The share of the triangles that the set of all of them keeps.
    pub share: f64,
    /// What the plan chooses.
    pub plan: String,
    pub rows: Vec<LightsRow>,
}

/// One way to make them.
#[derive(Clone, Debug, Serialize)]
pub struct LightsRow {
    pub name: &'static str,
    /// Triangles of the tree for shadow rays, or of all trees together.
    pub triangles: usize,
    pub rounds: Rounds<Picture>,
}

/// Measures one scene. Lights near each other are tried on the one of which that is printed; so are savings, on the CPU.
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
    let camera = Aim::camera(scene, topology)?;
    let light = Aim::light(scene, 0, topology)?;
    let aims = [camera.clone(), camera.away(), light.clone(), light.away()];
    let sizes = aims.each_ref().map(|aim| aim.count(scene, topology));
    let either_will_do = is_seen_from_outside(topology, &camera);
    let (light_set, lit) = match either_will_do {
        true => (SETS[3], &aims[3]),
        false => (SETS[2], &aims[2]),
    };

    let config = BuildConfig::default();
    let mut steps = Steps::new(backend, config, scene, Some(topology))?;
    let sets = sets(&mut steps, &aims, protocol.build_rounds)?;
    let mut all_pictures = Vec::new();
    for &(samples, rounds) in &protocol.pictures {
        // The longest are for comparison with what is printed.
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

/// One picture of so many samples a pixel.
pub fn settings(protocol: &Protocol, sample_count: u32) -> RenderSettings {
    RenderSettings {
        size: protocol.size,
        sample_count,
        mirror_depth: 0,
        ..RenderSettings::default()
    }
}

/// Builds over all triangles and over each set, in turn. One round before does not count.
fn sets<B: Backend>(
    steps: &mut Steps<B>,
    aims: &[Aim; 4],
    rounds: u32,
) -> Result<Rounds<SetsRound>> {
    let mut all = Rounds(Vec::new());
    for round in 0..=rounds {
        let sort = ms(&steps.sort()?);
        let whole = ms(&steps.build(0, None)?);
        let mut sets = [SetTimes::default(); 4];
        for (place, (aim, times)) in (1..).zip(aims.iter().zip(&mut sets)) {
            times.shared = Build::of(&steps.build(place, Some(aim))?);
        }
        for (place, (aim, times)) in (1..).zip(aims.iter().zip(&mut sets)) {
            times.division = Division::of(&steps.divide(aim)?);
            times.alone = Build::of(&steps.build_alone(place, aim)?);
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

/// Makes pictures each way, in turn. Where there are many samples it hardly matters how sets are sorted: one way does.
fn pictures<B: Backend>(
    steps: &mut Steps<B>,
    (camera, light): (&Aim, &Aim),
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

/// Makes pictures under `side * side` lights.
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
    let camera = Aim::camera(&scene, topology)?;
    let group = rig.group(topology);
    let alone = (0..count).map(|light| Aim::light(&scene, light, topology));
    let alone: Vec<Aim> = alone.collect::<Result<_>>()?;
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
        let away: Vec<Aim> = alone.iter().map(Aim::away).collect();
        ways.extend([
            (
                "one set for all, L-",
                grouped(&camera, &group.away(), count),
            ),
            (
                "a set for each, L-",
                Layout::sets(&camera, &away, Sorting::Once),
            ),
        ]);
    }
    ways.push(("as the plan chooses", planned));
    let layouts: Vec<&Layout> = ways.iter().map(|(_, layout)| layout).collect();
    let config = BuildConfig::default();
    let mut steps = Steps::new(backend, config, &scene, Some(topology))?;
    let all = take_turns(&mut steps, &layouts, &settings, (1, protocol.light_rounds))?;
    let row = |((name, layout), rounds): ((&'static str, Layout), Rounds<Picture>)| {
        let triangles = |aim: &Option<Aim>| match aim {
            Some(aim) => aim.count(&scene, topology),
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

/// A set for the camera, and one for all lights.
fn grouped(camera: &Aim, group: &Aim, count: usize) -> Layout {
    Layout {
        lights: vec![0; count],
        ..Layout::sets(camera, std::slice::from_ref(group), Sorting::Once)
    }
}

/// Whether shadow rays begin outside of everything closed: then what faces away from a light blocks it as well.
fn is_seen_from_outside(topology: &Topology, camera: &Aim) -> bool {
    let eye = slimbvh::topology::Target::Point(camera.target.point);
    camera.target.is_position == 1 && topology.is_outside_all(&eye)
}
