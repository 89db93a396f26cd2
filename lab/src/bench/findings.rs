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
use words::{Sentence, compared, quotient, time, verdict, win_if, within};

/// The verdict of a sentence on slimbvh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// It gains something.
    Wins,
    /// It loses something, or gains nothing.
    Loses,
    /// The spread of the runs hides whether it gains or loses.
    Open,
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
    let whole = find(&|record| record.knob == Knob::Reduce && record.setup.reduce == Reduce::Off);
    let whole = whole.filter(|_| reduced.is_none());
    sentences.extend(whole.map(|record| without_reduction(record, usual, scene)));
    let apart = find(&|record| record.knob == Knob::Lights);
    let both = apart.zip(reduced);
    sentences.extend(both.map(|(apart, reduced)| lights(apart, reduced)));
    if scene.equal.iter().any(|it| it.knob == Knob::Lights) {
        let text = "These lights share no tree: grouping changes nothing.";
        sentences.push((Verdict::Loses, text.into()));
    }
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
        compared(&own.ratios(Times::planned)),
        compared(&own.ratios(Times::frame))
    );
    (verdict(&own.ratios(Times::planned)), text)
}

/// The same where the default reduces: then it is measured beside the whole tree.
fn without_reduction(whole: &SetupRecord, usual: &SetupRecord, scene: &SceneRecord) -> Sentence {
    let ratios = usual
        .ratios(Times::planned)
        .over(&whole.ratios(Times::planned));
    let kept = usual.facts.tree_triangles as f64 / scene.triangles.max(1) as f64;
    let trees = slimbvh_cli::output::things(usual.facts.trees, "tree");
    let text = format!(
        "The default reduces trees here to what their rays can hit ({trees} with {} of the triangles in all): compared with one whole \
         tree, a picture is made {}, without the planning.",
        percent(kept),
        compared(&ratios)
    );
    (verdict(&ratios), text)
}

fn lights(apart: &SetupRecord, grouped: &SetupRecord) -> Sentence {
    let [grouped, apart] = [grouped, apart].map(|record| record.ratios(Times::planned));
    let times = grouped.over(&apart);
    let text = format!(
        "With trees shared by lights, a picture is made {}.",
        compared(&times)
    );
    (verdict(&times), text)
}

fn codes(own: &SetupRecord) -> Sentence {
    let text = format!(
        "With 63-bit codes instead of 30-bit codes, rays are traced {}, and the tree is built {}.",
        compared(&own.ratios(Times::trace)),
        compared(&own.ratios(|times| times.build))
    );
    (verdict(&own.ratios(Times::frame)), text)
}

fn refit(own: &SetupRecord) -> Sentence {
    let build = own.ratios(|times| times.build);
    let text = format!(
        "A tree is refitted after a 64th of the twist's period {}, compared with a rebuild; rays are traced {}.",
        compared(&build),
        compared(&own.ratios(Times::trace))
    );
    (verdict(&build), text)
}

fn threads(one: &SetupRecord, usual: &SetupRecord) -> Sentence {
    let (times, count) = (one.ratios(Times::frame), usual.setup.threads);
    let within = within(&times);
    let text = format!(
        "{count} threads make a picture {:.2} times as fast as one{within}.",
        times.median
    );
    let verdict = match times.is_clear() {
        true => win_if(times.median > 1.0),
        false => Verdict::Open,
    };
    (verdict, text)
}

/// The fastest and the smallest of the setups that change no pixel.
fn best(scene: &SceneRecord, usual: &SetupRecord) -> Sentence {
    let same = |record: &&SetupRecord| {
        record.likeness.changed_pixels == 0.0 && record.setup.is_comparable(&usual.setup)
    };
    let frames = |record: &SetupRecord| record.ratios(Times::frame);
    let fastest = scene.setups.iter().filter(same);
    let fastest = fastest.min_by(|a, b| frames(a).median.total_cmp(&frames(b).median));
    let smallest = scene.setups.iter().filter(same);
    let smallest = smallest.min_by_key(|record| record.facts.resident_bytes());
    let (Some(fastest), Some(smallest)) = (fastest, smallest) else {
        return (
            Verdict::Fails,
            "No setup makes the plain tree's picture.".into(),
        );
    };
    let is_faster = frames(fastest).median < 1.0 && frames(fastest).is_clear();
    let fast = match is_faster {
        true => format!(
            "\"{}\" is the fastest, {}",
            fastest.name,
            compared(&frames(fastest))
        ),
        false => "none is faster than the default by more than the spread of these runs".into(),
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
