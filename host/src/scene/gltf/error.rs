//! Faults of a glTF scene.

use thiserror::Error;

/// A fault of a glTF scene. Indices count from 0, as in the JSON.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum GltfError {
    /// The JSON cannot be read as glTF 2.0.
    #[error("the JSON is not glTF 2.0: {message}")]
    Json {
        /// The JSON reader's message, with line and column.
        message: String,
    },
    /// The GLB file's header or chunks are broken.
    #[error("the GLB file cannot be taken apart: {message}")]
    Glb {
        /// The GLB reader's message.
        message: String,
    },
    /// The JSON breaks a rule of glTF.
    #[error("{path}: {fault}")]
    Invalid {
        /// The path in the JSON.
        path: String,
        /// The rule that is broken.
        fault: gltf::json::validation::Error,
    },
    /// A primitive's positions are in an accessor that does not exist.
    #[error(
        "mesh {mesh} has its positions in accessor {accessor}, but there are only {accessor_count} accessors"
    )]
    NoAccessor {
        /// The mesh.
        mesh: usize,
        /// The accessor's index.
        accessor: usize,
        /// The number of accessors.
        accessor_count: usize,
    },
    /// A camera has a type without the values of that type.
    #[error("camera {camera} lacks the values of its type")]
    CameraWithoutValues {
        /// The camera.
        camera: usize,
    },
    /// A node is its own ancestor or has two parents.
    #[error("node {node} is reached twice; nodes must form trees")]
    NotATree {
        /// The node.
        node: usize,
    },
    /// The transform or the values of a camera or light give no finite direction.
    #[error("node {node} has a camera or light that points nowhere or is not finite")]
    Degenerate {
        /// The node.
        node: usize,
    },
    /// A buffer is neither base64 nor in a file beside the scene.
    #[error("buffer {buffer} is at \"{uri}\"; files beside the scene and base64 data are read")]
    BufferElsewhere {
        /// The buffer.
        buffer: usize,
        /// Its URI, shortened.
        uri: String,
    },
    /// A buffer without a URI, in a file without a binary chunk.
    #[error("buffer {buffer} has no address, and the file has no binary chunk for it")]
    NoBlob {
        /// The buffer.
        buffer: usize,
    },
    /// A data URI that is not base64.
    #[error("buffer {buffer} is not base64 at character {character}")]
    Base64 {
        /// The buffer.
        buffer: usize,
        /// The first character that is not base64, counted from 0 after the comma.
        character: usize,
    },
    /// A buffer is shorter than it states.
    #[error("buffer {buffer} announces {announced} bytes, {found} are there")]
    BufferCut {
        /// The buffer.
        buffer: usize,
        /// The bytes that it states.
        announced: u64,
        /// The bytes found.
        found: u64,
    },
    /// A buffer view ends beyond its buffer.
    #[error("buffer view {view} ends at byte {end} of buffer {buffer}, which has {length}")]
    ViewBeyondBuffer {
        /// The view.
        view: usize,
        /// Its end.
        end: u64,
        /// The buffer.
        buffer: usize,
        /// The buffer's bytes.
        length: u64,
    },
    /// An accessor ends beyond its buffer view.
    #[error("accessor {accessor} ends at byte {end} of buffer view {view}, which has {length}")]
    AccessorBeyondView {
        /// The accessor.
        accessor: usize,
        /// Its end.
        end: u64,
        /// The view.
        view: usize,
        /// The view's bytes.
        length: u64,
    },
    /// Elements overlap.
    #[error("accessor {accessor} has elements of {size} bytes every {stride} bytes")]
    Overlap {
        /// The accessor.
        accessor: usize,
        /// Bytes of an element.
        size: usize,
        /// Bytes from one element to the next.
        stride: usize,
    },
    /// An accessor has the wrong type for its use.
    #[error("accessor {accessor} holds {found}, but {expected} are needed")]
    WrongType {
        /// The accessor.
        accessor: usize,
        /// Its type.
        found: String,
        /// The type needed.
        expected: &'static str,
    },
    /// More elements without a buffer view than the whole scene has data.
    #[error("accessor {accessor} announces {count} elements without a buffer view")]
    Hollow {
        /// The accessor.
        accessor: usize,
        /// The number that it states.
        count: u64,
    },
    /// A sparse accessor replaces an element out of range.
    #[error("accessor {accessor} replaces element {element}, but there are only {count}")]
    SparseIndex {
        /// The accessor.
        accessor: usize,
        /// The element.
        element: u64,
        /// The number of elements.
        count: u64,
    },
    /// The numbers of positions and normals differ.
    #[error("mesh \"{part}\" has {normals} normals for {positions} positions")]
    NormalCount {
        /// The name of the node or the mesh.
        part: String,
        /// The number of normals.
        normals: usize,
        /// The number of positions.
        positions: usize,
    },
}
