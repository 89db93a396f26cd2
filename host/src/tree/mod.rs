//! The stored tree: plain, or in a codec; its sources for the traversal, its validation, its cost and its lists for files.
//!
//! [`StoredTree`] is the one enum of ways to store a tree. Each variant has a file: [`plain`], [`lattice`], [`paper10`], [`wide`].
//! The variant returns its lists ([`stored::Lists`]) and sources ([`sources::StoredNodes`], [`sources::StoredTriangles`]);
//! the rest of this module is generic over these traits.

mod bvh;
mod codec;
mod cost;
mod decode;
mod error;
mod lanes;
pub(crate) mod lattice;
mod meter;
mod packets;
pub(crate) mod paper10;
pub(crate) mod plain;
mod sources;
mod stored;
mod validate;
mod visitor;
pub(crate) mod wide;

pub use bvh::Bvh;
pub use codec::{CodecError, LatticeBits, MeshCodec, NodeCodec, WideStore, check_codecs};
pub(crate) use codec::{by_bits, most_triangles};
#[cfg(feature = "scenes")]
pub(crate) use codec::{tagged, tags};
pub use cost::sah_cost;
pub use error::{RefitError, TreeError};
pub use meter::Reads;
pub(crate) use packets::{PacketQuery, Question};
#[cfg(feature = "scenes")]
pub(crate) use stored::List;
#[cfg(any(feature = "gpu", feature = "scenes"))]
pub(crate) use stored::ListReader;
pub(crate) use stored::StoredTree;
