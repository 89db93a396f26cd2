//! Tools that the measurements share: rounds, names of machines, counted traversal, tables.

pub(crate) mod counts;
pub mod exponent;
pub mod machine;
pub(crate) mod paths;
pub(crate) mod pictures;
pub mod rounds;
pub(crate) mod step;
pub(crate) mod table;
pub(crate) mod walks;
