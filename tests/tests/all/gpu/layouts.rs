//! Meshes in the caller's buffers of any layout.

use super::builds::same_tree;
use proptest::prelude::*;
use slimbvh::generate::soup;
use slimbvh::gpu::{self, Gpu, GpuError, IndexLayout, VertexLayout, wgpu};
use slimbvh::{BuildConfig, CodeBits, Mesh};
use slimbvh_tests::gpu::{contents, done, gpu, storage};
use slimbvh_tests::{build, cases};
use wgpu::IndexFormat::{self, Uint16, Uint32};

/// Where a mesh lies in two buffers. All numbers are bytes.
#[derive(Clone, Copy, Debug)]
struct Layout {
    begin: u64,
    stride: u64,
    offset: u64,
    index_begin: u64,
    format: IndexFormat,
}

/// Garbage wherever the layout has no mesh.
const GARBAGE: u8 = 0xa5;

impl Layout {
    fn vertices(&self, mesh: &Mesh) -> Vec<u8> {
        let size = self.begin + self.stride * mesh.vertices.len() as u64;
        let mut bytes = vec![GARBAGE; size as usize + 64];
        for (i, vertex) in mesh.vertices.iter().enumerate() {
            let at = (self.begin + self.stride * i as u64 + self.offset) as usize;
            bytes[at..at + 12].copy_from_slice(bytemuck::bytes_of(vertex));
        }
        bytes
    }

    fn indices(&self, mesh: &Mesh) -> Vec<u8> {
        let mut bytes = vec![GARBAGE; self.index_begin as usize];
        for &index in mesh.indices.iter().flatten() {
            match self.format {
                Uint16 => bytes.extend((index as u16).to_le_bytes()),
                Uint32 => bytes.extend(index.to_le_bytes()),
            }
        }
        bytes.resize(bytes.len().next_multiple_of(4), GARBAGE);
        bytes
    }

    fn place(
        &self,
        gpu: &Gpu,
        mesh: &Mesh,
        buffers: &[wgpu::Buffer; 2],
    ) -> Result<gpu::Mesh, GpuError> {
        let end = self.begin + self.stride * mesh.vertices.len() as u64;
        let index_bytes = self.format.byte_size() as u64 * 3 * mesh.indices.len() as u64;
        let vertices = VertexLayout {
            slice: buffers[0].slice(self.begin..end),
            stride: self.stride,
            offset: self.offset,
        };
        let indices = IndexLayout {
            slice: buffers[1].slice(self.index_begin..self.index_begin + index_bytes),
            format: self.format,
        };
        gpu::Mesh::from_layout(gpu, vertices, indices)
    }
}

/// Builds, moves the vertices in the caller's buffer, and refits; compares both trees with the CPU's. Both buffers are as before
/// but for that.
fn check(gpu: &Gpu, mesh: &Mesh, layout: Layout) -> Result<(), String> {
    let buffers = [
        storage(gpu, &layout.vertices(mesh)),
        storage(gpu, &layout.indices(mesh)),
    ];
    let placed = done(layout.place(gpu, mesh, &buffers));
    assert_eq!(placed.triangle_count() as usize, mesh.indices.len());
    assert!(placed.vertex_buffer() == &buffers[0]);
    let mut builder = gpu::Builder::new(BuildConfig::default());
    let mut bvh = gpu::Bvh::new();
    let mut frame = gpu.frame();
    done(builder.build(&mut frame, &placed, &mut bvh));
    done(frame.submit());
    let mut expected = build(mesh, CodeBits::Bits30);
    same_tree(&done(bvh.download(gpu)), &expected)?;

    let mut moved = mesh.clone();
    for vertex in &mut moved.vertices {
        vertex[1] *= 1.5;
    }
    let bytes = layout.vertices(&moved);
    gpu.queue().write_buffer(placed.vertex_buffer(), 0, &bytes);
    let mut frame = gpu.frame();
    done(builder.refit(&mut frame, &placed, &mut bvh));
    done(frame.submit());
    let mut cpu_builder = slimbvh::Builder::new(BuildConfig::default());
    done(cpu_builder.refit(&moved, &mut expected));
    same_tree(&done(bvh.download(gpu)), &expected)?;
    assert!(contents::<u8>(gpu, &buffers[0]) == bytes);
    assert!(contents::<u8>(gpu, &buffers[1]) == layout.indices(mesh));
    Ok(())
}

#[test]
fn interleaved_vertices_and_short_indices_are_meshes() {
    let Some(gpu) = gpu() else { return };
    let mesh = soup(1235, 5);
    for (begin, stride, offset, index_begin, format) in [
        (0, 12, 0, 0, Uint32),
        (0, 12, 0, 0, Uint16),
        (0, 32, 0, 0, Uint16),
        (0, 32, 20, 0, Uint32),
        (260, 24, 12, 602, Uint16),
        (512, 12, 0, 4, Uint32),
        (4, 12, 0, 1024, Uint32),
        (1028, 16, 4, 2, Uint16),
    ] {
        let layout = Layout {
            begin,
            stride,
            offset,
            index_begin,
            format,
        };
        assert_eq!(check(gpu, &mesh, layout), Ok(()), "{layout:?}");
    }
}

