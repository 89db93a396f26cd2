//! A pool of one thread means one thread, for the peer too. A binary of its own: it counts the process' threads.
#![cfg(target_os = "linux")]

use slimbvh::generate::icosphere;
use slimbvh_bench::tracers::tracers;
use slimbvh_bench::{Input, Reference, pool};

/// Threads that this process has now.
fn thread_count() -> usize {
    std::fs::read_dir("/proc/self/task").unwrap().count()
}

/// Processor time of a thread so far, in clock ticks.
fn ticks(task: &str) -> u64 {
    let stat = std::fs::read_to_string(format!("/proc/self/task/{task}/stat")).unwrap();
    // User and system time are the 12th and 13th field after the name, which ends with the last parenthesis.
    let fields: Vec<&str> = stat
        .rsplit(')')
        .next()
        .unwrap()
        .split_whitespace()
        .collect();
    fields[11..13]
        .iter()
        .map(|x| x.parse::<u64>().unwrap())
        .sum()
}

#[test]
fn no_other_thread_works_in_a_pool_of_one() {
    // Large enough for every parallel path of obvhs, the one from 500 000 triangles on included.
    let mesh = icosphere(glam::Vec3::ZERO, 1.0, 8);
    let input = Input::new(&mesh);
    let reference = Reference::new(&mesh).unwrap();
    let tasks = || -> Vec<String> {
        let entries = std::fs::read_dir("/proc/self/task").unwrap();
        entries
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect()
    };
    let one = pool(1).unwrap();
    let worker = one.install(|| {
        let link = std::fs::read_link("/proc/thread-self").unwrap();
        link.file_name().unwrap().to_string_lossy().into_owned()
    });
    for mut tracer in tracers(&input) {
        let (threads_before, tasks_before) = (thread_count(), tasks());
        let before: Vec<u64> = tasks_before.iter().map(|task| ticks(task)).collect();
        one.install(|| {
            tracer.build().unwrap();
            reference.check(&*tracer).unwrap();
        });
        assert_eq!(thread_count(), threads_before, "{}", tracer.name());
        for (task, before) in tasks_before.iter().zip(before) {
            let spent = ticks(task) - before;
            if *task == worker {
                assert!(spent > 0);
            } else {
                assert!(spent <= 1, "{}: task {task} worked too", tracer.name());
            }
        }
    }
}
