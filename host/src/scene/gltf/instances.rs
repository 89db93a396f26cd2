//! Instances of a node's mesh (`EXT_mesh_gpu_instancing`).

use super::super::LoadError;
use super::super::error::excerpt;
use super::super::load::Source;
use super::GltfError;
use super::accessor::{Component, Elements, Expected, VECTORS, elements};
use super::buffers::Buffers;
use super::json::{Index, Instancing, Root};
use super::nodes::trs;
use glam::DAffine3;

/// Attributes that are read.
const READ: [&str; 3] = ["TRANSLATION", "ROTATION", "SCALE"];

const ROTATIONS: Expected = Expected {
    shape: "VEC4",
    width: 4,
    is_fit: |kind| kind.is_float() || matches!(kind, Component::I8 | Component::I16),
    name: "quaternions of floats or signed shares",
};

/// The accessor whose count is the number of instances.
pub(super) fn counting(instancing: &Instancing) -> Option<Index> {
    READ.iter()
        .find_map(|name| instancing.attributes.get(*name).copied())
}

/// The instances of a node.
pub(super) struct Instances<'b> {
    translations: Option<Elements<'b>>,
    rotations: Option<Elements<'b>>,
    scales: Option<Elements<'b>>,
    /// Their number.
    pub count: usize,
}

impl<'b> Instances<'b> {
    /// `None` if no attribute that is read states their number: then they are all in one place. Other attributes are noted.
    pub fn new(
        root: &Root,
        node: usize,
        instancing: &Instancing,
        (buffers, source): (&'b Buffers<'_>, &Source<'_>),
    ) -> Result<Option<Self>, LoadError> {
        let mut count = None;
        let mut read = |attribute: &'static str, expected: &Expected| {
            let Some(&accessor) = instancing.attributes.get(attribute) else {
                return Ok(None);
            };
            let place = || {
                format!("nodes[{node}].extensions.EXT_mesh_gpu_instancing.attributes.{attribute}")
            };
            let list = elements(root, accessor, place, expected, buffers)?;
            let expected = *count.get_or_insert(list.len());
            if list.len() != expected {
                return Err(buffers.fault(GltfError::InstanceCount {
                    node,
                    attribute,
                    found: list.len(),
                    expected,
                }));
            }
            Ok(Some(list))
        };
        let translations = read("TRANSLATION", &VECTORS)?;
        let rotations = read("ROTATION", &ROTATIONS)?;
        let scales = read("SCALE", &VECTORS)?;
        let own = instancing.attributes.iter();
        let own = own.filter(|(name, _)| !READ.contains(&name.as_str()));
        for (name, accessor) in own {
            let count = root
                .accessors
                .get(accessor.0)
                .map_or(0, |it| it.count.0)
                .max(1);
            let what = format!("values of instances by {}", excerpt(name));
            source.leave_out(&what, count);
        }
        Ok(count.map(|count| Self {
            translations,
            rotations,
            scales,
            count,
        }))
    }

    /// The transform of an instance to its node.
    pub fn transform(&self, instance: usize) -> DAffine3 {
        let translation = self
            .translations
            .as_ref()
            .map(|list| list.numbers(instance));
        let rotation = self.rotations.as_ref().map(|list| list.numbers(instance));
        let scale = self.scales.as_ref().map(|list| list.numbers(instance));
        trs(
            translation.unwrap_or_default(),
            rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]),
            scale.unwrap_or([1.0; 3]),
        )
    }
}
