//! Compares the instructions of builds and rays, counted by Valgrind, with the record: a guard against unnoticed slowdowns.
//! Times vary on a busy machine; counts differ by less than a thousandth from run to run.
//!
//! `UPDATE_GOLDEN=1` rewrites the record. It needs a build that is not incremental (`CARGO_INCREMENTAL=0`), as counts of an
//! incremental build differ by up to 6 %. Without Valgrind, or on another kind of processor, the test is skipped;
//! `REQUIRE_VALGRIND=1` makes that a failure.

mod frames;

use slimbvh::generate::{TorusKnot, terrain, torus_knot};
use slimbvh::{
    BuildConfig, Builder, Bvh, CodeBits, Hit, Mesh, MeshCodec, NodeCodec, Ray, TreeKind, WideStore,
};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A counted job.
struct Job {
    name: &'static str,
    /// Runs this number of rounds.
    run: fn(usize),
}

const JOBS: [Job; 12] = [
    Job {
        name: "build, 30-bit codes",
        run: |rounds| build(rounds, CodeBits::Bits30.into()),
    },
    Job {
        name: "build, 63-bit codes",
        run: |rounds| build(rounds, CodeBits::Bits63.into()),
    },
    Job {
        name: "build, clustered",
        run: |rounds| build(rounds, clustered()),
    },
    Job {
        name: "build, w4-48, triangles on the lattice",
        run: |rounds| build(rounds, on_lattice()),
    },
    Job {
        name: "closest hits",
        run: |rounds| trace(rounds, BuildConfig::default(), closest),
    },
    Job {
        name: "any hits",
        run: |rounds| trace(rounds, BuildConfig::default(), any),
    },
    Job {
        name: "closest hits, w4-48, triangles on the lattice",
        run: |rounds| trace(rounds, on_lattice(), closest),
    },
    Job {
        name: "closest hits together",
        run: |rounds| trace(rounds, BuildConfig::default(), closest_together),
    },
    Job {
        name: "closest hits together, w4",
        run: |rounds| trace(rounds, wide(), closest_together),
    },
    Job {
        name: "closest hits together, w4-48, triangles on the lattice",
        run: |rounds| trace(rounds, on_lattice(), closest_together),
    },
    Job {
        name: "frame with two sets, by hand",
        run: frames::by_hand,
    },
    Job {
        name: "frame with two sets, by view sets",
        run: frames::by_view_sets,
    },
];

/// The allowed difference from the record, as a share, upward and downward; below it the record is out of date.
const SLACK: f64 = 0.05;

/// The allowed difference with another compiler than the record's.
const SLACK_OF_ANOTHER_COMPILER: f64 = 0.25;

/// The environment variable with the job and the number of rounds for [`the_process_that_is_counted`].
const COUNTED: &str = "SLIMBVH_COUNTED_JOB";

fn closest(bvh: &Bvh, rays: &[Ray]) -> usize {
    let hits = rays.iter().map(|ray| bvh.closest_hit(ray));
    hits.filter(Hit::is_hit).count()
}

fn any(bvh: &Bvh, rays: &[Ray]) -> usize {
    rays.iter().filter(|ray| bvh.any_hit(ray)).count()
}

fn closest_together(bvh: &Bvh, rays: &[Ray]) -> usize {
    let mut hits = [Hit::MISS; 10_000];
    bvh.closest_hits_of_block(rays, &mut hits);
    hits.iter().filter(|hit| hit.is_hit()).count()
}

fn clustered() -> BuildConfig {
    BuildConfig {
        tree: TreeKind::Clustered,
        ..BuildConfig::default()
    }
}

fn wide() -> BuildConfig {
    BuildConfig {
        nodes: NodeCodec::Wide(WideStore::Full),
        ..BuildConfig::default()
    }
}

fn on_lattice() -> BuildConfig {
    BuildConfig {
        nodes: NodeCodec::Wide(WideStore::Packed),
        mesh: MeshCodec::Lattice { step_exponent: -12 },
        ..BuildConfig::default()
    }
}

/// Some ten thousand triangles, with coordinates on the lattice above.
fn knot() -> Mesh {
    snapped(torus_knot(&TorusKnot {
        segments: 512,
        sides: 12,
        ..TorusKnot::default()
    }))
}

fn snapped(mut mesh: Mesh) -> Mesh {
    for x in mesh.vertices.as_flattened_mut() {
        *x = (*x * 4096.0).round() / 4096.0;
    }
    mesh
}

fn build(rounds: usize, config: BuildConfig) {
    let mesh = knot();
    let mut builder = Builder::new(config);
    let mut bvh = Bvh::default();
    for _ in 0..=rounds {
        builder
            .build_into(&mesh, &mut bvh)
            .expect("the mesh is sound");
    }
}

/// In each round, counts the hits of the same neighbouring rays.
fn trace(rounds: usize, config: BuildConfig, count_hits: impl Fn(&Bvh, &[Ray]) -> usize) {
    let mesh = snapped(terrain(8.0, 64, 7));
    let bvh = Builder::new(config)
        .build(&mesh)
        .expect("the mesh is sound");
    let ray = |i: u16| {
        let (x, z) = (
            f32::from(i % 100) * 0.06 - 3.0,
            f32::from(i / 100) * 0.06 - 3.0,
        );
        Ray::new([0.5, 6.0, 11.0], [x - 0.5, -6.0, z - 11.0])
    };
    let rays: Vec<Ray> = (0..10_000).map(ray).collect();
    let hit_count: usize = (0..rounds).map(|_| count_hits(&bvh, &rays)).sum();
    assert!(rounds == 0 || hit_count > 5_000 * rounds, "{hit_count}");
}

