//! The promises about numbers, each a test of its name.

mod answers;
mod boxes;
mod clustered;
mod codecs;
mod decisions;
mod deepest_trees;
mod exact;
mod faults;
mod fuzz_seeds;
mod gpu;
mod instructions;
mod meshes;
mod negative_controls;
mod odd_rays;
mod packets;
mod reduced;
mod reduced_plans;
mod reduced_scenes;
mod refits;
mod rejecting;
mod repeatable;
mod saved;
mod trees;
mod unculled;
mod watertight;
mod written_once;
