//! `gpu-lab.sh`: its options, its budget, and its table. Skipped without a GPU where it measures; `REQUIRE_GPU=1` makes that a
//! failure.

use anyhow::{Context, Result};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn script(arguments: &[&str]) -> Result<Output> {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("gpu-lab.sh");
    let run = Command::new("bash").arg(script).args(arguments).output();
    run.context("bash starts")
}

fn said(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// A folder of steps with these names, which all hold the same program.
fn steps(test: &str, names: &[&str]) -> Result<PathBuf> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    if folder.exists() {
        std::fs::remove_dir_all(&folder)?;
    }
    for name in names {
        let step = folder.join(name);
        std::fs::create_dir_all(&step)?;
        std::fs::copy(env!("CARGO_BIN_EXE_gpu-lab"), step.join("gpu-lab"))?;
        std::fs::write(step.join("commit"), format!("{name}-1234"))?;
    }
    Ok(folder)
}

/// Whether there is an adapter.
fn is_there() -> Result<bool> {
    let program = env!("CARGO_BIN_EXE_gpu-lab");
    let is_there = Command::new(program)
        .arg("adapter")
        .output()?
        .status
        .success();
    let is_required = std::env::var_os("REQUIRE_GPU").is_some_and(|value| value != "0");
    assert!(
        is_there || !is_required,
        "there is no GPU, and REQUIRE_GPU is set"
    );
    if !is_there {
        eprintln!("SKIPPED: there is no GPU, not even in software");
    }
    Ok(is_there)
}

#[test]
fn bad_options_get_a_sentence_and_exit_code_2() -> Result<()> {
    let empty = steps("no-steps", &[])?;
    let empty = empty.to_string_lossy();
    for (arguments, part) in [
        (&["--fast"][..], "there is no option '--fast'"),
        (&["colors"], "there is no section 'colors'"),
        (&["--seconds"], "--seconds needs a value"),
        (
            &["--seconds", "1.5"],
            "--seconds needs a whole number, not '1.5'",
        ),
        (
            &["--seed", "many"],
            "--seed needs a whole number, not 'many'",
        ),
        (&["--build", "a/b"], "a step's name has letters"),
        (&["--steps", &empty], "there is no step in"),
    ] {
        let output = script(arguments)?;
        let text = said(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {text}");
        assert!(text.contains(part), "{arguments:?}: {text}");
        assert_eq!(text.lines().count(), 1, "{text}");
    }
    Ok(())
}

#[test]
fn gpu_sections_of_steps_stand_side_by_side() -> Result<()> {
    if !is_there()? {
        return Ok(());
    }
    let folder = steps("two-steps", &["base", "next"])?;
    let folder = folder.to_string_lossy();
    let output = script(&["--steps", &folder, "--quick", "builds", "--out", &folder])?;
    let (text, log) = (said(&output.stdout), said(&output.stderr));
    assert_eq!(output.status.code(), Some(0), "{log}");
    for part in [
        "| section | scene | what | unit | base | next | next/base |",
        "| builds | terrain 10,082 | 30 bits | ms |",
        "| step base | base-1234 |",
        "| seed | 7 |",
    ] {
        assert!(text.contains(part), "{part} is not in\n{text}\n{log}");
    }
    assert!(!text.contains("Not reached"), "{text}");
    // In turn, and back.
    let turns = log.lines().filter_map(|line| line.split_once(','));
    let turns: Vec<&str> = turns.map(|(turn, _)| turn).collect();
    let turns: Vec<&&str> = turns.iter().filter(|it| it.starts_with("builds")).collect();
    let expected = ["base", "next", "next", "base"].map(|step| format!("builds of {step}"));
    assert_eq!(turns, expected.iter().collect::<Vec<_>>());
    let records = std::fs::read_dir(&*folder)?.filter_map(Result::ok);
    let mut names = records.map(|entry| entry.file_name().to_string_lossy().into_owned());
    let record = names.find(|name| name.starts_with("gpu-lab-"));
    let record = record.context("a record was written")?;
    assert_eq!(
        std::fs::read_to_string(Path::new(&*folder).join(record))?,
        text
    );
    Ok(())
}

#[test]
fn gpu_sections_beyond_the_budget_are_named() -> Result<()> {
    if !is_there()? {
        return Ok(());
    }
    let folder = steps("no-time", &["one"])?;
    let folder = folder.to_string_lossy();
    let output = script(&["--steps", &folder, "--quick", "--seconds", "0"])?;
    let text = said(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output.stderr));
    for section in [
        "parity", "rays", "stages", "builds", "peers", "large", "stress",
    ] {
        let part = format!("- {section} of one");
        assert!(text.contains(&part), "{part} is not in\n{text}");
    }

    // Within a section, too.
    let program = env!("CARGO_BIN_EXE_gpu-lab");
    let output = Command::new(program)
        .args(["builds", "--quick", "--seconds", "0"])
        .output()?;
    let text = said(&output.stdout);
    assert!(text.contains("missed;builds: terrain 10,082"), "{text}");
    assert!(!text.contains("row;"), "{text}");
    Ok(())
}

/// A step whose program prints half a row and never ends, and one whose answers are wrong.
#[test]
fn gpu_steps_that_hang_or_are_wrong_are_named() -> Result<()> {
    if !is_there()? {
        return Ok(());
    }
    let folder = steps("faults", &["a-sound"])?;
    for (name, fault) in [
        (
            "c-hangs",
            "echo 'fact;seed;7'; printf 'row;builds;hills'; exec sleep 60",
        ),
        (
            "b-wrong",
            "echo 'row;builds;hills;plain;wrong answers;3'; exit 1",
        ),
    ] {
        let program = folder.join(name).join("gpu-lab");
        std::fs::create_dir_all(folder.join(name))?;
        std::fs::write(&program, format!("#!/bin/sh\n{fault}\n"))?;
        let status = Command::new("chmod").arg("+x").arg(&program).status()?;
        assert!(status.success());
    }
    let folder = folder.to_string_lossy();
    let output = script(&["--steps", &folder, "--quick", "--seconds", "6", "builds"])?;
    let text = said(&output.stdout);
    assert_eq!(output.status.code(), Some(1), "{}", said(&output.stderr));
    assert!(
        text.contains("- the rest of builds of c-hangs: it ran for"),
        "{text}"
    );
    assert!(
        text.contains("| builds | terrain 10,082 | 30 bits | ms |"),
        "{text}"
    );
    Ok(())
}
