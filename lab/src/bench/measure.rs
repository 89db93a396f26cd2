//! Everything that is measured of a scene.

use super::cross::{Objectives, candidates};
use super::facts::Facts;
use super::likeness::Likeness;
use super::pareto::front;
use super::prepared::Prepared;
use super::protocol::Protocol;
use super::scenes::Subject;
use super::setup::{Knob, Setup};
use super::times::{Round, Times};
use super::trial::{Trial, has};
use crate::measure::paths::Seen;
use crate::measure::rounds::Rounds;
use anyhow::Result;
use slimbvh::{Backend, Cpu, Frames, Picture, RenderSettings};
use slimbvh_cli::backend::Chosen;
use slimbvh_cli::output;

/// What was measured of one scene on one machine.
pub struct SceneRecord {
    pub name: String,
    pub backend: &'static str,
    pub triangles: usize,
    pub vertices: usize,
    pub lights: usize,
    /// Of the scene's box.
    pub diagonal: f32,
    /// The default first.
    pub setups: Vec<SetupRecord>,
    /// The plain tree's.
    pub picture: Picture,
}

/// What was measured with one setup.
pub struct SetupRecord {
    pub knob: Knob,
    pub setup: Setup,
    pub name: String,
    pub rounds: Rounds<Round>,
    /// The median of all that was timed of the default, in milliseconds.
    pub usual_ms: f64,
    pub facts: Facts,
    pub peak_bytes: usize,
    pub likeness: Likeness,
    /// Whether nothing that does the same work on the same cores is better in time, bytes and error.
    pub on_front: bool,
    /// Where it differs from the plain tree's.
    pub picture: Option<Picture>,
}

/// What everything is compared with.
struct Plain {
    seen: Vec<Seen>,
    picture: Picture,
}

impl SetupRecord {
    pub fn objectives(&self) -> Objectives {
        [
            self.frame(),
            self.facts.resident_bytes() as f64,
            self.likeness.image_rmse,
        ]
    }

    /// Milliseconds a picture: the default's, times how many times as long this took in the same rounds, so that what slowed the
    /// machine for a while does not tell.
    pub fn frame(&self) -> f64 {
        self.usual_ms * self.ratio(Times::frame)
    }

    /// Milliseconds of each part of a picture, which together are [`Self::frame`].
    pub fn parts(&self) -> [f64; 7] {
        let parts = std::array::from_fn(|part| self.rounds.median(|round| round.own.parts()[part]));
        let sum: f64 = parts.iter().sum();
        parts.map(|ms| ms / sum * self.frame())
    }

    /// How many times as long as the default's a picture takes.
    pub fn ratio(&self, of: impl Fn(&Times) -> f64) -> f64 {
        self.rounds
            .median(|round| of(&round.own) / of(&round.usual))
    }
}

/// Measures one scene with each setup, in turn with the default.
pub fn measure(
    subject: &Subject,
    chosen: &Chosen,
    protocol: &Protocol,
    threads: usize,
) -> Result<SceneRecord> {
    match chosen {
        Chosen::Cpu => measure_on(Cpu, subject, chosen, protocol, threads),
        #[cfg(feature = "gpu")]
        Chosen::Gpu(gpu) | Chosen::GpuIfItFits(gpu) => {
            measure_on(gpu, subject, chosen, protocol, threads)
        }
    }
}

