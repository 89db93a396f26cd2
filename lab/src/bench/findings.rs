//! What the figures say, in sentences.

mod words;

pub use words::{percent, share};

use super::measure::{SceneRecord, SetupRecord};
use super::setup::{Knob, Triangles};
use super::times::Times;
use crate::measure::step::Step;
use serde::Serialize;
use slimbvh::reduce::Reduce;
use slimbvh::{CodeBits, LatticeBits, NodeCodec};
use words::{NOTHING, Told, compared, in_words, is_clear, quotient, time, win_if};

/// What a sentence says of slimbvh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// It wins something.
    Wins,
    /// It costs something, or gains nothing.
    Loses,
    /// It is as it should be.
    Holds,
    /// It is not.
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
    let told = tell(scene).into_iter().map(|(verdict, text)| Finding {
        scene: scene.name.clone(),
        backend: scene.backend,
        verdict,
        text,
    });
    told.collect()
}

fn tell(scene: &SceneRecord) -> Vec<Told> {
    let Some(usual) = scene.setups.first() else {
        return Vec::new();
    };
    let find = |is: &dyn Fn(&SetupRecord) -> bool| scene.setups.iter().find(|record| is(record));
    let mut told = Vec::new();
    let coded = find(&|record| {
        record.knob == Knob::Nodes && record.setup.nodes == NodeCodec::Lattice(LatticeBits::Q10)
    });
    told.extend(
        coded
            .into_iter()
            .flat_map(|record| nodes(record, usual, scene)),
    );
    told.extend(widths(scene, usual));
    let of_mesh =
        |mesh: Triangles| find(&|record| record.knob == Knob::Mesh && record.setup.mesh == mesh);
    let coarse = of_mesh(Triangles::Lattice(Step::Pixels(0.5)));
    let its = coarse.into_iter();
    told.extend(its.flat_map(|record| triangles(record, usual, scene)));
    let printed = of_mesh(Triangles::Leaf10);
    let both = coarse.zip(printed);
    told.extend(both.map(|(coarse, printed)| beside_printed(coarse, printed)));
    let reduced = find(&|record| record.knob == Knob::Reduce && record.setup.reduce == Reduce::On);
    told.extend(reduced.map(|record| reduction(record, scene)));
    let apart = find(&|record| record.knob == Knob::Lights);
    told.extend(
        apart
            .zip(reduced)
            .map(|(apart, reduced)| lights(apart, reduced)),
    );
    let long = find(&|record| record.knob == Knob::Codes && record.setup.codes == CodeBits::Bits63);
    told.extend(long.map(codes));
    told.extend(find(&|record| record.knob == Knob::Update).map(refit));
    let alone = find(&|record| record.knob == Knob::Threads && record.setup.threads == 1);
    told.extend(alone.map(|record| threads(record, usual)));
    told.push(best(scene, usual));
    told.push(same(scene));
    told
}

fn nodes(own: &SetupRecord, usual: &SetupRecord, scene: &SceneRecord) -> Vec<Told> {
    let read = |record: &SetupRecord| record.facts.counts.all().bytes_read();
    let of_nodes = |record: &SetupRecord| record.facts.node_bytes as f64;
    let share = quotient(read(own), read(usual));
    let stored = quotient(of_nodes(own), of_nodes(usual));
    vec![
        (
            win_if(share < 1.0),
            format!(
                "Nodes in 10 bits take {} of the bytes of nodes in full, and rays read {} of the bytes.",
                percent(stored),
                percent(share)
            ),
        ),
        time(own, Times::trace, "Tracing nodes in 10 bits", scene.backend),
    ]
}

/// The fewest bits that trace about as well as the most.
fn widths(scene: &SceneRecord, usual: &SetupRecord) -> Option<Told> {
    let all = scene.setups.iter().filter(|it| it.knob == Knob::Nodes);
    let read = |record: &SetupRecord| record.facts.counts.all().bytes_read();
    let least = all.min_by(|a, b| read(a).total_cmp(&read(b)))?;
    Some((
        win_if(read(least) < read(usual)),
        format!(
            "Of all nodes those of {} let rays read the fewest bytes: {:.0} a ray instead of {:.0}.",
            least.setup.nodes_name(),
            read(least),
            read(usual)
        ),
    ))
}

