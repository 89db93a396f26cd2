//! What is wrong with a glTF scene.

use thiserror::Error;

/// What is wrong with a glTF scene. Indices count from 0, as in the JSON.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum GltfError {
    /// The JSON cannot be read as glTF 2.0.
    #[error("the JSON is not glTF 2.0: {message}")]
    Json {
        /// What the JSON reader says, with line and column.
        message: String,
    },
    /// The GLB file's header or chunks are broken.
    #[error("the GLB file cannot be taken apart: {message}")]
    Glb {
        /// What the GLB reader says.
        message: String,
    },
    /// The JSON breaks a rule of glTF.
    #[error("{path}: {fault}")]
    Invalid {
        /// Where in the JSON.
        path: String,
        /// Which rule.
        fault: gltf::json::validation::Error,
    },
    /// A primitive's positions are in an accessor that does not exist.
    #[error(
        "mesh {mesh} has its positions in accessor {accessor}, but there are only {accessor_count} accessors"
    )]
    NoAccessor {
        /// The mesh.
        mesh: usize,
        /// The accessor that it names.
        accessor: usize,
        /// How many there are.
        accessor_count: usize,
    },
    /// A camera's type announces values that are absent.
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
    /// A camera or a light whose transform or values make it point nowhere.
    #[error("node {node} has a camera or light that points nowhere or is not finite")]
    Degenerate {
        /// The node.
        node: usize,
    },
    /// A buffer is neither in the file nor beside it.
    #[error("buffer {buffer} is at \"{uri}\"; files beside the scene and base64 data are read")]
    BufferElsewhere {
        /// The buffer.
        buffer: usize,
        /// Where it is, shortened.
        uri: String,
    },
    /// A buffer without an address, in a file that brings none.
    #[error("buffer {buffer} has no address, and the file has no binary chunk for it")]
    NoBlob {
        /// The buffer.
        buffer: usize,
    },
    /// A data address that is not base64.
    #[error("buffer {buffer} is not base64 at character {character}")]
    Base64 {
        /// The buffer.
        buffer: usize,
        /// The first character that does not belong, counted from 0 after the comma.
        character: usize,
    },
    /// A buffer is shorter than announced.
    #[error("buffer {buffer} announces {announced} bytes, {found} are there")]
    BufferCut {
        /// The buffer.
        buffer: usize,
        /// How many bytes it announces.
        announced: u64,
        /// How many there are.
        found: u64,
    },
    /// A buffer view reaches beyond its buffer.
    #[error("buffer view {view} ends at byte {end} of buffer {buffer}, which has {length}")]
    ViewBeyondBuffer {
        /// The view.
        view: usize,
        /// Where it ends.
        end: u64,
        /// The buffer.
        buffer: usize,
        /// The buffer's bytes.
        length: u64,
    },
    /// An accessor reaches beyond its buffer view.
    #[error("accessor {accessor} ends at byte {end} of buffer view {view}, which has {length}")]
    AccessorBeyondView {
        /// The accessor.
        accessor: usize,
        /// Where it ends.
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
        /// Bytes from one to the next.
        stride: usize,
    },
    /// An accessor has the wrong type for its use.
    #[error("accessor {accessor} holds {found}, but {expected} are needed")]
    WrongType {
        /// The accessor.
        accessor: usize,
        /// What it holds.
        found: String,
        /// What it is used as.
        expected: &'static str,
    },
    /// More elements without a buffer view than there is data in the whole scene.
    #[error("accessor {accessor} announces {count} elements without a buffer view")]
    Hollow {
        /// The accessor.
        accessor: usize,
        /// How many it announces.
        count: u64,
    },
    /// A sparse accessor replaces an element that it does not have.
    #[error("accessor {accessor} replaces element {element}, but there are only {count}")]
    SparseIndex {
        /// The accessor.
        accessor: usize,
        /// The element.
        element: u64,
        /// How many there are.
        count: u64,
    },
    /// Positions and normals differ in number.
    #[error("mesh \"{part}\" has {normals} normals for {positions} positions")]
    NormalCount {
        /// The name of the node or the mesh.
        part: String,
        /// How many normals there are.
        normals: usize,
        /// How many positions there are.
        positions: usize,
    },
}
