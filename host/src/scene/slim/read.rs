//! Reads files without trusting them.

use super::Saved;
use super::check::check;
use super::error::FileError;
use super::layout::{
    ALIGNMENT, Header, MAGIC, ORDER, SECTION_COUNT, Section, SectionRecord, TABLE_END, VERSION,
    checksum, from_bytes, whole,
};
use super::records::{
    CameraRecord, HierarchyRecord, LightRecord, MaterialRecord, PartRecord, SceneRecord,
};
use super::write::scene_record;
use crate::text::excerpt;
use crate::tree::{Bvh, ListReader, StoredTree, TagError};
use crate::{Aabb, Mesh, Part, Scene, Up};
use bytemuck::Pod;

/// The scene and the hierarchy in a file's bytes, which may be mapped memory. Allocates at most as many bytes as there are,
/// plus a bit for each triangle.
///
/// The result is sound, whatever the bytes are: [`Mesh::validate`] and [`Bvh::validate_over`] have passed, and cameras,
/// lights and materials can be used.
///
/// # Errors
/// The first fault found. Every change of a single byte, or of a run of up to four, is found.
pub fn read(bytes: &[u8]) -> Result<Saved, FileError> {
    let file = Sections::read(bytes)?;
    let (scene, framing) = scene(&file)?;
    let bvh = hierarchy(&file)?;
    if file.are_without_scene() && bvh.mesh_triangle_count() > 0 {
        return Err(FileError::NoScene);
    }
    check(&scene, &bvh, framing)?;
    Ok(Saved {
        scene,
        bvh,
        framing,
    })
}

/// The header, after the check of the checksum.
fn header(bytes: &[u8]) -> Result<Header, FileError> {
    let begin = &bytes[..bytes.len().min(MAGIC.len())];
    if *begin != MAGIC[..begin.len()] {
        let shown = &bytes[..bytes.len().min(16)];
        return Err(FileError::NotSlim {
            found: excerpt(&String::from_utf8_lossy(shown)),
        });
    }
    let cut = FileError::HeaderCut {
        found: bytes.len(),
        expected: TABLE_END,
    };
    let head = bytes.get(..size_of::<Header>()).ok_or(cut.clone())?;
    let header = from_bytes::<Header>(head)[0];
    let (order, version) = (header.order, header.version);
    if order == ORDER.swap_bytes() {
        return Err(FileError::BigEndian);
    }
    if order != ORDER {
        return Err(FileError::ByteOrder { mark: order });
    }
    if version != VERSION {
        return Err(FileError::Version { version });
    }
    let (announced, found) = (whole(header.length), bytes.len() as u64);
    if announced != found {
        return Err(FileError::Length { announced, found });
    }
    if bytes.len() < TABLE_END {
        return Err(cut);
    }
    let computed = checksum(bytes);
    if header.checksum != computed {
        return Err(FileError::Checksum {
            stored: header.checksum,
            computed,
        });
    }
    Ok(header)
}

/// The positions of the sections.
pub(super) struct Sections<'a> {
    bytes: [&'a [u8]; SECTION_COUNT],
    records: Vec<SectionRecord>,
}

impl<'a> Sections<'a> {
    /// The sections of a file whose header and checksum are right.
    pub fn read(bytes: &'a [u8]) -> Result<Self, FileError> {
        Self::of(bytes, &header(bytes)?)
    }

    /// Whether the file is that of a hierarchy alone: no geometry, materials, cameras or lights, and no facts of a scene.
    pub fn are_without_scene(&self) -> bool {
        let (lists, rest) = self.bytes.split_at(Section::Scene as usize - 1);
        lists.iter().all(|list| list.is_empty()) && rest[0].iter().all(|&byte| byte == 0)
    }

    /// Checks that all sections are in order, each directly after the one before, with zeros in between.
    fn of(bytes: &'a [u8], header: &Header) -> Result<Self, FileError> {
        if header.section_count as usize != SECTION_COUNT {
            return Err(FileError::SectionCount {
                count: header.section_count,
            });
        }
        let records: Vec<SectionRecord> = from_bytes(&bytes[size_of::<Header>()..TABLE_END]);
        zeros(bytes, 32, size_of::<Header>())?;
        let mut sections = [&[][..]; SECTION_COUNT];
        let mut end = TABLE_END;
        for ((section, record), to) in Section::ALL.into_iter().zip(&records).zip(&mut sections) {
            if record.kind != section as u32 {
                return Err(FileError::Kind {
                    section,
                    kind: record.kind,
                });
            }
            let record_end = size_of::<Header>() + section as usize * size_of::<SectionRecord>();
            zeros(bytes, record_end - 8, record_end)?;
            let expected = end.next_multiple_of(ALIGNMENT as usize) as u64;
            let (begin, length) = (whole(record.begin), whole(record.length));
            if begin != expected {
                return Err(FileError::Place {
                    section,
                    begin,
                    expected,
                });
            }
            let section_end = begin.saturating_add(length);
            let is_last = section == Section::Triangles;
            let file_end = bytes.len() as u64;
            if section_end > file_end || is_last && section_end != file_end {
                return Err(FileError::End {
                    section,
                    end: section_end,
                    length: file_end,
                });
            }
            // Both are within the file in memory, so they fit.
            let (begin, section_end) = (begin as usize, section_end as usize);
            zeros(bytes, end, begin)?;
            *to = &bytes[begin..section_end];
            end = section_end;
        }
        Ok(Self {
            bytes: sections,
            records,
        })
    }

