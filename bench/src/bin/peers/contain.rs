//! Runs a child, and says what has become of it.

use crate::child::{Told, arguments};
use crate::peers::Fate;
use anyhow::{Context, Result};
use slimbvh::Hit;
use slimbvh::stress::{Answer, Effort};
use std::io::Read;
use std::process::{Command, Stdio};
use std::sync::mpsc::channel;
use std::thread;
use std::time::Duration;

/// What a peer says about a case.
pub struct Answered {
    /// One a ray, or none at all.
    pub answers: Vec<Answer>,
    /// To build and to trace.
    pub time_ms: f64,
    pub fate: Fate,
}

impl Answered {
    fn failed(word: &'static str, sentence: impl Into<String>) -> Self {
        Self {
            answers: Vec::new(),
            time_ms: 0.0,
            fate: Fate::Failed(word, sentence.into()),
        }
    }
}

/// Asks a peer about a case in a process of its own, which is ended at the limit.
pub fn contained(peer: &str, case: usize, effort: Effort, limit: Duration) -> Result<Answered> {
    let mut child = Command::new(std::env::current_exe()?)
        .args(arguments(peer, case, effort))
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .context("cannot start a process for a peer")?;
    let told = reader(child.stdout.take());
    let errors = reader(child.stderr.take());
    let Ok(told) = told.recv_timeout(limit) else {
        child.kill()?;
        child.wait()?;
        let seconds = limit.as_secs();
        return Ok(Answered::failed(
            "hung",
            format!("no answer in {seconds} s"),
        ));
    };
    let status = child.wait()?;
    let Ok(told) = serde_json::from_str::<Told>(&told) else {
        let errors = errors.recv().unwrap_or_default();
        let last = errors.lines().rfind(|line| !line.trim().is_empty());
        let sentence = format!("{status}: {}", last.unwrap_or("no message"));
        return Ok(Answered::failed("died", sentence));
    };
    Ok(answered(told))
}

/// Everything that comes out of a pipe, once it is closed.
fn reader(pipe: Option<impl Read + Send + 'static>) -> std::sync::mpsc::Receiver<String> {
    let (sender, receiver) = channel();
    thread::spawn(move || {
        let mut bytes = Vec::new();
        if let Some(mut pipe) = pipe {
            // What was read before an error is kept.
            let _ = pipe.read_to_end(&mut bytes);
        }
        // No one listens any more where the limit has passed.
        let _ = sender.send(String::from_utf8_lossy(&bytes).into_owned());
    });
    receiver
}

fn answered(told: Told) -> Answered {
    if let Some(reason) = told.refused {
        return Answered::failed("refused", reason);
    }
    let answer = |(t, primitive, any): (u32, u32, bool)| Answer {
        closest: match primitive {
            u32::MAX => Hit::MISS,
            _ => Hit {
                t: f32::from_bits(t),
                primitive,
                ..Hit::MISS
            },
        },
        any,
    };
    Answered {
        answers: told.answers.into_iter().map(answer).collect(),
        time_ms: told.time_ms,
        fate: match told.panicked {
            Some(message) => Fate::Failed("panicked", message),
            None => Fate::Answered,
        },
    }
}
