//! What only a real GPU can answer, section by section; `gpu-lab.sh` runs the sections of several builds in turn within a budget.
//! Each result is a row on standard output as soon as it is measured. Exit codes: 0 done, 1 an answer differs from the CPU's,
//! 2 usage or input.

mod builds;
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
use std::process::ExitCode;

fn main() -> ExitCode {
    match run() {
        Ok(0) => ExitCode::SUCCESS,
        Ok(wrong) => {
            eprintln!("WRONG: {wrong} answers are not the CPU's");
            ExitCode::from(1)
        }
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
    }
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