#[test]
#[ignore = "it is run under Valgrind by another test"]
fn the_process_that_is_counted() {
    let asked = std::env::var(COUNTED).expect("another test says what to count");
    let (job, rounds) = asked.split_once(' ').expect("a job's number, and rounds");
    let (job, rounds): (usize, usize) = (
        job.parse().expect("a number"),
        rounds.parse().expect("a number"),
    );
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .expect("a thread");
    pool.install(|| (JOBS[job].run)(rounds));
}

/// Instructions of one round, in thousands.
fn count(job: usize) -> u64 {
    let [some, more] = [1, 3].map(|rounds| {
        let output = Command::new("valgrind")
            .args([
                "--tool=cachegrind",
                "--cache-sim=no",
                "--cachegrind-out-file=/dev/null",
            ])
            .arg(std::env::current_exe().expect("this test has a path"))
            .args([
                "--exact",
                "instructions::the_process_that_is_counted",
                "--ignored",
            ])
            .args(["--test-threads", "1"])
            .env(COUNTED, format!("{job} {rounds}"))
            .env("RAYON_NUM_THREADS", "1")
            .output()
            .expect("Valgrind starts");
        let log = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{log}");
        total(&log).unwrap_or_else(|| panic!("nothing was counted:\n{log}"))
    });
    (more - some) / 2 / 1000
}

/// Parses the number in the line `==1== I   refs:      434,917,997`.
fn total(log: &str) -> Option<u64> {
    let mut lines = log.lines();
    let line = lines.find(|line| line.split_whitespace().skip(1).take(2).eq(["I", "refs:"]))?;
    line.split_whitespace()
        .last()?
        .replace(',', "")
        .parse()
        .ok()
}

/// The compiler's version.
fn compiler() -> String {
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".into());
    let output = Command::new(rustc).arg("--version").output();
    output.map_or_else(
        |_| "unknown".into(),
        |output| String::from_utf8_lossy(&output.stdout).trim().to_owned(),
    )
}

fn path() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../bench/record/instructions.csv")
}

fn is_to_be_counted() -> bool {
    let is_there = Command::new("valgrind").arg("--version").output().is_ok();
    let is_counted = is_there && cfg!(all(target_arch = "x86_64", target_os = "linux"));
    let is_required = std::env::var_os("REQUIRE_VALGRIND").is_some_and(|value| value == "1");
    assert!(
        is_counted || !is_required,
        "instructions cannot be counted here: install Valgrind"
    );
    if !is_counted {
        eprintln!(
            "INSTRUCTIONS WERE NOT COUNTED: there is no Valgrind here, or another kind of processor than the record's"
        );
    }
    is_counted
}

#[test]
fn no_more_instructions_than_on_record() {
    if !is_to_be_counted() {
        return;
    }
    let counts: Vec<u64> = (0..JOBS.len()).map(count).collect();
    if std::env::var_os("UPDATE_GOLDEN").is_some_and(|update| update == "1") {
        let mut text = format!("# {}\njob;instructions, thousands\n", compiler());
        for (Job { name, .. }, count) in JOBS.iter().zip(&counts) {
            writeln!(text, "{name};{count}").expect("a string takes all");
        }
        std::fs::write(path(), text).expect("the record can be written");
        return;
    }
    let text = std::fs::read_to_string(path()).expect("there is a record");
    let mut lines = text.lines();
    let of = lines
        .next()
        .and_then(|line| line.strip_prefix("# "))
        .expect("the compiler comes first");
    let slack = if of == compiler() {
        SLACK
    } else {
        SLACK_OF_ANOTHER_COMPILER
    };
    let recorded: Vec<(&str, f64)> = lines
        .skip(1)
        .filter_map(|line| line.split_once(';'))
        .map(|(name, count)| (name, count.parse().expect("a count")))
        .collect();
    let names: Vec<&str> = recorded.iter().map(|(name, _)| *name).collect();
    assert_eq!(
        names,
        JOBS.map(|job| job.name),
        "UPDATE_GOLDEN=1 writes the record anew"
    );
    let mut wrong = String::new();
    for ((name, recorded), count) in recorded.into_iter().zip(counts) {
        let ratio = count as f64 / recorded;
        println!("{name}: {count} thousand instructions, {ratio:.3} of the record");
        if (ratio - 1.0).abs() > slack {
            writeln!(
                wrong,
                "{name}: {count} thousand instructions, {ratio:.3} of the record"
            )
            .expect("a string takes all");
        }
    }
    assert!(
        wrong.is_empty(),
        "more than {slack} off; where that is meant, UPDATE_GOLDEN=1 writes the record anew:\n{wrong}"
    );
}

#[test]
fn the_total_is_found() {
    let log =
        "==7== Cachegrind\n==7== Command: I refs: 5\n==7== \n==7== I   refs:      1,234,567\n";
    assert_eq!(total(log), Some(1_234_567));
    assert_eq!(total("==7== D refs:  8"), None);
}
