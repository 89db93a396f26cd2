//! Output of commands that succeed.

mod help;
mod info;
mod outputs;
mod saved;
mod scenes;
mod views;

use crate::output::{decode, keys, number, parse};

const SMALL: [&str; 4] = ["render", "--size", "160x90", "--json"];
