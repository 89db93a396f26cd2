//! Findings: sentences about the measurements.

mod words;

pub use words::{percent, share};

use super::measure::{SceneRecord, SetupRecord};
use super::setup::{Knob, Triangles};
use super::times::Times;
use crate::measure::step::Step;
use serde::Serialize;
use slimbvh::reduce::Reduce;
use slimbvh::{CodeBits, LatticeBits, NodeCodec, WideStore};
use words::{MIN_DIFFERENCE, Sentence, compared, in_words, is_clear, quotient, time, win_if};

/// The verdict of a sentence on slimbvh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// It gains something.
    Wins,
    /// It loses something, or gains nothing.
    Loses,
    /// An expected property holds.
    Holds,
    /// An expected property fails.
    Fails,
}

/// A sentence about one scene on one machine.
#[derive(Clone, Debug, Serialize)]
pub struct Finding {
    pub scene: String,
    pub backend: &'static str,
    pub verdict: Verdict,
    pub text: String,
}

/// All sentences about a scene.
pub fn findings(scene: &SceneRecord) -> Vec<Finding> {
    let sentences = sentences(scene).into_iter().map(|(verdict, text)| Finding {
        scene: scene.name.clone(),
        backend: scene.backend,
        verdict,
        text,
    });
    sentences.collect()
}

fn sentences(scene: &SceneRecord) -> Vec<Sentence> {
    let Some(usual) = scene.setups.first() else {
        return Vec::new();
    };
    let find = |is: &dyn Fn(&SetupRecord) -> bool| scene.setups.iter().find(|record| is(record));
    let mut sentences = Vec::new();
    for (codec, name) in [
        (NodeCodec::Lattice(LatticeBits::Q10), "nodes of 10 bits"),
        (
            NodeCodec::Wide(WideStore::Exact),
            "nodes of four children in 64 bytes",
        ),
    ] {
        let coded = find(&|record| record.knob == Knob::Nodes && record.setup.nodes == codec);
        let coded = coded.into_iter();
        sentences.extend(coded.flat_map(|record| nodes(name, record, usual, scene)));
    }
    sentences.extend(widths(scene, usual));
    let of_mesh =
        |mesh: Triangles| find(&|record| record.knob == Knob::Mesh && record.setup.mesh == mesh);
    let coarse = of_mesh(Triangles::Lattice(Step::Pixels(0.5)));
    let its = coarse.into_iter();
    sentences.extend(its.flat_map(|record| triangles(record, usual, scene)));
    let printed = of_mesh(Triangles::Leaf10);
    let both = coarse.zip(printed);
    sentences.extend(both.map(|(coarse, printed)| beside_printed(coarse, printed)));
    let reduced = find(&|record| record.knob == Knob::Reduce && record.setup.reduce == Reduce::On);
    sentences.extend(reduced.map(|record| reduction(record, scene)));
    let apart = find(&|record| record.knob == Knob::Lights);
    sentences.extend(
        apart
            .zip(reduced)
            .map(|(apart, reduced)| lights(apart, reduced)),
    );
    let long = find(&|record| record.knob == Knob::Codes && record.setup.codes == CodeBits::Bits63);
    sentences.extend(long.map(codes));
    sentences.extend(find(&|record| record.knob == Knob::Update).map(refit));
    let alone = find(&|record| record.knob == Knob::Threads && record.setup.threads == 1);
    sentences.extend(alone.map(|record| threads(record, usual)));
    sentences.push(best(scene, usual));
    sentences.push(same(scene));
    sentences
}

fn nodes(name: &str, own: &SetupRecord, usual: &SetupRecord, scene: &SceneRecord) -> Vec<Sentence> {
    let read = |record: &SetupRecord| record.facts.counts.all().bytes_read();
    let of_nodes = |record: &SetupRecord| record.facts.node_bytes as f64;
    let share = quotient(read(own), read(usual));
    let stored = quotient(of_nodes(own), of_nodes(usual));
    vec![
        (
            win_if(share < 1.0),
            format!(
                "With {name}, nodes take {} of the bytes of full-precision ones, and rays read {} of the bytes.",
                percent(stored),
                percent(share)
            ),
        ),
        time(own, Times::trace, &format!("Tracing {name}"), scene.backend),
    ]
}

