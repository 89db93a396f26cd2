//! Runs the binary in a folder of its own and looks at all that it leaves behind.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs::File;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// No run may take longer. A GPU that is none compiles its kernels first.
const PATIENCE: Duration = Duration::from_secs(120);

/// A folder that the binary runs in.
pub struct Folder(TempDir);

/// What a run said and how it ended.
#[derive(Debug)]
pub struct Outcome {
    /// None where a signal ended it.
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

    /// All files below, by path, with their bytes. Folders have none.
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

    /// Runs the binary in this folder to its end.
    pub fn run<S: AsRef<OsStr>>(&self, arguments: impl IntoIterator<Item = S>) -> Outcome {
        self.run_command(command(), arguments)
    }

    /// Runs it with what drivers of GPUs there are, and all the memory that they want.
    #[cfg(feature = "gpu")]
    pub fn run_with_gpu<S: AsRef<OsStr>>(&self, arguments: impl IntoIterator<Item = S>) -> Outcome {
        let mut command = Command::new(crate::BINARY);
        // Mesa's layer that sorts devices complains where there is no desktop.
        command.env("NODEVICE_SELECT", "1");
        self.run_command(command, arguments)
    }

    fn run_command<S: AsRef<OsStr>>(
        &self,
        mut command: Command,
        arguments: impl IntoIterator<Item = S>,
    ) -> Outcome {
        // Into files: pipes could fill up while nobody reads them. Not into this folder, whose contents are compared.
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

    /// Runs the binary, which must succeed without a complaint. Returns its standard output.
    pub fn succeed<S: AsRef<OsStr>>(&self, arguments: impl IntoIterator<Item = S>) -> String {
        let outcome = self.run(arguments);
        assert_eq!((outcome.code, outcome.stderr.as_str()), (Some(0), ""));
        outcome.stdout
    }
}

/// The binary, on Linux with 8 GiB of address space: so a demand for more fails here and not on the whole machine.
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
    // The same on machines with a GPU, whose drivers want far more address space.
    command.env("VK_DRIVER_FILES", "none");
    // The same on machines with scene files.
    command.env_remove("SLIMBVH_SCENES");
    command
}
