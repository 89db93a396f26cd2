//! Triangles of a glTF mesh.

use super::super::LoadError;
use super::super::faces::{FaceSite, Run, unit_or_zero};
use super::super::load::Source;
use super::accessor::{Elements, INDICES, VECTORS, elements};
use super::buffers::Buffers;
use super::json::{Index, Primitive, Root};
use super::skin::{Morph, Skinning};
use super::{Faces, GltfError, materials};
use crate::text::excerpt;
use glam::{DAffine3, DMat3, DVec3, Mat3, Vec3};
use std::borrow::Cow;

/// The inputs of reading a primitive.
pub(super) struct Reader<'b, 'a> {
    pub root: &'b Root,
    pub buffers: &'b Buffers<'a>,
    pub source: &'b Source<'a>,
    /// The name of the part.
    pub part: &'b str,
    /// The weights of its morph targets.
    pub weights: &'b [f64],
    /// The skin, and the transforms of its joints.
    pub joints: Option<(usize, &'b [DAffine3])>,
}

/// A primitive's triangles, not yet placed.
pub(super) struct Surface<'b> {
    mode: Mode,
    /// `None` for all positions in order.
    indices: Option<Cow<'b, [u32]>>,
    positions: Elements<'b>,
    normals: Option<Elements<'b>>,
    morph: Morph<'b>,
    skinning: Option<Skinning<'b>>,
    /// The positions that triangles use, sorted; `None` for all.
    used: Option<Vec<u32>>,
    /// The material, if it names one.
    pub material: Option<usize>,
    pub face_count: usize,
}

/// The triangles that corners form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mode {
    Triangles,
    Strip,
    Fan,
}

impl Mode {
    /// The mode with this number; `None` for all that has no triangles.
    pub fn of(number: Option<Index>) -> Option<Self> {
        match number.map_or(4, |number| number.0) {
            4 => Some(Self::Triangles),
            5 => Some(Self::Strip),
            6 => Some(Self::Fan),
            _ => None,
        }
    }
}