/// The nodes of which rays read the fewest bytes.
fn widths(scene: &SceneRecord, usual: &SetupRecord) -> Option<Sentence> {
    let all = scene.setups.iter().filter(|it| it.knob == Knob::Nodes);
    let read = |record: &SetupRecord| record.facts.counts.all().bytes_read();
    let least = all.min_by(|a, b| read(a).total_cmp(&read(b)))?;
    Some((
        win_if(read(least) < read(usual)),
        format!(
            "Rays read the fewest bytes with nodes of {}: {:.0} a ray instead of {:.0}.",
            least.setup.nodes_name(),
            read(least),
            read(usual)
        ),
    ))
}

fn triangles(own: &SetupRecord, usual: &SetupRecord, scene: &SceneRecord) -> Vec<Sentence> {
    let (name, likeness, moves) = (own.setup.mesh_name(), &own.likeness, &own.facts.moves);
    let size = format!(
        "With triangles of {name} and matching nodes, a tree takes {:.1} bytes a triangle, {} of the default's.",
        own.facts.bytes_a_triangle(),
        percent(quotient(
            own.facts.bytes_a_triangle(),
            usual.facts.bytes_a_triangle()
        ))
    );
    let error = format!(
        "Vertices move by at most {:.2e}, which is {} of the scene's diagonal; {} of pixels see another triangle; the picture's \
         RMSE is {:.3} of 255 (SSIM {:.5}).",
        moves.most,
        share(moves.most / f64::from(scene.diagonal.max(f32::MIN_POSITIVE))),
        share(likeness.changed_primitives),
        likeness.image_rmse,
        likeness.ssim
    );
    let is_small = own.facts.bytes_a_triangle() < usual.facts.bytes_a_triangle();
    vec![
        (win_if(is_small), size),
        (
            Verdict::Loses,
            format!("With triangles of {name} pictures change. {error}"),
        ),
        time(
            own,
            Times::trace,
            &format!("Tracing triangles of {name}"),
            scene.backend,
        ),
    ]
}

/// Compares the lattice with the codec of the literature.
fn beside_printed(own: &SetupRecord, printed: &SetupRecord) -> Sentence {
    let bytes = |record: &SetupRecord| record.facts.bytes_a_triangle();
    let [own_bytes, printed_bytes] = [own, printed].map(bytes);
    let [own_error, printed_error] = [own, printed].map(|record| record.likeness.image_rmse);
    let text = format!(
        "Compared with the codec of the literature (\"{}\"), it takes {own_bytes:.1} bytes a triangle instead of {printed_bytes:.1}, \
         and the picture's RMSE is {own_error:.3} instead of {printed_error:.3}.",
        printed.name
    );
    let wins = own_bytes <= printed_bytes && own_error <= printed_error;
    (win_if(wins), text)
}

fn reduction(own: &SetupRecord, scene: &SceneRecord) -> Sentence {
    let (whole, planned) = (own.ratio(Times::frame), own.ratio(Times::planned));
    let plan = own.rounds.median(|round| round.own.plan);
    let kept = own.facts.tree_triangles as f64 / scene.triangles.max(1) as f64;
    if own.facts.trees == 1 && own.facts.tree_triangles == scene.triangles {
        let text =
            "Reduction leaves no triangle out of this scene's tree, even where it is requested.";
        return (Verdict::Loses, text.into());
    }
    let trees = slimbvh_cli::output::things(own.facts.trees, "tree");
    let text = format!(
        "Trees reduced to what their rays can hit ({trees} with {} of the triangles in all) make a picture {}; planning the reduction \
         takes {plan:.1} ms more, once per mesh, so that a single picture is made {}.",
        percent(kept),
        compared(own, Times::planned),
        in_words(whole)
    );
    (win_if(is_clear(own, Times::planned) && planned < 1.0), text)
}

