//! Writes files.

use super::check::check;
use super::error::WriteError;
use super::layout::{
    ALIGNMENT, Checksum, Header, ORDER, SECTION_COUNT, Section, SectionRecord, TABLE_END, VERSION,
    halves, magic, to_bytes,
};
use super::records::{
    CameraRecord, HierarchyRecord, LightRecord, MaterialRecord, PartRecord, SceneRecord,
};
use crate::tree::{self, Bvh};
use crate::{Aabb, Scene, Up};
use bytemuck::Pod;
use std::borrow::Cow;
use std::io::Write;

/// Writes a scene, a hierarchy over its mesh, and the box for the default camera if the scene has none
/// ([`Saved::framing`](super::Saved::framing)). Returns the number of bytes.
///
/// # Errors
/// If the content is invalid, before anything is written; [`read`](super::read) accepts every written file. If the
/// operating system refuses.
pub fn write(
    scene: &Scene,
    bvh: &Bvh,
    framing: Option<Aabb>,
    to: impl Write,
) -> Result<u64, WriteError> {
    check(scene, bvh, framing)?;
    write_checked(scene, bvh, framing, to)
}

/// [`write()`], of content that was checked.
pub fn write_checked(
    scene: &Scene,
    bvh: &Bvh,
    framing: Option<Aabb>,
    mut to: impl Write,
) -> Result<u64, WriteError> {
    let parts: Vec<PartRecord> = (scene.mesh.parts.iter())
        .map(|part| PartRecord {
            name_bytes: part.name.len() as u32,
            zero: 0,
            first_triangle: part.first_triangle,
            triangle_count: part.triangle_count,
        })
        .collect();
    let names: Vec<&str> = (scene.mesh.parts.iter())
        .map(|part| part.name.as_str())
        .collect();
    let names = names.concat();
    let materials: Vec<MaterialRecord> = scene.materials.iter().map(Into::into).collect();
    let cameras: Vec<CameraRecord> = scene.cameras.iter().map(Into::into).collect();
    let lights: Vec<LightRecord> = scene.lights.iter().map(Into::into).collect();
    let scenes = [scene_record(scene, framing)];
    let hierarchies = [HierarchyRecord::from(bvh)];
    let mesh = &scene.mesh;
    let [nodes, triangles] = bvh.stored.lists().lists();
    let lists = [
        List::of(Section::Vertices, &mesh.vertices),
        List::of(Section::Indices, &mesh.indices),
        List::of(Section::Normals, &mesh.normals),
        List::of(Section::MaterialIndices, &mesh.materials),
        List::of(Section::Parts, &parts),
        List {
            section: Section::Names,
            item_bytes: 1,
            bytes: Cow::Borrowed(names.as_bytes()),
        },
        List::of(Section::Materials, &materials),
        List::of(Section::Cameras, &cameras),
        List::of(Section::Lights, &lights),
        List::of(Section::Scene, &scenes),
        List::of(Section::Hierarchy, &hierarchies),
        List::stored(Section::Nodes, nodes),
        List::stored(Section::Triangles, triangles),
    ];
    write_lists(&lists, &mut to)
}

/// The scene's record.
pub fn scene_record(scene: &Scene, framing: Option<Aabb>) -> SceneRecord {
    SceneRecord {
        framing: framing.into(),
        dropped_face_count: scene.dropped_face_count.try_into().unwrap_or(u32::MAX),
        is_z_up: u32::from(scene.up == Up::Z),
        origin: SceneRecord::origin_words(scene.origin),
    }
}

/// A section with its items.
struct List<'a> {
    section: Section,
    item_bytes: usize,
    bytes: Cow<'a, [u8]>,
}

impl<'a> List<'a> {
    fn of<T: Pod>(section: Section, items: &'a [T]) -> Self {
        Self {
            section,
            item_bytes: size_of::<T>(),
            bytes: to_bytes(items),
        }
    }

    fn stored(section: Section, list: tree::List<'a>) -> Self {
        Self {
            section,
            item_bytes: list.item_bytes,
            bytes: to_bytes(list.words),
        }
    }
}

fn write_lists(lists: &[List; SECTION_COUNT], to: &mut impl Write) -> Result<u64, WriteError> {
    // The position of each section, and the number of zeros before it.
    let mut end = TABLE_END as u64;
    let mut records = Vec::with_capacity(SECTION_COUNT);
    let mut gaps = Vec::with_capacity(SECTION_COUNT);
    for list in lists {
        let begin = end.next_multiple_of(ALIGNMENT);
        let length = list.bytes.len() as u64;
        gaps.push((begin - end) as usize);
        records.push(SectionRecord {
            kind: list.section as u32,
            item_bytes: list.item_bytes as u32,
            begin: halves(begin),
            length: halves(length),
            zeros: [0; 2],
        });
        end = begin + length;
    }
    let header = |checksum| Header {
        magic: magic(),
        order: ORDER,
        version: VERSION,
        checksum,
        section_count: SECTION_COUNT as u32,
        length: halves(end),
        zeros: [0; 8],
    };
    let head = |checksum| [&*to_bytes(&[header(checksum)]), &*to_bytes(&records)].concat();

    // The checksum is known only at the end, but is stored in the header.
    let mut checksum = Checksum::default();
    let unsigned = head(0);
    checksum.take(&unsigned[..super::layout::CHECKSUM.start]);
    checksum.take(&unsigned[super::layout::CHECKSUM.end..]);
    let zeros = [0; ALIGNMENT as usize];
    for (list, &gap) in lists.iter().zip(&gaps) {
        checksum.take(&zeros[..gap]);
        checksum.take(&list.bytes);
    }
    to.write_all(&head(checksum.finish()))?;
    for (list, &gap) in lists.iter().zip(&gaps) {
        to.write_all(&zeros[..gap])?;
        to.write_all(&list.bytes)?;
    }
    to.flush()?;
    Ok(end)
}
