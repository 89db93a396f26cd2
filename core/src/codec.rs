//! Stage `encode`: nodes and triangles in fewer bytes. A decoded box always contains the box that was encoded.
//!
//! There are three codecs. **Wide** nodes have up to four children; on the lattice they use integers only: all planes lie on one
//! lattice of the scene, in a frame of the node's own, and what cannot be counted exactly is rounded outward ([`WideNode`],
//! [`PackedWideNode`]). The **parent-frame lattice** codec, the laboratory's, has nodes of two children, whose planes are counted
//! from the decoded parent's ([`encode_node`]). The **paper10** codec places planes in 10 bits between those of the decoded parent,
//! by floats. It is NODE and NODE+MESH of the
//! paper on the compression of hierarchy and mesh after Karras (measured on a GTX 970; its authors are not known to us), and
//! serves as the baseline that the lattice codec is measured against.
#![allow(
    clippy::needless_range_loop,
    reason = "iterator chains do not compile to SPIR-V"
)]

mod encode;
pub mod frame;
mod full_wide_node;
mod lattice_leaf;
mod lattice_node;
mod lattice_nodes;
mod leaf_width;
mod links;
mod mixed_wide_node;
mod packed_links;
mod packed_wide_node;
mod paper10;
mod root;
mod rounded;
mod rounded_children;
mod shared_leaf;
mod wide_axis;
mod wide_node;
mod wide_sources;

pub use encode::{BoxCodec, LatticeCodec, Paper10Codec, PlainNode, node_bounds};
pub use full_wide_node::FullWideNode;
pub use lattice_leaf::{
    FINEST_STEP, LatticeTriangles, LeafCorner, encode_narrow_triangle, encode_triangle, scaled_step,
};
pub use lattice_node::{
    EncodedNode, decode_node, encode_child, encode_node, links_of, node_words, with_links,
};
pub use lattice_nodes::{LatticeCursor, LatticeNodes};
pub use leaf_width::{LatticeBounds, LeafFrame, LeafWidth};
pub use links::Links;
pub use mixed_wide_node::MixedWideNode;
pub use packed_links::PackedLinks;
pub use packed_wide_node::PackedWideNode;
pub use paper10::{
    EncodedPaper10, Paper10Box, Paper10Cursor, Paper10Node, Paper10Nodes, Paper10Triangle,
    Paper10Triangles, decode_paper10_node, encode_paper10_node, encode_paper10_triangle,
    paper10_child,
};
pub use root::RootWords;
pub use rounded::RoundedNode;
pub use rounded_children::RoundedChildren;
pub use shared_leaf::{
    MOST_SHARED_BYTES, SharedTriangles, TriangleCorners, corner_count, corner_counts, index_place,
    leaf_words, number_corners, store_shared_leaf, store_shared_triangle,
};
pub use wide_axis::{WideAxis, wide_axes};
pub use wide_node::WideNode;
pub use wide_sources::{
    LatticeRow, LatticeWideNodes, MixedWideRow, PackedWideNodes, PackedWideRow, WideMixedNodes,
    WideNodes, WideRow,
};
