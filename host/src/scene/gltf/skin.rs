//! Skins and morph targets at the file's pose; glTF 2.0, sections 3.7.3.3 and 3.7.2.2.

use super::super::LoadError;
use super::GltfError;
use super::accessor::{Component, Elements, Expected, VECTORS, elements};
use super::buffers::Buffers;
use super::json::{Attributes, Index, Primitive, Root};
use super::nodes::Nodes;
use crate::text::excerpt;
use glam::{DAffine3, DMat4, DVec3};

const MATRICES: Expected = Expected {
    shape: "MAT4",
    width: 16,
    is_fit: Component::is_float,
    name: "matrices of floats",
};

const JOINTS: Expected = Expected {
    shape: "VEC4",
    width: 4,
    is_fit: Component::is_unsigned,
    name: "vectors of four unsigned numbers",
};

const WEIGHTS: Expected = Expected {
    shape: "VEC4",
    width: 4,
    is_fit: |kind| kind.is_float() || kind.is_unsigned(),
    name: "vectors of four shares",
};

/// The transform of each joint of a skin, from the mesh to the scene.
pub(super) fn joints(
    root: &Root,
    index: Index,
    place: impl FnOnce() -> String,
    nodes: &mut Nodes<'_>,
    buffers: &Buffers<'_>,
) -> Result<Vec<DAffine3>, LoadError> {
    let fault = |error| buffers.fault(error);
    let skin = root.skins.item("skins", index, place).map_err(fault)?;
    let place = |member: &str| format!("skins[{}].{member}", index.0);
    let matrices = skin.inverse_bind_matrices.map(|accessor| {
        let place = || place("inverseBindMatrices");
        elements(root, accessor, place, &MATRICES, buffers)
    });
    let matrices = matrices.transpose()?;
    if let Some(matrices) = matrices.as_ref().filter(|it| it.len() < skin.joints.len()) {
        return Err(fault(GltfError::BindMatrices {
            skin: index.0,
            found: matrices.len(),
            joints: skin.joints.len(),
        }));
    }
    let mut joints = Vec::with_capacity(skin.joints.len());
    for (i, &joint) in skin.joints.iter().enumerate() {
        root.nodes
            .item("nodes", joint, || place(&format!("joints[{i}]")))
            .map_err(fault)?;
        let transform = nodes.transform(joint.0).map_err(fault)?;
        joints.push(match &matrices {
            Some(matrices) => {
                let inverse = DMat4::from_cols_array(&matrices.numbers(i));
                transform * DAffine3::from_mat4(inverse)
            }
            None => transform,
        });
    }
    Ok(joints)
}

/// The joints that a primitive's vertices follow.
pub(super) struct Skinning<'b> {
    /// Joints and weights, four a vertex in each set.
    sets: Vec<[Elements<'b>; 2]>,
    skin: usize,
    joints: &'b [DAffine3],
}