impl<'b> Reader<'b, '_> {
    /// The triangles of a primitive, which stands at a place in the JSON. Points, lines and what is invisible are noted.
    pub fn read(
        &self,
        primitive: &Primitive,
        place: &str,
    ) -> Result<Option<Surface<'b>>, LoadError> {
        let fault = |error| self.buffers.fault(error);
        let material = primitive.material.map(|index| {
            let place = || format!("{place}.material");
            self.root.materials.item("materials", index, place)
        });
        let material = material.transpose().map_err(fault)?;
        let Some(mode) = self.mode(primitive, place).map_err(fault)? else {
            return Ok(None);
        };
        if material.is_some_and(materials::is_invisible) {
            self.source.leave_out("invisible primitives (alpha)", 1);
            return Ok(None);
        }
        self.refuse_compressed(primitive, place).map_err(fault)?;
        let Some(positions) = self.vectors(primitive, place, "POSITION")? else {
            self.source.leave_out("primitives without positions", 1);
            return Ok(None);
        };

        // Read the lists.
        let indices = primitive.indices.map(|index| {
            let place = || format!("{place}.indices");
            elements(self.root, index, place, &INDICES, self.buffers)
        });
        let indices = indices.transpose()?.map(Elements::into_unsigned);
        let normals = self.vectors(primitive, place, "NORMAL")?;
        let morph = Morph::new(self.root, primitive, place, self.weights, self.buffers)?;
        let skinning = match self.joints {
            Some(joints) => Skinning::new(self.root, primitive, place, joints, self.buffers)?,
            None => None,
        };
        let counts = normals.iter().map(|list| ("normals", list.len()));
        let counts = counts.chain(morph.lists());
        let mut counts = counts.chain(skinning.iter().flat_map(Skinning::lists));
        if let Some((what, found)) = counts.find(|(_, count)| *count != positions.len()) {
            return Err(fault(GltfError::AttributeCount {
                part: excerpt(self.part),
                what: what.into(),
                found,
                positions: positions.len(),
            }));
        }
        drop(counts);
        if primitive.attributes.contains_key("COLOR_0") {
            self.source.leave_out("vertex colours", positions.len());
        }

        let corner_count = indices.as_ref().map_or(positions.len(), |list| list.len());
        let face_count = triangle_count(mode, corner_count);
        let spare = match mode {
            Mode::Triangles => corner_count % 3,
            _ if face_count == 0 => corner_count,
            _ => 0,
        };
        (self.source).leave_out("corners without a triangle", spare);
        let has_variants = primitive.extensions.contains_key("KHR_materials_variants");
        (self.source).leave_out("primitives with material variants", {
            usize::from(has_variants)
        });
        if face_count == 0 {
            return Ok(None);
        }
        Ok(Some(Surface {
            used: used(indices.as_deref(), positions.len(), face_count),
            mode,
            indices,
            positions,
            normals,
            morph,
            skinning,
            material: primitive.material.map(|index| index.0),
            face_count,
        }))
    }

    /// The mode; `None` for points and lines.
    fn mode(&self, primitive: &Primitive, place: &str) -> Result<Option<Mode>, GltfError> {
        if let Some(mode) = Mode::of(primitive.mode) {
            return Ok(Some(mode));
        }
        let corners = primitive
            .indices
            .or(primitive.attributes.get("POSITION").copied());
        let corners = corners.and_then(|accessor| self.root.accessors.get(accessor.0));
        let corners = corners.map_or(0, |accessor| accessor.count.0);
        let (what, count) = match primitive.mode.unwrap_or(Index(4)).0 {
            0 => ("points", corners),
            1 => ("lines", corners / 2),
            2 => ("lines", corners),
            3 => ("lines", corners.saturating_sub(1)),
            value => {
                return Err(GltfError::UnknownValue {
                    place: format!("{place}.mode"),
                    value,
                    expected: "a mode of primitives",
                });
            }
        };
        self.source.leave_out(what, count);
        Ok(None)
    }

    /// Refuses a compressed primitive unless its accessors have data, too.
    fn refuse_compressed(&self, primitive: &Primitive, place: &str) -> Result<(), GltfError> {
        const DRACO: &str = "KHR_draco_mesh_compression";
        if !primitive.extensions.contains_key(DRACO) {
            return Ok(());
        }
        let has_data = |index: &Index| {
            let accessor = self.root.accessors.get(index.0);
            accessor.is_none_or(|it| it.buffer_view.is_some() || it.sparse.is_some())
        };
        let attribute = |name: &str| primitive.attributes.get(name);
        let is_plain = attribute("POSITION").is_some_and(has_data)
            && attribute("NORMAL").is_none_or(has_data)
            && primitive.indices.as_ref().is_none_or(has_data);
        match is_plain {
            true => Ok(()),
            false => Err(GltfError::Compressed {
                place: place.into(),
                extension: DRACO.into(),
            }),
        }
    }

    fn vectors(
        &self,
        primitive: &Primitive,
        place: &str,
        name: &str,
    ) -> Result<Option<Elements<'b>>, LoadError> {
        let place = || format!("{place}.attributes.{name}");
        let accessor = primitive.attributes.get(name);
        let read = |&accessor| elements(self.root, accessor, place, &VECTORS, self.buffers);
        accessor.map(read).transpose()
    }
}

