//! The members of a glTF 2.0 document that are read. All others are skipped, so none of them can refuse a file.

use super::list::List;
use serde::de::{Deserializer, Error, IgnoredAny, Unexpected, Visitor};
use serde::{Deserialize, de::DeserializeOwned};
use serde_json::Value;
use serde_json::value::RawValue;
use std::collections::BTreeMap;
use std::fmt;

/// A document. Objects refer to each other by their places in these lists.
#[derive(Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Root {
    pub asset: Asset,
    pub scene: Option<Index>,
    pub scenes: List<Scene>,
    pub nodes: List<Node>,
    pub meshes: List<Mesh>,
    pub skins: List<Skin>,
    pub cameras: List<Camera>,
    pub materials: List<Material>,
    pub accessors: List<Accessor>,
    pub buffer_views: List<BufferView>,
    pub buffers: List<Buffer>,
    /// Only counted.
    pub animations: Value,
    pub extensions_used: List<String>,
    pub extensions_required: List<String>,
    #[serde(deserialize_with = "lenient")]
    pub extensions: RootExtensions,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(super) struct Asset {
    /// A string; some files have a number.
    pub version: Value,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(super) struct RootExtensions {
    #[serde(rename = "KHR_lights_punctual", deserialize_with = "lenient")]
    pub lights: Lights,
    #[serde(flatten)]
    pub others: Others,
}

/// Extensions that are not read, by their names.
pub(super) type Others = BTreeMap<String, IgnoredAny>;

#[derive(Default, Deserialize)]
#[serde(default)]
pub(super) struct Lights {
    pub lights: List<Light>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(super) struct Scene {
    #[serde(deserialize_with = "or_default")]
    pub nodes: Vec<Index>,
    #[serde(deserialize_with = "lenient")]
    pub extensions: Others,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(super) struct Node {
    #[serde(deserialize_with = "text")]
    pub name: Option<String>,
    #[serde(deserialize_with = "or_default")]
    pub children: Vec<Index>,
    /// By columns.
    pub matrix: Option<[f64; 16]>,
    pub translation: Option<[f64; 3]>,
    pub rotation: Option<[f64; 4]>,
    pub scale: Option<[f64; 3]>,
    pub mesh: Option<Index>,
    pub skin: Option<Index>,
    pub camera: Option<Index>,
    #[serde(deserialize_with = "or_default")]
    pub weights: Vec<f64>,
    #[serde(deserialize_with = "or_default")]
    pub extensions: NodeExtensions,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(super) struct NodeExtensions {
    #[serde(rename = "KHR_lights_punctual")]
    pub light: Option<LightOfNode>,
    #[serde(rename = "EXT_mesh_gpu_instancing")]
    pub instancing: Option<Instancing>,
    #[serde(rename = "KHR_node_visibility")]
    pub visibility: Option<Visibility>,
    #[serde(rename = "MSFT_lod")]
    pub levels: Option<Levels>,
    #[serde(flatten)]
    pub others: Others,
}

#[derive(Deserialize)]
pub(super) struct LightOfNode {
    pub light: Index,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(super) struct Instancing {
    #[serde(deserialize_with = "or_default")]
    pub attributes: Attributes,
}

#[derive(Deserialize)]
pub(super) struct Visibility {
    pub visible: Option<bool>,
}

/// Nodes that stand for this one at a distance.
#[derive(Default, Deserialize)]
#[serde(default)]
pub(super) struct Levels {
    #[serde(deserialize_with = "or_default")]
    pub ids: Vec<Index>,
}

/// Accessors by their meaning.
pub(super) type Attributes = BTreeMap<String, Index>;

#[derive(Default, Deserialize)]
#[serde(default)]
pub(super) struct Mesh {
    #[serde(deserialize_with = "text")]
    pub name: Option<String>,
    #[serde(deserialize_with = "or_default")]
    pub primitives: Vec<Primitive>,
    #[serde(deserialize_with = "or_default")]
    pub weights: Vec<f64>,
    #[serde(deserialize_with = "lenient")]
    pub extensions: Others,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(super) struct Primitive {
    #[serde(deserialize_with = "or_default")]
    pub attributes: Attributes,
    pub indices: Option<Index>,
    pub material: Option<Index>,
    pub mode: Option<Index>,
    #[serde(deserialize_with = "or_default")]
    pub targets: Vec<Attributes>,
    #[serde(deserialize_with = "lenient")]
    pub extensions: BTreeMap<String, Value>,
}

#[derive(Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Skin {
    pub inverse_bind_matrices: Option<Index>,
    #[serde(deserialize_with = "or_default")]
    pub joints: Vec<Index>,
    #[serde(deserialize_with = "lenient")]
    pub extensions: Others,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(super) struct Camera {
    pub perspective: Option<Perspective>,
    pub orthographic: Option<Orthographic>,
    #[serde(rename = "type")]
    pub kind: String,
    #[serde(deserialize_with = "lenient")]
    pub extensions: Others,
}

#[derive(Deserialize)]
pub(super) struct Perspective {
    pub yfov: f32,
}

#[derive(Deserialize)]
pub(super) struct Orthographic {
    pub ymag: f32,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub(super) struct Light {
    #[serde(rename = "type")]
    pub kind: String,
    pub color: Option<[f32; 3]>,
    pub intensity: Option<f32>,
    pub range: Option<f32>,
    #[serde(deserialize_with = "lenient")]
    pub extensions: Others,
}

#[derive(Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Material {
    #[serde(deserialize_with = "or_default")]
    pub pbr_metallic_roughness: Roughness,
    pub normal_texture: Value,
    pub occlusion_texture: Value,
    pub emissive_texture: Value,
    pub emissive_factor: Option<[f32; 3]>,
    pub alpha_mode: Option<String>,
    pub alpha_cutoff: Option<f32>,
    pub double_sided: Option<bool>,
    #[serde(deserialize_with = "lenient")]
    pub extensions: BTreeMap<String, Value>,
}

#[derive(Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Roughness {
    pub base_color_factor: Option<[f32; 4]>,
    pub base_color_texture: Value,
    pub metallic_factor: Option<f32>,
    pub roughness_factor: Option<f32>,
    pub metallic_roughness_texture: Value,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Accessor {
    pub buffer_view: Option<Index>,
    #[serde(default)]
    pub byte_offset: Index,
    pub component_type: Index,
    #[serde(default)]
    pub normalized: bool,
    pub count: Index,
    #[serde(rename = "type")]
    pub shape: String,
    pub sparse: Option<Sparse>,
    #[serde(default, deserialize_with = "lenient")]
    pub extensions: Others,
}

#[derive(Deserialize)]
pub(super) struct Sparse {
    pub count: Index,
    pub indices: SparseIndices,
    pub values: SparseValues,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct SparseIndices {
    pub buffer_view: Index,
    #[serde(default)]
    pub byte_offset: Index,
    pub component_type: Index,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct SparseValues {
    pub buffer_view: Index,
    #[serde(default)]
    pub byte_offset: Index,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct BufferView {
    pub buffer: Index,
    #[serde(default)]
    pub byte_offset: Index,
    pub byte_length: Index,
    pub byte_stride: Option<Index>,
    #[serde(default, deserialize_with = "lenient")]
    pub extensions: BTreeMap<String, Value>,
}

#[derive(Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Buffer {
    pub uri: Option<String>,
    pub byte_length: Index,
    #[serde(deserialize_with = "lenient")]
    pub extensions: BTreeMap<String, Value>,
}

/// An index or a count. glTF 2.0 accepts `3.0` for `3`.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Index(pub usize);

impl<'de> Deserialize<'de> for Index {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct Whole;

        impl Visitor<'_> for Whole {
            type Value = Index;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a whole number that is not negative")
            }

            fn visit_u64<E: Error>(self, number: u64) -> Result<Index, E> {
                let number = usize::try_from(number);
                number
                    .map(Index)
                    .map_err(|_| E::custom("a number is too large"))
            }

            fn visit_f64<E: Error>(self, number: f64) -> Result<Index, E> {
                // Below 2^53 all whole numbers are exact.
                let is_whole = number.fract() == 0.0 && (0.0..9e15).contains(&number);
                match is_whole {
                    true => self.visit_u64(number as u64),
                    false => Err(E::invalid_value(Unexpected::Float(number), &self)),
                }
            }
        }
        from.deserialize_any(Whole)
    }
}

/// A text; anything else is none.
fn text<'de, D: Deserializer<'de>>(from: D) -> Result<Option<String>, D::Error> {
    match Value::deserialize(from)? {
        Value::String(text) => Ok(Some(text)),
        _ => Ok(None),
    }
}

/// Takes anything of a wrong type for a missing member.
fn lenient<'de, T, D>(from: D) -> Result<T, D::Error>
where
    T: Default + DeserializeOwned,
    D: Deserializer<'de>,
{
    let raw = <&RawValue>::deserialize(from)?;
    Ok(serde_json::from_str(raw.get()).unwrap_or_default())
}

/// Takes `null` for a missing member.
fn or_default<'de, T, D>(from: D) -> Result<T, D::Error>
where
    T: Default + DeserializeOwned,
    D: Deserializer<'de>,
{
    Ok(Option::<T>::deserialize(from)?.unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_in_any_notation() {
        let index = |text: &str| {
            serde_json::from_str::<Index>(text)
                .map(|index| index.0)
                .ok()
        };
        assert_eq!(index("7"), Some(7));
        assert_eq!(index("7.0"), Some(7));
        assert_eq!(index("7e2"), Some(700));
        assert_eq!(index("18446744073709551615"), Some(usize::MAX));
        for wrong in ["-1", "7.5", "-0.5", "1e300", "\"7\"", "null", "[7]"] {
            assert_eq!(index(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn members_that_are_not_read_may_hold_anything() {
        let text = r#"{"asset": {"version": 2.0, "extras": [1]}, "images": 7, "textures": null, "samplers": "x",
            "animations": {"a": 1}, "nodes": null, "cameras": 7, "skins": "x", "buffers": {"a": [1]}, "accessors": [{}], "meshes": [3, {"name": 7}], "materials": [{"normalTexture": 3, "extras": {}, "extensions": {"X": [[]]}}]}"#;
        let root: Root = serde_json::from_str(text).expect("it is sound");
        assert_eq!((root.nodes.len(), root.materials.len()), (0, 1));
        assert!(root.accessors.get(0).is_none() && root.accessors.len() == 1);
        assert!(root.meshes.get(1).is_some_and(|mesh| mesh.name.is_none()));
    }
}
