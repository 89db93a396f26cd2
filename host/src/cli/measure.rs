//! What all commands that measure have in common.

pub mod counts;
pub mod machine;
pub mod paths;
pub mod rounds;
pub mod step;
pub mod table;
pub mod walks;
