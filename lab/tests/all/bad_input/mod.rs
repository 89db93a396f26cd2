//! Bad input: the binary exits with code 2 and one sentence that names the fault, and writes no file.

mod bench;
mod reproduce;
mod stress;

use crate::refusal::{folder, refuses, refuses_usage};
