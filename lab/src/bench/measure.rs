//! Measurements of a scene.

use super::cross::{Objectives, candidates};
use super::equal::{Equal, Work, known_as};
use super::facts::Facts;
use super::likeness::Likeness;
use super::only::Only;
use super::pareto::{front, stays};
use super::prepared::Prepared;
use super::protocol::Protocol;
use super::scenes::Subject;
use super::setup::{Knob, Setup};
use super::spread::Ratios;
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
    /// Setups that were not measured, as each does the same work as one of those above.
    pub equal: Vec<Equal>,
    /// The picture of the plain tree.
    pub picture: Picture,
}

/// What is measured, and how.
pub struct Conditions<'a> {
    pub protocol: &'a Protocol,
    pub threads: usize,
    pub only: &'a Only,
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
    /// Whether it is there wherever within their spreads the times lie.
    pub front_is_clear: bool,
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
        self.ratios(of).median
    }

    /// The ratios of a time to the default's in the same rounds.
    pub fn ratios(&self, of: impl Fn(&Times) -> f64) -> Ratios {
        let rounds = self.rounds.0.iter();
        Ratios::new(rounds.map(|round| of(&round.own) / of(&round.usual)))
    }

    /// The spread of [`Self::frame`]: that of the ratios; for the default, which all others are compared with, that of its times.
    pub fn spread(&self) -> f64 {
        match self.knob {
            Knob::Default => self.rounds.spread(|round| round.own.frame()),
            _ => self.ratios(Times::frame).spread(),
        }
    }

    /// Where [`Self::frame`] may lie, beside the default's.
    pub fn frame_range(&self) -> [f64; 2] {
        let range = self.ratios(Times::frame).range();
        range.map(|ratio| ratio * self.usual_ms)
    }

    /// The ranges of [`Self::objectives`].
    fn objective_ranges(&self) -> [[f64; 2]; 3] {
        let [_, bytes, error] = self.objectives();
        [self.frame_range(), [bytes; 2], [error; 2]]
    }
}

/// Measures one scene with each setup, alternating with the default.
pub fn measure(subject: &Subject, chosen: &Chosen, conditions: &Conditions) -> Result<SceneRecord> {
    match chosen {
        Chosen::Cpu => measure_on(Cpu, subject, chosen, conditions),
        #[cfg(feature = "gpu")]
        Chosen::Gpu(gpu) | Chosen::GpuIfItFits(gpu) => measure_on(gpu, subject, chosen, conditions),
    }
}

fn measure_on<B: Backend>(
    backend: B,
    subject: &Subject,
    chosen: &Chosen,
    conditions: &Conditions,
) -> Result<SceneRecord>
where
    Frames<B>: Send,
{
    let Conditions {
        protocol,
        threads,
        only,
    } = *conditions;
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
    let mut works: Vec<Work> = Vec::new();
    let mut equal: Vec<Equal> = Vec::new();
    let mut run = |list: Vec<(Knob, Setup)>,
                   setups: &mut Vec<SetupRecord>,
                   equal: &mut Vec<Equal>|
     -> Result<()> {
        let all = (setups.len() + list.len() + protocol.crossed) as f64;
        for (knob, setup) in list {
            let name = setup.name(&usual.setup);
            if !has(chosen, &setup, &usual.setup) || !only.wants(knob, &name) {
                continue;
            }
            let prepared = Prepared::new(setup, scene, settings);
            let work = Work::new(&prepared)?;
            if let Some(same) = works.iter().position(|other| work.is_same(other)) {
                equal.push(Equal {
                    scene: subject.name.clone(),
                    backend: B::NAME,
                    knob,
                    setup: name,
                    measured_as: setups[same].name.clone(),
                    setups: [setup, setups[same].setup],
                });
                continue;
            }
            works.push(work);
            let mut own = Trial::new(backend, &prepared)?;
            let both = (&mut usual_trial, &mut own);
            let mut record = measure_one(&prepared, both, &plain, protocol)?;
            (record.knob, record.name) = (knob, name);
            setups.push(record);
            progress.set(setups.len() as f64 / all);
        }
        settle(setups);
        Ok(())
    };
    let single = Setup::one_at_a_time(threads, scene.lights.len());
    run(single, &mut setups, &mut equal)?;
    let crossed = candidates(&setups, &known_as(&equal), protocol.crossed).into_iter();
    let crossed = crossed.map(|setup| (Knob::Crossed, setup));
    run(crossed.collect(), &mut setups, &mut equal)?;
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
        equal,
        picture: plain.picture,
    })
}

/// Gives the default's record all rounds of the default, which were timed beside the other setups.
fn settle(setups: &mut [SetupRecord]) {
    let usual = |record: &SetupRecord| {
        let rounds = record.rounds.0.iter();
        rounds.map(|round| round.usual).collect::<Vec<_>>()
    };
    // The default beside itself, only if it is alone.
    let beside = usize::from(setups.len() > 1);
    let rounds = setups.iter().skip(beside).flat_map(usual);
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
        front_is_clear: false,
        picture: (likeness.changed_pixels > 0.0).then(|| picture.clone()),
    })
}

/// Marks the setups on the Pareto front.
pub fn mark_front(setups: &mut [SetupRecord]) {
    let Some(usual) = setups.first().map(|record| record.setup) else {
        return;
    };
    let mut comparable: Vec<&mut SetupRecord> = setups
        .iter_mut()
        .filter(|record| record.setup.is_comparable(&usual))
        .collect();
    let objectives: Vec<Objectives> = comparable.iter().map(|it| it.objectives()).collect();
    let ranges: Vec<_> = comparable.iter().map(|it| it.objective_ranges()).collect();
    let marks = front(&objectives).into_iter().zip(stays(&ranges));
    for (record, (on_front, stays)) in comparable.iter_mut().zip(marks) {
        record.on_front = on_front;
        record.front_is_clear = on_front && stays;
    }
}