    /// A section's bytes, if its items have this size.
    fn bytes(&self, section: Section, expected: usize) -> Result<&'a [u8], FileError> {
        let place = section as usize - 1;
        let (bytes, record) = (self.bytes[place], &self.records[place]);
        if record.item_bytes as usize != expected {
            return Err(FileError::ItemBytes {
                section,
                item_bytes: record.item_bytes,
                expected,
            });
        }
        if bytes.len() % expected != 0 {
            return Err(FileError::CutItem {
                section,
                length: bytes.len() as u64,
                item_bytes: expected,
            });
        }
        Ok(bytes)
    }

    /// A section's items.
    fn items<T: Pod>(&self, section: Section) -> Result<Vec<T>, FileError> {
        Ok(from_bytes(self.bytes(section, size_of::<T>())?))
    }

    /// A section's only item.
    fn item<T: Pod>(&self, section: Section) -> Result<T, FileError> {
        let items = self.items::<T>(section)?;
        match items[..] {
            [item] => Ok(item),
            _ => Err(FileError::Count {
                section,
                count: items.len(),
            }),
        }
    }

    /// The values of a section's records. Each record must be exactly as it would be written.
    fn records<R, T>(
        &self,
        section: Section,
        parse: impl Fn(&R) -> Option<T>,
    ) -> Result<Vec<T>, FileError>
    where
        R: Pod + for<'r> From<&'r T>,
    {
        let records = self.items::<R>(section)?;
        let item = |(item, record)| {
            parse(record)
                .filter(|it| is_same(&R::from(it), record))
                .ok_or(FileError::Record { section, item })
        };
        records.iter().enumerate().map(item).collect()
    }
}

fn is_same<R: Pod>(a: &R, b: &R) -> bool {
    bytemuck::bytes_of(a) == bytemuck::bytes_of(b)
}

/// Checks that all bytes between two positions are zero.
fn zeros(bytes: &[u8], from: usize, to: usize) -> Result<(), FileError> {
    match bytes[from..to].iter().position(|&byte| byte != 0) {
        Some(offset) => Err(FileError::NotZero {
            at: (from + offset) as u64,
        }),
        None => Ok(()),
    }
}

/// The scene, and the box for the default camera.
pub(super) fn scene(file: &Sections) -> Result<(Scene, Option<Aabb>), FileError> {
    let record: SceneRecord = file.item(Section::Scene)?;
    let framing = (&record.framing).into();
    let scene = Scene {
        mesh: Mesh {
            vertices: file.items(Section::Vertices)?,
            indices: file.items(Section::Indices)?,
            normals: file.items(Section::Normals)?,
            materials: file.items(Section::MaterialIndices)?,
            parts: parts(file)?,
        },
        materials: file.records(Section::Materials, |record: &MaterialRecord| {
            Some(record.into())
        })?,
        cameras: file.records(Section::Cameras, CameraRecord::camera)?,
        lights: file.records(Section::Lights, LightRecord::light)?,
        dropped_face_count: record.dropped_face_count as usize,
        left_out: Vec::new(),
        origin: record.origin().unwrap_or_default(),
        up: if record.is_z_up == 1 { Up::Z } else { Up::Y },
    };
    if is_same(&scene_record(&scene, framing), &record) {
        Ok((scene, framing))
    } else {
        Err(FileError::Record {
            section: Section::Scene,
            item: 0,
        })
    }
}

/// The parts, with their names.
fn parts(file: &Sections) -> Result<Vec<Part>, FileError> {
    let records: Vec<PartRecord> = file.items(Section::Parts)?;
    let mut names = file.bytes(Section::Names, 1)?;
    let mut parts = Vec::with_capacity(records.len());
    for (part, record) in records.iter().enumerate() {
        if record.zero != 0 {
            return Err(FileError::Record {
                section: Section::Parts,
                item: part,
            });
        }
        let fault = FileError::Name { part };
        let split = names.split_at_checked(record.name_bytes as usize);
        let (name, rest) = split.ok_or(fault.clone())?;
        names = rest;
        parts.push(Part {
            name: str::from_utf8(name).map_err(|_| fault)?.into(),
            first_triangle: record.first_triangle,
            triangle_count: record.triangle_count,
        });
    }
    if names.is_empty() {
        Ok(parts)
    } else {
        Err(FileError::Name { part: parts.len() })
    }
}

/// The hierarchy, unchecked except that its lists are whole.
pub(super) fn hierarchy(file: &Sections) -> Result<Bvh, FileError> {
    let section = Section::Hierarchy;
    let record: HierarchyRecord = file.item(section)?;
    let fault = FileError::Record { section, item: 0 };
    let codecs = record.codecs().map_err(|error| match error {
        TagError::Unknown => fault.clone(),
        TagError::Laboratory { bits } => FileError::LabCodec { bits },
    })?;
    let count = record.triangle_count as usize;
    let stored = StoredTree::read(codecs, &record.root(), count, &mut &*file)?;
    let bvh = record.bvh(stored);
    if is_same(&HierarchyRecord::from(&bvh), &record) {
        Ok(bvh)
    } else {
        Err(fault)
    }
}

impl ListReader for &Sections<'_> {
    type Error = FileError;

    fn nodes<T: Pod>(&mut self, per_node: usize) -> Result<Vec<T>, FileError> {
        let bytes = self.bytes(Section::Nodes, per_node * size_of::<T>())?;
        Ok(from_bytes(bytes))
    }

    fn triangles<T: Pod>(&mut self) -> Result<Vec<T>, FileError> {
        self.items(Section::Triangles)
    }
}
