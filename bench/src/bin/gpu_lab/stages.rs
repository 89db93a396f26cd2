//! Section `stages`: times of a picture's stages, plain and coded trees in turn. Beside each is its ratio to stage `camera` of the
//! same frame, whose work is the same in all: the GPU's clock cancels out.

use crate::rayset::{STORED, picture};
use crate::scenes::cached;
use crate::session::Session;
use crate::traces::build;
use anyhow::{Context, Result};
use slimbvh::gpu::{Bvh, Gpu, Renderer, Scene as GpuScene};
use slimbvh::{Camera, Light, RenderSettings, Scene, Stages};
use slimbvh_bench::rays::{camera, sun};
use slimbvh_lab::measure::rounds::median;
use std::time::Duration;

/// `camera`: its time measures the clock.
const CLOCK: &str = "camera";

/// The stages that are shown.
const SHOWN: [&str; 3] = ["trace primary", "trace shadow", "shade"];

/// Renders the first scene that fits a cache.
pub fn run(session: &mut Session) -> Result<()> {
    let subjects = cached(session.is_quick, session.seed)?;
    let subject = subjects.into_iter().next().context("there is a scene")?;
    let name = subject.name;
    if !session.has(3.0, &name)? {
        return Ok(());
    }
    let scene = Scene {
        mesh: subject.mesh,
        ..Scene::default()
    };
    let uploaded = GpuScene::upload(&session.gpu, &scene)?;
    let mut pictures = Vec::new();
    for (codec, nodes) in STORED {
        let bvh = build(session, &uploaded.mesh, nodes)?;
        pictures.push((
            codec,
            Picture::new(&scene, &uploaded, bvh, session.is_quick)?,
        ));
    }
    if pictures[0].1.render(&session.gpu)?.total().is_zero() {
        return session.missed(&format!("{} has no timestamps", session.gpu.name()));
    }
    session.raise_clock(|| pictures[0].1.render(&session.gpu).map(drop))?;
    let mut rounds = vec![Vec::new(); pictures.len()];
    for round in 0..=session.rounds() {
        for ((_, picture), stages) in pictures.iter_mut().zip(&mut rounds) {
            let rendered = picture.render(&session.gpu)?;
            if round > 0 {
                stages.push(rendered);
            }
        }
    }
    for ((codec, _), rounds) in pictures.iter().zip(&rounds) {
        let ms = |stage| median(&mut seconds(rounds, stage)) * 1e3;
        session.row(&name, &format!("{codec}, {CLOCK}"), "ms", ms(CLOCK))?;
        let clock = seconds(rounds, CLOCK);
        for stage in SHOWN {
            session.row(&name, &format!("{codec}, {stage}"), "ms", ms(stage))?;
            let pairs = seconds(rounds, stage).into_iter().zip(&clock);
            let mut ratios: Vec<f64> = pairs.map(|(stage, clock)| stage / clock).collect();
            let what = format!("{codec}, {stage}");
            session.row(&name, &what, "× camera", median(&mut ratios))?;
        }
    }
    Ok(())
}

/// The seconds of a stage in each round.
fn seconds(rounds: &[Stages], stage: &str) -> Vec<f64> {
    let of = |stages: &Stages| {
        let found = stages.iter().find(|(name, _)| *name == stage);
        found.map_or(Duration::ZERO, |(_, time)| time).as_secs_f64()
    };
    rounds.iter().map(of).collect()
}

/// A picture with one tree for all rays.
struct Picture<'a> {
    uploaded: &'a GpuScene,
    bvh: Bvh,
    renderer: Renderer,
    camera: Camera,
    lights: Vec<Light>,
    settings: RenderSettings,
}

impl<'a> Picture<'a> {
    fn new(scene: &Scene, uploaded: &'a GpuScene, bvh: Bvh, is_quick: bool) -> Result<Self> {
        let bounds = scene.mesh.bounds().context("the mesh has no vertices")?;
        Ok(Self {
            uploaded,
            bvh,
            renderer: Renderer::default(),
            camera: camera(&bounds),
            lights: vec![sun()],
            settings: RenderSettings {
                size: picture(is_quick),
                ..RenderSettings::default()
            },
        })
    }

    fn render(&mut self, gpu: &Gpu) -> Result<Stages> {
        let mut frame = gpu.frame();
        self.renderer.render(
            &mut frame,
            self.uploaded,
            &self.bvh,
            &self.camera,
            &self.lights,
            &self.settings,
        )?;
        Ok(frame.submit()?.wait()?)
    }
}
