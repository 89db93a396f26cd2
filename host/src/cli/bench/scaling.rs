//! How costs grow.

use super::facts::Facts;
use super::machine::open;
use super::prepared::Prepared;
use super::protocol::Protocol;
use super::setup::Setup;
use super::times::Times;
use crate::cli::backend::Chosen;
use crate::cli::measure::rounds::Rounds;
use crate::cli::output;
use anyhow::Result;
use serde::Serialize;
use slimbvh::{Light, RenderSettings, Scene, generate};

/// Costs while one thing grows and all else stays.
#[derive(Clone, Debug, Serialize)]
pub struct Series {
    pub backend: &'static str,
    /// What grows.
    pub of: &'static str,
    pub points: Vec<Point>,
    pub exponents: Vec<Exponent>,
}

/// Costs at one amount. Times are medians in milliseconds.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Point {
    pub amount: usize,
    pub build_ms: f64,
    pub primary_ms: f64,
    pub shadow_ms: f64,
    pub bytes_per_ray: f64,
    pub resident_bytes: usize,
}

/// A cost grows about as the amount to this power.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Exponent {
    pub cost: &'static str,
    pub exponent: f64,
}

/// A cost by name.
pub type Cost = (&'static str, fn(&Point) -> f64);

/// All that grow.
pub const COSTS: [Cost; 5] = [
    ("build", |point| point.build_ms),
    ("primary", |point| point.primary_ms),
    ("shadow", |point| point.shadow_ms),
    ("bytes a ray", |point| point.bytes_per_ray),
    ("bytes of the tree", |point| point.resident_bytes as f64),
];

/// Cells along a side of a terrain of about 1,000 triangles, four times as many, and so on to a million.
const CELLS: [u32; 6] = [23, 45, 90, 181, 362, 724];

/// Cells of the terrain where something else grows.
const USUAL_CELLS: u32 = 181;

/// Up to how many lights.
const MOST_LIGHTS: usize = 16;

/// Measures one whole tree over a terrain while triangles, rays, lights, and on cores threads grow.
pub fn measure(chosen: &Chosen, protocol: &Protocol, threads: usize) -> Result<Vec<Series>> {
    let _progress = output::spinner("measuring how costs grow".into());
    let point = |amount, scene: &Scene, size, threads| {
        let settings = RenderSettings {
            size,
            mirror_depth: 0,
            ..RenderSettings::default()
        };
        point(
            amount,
            (scene, settings),
            chosen,
            (protocol.rounds, threads),
        )
    };
    let size = protocol.size;
    let cells = CELLS.iter().take(protocol.terrains);
    let triangles = cells.map(|&cells| {
        let scene = terrain(cells, 1);
        point(scene.mesh.indices.len(), &scene, size, threads)
    });
    let triangles: Vec<Point> = triangles.collect::<Result<_>>()?;

    let usual = terrain(USUAL_CELLS, 1);
    let shares = [8, 4, 2, 1].map(|share| size.map(|side| side / share));
    let rays = shares.iter().map(|&size| {
        let count = (size[0] * size[1]) as usize;
        point(count, &usual, size, threads)
    });
    let rays: Vec<Point> = rays.collect::<Result<_>>()?;

    let counts = doubled(MOST_LIGHTS);
    let lights = counts.iter().map(|&count| {
        let scene = terrain(USUAL_CELLS, count);
        point(count, &scene, size, threads)
    });
    let lights: Vec<Point> = lights.collect::<Result<_>>()?;

    let mut all = vec![("triangles", triangles), ("rays", rays), ("lights", lights)];
    if matches!(chosen, Chosen::Cpu) && threads > 1 {
        let counts = doubled(threads);
        let own = counts
            .iter()
            .map(|&count| point(count, &usual, size, count));
        all.push(("threads", own.collect::<Result<_>>()?));
    }
    let backend = super::machine::name(chosen);
    let series = all.into_iter().map(|(of, points)| Series {
        backend,
        of,
        exponents: exponents(&points),
        points,
    });
    Ok(series.collect())
}

/// 1, 2, 4 and so on, and the last.
fn doubled(most: usize) -> Vec<usize> {
    let powers = (0..usize::BITS).map(|power| 1 << power);
    powers
        .take_while(|&count| count < most)
        .chain([most])
        .collect()
}

/// Open ground under this many lights that reach all of it.
fn terrain(cells: u32, light_count: usize) -> Scene {
    let mut scene = Scene {
        mesh: generate::terrain(10.0, cells, 1),
        ..Scene::default()
    };
    // On a spiral, so that no two are at one place.
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

fn point(
    amount: usize,
    (scene, settings): (&Scene, RenderSettings),
    chosen: &Chosen,
    (round_count, threads): (u32, usize),
) -> Result<Point> {
    let prepared = Prepared::new(Setup::plain(threads), scene, settings);
    let mut machine = open(chosen, &prepared)?;
    let mut rounds: Rounds<Times> = Rounds::default();
    for round in 0..=round_count {
        let times = machine.frame()?;
        if round > 0 {
            rounds.0.push(times);
        }
    }
    drop(machine);
    let facts = Facts::new(&prepared)?;
    Ok(Point {
        amount,
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
        let exponent = slope(pairs)?;
        Some(Exponent { cost, exponent })
    });
    fitted.into_iter().flatten().collect()
}

/// The slope of the line that fits the logarithms of pairs above 0 best, by least squares; none for fewer than two amounts.
fn slope(pairs: impl Iterator<Item = [f64; 2]>) -> Option<f64> {
    let above = pairs.filter(|[x, y]| *x > 0.0 && *y > 0.0);
    let logs: Vec<[f64; 2]> = above.map(|pair| pair.map(f64::ln)).collect();
    let count = logs.len() as f64;
    let mean = [0, 1].map(|i: usize| logs.iter().map(|pair| pair[i]).sum::<f64>() / count);
    let products = |i: usize| {
        let terms = logs
            .iter()
            .map(|pair| (pair[0] - mean[0]) * (pair[i] - mean[i]));
        terms.sum::<f64>()
    };
    let [square, product] = [products(0), products(1)];
    (square > 0.0).then(|| product / square)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_are_exponents() {
        let power = |exponent: f64| [1.0, 2.0, 8.0, 64.0].map(|x: f64| [x, 3.0 * x.powf(exponent)]);
        for exponent in [-0.5, 0.0, 1.0, 1.75] {
            let found = slope(power(exponent).into_iter()).unwrap();
            assert!((found - exponent).abs() < 1e-12, "{found}");
        }
        // By hand: (0, 0), (1, 1), (2, 3) in logarithms has 3/2.
        let [e, e2] = [1.0f64, 2.0].map(f64::exp);
        let found = slope([[1.0, 1.0], [e, e], [e2, 3f64.exp()]].into_iter()).unwrap();
        assert!((found - 1.5).abs() < 1e-12);
        assert_eq!(slope([[2.0, 1.0]].into_iter()), None);
        assert_eq!(
            slope([[2.0, 1.0], [2.0, 3.0], [0.0, 1.0]].into_iter()),
            None
        );
    }

    #[test]
    fn amounts_are_doubled_up_to_the_last() {
        assert_eq!(doubled(1), [1]);
        assert_eq!(doubled(6), [1, 2, 4, 6]);
        assert_eq!(doubled(8), [1, 2, 4, 8]);
    }

    #[test]
    fn more_triangles_are_more_bytes() {
        let protocol = Protocol {
            size: [64, 40],
            rounds: 1,
            terrains: 2,
            ..Protocol::QUICK
        };
        let all = measure(&Chosen::Cpu, &protocol, 2).unwrap();
        let names: Vec<&str> = all.iter().map(|series| series.of).collect();
        assert_eq!(names, ["triangles", "rays", "lights", "threads"]);
        let [triangles, rays, ..] = &all[..] else {
            unreachable!("there are four");
        };
        let bytes = triangles.exponents[4];
        assert!((bytes.exponent - 1.0).abs() < 0.1, "{bytes:?}");
        let amounts: Vec<usize> = rays.points.iter().map(|point| point.amount).collect();
        assert_eq!(amounts, [8 * 5, 16 * 10, 32 * 20, 64 * 40]);
        for series in &all {
            assert!(series.points.iter().all(|point| point.primary_ms > 0.0));
        }
    }
}
