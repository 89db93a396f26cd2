//! Stage `gather` on the GPU: meshes in buffers of any layout.

use super::buffer::{Range, Slot};
use super::mesh::check_words;
use super::program::{Recorder, Uniform, threads};
use super::{Gpu, GpuError, Kernel, Mesh, Misfit};
use wgpu::{BufferSlice, BufferUsages, IndexFormat};

/// Bytes of a position, and of a triangle's three indices as kernels read them.
pub const ELEMENT_BYTES: u64 = 12;

/// Vertices in a buffer of the caller's: a position of three `f32` anywhere in each.
///
/// ```no_run
/// use slimbvh::gpu::{VertexLayout, wgpu};
/// # fn run(vertices: &wgpu::Buffer) {
/// // Four bytes of color, then the position.
/// let layout = VertexLayout { slice: vertices.slice(..), stride: 16, offset: 4 };
/// # }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct VertexLayout<'a> {
    /// From the first vertex to the end of the last, beginning at a multiple of 4 bytes. The buffer has the usage `STORAGE`.
    pub slice: BufferSlice<'a>,
    /// Bytes from one vertex to the next, a multiple of 4: wgpu's `array_stride`.
    pub stride: u64,
    /// Where a vertex has its position, in bytes, a multiple of 4: the `offset` of wgpu's attribute.
    pub offset: u64,
}

/// Indices in a buffer of the caller's, three a triangle.
///
/// ```no_run
/// use slimbvh::gpu::{IndexLayout, wgpu};
/// # fn run(indices: &wgpu::Buffer) {
/// // The first 100 triangles, two bytes an index.
/// let slice = indices.slice(..2 * 3 * 100);
/// let layout = IndexLayout { slice, format: wgpu::IndexFormat::Uint16 };
/// # }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct IndexLayout<'a> {
    /// From the first index to the end of the last, beginning at a multiple of an index's size. The buffer has the usage `STORAGE`.
    pub slice: BufferSlice<'a>,
    /// How large an index is.
    pub format: IndexFormat,
}

/// What a list is gathered from.
#[derive(Clone, Debug, PartialEq)]
pub struct Source {
    /// Words that hold the list.
    pub words: Range,
    /// Elements of the list: vertices or triangles.
    pub count: u64,
    /// As the kernel takes them.
    params: [u32; 4],
}

impl Source {
    /// Bytes of the list without gaps.
    pub fn tight_bytes(&self) -> u64 {
        self.count * ELEMENT_BYTES
    }
}

impl VertexLayout<'_> {
    /// What the positions are gathered from.
    ///
    /// # Errors
    /// If the numbers do not fit each other, or the buffer cannot be bound.
    pub(super) fn source(&self, gpu: &Gpu) -> Result<Source, GpuError> {
        const NAME: &str = "the buffer of vertices";
        let Self { stride, offset, .. } = *self;
        for (number, bytes) in [("stride", stride), ("position's offset", offset)] {
            if !bytes.is_multiple_of(4) {
                return Err(Misfit::UnalignedNumber { number, bytes }.of(NAME));
            }
        }
        if offset > stride || stride - offset < ELEMENT_BYTES {
            return Err(Misfit::PositionOutside { offset, stride }.of(NAME));
        }
        let range = Range::of_slice(self.slice);
        check_whole(NAME, &range, ("vertices", stride))?;
        let (words, skipped_bytes) = check_words(gpu, NAME, &range, 4)?;
        let first = (skipped_bytes + offset) / 4;
        Ok(Source {
            count: range.size / stride,
            params: [first as u32, (stride / 4) as u32, 0, 0],
            words,
        })
    }

    /// Whether kernels can read positions in place, as far as gaps go.
    pub(super) const fn is_tight(&self) -> bool {
        self.stride == ELEMENT_BYTES && self.offset == 0
    }
}

impl IndexLayout<'_> {
    /// What the indices are gathered from.
    ///
    /// # Errors
    /// If they are no whole triangles, or the buffer cannot be bound.
    pub(super) fn source(&self, gpu: &Gpu) -> Result<Source, GpuError> {
        const NAME: &str = "the buffer of indices";
        let index_bytes = self.format.byte_size() as u64;
        let range = Range::of_slice(self.slice);
        check_whole(NAME, &range, ("indices", index_bytes))?;
        let index_count = range.size / index_bytes;
        if !index_count.is_multiple_of(3) {
            return Err(Misfit::PartialTriangle { index_count }.of(NAME));
        }
        let (words, skipped_bytes) = check_words(gpu, NAME, &range, index_bytes)?;
        let first = skipped_bytes / index_bytes;
        Ok(Source {
            count: index_count / 3,
            params: [first as u32, 8 * index_bytes as u32, 0, 0],
            words,
        })
    }
}

/// Refuses a range that is empty or ends within an element.
fn check_whole(
    what: &'static str,
    range: &Range,
    (elements, element_bytes): (&'static str, u64),
) -> Result<(), GpuError> {
    let bytes = range.size;
    if bytes == 0 {
        let fault = Misfit::PartialElement {
            bytes,
            element_bytes,
        };
        return Err(fault.of(what));
    }
    if !bytes.is_multiple_of(element_bytes) {
        let fault = Misfit::PartialElements {
            bytes,
            elements,
            element_bytes,
        };
        return Err(fault.of(what));
    }
    Ok(())
}

/// How kernels take lists without gaps.
const TIGHT: [[u32; 4]; 2] = [[0, 3, 0, 0], [0, 32, 0, 0]];

impl Mesh {
    /// The same mesh, gathered from the caller's buffers where these cannot be copied from.
    pub(super) fn readable(&self, gpu: &Gpu) -> Self {
        let mut mesh = self.clone();
        let labels = ["slimbvh copied vertices", "slimbvh copied indices"];
        let lists = [&mut mesh.vertices, &mut mesh.indices].into_iter();
        let lists = lists.zip(&mut mesh.sources).zip(labels).zip(TIGHT);
        for (((range, source), label), params) in lists {
            if source.is_none() && !range.buffer.usage().contains(BufferUsages::COPY_SRC) {
                let words = range.clone();
                *range = Slot::storage(label).range(gpu, words.size);
                *source = Some(Source {
                    count: words.size / ELEMENT_BYTES,
                    params,
                    words,
                });
            }
        }
        mesh
    }

    /// Stage `gather`, for what is not without gaps.
    pub(super) fn record_gather(&self, recorder: &mut Recorder) {
        let lists = [
            (Kernel::gather_positions, &self.sources[0], &self.vertices),
            (Kernel::gather_indices, &self.sources[1], &self.indices),
        ];
        let lists =
            lists.map(|(kernel, source, to)| source.as_ref().map(|from| (kernel, from, to)));
        if lists.iter().any(Option::is_some) {
            recorder.stage("gather");
        }
        for (kernel, from, to) in lists.into_iter().flatten() {
            let params = [Uniform::Params(from.params)];
            let each = threads(from.count as u32);
            recorder.dispatch(kernel, &params, &[&from.words], &[to], each);
        }
    }
}