impl<'b> Skinning<'b> {
    /// `None` if the primitive has no joints.
    pub fn new(
        root: &Root,
        primitive: &Primitive,
        place: &str,
        (skin, joints): (usize, &'b [DAffine3]),
        buffers: &'b Buffers<'_>,
    ) -> Result<Option<Self>, LoadError> {
        let mut sets = Vec::new();
        // Sets count without gaps.
        for set in 0.. {
            let names = [format!("JOINTS_{set}"), format!("WEIGHTS_{set}")];
            let [Some(&joints), Some(&weights)] =
                [&names[0], &names[1]].map(|name| primitive.attributes.get(name))
            else {
                break;
            };
            let place = |name: &str| format!("{place}.attributes.{name}");
            let joints = elements(root, joints, || place(&names[0]), &JOINTS, buffers)?;
            let weights = elements(root, weights, || place(&names[1]), &WEIGHTS, buffers)?;
            sets.push([joints, weights]);
        }
        Ok((!sets.is_empty()).then_some(Self { sets, skin, joints }))
    }

    /// The lists that have an element for each vertex.
    pub fn lists(&self) -> impl Iterator<Item = (&'static str, usize)> {
        let sets = self.sets.iter();
        sets.flat_map(|[joints, weights]| [("joints", joints.len()), ("weights", weights.len())])
    }

    /// The weighted mean of the joints' transforms. Without weights, that of the first joint.
    pub fn transform(&self, vertex: usize, part: &str) -> Result<DAffine3, GltfError> {
        let mut sum = DAffine3 {
            matrix3: glam::DMat3::ZERO,
            translation: DVec3::ZERO,
        };
        let mut total = 0.0;
        for [joints, weights] in &self.sets {
            let weights = weights.numbers::<4>(vertex);
            for (joint, weight) in joints.unsigned::<4>(vertex).into_iter().zip(weights) {
                if weight != 0.0 {
                    let transform = self.joint(joint, vertex, part)?;
                    sum.matrix3 += transform.matrix3 * weight;
                    sum.translation += transform.translation * weight;
                    total += weight;
                }
            }
        }
        if total == 0.0 {
            let [first, ..] = self.sets[0][0].unsigned::<4>(vertex);
            return self.joint(first, vertex, part);
        }
        Ok(DAffine3 {
            matrix3: sum.matrix3 * (1.0 / total),
            translation: sum.translation / total,
        })
    }

    fn joint(&self, joint: u32, vertex: usize, part: &str) -> Result<DAffine3, GltfError> {
        let found = self.joints.get(joint as usize).copied();
        found.ok_or_else(|| GltfError::JointOutOfRange {
            part: excerpt(part),
            vertex,
            joint,
            skin: self.skin,
            count: self.joints.len(),
        })
    }
}

/// The morph targets of a primitive that have a weight.
pub(super) struct Morph<'b> {
    targets: Vec<Target<'b>>,
}

struct Target<'b> {
    weight: f64,
    positions: Option<Elements<'b>>,
    normals: Option<Elements<'b>>,
}

impl<'b> Morph<'b> {
    pub fn new(
        root: &Root,
        primitive: &Primitive,
        place: &str,
        weights: &[f64],
        buffers: &'b Buffers<'_>,
    ) -> Result<Self, LoadError> {
        let mut targets = Vec::new();
        for (i, (target, &weight)) in primitive.targets.iter().zip(weights).enumerate() {
            if weight == 0.0 {
                continue;
            }
            let read = |target: &Attributes, name: &str| {
                let place = || format!("{place}.targets[{i}].{name}");
                let accessor = target.get(name);
                let read = |&accessor| elements(root, accessor, place, &VECTORS, buffers);
                accessor.map(read).transpose()
            };
            targets.push(Target {
                weight,
                positions: read(target, "POSITION")?,
                normals: read(target, "NORMAL")?,
            });
        }
        Ok(Self { targets })
    }

    /// Whether nothing is moved.
    pub const fn is_empty(&self) -> bool {
        self.targets.is_empty()
    }

    /// The lists that have an element for each vertex.
    pub fn lists(&self) -> impl Iterator<Item = (&'static str, usize)> {
        self.targets.iter().flat_map(|target| {
            let positions = target.positions.as_ref();
            let normals = target.normals.as_ref();
            let positions = positions.map(|list| ("morph target positions", list.len()));
            positions
                .into_iter()
                .chain(normals.map(|list| ("morph target normals", list.len())))
        })
    }

    pub fn position(&self, vertex: usize, at: DVec3) -> DVec3 {
        self.targets
            .iter()
            .fold(at, |at, target| match &target.positions {
                Some(list) => at + DVec3::from_array(list.numbers(vertex)) * target.weight,
                None => at,
            })
    }

    pub fn normal(&self, vertex: usize, normal: DVec3) -> DVec3 {
        self.targets
            .iter()
            .fold(normal, |normal, target| match &target.normals {
                Some(list) => normal + DVec3::from_array(list.numbers(vertex)) * target.weight,
                None => normal,
            })
    }
}
