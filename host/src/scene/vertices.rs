//! Positions as a file has them.

use crate::mesh::narrowed;

/// Positions as a file has them.
pub(super) enum Vertices {
    /// In `f32`: nothing is lost.
    Narrow(Vec<[f32; 3]>),
    /// In `f64`: what is narrowed may be rounded.
    Wide(Vec<[f64; 3]>),
}

impl Default for Vertices {
    fn default() -> Self {
        Self::Wide(Vec::new())
    }
}

impl Vertices {
    pub const fn len(&self) -> usize {
        match self {
            Self::Narrow(list) => list.len(),
            Self::Wide(list) => list.len(),
        }
    }

    pub fn reserve(&mut self, count: usize) {
        match self {
            Self::Narrow(list) => list.reserve(count),
            Self::Wide(list) => list.reserve(count),
        }
    }

    pub fn push(&mut self, position: [f64; 3]) {
        match self {
            Self::Narrow(list) => list.push(position.map(|x| x as f32)),
            Self::Wide(list) => list.push(position),
        }
    }

    pub fn get(&self, vertex: u32) -> Option<[f64; 3]> {
        match self {
            Self::Narrow(list) => list.get(vertex as usize).map(|v| v.map(f64::from)),
            Self::Wide(list) => list.get(vertex as usize).copied(),
        }
    }

    /// The positions in `f32` around a local origin, and that origin: zero where `f32` suffices.
    pub fn narrowed(self, triangles: &[[u32; 3]]) -> (Vec<[f32; 3]>, [f64; 3]) {
        match self {
            Self::Narrow(list) => (list, [0.0; 3]),
            Self::Wide(list) => narrowed(&list, triangles),
        }
    }
}
