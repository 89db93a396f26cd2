//! A run of a section: the GPU, the budget, and what is printed.

use crate::judgement::Judgement;
use crate::options::Options;
use crate::rayset::RaySet;
use crate::row::{Line, Row};
use crate::sections::Section;
use anyhow::Result;
use slimbvh::gpu::{Gpu, adapters};
use slimbvh_bench::machine;
use std::io::Write;
use std::time::{Duration, Instant};

/// How long a hardware GPU works before it is measured: an idle one is a few times slower at first.
const WARM_UP: Duration = Duration::from_millis(500);

/// A run of a section.
pub struct Session {
    /// The GPU.
    pub gpu: Gpu,
    /// Whether the adapter runs on the CPU.
    pub is_software: bool,
    /// Whether scenes are small.
    pub is_quick: bool,
    /// Of scenes and of bounce rays.
    pub seed: u64,
    /// Wrong answers so far.
    pub wrong_answers: u64,
    section: &'static str,
    end: Instant,
}

impl Session {
    /// Opens the GPU.
    pub fn open(options: &Options) -> Result<Self> {
        let gpu = Gpu::open(&options.adapter)?;
        let adapter = adapters().into_iter().find(|it| it.name == gpu.name());
        Ok(Self {
            is_software: adapter.is_some_and(|adapter| adapter.is_software),
            gpu,
            is_quick: options.is_quick,
            seed: options.seed,
            wrong_answers: 0,
            section: "",
            end: Instant::now() + options.budget,
        })
    }

    /// Prints what the results are of. All rows from here on are of this section.
    pub fn introduce(&mut self, section: Section) -> Result<()> {
        self.section = section.name();
        let adapters = adapters();
        let adapter = adapters.iter().find(|it| it.name == self.gpu.name());
        let kind = adapter.map_or_else(String::new, |it| {
            format!("{}, {}, {}", it.kind, it.api, it.driver)
        });
        let facts = [
            ("adapter", self.gpu.name().to_owned()),
            ("kind", kind),
            ("host", machine::processor()),
            ("date", machine::date()),
            ("seed", self.seed.to_string()),
        ];
        for (name, value) in facts {
            self.print(&Line::Fact(name.into(), value.replace(';', ",")))?;
        }
        Ok(())
    }

    /// Prints a result.
    pub fn row(&self, scene: &str, what: &str, unit: &str, value: f64) -> Result<()> {
        self.print(&Line::Row(Row {
            section: self.section.into(),
            scene: scene.into(),
            what: what.into(),
            unit: unit.into(),
            value,
        }))
    }

    /// Judges the adapter's answers to one set of rays.
    pub fn judge(&self, set: &RaySet, expected: &[u32], answers: &[u32]) -> Judgement {
        Judgement::new(set.question, expected, answers, self.is_software)
    }

    /// Prints a judgement, and counts the wrong answers.
    pub fn judged(&mut self, scene: &str, what: &str, judgement: Judgement) -> Result<()> {
        let Judgement {
            wrong,
            grazing,
            last_bits,
        } = judgement;
        self.wrong_answers += wrong as u64;
        self.row(scene, what, "wrong answers", wrong as f64)?;
        if !self.is_software {
            self.row(scene, what, "other last bits", last_bits as f64)?;
            self.row(scene, what, "other answers, grazing", grazing as f64)?;
        }
        Ok(())
    }

    /// Prints a sentence.
    pub fn note(&self, text: String) -> Result<()> {
        self.print(&Line::Note(text.replace(';', ",")))
    }

    /// Whether this much time is left. If not, prints what is not reached.
    pub fn has(&self, seconds: f64, what: &str) -> Result<bool> {
        let left = self.end.saturating_duration_since(Instant::now());
        let has = left.as_secs_f64() >= seconds;
        if !has {
            self.missed(what)?;
        }
        Ok(has)
    }

    /// Prints what of the section is not reached.
    pub fn missed(&self, what: &str) -> Result<()> {
        let text = format!("{}: {what}", self.section);
        self.print(&Line::Missed(text.replace(';', ",")))
    }

    /// Rounds after one to warm up.
    pub fn rounds(&self) -> usize {
        if self.is_quick { 3 } else { 15 }
    }

    /// Keeps a hardware GPU busy until its clock is up.
    pub fn raise_clock(&self, mut work: impl FnMut() -> Result<()>) -> Result<()> {
        let start = Instant::now();
        while !self.is_software && start.elapsed() < WARM_UP {
            work()?;
        }
        Ok(())
    }

    fn print(&self, line: &Line) -> Result<()> {
        let mut out = std::io::stdout().lock();
        writeln!(out, "{line}")?;
        Ok(out.flush()?)
    }
}
