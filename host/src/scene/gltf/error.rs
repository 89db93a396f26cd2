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
    /// The file follows another version of glTF.
    #[error(
        "the file is glTF {version}, but slimbvh reads glTF 2.0; convert it, for example with `gltf-pipeline -i in.gltf -o out.glb`"
    )]
    Version {
        /// The file's version.
        version: String,
    },
    /// The GLB file's header or chunks are broken.
    #[error("the GLB file cannot be taken apart: {message}")]
    Glb {
        /// The fault.
        message: String,
    },
    /// A required extension that may change geometry.
    #[error(
        "the file requires the extension \"{name}\", which slimbvh does not know; export it without that extension"
    )]
    UnknownExtension {
        /// The extension.
        name: String,
    },
    /// Geometry in a compression that cannot be decoded.
    #[error(
        "{place} is compressed by {extension}, which slimbvh cannot decode; unpack the file, for example with `gltf-transform copy in.glb out.glb`"
    )]
    Compressed {
        /// The path in the JSON.
        place: String,
        /// The extension.
        extension: String,
    },
    /// An object refers to one that does not exist.
    #[error("{place} is {index}, but the number of {what} is {count}")]
    NoSuch {
        /// The path in the JSON.
        place: String,
        /// The index there.
        index: usize,
        /// The list that it refers to.
        what: &'static str,
        /// The list's length.
        count: usize,
    },
    /// An object lacks a member, or has one of a wrong type.
    #[error("item {index} of the {what} cannot be read: {message}")]
    Unreadable {
        /// The list.
        what: &'static str,
        /// The object's place in it.
        index: usize,
        /// The JSON reader's message.
        message: String,
    },
    /// A number stands for nothing.
    #[error("{place} is {value}, which is not {expected}")]
    UnknownValue {
        /// The path in the JSON.
        place: String,
        /// The number there.
        value: usize,
        /// The values that are known.
        expected: &'static str,
    },
    /// A camera has a type without the values of that type.
    #[error("camera {camera} lacks the values of its type")]
    CameraWithoutValues {
        /// The camera.
        camera: usize,
    },
    /// A camera without a field of view or a height.
    #[error("camera {camera} has {member} {value}, which is not {expected}")]
    CameraExtent {
        /// The camera.
        camera: usize,
        /// `yfov` or `ymag`.
        member: &'static str,
        /// The number there.
        value: String,
        /// The numbers that are sound.
        expected: &'static str,
    },
    /// A node is its own ancestor or has two parents.
    #[error("node {node} is reached twice; nodes must form trees")]
    NotATree {
        /// The node.
        node: usize,
    },
    /// The transform or the values of a camera or light give no finite direction.
    #[error("node {node} has a {what} that points nowhere or is not finite")]
    Degenerate {
        /// The node.
        node: usize,
        /// `camera` or `light`.
        what: &'static str,
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
    /// An attribute has more or fewer elements than there are positions.
    #[error("mesh \"{part}\" has {found} {what} for {positions} positions")]
    AttributeCount {
        /// The name of the node or the mesh.
        part: String,
        /// The attribute, in the plural.
        what: String,
        /// The number of its elements.
        found: usize,
        /// The number of positions.
        positions: usize,
    },
    /// A skin has fewer inverse bind matrices than joints.
    #[error("skin {skin} has {found} inverse bind matrices for {joints} joints")]
    BindMatrices {
        /// The skin.
        skin: usize,
        /// The number of matrices.
        found: usize,
        /// The number of joints.
        joints: usize,
    },
    /// A vertex follows a joint that its skin does not have.
    #[error(
        "mesh \"{part}\", vertex {vertex} follows joint {joint}, but skin {skin} has only {count} joints"
    )]
    JointOutOfRange {
        /// The name of the node or the mesh.
        part: String,
        /// The vertex in its primitive.
        vertex: usize,
        /// The joint.
        joint: u32,
        /// The skin.
        skin: usize,
        /// The number of its joints.
        count: usize,
    },
    /// The lists of a node's instances differ in length.
    #[error("node {node} has {found} instances by {attribute}, but {expected} by the others")]
    InstanceCount {
        /// The node.
        node: usize,
        /// `TRANSLATION`, `ROTATION` or `SCALE`.
        attribute: &'static str,
        /// The length of its list.
        found: usize,
        /// The length of the list before.
        expected: usize,
    },
}
