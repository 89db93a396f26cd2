//! The promises about numbers, each a test of its name.
