//! Section `peers`: slimbvh beside walks over obvhs' trees, all in one submission on the same rays into the same answers.

use crate::rayset::{RaySet, STORED, picture, ray_sets};
use crate::scenes::{Subject, cached, thousands};
use crate::session::Session;
use crate::traces::build;
use anyhow::{Context, Result};
use slimbvh::gpu::{Bvh, Mesh as GpuMesh};
use slimbvh_bench::gpu_peers::{GpuPeer, PEER_SHARE, PeerTree, Stopwatch, Walk};
use slimbvh_bench::tracers::{Question, triangles};
use slimbvh_bench::{Agreement, Answer};
use slimbvh_core::Hit;
use slimbvh_lab::measure::rounds::median;
use std::iter;

/// Measures all scenes that fit a cache.
pub fn run(session: &mut Session) -> Result<()> {
    for subject in cached(session.is_quick, session.seed)? {
        if session.has(4.0, &subject.name)? {
            measure(session, &subject)?;
        }
    }
    Ok(())
}

/// Measures one scene.
pub fn measure(session: &mut Session, subject: &Subject) -> Result<()> {
    let (gpu, name) = (&session.gpu, &subject.name);
    let uploaded = GpuMesh::upload(gpu, &subject.mesh)?;
    let bvh = build(session, &uploaded, STORED[0].1)?;
    let size = picture(session.is_quick);
    let sets = ray_sets(gpu, &subject.mesh, &bvh, size, session.seed)?;
    let list = triangles(&subject.mesh);
    let (peers, reasons) = present(|walk| {
        let tree = PeerTree::build(walk, &list).with_context(|| walk.to_string())?;
        GpuPeer::new(gpu, &tree)
    });
    for reason in reasons {
        session.missed(&format!("{name}: {reason}"))?;
    }
    if peers.is_empty() {
        return Ok(());
    }
    let Some(watch) = Stopwatch::new(gpu.device(), peers.len() as u32) else {
        return session.missed(&format!("{} has no timestamps", gpu.name()));
    };
    let mut tracers = vec!["slimbvh".to_owned()];
    tracers.extend(peers.iter().map(|peer| peer.walk().to_string()));
    for peer in &peers {
        let (mut other, mut all) = (0, 0);
        for set in &sets {
            other += disagreements(session, set, &bvh, peer)?;
            all += set.list.len();
        }
        let what = format!("{}, {} rays of all kinds", peer.walk(), thousands(all));
        let percent = 100.0 * other as f64 / all as f64;
        session.row(name, &what, "% other answers", percent)?;
    }
    for set in &sets {
        session.raise_clock(|| set.time(gpu, &bvh).map(drop))?;
        let mut rounds = vec![Vec::new(); tracers.len()];
        for round in 0..=session.rounds() {
            let seconds = together(session, set, &bvh, &peers, &watch, round)?;
            for (times, seconds) in rounds.iter_mut().zip(seconds) {
                if round > 0 {
                    times.push(seconds);
                }
            }
        }
        let kind = set.name;
        for (tracer, times) in tracers.iter().zip(&rounds) {
            let rate = set.rate(median(&mut times.clone()));
            session.row(name, &format!("{tracer}, {kind}"), "Mrays/s", rate)?;
        }
        let (slim, others) = (&rounds[0], &rounds[1..]);
        for (peer, times) in peers.iter().zip(others) {
            let what = format!("slimbvh, {kind}");
            let unit = format!("× {}", peer.walk());
            session.row(name, &what, &unit, ratio(slim, times))?;
        }
        if let ("eye", [plain, wide]) = (kind, others) {
            let share = ratio(wide, plain);
            let verdict = if share >= PEER_SHARE {
                "counts"
            } else {
                "does not count"
            };
            let software = if session.is_software {
                " (a software adapter: an indication only)"
            } else {
                ""
            };
            session.note(format!(
                "{name}: on coherent rays cwbvh has {share:.2} of the rate of aila-laine and {verdict} as a peer, from {PEER_SHARE} on{software}"
            ))?;
        }
    }
    Ok(())
}

/// The rate of the first to that of the second, as the median over rounds.
fn ratio(first: &[f64], second: &[f64]) -> f64 {
    let pairs = first.iter().zip(second);
    median(&mut pairs.map(|(a, b)| b / a).collect::<Vec<_>>())
}

/// Those of both peers that can be made, and why others cannot.
fn present<T>(make: impl Fn(Walk) -> Result<T>) -> (Vec<T>, Vec<String>) {
    let (mut peers, mut reasons) = (Vec::new(), Vec::new());
    for walk in Walk::ALL {
        match make(walk) {
            Ok(peer) => peers.push(peer),
            Err(error) => reasons.push(format!("{error:#}")),
        }
    }
    (peers, reasons)
}

/// Seconds of slimbvh and of each peer in one submission. Who begins changes from round to round.
fn together(
    session: &Session,
    set: &RaySet,
    bvh: &Bvh,
    peers: &[GpuPeer],
    watch: &Stopwatch,
    round: usize,
) -> Result<Vec<f64>> {
    let gpu = &session.gpu;
    let mut frame = gpu.frame();
    let tracer_count = 1 + peers.len();
    for turn in 0..tracer_count {
        match (turn + round) % tracer_count {
            0 => set.trace(&mut frame, bvh)?,
            number => {
                let pass = watch.pass(number as u32 - 1);
                let (rays, answers) = (&set.rays, &set.answers);
                peers[number - 1].trace(&mut frame, set.question, rays, answers, Some(pass));
            }
        }
    }
    watch.resolve(frame.encoder());
    let slim = frame.submit()?.wait()?.total();
    let times = watch.read(gpu.device(), gpu.queue())?;
    let all = iter::once(slim).chain(times);
    Ok(all.map(|time| time.as_secs_f64()).collect())
}

/// The number of a peer's answers that are others than slimbvh's, with the leeway of [`Agreement`].
fn disagreements(session: &Session, set: &RaySet, bvh: &Bvh, peer: &GpuPeer) -> Result<usize> {
    let gpu = &session.gpu;
    let expected = set.ask(gpu, bvh)?;
    let mut frame = gpu.frame();
    peer.trace(&mut frame, set.question, &set.rays, &set.answers, None);
    let answers = frame.read_later(set.answers.slice(..))?;
    frame.submit()?.wait()?;
    let answers: Vec<u32> = answers.read(gpu)?;
    let agreement = match set.question {
        Question::Closest => {
            let [expected, answers] = [&expected, &answers].map(|words| closest(words));
            Agreement::of_closest(&expected, &answers)
        }
        Question::Any => {
            let [expected, answers] = [&expected, &answers]
                .map(|words| words.iter().map(|&w| w == 1).collect::<Vec<_>>());
            Agreement::of_any(&expected, &answers)
        }
    };
    Ok(agreement.disagreements())
}

fn closest(words: &[u32]) -> Vec<Answer> {
    let hits: Vec<Hit> = bytemuck::allocation::pod_collect_to_vec(words);
    hits.iter().map(Answer::from).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use anyhow::ensure;

    #[test]
    fn a_peer_that_is_refused_leaves_the_other() {
        for refused in Walk::ALL {
            let (peers, reasons) = present(|walk| {
                ensure!(walk != refused, "{walk}: its stack is too deep");
                Ok(walk)
            });
            assert_eq!(peers.len(), 1);
            assert_ne!(peers[0], refused);
            assert_eq!(reasons, [format!("{refused}: its stack is too deep")]);
        }
    }
}
