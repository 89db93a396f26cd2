//! The stored tree: plain, or in a codec; its sources for the traversal, its validation, its cost and its lists for files.
//!
//! [`StoredTree`] is the one enum of ways to store a tree. Each variant has a file: [`plain`], [`paper10`], [`wide`], and for the laboratory `parent_frame`.
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
#[cfg(feature = "lab")]
pub(crate) mod parent_frame;
pub(crate) mod plain;
mod query;
mod ray_filter;
mod rays;
mod sources;
mod stored;
mod surface;
mod validate;
mod visitor;
pub(crate) mod wide;

pub use bvh::Bvh;
#[cfg(any(feature = "gpu", feature = "scenes"))]
pub(crate) use codec::ON_LATTICE;
pub(crate) use codec::most_triangles;
pub use codec::{CodecError, MeshCodec, NodeCodec, Processor, WideStore, check_codecs};
#[cfg(feature = "scenes")]
pub(crate) use codec::{TagError, tagged, tags};
pub use cost::sah_cost;
pub use error::{RefitError, TreeError};
pub use meter::Reads;
pub(crate) use packets::{PacketQuery, Question};
#[cfg(feature = "lab")]
pub use parent_frame::LatticeBits;
pub(crate) use query::Query;
#[cfg(feature = "scenes")]
pub(crate) use stored::List;
#[cfg(any(feature = "gpu", feature = "scenes"))]
pub(crate) use stored::ListReader;
pub(crate) use stored::StoredTree;
pub(crate) use surface::surface_at;