fn triangles(own: &SetupRecord, usual: &SetupRecord, scene: &SceneRecord) -> Vec<Told> {
    let (name, likeness, moves) = (own.setup.mesh_name(), &own.likeness, &own.facts.moves);
    let size = format!(
        "With triangles of {name} and nodes that go with them, a tree takes {:.1} bytes a triangle, {} of the default's.",
        own.facts.bytes_a_triangle(),
        percent(quotient(
            own.facts.bytes_a_triangle(),
            usual.facts.bytes_a_triangle()
        ))
    );
    let error = format!(
        "No vertex moves by more than {:.2e}, which is {} of the scene's diagonal, {} of pixels see another triangle, and the picture is \
         off by {:.3} of 255 (SSIM {:.5}).",
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

/// The lattice beside the codec of the literature.
fn beside_printed(own: &SetupRecord, printed: &SetupRecord) -> Told {
    let bytes = |record: &SetupRecord| record.facts.bytes_a_triangle();
    let [own_bytes, printed_bytes] = [own, printed].map(bytes);
    let [own_error, printed_error] = [own, printed].map(|record| record.likeness.image_rmse);
    let text = format!(
        "Beside the codec of the literature (\"{}\") that is {own_bytes:.1} bytes a triangle instead of {printed_bytes:.1}, and a picture \
         that is off by {own_error:.3} instead of {printed_error:.3}.",
        printed.name
    );
    let wins = own_bytes <= printed_bytes && own_error <= printed_error;
    (win_if(wins), text)
}

fn reduction(own: &SetupRecord, scene: &SceneRecord) -> Told {
    let (whole, planned) = (own.ratio(Times::frame), own.ratio(Times::planned));
    let plan = own.rounds.median(|round| round.own.plan);
    let kept = own.facts.tree_triangles as f64 / scene.triangles.max(1) as f64;
    if own.facts.trees == 1 && own.facts.tree_triangles == scene.triangles {
        let text = "Nothing may be left out of this scene's tree, even where that is asked for.";
        return (Verdict::Loses, text.into());
    }
    let trees = slimbvh_cli::output::things(own.facts.trees, "tree");
    let text = format!(
        "Trees without what their rays cannot hit ({trees} with {} of the triangles in all) make a picture {}; finding out what may be left out \
         takes {plan:.1} ms more, once for a mesh, so that a single picture is made {}.",
        percent(kept),
        compared(own, Times::planned),
        in_words(whole)
    );
    (win_if(is_clear(own, Times::planned) && planned < 1.0), text)
}

fn lights(apart: &SetupRecord, grouped: &SetupRecord) -> Told {
    let time = |record: &SetupRecord| record.ratio(Times::planned);
    if grouped.facts.trees == apart.facts.trees {
        let text =
            "These lights are too far from each other to share a tree: grouping changes nothing.";
        return (Verdict::Loses, text.into());
    }
    let times = time(grouped) / time(apart);
    let text = format!(
        "Where lights share a tree, a picture is made {}.",
        in_words(times)
    );
    (win_if(times < 1.0 - NOTHING), text)
}

fn codes(own: &SetupRecord) -> Told {
    let text = format!(
        "63-bit codes instead of 30: rays are traced {}, and the tree is built {}.",
        compared(own, Times::trace),
        compared(own, |times| times.build)
    );
    let wins = own.ratio(Times::frame) < 1.0 && is_clear(own, Times::frame);
    (win_if(wins), text)
}

fn refit(own: &SetupRecord) -> Told {
    let build = own.ratio(|times| times.build);
    let text = format!(
        "Refitting a tree after the scene was twisted by a 64th of its round takes {} of the time of a new one; its rays are traced {}.",
        percent(build),
        compared(own, Times::trace)
    );
    (win_if(build < 1.0), text)
}

fn threads(one: &SetupRecord, usual: &SetupRecord) -> Told {
    let (times, count) = (one.ratio(Times::frame), usual.setup.threads);
    let is_faster = times > 1.0 && is_clear(one, Times::frame);
    let text = match is_faster {
        true => format!("{count} threads make a picture {times:.2} times as fast as one."),
        false => {
            format!("{count} threads gain nothing clear over one here ({times:.2} times as fast).")
        }
    };
    (win_if(is_faster), text)
}

/// The fastest and the smallest of those that lose nothing.
fn best(scene: &SceneRecord, usual: &SetupRecord) -> Told {
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
        false => "nothing is clearly faster than the default".into(),
    };
    let bytes = |record: &SetupRecord| record.facts.resident_bytes() as f64;
    let text = format!(
        "Of all that change no pixel, \"{}\" is the smallest, {:.1} bytes a triangle of the mesh, {} of the default's; {fast}.",
        smallest.name,
        bytes(smallest) / scene.triangles.max(1) as f64,
        percent(quotient(bytes(smallest), bytes(usual))),
    );
    (win_if(is_faster || bytes(smallest) < bytes(usual)), text)
}

/// Whether all that should lose nothing do so.
fn same(scene: &SceneRecord) -> Told {
    let lossless = scene.setups.iter().filter(|it| it.setup.is_lossless());
    let (same, other): (Vec<_>, Vec<_>) =
        lossless.partition(|record| record.likeness.changed_pixels == 0.0);
    if other.is_empty() {
        let text = format!(
            "All {} setups with triangles in full make the plain tree's picture, byte for byte.",
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
        "These have triangles in full, and change pixels all the same: {}.",
        names.join(", ")
    );
    (Verdict::Fails, text)
}
