//! Runs children until all rays of a case are answered or given up, and says what has become of them.

use crate::child::{AT_ONCE, Line, Task};
use anyhow::{Context, Result};
use slimbvh::Hit;
use slimbvh_lab::stress::Answer;
use std::io::{BufRead, BufReader, Read};
use std::process::{Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

/// After so many processes that have died of a ray, the rays that are left are given up.
const MOST_DEATHS: usize = 50;

/// What a peer says about a case.
#[derive(Default)]
pub struct Answered {
    /// One a ray, of which the last may lack.
    pub answers: Vec<Answer>,
    /// To build and to trace.
    pub time_ms: f64,
    /// What went wrong: in a word, and in a sentence. What is not answered counts as a miss.
    pub failure: Option<(String, String)>,
    /// Rays that it does not take.
    pub refused: usize,
    /// Rays that it panics with, and a message.
    panicked: (usize, String),
    /// Rays that a process has died of, and how.
    died: (usize, String),
}

/// Why a child has ended.
enum End {
    /// It was to.
    Done,
    /// The limit is passed.
    Hung,
    /// By itself, with this status and these last words.
    Died(String),
}

/// Asks a peer about all rays of a case, in processes that are ended at the limit.
pub fn contained(mut task: Task<'_>, ray_count: usize, limit: Duration) -> Result<Answered> {
    let mut answered = Answered::default();
    loop {
        let mut is_built = false;
        let end = child(&task, limit, |line| answered.take(line, &mut is_built))?;
        let count = answered.answers.len();
        match end {
            End::Done => break,
            End::Hung => {
                let reason = format!("no answer to ray {count} in {} s", limit.as_secs());
                answered.failure = Some(("hung".into(), reason));
                break;
            }
            End::Died(how) if !is_built => {
                let reason = format!("while it builds: {how}");
                answered.failure = Some(("died".into(), reason));
                break;
            }
            // It is one of the rays that were asked about at once.
            End::Died(_) if count >= task.careful_until => {
                task.first = count;
                task.careful_until = count + AT_ONCE;
            }
            End::Died(how) => {
                answered.died = (answered.died.0 + 1, how);
                if answered.died.0 == MOST_DEATHS {
                    break;
                }
                answered.answers.push(MISS);
                task.first = count + 1;
            }
        }
    }
    answered.sum_up(ray_count);
    Ok(answered)
}

/// Nothing is hit, or nothing is answered.
pub const MISS: Answer = Answer {
    closest: Hit::MISS,
    any: false,
};

impl Answered {
    fn take(&mut self, line: Line, is_built: &mut bool) {
        let answer = match line {
            Line::Built => {
                *is_built = true;
                return;
            }
            Line::Failed { word, reason } => {
                self.failure = Some((word, reason));
                return;
            }
            Line::Done(time_ms) => {
                self.time_ms = time_ms;
                return;
            }
            Line::Answer(_, u32::MAX, any) => Answer {
                closest: Hit::MISS,
                any,
            },
            Line::Answer(t, primitive, any) => Answer {
                closest: Hit {
                    t: f32::from_bits(t),
                    primitive,
                    ..Hit::MISS
                },
                any,
            },
            Line::Panicked(message) => {
                self.panicked = (self.panicked.0 + 1, message);
                MISS
            }
            Line::Refused => {
                self.refused += 1;
                MISS
            }
        };
        self.answers.push(answer);
    }

    /// Of what went wrong with single rays the gravest.
    fn sum_up(&mut self, ray_count: usize) {
        if self.failure.is_some() {
            return;
        }
        let (died, how) = &self.died;
        let (panicked, message) = &self.panicked;
        let failure = match (*died, *panicked) {
            (0, 0) => return,
            (0, count) => (
                "panicked",
                format!("with {count} of {ray_count} rays: {message}"),
            ),
            (MOST_DEATHS, _) => (
                "died",
                format!("with {died} of {ray_count} rays, then given up: {how}"),
            ),
            (died, _) => ("died", format!("with {died} of {ray_count} rays: {how}")),
        };
        self.failure = Some((failure.0.into(), failure.1));
    }
}

/// Runs a child and takes its lines.
fn child(task: &Task<'_>, limit: Duration, mut take: impl FnMut(Line)) -> Result<End> {
    let mut child = Command::new(std::env::current_exe()?)
        .args(task.arguments())
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .context("cannot start a process for a peer")?;
    let lines = lines(child.stdout.take());
    let errors = lines_of(child.stderr.take());
    let end = Instant::now() + limit;
    loop {
        let left = end.saturating_duration_since(Instant::now());
        match lines.recv_timeout(left) {
            Ok(line) => {
                let is_last = matches!(line, Line::Done(_) | Line::Failed { .. });
                take(line);
                if is_last {
                    // What it does after counts no more; tearing down may fail, too.
                    child.kill()?;
                    child.wait()?;
                    return Ok(End::Done);
                }
            }
            Err(RecvTimeoutError::Timeout) => {
                child.kill()?;
                child.wait()?;
                return Ok(End::Hung);
            }
            Err(RecvTimeoutError::Disconnected) => {
                let status = child.wait()?;
                let last = errors.iter().last();
                let last = last.unwrap_or_else(|| "no message".into());
                return Ok(End::Died(format!("{status}: {last}")));
            }
        }
    }
}

/// The lines of a child, as they come.
fn lines(pipe: Option<impl Read + Send + 'static>) -> Receiver<Line> {
    let (sender, receiver) = channel();
    let lines = lines_of(pipe);
    thread::spawn(move || {
        // A line that was cut short ends it. No one listens any more where the limit has passed.
        let mut lines = lines.iter().map(|line| serde_json::from_str(&line));
        while let Some(Ok(line)) = lines.next() {
            if sender.send(line).is_err() {
                break;
            }
        }
    });
    receiver
}

/// The lines that come out of a pipe, but for empty ones.
fn lines_of(pipe: Option<impl Read + Send + 'static>) -> Receiver<String> {
    let (sender, receiver) = channel();
    thread::spawn(move || {
        let lines = pipe.map(|pipe| BufReader::new(pipe).lines());
        let lines = lines.into_iter().flatten().map_while(Result::ok);
        for line in lines.filter(|line| !line.trim().is_empty()) {
            if sender.send(line).is_err() {
                break;
            }
        }
    });
    receiver
}
