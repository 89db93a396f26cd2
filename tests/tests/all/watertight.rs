//! No ray escapes from a closed mesh.

mod aims;
mod planes;
mod rooms;
mod solids;

use aims::{Aims, escapes};