impl Surface<'_> {
    /// Whether it follows joints instead of its node.
    pub const fn is_skinned(&self) -> bool {
        self.skinning.is_some()
    }

    /// Adds the triangles to a part. A transform that mirrors turns them around, so that their front stays outside.
    pub fn place(
        &self,
        transform: DAffine3,
        part: &str,
        is_lenient: bool,
        faces: &mut Faces<'_>,
    ) -> Result<(), PlaceError> {
        let site = |face| FaceSite {
            line: None,
            part: Some(part),
            face,
        };
        let count = self.vertex_count();
        let run = faces.next_run(count)?;
        let broken = self.first_broken_face();
        if !is_lenient && let Some(face) = broken {
            let count = self.positions.len();
            faces.polygon(&self.corners(face), Run { count, ..run }, site(face))?;
        }
        let is_mirrored = self.place_vertices(transform, part, is_lenient, faces)?;
        let place = |corner: i64| match &self.used {
            None => corner,
            // An index out of range stays out of range.
            Some(used) => match used.binary_search(&(corner as u32)) {
                Ok(place) => place as i64,
                Err(_) => count as i64,
            },
        };
        for face in 0..self.face_count {
            let mut corners = self.corners(face).map(place);
            if is_mirrored.of(corners[0]) {
                corners.swap(1, 2);
            }
            match broken {
                None => faces.cut(3, |i| run.first + corners[i] as u32)?,
                Some(_) => faces.polygon(&corners, run, site(face))?,
            }
        }
        Ok(())
    }

    /// Adds the vertices and their normals.
    fn place_vertices(
        &self,
        transform: DAffine3,
        part: &str,
        is_lenient: bool,
        faces: &mut Faces<'_>,
    ) -> Result<Mirrored, GltfError> {
        let is_still = self.skinning.is_none() && transform == DAffine3::IDENTITY;
        let first = faces.vertices.len();
        let count = self.vertex_count();
        faces.vertices.reserve(count);
        let vertex = |i: usize| self.used.as_ref().map_or(i, |used| used[i] as usize);
        let position = |vertex| {
            let position = DVec3::from_array(self.positions.numbers(vertex));
            self.morph.position(vertex, position)
        };
        let normal = |list: &Elements<'_>, vertex| {
            self.morph
                .normal(vertex, DVec3::from_array(list.numbers(vertex)))
        };
        if self.normals.is_some() {
            faces.mesh.normals.resize(first, [0.0; 3]);
            faces.mesh.normals.reserve(count);
        }

        let mirrored = if let Some(skinning) = &self.skinning {
            let mut mirrored = Vec::with_capacity(count);
            for vertex in (0..count).map(vertex) {
                let transform = match skinning.transform(vertex, part) {
                    // The faces of the vertex are dropped.
                    Err(_) if is_lenient => DAffine3::from_translation(DVec3::NAN),
                    transform => transform?,
                };
                let at = transform.transform_point3(position(vertex));
                faces.vertices.push(at.to_array());
                if let Some(normals) = &self.normals {
                    let turn = normal_matrix(transform.matrix3);
                    let normal = normal(normals, vertex);
                    faces.mesh.normals.push(turned(turn, normal));
                }
                mirrored.push(transform.matrix3.determinant() < 0.0);
            }
            Mirrored::Some(mirrored)
        } else {
            let placed = |at: DVec3| match is_still {
                true => at.to_array(),
                false => transform.transform_point3(at).to_array(),
            };
            // Most files have plain lists.
            let is_plain = self.used.is_none() && self.morph.is_empty();
            match self.positions.floats().filter(|_| is_plain) {
                Some(list) => faces.vertices.extend(list.map(|at| placed(wide(at)))),
                None => {
                    let all = (0..count).map(|i| placed(position(vertex(i))));
                    faces.vertices.extend(all);
                }
            }
            if let Some(normals) = &self.normals {
                let turn = normal_matrix(transform.matrix3);
                let list = &mut faces.mesh.normals;
                match normals.floats().filter(|_| is_plain) {
                    Some(normals) => list.extend(normals.map(|normal| turned(turn, wide(normal)))),
                    None => {
                        let all = (0..count).map(|i| turned(turn, normal(normals, vertex(i))));
                        list.extend(all);
                    }
                }
            }
            Mirrored::All(transform.matrix3.determinant() < 0.0)
        };
        if !faces.mesh.normals.is_empty() {
            faces.mesh.normals.resize(first + count, [0.0; 3]);
        }
        Ok(mirrored)
    }

    /// The number of vertices that are placed.
    pub fn vertex_count(&self) -> usize {
        self.used.as_ref().map_or(self.positions.len(), Vec::len)
    }

    /// The number of their normals.
    pub fn normal_count(&self) -> usize {
        self.normals.as_ref().map_or(0, |_| self.vertex_count())
    }

    /// The positions of a triangle's corners.
    fn corners(&self, face: usize) -> [i64; 3] {
        let corners = corners(self.mode, face);
        match &self.indices {
            Some(indices) => corners.map(|corner| i64::from(indices[corner])),
            None => corners.map(|corner| corner as i64),
        }
    }

    /// The first triangle with an index out of range.
    fn first_broken_face(&self) -> Option<usize> {
        let count = self.positions.len();
        let is_broken = |&index: &u32| index as usize >= count;
        if !self.indices.as_ref()?.iter().any(is_broken) {
            return None;
        }
        let is_outside = |corner: i64| corner as usize >= count;
        (0..self.face_count).find(|&face| self.corners(face).into_iter().any(is_outside))
    }
}

/// Whether transforms turn triangles around.
enum Mirrored {
    All(bool),
    /// By vertex.
    Some(Vec<bool>),
}

impl Mirrored {
    /// By the first corner of the triangle.
    fn of(&self, corner: i64) -> bool {
        match self {
            Self::All(all) => *all,
            Self::Some(list) => list.get(corner as usize).is_some_and(|it| *it),
        }
    }
}

/// Why a surface cannot be placed.
pub(super) enum PlaceError {
    Gltf(GltfError),
    Load(LoadError),
}

