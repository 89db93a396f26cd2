//! Nodes outside every scene.

use super::super::load::Source;
use super::json::{Index, Node, Root};
use super::nodes::Visited;
use std::collections::BTreeSet;

/// Notes nodes of no scene that hold a camera, a light or a mesh that the scene has elsewhere; other meshes are noted as such. Levels of
/// detail and the nodes of other scenes are noted with those.
pub(super) fn note(root: &Root, visited: &[Visited<'_>], source: &Source<'_>) {
    let mut known = vec![false; root.nodes.len()];
    for it in visited {
        known[it.index] = true;
    }
    let levels = visited.iter().flat_map(|it| &it.node.extensions.levels);
    let scenes = root.scenes.iter().flat_map(|(_, scene)| &scene.nodes);
    mark(
        levels.flat_map(|levels| &levels.ids).chain(scenes),
        root,
        &mut known,
    );

    let meshes = visited.iter().filter_map(|it| Some(it.node.mesh?.0));
    let meshes: BTreeSet<usize> = meshes.collect();
    let holds = |node: &Node| {
        let has_mesh = node.mesh.is_some_and(|mesh| meshes.contains(&mesh.0));
        has_mesh || node.camera.is_some() || node.extensions.light.is_some()
    };
    let outside = root
        .nodes
        .iter()
        .filter(|(index, node)| !known[*index] && holds(node));
    source.leave_out("nodes outside every scene", outside.count());
}

/// Marks nodes and all below them.
fn mark<'n>(nodes: impl Iterator<Item = &'n Index>, root: &'n Root, known: &mut [bool]) {
    let mut stack: Vec<&Index> = nodes.collect();
    while let Some(&Index(node)) = stack.pop() {
        if known.get(node) == Some(&false) {
            known[node] = true;
            stack.extend(root.nodes.get(node).iter().flat_map(|node| &node.children));
        }
    }
}
