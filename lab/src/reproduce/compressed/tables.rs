//! Tables of the paper's figures, with ours below them.

mod memory;
mod times;

use super::bench::TimedOn;
use super::measure::{MethodRecord, STRONG, SceneRecord};
use super::methods::Method;
use crate::measure::table::Table;
use crate::reproduce::tables::{NOTHING, percent, ratio, time};
use slimbvh_cli::output::count;

/// All tables.
pub fn tables(records: &[SceneRecord], place: TimedOn) -> Vec<Table> {
    let mut tables = vec![
        touched(records),
        memory::bytes(records),
        times::frames(records, place),
        times::stages(records),
    ];
    if place.is_gpu() {
        tables.push(memory::buffers(records));
    }
    tables.extend([pictures(records), kinds(records)]);
    if !place.is_gpu() {
        tables.push(widths(records));
    }
    tables
}

/// A ratio as a signed change in percent.
fn change(ratio: f64) -> String {
    format!("{:+.1} %", 100.0 * (ratio - 1.0))
}

/// Fills a row with empty cells.
fn filled(mut row: Vec<String>, columns: usize) -> Vec<String> {
    row.resize(columns, NOTHING.to_owned());
    row
}

/// The methods that are not measured for their width alone.
fn main_methods(record: &SceneRecord) -> impl Iterator<Item = &MethodRecord> {
    record
        .methods
        .iter()
        .filter(|own| !own.method.is_other_width())
}

fn touched(records: &[SceneRecord]) -> Table {
    let head = vec![
        "scene",
        "by",
        "method",
        "box tests",
        "of plain",
        "triangle tests",
        "of plain",
        "nodes read",
        "triangles read",
        "bytes read",
        "of plain",
    ];
    let mut rows = Vec::new();
    for record in records {
        let name = || record.name.to_owned();
        for (i, method) in [Method::Node, Method::NodeMesh].into_iter().enumerate() {
            if let Some(printed) = &record.printed {
                let mut row = filled(vec![name(), "printed".into(), method.name()], head.len());
                let [boxes, triangles] = printed.more_tests.map(|more| change(1.0 + more));
                if method == Method::Node {
                    (row[4], row[6]) = (boxes, triangles);
                }
                row[10] = change(1.0 + printed.more_read[i]);
                rows.push(row);
            }
        }
        let plain = record.plain().counts.all();
        for own in main_methods(record) {
            let all = own.counts.all();
            let read = |sum: u64| format!("{:.0}", all.mean(sum));
            rows.push(vec![
                name(),
                "ours".into(),
                own.name.clone(),
                format!("{:.2}", all.box_tests()),
                change(all.box_tests() / plain.box_tests()),
                format!("{:.2}", all.triangle_tests()),
                change(all.triangle_tests() / plain.triangle_tests()),
                read(all.node_bytes),
                read(all.triangle_bytes),
                read(all.node_bytes + all.triangle_bytes),
                change(all.bytes_read() / plain.bytes_read()),
            ]);
        }
    }
    Table {
        title: "What a ray touches".into(),
        notes: vec![
            "Means per ray of the picture, including rays that miss: boxes tested (all children of the opened nodes), triangles tested, and \
             bytes of the opened nodes and tested triangles, each counted as often as it is touched, as if there were no cache. Moved \
             vertices make another picture, whose rays these are. Printed: compared with Karras' tree, with one box and links per node and \
             one triangle per leaf; ours is a different tree (see plain)."
                .into(),
            "A box grows by less than a cell on each side, 1 of 1023 of its parent's, which explains the few additional tests of NODE here; the \
             paper does not say why it found more. Flat boxes in larger ones become a cell thick on the lattice, so that rays which start on such \
             a surface test its triangles again (shiny). Triangles whose vertices coincide vanish, and are not hit."
                .into(),
            "w4-64 and w4-48: a leaf of triangles on the lattice is decoded from its node, which is counted as read again. Each ray is \
             tested against the root's own box first, which w4 and plain do without."
                .into(),
        ],
        word_columns: 3,
        head,
        rows,
    }
}

