//! Whatever is wrong with the input, the answer is exit code 2 and one sentence that names it. Nothing else is written.

mod bench;
mod reproduce;
mod stress;

use crate::refusal::{folder, refuses, refuses_usage};