/// The negative control: a layout that is off by one word, or by one index, makes another tree.
#[test]
fn another_layout_makes_another_tree() {
    let Some(gpu) = gpu() else { return };
    let mesh = soup(333, 8);
    let layout = Layout {
        begin: 4,
        stride: 24,
        offset: 4,
        index_begin: 2,
        format: Uint16,
    };
    let buffers = [
        storage(gpu, &layout.vertices(&mesh)),
        storage(gpu, &layout.indices(&mesh)),
    ];
    let tree = |layout: Layout| {
        let placed = done(layout.place(gpu, &mesh, &buffers));
        let (mut builder, mut bvh) = (
            gpu::Builder::new(BuildConfig::default()),
            gpu::Bvh::default(),
        );
        let mut frame = gpu.frame();
        done(builder.build(&mut frame, &placed, &mut bvh));
        done(frame.submit());
        same_tree(&done(bvh.download(gpu)), &build(&mesh, CodeBits::Bits30))
    };
    assert_eq!(tree(layout), Ok(()));
    let others = [
        Layout {
            offset: 8,
            ..layout
        },
        Layout { begin: 8, ..layout },
        Layout {
            index_begin: 0,
            ..layout
        },
    ];
    for other in others {
        assert!(tree(other).is_err(), "{other:?}");
    }
}

proptest! {
    #![proptest_config(cases(12))]

    #[test]
    fn any_layout_makes_the_tree_of_the_tight_mesh(
        (begin, gap, offset, index_begin) in (0u64..80, 0u64..9, 0u64..9, 0u64..80),
        is_short: bool,
        count in 1u32..700,
    ) {
        let Some(gpu) = gpu() else { return Ok(()) };
        let (unit, format) = if is_short { (2, Uint16) } else { (4, Uint32) };
        let layout = Layout {
            begin: 4 * begin,
            stride: 12 + 4 * (gap + offset),
            offset: 4 * offset,
            index_begin: unit * index_begin,
            format,
        };
        prop_assert_eq!(check(gpu, &soup(count, count.into()), layout), Ok(()));
    }
}

/// Sizes that fit by chance are taken by [`gpu::Mesh::from_buffers`]; the layout is refused by name and number.
#[test]
fn layouts_that_do_not_fit_are_refused_by_number() {
    let Some(gpu) = gpu() else { return };
    let words = storage(gpu, &[0u32; 960]);
    let refusal =
        |size: u64, (stride, offset): (u64, u64), indices: std::ops::Range<u64>, format| {
            let vertices = VertexLayout {
                slice: words.slice(..size),
                stride,
                offset,
            };
            let indices = IndexLayout {
                slice: words.slice(indices),
                format,
            };
            match gpu::Mesh::from_layout(gpu, vertices, indices) {
                Err(error @ GpuError::Unfit { .. }) => error.to_string(),
                other => panic!("{other:?}"),
            }
        };
    let good = (32, 0);
    for (expected, found) in [
        (
            "the buffer of vertices has 3190 bytes, which are no whole vertices of 32 bytes",
            refusal(3190, good, 0..600, Uint16),
        ),
        (
            "the buffer of vertices has positions of 12 bytes at byte 24 of vertices of 32 bytes",
            refusal(3200, (32, 24), 0..600, Uint16),
        ),
        (
            "the buffer of vertices has positions of 12 bytes at byte 0 of vertices of 0 bytes",
            refusal(3200, (0, 0), 0..600, Uint16),
        ),
        (
            "the buffer of vertices has a stride of 30 bytes, which is no multiple of 4",
            refusal(3000, (30, 0), 0..600, Uint16),
        ),
        (
            "the buffer of vertices has a position's offset of 6 bytes, which is no multiple of 4",
            refusal(3200, (32, 6), 0..600, Uint16),
        ),
        (
            "the buffer of indices has 301 indices, which are no whole triangles",
            refusal(3200, good, 0..602, Uint16),
        ),
        (
            "the buffer of indices has 602 bytes, which are no whole indices of 4 bytes",
            refusal(3200, good, 0..602, Uint32),
        ),
        (
            "the buffer of indices begins at byte 3, which is no multiple of 2",
            refusal(3200, good, 3..603, Uint16),
        ),
    ] {
        assert_eq!(found, expected);
    }

    let make = |size: u64, usage| {
        gpu.device().create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size,
            usage,
            mapped_at_creation: false,
        })
    };
    let odd = make(606, wgpu::BufferUsages::STORAGE);
    let plain = make(606, wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::INDEX);
    for (buffer, expected) in [
        (
            &odd,
            "ends at byte 606, within a word; make it a multiple of 4 bytes long",
        ),
        (&plain, "was made without the usage STORAGE"),
    ] {
        let vertices = VertexLayout {
            slice: words.slice(..),
            stride: 32,
            offset: 0,
        };
        let indices = IndexLayout {
            slice: buffer.slice(..),
            format: Uint16,
        };
        let error = gpu::Mesh::from_layout(gpu, vertices, indices).err();
        let message = error.map(|error| error.to_string());
        assert_eq!(message, Some(format!("the buffer of indices {expected}")));
    }
}
