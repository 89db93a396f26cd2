//! Section `rays`: rates of eye, shadow and bounce rays through plain and coded trees, which take turns.

use crate::judgement::Judgement;
use crate::rayset::{RaySet, STORED, config, picture, ray_sets};
use crate::scenes::{Subject, cached};
use crate::session::Session;
use anyhow::Result;
use slimbvh::NodeCodec;
use slimbvh::gpu::{Builder, Bvh, Mesh as GpuMesh};
use slimbvh_lab::measure::rounds::median;

/// Measures all scenes that fit a cache.
pub fn run(session: &mut Session) -> Result<()> {
    for subject in cached(session.is_quick, session.seed)? {
        if session.has(1.0, &subject.name)? {
            let uploaded = GpuMesh::upload(&session.gpu, &subject.mesh)?;
            measure(session, &subject, &uploaded, &STORED)?;
        }
    }
    Ok(())
}

/// Builds a mesh's tree.
pub fn build(session: &Session, uploaded: &GpuMesh, nodes: NodeCodec) -> Result<Bvh> {
    let (mut builder, mut bvh) = (Builder::new(config(nodes)), Bvh::new());
    let mut frame = session.gpu.frame();
    builder.build(&mut frame, uploaded, &mut bvh)?;
    frame.submit()?.wait()?;
    Ok(bvh)
}

/// Measures one scene through trees that are stored so. The first is plain: the others' answers are compared with its.
pub fn measure(
    session: &mut Session,
    subject: &Subject,
    uploaded: &GpuMesh,
    stored: &[(&str, NodeCodec)],
) -> Result<()> {
    let name = &subject.name;
    let mut trees = Vec::new();
    for &(codec, nodes) in stored {
        trees.push((codec, build(session, uploaded, nodes)?));
    }
    let Some((_, plain)) = trees.first() else {
        return Ok(());
    };
    let size = picture(session.is_quick);
    let sets = ray_sets(&session.gpu, &subject.mesh, plain, size, session.seed)?;
    let judgement = differences(session, &sets, &trees)?;
    session.judged(name, "coded against plain, all kinds", judgement)?;
    session.raise_clock(|| sets[0].time(&session.gpu, plain).map(drop))?;

    // Seconds of each tree and kind, by round; the first round is not counted.
    let mut times = vec![vec![Vec::new(); sets.len()]; trees.len()];
    for round in 0..=session.rounds() {
        for ((_, bvh), times) in trees.iter().zip(&mut times) {
            for (set, times) in sets.iter().zip(times) {
                let time = set.time(&session.gpu, bvh)?.as_secs_f64();
                if round > 0 {
                    times.push(time);
                }
            }
        }
    }
    for ((codec, _), times) in trees.iter().zip(&mut times) {
        for (set, times) in sets.iter().zip(times) {
            let what = format!("{codec}, {}", set.name);
            session.row(name, &what, "Mrays/s", set.rate(median(times)))?;
        }
    }
    Ok(())
}

/// Judges the answers of all other trees by the first tree's.
fn differences(session: &Session, sets: &[RaySet], trees: &[(&str, Bvh)]) -> Result<Judgement> {
    let mut judgement = Judgement::default();
    for set in sets {
        let expected = set.ask(&session.gpu, &trees[0].1)?;
        for (_, bvh) in &trees[1..] {
            judgement += session.judge(set, &expected, &set.ask(&session.gpu, bvh)?);
        }
    }
    Ok(judgement)
}
