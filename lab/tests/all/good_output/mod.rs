//! What the binary writes when all is well.

mod bench;
mod help;
mod reproduce;
mod stress;

use crate::output::{decode, keys, number, parse};
