//! Counts the instructions of a child process with Valgrind.

use anyhow::{Context, Result, bail, ensure};
use std::io::ErrorKind;
use std::process::Command;

/// A child process' count and output.
pub struct Counted {
    /// All instructions that it executed.
    pub instructions: u64,
    /// Its standard output.
    pub said: String,
}

/// Checks that Valgrind is installed.
pub fn check() -> Result<()> {
    match Command::new("valgrind").arg("--version").output() {
        Ok(_) => Ok(()),
        Err(error) if error.kind() == ErrorKind::NotFound => {
            bail!("instructions are counted by valgrind, which is not installed")
        }
        Err(error) => Err(error).context("cannot start valgrind"),
    }
}

/// Runs this program as a child process with these arguments and counts its instructions. Errors name it `what`.
pub fn instructions(arguments: &[String], what: &str) -> Result<Counted> {
    let program = std::env::current_exe().context("cannot find this program")?;
    let output = Command::new("valgrind")
        .args(["--tool=cachegrind", "--cache-sim=no"])
        .arg("--cachegrind-out-file=/dev/null")
        .arg(program)
        .args(arguments)
        // One thread: reading files would else start a thread for each core.
        .env("RAYON_NUM_THREADS", "1")
        .output()
        .context("cannot start valgrind")?;
    let log = String::from_utf8_lossy(&output.stderr);
    ensure!(output.status.success(), "{what} failed:\n{log}");
    let count = total(&log).with_context(|| format!("valgrind counted nothing:\n{log}"))?;
    Ok(Counted {
        instructions: count,
        said: String::from_utf8_lossy(&output.stdout).trim().to_owned(),
    })
}

/// Parses the number in the line `==1== I   refs:      434,917,997`.
fn total(log: &str) -> Option<u64> {
    let mut lines = log.lines();
    let line = lines.find(|line| line.split_whitespace().skip(1).take(2).eq(["I", "refs:"]))?;
    let number = line.split_whitespace().last()?;
    number.replace(',', "").parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_total_is_found() {
        let log =
            "==7== Cachegrind\n==7== Command: I refs: 5\n==7== \n==7== I   refs:      1,234,567\n";
        assert_eq!(total(log), Some(1_234_567));
        assert_eq!(total("==7== I refs:  8"), Some(8));
        assert_eq!(total("==7== D refs:  8"), None);
    }
}
