//! The growth of costs.

use super::facts::Facts;
use super::prepared::Prepared;
use super::protocol::Protocol;
use super::setup::Setup;
use super::times::Times;
use super::trial::Trial;
use crate::measure::exponent::{CELLS, exponent};
use crate::measure::rounds::Rounds;
use crate::measure::table::Table;
use anyhow::Result;
use serde::Serialize;
use slimbvh::{Backend, Cpu, Frames, Light, RenderSettings, Scene, generate};
use slimbvh_cli::backend::{Chosen, is_too_large};
use slimbvh_cli::output::{self, count};

/// The costs over one growing amount, while everything else stays.
#[derive(Clone, Debug, Serialize)]
pub struct Series {
    pub backend: &'static str,
    /// The growing amount.
    pub of: &'static str,
    pub points: Vec<Point>,
    pub exponents: Vec<Exponent>,
    /// Why larger amounts are missing, if the GPU cannot hold them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub left_out: Option<String>,
}

/// The costs at one amount. Times are medians in milliseconds.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Point {
    pub amount: usize,
    /// The number of pictures of which the times are medians.
    pub rounds: usize,
    pub build_ms: f64,
    pub primary_ms: f64,
    pub shadow_ms: f64,
    /// Counted over at most [`MOST_COUNTED_SAMPLES`] samples per pixel.
    pub bytes_per_ray: f64,
    pub resident_bytes: usize,
}

/// A cost grows approximately as the amount to this power.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Exponent {
    pub cost: &'static str,
    pub exponent: f64,
}

impl Exponent {
    /// The exponent in hundredths, without a sign for zero.
    pub fn text(&self) -> String {
        format!("{:.2}", (self.exponent * 100.0).round() / 100.0 + 0.0)
    }
}

impl Series {
    /// The series as a text table.
    pub fn table(&self) -> Table {
        let cells = |point: &Point| {
            vec![
                count(point.amount),
                format!("{:.2}", point.build_ms),
                format!("{:.2}", point.primary_ms),
                format!("{:.2}", point.shadow_ms),
                format!("{:.0}", point.bytes_per_ray),
                format!("{:.0}", point.resident_bytes as f64 / 1024.0),
                point.rounds.to_string(),
            ]
        };
        let powers = self.exponents.iter();
        let powers = powers.map(|it| format!("{} {}", it.cost, it.text()));
        let powers: Vec<String> = powers.collect();
        let mut notes = vec![format!("exponents of growth: {}", powers.join(", "))];
        notes.extend(self.left_out.clone());
        Table {
            title: format!("more {} on the {}", self.of, self.backend.to_uppercase()),
            notes,
            word_columns: 0,
            head: vec![
                self.of,
                "build ms",
                "primary ms",
                "shadow ms",
                "bytes/ray",
                "KiB",
                "pictures",
            ],
            rows: self.points.iter().map(cells).collect(),
        }
    }
}

