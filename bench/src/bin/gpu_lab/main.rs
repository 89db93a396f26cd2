//! What only a real GPU can answer, section by section; `gpu-lab.sh` runs the sections of several builds in turn within a budget.
//! Each result is a row on standard output as soon as it is measured. Exit codes: 0 done, 1 an answer is wrong,
//! 2 usage or input.

mod builds;
mod judgement;
mod large;
mod options;
mod parity;
mod peers;
mod rayset;
mod row;
mod scenes;
mod sections;
mod session;
mod stages;
mod table;
mod traces;

use anyhow::Result;
use options::{Options, Task};
use session::Session;
use slimbvh_bench::exit;
use std::process::ExitCode;

fn main() -> ExitCode {
    exit::code(run().map(exit::wrong_answers))
}

/// Returns the number of wrong answers.
fn run() -> Result<u64> {
    let options = Options::parse(std::env::args().skip(1))?;
    match &options.task {
        Task::Help => println!("{}", options::USAGE),
        Task::Table(task) => task.run()?,
        Task::Adapter => println!("{}", Session::open(&options)?.gpu.name()),
        Task::Section(section) => {
            let mut session = Session::open(&options)?;
            session.introduce(*section)?;
            section.run(&mut session)?;
            return Ok(session.wrong_answers);
        }
    }
    Ok(0)
}
