//! Standard input as a scene.

use anyhow::{Context, Result, bail};
use slimbvh::scene::Format;
use std::io::Read;
use std::sync::{Mutex, OnceLock, PoisonError};

/// Standard input, which can be read once.
#[derive(Debug, Default)]
pub struct Input(OnceLock<Content>);

#[derive(Debug)]
struct Content {
    format: Format,
    bytes: Mutex<Vec<u8>>,
}

impl Input {
    /// Reads all of it, the first time.
    ///
    /// # Errors
    /// If it cannot be read, or is larger than this.
    pub fn read(&self, limit_bytes: u64) -> Result<()> {
        if self.0.get().is_some() {
            return Ok(());
        }
        let mut bytes = Vec::new();
        let input = std::io::stdin().lock();
        input
            .take(limit_bytes.saturating_add(1))
            .read_to_end(&mut bytes)
            .context("cannot read standard input")?;
        if bytes.len() as u64 > limit_bytes {
            let limit = crate::output::bytes(limit_bytes);
            bail!("standard input has more than {limit}; name a file of at most that size");
        }
        if bytes.is_empty() {
            bail!("standard input is empty; a scene is expected there");
        }
        self.0.get_or_init(|| Content {
            format: Format::of_content(&bytes),
            bytes: Mutex::new(bytes),
        });
        Ok(())
    }

    /// The format that its content looks like, if it was read.
    pub fn format(&self) -> Option<Format> {
        self.0.get().map(|content| content.format)
    }

    /// Its bytes, if it was read.
    pub fn take(&self) -> Option<Vec<u8>> {
        let content = self.0.get()?;
        let mut bytes = content.bytes.lock().unwrap_or_else(PoisonError::into_inner);
        Some(std::mem::take(&mut bytes))
    }
}
