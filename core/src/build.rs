//! From a mesh to plain nodes: the stages `gather`, `bounds`, `morton`, `sort`, `scan`, `compact`, `fit`, `snap`, `topology` or `cluster`,
//! and `refit`.

pub mod bounds;
pub mod cluster;
pub mod compact;
pub mod fit;
pub mod gather;
pub mod morton;
pub mod node;
pub mod refit;
pub mod scan;
pub mod snap;
pub mod sort;
pub mod sweep;
pub mod topology;
pub mod wide;
