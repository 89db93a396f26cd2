//! Why something of the caller's does not fit its use.

use super::GpuError;
use thiserror::Error;
use wgpu::TextureFormat;

/// What is wrong with something of the caller's: the end of a sentence that begins with its name.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum Misfit {
    /// A buffer or texture cannot be used in this way.
    #[error("was made without the usage {usage}")]
    MissingUsage {
        /// Name of the usage, as wgpu has it.
        usage: &'static str,
    },
    /// A range begins where the adapter cannot bind it.
    #[error("begins at byte {offset}, which is no multiple of {alignment}")]
    MisalignedOffset {
        /// Where the range begins, in bytes.
        offset: u64,
        /// What the adapter needs a multiple of, in bytes.
        alignment: u64,
    },
    /// A range is empty, or ends within an element.
    #[error("has {bytes} bytes, which is not one element of {element_bytes} bytes or more")]
    PartialElement {
        /// The range's size.
        bytes: u64,
        /// An element's size.
        element_bytes: u64,
    },
    /// A range ends within a vertex or an index.
    #[error("has {bytes} bytes, which are no whole {elements} of {element_bytes} bytes")]
    PartialElements {
        /// The range's size.
        bytes: u64,
        /// What its elements are.
        elements: &'static str,
        /// An element's size.
        element_bytes: u64,
    },
    /// A range ends within a triangle.
    #[error("has {index_count} indices, which are no whole triangles")]
    PartialTriangle {
        /// Indices in the range.
        index_count: u64,
    },
    /// A number of a layout is not in words.
    #[error("has a {number} of {bytes} bytes, which is no multiple of 4")]
    UnalignedNumber {
        /// Which number.
        number: &'static str,
        /// The number.
        bytes: u64,
    },
    /// Positions reach beyond their vertices.
    #[error("has positions of 12 bytes at byte {offset} of vertices of {stride} bytes")]
    PositionOutside {
        /// Where a vertex has its position.
        offset: u64,
        /// Bytes from one vertex to the next.
        stride: u64,
    },
    /// A range's last word is not in the buffer: kernels read words.
    #[error("ends at byte {end}, within a word; make it a multiple of 4 bytes long")]
    EndsWithinWord {
        /// Where the range ends.
        end: u64,
    },
    /// A range cannot be copied: only whole words can.
    #[error("is to be read from byte {offset} for {bytes} bytes, which are not multiples of 4")]
    PartialWord {
        /// Where the range begins, in bytes.
        offset: u64,
        /// The range's size.
        bytes: u64,
    },
    /// The answers of all rays do not fit in.
    #[error("has {bytes} bytes, but {ray_count} rays have answers of {answer_bytes} bytes each")]
    TooFewAnswers {
        /// The buffer's size.
        bytes: u64,
        /// Rays.
        ray_count: u64,
        /// Size of the answer to a ray.
        answer_bytes: u64,
    },
    /// The ends of all rays are not there.
    #[error("has {bytes} bytes, but {ray_count} rays have ends of 16 bytes each")]
    TooFewEnds {
        /// The buffer's size.
        bytes: u64,
        /// Rays.
        ray_count: u64,
    },
    /// A number is not one word.
    #[error("has {bytes} bytes; pass a slice of one `u32`")]
    NotOneWord {
        /// The slice's size.
        bytes: u64,
    },
    /// More bits than indices can number.
    #[error("take {bytes} bytes; fewer than {limit_bytes} can be numbered")]
    TooManyBits {
        /// The size of the bits.
        bytes: u64,
        /// The least size that is too large.
        limit_bytes: u64,
    },
    /// A texture is smaller than the picture.
    #[error(
        "has {}x{} texels, the picture {}x{}",
        .texture[0], .texture[1], .picture[0], .picture[1]
    )]
    TextureTooSmall {
        /// Width and height of the texture, in texels.
        texture: [u32; 2],
        /// Width and height of the picture, in pixels.
        picture: [u32; 2],
    },
    /// No kernel writes texels of this format.
    #[error(
        "is of format {format:?}; take Rgba32Float, Rgba8Unorm, Bgra8Unorm, or their Srgb kinds"
    )]
    TextureFormat {
        /// The texture's format.
        format: TextureFormat,
    },
    /// A mesh is not the one whose surfaces are known, by its counts.
    #[error(
        "has {triangle_count} triangles and {vertex_count} vertices, but its surfaces {} and {}",
        .surfaces[0], .surfaces[1]
    )]
    OtherMesh {
        /// Triangles of the mesh.
        triangle_count: u64,
        /// Vertices of the mesh.
        vertex_count: u64,
        /// Triangles and vertices of the surfaces.
        surfaces: [u64; 2],
    },
    /// An eye was decided for other components.
    #[error("has the sides of {has} components, not of {needs}")]
    OtherComponents {
        /// Entries of its sides.
        has: u64,
        /// Entries that are needed.
        needs: u64,
    },
    /// A rule's sides were set or decided for the components of another mesh.
    #[error("has sides of other components; set or decide them for these")]
    OthersSides,
    /// A scene was not loaded.
    #[error("is not on the GPU; load it first")]
    NotLoaded,
    /// A hierarchy was not built.
    #[error("is empty; build it first")]
    NotBuilt,
    /// A set has more triangles than its memory holds, so that it is empty.
    #[error("has {count} triangles and memory for {limit}: its rays go through the whole tree")]
    DoesNotFit {
        /// Triangles of the set.
        count: u32,
        /// Triangles that there is memory for.
        limit: u32,
    },
    /// A picture was not rendered.
    #[error("is empty; render first")]
    NotRendered,
    /// A target was neither set nor decided.
    #[error("is empty; set or decide it first")]
    NotDecided,
    /// Nothing was measured.
    #[error("know no mesh; measure one first")]
    NotMeasured,
    /// A builder has no mesh to take the scene's exponent from.
    #[error("has seen no mesh; sort, build or refit one first")]
    NoMesh,
    /// There are no WGSL functions for its codec.
    #[error("is stored in a codec; functions for WGSL take one in full, or of wide nodes")]
    InCodec,
    /// A hierarchy in a codec is refitted from nodes in full, which its builder keeps of the last one only.
    #[error("is in a codec and was not built last by this builder; build it again")]
    NotBuiltLast,
}

impl Misfit {
    /// The error of something that this is wrong with.
    pub(super) const fn of(self, what: &'static str) -> GpuError {
        GpuError::Unfit { what, fault: self }
    }
}
