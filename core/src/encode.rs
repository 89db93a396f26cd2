//! Stage `encode`: nodes and triangles in fewer bytes, boxes never smaller than what they hold.
//!
//! Two codecs. The **lattice** codec knows integers only: all planes lie on one lattice of the scene, a child's planes are
//! counted from its decoded parent's, and what cannot be counted exactly is rounded outward. The **printed** codec (after
//! the paper on compressed hierarchies that README cites) places planes by floats between those of the decoded parent; it is
//! there to be measured against.
#![allow(
    clippy::needless_range_loop,
    reason = "iterator chains do not compile to SPIR-V"
)]

mod lattice_leaf;
mod lattice_node;
mod lattice_nodes;
mod links;
mod printed;
mod root;
mod rounded;
mod walk;

pub use lattice_leaf::{
    FINEST_STEP, LatticeTriangles, LeafCorner, LeafWidth, encode_narrow_triangle, encode_triangle,
    scaled_step,
};
pub use lattice_node::{
    EncodedNode, decode_node, encode_child, encode_node, links_of, node_words, with_links,
};
pub use lattice_nodes::{LatticeCursor, LatticeFrame, LatticeNodes};
pub use links::Links;
pub use printed::{
    EncodedPrinted, PrintedBox, PrintedCursor, PrintedNode, PrintedNodes, PrintedTriangle,
    PrintedTriangles, decode_printed_node, encode_printed_node, encode_printed_triangle,
    printed_child,
};
pub use root::RootWords;
pub use rounded::RoundedNode;
pub use walk::{BoxCodec, LatticeCodec, PlainNode, PrintedCodec, node_bounds};
