//! Runs the binary in a temporary folder and reads everything that it leaves there.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs::File;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// Time limit of a run. A software adapter compiles its kernels first.
const PATIENCE: Duration = Duration::from_secs(120);

/// A temporary folder that the binary runs in.
pub struct Folder(TempDir);

/// The exit code and the output of a run.
#[derive(Debug)]
pub struct Outcome {
    /// None if a signal ended the run.
    pub code: Option<i32>,
    pub stdout: String,
    pub stderr: String,
}

impl Folder {
    pub fn new() -> Self {
        Self(tempfile::tempdir().expect("the system has a place for temporary files"))
    }

    pub fn path(&self) -> &Path {
        self.0.path()
    }

    pub fn write(&self, name: impl AsRef<Path>, bytes: impl AsRef<[u8]>) {
        std::fs::write(self.path().join(name), bytes).expect("the folder is ours");
    }

    pub fn read(&self, name: impl AsRef<Path>) -> Vec<u8> {
        let path = self.path().join(name);
        std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    }

    /// All files and folders below this one, by path, with the bytes of the files.
    pub fn contents(&self) -> BTreeMap<String, Vec<u8>> {
        let mut contents = BTreeMap::new();
        let mut folders = vec![self.path().to_owned()];
        while let Some(folder) = folders.pop() {
            for entry in std::fs::read_dir(folder).expect("the folder is ours") {
                let path = entry.expect("the folder is ours").path();
                let name = format!("{:?}", path.strip_prefix(self.path()).unwrap_or(&path));
                if path.is_dir() {
                    contents.insert(name, Vec::new());
                    folders.push(path);
                } else {
                    contents.insert(name, self.read(&path));
                }
            }
        }
        contents
    }

    /// Runs the binary in this folder and waits for its end.
    pub fn run<S: AsRef<OsStr>>(&self, arguments: impl IntoIterator<Item = S>) -> Outcome {
        self.run_command(command(), arguments)
    }

    /// Runs the binary with this machine's GPU drivers and without a limit on its memory.
    #[cfg(feature = "gpu")]
    pub fn run_with_gpu<S: AsRef<OsStr>>(&self, arguments: impl IntoIterator<Item = S>) -> Outcome {
        let mut command = Command::new(crate::BINARY);
        // Mesa's device selection layer prints complaints on machines without a desktop.
        command.env("NODEVICE_SELECT", "1");
        self.run_command(command, arguments)
    }

    fn run_command<S: AsRef<OsStr>>(
        &self,
        mut command: Command,
        arguments: impl IntoIterator<Item = S>,
    ) -> Outcome {
        // Redirect into files: a full pipe would block the binary. The files lie outside this folder, which is compared.
        let said = tempfile::tempdir().expect("the system has a place for temporary files");
        let (out, err) = (said.path().join("out"), said.path().join("err"));
        let file = |path| File::create(path).expect("the folder is ours");
        command.args(arguments).current_dir(self.path());
        command.stdin(Stdio::null());
        command.stdout(file(&out)).stderr(file(&err));
        let mut child = command.spawn().expect("the binary was built");

        let begin = Instant::now();
        let status = loop {
            if let Some(status) = child.try_wait().expect("the child is ours") {
                break status;
            }
            if begin.elapsed() > PATIENCE {
                let _ = child.kill();
                let _ = child.wait();
                panic!("{command:?} is not done after {PATIENCE:?}");
            }
            std::thread::sleep(Duration::from_millis(1));
        };
        let text = |path| {
            let bytes = std::fs::read(path).expect("the folder is ours");
            String::from_utf8(bytes).expect("the binary writes UTF-8")
        };
        Outcome {
            code: status.code(),
            stdout: text(out),
            stderr: text(err),
        }
    }

    /// Runs the binary with these bytes as standard input. Returns its exit code, standard output and standard error.
    pub fn pipe(&self, input: &[u8], arguments: &[&str]) -> (Option<i32>, Vec<u8>, String) {
        let said = tempfile::tempdir().expect("the system has a place for temporary files");
        let path = said.path().join("in");
        std::fs::write(&path, input).expect("the folder is ours");
        let mut command = command();
        command.args(arguments).current_dir(self.path());
        command.stdin(File::open(&path).expect("the folder is ours"));
        let output = command.output().expect("the binary was built");
        let stderr = String::from_utf8(output.stderr).expect("the binary writes UTF-8");
        (output.status.code(), output.stdout, stderr)
    }

    /// Runs the binary, which must succeed and print nothing to standard error. Returns its standard output.
    pub fn succeed<S: AsRef<OsStr>>(&self, arguments: impl IntoIterator<Item = S>) -> String {
        let outcome = self.run(arguments);
        assert_eq!((outcome.code, outcome.stderr.as_str()), (Some(0), ""));
        outcome.stdout
    }
}

/// The binary. On Linux its address space is limited to 8 GiB: larger allocations fail without exhausting the machine.
pub fn command() -> Command {
    let binary = crate::BINARY;
    let mut command;
    if cfg!(target_os = "linux") {
        command = Command::new("sh");
        command.args(["-c", "ulimit -v 8388608; exec \"$@\"", "sh", binary]);
    } else {
        command = Command::new(binary);
    }
    // Every thread takes address space, and some machines have hundreds.
    command.env("RAYON_NUM_THREADS", "2");
    // Hide GPUs, for equal results on every machine and because their drivers need far more address space.
    command.env("VK_DRIVER_FILES", "none");
    // Hide scene files, for equal results on every machine.
    command.env_remove("SLIMBVH_SCENES");
    command
}
