//! Tables of the memory of trees and triangles, and of the GPU's buffers.

use super::super::measure::SceneRecord;
use super::main_methods;
use crate::measure::table::Table;
use crate::reproduce::tables::percent;
use slimbvh_cli::output::count;

/// The bytes of nodes and triangles.
pub fn bytes(records: &[SceneRecord]) -> Table {
    let mut rows = Vec::new();
    for record in records {
        let each = |bytes: usize| format!("{:.1}", bytes as f64 / record.triangles as f64);
        for own in main_methods(record) {
            rows.push(vec![
                record.name.to_owned(),
                own.name.clone(),
                own.method.node_bytes().to_string(),
                count(own.node_bytes),
                each(own.node_bytes),
                count(own.triangle_bytes),
                each(own.triangle_bytes),
                count(own.bytes()),
                each(own.bytes()),
                percent(own.bytes() as f64 / record.plain().bytes() as f64),
            ]);
        }
    }
    Table {
        title: "Bytes of tree and triangles".into(),
        notes: vec![
            "Bytes per node; of all nodes, and of these per triangle of the scene; of all triangles in leaves with their index; of both. The caller's mesh is \
             not included. The paper says that up to 40 % less memory is needed."
                .into(),
        ],
        word_columns: 2,
        head: vec![
            "scene", "method", "a node", "nodes", "a triangle", "triangles", "each", "together", "a triangle", "of plain",
        ],
        rows,
    }
}

/// The bytes of the GPU's buffers.
pub fn buffers(records: &[SceneRecord]) -> Table {
    let mut rows = Vec::new();
    for record in records {
        let plain = record.plain().on_gpu.map(|on_gpu| on_gpu.buffers);
        for own in main_methods(record) {
            let Some((own_buffers, plain)) = own.on_gpu.map(|g| g.buffers).zip(plain) else {
                continue;
            };
            let bytes = |bytes: u64| count(bytes);
            let together = own_buffers.together();
            rows.push(vec![
                record.name.to_owned(),
                own.name.clone(),
                count(own.bytes()),
                bytes(own_buffers.tree),
                bytes(own_buffers.builder),
                bytes(own_buffers.renderer),
                bytes(own_buffers.scene),
                bytes(together),
                percent(together as f64 / plain.together() as f64),
                percent(own_buffers.tree as f64 / plain.tree as f64),
            ]);
        }
    }
    Table {
        title: "Bytes of the GPU's buffers, at most".into(),
        notes: vec![
            "The bytes that tree and triangles take; the room reserved for them, as only the GPU knows the number of nodes and the sizes of \
             triangles; the builder's buffers between stages, which hold nodes and triangles in full precision before they are coded; the \
             renderer's, for rays and the picture; the caller's mesh and materials; the sum of all these, which exist at once. A tree that \
             was uploaded has no more room than it takes, and no builder."
                .into(),
        ],
        word_columns: 2,
        head: vec![
            "scene", "method", "taken", "room", "builder", "renderer", "mesh", "together", "of plain", "room, of plain",
        ],
        rows,
    }
}
