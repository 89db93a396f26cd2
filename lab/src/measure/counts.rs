//! Counts of the nodes and triangles that the rays of a picture touch in a tree. They are the same on every machine.

use super::paths::{Kind, Paths, Seen};
use super::walks::Walks;
use anyhow::{Result, ensure};
use rayon::prelude::*;
use serde::Serialize;
use slimbvh::{Ray, RenderSettings, Scene};
use slimbvh_core::encode::MOST_SHARED_BYTES;

/// Sums over rays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Tally {
    pub rays: u64,
    /// Opened inner nodes.
    pub nodes: u64,
    /// Tested boxes: the opened nodes' children, and the root's own where rays are tested against it.
    pub boxes: u64,
    /// Tested triangles.
    pub triangles: u64,
    /// Bytes of the opened nodes, and of those that leaves were decoded from.
    pub node_bytes: u64,
    /// Bytes of the tested triangles.
    pub triangle_bytes: u64,
}

/// The sums over the rays of a picture, by kind.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Counts {
    pub eye: Tally,
    pub shadow: Tally,
    /// Rays from mirrors and glass.
    pub secondary: Tally,
    /// The first hit of each sample.
    #[serde(skip)]
    pub seen: Vec<Seen>,
}

impl Tally {
    fn plus(self, other: Self) -> Self {
        Self {
            rays: self.rays + other.rays,
            nodes: self.nodes + other.nodes,
            boxes: self.boxes + other.boxes,
            triangles: self.triangles + other.triangles,
            node_bytes: self.node_bytes + other.node_bytes,
            triangle_bytes: self.triangle_bytes + other.triangle_bytes,
        }
    }

    /// Box tests per ray.
    pub fn box_tests(&self) -> f64 {
        self.mean(self.boxes)
    }

    /// Triangle tests per ray.
    pub fn triangle_tests(&self) -> f64 {
        self.mean(self.triangles)
    }

    /// Bytes of nodes and triangles per ray.
    pub fn bytes_read(&self) -> f64 {
        self.mean(self.node_bytes + self.triangle_bytes)
    }

    pub fn mean(&self, sum: u64) -> f64 {
        sum as f64 / self.rays.max(1) as f64
    }
}

impl Counts {
    /// All rays.
    pub fn all(&self) -> Tally {
        self.eye.plus(self.shadow).plus(self.secondary)
    }

    fn of(&mut self, kind: Kind) -> &mut Tally {
        match kind {
            Kind::Eye => &mut self.eye,
            Kind::Shadow(_) => &mut self.shadow,
            Kind::Secondary => &mut self.secondary,
        }
    }

    /// Checks that the tested triangles take 16 to [`MOST_SHARED_BYTES`] each: rays test all of a leaf.
    fn check(&self) -> Result<()> {
        let Tally {
            triangles,
            triangle_bytes,
            ..
        } = self.all();
        let range = 16 * triangles..=u64::from(MOST_SHARED_BYTES) * triangles;
        ensure!(
            range.contains(&triangle_bytes),
            "{triangles} triangles cannot take {triangle_bytes} bytes"
        );
        Ok(())
    }

    fn plus(mut self, mut other: Self) -> Self {
        self.seen.append(&mut other.seen);
        Self {
            eye: self.eye.plus(other.eye),
            shadow: self.shadow.plus(other.shadow),
            secondary: self.secondary.plus(other.secondary),
            seen: self.seen,
        }
    }
}

/// Samples per task.
const BLOCK: u32 = 512;

/// Follows all paths of a picture through its trees, and counts what they touch.
pub fn count(scene: &Scene, walks: &Walks, settings: &RenderSettings) -> Result<Counts> {
    let paths = Paths::new(scene, walks.exponent(), settings)?;
    let [width, height] = settings.size;
    let sample_count = width * height * settings.sample_count;
    let blocks = (0..sample_count.div_ceil(BLOCK)).into_par_iter();
    let blocks = blocks.map(|block| {
        let mut counts = Counts::default();
        let first = block * BLOCK;
        for sample in first..(first + BLOCK).min(sample_count) {
            let meet = |kind, ray: &Ray, skip| {
                let (tally, hit) = walks.of(kind).meet(kind, ray, skip);
                let sum = counts.of(kind);
                *sum = sum.plus(tally);
                hit
            };
            let seen = paths.follow(sample, meet);
            counts.seen.push(seen);
        }
        counts
    });
    let blocks: Vec<Counts> = blocks.collect();
    let counts = blocks.into_iter().fold(Counts::default(), Counts::plus);
    counts.check()?;
    Ok(counts)
}
