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
    let output = script(&[
        "--steps", &folder, "--quick", "--whole", "builds", "--out", &folder,
    ])?;
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

/// A folder of steps whose programs are scripts: each measures by a line of shell, and has the real program make tables.
fn scripted(test: &str, programs: &[(&str, &str)]) -> Result<PathBuf> {
    let folder = steps(test, &[])?;
    for (name, measure) in programs {
        let program = folder.join(name).join("gpu-lab");
        std::fs::create_dir_all(folder.join(name))?;
        let real = env!("CARGO_BIN_EXE_gpu-lab");
        let text = format!(
            "#!/bin/sh\ncase $1 in adapter) echo A; exit ;; table) exec '{real}' \"$@\" ;; esac\n{measure}\n"
        );
        std::fs::write(&program, text)?;
        let status = Command::new("chmod").arg("+x").arg(&program).status()?;
        assert!(status.success());
    }
    Ok(folder)
}

/// A sound step, one whose answers are wrong, and one that prints half a row and never ends. The last one uses up the budget.
#[test]
fn steps_that_hang_or_are_wrong_are_named() -> Result<()> {
    let sound = "echo 'row;parity;hills;plain;wrong answers;0'";
    let wrong = "echo 'row;parity;hills;plain;wrong answers;3'; exit 1";
    let hangs = "echo 'fact;seed;7'; printf 'row;parity;hills'; exec sleep 60";
    let folder = scripted(
        "faults",
        &[("a-sound", sound), ("b-wrong", wrong), ("c-hangs", hangs)],
    )?;
    let folder = folder.to_string_lossy();
    let output = script(&["--steps", &folder, "--quick", "--seconds", "6", "parity"])?;
    let (text, log) = (said(&output.stdout), said(&output.stderr));
    assert_eq!(output.status.code(), Some(1), "{log}");
    for part in [
        "- the rest of parity of c-hangs: it ran for",
        "| parity | hills | plain | wrong answers | 0 | 3 | – |",
    ] {
        assert!(text.contains(part), "{part} is not in\n{text}\n{log}");
    }
    Ok(())
}

/// Whether anything is not reached decides with `--whole`, and only then.
#[test]
fn whole_runs_reach_everything() -> Result<()> {
    let row = "echo 'row;parity;hills;plain;wrong answers;0'";
    let refused = format!("{row}; echo 'missed;peers: hills: cwbvh'");
    let hangs = format!("{row}; exec sleep 60");
    for (name, measure, seconds, code) in [
        ("whole", row, "60", 0),
        ("part-refused", &refused, "60", 1),
        ("part-late", &hangs, "4", 1),
        ("part-unbegun", row, "0", 1),
    ] {
        let folder = scripted(name, &[("one", measure)])?;
        let folder = folder.to_string_lossy();
        let arguments = [
            "--steps",
            &folder,
            "--quick",
            "--seconds",
            seconds,
            "parity",
        ];
        let output = script(&arguments)?;
        assert_eq!(output.status.code(), Some(0), "{name}");
        let output = script(&[&arguments[..], &["--whole"]].concat())?;
        let log = said(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{name}: {log}");
        assert_eq!(
            log.contains("not everything was reached"),
            code == 1,
            "{log}"
        );
    }
    Ok(())
}
