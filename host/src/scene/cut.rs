//! A polygon as triangles, also where it is concave or has a keyhole. Ears are clipped by `earcut`.

use earcut::Earcut;
use glam::DVec3;
use std::collections::HashSet;

/// What triangles of a fan may overlap, as a share of the polygon's area: less than rounding of the corners moves.
const OVERLAP: f64 = 1e-6;

/// Cuts polygons, with buffers that are kept from one to the next.
#[derive(Default)]
pub(super) struct Cutter {
    corners: Vec<DVec3>,
    ears: Ears,
}

struct Ears {
    earcut: Earcut<f64>,
    /// Three corners of each triangle.
    triangles: Vec<u32>,
}

impl Default for Ears {
    fn default() -> Self {
        Self {
            earcut: Earcut::new(),
            triangles: Vec::new(),
        }
    }
}

impl Cutter {
    /// The triangles of a polygon with these corners, as positions in its list: two fewer than corners, each with the polygon's
    /// orientation. They are the fan around the first corner where that is right, so for all convex polygons, and where a
    /// polygon has no area. A polygon that is not flat is cut as it looks along its normal, by Newell.
    pub fn cut(
        &mut self,
        corners: impl ExactSizeIterator<Item = DVec3>,
        mut triangle: impl FnMut([u32; 3]),
    ) {
        let count = corners.len() as u32;
        self.corners.clear();
        self.corners.extend(corners);
        self.ears.triangles.clear();
        if let Some(normal) = self.normal_if_concave() {
            self.ears.clip(&self.corners, normal);
        }
        match self.ears.triangles.as_chunks::<3>() {
            ([], _) => (2..count).for_each(|i| triangle([0, i - 1, i])),
            (triangles, _) => triangles.iter().copied().for_each(triangle),
        }
    }

    /// The polygon's normal, if it has one and the fan is wrong.
    fn normal_if_concave(&self) -> Option<DVec3> {
        let &[first, ref rest @ ..] = &self.corners[..] else {
            return None;
        };
        // Twice the areas of the fan's triangles, with their normals.
        let areas = || {
            let edges = rest.windows(2);
            edges.map(|edge| (edge[0] - first).cross(edge[1] - first))
        };
        let normal: DVec3 = areas().sum();
        let square = normal.length_squared();
        if !(square > 0.0 && square.is_finite()) {
            return None;
        }
        // A fan is right if no triangle looks to the other side, and all corners lie on one side of the first edge, so that it does not
        // go around more than once.
        let least = -OVERLAP * square;
        let is_right = |area: DVec3| area.dot(normal) >= least;
        let edge = rest.iter().map(|&corner| corner - first);
        let edge = edge.into_iter().find(|edge| *edge != DVec3::ZERO)?;
        let mut sides = rest.iter().map(|&corner| edge.cross(corner - first));
        let is_fan = areas().all(is_right) && (rest.len() < 4 || sides.all(is_right));
        (!is_fan).then(|| normal.normalize())
    }
}

impl Ears {
    /// Cuts a polygon as it looks along this normal.
    fn clip(&mut self, corners: &[DVec3], normal: DVec3) {
        let (u, v) = normal.any_orthonormal_pair();
        let flat = corners.iter().map(|corner| {
            let d = corner - corners[0];
            [u.dot(d), v.dot(d)]
        });
        self.earcut.earcut(flat, &[], &mut self.triangles);
        let (triangles, _) = self.triangles.as_chunks_mut::<3>();
        for triangle in triangles.iter_mut() {
            let [a, b, c] = triangle.map(|i| corners[i as usize]);
            if (b - a).cross(c - a).dot(normal) < 0.0 {
                triangle.swap(1, 2);
            }
        }
        if self.triangles.len() / 3 < corners.len() - 2 {
            self.restore_corners(corners.len() as u32);
        }
    }

    /// Adds triangles without area for corners that lie on a line between two others and were left out: a neighbour has them.
    fn restore_corners(&mut self, count: u32) {
        let (triangles, _) = self.triangles.as_chunks::<3>();
        let edges: HashSet<[u32; 2]> = triangles
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .collect();
        let mut added = Vec::new();
        for &[a, b] in &edges {
            let skipped = (b + count - a) % count;
            if skipped > 1 && !edges.contains(&[b, a]) {
                let corner = |i| (a + i) % count;
                added.extend((2..=skipped).map(|i| [a, corner(i - 1), corner(i)]));
            }
        }
        // In an order that does not depend on hashes.
        added.sort_unstable();
        let room = (count as usize - 2).saturating_sub(self.triangles.len() / 3);
        added.truncate(room);
        self.triangles.extend(added.into_flattened());
    }
}