/// The name and the value of a cost.
pub type Cost = (&'static str, fn(&Point) -> f64);

/// The costs whose growth is measured.
pub const COSTS: [Cost; 5] = [
    ("build", |point| point.build_ms),
    ("primary", |point| point.primary_ms),
    ("shadow", |point| point.shadow_ms),
    ("bytes a ray", |point| point.bytes_per_ray),
    ("bytes of the tree", |point| point.resident_bytes as f64),
];

/// Cells of the terrain if something other than triangles grows: about 100,000 triangles.
const USUAL_CELLS: u32 = 224;

/// Maximum number of samples per pixel whose bytes are counted.
pub const MOST_COUNTED_SAMPLES: u32 = 10;

/// If a picture takes longer than this, at most [`LONG_ROUNDS`] pictures are timed after the untimed one.
pub const LONG_MS: f64 = 2000.0;
pub const LONG_ROUNDS: u32 = 3;

/// Measures one whole tree over a terrain while triangles, rays, lights and, on the CPU, threads grow.
pub fn measure(chosen: &Chosen, protocol: &Protocol, threads: usize) -> Result<Vec<Series>> {
    let usual = terrain(USUAL_CELLS, 1);
    let large = settings(protocol.size, 1);
    let small = settings(protocol.small_size, 1);
    let at = |amount, scene: &Scene, settings, threads| {
        point(
            amount,
            (scene, settings),
            chosen,
            (protocol.rounds, threads),
        )
    };
    let backend = chosen.name();
    let cells = CELLS.iter().take(protocol.terrains);
    let triangles: Vec<usize> = cells
        .map(|&cells| 2 * (cells as usize) * (cells as usize))
        .collect();
    let of_triangles = series((backend, "triangles"), &triangles, |amount| {
        let cells = (amount / 2).isqrt() as u32;
        at(amount, &terrain(cells, 1), large, threads)
    })?;

    let pixels = (protocol.small_size[0] * protocol.small_size[1]) as usize;
    let samples = protocol.samples.iter();
    let rays: Vec<usize> = samples.map(|&samples| samples as usize * pixels).collect();
    let of_rays = series((backend, "rays"), &rays, |amount| {
        let samples = (amount / pixels) as u32;
        let settings = settings(protocol.small_size, samples);
        at(amount, &usual, settings, threads)
    })?;

    let of_lights = series((backend, "lights"), &doubled(protocol.lights), |count| {
        at(count, &terrain(USUAL_CELLS, count), small, threads)
    })?;

    let mut all = vec![of_triangles, of_rays, of_lights];
    if matches!(chosen, Chosen::Cpu) && threads > 1 {
        let counts = doubled(threads);
        all.push(series((backend, "threads"), &counts, |count| {
            at(count, &usual, large, count)
        })?);
    }
    Ok(all)
}

/// Measures at all amounts up to the first that is too large for the GPU.
fn series(
    (backend, of): (&'static str, &'static str),
    amounts: &[usize],
    point: impl Fn(usize) -> Result<Point>,
) -> Result<Series> {
    let _progress = output::spinner(format!("measuring how costs grow with {of}"));
    let (mut points, mut left_out) = (Vec::new(), None);
    for &amount in amounts {
        match point(amount) {
            Ok(point) => points.push(point),
            Err(error) if is_too_large(&error) => {
                left_out = Some(format!("{}: {}", count(amount), output::sentence(&error)));
                break;
            }
            Err(error) => return Err(error),
        }
    }
    Ok(Series {
        backend,
        of,
        exponents: exponents(&points),
        points,
        left_out,
    })
}

fn settings(size: [u32; 2], sample_count: u32) -> RenderSettings {
    RenderSettings {
        size,
        sample_count,
        mirror_depth: 0,
        ..RenderSettings::default()
    }
}

/// 1, 2, 4 and so on below `most`, then `most`.
fn doubled(most: usize) -> Vec<usize> {
    let powers = (0..usize::BITS).map(|power| 1 << power);
    powers
        .take_while(|&count| count < most)
        .chain([most])
        .collect()
}

/// A terrain under this many lights, each of which reaches all of it.
fn terrain(cells: u32, light_count: usize) -> Scene {
    let mut scene = Scene {
        mesh: generate::terrain(10.0, cells, 1),
        ..Scene::default()
    };
    // On a spiral, so that no two lights coincide.
    let light = |i: usize| {
        let turn = 2.4 * i as f32;
        let radius = 4.0 * ((i as f32 + 0.5) / light_count as f32).sqrt();
        Light::Point {
            position: [radius * turn.cos(), 8.0, radius * turn.sin()],
            color: [60.0 / light_count as f32; 3],
            range: f32::INFINITY,
        }
    };
    scene.lights = (0..light_count).map(light).collect();
    scene.complete(scene.mesh.bounds(), [16, 9]);
    scene
}

/// Times pictures after an untimed one, and fewer of them if one takes long.
fn rounds<B: Backend>(backend: B, prepared: &Prepared, most: u32) -> Result<Rounds<Times>>
where
    Frames<B>: Send,
{
    let mut trial = Trial::new(backend, prepared)?;
    let first = trial.frame()?;
    let round_count = match first.frame() > LONG_MS {
        true => most.min(LONG_ROUNDS),
        false => most,
    };
    let rounds = (0..round_count).map(|_| trial.frame());
    Ok(Rounds(rounds.collect::<Result<_>>()?))
}

fn point(
    amount: usize,
    (scene, settings): (&Scene, RenderSettings),
    chosen: &Chosen,
    (most_rounds, threads): (u32, usize),
) -> Result<Point> {
    let mut prepared = Prepared::new(Setup::plain(threads), scene, settings);
    let rounds = match chosen {
        Chosen::Cpu => rounds(Cpu, &prepared, most_rounds)?,
        #[cfg(feature = "gpu")]
        Chosen::Gpu(gpu) | Chosen::GpuIfItFits(gpu) => rounds(gpu, &prepared, most_rounds)?,
    };
    prepared.settings.sample_count = settings.sample_count.min(MOST_COUNTED_SAMPLES);
    let facts = Facts::new(&prepared)?;
    Ok(Point {
        amount,
        rounds: rounds.0.len(),
        build_ms: rounds.median(|times| times.build),
        primary_ms: rounds.median(|times| times.primary),
        shadow_ms: rounds.median(|times| times.shadow),
        bytes_per_ray: facts.counts.all().bytes_read(),
        resident_bytes: facts.resident_bytes(),
    })
}

fn exponents(points: &[Point]) -> Vec<Exponent> {
    let fitted = COSTS.map(|(cost, of)| {
        let pairs = points.iter().map(|point| [point.amount as f64, of(point)]);
        let exponent = exponent(pairs)?;
        Some(Exponent { cost, exponent })
    });
    fitted.into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_has_no_sign() {
        let text = |exponent| Exponent { cost: "", exponent }.text();
        assert_eq!(
            [-0.004, 0.004, -0.006, 1.234].map(text),
            ["0.00", "0.00", "-0.01", "1.23"]
        );
    }

    #[test]
    fn amounts_are_doubled_up_to_the_last() {
        assert_eq!(doubled(1), [1]);
        assert_eq!(doubled(6), [1, 2, 4, 6]);
        assert_eq!(doubled(8), [1, 2, 4, 8]);
    }

    #[test]
    fn triangles_go_from_a_thousand_to_ten_million() {
        assert_eq!(CELLS.len(), Protocol::FULL.terrains);
        for (i, cells) in CELLS.into_iter().enumerate() {
            let triangles = 2 * (cells as usize).pow(2);
            let expected = 10f64.powf(3.0 + 0.5 * i as f64);
            let ratio = triangles as f64 / expected;
            assert!((ratio - 1.0).abs() < 0.035, "{triangles}");
            assert_eq!((triangles / 2).isqrt(), cells as usize);
        }
    }

    #[test]
    fn rays_go_from_a_tenth_of_a_million_to_a_hundred() {
        let [width, height] = Protocol::FULL.small_size;
        let rays = |samples: &u32| f64::from(width * height * samples);
        let samples = Protocol::FULL.samples;
        assert!(samples.iter().map(rays).all(|rays| rays < 1.1e8));
        assert!(samples.first().map(rays).unwrap() < 1.1e5);
        assert!(samples.last().map(rays).unwrap() >= 1e8);
    }

    #[test]
    fn more_triangles_are_more_bytes() {
        let protocol = Protocol {
            size: [64, 40],
            small_size: [32, 20],
            samples: &[1, 2, 30],
            lights: 4,
            rounds: 1,
            terrains: 2,
            ..Protocol::QUICK
        };
        let all = measure(&Chosen::Cpu, &protocol, 2).unwrap();
        let names: Vec<&str> = all.iter().map(|series| series.of).collect();
        assert_eq!(names, ["triangles", "rays", "lights", "threads"]);
        let [triangles, rays, lights, threads] = &all[..] else {
            unreachable!("there are four");
        };
        let bytes = triangles.exponents[4];
        assert!((bytes.exponent - 1.0).abs() < 0.1, "{bytes:?}");
        let amounts = |series: &Series| -> Vec<usize> {
            series.points.iter().map(|point| point.amount).collect()
        };
        assert_eq!(amounts(triangles), [968, 3200]);
        assert_eq!(amounts(rays), [640, 1280, 19_200]);
        assert_eq!(amounts(lights), [1, 2, 4]);
        assert_eq!(amounts(threads), [1, 2]);
        for series in &all {
            assert!(series.points.iter().all(|point| point.primary_ms > 0.0));
            assert!(series.points.iter().all(|point| point.rounds == 1));
        }
        // Fewer samples give the same bytes per ray.
        let [_, few, many] = &rays.points[..] else {
            unreachable!("there are three");
        };
        assert!((many.bytes_per_ray / few.bytes_per_ray - 1.0).abs() < 0.05);
        let text = rays.table().text();
        assert!(text.starts_with("more rays on the CPU\n"), "{text}");
        assert!(text.contains("\n  19,200  "), "{text}");
    }

    #[test]
    fn a_fault_that_is_not_the_size_ends_it() {
        let fail = |_| anyhow::bail!("no");
        assert!(series(("cpu", "rays"), &[1, 2], fail).is_err());
    }

    /// A series keeps the amounts that fit the GPU, and says why it ends.
    #[cfg(feature = "gpu")]
    #[test]
    fn too_large_a_mesh_ends_a_series() {
        let point = |amount| {
            if amount > 2 {
                return Err(anyhow::Error::new(slimbvh::gpu::GpuError::TooLarge {
                    what: "nodes",
                    bytes: 9,
                    limit: "max_buffer_size",
                    limit_bytes: 8,
                    adapter: "small".into(),
                    advice: "none",
                }));
            }
            Ok(Point {
                amount,
                rounds: 1,
                build_ms: 1.0,
                primary_ms: 1.0,
                shadow_ms: 1.0,
                bytes_per_ray: 1.0,
                resident_bytes: 1,
            })
        };
        let series = series(("gpu", "triangles"), &[1, 2, 3000, 4000], point).unwrap();
        assert_eq!(series.points.len(), 2);
        let text = series.table().text();
        assert!(text.contains("3,000: nodes would take 9 bytes"), "{text}");
    }
}