fn measure_on<B: Backend>(
    backend: B,
    subject: &Subject,
    chosen: &Chosen,
    protocol: &Protocol,
    threads: usize,
) -> Result<SceneRecord>
where
    Frames<B>: Send,
{
    let scene = &subject.scene;
    let settings = RenderSettings {
        size: protocol.size,
        mirror_depth: protocol.mirror_depth,
        ..RenderSettings::default()
    };
    let prepared = Prepared::new(Setup::plain(threads), scene, settings);
    let facts = Facts::new(&prepared)?;
    let mut trial = Trial::new(backend, &prepared)?;
    trial.frame()?;
    let plain = Plain {
        seen: facts.counts.seen,
        picture: trial.picture.clone(),
    };
    drop(trial);

    let usual = Prepared::new(Setup::usual(threads), scene, settings);
    let mut usual_trial = Trial::new(backend, &usual)?;
    usual_trial.frame()?;
    let progress = output::bar(&format!("measuring {}", subject.name));
    let mut setups: Vec<SetupRecord> = Vec::new();
    let mut run = |list: Vec<(Knob, Setup)>, setups: &mut Vec<SetupRecord>| -> Result<()> {
        let all = (setups.len() + list.len() + protocol.crossed) as f64;
        for (knob, setup) in list {
            if !has(chosen, &setup, &usual.setup) {
                continue;
            }
            let prepared = Prepared::new(setup, scene, settings);
            let mut own = Trial::new(backend, &prepared)?;
            let both = (&mut usual_trial, &mut own);
            let mut record = measure_one(&prepared, both, &plain, protocol)?;
            (record.knob, record.name) = (knob, setup.name(&usual.setup));
            setups.push(record);
            progress.set(setups.len() as f64 / all);
        }
        settle(setups);
        Ok(())
    };
    let single = Setup::one_at_a_time(threads, scene.lights.len());
    run(single, &mut setups)?;
    let crossed = candidates(&setups, protocol.crossed).into_iter();
    run(
        crossed.map(|setup| (Knob::Crossed, setup)).collect(),
        &mut setups,
    )?;
    mark_front(&mut setups);
    let bounds = scene.mesh.bounds();
    Ok(SceneRecord {
        name: subject.name.clone(),
        backend: B::NAME,
        triangles: scene.mesh.indices.len(),
        vertices: scene.mesh.vertices.len(),
        lights: scene.lights.len(),
        diagonal: bounds.map_or(0.0, |bounds| (bounds.max - bounds.min).length()),
        setups,
        picture: plain.picture,
    })
}

/// All that was timed of the default, in turn with whatever, is the default's.
fn settle(setups: &mut [SetupRecord]) {
    let usual = |record: &SetupRecord| {
        let rounds = record.rounds.0.iter();
        rounds.map(|round| round.usual).collect::<Vec<_>>()
    };
    let rounds = setups.iter().skip(1).flat_map(usual);
    let rounds: Vec<Round> = rounds.map(|usual| Round { usual, own: usual }).collect();
    if rounds.is_empty() {
        return;
    }
    let rounds = Rounds(rounds);
    let usual_ms = rounds.median(|round| round.usual.frame());
    for record in setups.iter_mut() {
        record.usual_ms = usual_ms;
    }
    if let Some(first) = setups.first_mut() {
        first.rounds = rounds;
    }
}

/// Makes pictures with the default and with a setup in turn, and compares the last one.
fn measure_one<B: Backend>(
    prepared: &Prepared,
    (usual, own): (&mut Trial<B>, &mut Trial<B>),
    plain: &Plain,
    protocol: &Protocol,
) -> Result<SetupRecord>
where
    Frames<B>: Send,
{
    let mut rounds = Rounds::default();
    // One before does not count. The default's is the last of the setup before.
    own.frame()?;
    for _ in 0..protocol.rounds {
        rounds.0.push(Round {
            usual: usual.frame()?,
            own: own.frame()?,
        });
    }
    let mut facts = Facts::new(prepared)?;
    let picture = &own.picture;
    let seen = std::mem::take(&mut facts.counts.seen);
    let likeness = Likeness::new(picture, &plain.picture, [&seen, &plain.seen])?;
    Ok(SetupRecord {
        knob: Knob::Default,
        setup: prepared.setup,
        name: String::new(),
        rounds,
        usual_ms: f64::NAN,
        facts,
        peak_bytes: own.peak_bytes(),
        likeness,
        on_front: false,
        picture: (likeness.changed_pixels > 0.0).then(|| picture.clone()),
    })
}

fn mark_front(setups: &mut [SetupRecord]) {
    let Some(usual) = setups.first().map(|record| record.setup) else {
        return;
    };
    let mut comparable: Vec<&mut SetupRecord> = setups
        .iter_mut()
        .filter(|record| record.setup.is_comparable(&usual))
        .collect();
    let objectives: Vec<Objectives> = comparable.iter().map(|it| it.objectives()).collect();
    for (record, on_front) in comparable.iter_mut().zip(front(&objectives)) {
        record.on_front = on_front;
    }
}
