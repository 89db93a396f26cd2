//! Positions as a file has them.

use crate::mesh::{Narrow, narrowed};
use std::collections::TryReserveError;

/// Positions as a file has them.
pub(super) enum Vertices {
    /// In `f32`.
    Narrow(Narrow),
    /// In `f64`: what is narrowed may be rounded.
    Wide(Vec<[f64; 3]>),
}

impl Default for Vertices {
    fn default() -> Self {
        Self::Wide(Vec::new())
    }
}

impl Vertices {
    /// None, to be narrowed as they come.
    pub fn narrow() -> Self {
        Self::Narrow(Narrow::default())
    }

    pub const fn len(&self) -> usize {
        match self {
            Self::Narrow(narrow) => narrow.list.len(),
            Self::Wide(list) => list.len(),
        }
    }

    pub fn reserve(&mut self, count: usize) {
        match self {
            Self::Narrow(narrow) => narrow.list.reserve(count),
            Self::Wide(list) => list.reserve(count),
        }
    }

    pub fn try_reserve(&mut self, count: usize) -> Result<(), TryReserveError> {
        match self {
            Self::Narrow(narrow) => narrow.list.try_reserve(count),
            Self::Wide(list) => list.try_reserve(count),
        }
    }

    pub fn push(&mut self, position: [f64; 3]) {
        self.extend(std::iter::once(position));
    }

    pub fn extend(&mut self, positions: impl Iterator<Item = [f64; 3]>) {
        match self {
            Self::Narrow(narrow) => narrow.extend(positions),
            Self::Wide(list) => list.extend(positions),
        }
    }

    pub fn get(&self, vertex: u32) -> Option<[f64; 3]> {
        match self {
            Self::Narrow(narrow) => narrow.list.get(vertex as usize).map(|v| v.map(f64::from)),
            Self::Wide(list) => list.get(vertex as usize).copied(),
        }
    }

    /// Whether they were narrowed, and a local origin might keep more.
    pub fn may_lose(&self, triangles: &[[u32; 3]]) -> bool {
        match self {
            Self::Narrow(narrow) => narrow.may_lose(triangles),
            Self::Wide(_) => false,
        }
    }

    /// The positions in `f32` around their local origin, and that origin: zero where `f32` suffices.
    pub fn narrowed(self, triangles: &[[u32; 3]]) -> (Vec<[f32; 3]>, [f64; 3]) {
        match self {
            Self::Narrow(narrow) => narrow.around_origin(triangles),
            Self::Wide(list) => narrowed(&list, triangles),
        }
    }
}
