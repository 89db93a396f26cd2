//! `shader-stats` against the committed record, and against planted faults. Skipped without Mesa's RADV; `REQUIRE_RADV=1` makes
//! that a failure.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A kernel that keeps 300 words in private memory, which naga clears.
const WITH_PRIVATE_ARRAY: &str = "
    @group(0) @binding(0) var<storage, read_write> words: array<u32>;
    @compute @workgroup_size(64) fn planted(@builtin(global_invocation_id) id: vec3<u32>) {
        var kept: array<u32, 300>;
        for (var i = 0u; i < 300u; i++) { kept[words[i] % 300u] = i; }
        words[id.x] = kept[words[id.x] % 300u];
    }";

/// The same without.
const WITHOUT: &str = "
    @group(0) @binding(0) var<storage, read_write> words: array<u32>;
    @compute @workgroup_size(64) fn planted(@builtin(global_invocation_id) id: vec3<u32>) {
        var kept = 0u;
        for (var i = 0u; i < 300u; i++) { kept ^= words[i] % 300u; }
        words[id.x] = kept;
    }";

fn run(arguments: &[&Path], is_required: bool) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_shader-stats"));
    command.args(arguments).env_remove("REQUIRE_RADV");
    if is_required {
        command.env("REQUIRE_RADV", "1");
    }
    command.output().expect("the program starts")
}

fn said(output: &Output) -> String {
    let bytes = [&output.stdout[..], &output.stderr].concat();
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Whether RADV is installed.
fn is_there() -> bool {
    let text = said(&run(&[Path::new("--list"), Path::new("none.spv")], false));
    let is_there = !text.contains("SHADERS ARE NOT COMPILED");
    let is_required = std::env::var_os("REQUIRE_RADV").is_some_and(|value| value == "1");
    assert!(is_there || !is_required, "{text}");
    if !is_there {
        eprintln!("{text}");
    }
    is_there
}

/// A folder of its own for a test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).expect("a folder can be made");
    folder
}

/// Writes a kernel's SPIR-V as `planted.spv`.
fn plant(folder: &Path, wgsl: &str) -> PathBuf {
    use naga::valid::{Capabilities, ValidationFlags, Validator};
    let module = naga::front::wgsl::parse_str(wgsl).expect("it is WGSL");
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
    let info = validator.validate(&module).expect("it is valid");
    // As rust-gpu leaves it: unchecked.
    let options = naga::back::spv::Options {
        bounds_check_policies: naga::proc::BoundsCheckPolicies::default(),
        force_loop_bounding: false,
        ..naga::back::spv::Options::default()
    };
    let words = naga::back::spv::write_vec(&module, &info, &options, None).expect("SPIR-V");
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    let path = folder.join("planted.spv");
    std::fs::write(&path, bytes).expect("a file can be written");
    path
}

/// The counts of a module: instructions, registers, bytes of scratch memory a thread, bytes of workgroup memory.
fn counts(module: &Path) -> [u64; 4] {
    let output = run(&[Path::new("--list"), module], true);
    assert!(output.status.success(), "{}", said(&output));
    let text = said(&output);
    let line = text.lines().find(|line| line.starts_with("planted;"));
    let words = line.unwrap_or_else(|| panic!("{text}")).split(';').skip(1);
    let counts: Vec<u64> = words.map(|word| word.parse().expect("a count")).collect();
    counts.try_into().expect("four counts")
}

#[test]
fn committed_modules_are_as_on_record() {
    if !is_there() {
        return;
    }
    let output = run(
        &[],
        std::env::var_os("REQUIRE_RADV").is_some_and(|value| value == "1"),
    );
    let text = said(&output);
    print!("{text}");
    assert!(output.status.success(), "{text}");
}

#[test]
fn a_private_array_is_scratch_memory() {
    if !is_there() {
        return;
    }
    let folder = folder("private-array");
    let [.., scratch, workgroup] = counts(&plant(&folder, WITHOUT));
    assert_eq!([scratch, workgroup], [0, 0]);
    let [.., scratch, workgroup] = counts(&plant(&folder, WITH_PRIVATE_ARRAY));
    assert!((1200..1300).contains(&scratch), "{scratch} bytes a thread");
    assert_eq!(workgroup, 0);
}

#[test]
fn planted_faults_fail() {
    if !is_there() {
        return;
    }
    let folder = folder("faults");
    let record = folder.join("record.csv");
    let compare = |module: &Path, is_required| {
        let output = run(&[Path::new("--record"), &record, module], is_required);
        (output.status.code(), said(&output))
    };
    let module = plant(&folder, WITHOUT);
    let [instructions, vgprs, ..] = counts(&module);
    let output = run(
        &[
            Path::new("--write"),
            Path::new("--record"),
            &record,
            &module,
        ],
        true,
    );
    assert!(output.status.success(), "{}", said(&output));
    let text = std::fs::read_to_string(&record).expect("a record was written");
    assert_eq!(compare(&module, true).0, Some(0));

    // Over 1 % fewer instructions on record, fewer registers, or one instruction more.
    let row = |instructions: u64, vgprs: u64| format!("planted;{instructions};{vgprs};0;0");
    let edited = |to: String| {
        let from = row(instructions, vgprs);
        assert!(text.contains(&from), "{text}");
        std::fs::write(&record, text.replace(&from, &to)).expect("a file can be written");
    };
    for (to, verdict) in [
        (row(instructions - instructions / 50 - 2, vgprs), "WORSE"),
        (row(instructions, vgprs - 8), "WORSE"),
        (row(instructions + 1, vgprs), "out of date"),
    ] {
        edited(to);
        let (code, said) = compare(&module, true);
        assert!(
            code == Some(1) && said.contains(verdict),
            "{code:?}: {said}"
        );
    }

    // The array appears.
    edited(row(instructions, vgprs));
    let module = plant(&folder, WITH_PRIVATE_ARRAY);
    let (code, said) = compare(&module, true);
    assert!(
        code == Some(1) && said.contains("scratch_bytes 0 -> "),
        "{code:?}: {said}"
    );

    // A record of another driver compares nothing.
    std::fs::write(&record, text.replacen("# ", "# another ", 1)).expect("a file can be written");
    let (code, said) = compare(&module, false);
    assert!(
        code == Some(0) && said.contains("NOT COMPARED"),
        "{code:?}: {said}"
    );
    let (code, said) = compare(&module, true);
    assert!(
        code == Some(1) && said.contains("REQUIRE_RADV"),
        "{code:?}: {said}"
    );
}
