//! The paper on compressed trees, measured on a GPU.

use crate::adapter::adapter;
use crate::process::Folder;
use serde_json::Value;

/// Times come from the GPU, counts equal those of a report by the CPU, and methods that only the CPU has are not there.
#[test]
fn compressed_trees_are_timed_on_a_gpu_and_counted_as_on_the_cpu() {
    let Some(adapter) = adapter() else { return };
    let folder = Folder::new();
    let common = ["reproduce", "compressed", "--quick", "--only=shiny"];
    let run = |name: &str, backend: &[&str]| {
        let outputs = [
            "--out",
            &format!("{name}.md"),
            "--json",
            &format!("{name}.json"),
        ];
        let outcome = folder.run_with_gpu([&common[..], backend, &outputs].concat());
        assert_eq!((outcome.code, outcome.stderr.as_str()), (Some(0), ""));
        let json = folder.read(format!("{name}.json"));
        let report: Value = serde_json::from_slice(&json).expect("it is JSON");
        (outcome.stdout, report)
    };
    let (text, gpu) = run("gpu", &["--backend=gpu", "--adapter", adapter]);
    let (_, cpu) = run("cpu", &["--backend=cpu"]);
    let is_software = slimbvh::gpu::adapters()[0].is_software;
    for (part, is_there) in [
        (adapter, true),
        ("Times by stage, ms", true),
        ("By the GPU's own clock", true),
        ("Bytes of the GPU's buffers, at most", true),
        ("q10", false),
        ("Bits per plane", false),
        ("encoding / construction", true),
        ("NaN", false),
        ("left out", false),
        ("a software adapter: the times say nothing", is_software),
        ("what encoding adds to construction", false),
        // These are not judged on a software adapter, and not for the smallest scene.
        ("rendering / plain", false),
    ] {
        assert_eq!(text.contains(part), is_there, "{part}: {text}");
    }
    assert_eq!(gpu["backend"], "gpu");
    let machine = gpu["machine"].as_str().expect("it is a name");
    assert!(machine.starts_with(adapter), "{machine}");

    let methods = |report: &Value| report["scenes"][0]["methods"].as_array().unwrap().clone();
    let number = |value: &Value| value.as_f64().expect("it is a number");
    let named = |method: &Value| method["name"].as_str().expect("it is a name").to_owned();
    let on_both = methods(&cpu).into_iter();
    let on_both = on_both.filter(|method| !named(method).starts_with('q'));
    let on_both: Vec<Value> = on_both.collect();
    assert_eq!(methods(&gpu).len(), on_both.len());
    for (own, cpu) in methods(&gpu).iter().zip(on_both) {
        let name = named(own);
        for counted in [
            "name",
            "node_bytes",
            "triangle_bytes",
            "counts",
            "differences",
            "moved",
        ] {
            assert_eq!(own[counted], cpu[counted], "{name}");
        }
        assert!(cpu["on_gpu"].is_null());
        let rounds = own["rounds"].as_array().expect("it is a list");
        assert!(!rounds.is_empty(), "{name}");
        for round in rounds {
            let frame = &round["own"];
            let parts = ["construction", "encoding", "rendering"].map(|part| number(&frame[part]));
            let stages = frame["stages"].as_object().expect("it is an object");
            let sum: f64 = stages.values().map(number).sum();
            assert!(
                (sum - parts.iter().sum::<f64>()).abs() < 1e-6 * sum,
                "{frame}"
            );
            assert!(stages.contains_key("trace primary") && stages.contains_key("sort"));
            assert_eq!(parts[1] > 0.0, name != "plain");
        }
        let likeness = &own["on_gpu"]["likeness"];
        assert!(number(&likeness["rays"]) >= 2000.0);
        assert!(number(&likeness["pixels_unlike"]) <= number(&likeness["pixels"]) / 1000.0);
        let buffers = &own["on_gpu"]["buffers"];
        let taken = number(&own["node_bytes"]) + number(&own["triangle_bytes"]);
        assert!(number(&buffers["tree"]) >= taken && number(&buffers["builder"]) > 0.0);
    }

    // The file has the same tables, and all their rows are as long as their heads.
    let file = String::from_utf8(folder.read("gpu.md")).expect("it is text");
    let (_, table) = file
        .split_once("## Bytes of the GPU's buffers")
        .expect("it is there");
    let rows = table.lines().skip_while(|line| !line.starts_with('|'));
    let rows = rows.take_while(|line| line.starts_with('|'));
    let lengths: Vec<usize> = rows.map(|row| row.matches('|').count()).collect();
    assert_eq!(lengths, [11; 13]);
}
