//! Section `parity`: the GPU's answers are those of the CPU.

use crate::judgement::Judgement;
use crate::rayset::{STORED, config, picture, ray_sets};
use crate::scenes::{cached, thousands};
use crate::session::Session;
use crate::traces::build;
use anyhow::Result;
use slimbvh::Builder;
use slimbvh::gpu::Mesh as GpuMesh;
use slimbvh_bench::tracers::Question;

/// Compares all scenes that fit a cache, all kinds of rays and all codecs.
pub fn run(session: &mut Session) -> Result<()> {
    for subject in cached(session.is_quick, session.seed)? {
        let name = &subject.name;
        if !session.has(3.0, name)? {
            continue;
        }
        let uploaded = GpuMesh::upload(&session.gpu, &subject.mesh)?;
        let plain = build(session, &uploaded, STORED[0].1)?;
        let size = picture(session.is_quick);
        let sets = ray_sets(&session.gpu, &subject.mesh, &plain, size, session.seed)?;
        for (codec, nodes) in STORED {
            let on_gpu = build(session, &uploaded, nodes)?;
            let on_cpu = Builder::new(config(nodes)).build(&subject.mesh)?;
            let (mut judgement, mut all) = (Judgement::default(), 0);
            for set in &sets {
                let expected: Vec<u32> = match set.question {
                    Question::Closest => {
                        let mut hits = Vec::new();
                        on_cpu.closest_hits(&set.list, &mut hits);
                        bytemuck::allocation::pod_collect_to_vec(&hits)
                    }
                    Question::Any => {
                        let mut found = Vec::new();
                        on_cpu.any_hits(&set.list, &mut found);
                        found.into_iter().map(u32::from).collect()
                    }
                };
                let answers = set.ask(&session.gpu, &on_gpu)?;
                judgement += session.judge(set, &expected, &answers);
                all += set.list.len();
            }
            let what = format!("{codec}, {} rays of all kinds", thousands(all));
            session.judged(name, &what, judgement)?;
        }
    }
    Ok(())
}