impl From<GltfError> for PlaceError {
    fn from(error: GltfError) -> Self {
        Self::Gltf(error)
    }
}

impl From<LoadError> for PlaceError {
    fn from(error: LoadError) -> Self {
        Self::Load(error)
    }
}

/// The positions that triangles use, if these are far fewer than all: many primitives can share one list.
fn used(indices: Option<&[u32]>, position_count: usize, face_count: usize) -> Option<Vec<u32>> {
    if position_count <= 3 * face_count {
        return None;
    }
    let is_there = |index: &u32| (*index as usize) < position_count;
    let mut used: Vec<u32> = match indices {
        Some(indices) => indices.iter().copied().filter(is_there).collect(),
        None => return None,
    };
    used.sort_unstable();
    used.dedup();
    Some(used)
}

pub(super) const fn triangle_count(mode: Mode, corner_count: usize) -> usize {
    match mode {
        Mode::Triangles => corner_count / 3,
        _ => corner_count.saturating_sub(2),
    }
}

/// The indices of a triangle's corners; glTF 2.0, section 3.7.2.1.
const fn corners(mode: Mode, face: usize) -> [usize; 3] {
    match mode {
        Mode::Strip => [face, face + 1 + face % 2, face + 2 - face % 2],
        Mode::Fan => [face + 1, face + 2, 0],
        Mode::Triangles => [3 * face, 3 * face + 1, 3 * face + 2],
    }
}

fn wide(vector: [f32; 3]) -> DVec3 {
    Vec3::from_array(vector).as_dvec3()
}

/// The turned normal, with length 1. Zero (flat shading) if it has no direction.
fn turned(turn: Mat3, normal: DVec3) -> [f32; 3] {
    unit_or_zero((turn * normal.as_vec3()).to_array())
}

/// The inverse transpose up to a positive factor, defined also for singular matrices. Its largest number is 1.
fn normal_matrix(m: DMat3) -> Mat3 {
    let cofactors = DMat3::from_cols(
        m.y_axis.cross(m.z_axis),
        m.z_axis.cross(m.x_axis),
        m.x_axis.cross(m.y_axis),
    );
    let numbers = cofactors.to_cols_array();
    let largest = numbers.into_iter().map(f64::abs).fold(0.0, f64::max);
    let sign = if m.determinant() < 0.0 { -1.0 } else { 1.0 };
    (cofactors * (sign / largest)).as_mat3()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strips_keep_their_winding() {
        let strip = |face| corners(Mode::Strip, face);
        assert_eq!(
            [strip(0), strip(1), strip(2)],
            [[0, 1, 2], [1, 3, 2], [2, 3, 4]]
        );
        assert_eq!(corners(Mode::Fan, 1), [2, 3, 0]);
        assert_eq!(triangle_count(Mode::Strip, 5), 3);
        assert_eq!(triangle_count(Mode::Fan, 1), 0);
        assert_eq!(triangle_count(Mode::Triangles, 8), 2);
    }

    #[test]
    fn normals_stay_perpendicular_and_outside() {
        // A plane x + y = 1 stretched by 2 along x becomes x/2 + y = 1, at any size.
        let scaled = |x, y, z| normal_matrix(DMat3::from_diagonal(DVec3::new(x, y, z)));
        for size in [1.0, 1e-30, 1e30] {
            let stretched = scaled(2.0 * size, size, size);
            let expected = unit_or_zero([1.0, 2.0, 0.0]);
            assert_eq!(turned(stretched, DVec3::new(1.0, 1.0, 0.0)), expected);
        }
        let mirrored = scaled(-1.0, 2.0, 3.0);
        assert_eq!(turned(mirrored, DVec3::X), [-1.0, 0.0, 0.0]);
        assert_eq!(turned(mirrored, DVec3::Y), [0.0, 1.0, 0.0]);
        assert_eq!(turned(scaled(0.0, 0.0, 3.0), DVec3::X), [0.0; 3]);
        assert_eq!(turned(mirrored, DVec3::NAN), [0.0; 3]);
    }

    #[test]
    fn positions_that_no_triangle_uses_are_left_out() {
        assert_eq!(used(Some(&[5, 9, 5]), 10, 1), Some(vec![5, 9]));
        assert_eq!(used(Some(&[5, 99, 5]), 10, 1), Some(vec![5]));
        assert_eq!(used(Some(&[2, 1, 0]), 3, 1), None);
        assert_eq!(used(None, 30, 1), None);
    }
}
