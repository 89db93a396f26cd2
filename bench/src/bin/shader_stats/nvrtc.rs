//! NVIDIA's NVRTC, where it is installed: `nvrtc.py` calls it.

use super::cpp;
use super::translate::Kernel;
use anyhow::{Context, Result, ensure};
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

/// Whether the environment names the folder of NVRTC and nvdisasm.
pub fn is_there() -> bool {
    std::env::var_os("NVRTC_HOME").is_some()
}

/// Compiles a module. Returns the number of registers, and the disassembly.
pub fn assembly(file: &Path) -> Result<(String, String)> {
    let text = cpp::translate(&Kernel::read(file)?)?;
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("nvrtc.py");
    let mut process = Command::new("python3")
        .arg(script)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .context("cannot start python3")?;
    let mut input = process.stdin.take().context("the script reads its input")?;
    let written = input.write_all(text.as_bytes());
    drop(input);
    let output = process.wait_with_output()?;
    let log = String::from_utf8_lossy(&output.stderr);
    ensure!(output.status.success(), "NVRTC failed for {file:?}:\n{log}");
    written?;
    let text = String::from_utf8(output.stdout)?;
    let (registers, assembly) = text
        .split_once('\n')
        .context("the script printed nothing")?;
    Ok((registers.to_owned(), assembly.to_owned()))
}