fn pictures(records: &[SceneRecord]) -> Table {
    let mut rows = Vec::new();
    for record in records {
        for own in main_methods(record) {
            let differences = own.differences;
            let millionths = |length: f32| format!("{:.2}", 1e6 * length / record.diagonal);
            let [moved, bound] = own.moved.map_or([NOTHING.into(), NOTHING.into()], |moved| {
                moved.map(millionths)
            });
            let cracks = |of: fn(&super::cracks::Cracks) -> usize| {
                own.cracks
                    .as_ref()
                    .map_or(NOTHING.into(), |cracks| count(of(cracks)))
            };
            rows.push(vec![
                record.name.to_owned(),
                own.name.clone(),
                count(differences.lost),
                count(differences.gained),
                count(differences.changed),
                count(differences.strongly),
                moved,
                bound,
                cracks(|cracks| cracks.aimed),
                cracks(|cracks| cracks.lost),
                cracks(|cracks| cracks.leaked),
            ]);
        }
    }
    Table {
        title: "Changes of the picture".into(),
        notes: vec![format!(
            "Pixels compared with the plain tree's picture: those that lost their hit, those that gained one, those that \
             changed at all, and those that changed by more than {STRONG} of 255. The largest move of a vertex and its bound, in millionths of the \
             scene's diagonal; for the paper's codec, the bound of the largest leaf. Cracks, for closed scenes: rays aimed from the eye at \
             vertices and middles of edges of triangles that face it; those that hit nothing (for the plain tree: rounded past a \
             silhouette), and those that pass their target and first hit a triangle from behind: they got in between two."
        )],
        word_columns: 2,
        head: vec![
            "scene", "method", "lost", "gained", "changed", "strongly", "moved", "bound", "aimed",
            "missed", "got in",
        ],
        rows,
    }
}

fn kinds(records: &[SceneRecord]) -> Table {
    let mut rows = Vec::new();
    for record in records {
        let plain = &record.plain().counts;
        for own in main_methods(record) {
            let counts = &own.counts;
            let kinds = [
                ("eye", counts.eye, plain.eye),
                ("shadow", counts.shadow, plain.shadow),
                ("secondary", counts.secondary, plain.secondary),
            ];
            for (kind, tally, plain) in kinds.into_iter().filter(|kind| kind.1.rays > 0) {
                rows.push(vec![
                    record.name.to_owned(),
                    own.name.clone(),
                    kind.to_owned(),
                    count(tally.rays as usize),
                    format!("{:.2}", tally.box_tests()),
                    change(tally.box_tests() / plain.box_tests()),
                    format!("{:.2}", tally.triangle_tests()),
                    change(tally.triangle_tests() / plain.triangle_tests()),
                    format!("{:.0}", tally.bytes_read()),
                    change(tally.bytes_read() / plain.bytes_read()),
                ]);
            }
        }
    }
    Table {
        title: "What a ray touches, by kind of ray".into(),
        notes: vec!["Eye rays, shadow rays, and rays from mirrors and through glass.".into()],
        word_columns: 3,
        head: vec![
            "scene",
            "method",
            "rays",
            "number",
            "box tests",
            "of plain",
            "triangle tests",
            "of plain",
            "bytes read",
            "of plain",
        ],
        rows,
    }
}

fn widths(records: &[SceneRecord]) -> Table {
    let mut rows = Vec::new();
    for record in records {
        let plain = record.plain().counts.all();
        let mut widths: Vec<&MethodRecord> = record.methods.iter().collect();
        widths.retain(|own| matches!(own.method, Method::Lattice(_)));
        widths.sort_by_key(|own| match own.method {
            Method::Lattice(bits) => bits.count(),
            _ => 0,
        });
        for own in widths {
            let all = own.counts.all();
            let rounds = &own.rounds;
            let rendering = rounds.median(|round| round.own.rendering / round.plain.rendering);
            rows.push(vec![
                record.name.to_owned(),
                own.name.clone(),
                own.method.node_bytes().to_string(),
                format!("{:.1}", own.node_bytes as f64 / record.triangles as f64),
                percent(own.bytes() as f64 / record.plain().bytes() as f64),
                change(all.box_tests() / plain.box_tests()),
                change(all.triangle_tests() / plain.triangle_tests()),
                change(all.bytes_read() / plain.bytes_read()),
                time(rounds.median(|round| round.own.encoding)),
                ratio(rendering),
                count(own.differences.changed),
            ]);
        }
    }
    Table {
        title: "Bits per plane".into(),
        notes: vec![
            "Nodes on the lattice with N bits per plane, triangles in full precision: more bits take more bytes, fewer bits more tests. Pictures must \
             not change."
                .to_owned(),
        ],
        word_columns: 2,
        head: vec![
            "scene",
            "bits",
            "a node",
            "nodes, a triangle",
            "together, of plain",
            "box tests",
            "triangle tests",
            "bytes read",
            "encoding, ms",
            "rendering, of plain",
            "pixels changed",
        ],
        rows,
    }
}
