//! Measurements of a scene.

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

/// The measurements of one scene on one machine.
pub struct SceneRecord {
    pub name: String,
    pub backend: &'static str,
    pub triangles: usize,
    pub vertices: usize,
    pub lights: usize,
    /// The diagonal of the scene's bounding box.
    pub diagonal: f32,
    /// The default comes first.
    pub setups: Vec<SetupRecord>,
    /// The picture of the plain tree.
    pub picture: Picture,
}

/// The measurements of one setup.
pub struct SetupRecord {
    pub knob: Knob,
    pub setup: Setup,
    pub name: String,
    pub rounds: Rounds<Round>,
    /// The median time of the default in all its rounds, in milliseconds.
    pub usual_ms: f64,
    pub facts: Facts,
    pub peak_bytes: usize,
    pub likeness: Likeness,
    /// Whether the setup is on the Pareto front of time, bytes and error among the setups with the same work and threads.
    pub on_front: bool,
    /// The picture, if it differs from the plain tree's.
    pub picture: Option<Picture>,
}

/// The reference of all comparisons.
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

    /// Milliseconds per picture: the default's time, times the median ratio of this setup to the default in the same rounds.
    /// A temporary slowdown of the machine cancels out.
    pub fn frame(&self) -> f64 {
        self.usual_ms * self.ratio(Times::frame)
    }

    /// Milliseconds of each part of a picture, scaled so that their sum is [`Self::frame`].
    pub fn parts(&self) -> [f64; 7] {
        let parts = std::array::from_fn(|part| self.rounds.median(|round| round.own.parts()[part]));
        let sum: f64 = parts.iter().sum();
        parts.map(|ms| ms / sum * self.frame())
    }

    /// The median ratio of a time to the default's in the same round.
    pub fn ratio(&self, of: impl Fn(&Times) -> f64) -> f64 {
        self.rounds
            .median(|round| of(&round.own) / of(&round.usual))
    }
}

/// Measures one scene with each setup, alternating with the default.
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

/// Gives the default's record all rounds of the default, which were timed beside the other setups.
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

/// Alternates pictures of the default and of a setup, and compares the setup's last picture with the plain tree's.
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
    // The setup's first picture is not timed. The default's is the last one of the setup before.
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
