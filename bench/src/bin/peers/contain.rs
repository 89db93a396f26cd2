//! Runs child processes until all rays of a case are answered or given up, and reports how they ended.

use crate::child::{AT_ONCE, Line, Task};
use anyhow::{Context, Result};
use slimbvh::Hit;
use slimbvh_lab::stress::Answer;
use std::io::{BufRead, BufReader, Read};
use std::process::{Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

/// After this number of processes that died of a ray, the remaining rays are given up.
const MOST_DEATHS: usize = 50;

/// A peer's answers to a case.
#[derive(Default)]
pub struct Answered {
    /// One answer a ray; the last ones may be missing.
    pub answers: Vec<Answer>,
    /// The time to build and to trace together, in milliseconds.
    pub time_ms: f64,
    /// The failure, as a word and as a sentence. A ray without an answer counts as a miss.
    pub failure: Option<(String, String)>,
    /// Rays that the peer does not accept.
    pub refused: usize,
    /// Rays on which the peer panics, and a message.
    panicked: (usize, String),
    /// Rays of which a process died, and how.
    died: (usize, String),
}

/// How a child process ended.
enum End {
    /// As expected, after its last line.
    Done,
    /// Ended at the time limit.
    Hung,
    /// By itself, with this status and this last line on standard error.
    Died(String),
}

/// Traces all rays of a case with a peer, in processes that are ended at the time limit.
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
            // One of the rays of the last call killed the process.
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

/// A miss, also used for a ray without an answer.
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

    /// The gravest failure among single rays.
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

/// Runs a child process and reads its lines.
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
                    // After the last line the exit status does not count: freeing a peer may fail, too.
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

/// Sends a child's lines as they arrive.
fn lines(pipe: Option<impl Read + Send + 'static>) -> Receiver<Line> {
    let (sender, receiver) = channel();
    let lines = lines_of(pipe);
    thread::spawn(move || {
        // A truncated line ends the output. After the time limit the receiver is gone.
        let mut lines = lines.iter().map(|line| serde_json::from_str(&line));
        while let Some(Ok(line)) = lines.next() {
            if sender.send(line).is_err() {
                break;
            }
        }
    });
    receiver
}

/// The lines of a pipe without empty ones.
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
