//! The nodes of a glTF scene, and their transforms to the scene, in `f64`.

use super::GltfError;
use super::json::{Index, Node, Root};
use glam::{DAffine3, DMat4, DQuat, DVec3};

/// The nodes of the default scene.
pub(super) struct Nodes<'a> {
    root: &'a Root,
    /// Each once, parents first.
    pub visited: Vec<Visited<'a>>,
    /// The transform of each node, as far as it is known.
    transforms: Vec<Option<DAffine3>>,
    /// The parent of each node in the file.
    parents: Vec<Option<usize>>,
}

/// A node of the scene.
#[derive(Clone, Copy)]
pub(super) struct Visited<'a> {
    pub node: &'a Node,
    pub index: usize,
    pub transform: DAffine3,
    /// Whether it or a node above it is not to be seen (`KHR_node_visibility`).
    pub is_hidden: bool,
}

impl<'a> Nodes<'a> {
    /// Visits the nodes. Iterative, so depth cannot overflow the stack.
    pub fn new(root: &'a Root) -> Result<Self, GltfError> {
        let mut parents = vec![None; root.nodes.len()];
        for (parent, node) in root.nodes.iter() {
            for &Index(child) in &node.children {
                if let Some(known @ None) = parents.get_mut(child) {
                    *known = Some(parent);
                }
            }
        }
        let mut stack: Vec<Visited> = Vec::new();
        for (index, place) in roots(root, &parents)? {
            stack.push(Visited {
                node: root.nodes.item("nodes", Index(index), || place)?,
                index,
                transform: DAffine3::IDENTITY,
                is_hidden: false,
            });
        }
        stack.reverse();

        let mut transforms = vec![None; root.nodes.len()];
        let mut visited = Vec::new();
        while let Some(mut it) = stack.pop() {
            it.transform *= local(it.node);
            if transforms[it.index].replace(it.transform).is_some() {
                return Err(GltfError::NotATree { node: it.index });
            }
            let visibility = it.node.extensions.visibility.as_ref();
            it.is_hidden |= visibility.is_some_and(|it| it.visible == Some(false));
            visited.push(it);
            for (i, &child) in it.node.children.iter().enumerate().rev() {
                let place = || format!("nodes[{}].children[{i}]", it.index);
                stack.push(Visited {
                    node: root.nodes.item("nodes", child, place)?,
                    index: child.0,
                    ..it
                });
            }
        }
        Ok(Self {
            root,
            visited,
            transforms,
            parents,
        })
    }

    /// The transform of a node, which need not be in the scene.
    pub fn transform(&mut self, node: usize) -> Result<DAffine3, GltfError> {
        let mut above = Vec::new();
        let mut next = Some(node);
        let mut transform = DAffine3::IDENTITY;
        while let Some(node) = next {
            if let Some(known) = self.transforms[node] {
                transform = known;
                break;
            }
            // A chain that is longer than the number of nodes comes back to itself.
            if above.len() == self.transforms.len() {
                return Err(GltfError::NotATree { node });
            }
            above.push(node);
            next = self.parents[node];
        }
        for node in above.into_iter().rev() {
            transform *= self.root.nodes.get(node).map_or(DAffine3::IDENTITY, local);
            self.transforms[node] = Some(transform);
        }
        Ok(transform)
    }
}

/// The roots of the default scene, or of the first with nodes, each with its place in the JSON. Without scenes, all nodes without a
/// parent, but for those that stand for others at a distance.
fn roots(root: &Root, parents: &[Option<usize>]) -> Result<Vec<(usize, String)>, GltfError> {
    let first = || {
        let mut scenes = root.scenes.iter();
        let found = scenes.find(|(_, scene)| !scene.nodes.is_empty());
        found.map_or(Index(0), |(scene, _)| Index(scene))
    };
    if root.scenes.len() > 0 {
        let index = root.scene.unwrap_or_else(first);
        let scene = root.scenes.item("scenes", index, || "scene".into())?;
        let nodes = scene.nodes.iter().enumerate();
        let place = |i| format!("scenes[{}].nodes[{i}]", index.0);
        return Ok(nodes.map(|(i, &Index(node))| (node, place(i))).collect());
    }
    let mut is_root: Vec<bool> = parents.iter().map(Option::is_none).collect();
    let nodes = root.nodes.iter();
    let levels = nodes.filter_map(|(_, node)| node.extensions.levels.as_ref());
    for &Index(node) in levels.flat_map(|levels| &levels.ids) {
        if let Some(is_root) = is_root.get_mut(node) {
            *is_root = false;
        }
    }
    let nodes = (0..root.nodes.len()).filter(|&node| is_root[node]);
    Ok(nodes.map(|node| (node, String::new())).collect())
}

/// The transform of a node to its parent.
fn local(node: &Node) -> DAffine3 {
    if let Some(matrix) = &node.matrix {
        return DAffine3::from_mat4(DMat4::from_cols_array(matrix));
    }
    trs(
        node.translation.unwrap_or_default(),
        node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]),
        node.scale.unwrap_or([1.0; 3]),
    )
}

/// Scales, turns and moves, in this order. A quaternion counts by its direction; zero turns nothing.
pub(super) fn trs(translation: [f64; 3], rotation: [f64; 4], scale: [f64; 3]) -> DAffine3 {
    let rotation = DQuat::from_array(rotation);
    let rotation = match rotation.length_squared() {
        0.0 => DQuat::IDENTITY,
        _ => rotation.normalize(),
    };
    let (scale, translation) = (DVec3::from_array(scale), DVec3::from_array(translation));
    DAffine3::from_scale_rotation_translation(scale, rotation, translation)
}