fn lights(apart: &SetupRecord, grouped: &SetupRecord) -> Sentence {
    let time = |record: &SetupRecord| record.ratio(Times::planned);
    if grouped.facts.trees == apart.facts.trees {
        let text =
            "These lights are too far from each other to share a tree: grouping changes nothing.";
        return (Verdict::Loses, text.into());
    }
    let times = time(grouped) / time(apart);
    let text = format!(
        "With trees shared by lights, a picture is made {}.",
        in_words(times)
    );
    (win_if(times < 1.0 - MIN_DIFFERENCE), text)
}

fn codes(own: &SetupRecord) -> Sentence {
    let text = format!(
        "With 63-bit codes instead of 30-bit codes, rays are traced {}, and the tree is built {}.",
        compared(own, Times::trace),
        compared(own, |times| times.build)
    );
    let wins = own.ratio(Times::frame) < 1.0 && is_clear(own, Times::frame);
    (win_if(wins), text)
}

fn refit(own: &SetupRecord) -> Sentence {
    let build = own.ratio(|times| times.build);
    let text = format!(
        "Refitting a tree after a 64th of the twist's period takes {} of the time of a rebuild; rays are traced {}.",
        percent(build),
        compared(own, Times::trace)
    );
    (win_if(build < 1.0), text)
}

fn threads(one: &SetupRecord, usual: &SetupRecord) -> Sentence {
    let (times, count) = (one.ratio(Times::frame), usual.setup.threads);
    let is_faster = times > 1.0 && is_clear(one, Times::frame);
    let text = match is_faster {
        true => format!("{count} threads make a picture {times:.2} times as fast as one."),
        false => {
            format!(
                "{count} threads are not clearly faster than one here ({times:.2} times as fast)."
            )
        }
    };
    (win_if(is_faster), text)
}

/// The fastest and the smallest of the setups that change no pixel.
fn best(scene: &SceneRecord, usual: &SetupRecord) -> Sentence {
    let same = |record: &&SetupRecord| {
        record.likeness.changed_pixels == 0.0 && record.setup.is_comparable(&usual.setup)
    };
    let fastest = scene.setups.iter().filter(same);
    let fastest = fastest.min_by(|a, b| a.ratio(Times::frame).total_cmp(&b.ratio(Times::frame)));
    let smallest = scene.setups.iter().filter(same);
    let smallest = smallest.min_by_key(|record| record.facts.resident_bytes());
    let (Some(fastest), Some(smallest)) = (fastest, smallest) else {
        return (
            Verdict::Fails,
            "No setup makes the plain tree's picture.".into(),
        );
    };
    let is_faster = fastest.ratio(Times::frame) < 1.0 && is_clear(fastest, Times::frame);
    let fast = match is_faster {
        true => format!(
            "\"{}\" is the fastest, {}",
            fastest.name,
            compared(fastest, Times::frame)
        ),
        false => "no setup is clearly faster than the default".into(),
    };
    let bytes = |record: &SetupRecord| record.facts.resident_bytes() as f64;
    let text = format!(
        "Of the setups that change no pixel, \"{}\" is the smallest with {:.1} bytes a triangle of the mesh, {} of the default's; {fast}.",
        smallest.name,
        bytes(smallest) / scene.triangles.max(1) as f64,
        percent(quotient(bytes(smallest), bytes(usual))),
    );
    (win_if(is_faster || bytes(smallest) < bytes(usual)), text)
}

/// Whether all lossless setups make the plain tree's picture.
fn same(scene: &SceneRecord) -> Sentence {
    let lossless = scene.setups.iter().filter(|it| it.setup.is_lossless());
    let (same, other): (Vec<_>, Vec<_>) =
        lossless.partition(|record| record.likeness.changed_pixels == 0.0);
    if other.is_empty() {
        let text = format!(
            "All {} setups with full-precision triangles make the plain tree's picture, byte for byte.",
            same.len()
        );
        return (Verdict::Holds, text);
    }
    let names: Vec<String> = other
        .iter()
        .map(|record| {
            format!(
                "\"{}\" ({})",
                record.name,
                share(record.likeness.changed_pixels)
            )
        })
        .collect();
    let text = format!(
        "These setups have full-precision triangles and yet change pixels: {}.",
        names.join(", ")
    );
    (Verdict::Fails, text)
}
