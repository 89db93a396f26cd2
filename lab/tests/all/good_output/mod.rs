//! Output of commands that succeed.

mod bench;
mod help;
mod reproduce;
mod stress;

use crate::output::{decode, keys, number, parse};
