//! Records of parts, materials, cameras, lights, the scene and the hierarchy.

use crate::tree::{Bvh, MeshCodec, NodeCodec, StoredTree, TagError, tagged, tags};
use crate::{AreaShape, Camera, Light, Material, Projection};
use bytemuck::{Pod, Zeroable};
use slimbvh_core::encode::RootWords;
use slimbvh_core::{Aabb, Vec3};

/// A part. 16 bytes.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub struct PartRecord {
    /// Bytes 0–3: length of its name.
    pub name_bytes: u32,
    /// Bytes 4–7: zero.
    pub zero: u32,
    /// Bytes 8–11.
    pub first_triangle: u32,
    /// Bytes 12–15.
    pub triangle_count: u32,
}

/// A material. 32 bytes.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub struct MaterialRecord {
    /// Bytes 0–11.
    base_color: [f32; 3],
    /// Bytes 12–15.
    mirror: f32,
    /// Bytes 16–19.
    transmission: f32,
    /// Bytes 20–23.
    ior: f32,
    /// Bytes 24–27: 1 for a single-sided material, 0 for a double-sided one.
    single_sided: u32,
    /// Bytes 28–31: zero.
    zero: u32,
}

const _: () = assert!(size_of::<MaterialRecord>() == 32);

impl From<&Material> for MaterialRecord {
    fn from(material: &Material) -> Self {
        Self {
            base_color: material.base_color,
            mirror: material.mirror,
            transmission: material.transmission,
            ior: material.ior,
            single_sided: u32::from(!material.double_sided),
            zero: 0,
        }
    }
}

impl From<&MaterialRecord> for Material {
    fn from(record: &MaterialRecord) -> Self {
        Self {
            base_color: record.base_color,
            mirror: record.mirror,
            transmission: record.transmission,
            ior: record.ior,
            double_sided: record.single_sided == 0,
        }
    }
}

/// A camera. 64 bytes.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub struct CameraRecord {
    /// Bytes 0–11.
    eye: [f32; 3],
    /// Bytes 12–15: 0 perspective, 1 thin lens, 2 parallel.
    kind: u32,
    /// Bytes 16–27.
    target: [f32; 3],
    /// Bytes 28–31: degrees, or the picture's height.
    extent: f32,
    /// Bytes 32–43.
    up: [f32; 3],
    /// Bytes 44–47: the lens's radius.
    radius: f32,
    /// Bytes 48–51: the distance in focus.
    focus_distance: f32,
    /// Bytes 52–63: zeros.
    zeros: [u32; 3],
}

const _: () = assert!(size_of::<CameraRecord>() == 64);

impl From<&Camera> for CameraRecord {
    fn from(camera: &Camera) -> Self {
        let (kind, extent, radius, focus_distance) = match camera.projection {
            Projection::Perspective { vertical_fov } => (0, vertical_fov, 0.0, 0.0),
            Projection::ThinLens {
                vertical_fov,
                radius,
                focus_distance,
            } => (1, vertical_fov, radius, focus_distance),
            Projection::Orthographic { height } => (2, height, 0.0, 0.0),
        };
        Self {
            eye: camera.eye,
            kind,
            target: camera.target,
            extent,
            up: camera.up,
            radius,
            focus_distance,
            zeros: [0; 3],
        }
    }
}

impl CameraRecord {
    /// `None` for an unknown kind.
    pub fn camera(&self) -> Option<Camera> {
        let projection = match self.kind {
            0 => Projection::Perspective {
                vertical_fov: self.extent,
            },
            1 => Projection::ThinLens {
                vertical_fov: self.extent,
                radius: self.radius,
                focus_distance: self.focus_distance,
            },
            2 => Projection::Orthographic {
                height: self.extent,
            },
            _ => return None,
        };
        Some(Camera {
            eye: self.eye,
            target: self.target,
            up: self.up,
            projection,
        })
    }
}

/// A light. 64 bytes.
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[repr(C)]
pub struct LightRecord {
    /// Bytes 0–11.
    color: [f32; 3],
    /// Bytes 12–15: 0 sun, 1 point, 2 disc, 3 rectangle.
    kind: u32,
    /// Bytes 16–27: the direction of a sun's light, or the position of another light.
    place: [f32; 3],
    /// Bytes 28–31: zero for a sun.
    range: f32,
    /// Bytes 32–43: first half edge.
    edge_1: [f32; 3],
    /// Bytes 44–47: zero.
    zero_1: u32,
    /// Bytes 48–59: second half edge.
    edge_2: [f32; 3],
    /// Bytes 60–63: zero.
    zero_2: u32,
}

const _: () = assert!(size_of::<LightRecord>() == 64);

impl From<&Light> for LightRecord {
    fn from(light: &Light) -> Self {
        match *light {
            Light::Directional { direction, color } => Self {
                color,
                place: direction,
                ..Self::default()
            },
            Light::Point {
                position,
                color,
                range,
            } => Self {
                color,
                kind: 1,
                place: position,
                range,
                ..Self::default()
            },
            Light::Area {
                center,
                half_edges: [edge_1, edge_2],
                shape,
                color,
                range,
            } => Self {
                color,
                kind: match shape {
                    AreaShape::Disc => 2,
                    AreaShape::Rectangle => 3,
                },
                place: center,
                range,
                edge_1,
                edge_2,
                ..Self::default()
            },
        }
    }
}

impl LightRecord {
    /// `None` for an unknown kind.
    pub fn light(&self) -> Option<Light> {
        let (place, color, range) = (self.place, self.color, self.range);
        let area = |shape| Light::Area {
            center: place,
            half_edges: [self.edge_1, self.edge_2],
            shape,
            color,
            range,
        };
        match self.kind {
            0 => Some(Light::Directional {
                direction: place,
                color,
            }),
            1 => Some(Light::Point {
                position: place,
                color,
                range,
            }),
            2 => Some(area(AreaShape::Disc)),
            3 => Some(area(AreaShape::Rectangle)),
            _ => None,
        }
    }
}

/// An optional box. 32 bytes.
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[repr(C)]
pub struct BoxRecord {
    /// Bytes 0–11.
    min: [f32; 3],
    /// Bytes 12–15: 1 if there is a box.
    is_there: u32,
    /// Bytes 16–27.
    max: [f32; 3],
    /// Bytes 28–31: zero.
    zero: u32,
}

impl From<Option<Aabb>> for BoxRecord {
    fn from(bounds: Option<Aabb>) -> Self {
        bounds.map_or_else(Self::default, |bounds| Self {
            min: bounds.min.to_array(),
            is_there: 1,
            max: bounds.max.to_array(),
            zero: 0,
        })
    }
}

impl From<&BoxRecord> for Option<Aabb> {
    fn from(record: &BoxRecord) -> Self {
        (record.is_there != 0).then(|| Aabb {
            min: Vec3::from_array(record.min),
            max: Vec3::from_array(record.max),
        })
    }
}

/// Facts of the scene besides its lists. 64 bytes.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub struct SceneRecord {
    /// Bytes 0–31: the box for the default camera.
    pub framing: BoxRecord,
    /// Bytes 32–35: faces that a lenient loader dropped.
    pub dropped_face_count: u32,
    /// Bytes 36–39: 1 if z points up, else 0.
    pub is_z_up: u32,
    /// Bytes 40–63: the local origin, three `f64`, their low words first.
    pub origin: [[u32; 2]; 3],
}

impl SceneRecord {
    /// The words of a local origin.
    pub fn origin_words(origin: [f64; 3]) -> [[u32; 2]; 3] {
        let words = |bits: u64| [bits as u32, (bits >> 32) as u32];
        origin.map(|x| words(x.to_bits()))
    }

    /// The local origin; `None` if it is not finite.
    pub fn origin(&self) -> Option<[f64; 3]> {
        let bits = |[low, high]: [u32; 2]| u64::from(low) | u64::from(high) << 32;
        let origin = self.origin.map(|words| f64::from_bits(bits(words)));
        origin.iter().all(|x| x.is_finite()).then_some(origin)
    }
}

const _: () = assert!(size_of::<SceneRecord>() == 64);

/// A hierarchy, without its lists. 128 bytes.
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[repr(C)]
pub struct HierarchyRecord {
    /// Bytes 0–3: the tag of the nodes' codec.
    nodes: u32,
    /// Bytes 4–7: the bits of a lattice plane, else 0.
    bits: u32,
    /// Bytes 8–11: the tag of the triangles' codec.
    triangles: u32,
    /// Bytes 12–15.
    pub triangle_count: u32,
    /// Bytes 16–19.
    mesh_triangle_count: u32,
    /// Bytes 20–23.
    depth_bound: u32,
    /// Bytes 24–27.
    scene_exponent: i32,
    /// Bytes 28–31: the exponent of the lattice's step at the scene's magnitude, else 0.
    step_exponent: i32,
    /// Bytes 32–63: the mesh's bounds.
    bounds: BoxRecord,
    /// Bytes 64–75: floats or integers, depending on the codec; 0 in full.
    root_min: [u32; 3],
    /// Bytes 76–79: zero.
    zero_1: u32,
    /// Bytes 80–91: as `root_min`.
    root_max: [u32; 3],
    /// Bytes 92–95: zero.
    zero_2: u32,
    /// Bytes 96–127: zeros.
    zeros: [u32; 8],
}

const _: () = assert!(size_of::<HierarchyRecord>() == 128);

impl From<&Bvh> for HierarchyRecord {
    fn from(bvh: &Bvh) -> Self {
        let [nodes, bits, triangles] = tags(bvh.codecs());
        let root = bvh.root_words().unwrap_or_default();
        let ([a, b, c, _], [x, y, z, _]) = (root.low, root.high);
        Self {
            nodes,
            bits,
            triangles,
            triangle_count: bvh.triangle_count() as u32,
            mesh_triangle_count: bvh.mesh_triangle_count as u32,
            depth_bound: bvh.depth_bound,
            scene_exponent: bvh.scene_exponent,
            step_exponent: root.step_exponent(),
            bounds: bvh.bounds.into(),
            root_min: [a, b, c],
            root_max: [x, y, z],
            ..Self::default()
        }
    }
}

impl HierarchyRecord {
    /// The codecs of its lists.
    ///
    /// # Errors
    /// For tags that mean none.
    pub fn codecs(&self) -> Result<(NodeCodec, MeshCodec), TagError> {
        let tags = [self.nodes, self.bits, self.triangles];
        tagged(tags, self.step_exponent.wrapping_sub(self.scene_exponent))
    }

    /// The root's box and the lattice's step.
    pub fn root(&self) -> RootWords {
        let ([a, b, c], [x, y, z]) = (self.root_min, self.root_max);
        RootWords {
            low: [a, b, c, self.step_exponent as u32],
            high: [x, y, z, 0],
        }
    }

    /// The hierarchy with these lists.
    pub fn bvh(&self, stored: StoredTree) -> Bvh {
        Bvh {
            stored,
            mesh_triangle_count: self.mesh_triangle_count as usize,
            bounds: (&self.bounds).into(),
            scene_exponent: self.scene_exponent,
            depth_bound: self.depth_bound,
        }
    }
}
